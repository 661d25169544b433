//! Answers about rays whose story is known.

use rayscope::query::{Query, Vocabulary};
use rayscope::record::{EventId, RayKind, What};
use rayscope::scene::{Scene, embedded_scene, load};
use rayscope::trace::{RayTree, record_pixel, record_ray};

fn scene(name: &str) -> Scene {
    load(embedded_scene(name).unwrap().text, name).unwrap()
}

fn tree(name: &str) -> RayTree {
    let scene = scene(name);
    let [x, y] = scene.pixels[0];
    record_pixel(&scene, x, y)
}

fn matches(question: &str, tree: &RayTree) -> Vec<EventId> {
    Query::parse(question).unwrap().matches(tree).collect()
}

/// A glass cube with a cube of clay behind it, and a ray that goes into its front at 45° and then meets its side from inside.
fn glass() -> RayTree {
    let text = r#"{ "camera": { "eye": [0, -8, 0], "look_at": [0, 0, 0] },
        "lights": [ { "name": "key", "point": [-9, -9, 9] } ],
        "materials": { "glass": { "transparency": 1, "index_of_refraction": 1.5 }, "clay": { "diffuse": [1, 1, 1] } },
        "objects": [ { "shape": "cube", "name": "block", "material": "glass" },
                     { "shape": "sphere", "name": "ball", "material": "clay", "transform": [ { "translate": [0, 6, 0] } ] } ] }"#;
    let scene = load(text, "glass").unwrap_or_else(|errors| panic!("{errors}"));
    // In at 45°, on at asin(sin 45° / 1.5) = 28.1°; at the side that is 61.9°, beyond the critical 41.8°.
    record_ray(&scene, [-1.0, -2.2, 0.0].into(), [1.0, 1.0, 0.0].into())
}

#[test]
fn light_that_meets_the_side_of_a_glass_block_at_62_degrees_is_totally_reflected() {
    let tree = glass();
    let found = matches("tir", &tree);
    assert!(!found.is_empty());
    let What::Snell { theta1, critical, .. } = tree.event(found[0]).what else { panic!("tir is of Snell's law") };
    assert!((theta1 - (90.0 - (0.5_f64.sqrt() / 1.5).asin().to_degrees())).abs() < 1e-9, "{theta1}");
    assert!((critical.unwrap() - (1.0 / 1.5_f64).asin().to_degrees()).abs() < 1e-9);
    assert_eq!(
        matches("tir & theta1>60 & theta1<63 & object=block & material=glass & kind=refracted & depth=1", &tree)[0],
        found[0]
    );
    assert_eq!(matches("tir & object=ball", &tree), [0; 0]);
    assert_eq!(matches("tir & kind=camera", &tree), [0; 0]);
}

#[test]
fn a_loose_ray_is_a_ray_from_the_eye_at_depth_0() {
    let tree = glass();
    assert_eq!(matches("ray & depth=0", &tree), [0]);
    assert_eq!(matches("camera", &tree), [0]);
    let first_hit = matches("hit & kind=camera", &tree);
    assert_eq!(first_hit.len(), 1);
    assert_eq!(matches("hit=block & kind=camera & part=* & t<1.3 & t>1.1", &tree), first_hit, "the front is at y = −1");
}

#[test]
fn what_comes_after_a_hit_has_its_object_and_a_spawned_ray_starts_afresh() {
    let tree = glass();
    for id in matches("snell", &tree) {
        assert!(matches("snell & object=block", &tree).contains(&id));
    }
    for id in matches("refracted | reflected | shadow", &tree) {
        assert!(!matches("object=*", &tree).contains(&id), "a ray has met nothing yet");
        assert!(matches("left=block", &tree).contains(&id) || matches("left=ball", &tree).contains(&id));
    }
}

#[test]
fn an_early_out_within_the_search_of_an_object_is_below_that_objects_event() {
    let tree = tree("optics/fishbowl");
    let found = matches("object=bowl & csg.early_out", &tree);
    assert!(!found.is_empty());
    for id in &found {
        assert!(matches!(&tree.event(*id).what, What::Combine { early_out: Some(_), .. }));
        let above = tree.path(*id).into_iter().rev().find_map(|id| match &tree.event(id).what {
            What::Object { name, .. } => Some(name.clone()),
            _ => None,
        });
        assert_eq!(above.as_deref(), Some("bowl"));
    }
    let others = matches("csg.early_out & object!=bowl", &tree);
    assert_eq!(found.len() + others.len(), matches("csg.early_out", &tree).len());
}

#[test]
fn kind_and_depth_are_those_of_one_ray() {
    for name in ["optics/fishbowl", "optics/glass_cube", "media/smoke", "lens/focus"] {
        let tree = tree(name);
        let by_hand: Vec<EventId> = tree
            .events
            .iter()
            .map(|event| event.id)
            .filter(|&id| ray_of(&tree, id).is_some_and(|(kind, depth)| kind == RayKind::Refracted && depth >= 2))
            .collect();
        let found = matches("kind=refracted & depth>=2", &tree);
        assert_eq!(found, by_hand, "{name}");
    }
}

/// The nearest spawned ray above an event, itself included.
fn ray_of(tree: &RayTree, id: EventId) -> Option<(RayKind, u32)> {
    tree.path(id).into_iter().rev().find_map(|id| match tree.event(id).what {
        What::Ray { ray, depth, .. } if ray != RayKind::Camera => Some((ray, depth)),
        _ => None,
    })
}

#[test]
fn every_event_between_the_camera_ray_and_the_pixel_as_written_belongs_to_that_ray_or_to_its_descendants() {
    for name in ["csg/bowl", "lens/focus", "sampling/antialiasing"] {
        let tree = tree(name);
        let without = matches("!(kind=*)", &tree);
        for id in without {
            let what = &tree.event(id).what;
            let expected = matches!(
                what,
                What::Pixel { .. }
                    | What::Sample(_)
                    | What::Step { number: 1 | 6, .. }
                    | What::Lens(_)
                    | What::Average(_)
                    | What::Written { .. }
            );
            assert!(expected, "{name}: {what:?}");
        }
    }
}

#[test]
fn a_question_of_a_pixel_may_ask_what_its_story_has_not() {
    let tree = tree("csg/bowl");
    assert_eq!(matches("pixel & has(hit)", &tree), [0]);
    assert_eq!(matches("pixel & !has(tir)", &tree), [0]);
    assert_eq!(matches("pixel & has(tir)", &tree), [0; 0]);
}

#[test]
fn names_that_nothing_in_the_scene_has_are_told_with_the_nearest() {
    let vocabulary = Vocabulary::of(&scene("optics/fishbowl"));
    let query = Query::parse("tir | object=bwl & object=b* & part=surface").unwrap();
    let unknown = query.unknown_names(&vocabulary);
    assert_eq!(unknown.len(), 1);
    assert_eq!((unknown[0].column, unknown[0].length, unknown[0].nearest.as_deref()), (14, 3, Some("bowl")));
}
