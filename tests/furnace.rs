//! The furnace: where the same light comes from everywhere, whatever loses no light cannot be seen.

use rayscope::scene::{Scene, load};
use rayscope::trace::{Progress, render};
use serde_json::{Value, json};

/// A white room with one object, seen in few pixels; rays end where they count for next to nothing.
fn furnace(object: &Value, material: &Value) -> Scene {
    let mut lossless = json!({ "ambient": [0, 0, 0], "diffuse": [0, 0, 0] });
    lossless.as_object_mut().unwrap().extend(material.as_object().unwrap().clone());
    let mut object = object.clone();
    object["material"] = json!("lossless");
    let scene = json!({
        "camera": { "eye": [0.4, -5, 0.9], "look_at": [0, 0, 0], "field_of_view": 32 },
        "image": { "width": 23, "height": 17 },
        "ambient": [0, 0, 0],
        "background": [1, 1, 1],
        "materials": { "lossless": lossless },
        "objects": [object],
        "sampling": { "wavelengths": 6 },
        "limits": { "depth": 100_000, "contribution": 1e-6 }
    });
    load(&scene.to_string(), "a furnace").unwrap_or_else(|errors| panic!("{errors}"))
}

/// Objects with their names. In some of them light goes round for long: in a shell whose hole is off its middle, for more than
/// 10,000 reflections.
fn objects() -> Vec<(&'static str, Value)> {
    let ball = |radius: f64, x: f64| json!({ "shape": "sphere", "transform": [{ "scale": radius }, { "translate": [x, 0, 0] }] });
    vec![
        ("a ball", json!({ "shape": "sphere" })),
        ("a lens", json!({ "shape": "intersection", "of": [ball(1.6, 0.9), ball(1.6, -0.9)] })),
        ("a shell", json!({ "shape": "difference", "of": [ball(1.2, 0.0), ball(0.9, 0.0)] })),
        ("a crooked shell", json!({ "shape": "difference", "of": [ball(1.2, 0.0), ball(0.9, 0.1)] })),
        ("two balls in one", json!({ "shape": "union", "of": [ball(0.8, -0.5), ball(0.8, 0.5)] })),
        ("a hollowed block", json!({ "shape": "difference", "of": [{ "shape": "cube" }, ball(0.7, 0.2)] })),
        ("a ring", json!({ "shape": "torus", "d": 2 })),
    ]
}

/// Every pixel is white, however long its light goes round.
fn assert_white(scene: &Scene, what: &str) {
    let (picture, _) = render(scene, &Progress::new());
    for y in 0..scene.image.height {
        for x in 0..scene.image.width {
            let colour = picture.pixel(x, y);
            assert!((colour - 1.0).abs().max_element() <= 1e-3, "{what}: {colour} at {x},{y}");
        }
    }
}

#[test]
fn perfect_mirrors_cannot_be_seen() {
    for (name, object) in objects() {
        assert_white(&furnace(&object, &json!({ "reflectivity": 1 })), &format!("{name}, a mirror"));
    }
}

#[test]
fn glass_that_loses_nothing_cannot_be_seen() {
    for (name, object) in objects() {
        for index in [1.333, 1.5, 2.4] {
            let glass = json!({ "transparency": 1, "index_of_refraction": index, "fresnel": { "kind": "dielectric" } });
            assert_white(&furnace(&object, &glass), &format!("{name} of glass, n = {index}"));
        }
    }
}

#[test]
fn fixed_weights_that_add_up_to_one_lose_nothing_either() {
    for (name, object) in objects() {
        let glass = json!({ "transparency": 0.9, "reflectivity": 0.1, "index_of_refraction": 1.5 });
        assert_white(&furnace(&object, &glass), &format!("{name} by weights"));
    }
}

#[test]
fn taking_light_apart_loses_nothing() {
    for (name, object) in objects() {
        for kind in ["BK7", "SF11", "water"] {
            let glass = json!({
                "transparency": 1,
                "fresnel": { "kind": "dielectric" },
                "dispersion": { "kind": "glass", "glass": kind }
            });
            assert_white(&furnace(&object, &glass), &format!("{name} of {kind}"));
        }
        let weights = json!({ "transparency": 1, "dispersion": { "kind": "glass", "glass": "diamond" } });
        assert_white(&furnace(&object, &weights), &format!("{name} of diamond, by weights"));
    }
}

#[test]
fn a_metal_absorbs_what_it_does_not_mirror() {
    // The middle of the picture looks at the ball head on: ((η − 1)² + k²) / ((η + 1)² + k²).
    let metal = json!({ "fresnel": { "kind": "conductor", "eta": [1.5, 0.2, 1], "k": [0, 3.9, 2] } });
    let mut scene = furnace(&json!({ "shape": "sphere" }), &metal);
    scene.image = rayscope::scene::Image { width: 1, height: 1 };
    let (picture, _) = render(&scene, &Progress::new());
    for (found, (eta, k)) in picture.pixel(0, 0).to_array().into_iter().zip([(1.5, 0.0), (0.2, 3.9), (1.0, 2.0_f64)]) {
        let expected = ((eta - 1.0_f64).powi(2) + k * k) / ((eta + 1.0).powi(2) + k * k);
        assert!((found - expected).abs() < 1e-12, "{found} is not {expected}");
    }
}
