//! The peer scenes say the same to this program as to the others.

mod povray;

use glam::DVec3;
use rayscope::peer::{Agreement, import};
use rayscope::record::{Effect, NullRecorder};
use rayscope::scene::{Image, Scene, load};
use rayscope::trace::{Progress, render};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

const SCENES: [&str; 9] = [
    "a_spheres",
    "b_tori",
    "c_superellipsoids",
    "d_csg",
    "e_glass",
    "h_solids",
    "i_scaling_100",
    "i_scaling_1000",
    "i_scaling_10000",
];

fn imported(name: &str) -> Scene {
    load(&import(&peer(name)).unwrap(), name).unwrap()
}

/// The file of a peer scene.
fn path(name: &str, ending: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/peers/{name}.{ending}"))
}

fn peer(name: &str) -> String {
    fs::read_to_string(path(name, "json")).unwrap()
}

fn vector(value: &Value) -> DVec3 {
    let number = |k: usize| value[k].as_f64().unwrap();
    DVec3::new(number(0), number(1), number(2))
}

/// One peer object's shape alone, at the origin.
fn solid(object: &str) -> Scene {
    let camera = r#"{"type": "perspective", "location": [0, 0, -9], "direction": [0, 0, 1], "right": [-1, 0, 0], "up": [0, 1, 0]}"#;
    let material = r#"{"pigment": {"type": "solid", "rgb": [1, 1, 1]}, "ambient": 0, "diffuse": 1, "phong": 0, "phong_size": 1, "reflection": 0}"#;
    let text = format!(
        r#"{{"format": "peer-scene/1", "name": "", "about": "", "image": {{"width": 9, "height": 9}}, "camera": {camera},
        "max_depth": 5, "adc_bailout": 0, "background": [0, 0, 0], "lights": [], "materials": {{"m": {material}}},
        "objects": [{object}]}}"#
    );
    load(&import(&text).unwrap(), "solid").unwrap()
}

/// Whether a point is inside the first object.
fn holds(scene: &Scene, point: [f64; 3]) -> bool {
    let direction = DVec3::new(1.0, 1e-3, 1e-4);
    scene.objects[0].solid.inside::<f64>(DVec3::from_array(point), direction, &mut NullRecorder).contains(0.0)
}

#[test]
fn rays_through_pixels_are_the_peers_to_12_digits() {
    for name in SCENES {
        let (scene, file): (_, Value) = (imported(name), serde_json::from_str(&peer(name)).unwrap());
        let camera = &file["camera"];
        assert_eq!(scene.camera.eye, vector(&camera["location"]), "{name}");
        let [direction, right, up] = ["direction", "right", "up"].map(|field| vector(&camera[field]));
        for [x, y] in [[0.0, 0.0], [639.5, 0.5], [12.5, 479.5], [320.0, 240.0], [500.5, 99.5]] {
            let theirs = direction + (x / 640.0 - 0.5) * right + (0.5 - y / 480.0) * up;
            let ours = scene.camera.ray_direction(scene.image, x, y);
            assert!(ours.normalize().distance(theirs.normalize()) < 1e-12, "{name}: {ours} and not {theirs}");
        }
    }
}

#[test]
fn every_object_light_and_material_is_there() {
    for name in SCENES {
        let (scene, file): (_, Value) = (imported(name), serde_json::from_str(&peer(name)).unwrap());
        assert_eq!(scene.objects.len(), file["objects"].as_array().unwrap().len(), "{name}");
        assert_eq!(scene.lights.len(), file["lights"].as_array().unwrap().len(), "{name}");
        assert_eq!(scene.materials.len(), file["materials"].as_object().unwrap().len(), "{name}");
    }
}

#[test]
fn a_sphere_stands_about_its_centre() {
    let scene = solid(r#"{"shape": "sphere", "center": [1, 2, 3], "radius": 0.5, "material": "m"}"#);
    assert!(holds(&scene, [1.0, 2.0, 3.49]) && !holds(&scene, [1.0, 2.0, 3.51]));
}

#[test]
fn a_box_goes_from_corner_to_corner() {
    let scene = solid(r#"{"shape": "box", "min": [0, 0, 0], "max": [1, 2, 4], "material": "m"}"#);
    assert!(holds(&scene, [0.01, 1.99, 3.99]) && !holds(&scene, [0.5, 2.01, 2.0]) && !holds(&scene, [-0.01, 1.0, 1.0]));
}

#[test]
fn a_cone_narrows_towards_its_cap_whichever_end_has_the_apex() {
    let upright =
        r#"{"shape": "cone", "base": [0, 0, 0], "base_radius": 2, "cap": [0, 4, 0], "cap_radius": 1, "material": "m"}"#;
    let scene = solid(upright);
    assert!(holds(&scene, [0.0, 2.0, 1.49]) && !holds(&scene, [0.0, 2.0, 1.51]) && !holds(&scene, [0.0, 4.01, 0.0]));
    let inverted = r#"{"shape": "cone", "base": [0, 0, 0], "base_radius": 0, "cap": [0, 1.5, 0], "cap_radius": 2, "material": "m"}"#;
    let scene = solid(inverted);
    assert!(holds(&scene, [0.0, 1.49, 1.98]) && holds(&scene, [0.0, 0.01, 0.0]) && !holds(&scene, [0.0, 0.75, 1.01]));
}

#[test]
fn a_cylinder_goes_from_its_base_to_its_cap() {
    let slanted = r#"{"shape": "cylinder", "base": [1, 1, 1], "cap": [3, 3, 1], "radius": 0.5, "material": "m"}"#;
    let scene = solid(slanted);
    assert!(holds(&scene, [2.0, 2.0, 1.49]) && !holds(&scene, [2.0, 2.0, 1.51]));
    assert!(holds(&scene, [2.99, 2.99, 1.0]) && !holds(&scene, [3.01, 3.01, 1.0]));
}

#[test]
fn the_axis_of_a_torus_is_y() {
    let scene = solid(r#"{"shape": "torus", "major": 2, "minor": 0.5, "material": "m"}"#);
    assert!(holds(&scene, [0.0, 0.0, 2.49]) && holds(&scene, [-2.0, 0.49, 0.0]));
    assert!(!holds(&scene, [0.0, 0.0, 2.51]) && !holds(&scene, [0.0, 2.0, 0.0]));
}

/// With e = 2 the section is a square on its tip, |x| + |y| = 1; with n = 1 the height goes as a circle does.
#[test]
fn the_exponents_of_a_superellipsoid_are_turned_over() {
    let scene = solid(r#"{"shape": "superellipsoid", "e": 2, "n": 1, "material": "m"}"#);
    assert!(holds(&scene, [0.49, 0.49, 0.0]) && !holds(&scene, [0.51, 0.51, 0.0]));
    assert!(holds(&scene, [0.0, 0.59, 0.79]) && !holds(&scene, [0.0, 0.61, 0.81]));
}

#[test]
fn a_plane_is_solid_below_its_normal() {
    let scene = solid(r#"{"shape": "plane", "normal": [0, 1, 0], "distance": -2, "material": "m"}"#);
    assert!(holds(&scene, [5.0, -2.01, 7.0]) && !holds(&scene, [5.0, -1.99, 7.0]));
}

#[test]
fn a_matrix_is_applied_last_and_a_difference_takes_away_all_but_its_first() {
    let object = r#"{"shape": "difference", "material": "m", "matrix": [[1, 0, 0, 10], [0, 1, 0, 0], [0, 0, 1, 0]], "children": [
        {"shape": "sphere", "center": [0, 0, 0], "radius": 1},
        {"shape": "sphere", "center": [0, 0, 1], "radius": 0.5},
        {"shape": "sphere", "center": [0, 0, -1], "radius": 0.5}]}"#;
    let scene = solid(object);
    assert!(holds(&scene, [10.0, 0.0, 0.0]) && !holds(&scene, [0.0, 0.0, 0.0]));
    assert!(!holds(&scene, [10.0, 0.0, 0.9]) && !holds(&scene, [10.0, 0.0, -0.9]));
}

/// The share of pixels that POV-Ray draws alike; the two largest scenes are left to `rayscope bench`, for their time.
#[test]
fn pov_ray_draws_the_same_pictures() {
    for (name, least) in [
        ("b_tori", 1.0),
        ("c_superellipsoids", 0.999),
        ("d_csg", 1.0),
        ("e_glass", 0.999),
        ("h_solids", 1.0),
        ("i_scaling_100", 1.0),
    ] {
        let Some(theirs) = povray::picture(&path(name, "pov"), 160, 120) else { return };
        let agreement = Agreement::of(&povray::ours(imported(name), 160, 120), &theirs).unwrap();
        assert!(agreement.share >= least, "{name}: {agreement:?}");
    }
}

/// The means of blocks of 4 × 4 pixels, where noise has gone and blur stays.
fn blocks(picture: &[u8], width: usize) -> Vec<f64> {
    let rows = picture.len() / 3 / width;
    let block = |x: usize, y: usize, channel: usize| {
        let places = (0..16).map(|k| ((4 * y + k / 4) * width + 4 * x + k % 4) * 3 + channel);
        places.map(|place| f64::from(picture[place])).sum::<f64>() / 16.0
    };
    let all = (0..rows / 4).flat_map(|y| (0..width / 4).map(move |x| (x, y)));
    all.flat_map(|(x, y)| [0, 1, 2].map(|channel| block(x, y, channel))).collect()
}

/// The mean difference of blocks, of 255.
fn mean_difference(one: &[u8], other: &[u8], width: usize) -> f64 {
    let (one, other) = (blocks(one, width), blocks(other, width));
    one.iter().zip(&other).map(|(a, b)| (a - b).abs()).sum::<f64>() / one.len() as f64
}

#[test]
fn pov_ray_blurs_what_is_out_of_focus_alike() {
    let Some(theirs) = povray::picture(&path("g_dof", "pov"), 160, 120) else { return };
    let scene = imported("g_dof");
    let with_focus = |focus: f64, radius: f64| {
        let mut scene = scene.clone();
        let lens = scene.lens.as_mut().unwrap();
        (lens.focus, lens.radius) = (lens.focus * focus, lens.radius * radius);
        mean_difference(&povray::ours(scene, 160, 120), &theirs, 160)
    };
    let alike = with_focus(1.0, 1.0);
    // In a picture so small the noise of 64 samples hides what is less than that.
    for (focus, radius) in [(0.85, 1.0), (1.3, 1.0), (1.0, 0.25), (1.0, 1.5)] {
        let other = with_focus(focus, radius);

        assert!(alike < 0.8 * other, "{alike} as it is, {other} with {focus} of its focus and {radius} of its radius");
    }
    assert!(alike < 0.75, "{alike}");
}

/// Both programs have noise of their own, so the pictures are not compared.
#[test]
fn the_textured_scene_is_read_with_its_patterns_and_its_bumps() {
    let mut scene = imported("f_textures");
    scene.image = Image { width: 64, height: 48 };
    let (_, tally) = render(&scene, &Progress::new());
    assert!(tally.calls(Effect::SolidTextures) > 0 && tally.calls(Effect::Bumps) > 0);
    assert_eq!(tally.calls(Effect::ImageTextures), 0);
}
