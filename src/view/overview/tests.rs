//! Tests of the overview: the camera's own view is the picture's, orbits turn about the middle, nothing collides.

use super::*;
use crate::scene::{embedded_scene, load};
use crate::trace::record_pixel;
use crate::view::readable::assert_readable;
use glam::DVec3;

fn recorded(name: &str) -> (Scene, Wireframe, RayTree) {
    let scene = load(embedded_scene(name).unwrap().text, name).unwrap();
    let [x, y] = scene.pixels[0];
    let tree = record_pixel(&scene, x, y);
    let wires = Wireframe::of(&scene);
    (scene, wires, tree)
}

#[test]
fn through_the_camera_everything_is_where_the_picture_has_it() {
    let (scene, wires, _) = recorded("csg/bowl");
    let options = OverviewOptions { stand: Stand::Camera, size: [800.0, 500.0], ..OverviewOptions::default() };
    let sight = overview_sight(&scene, &wires, &options);
    let size = [scene.image.width, scene.image.height].map(f64::from);
    let scale = ((800.0 - 2.0 * MARGIN) / size[0]).min((500.0 - 2.0 * MARGIN) / size[1]);
    for point in [DVec3::ZERO, DVec3::new(1.0, -0.5, 2.0), DVec3::new(-2.0, 1.0, 0.3)] {
        let [x, y] = scene.camera.project(scene.image, point).unwrap();
        let expected = [400.0 + scale * (x - 0.5 * size[0]), 250.0 + scale * (y - 0.5 * size[1])];
        let [got_x, got_y] = sight.place(point).unwrap();
        assert!((got_x - expected[0]).abs() < 1e-9 && (got_y - expected[1]).abs() < 1e-9, "{point}");
    }
}

#[test]
fn a_view_is_a_frame_of_unit_vectors_at_right_angles_from_everywhere() {
    let (scene, wires, _) = recorded("csg/bowl");
    for yaw in [0.0, 1.0, 3.0, -20.0, f64::NAN] {
        for pitch in [-9.0, -0.5, 0.0, 1.5, f64::INFINITY] {
            for is_perspective in [false, true] {
                let stand = Stand::Orbit { yaw, pitch };
                let options = OverviewOptions { stand, is_perspective, ..OverviewOptions::default() };
                let Sight { right, up, forward, .. } = overview_sight(&scene, &wires, &options);
                for v in [right, up, forward] {
                    assert!((v.length() - 1.0).abs() < 1e-12);
                }
                assert!(right.dot(up).abs() < 1e-12 && right.cross(up).distance(-forward) < 1e-12);
            }
        }
    }
}

#[test]
fn parallel_lines_stay_parallel_without_perspective() {
    let (scene, wires, _) = recorded("csg/bowl");
    let options = OverviewOptions { is_perspective: false, ..OverviewOptions::default() };
    let sight = overview_sight(&scene, &wires, &options);
    let along = |from: DVec3| {
        let [a, b] = [from, from + DVec3::new(1.0, 2.0, 0.5)].map(|point| sight.place(point).unwrap());
        [b[0] - a[0], b[1] - a[1]]
    };
    let (first, second) = (along(DVec3::ZERO), along(DVec3::new(4.0, -3.0, 9.0)));
    assert!((0..2).all(|i| (first[i] - second[i]).abs() < 1e-9));
}

#[test]
fn a_scene_whose_size_overflows_stops_nothing() {
    let text = embedded_scene("hello/sphere").unwrap().text.replace("[0, 0, 1] }]", "[0, 0, 1e200] }]");
    assert!(text.contains("1e200"), "an object stands so far off that the square of its distance is infinite");
    let scene = load(&text, "huge").unwrap();
    let [x, y] = scene.pixels[0];
    let (tree, wires) = (record_pixel(&scene, x, y), Wireframe::of(&scene));
    for is_perspective in [false, true] {
        let options = OverviewOptions {
            stand: Stand::Orbit { yaw: 0.5, pitch: 0.4 },
            is_perspective,
            ..OverviewOptions::default()
        };
        let drawing = overview(&scene, &wires, &tree, 0, &options).unwrap();
        assert!(drawing.texts().all(|text| text.at.iter().all(|x| x.is_finite())));
    }
}

#[test]
fn from_all_round_everything_lies_within_the_drawing() {
    let (scene, wires, _) = recorded("optics/fishbowl");
    for yaw in [0.0, 0.7, 2.0, 4.0] {
        for is_perspective in [false, true] {
            let stand = Stand::Orbit { yaw, pitch: 0.4 };
            let options = OverviewOptions { stand, is_perspective, size: [900.0, 500.0], ..OverviewOptions::default() };
            let sight = overview_sight(&scene, &wires, &options);
            let frame = Drawing::new(options.size, Theme::Light.palette().ground).frame();
            for point in wires.lines.iter().flat_map(|line| &line.points) {
                let spot = sight.place(*point).expect("it lies before the eye");
                assert!(frame.contains(spot), "{point} is at {spot:?}, from {yaw}");
            }
        }
    }
}

#[test]
fn what_lies_behind_the_eye_is_cut_off_and_not_mirrored() {
    let (scene, wires, _) = recorded("csg/bowl");
    let options = OverviewOptions { stand: Stand::Camera, ..OverviewOptions::default() };
    let sight = overview_sight(&scene, &wires, &options);
    let behind = scene.camera.eye - scene.camera.forward;
    let ahead = scene.camera.eye + scene.camera.forward * 3.0;
    assert!(sight.place(behind).is_none() && sight.line([behind, behind - DVec3::X]).is_none());
    assert_eq!(sight.line([behind, ahead]).map(|[_, to]| to), sight.place(ahead));
}

#[test]
fn nothing_is_drawn_before_it_happens_and_a_click_on_the_hit_finds_it() {
    let (scene, wires, tree) = recorded("optics/glass_ball");
    let options = OverviewOptions::default();
    for step in (0..tree.end()).step_by(23) {
        let drawing = overview(&scene, &wires, &tree, step, &options).unwrap();
        assert!(drawing.marks.iter().filter_map(|mark| mark.event).all(|event| event <= step), "at {step}");
    }
    let hit = tree.events.iter().find(|event| matches!(event.what, What::Hit { .. })).unwrap();
    let What::Hit { point, .. } = &hit.what else { unreachable!() };
    let at = overview_sight(&scene, &wires, &options).place(DVec3::from_array(*point)).unwrap();
    let drawing = overview(&scene, &wires, &tree, hit.id, &options).unwrap();
    assert_eq!(drawing.event_at(at, 3.0), Some(hit.id));
}

#[test]
fn the_description_names_objects_lights_and_every_ray() {
    let (scene, wires, tree) = recorded("csg/bowl");
    let told = overview(&scene, &wires, &tree, tree.end() - 1, &OverviewOptions::default()).unwrap().description;
    for part in ["bowl", "key light", "fill light", "The camera ray", "The shadow ray"] {
        assert!(told.contains(part), "{part}: {told}");
    }
}

#[test]
fn nothing_covers_anything_at_any_size() {
    for name in ["csg/bowl", "optics/glass_ball", "primitives/plane", "hard/far_torus", "lights/soft_shadows"] {
        let (scene, wires, tree) = recorded(name);
        for size in [[300.0, 200.0], [560.0, 360.0], [900.0, 600.0], [20.0, 20.0]] {
            for stand in [Stand::default(), Stand::Camera] {
                let options = OverviewOptions { size, stand, probe_t: Some(2.0), ..OverviewOptions::default() };
                let drawing = overview(&scene, &wires, &tree, tree.end() - 1, &options).unwrap();
                assert_readable(&drawing, &format!("{name} in {size:?} from {stand:?}"));
            }
        }
    }
}
