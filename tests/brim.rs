//! Transparent objects that share a boundary: a glass that is filled to the brim. Wherever the scene lies, the water begins where
//! the glass ends, with no air between them.

use glam::{DMat3, DVec3};
use rayscope::record::{EventId, What};
use rayscope::scene::{Scene, load};
use rayscope::trace::{RayTree, record_ray};

/// A glass of radius 1 and height 2 with a wall of 0.1, and water in it up to the rim, moved and turned by `steps`. The hollow is
/// deeper than the water, so that the two have the same wall by different transforms.
fn full_glass(steps: &str) -> Scene {
    let text = format!(
        r#"{{
            "background": [1, 1, 1],
            "limits": {{ "depth": 6, "contribution": 0 }},
            "materials": {{
                "glass": {{ "ambient": [0, 0, 0], "diffuse": [0, 0, 0], "transparency": 0.9, "index_of_refraction": 1.5 }},
                "water": {{ "ambient": [0, 0, 0], "diffuse": [0, 0, 0], "transparency": 0.8, "index_of_refraction": 1.33 }}
            }},
            "objects": [
                {{ "shape": "difference", "name": "glass", "material": "glass", "transform": {steps}, "of": [
                    {{ "shape": "cylinder", "name": "body", "transform": [{{ "scale": [1, 1, 2] }}] }},
                    {{ "shape": "cylinder", "name": "hollow",
                       "transform": [{{ "scale": [0.9, 0.9, 2.5] }}, {{ "translate": [0, 0, 0.1] }}] }}
                ] }},
                {{ "shape": "cylinder", "name": "water", "material": "water",
                   "transform": [{{ "scale": [0.9, 0.9, 1.9] }}, {{ "translate": [0, 0, 0.1] }}, {after}] }}
            ]
        }}"#,
        after = steps.trim_start_matches('[').trim_end_matches(']')
    );
    load(&text, "a test").unwrap_or_else(|errors| panic!("{errors}"))
}

/// Numbers in [0, 1) that are the same everywhere (additive recurrence with powers of the plastic number's relatives).
fn spread(number: u32, dimension: u32) -> f64 {
    const ROOT: f64 = 1.167_303_978_261_418_7;
    (0.5 + f64::from(number + 1) * ROOT.powi(-i32::try_from(dimension + 1).expect("small"))).fract()
}

/// A ray from around the glass towards a point in it, in the glass's own space.
fn ray(number: u32) -> [DVec3; 2] {
    let [u, v, a, b, c] = std::array::from_fn(|d| spread(number, u32::try_from(d).expect("small")));
    let (height, angle) = (2.0 * u - 1.0, std::f64::consts::TAU * v);
    let round = (1.0 - height * height).sqrt();
    let from = DVec3::new(round * angle.cos(), round * angle.sin(), height) * 6.0 + DVec3::Z;
    let to = DVec3::new(1.8 * a - 0.9, 1.8 * b - 0.9, 2.0 * c);
    [from, to - from]
}

/// What is wrong with how a ray went through the glass, if anything; and how often it went through the wall between glass and
/// water.
fn judged(tree: &RayTree) -> Result<usize, String> {
    let mut shared = 0;
    let mut last_leaf = String::new();
    for event in &tree.events {
        match &event.what {
            What::Hit { leaf, .. } => last_leaf.clone_from(leaf),
            What::Medium { object, before, after, interpenetration, hidden, .. } => {
                let told = format!("{object}: {before} → {after} at {last_leaf}, event {}", event.id);
                if *interpenetration || *hidden {
                    return Err(told);
                }
                let both = object == "glass and water" || object == "water and glass";
                let between = [before.as_str(), after.as_str()] == ["glass", "water"]
                    || [before.as_str(), after.as_str()] == ["water", "glass"];
                // What is seen of a shared wall is the glass's: rounding does not choose between the two.
                if between != both || (last_leaf == "hollow") != both {
                    return Err(told);
                }
                shared += usize::from(both);
            }
            What::Nothing { .. } if medium_of(tree, event.id) != "air" => {
                return Err(format!("a ray in {} leaves the scene, event {}", medium_of(tree, event.id), event.id));
            }
            _ => {}
        }
    }
    Ok(shared)
}

/// The medium of the ray that an event belongs to.
fn medium_of(tree: &RayTree, id: EventId) -> &str {
    let above = tree.path(id).into_iter().rev();
    let mut media = above.filter_map(|id| match &tree.event(id).what {
        What::Ray { medium, .. } => Some(medium.as_str()),
        _ => None,
    });
    media.next().unwrap_or("air")
}

fn assert_full(scene: &Scene, to_world: impl Fn(DVec3) -> DVec3, count: u32, place: &str) {
    let (mut shared, mut wrong) = (0, Vec::new());
    for number in 0..count {
        let [from, direction] = ray(number);
        let origin = to_world(from);
        let tree = record_ray(scene, origin, to_world(from + direction) - origin);
        match judged(&tree) {
            Ok(count) => shared += count,
            Err(reason) => wrong.push(format!("ray {number}: {reason}")),
        }
    }
    wrong.truncate(5);
    assert!(wrong.is_empty(), "{place}:\n{}", wrong.join("\n"));
    assert!(shared > count as usize / 4, "{place}: only {shared} hits between glass and water");
}

#[test]
fn the_water_of_a_full_glass_begins_where_the_glass_ends() {
    assert_full(&full_glass(r#"[{ "scale": 1 }]"#), |p| p, 10_000, "in place");
}

#[test]
fn so_it_does_turned_and_far_from_the_origin() {
    let axis = DVec3::new(1.0, 2.0, 2.0) / 3.0;
    let turn = DMat3::from_axis_angle(axis, 25_f64.to_radians());
    for far in [10.0, 1e3, 1e6] {
        let shift = DVec3::new(far, -0.7 * far, 0.3 * far);
        let steps = format!(
            r#"[{{ "rotate": {{ "axis": [1, 2, 2], "degrees": 25 }} }}, {{ "translate": [{}, {}, {}] }}]"#,
            shift.x, shift.y, shift.z
        );
        assert_full(&full_glass(&steps), |p| turn * p + shift, 4_000, &format!("{far} away"));
    }
}

#[test]
fn so_it_does_in_another_size() {
    for size in [1e-6, 1e6] {
        let steps = format!(r#"[{{ "rotate": {{ "axis": [3, 0, 4], "degrees": 70 }} }}, {{ "scale": {size} }}]"#);
        let turn = DMat3::from_axis_angle(DVec3::new(0.6, 0.0, 0.8), 70_f64.to_radians());
        assert_full(&full_glass(&steps), |p| turn * p * size, 2_000, &format!("{size} times as large"));
    }
}

#[test]
fn blocks_side_by_side_are_passed_as_one_where_they_touch() {
    let text = r#"{
        "background": [1, 1, 1],
        "materials": { "glass": { "ambient": [0, 0, 0], "diffuse": [0, 0, 0], "transparency": 0.9, "index_of_refraction": 1.5 } },
        "objects": [
            { "shape": "cube", "name": "left", "material": "glass", "transform": [{ "translate": [-1, 0, 0] }] },
            { "shape": "cube", "name": "right", "material": "glass", "transform": [{ "scale": [0.3, 1, 1] }, { "translate": [0.3, 0, 0] }] }
        ]
    }"#;
    let blocks = load(text, "a test").unwrap_or_else(|errors| panic!("{errors}"));
    for slant in [0.0, 0.1, 0.37] {
        let tree = record_ray(&blocks, DVec3::new(-5.0, 0.1, -0.2), DVec3::new(1.0, 0.0, slant * 0.2));
        let media: Vec<String> = tree
            .events
            .iter()
            .filter_map(|event| match &event.what {
                What::Medium { before, after, .. } => Some(format!("{before} {after}")),
                _ => None,
            })
            .collect();
        assert_eq!(media[..3], ["air left", "left right", "right air"], "slant {slant}: {media:?}");
    }
}
