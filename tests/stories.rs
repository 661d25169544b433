//! What the embedded scenes promise to show is there to be seen.

use rayscope::record::{Event, EventId, NullRecorder, Operator, RayKind, What};
use rayscope::scene::{Scene, embedded_scene, load};
use rayscope::trace::{RayTree, record_pixel, trace_pixel};
use serde_json::json;

fn scene(name: &str) -> Scene {
    let embedded = embedded_scene(name).unwrap_or_else(|| panic!("no scene {name}"));
    load(embedded.text, name).unwrap_or_else(|errors| panic!("{errors}"))
}

/// The trees of the pixels that the scene itself points out.
fn telling_trees(scene: &Scene) -> Vec<RayTree> {
    scene.pixels.iter().map(|[x, y]| record_pixel(scene, *x, *y)).collect()
}

fn count(tree: &RayTree, is: impl Fn(&What) -> bool) -> usize {
    tree.events.iter().filter(|event| is(&event.what)).count()
}

fn hits(tree: &RayTree) -> Vec<&Event> {
    tree.events.iter().filter(|event| matches!(event.what, What::Hit { .. })).collect()
}

/// The steps directly below an event; anything else there is told by `other`.
fn steps_below(tree: &RayTree, id: EventId, mut other: impl FnMut(&Event)) -> Vec<u8> {
    let number = |event: &Event| {
        if let What::Step { number, .. } = event.what {
            return Some(number);
        }
        other(event);
        None
    };
    tree.children(id).filter_map(number).collect()
}

#[test]
fn the_first_level_of_every_pixel_is_the_six_steps_or_its_samples_with_theirs() {
    for embedded in rayscope::scene::embedded_scenes() {
        for tree in telling_trees(&scene(&embedded.name)) {
            let (mut samples, mut averages) = (Vec::new(), 0);
            let steps = steps_below(&tree, 0, |event| match event.what {
                What::Sample(_) => samples.push(event.id),
                What::Average(_) => averages += 1,
                ref other => panic!("{}: {other:?} at the first level", embedded.name),
            });
            if samples.is_empty() {
                assert_eq!((steps.as_slice(), averages), (&[1, 2, 3, 4, 5, 6][..], 0), "{}", embedded.name);
                continue;
            }
            assert_eq!((steps.as_slice(), averages), (&[6][..], 1), "{}", embedded.name);
            // Only the last ones may be cut short by the limit on a recording's size.
            for &sample in samples.iter().take(2) {
                let steps =
                    steps_below(&tree, sample, |event| panic!("{}: {:?} in a sample", embedded.name, event.what));
                assert_eq!(steps, [1, 2, 3, 4, 5], "{}", embedded.name);
            }
        }
    }
}

#[test]
fn the_bowl_shows_three_primitives_three_lists_an_early_out_rejections_and_a_shadow_ray() {
    let trees = telling_trees(&scene("csg/bowl"));
    assert!(trees.len() >= 2, "§ 6.5.1 has two rays");
    for tree in &trees {
        assert!(count(tree, |what| matches!(what, What::Transform { .. })) >= 3);
        assert!(count(tree, |what| matches!(what, What::Combine { operator: Operator::Difference, .. })) >= 2);
        assert!(count(tree, |what| matches!(what, What::Light { .. })) >= 1);
    }
    let some_tree_has = |is: &dyn Fn(&What) -> bool| trees.iter().any(|tree| count(tree, is) > 0);
    assert!(some_tree_has(&|what| matches!(what, What::Combine { early_out: Some(_), .. })));
    assert!(some_tree_has(&|what| matches!(what, What::Rejected { t, .. } if *t > 0.0)));
    assert!(some_tree_has(&|what| matches!(what, What::Ray { ray: RayKind::Shadow, .. })));
}

#[test]
fn one_ray_hits_the_bowl_from_outside_and_one_passes_the_opening() {
    let flipped: Vec<bool> = telling_trees(&scene("csg/bowl"))
        .iter()
        .map(|tree| {
            let What::Hit { n_geometric, generic_point, .. } = &hits(tree)[0].what else { panic!("a hit") };
            // On the subtracted inner sphere the outward normal of the bowl points to the sphere's centre.
            n_geometric.iter().zip(generic_point).map(|(n, p)| n * p).sum::<f64>() < 0.0
        })
        .collect();
    assert!(flipped.contains(&false) && flipped.contains(&true), "{flipped:?}");
}

#[test]
fn the_fishbowl_bends_light_twice_on_the_way_into_the_water() {
    let trees = telling_trees(&scene("optics/fishbowl"));
    let goes_through = |tree: &RayTree| {
        let indices: Vec<(f64, f64)> = tree
            .events
            .iter()
            .filter_map(|event| match event.what {
                What::Snell { n1, n2, .. } => Some((n1, n2)),
                _ => None,
            })
            .collect();
        indices.windows(2).any(|pair| pair[0].0 == 1.0 && pair[0].1 == pair[1].0 && pair[1].1 > 1.3 && pair[1].1 < 1.34)
    };
    assert!(trees.iter().any(goes_through), "air → glass → water");
}

#[test]
fn the_glass_cube_reflects_totally_past_its_critical_angle() {
    let mut seen = 0;
    for tree in telling_trees(&scene("optics/glass_cube")) {
        for event in &tree.events {
            if let What::Snell { n1, n2, theta1, theta2, critical, total_internal_reflection: true, .. } = &event.what {
                let expected = (n2 / n1).asin().to_degrees();
                let critical = critical.expect("light comes from the denser side");
                assert!((critical - expected).abs() < 1e-9);
                assert!(*theta1 > critical && theta2.is_none());
                seen += 1;
            }
        }
    }
    assert!(seen > 0);
}

/// Balls of glass that are mirrors too, one in the other: each hit spawns two rays.
const DOUBLING: &str = r#"{
    "camera": {"eye": [0, -6, 0.5], "look_at": [0, 0, 0], "up": [0, 0, 1], "field_of_view": 40},
    "image": {"width": 9, "height": 9},
    "limits": {"depth": 50, "contribution": 0},
    "materials": {"both": {"reflectivity": 1, "transparency": 1, "index_of_refraction": 1.5}},
    "objects": [{"shape": "sphere", "material": "both"},
                {"shape": "sphere", "material": "both", "transform": [{"scale": 0.75}]},
                {"shape": "sphere", "material": "both", "transform": [{"scale": 0.5}]}]
}"#;

#[test]
fn rays_that_double_at_every_hit_end_at_a_stated_number() {
    let scene = load(DOUBLING, "doubling").unwrap_or_else(|errors| panic!("{errors}"));
    let tree = record_pixel(&scene, 4, 4);
    assert!(tree.events.iter().any(|event| matches!(&event.what, What::Limit { limit, .. } if limit == "rays")));
}

/// A closed room whose walls mirror all but a small share of what they see, and give as much of their own.
fn room_of_mirrors(share: f64, depth: u32) -> Scene {
    let own = [share; 3];
    let room = json!({
        "camera": {"eye": [0.1, 0.2, 0.3], "look_at": [1, 0.3, 0.2]},
        "image": {"width": 3, "height": 2},
        "ambient": [1, 1, 1],
        "limits": { "depth": depth, "contribution": 0 },
        "materials": {"mirror": {"ambient": own, "diffuse": [0, 0, 0], "reflectivity": 1.0 - share}},
        "objects": [{"shape": "cube", "material": "mirror", "transform": [{"scale": 3}]}]
    });
    load(&room.to_string(), "a room of mirrors").unwrap_or_else(|errors| panic!("{errors}"))
}

#[test]
fn as_deep_as_a_scene_may_ask_a_room_of_mirrors_gives_the_sum_of_the_series() {
    // 1 − (1 − s)ⁿ⁺¹ after n reflections. Each of them rounds, and each rounding counts for the less the deeper it lies.
    for (share, depth) in [(0.02_f64, 250), (2e-5, 100_000)] {
        let expected = 1.0 - (1.0 - share).powf(f64::from(depth + 1));
        let found = trace_pixel(&room_of_mirrors(share, depth), 1, 1, &mut NullRecorder).x;
        assert!((found - expected).abs() < 1e-11, "{found} is not {expected} after {depth} reflections");
    }
}

#[test]
fn a_path_of_ten_thousand_reflections_is_told_from_end_to_end() {
    let scene = room_of_mirrors(2e-4, 10_000);
    let tree = record_pixel(&scene, 1, 1);
    let rays = count(&tree, |what| matches!(what, What::Ray { ray: RayKind::Reflected, .. }));
    assert_eq!(rays, 10_000);
    assert!((tree.colour()[0] - (1.0 - (1.0_f64 - 2e-4).powi(10_001))).abs() < 1e-11);
}

#[test]
fn mirrors_that_face_each_other_end_at_a_stated_limit() {
    let trees = telling_trees(&scene("optics/mirrors"));
    assert!(trees.iter().any(|tree| count(tree, |what| matches!(what, What::Limit { .. })) > 0));
}

#[test]
fn the_same_overlap_is_reported_under_policy_1_and_decided_under_policy_2() {
    let reported = |what: &What| matches!(what, What::Medium { interpenetration: true, .. });
    let hidden = |what: &What| matches!(what, What::Medium { hidden: true, .. });
    let forbid = telling_trees(&scene("optics/media_forbid"));
    let priority = telling_trees(&scene("optics/media_priority"));
    assert!(forbid.iter().any(|tree| count(tree, reported) > 0));
    assert!(priority.iter().any(|tree| count(tree, hidden) > 0));
    assert!(priority.iter().all(|tree| count(tree, reported) == 0));
}

#[test]
fn a_ray_that_leaves_an_overlap_reports_it_as_one_that_enters_it_does() {
    let mut passed_through = 0;
    for tree in telling_trees(&scene("optics/media_forbid")) {
        for event in &tree.events {
            // A boundary can only be hidden by another object that the ray is inside at the same place.
            if let What::Medium { hidden: true, interpenetration, .. } = event.what {
                assert!(interpenetration);
                passed_through += 1;
            }
        }
    }
    assert!(passed_through > 0);
}

#[test]
fn the_components_of_every_hit_sum_to_its_colour() {
    for embedded in rayscope::scene::embedded_scenes() {
        for tree in telling_trees(&scene(&embedded.name)) {
            for event in &tree.events {
                if let What::Colour { ambient, diffuse, specular, reflected, transmitted, total } = event.what {
                    for channel in 0..3 {
                        let parts = [ambient, diffuse, specular, reflected, transmitted];
                        let sum: f64 = parts.iter().map(|part| part[channel]).sum();
                        assert!((sum - total[channel]).abs() <= 1e-12, "{}", embedded.name);
                    }
                }
            }
        }
    }
}

#[test]
fn hit_times_are_shared_by_world_and_generic_coordinates() {
    for embedded in rayscope::scene::embedded_scenes() {
        for tree in telling_trees(&scene(&embedded.name)) {
            let Some(hit) = hits(&tree).into_iter().next() else { continue };
            let What::Hit { object, leaf, t, point, generic_point, .. } = &hit.what else { unreachable!() };
            // Leaves may have the same name, in one object as in several.
            let is_own = |id: EventId| matches!(&tree.event(id).what, What::Object { name, .. } if name == object);
            let mut transforms = tree.events[..hit.id as usize].iter().filter_map(|event| match &event.what {
                What::Transform { of, origin, direction, .. }
                    if of == leaf && tree.path(event.id).into_iter().any(is_own) =>
                {
                    Some((origin, direction))
                }
                _ => None,
            });
            // The world point is rounded, and the more coarsely the farther it is from the origin.
            let rounded = 8.0 * f64::EPSILON * point.iter().map(|x| x.abs()).sum::<f64>();
            let leads_to_hit = |(s, c): (&[f64; 3], &[f64; 3])| {
                (0..3).all(|axis| {
                    let at_t = s[axis] + c[axis] * t;
                    let room = 1e-9 * (1.0 + s[axis].abs()) + rounded * c.iter().map(|x| x.abs()).sum::<f64>();
                    (at_t - generic_point[axis]).abs() < room
                })
            };
            assert!(transforms.any(leads_to_hit), "{}", embedded.name);
        }
    }
}
