//! Lights that have a size against what geometry says of them.

use rayscope::record::{Effect, What};
use rayscope::scene::{Scene, load};
use rayscope::trace::{Progress, record_ray, render};
use std::f64::consts::PI;

/// The height of the edge of a half plane that covers x < 0, and that of the light's middle above it.
const EDGE: f64 = 2.0;
const LIGHT: f64 = 5.0;

fn scene(area: &str, samples: u32) -> Scene {
    let text = format!(
        r#"{{
            "camera": {{ "eye": [0, -3, 0.5], "look_at": [0, 0, 0] }},
            "image": {{ "width": 32, "height": 8 }},
            "sampling": {{ "samples": 4 }},
            "lights": [{{ "name": "lamp", "area": {area}, "samples": {samples} }}],
            "materials": {{ "matt": {{ "diffuse": [1, 1, 1] }} }},
            "objects": [
                {{ "shape": "plane", "material": "matt" }},
                {{ "shape": "square", "material": "matt",
                    "transform": [{{ "translate": [-1, 0, 0] }}, {{ "scale": 1000 }}, {{ "translate": [0, 0, {EDGE}] }}] }}
            ]
        }}"#
    );
    load(&text, "edge").unwrap_or_else(|errors| panic!("{errors}"))
}

/// The share of the light that arrives at (x, 0, 0).
fn arriving(scene: &Scene, x: f64) -> f64 {
    let tree = record_ray(scene, glam::DVec3::new(x, -1.0, 0.5), glam::DVec3::new(0.0, 1.0, -0.5));
    let light = tree.events.iter().find_map(|event| match &event.what {
        What::Light { arriving, .. } => Some(arriving[0]),
        _ => None,
    });
    light.unwrap()
}

/// Where the edge is seen in the light's plane from (x, 0, 0): beyond it the light is in sight.
fn edge_in_light(x: f64) -> f64 {
    x * (1.0 - LIGHT / EDGE)
}

const PLACES: [f64; 9] = [-0.9, -0.6, -0.4, -0.17, 0.0, 0.05, 0.33, 0.5, 0.8];

#[test]
fn a_disc_behind_an_edge_lights_by_the_segment_that_is_seen() {
    let scene =
        scene(&format!(r#"{{ "kind": "disc", "centre": [0, 0, {LIGHT}], "normal": [0, 0, 1], "radius": 0.8 }}"#), 4096);
    for x in PLACES {
        let s = (edge_in_light(x) / 0.8).clamp(-1.0, 1.0);
        let expected = (s.acos() - s * (1.0 - s * s).sqrt()) / PI;
        assert!((arriving(&scene, x) - expected).abs() < 0.004, "at {x}: {} and not {expected}", arriving(&scene, x));
    }
}

#[test]
fn a_rectangle_behind_an_edge_lights_by_the_part_that_is_seen() {
    let rectangle =
        format!(r#"{{ "kind": "rectangle", "corner": [-0.5, -2, {LIGHT}], "edges": [[1, 0, 0], [0, 4, 0]] }}"#);
    let scene = scene(&rectangle, 1024);
    for x in PLACES {
        let expected = (0.5 - edge_in_light(x)).clamp(0.0, 1.0);
        assert!((arriving(&scene, x) - expected).abs() < 0.002, "at {x}: {} and not {expected}", arriving(&scene, x));
    }
}

/// The share of the solid angle of a cone of half angle α on one side of a plane through its apex, at the angle ε from its axis,
/// by slices about the axis.
fn seen_of_cone(alpha: f64, epsilon: f64) -> f64 {
    const SLICES: u32 = 20_000;
    let cap = 1.0 - alpha.cos();
    let slice = |k: u32| {
        let theta = (1.0 - cap * (f64::from(k) + 0.5) / f64::from(SLICES)).acos();
        let cosine = (epsilon.tan() / theta.tan()).clamp(-1.0, 1.0);
        cosine.acos() / PI
    };
    (0..SLICES).map(slice).sum::<f64>() / f64::from(SLICES)
}

#[test]
fn a_sphere_behind_an_edge_lights_by_the_solid_angle_that_is_seen() {
    let scene = scene(&format!(r#"{{ "kind": "sphere", "centre": [0, 0, {LIGHT}], "radius": 0.8 }}"#), 4096);
    for x in PLACES {
        let alpha = (0.8 / x.hypot(LIGHT)).asin();
        // The angle by which the sphere's middle lies behind the edge.
        let epsilon = (-x).atan2(LIGHT) - (-x).atan2(EDGE);
        let expected = seen_of_cone(alpha, -epsilon);
        assert!((arriving(&scene, x) - expected).abs() < 0.004, "at {x}: {} and not {expected}", arriving(&scene, x));
    }
}

#[test]
fn every_point_of_a_light_costs_one_shadow_ray() {
    let scene =
        scene(&format!(r#"{{ "kind": "disc", "centre": [3, 0, {LIGHT}], "normal": [0, 0, 1], "radius": 0.5 }}"#), 3);
    let (_, tally) = render(&scene, &Progress::new());
    let shadows = tally.rays(rayscope::record::RayKind::Shadow);
    assert_eq!(tally.sent(Effect::SoftShadows), shadows);
    assert_eq!(tally.sent(Effect::Shadows), 0);
    assert!(shadows > 0 && shadows.is_multiple_of(3), "{shadows}");
}

#[test]
fn a_light_that_is_asked_once_a_sample_has_the_same_mean_as_one_that_is_asked_often() {
    let area = format!(r#"{{ "kind": "disc", "centre": [0, 0, {LIGHT}], "normal": [0, 0, 1], "radius": 0.8 }}"#);
    let (mut once, mut often) = (scene(&area, 1), scene(&area, 16));
    (once.sampling.samples, often.sampling.samples) = (2048, 256);
    let [a, b] = [once, often].map(|scene| render(&scene, &Progress::new()).0);
    for x in 0..32 {
        let difference = (a.pixel(x, 4) - b.pixel(x, 4)).abs().max_element();
        assert!(difference < 0.02, "{x}: {difference}");
    }
}
