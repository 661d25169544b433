//! Shadows, glass, mirrors and total reflection in hard pictures: colours that can be worked out exactly.

use super::line::PixelRay;
use super::number::{Big, Number, squared};
use super::picture::{View, scene};
use super::set::{Sets, Surface, part};
use super::truth::Truth;
use glam::DVec3;
use rayscope::record::{NullRecorder, RayKind};
use rayscope::scene::Scene;
use rayscope::trace::{Picture, Progress, render, trace_pixel};
use serde_json::{Value, json};

/// Every pixel of a scene with its ray.
fn pixels(scene: &Scene) -> impl Iterator<Item = (u32, u32, PixelRay)> {
    let (camera, image) = (scene.camera, scene.image);
    (0..image.height).flat_map(move |y| {
        (0..image.width).map(move |x| {
            let direction = camera.ray_direction(image, f64::from(x) + 0.5, f64::from(y) + 0.5);
            (x, y, PixelRay { origin: camera.eye, direction })
        })
    })
}

fn picture(scene: &Scene) -> Picture {
    render(scene, &Progress::new()).0
}

/// A scene of one material, which is given, before a background of this brightness.
fn lit(view: View, background: f64, material: &Value, objects: &[Value], lights: &Value) -> Scene {
    let mut file = json!({
        "camera": {"eye": view.eye, "look_at": view.look_at, "field_of_view": view.field},
        "image": {"width": view.size[0], "height": view.size[1]},
        "background": [background, 0, 0],
        "materials": {"m": material},
        "objects": objects,
        "lights": lights,
    });
    for object in file["objects"].as_array_mut().unwrap() {
        object["material"] = json!("m");
    }
    rayscope::scene::load(&file.to_string(), "light.json").unwrap_or_else(|errors| panic!("{errors}"))
}

#[test]
fn shadows_are_where_they_are_at_every_scale() {
    for scale in [1e-6, 1e-4, 1.0, 1e8] {
        let at = |p: [f64; 3]| p.map(|x| x * scale);
        let view = View::new(at([3.0, -6.0, 4.0]), at([0.5, 0.5, 0.2]), 40.0);
        let lamp = DVec3::from_array(at([-4.0, -3.0, 7.0]));
        let ball =
            json!({"shape": "sphere", "transform": [{"scale": 0.8}, {"translate": [0, 0, 1.1]}, {"scale": scale}]});
        let material = json!({"ambient": [0.125, 0, 0], "diffuse": [0.5, 0, 0]});
        let lights = json!([{"point": lamp.to_array()}]);
        let scene = lit(view, 0.0, &material, &[ball, json!({"shape": "plane"})], &lights);
        let sphere = Sets::one(part(0, vec![Surface::Ball]));
        let (mut shaded, mut undetermined) = (0, 0);
        for (x, y, ray) in pixels(&scene) {
            let ball = sphere.verdict(&scene, ray);
            if ball.seen.is_some() || ray.direction.z >= 0.0 {
                continue;
            }
            let point = ray.origin - ray.direction * (ray.origin.z / ray.direction.z);
            let shadow = sphere.verdict(&scene, PixelRay { origin: point, direction: lamp - point });
            if !(ball.sure && shadow.sure) {
                undetermined += 1;
                continue;
            }
            let ours = trace_pixel(&scene, x, y, &mut NullRecorder).x == 0.125;
            assert_eq!(ours, shadow.seen.is_some(), "at scale {scale:e} pixel {x},{y} of the ray {ray:?}");
            shaded += u32::from(ours);
        }
        assert!(shaded > 1000 && undetermined <= 8, "{shaded} in the shadow, {undetermined} undetermined");
    }
}

#[test]
fn every_ray_leaves_a_pane_however_thin() {
    let glass = json!({"ambient": [0, 0, 0], "diffuse": [0, 0, 0], "transparency": 0.75, "index_of_refraction": 1.5});
    for thickness in [1e-2, 4e-5, 1e-9, 1e-12] {
        for degrees in [0.0, 31.0] {
            let pane = json!({"shape": "cube", "transform": [
                {"scale": [20, 0.5 * thickness, 20]}, {"rotate": {"axis": [1, 2, 3], "degrees": degrees}}
            ]});
            let view = View::new([0.5, -3.0, 0.25], [0.0; 3], 45.0);
            let scene = lit(view, 0.5, &glass, &[pane], &json!([]));
            let (picture, tally) = render(&scene, &Progress::new());
            for (x, y, ray) in pixels(&scene) {
                let ours = picture.pixel(x, y).x;
                assert_eq!(ours, 0.75 * 0.75 * 0.5, "{thickness:e}, {degrees}°: pixel {x},{y} of the ray {ray:?}");
            }
            assert_eq!(tally.rays(RayKind::Refracted), 2 * 320 * 240, "once in and once out");
        }
    }
}

#[test]
fn a_ray_passes_both_walls_of_a_bubble_however_thin() {
    // The index of air: nothing is bent, so every crossing can be told from the pixel's ray.
    let air = json!({"ambient": [0, 0, 0], "diffuse": [0, 0, 0], "transparency": 0.5, "index_of_refraction": 1});
    for wall in [1e-2, 4e-5, 1e-9] {
        let shell = json!({"shape": "difference", "of": [
            {"shape": "sphere"}, {"shape": "sphere", "transform": [{"scale": 1.0 - wall}]}
        ]});
        let view = View::new([2.0, -4.0, 1.5], [0.0; 3], 30.0);
        let scene = lit(view, 0.5, &air, &[shell], &json!([]));
        let [outer, inner] = [0, 1].map(|leaf| Sets::one(part(leaf, vec![Surface::Ball])));
        let picture = picture(&scene);
        let (mut through, mut undetermined) = (0, 0);
        for (x, y, ray) in pixels(&scene) {
            let [outer, inner] = [&outer, &inner].map(|ball| ball.verdict(&scene, ray));
            if !(outer.sure && inner.sure) {
                undetermined += 1;
                continue;
            }
            let crossed = 2 * i32::from(outer.seen.is_some()) + 2 * i32::from(inner.seen.is_some());
            let ours = picture.pixel(x, y).x;
            assert_eq!(ours, 0.5 * 0.5_f64.powi(crossed), "wall {wall:e}: pixel {x},{y} of the ray {ray:?}");
            through += u32::from(crossed == 4);
        }
        assert!(through > 10_000 && undetermined <= 8, "{through} through both, {undetermined} undetermined");
    }
}

#[test]
fn light_in_a_closed_room_of_mirrors_is_a_geometric_series() {
    const K: f64 = 0.9;
    let mirror = json!({"ambient": [0.0625, 0, 0], "diffuse": [0, 0, 0], "reflectivity": K});
    let room = json!({"shape": "difference", "transform": [{"rotate": {"axis": [1, 2, 3], "degrees": 37}}], "of": [
        {"shape": "cube", "transform": [{"scale": [3.1, 2.3, 1.7]}]},
        {"shape": "cube", "transform": [{"scale": [3, 2.2, 1.6]}]}
    ]});
    let view = View { size: [96, 72], ..View::new([0.3, -0.2, 0.1], [1.0, 2.0, -0.5], 80.0) };
    let mut scene = lit(view, 0.0, &mirror, &[room], &json!([]));
    for depth in [5, 12, 50, 200] {
        (scene.limits.depth, scene.limits.contribution) = (depth, 0.0);
        let last = K.powi(i32::try_from(depth).unwrap() + 1);
        let exact = 0.0625 * (1.0 - last) / (1.0 - K);
        let picture = picture(&scene);
        for (x, y, ray) in pixels(&scene) {
            let ours = picture.pixel(x, y).x;
            assert!((ours / exact - 1.0).abs() < 1e-13, "depth {depth}: {ours}, exact {exact}: {x},{y}, {ray:?}");
        }
    }
    // After 200 reflections what is left out is below the seventh digit of the series without end, 0.0625 / (1 − k).
    assert!(picture(&scene).pixel(0, 0).x > 0.625 * (1.0 - 1e-8));
}

#[test]
fn light_is_totally_reflected_exactly_past_the_critical_angle() {
    let n: f64 = 1.333;
    let water = json!({"ambient": [0, 0, 0], "diffuse": [0, 0, 0], "transparency": 1, "index_of_refraction": n});
    let pool = json!({"shape": "cube", "transform": [{"scale": [100, 100, 1]}, {"translate": [0, 0, -1]}]});
    for field in [110.0, 1e-7] {
        // Once wide, and once a millionth of a degree at the rim of the window itself.
        let tilt = if field > 1.0 { 0.05 } else { (1.0 / n).asin().tan() };
        let view = View::new([0.0, 0.0, -0.5], [0.0, tilt, 0.5], field);
        let mut scene = lit(view, 0.5, &water, std::slice::from_ref(&pool), &json!([]));
        // What is reflected meets the pool's ground next, and goes no further: it is black.
        scene.limits.depth = 1;
        let picture = picture(&scene);
        let (mut reflected, mut undetermined) = (0, 0);
        for (x, y, ray) in pixels(&scene) {
            let [dx, dy, dz] = ray.direction.to_array().map(Big::of);
            let across = squared(&dx) + squared(&dy);
            let excess = across.clone() * squared(&Big::of(n)) / (across + squared(&dz)) - Big::of(1.0);
            if excess.size() < Big::of(4.0 * f64::EPSILON) {
                undetermined += 1;
                continue;
            }
            let exact = excess > Big::of(0.0);
            let ours = picture.pixel(x, y).x;
            assert_eq!(ours, if exact { 0.0 } else { 0.5 }, "pixel {x},{y} of the ray {ray:?}");
            reflected += u32::from(exact);
        }
        assert!((10_000..66_000).contains(&reflected) && undetermined <= 8, "{reflected}, {undetermined}");
    }
}

#[test]
fn the_scene_of_a_case_shows_its_materials() {
    let scene = scene(View::new([0.0, -5.0, 0.0], [0.0; 3], 30.0), &[json!({"shape": "sphere", "material": "3"})]);
    assert_eq!(trace_pixel(&scene, 160, 120, &mut NullRecorder).x, 0.25);
}
