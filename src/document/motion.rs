//! Moving things of a scene: which values of the file change when a thing is moved by a vector of the world.

use super::completion::value_at;
use super::place::{Place, Step};
use crate::math::portable;
use crate::scene::{Camera, Image, Transform};
use glam::{DAffine3, DMat3, DVec3};
use serde_json::{Value, json};

/// Places with the values that they are to have.
pub type Settings = Vec<(Place, Value)>;

/// What changes when the thing at `place` is moved by `by`, in world space. None for what has no place in the world.
///
/// Decimal places beyond `decimals` are rounded away from the new coordinates.
#[must_use]
pub fn moved(whole: &Value, place: &Place, by: DVec3, decimals: i32) -> Option<Settings> {
    let first = match place.0.first()? {
        Step::Field(name) => name.as_str(),
        Step::Item(_) => return None,
    };
    match first {
        "camera" => {
            let eye = vector(whole, &place.field("eye")).unwrap_or(DVec3::new(4.0, -6.0, 3.0));
            Some(vec![(place.field("eye"), written(eye + by, decimals))])
        }
        "lights" => light(whole, place, by, decimals),
        "objects" | "solids" => solid(whole, place, by, decimals),
        _ => None,
    }
}

fn light(whole: &Value, place: &Place, by: DVec3, decimals: i32) -> Option<Settings> {
    let area = place.field("area");
    let fields = [place.field("point"), place.field("directional"), area.field("centre"), area.field("corner")];
    let (field, at) = fields.into_iter().find_map(|field| vector(whole, &field).map(|at| (field, at)))?;
    Some(vec![(field, written(at + by, decimals))])
}

/// A solid is moved by its last step, if that is a `translate`, or by a further one. The solids around it are scaled and
/// turned afterwards, so the step is what they take to `by`.
fn solid(whole: &Value, place: &Place, by: DVec3, decimals: i32) -> Option<Settings> {
    let around = linear_around(whole, place)?;
    let by = around.inverse() * by;
    let list = place.field("transform");
    let steps = value_at(whole, &list).and_then(Value::as_array).map_or(0, Vec::len);
    let last = steps.checked_sub(1).map(|last| list.item(last).field("translate"));
    Some(match last.and_then(|last| vector(whole, &last).map(|at| (last, at))) {
        Some((field, at)) => vec![(field, written(at + by, decimals))],
        None => vec![(list.item(steps), json!({ "translate": written(by, decimals) }))],
    })
}

/// The linear part of what the solids around the one at `place` do to it. None where something in it cannot be read.
fn linear_around(whole: &Value, place: &Place) -> Option<DMat3> {
    let mut linear = DMat3::IDENTITY;
    let mut here = place.clone();
    while let Some(outer) = here.parent().and_then(|(list, _)| list.parent().map(|(outer, step)| (outer, step.clone())))
    {
        let (outer, step) = outer;
        if step != Step::Field("of".to_owned()) {
            break;
        }
        linear = own_affine(whole, &outer)?.matrix3 * linear;
        here = outer;
    }
    (linear.determinant() != 0.0).then_some(linear)
}

/// What the steps of a solid's transform do together.
fn own_affine(whole: &Value, solid: &Place) -> Option<DAffine3> {
    let Some(steps) = value_at(whole, &solid.field("transform")) else { return Some(DAffine3::IDENTITY) };
    let steps: Vec<Transform> = serde_json::from_value(steps.clone()).ok()?;
    steps.iter().try_fold(DAffine3::IDENTITY, |before, step| Some(step.affine().ok()? * before))
}

fn vector(whole: &Value, place: &Place) -> Option<DVec3> {
    let items = value_at(whole, place)?.as_array()?;
    let numbers: Vec<f64> = items.iter().map(Value::as_f64).collect::<Option<_>>()?;
    <[f64; 3]>::try_from(numbers).ok().map(DVec3::from_array)
}

fn written(vector: DVec3, decimals: i32) -> Value {
    json!(vector.to_array().map(|x| rounded(x, decimals)))
}

/// The nearest number with so many decimal places.
#[must_use]
pub fn rounded(number: f64, decimals: i32) -> f64 {
    let places = usize::try_from(decimals.max(0)).unwrap_or_default();
    // By way of the text, so that the result is the number that people write.
    let text = format!("{number:.places$}");
    text.parse().map_or(number, |number: f64| if number == 0.0 { 0.0 } else { number })
}

/// How many decimal places a step of this size calls for: two digits of the step are kept.
#[must_use]
pub fn decimals_for(step: f64) -> i32 {
    if !(step.is_finite() && step > 0.0) {
        return 6;
    }
    #[expect(clippy::cast_possible_truncation, reason = "logarithms of numbers are below 400")]
    let places = 1 - portable::log10(step).floor() as i32;
    places.clamp(0, 12)
}

/// The vector of the world that a move of so many pixels to the right and down is, at a depth along the view.
#[must_use]
pub fn across_view(camera: &Camera, image: Image, depth: f64, [right, down]: [f64; 2]) -> DVec3 {
    let (half_width, half_height) = camera.half_size(image);
    let across = 2.0 * half_width * right / f64::from(image.width);
    let upwards = -2.0 * half_height * down / f64::from(image.height);
    (camera.right * across + camera.up * upwards) * depth
}

/// How far a point lies along the view.
#[must_use]
pub fn depth(camera: &Camera, point: DVec3) -> f64 {
    (point - camera.eye).dot(camera.forward)
}

/// The part of a move that goes along an axis of the world, such that it looks the same as nearly as can be.
///
/// `towards` is the direction in which one looks: along it nothing is seen to move. The axis is seen as a line, and the
/// pointer is followed along it.
#[must_use]
pub fn along_axis(towards: DVec3, by: DVec3, axis: DVec3) -> DVec3 {
    let seen = across(towards, axis);
    let length = seen.length_squared();
    // An axis that points at the eye cannot be followed.
    if length < 1e-6 { DVec3::ZERO } else { axis * (by.dot(seen) / length) }
}

/// The same for that axis of the world which goes most nearly the way of the move.
#[must_use]
pub fn along_nearest_axis(towards: DVec3, by: DVec3) -> DVec3 {
    let likeness = |axis: DVec3| across(towards, by).dot(across(towards, axis).normalize_or_zero()).abs();
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let nearest = axes.into_iter().max_by(|a, b| likeness(*a).total_cmp(&likeness(*b))).unwrap_or(DVec3::X);
    along_axis(towards, by, nearest)
}

/// What is seen of a vector by somebody who looks in a direction.
fn across(towards: DVec3, vector: DVec3) -> DVec3 {
    vector - towards * vector.dot(towards)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Structure, Syntax};
    use crate::scene::{embedded_scene, load};

    /// The scene after the thing at a place was moved.
    fn scene_with(text: &str, place: &str, by: DVec3) -> crate::scene::Scene {
        let mut text = text.to_owned();
        let whole: Value = serde_json::from_str(&text).unwrap();
        for (place, value) in moved(&whole, &Place::read(place).unwrap(), by, 12).unwrap() {
            let syntax = Syntax::of(&text);
            let changes = Structure { text: &text, syntax: &syntax }.set(&place, &value).unwrap();
            crate::document::change::splice(&mut text, changes);
        }
        load(&text, "moved.json").unwrap()
    }

    #[test]
    fn a_part_moves_by_as_much_in_the_world_however_its_object_is_turned_and_scaled() {
        let text = r#"{ "materials": { "m": {} }, "objects": [{ "shape": "union", "material": "m",
            "transform": [{ "scale": [2, 3, 4] }, { "rotate": { "axis": [1, 2, 3], "degrees": 50 } }],
            "of": [{ "shape": "cube", "transform": [{ "scale": 0.5 }] }, { "shape": "sphere" }] }] }"#;
        let before = load(text, "before.json").unwrap();
        let by = DVec3::new(1.0, -2.0, 0.5);
        let after = scene_with(text, "objects[0].of[0]", by);
        let middle = |scene: &crate::scene::Scene, leaf: usize| {
            scene.objects[0].solid.leaves[leaf].placement.world_from_generic().translation
        };
        assert!((middle(&after, 0) - middle(&before, 0) - by).length() < 1e-9);
        assert_eq!(middle(&after, 1), middle(&before, 1));
    }

    #[test]
    fn camera_lights_and_objects_move_by_changing_the_numbers_they_have() {
        let text = embedded_scene("csg/bowl").unwrap().text;
        let by = DVec3::new(0.5, 0.25, -1.0);
        let before = load(text, "bowl").unwrap();
        assert!((scene_with(text, "camera", by).camera.eye - before.camera.eye - by).length() < 1e-12);
        let whole: Value = serde_json::from_str(text).unwrap();
        let place = Place::read("objects[0]").unwrap();
        let settings = moved(&whole, &place, by, 6).unwrap();
        assert_eq!(settings, [(Place::read("objects[0].transform[0].translate").unwrap(), json!([0.5, 0.25, 0.5]))]);
        let settings = moved(&whole, &Place::read("lights[0]").unwrap(), by, 6).unwrap();
        assert_eq!(settings[0].1, json!([-7.5, -9.75, 14.0]));
    }

    #[test]
    fn a_point_that_is_moved_across_the_view_follows_the_pointer() {
        let scene = load(embedded_scene("csg/bowl").unwrap().text, "bowl").unwrap();
        let point = DVec3::new(0.3, 0.2, 1.0);
        let [x, y] = scene.camera.project(scene.image, point).unwrap();
        let by = across_view(&scene.camera, scene.image, depth(&scene.camera, point), [40.0, -25.0]);
        let [x2, y2] = scene.camera.project(scene.image, point + by).unwrap();
        assert!((x2 - x - 40.0).abs() < 1e-9 && (y2 - y + 25.0).abs() < 1e-9);
        let along = along_axis(scene.camera.forward, by, DVec3::X);
        assert_eq!((along.y, along.z), (0.0, 0.0));
        assert_eq!(along_nearest_axis(DVec3::Y, DVec3::new(0.3, 0.0, -2.0)), DVec3::new(0.0, 0.0, -2.0));
    }

    #[test]
    fn numbers_are_rounded_to_what_people_write() {
        assert_eq!(rounded(0.1 + 0.2, 3), 0.3);
        assert_eq!(rounded(-0.0001, 3).to_bits(), 0.0_f64.to_bits());
        assert_eq!((decimals_for(0.0123), decimals_for(1.0), decimals_for(500.0)), (3, 1, 0));
    }
}
