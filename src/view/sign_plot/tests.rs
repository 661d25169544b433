//! Tests of the time that is dragged: the shape's own F there, and places that belong to times.

use super::*;
use crate::scene::{embedded_scene, embedded_scenes, load};
use crate::trace::record_pixel;
use crate::view::readable::assert_readable;

fn recorded(name: &str) -> (Scene, RayTree, EventId) {
    let scene = load(embedded_scene(name).unwrap().text, name).unwrap();
    let [x, y] = scene.pixels[0];
    let tree = record_pixel(&scene, x, y);
    let found = tree.events.iter().find(|event| matches!(event.what, What::Implicit { .. }));
    let event = found.expect("a shape was asked").id;
    (scene, tree, event)
}

fn probed(name: &str, t: f64, size: [f64; 2]) -> Option<ProbedSigns> {
    let (scene, tree, event) = recorded(name);
    probed_sign_plot(&scene, &tree, event, Some(t), size, Theme::Light)
}

#[test]
fn d_at_the_probe_is_what_was_recorded_there() {
    for embedded in embedded_scenes().into_iter().filter(|scene| scene.name.starts_with("skewed/")) {
        let (scene, tree, event) = recorded(&embedded.name);
        let What::Implicit { samples, .. } = &tree.event(event).what else { unreachable!() };
        let largest = samples.iter().map(|[_, d]| d.abs()).fold(0.0, f64::max);
        for [t, d] in samples.iter().step_by(samples.len() / 7 + 1) {
            let plot = probed_sign_plot(&scene, &tree, event, Some(*t), [600.0, 300.0], Theme::Light).unwrap();
            let found = plot.probe.expect("the scene is the one that was recorded");
            assert!((found.d - d).abs() <= 1e-9 * largest, "{}: {} instead of {d} at {t}", embedded.name, found.d);
        }
    }
}

#[test]
fn places_and_times_belong_together() {
    let layout = probed("primitives/sphere", 3.0, [600.0, 300.0]).unwrap().layout;
    for t in [layout.t[0], 0.3 * layout.t[0] + 0.7 * layout.t[1], layout.t[1]] {
        assert!((layout.t_at(layout.x_at(t)) - t).abs() < 1e-9);
    }
    assert_eq!(layout.t_at(-1e9), layout.t[0]);
    assert_eq!(layout.t_at(1e9), layout.t[1]);
}

#[test]
fn inside_and_outside_follow_the_time() {
    let (scene, tree, _) = recorded("primitives/sphere");
    let through = tree.events.iter().find_map(|event| match &event.what {
        What::Implicit { roots, .. } if roots.len() == 2 => Some((event.id, roots[0], roots[1])),
        _ => None,
    });
    let (event, near, far) = through.expect("the ray passes through the sphere");
    let side = |t: f64| {
        let plot = probed_sign_plot(&scene, &tree, event, Some(t), [600.0, 300.0], Theme::Light).unwrap();
        plot.probe.unwrap().side()
    };
    assert_eq!([side(near - 0.01), side(f64::midpoint(near, far)), side(far + 0.01)], ["outside", "inside", "outside"]);
}

#[test]
fn the_read_out_stands_in_the_drawing_and_in_its_description() {
    let plot = probed("primitives/torus", 6.0, [700.0, 300.0]).unwrap();
    let probe = plot.probe.unwrap();
    for told in [format!("t = {}", brief(probe.t)), format!("d = {}", brief(probe.d)), probe.side().to_owned()] {
        assert!(plot.drawing.description.contains(&told), "{told}");
        assert!(plot.drawing.texts().any(|text| text.text.contains(&told)), "{told}");
    }
}

#[test]
fn nothing_covers_anything_at_any_size() {
    for name in ["primitives/sphere", "skewed/torus", "csg/bowl"] {
        for size in [[300.0, 200.0], [560.0, 360.0], [900.0, 600.0]] {
            for t in [0.0, 5.0, 1e9] {
                let plot = probed(name, t, size).unwrap();
                assert_readable(&plot.drawing, &format!("{name} at {t} in {size:?}"));
            }
        }
    }
}

#[test]
fn what_happens_at_a_hit_has_the_signs_of_the_ray_that_hit_and_not_those_of_a_shadow() {
    let name = "textures/solid_textures";
    let scene = load(embedded_scene(name).unwrap().text, name).unwrap();
    let tree = record_pixel(&scene, 500, 140);
    let lattice = tree.events.iter().find(|event| matches!(event.what, What::Lattice(_))).expect("there is noise").id;
    let hit = |what: &What| if let What::Hit { t, .. } = what { Some(*t) } else { None };
    let t = tree.events[..lattice as usize].iter().find_map(|event| hit(&event.what)).expect("something is hit");
    let asked = asked_near(&tree, lattice).expect("the shape was asked");
    let What::Implicit { roots, .. } = &tree.event(asked).what else { panic!("it says where the ray is inside") };
    assert!(roots.iter().any(|root| (root - t).abs() < 1e-9 * t), "{t} is none of {roots:?}");
}
