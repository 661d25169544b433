//! The things of a scene that can be edited one by one: camera, lights, materials, objects and their parts.

use super::completion::value_at;
use super::place::{Place, Step};
use crate::csg::Solid;
use crate::scene::Object;
use serde_json::Value;

/// What a thing is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TargetKind {
    /// The eye.
    Camera,
    /// The picture's size.
    Image,
    /// How pixels are sampled.
    Sampling,
    /// Where a ray's tree ends.
    Limits,
    /// A light.
    Light,
    /// A material.
    Material,
    /// An object.
    Object,
    /// A solid that is a part of an object.
    Part,
    /// A named solid, for copies.
    Solid,
}

/// A thing of the scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Target {
    /// What it is.
    pub kind: TargetKind,
    /// Where it stands; of camera, image, sampling and limits perhaps only where it would stand.
    pub place: Place,
    /// Its name, or its shape's; empty where there is but one of its kind.
    pub name: String,
    /// How many solids it is inside of.
    pub depth: usize,
}

/// Parts of parts are listed no deeper.
const MOST_DEPTH: usize = 200;

/// All things of a scene: camera, picture and limits first, then lights, objects with their parts, and materials.
#[must_use]
pub fn targets(whole: &Value) -> Vec<Target> {
    let root = Place::ROOT;
    let single = |kind, name: &str| Target { kind, place: root.field(name), name: String::new(), depth: 0 };
    let mut list = vec![
        single(TargetKind::Camera, "camera"),
        single(TargetKind::Image, "image"),
        single(TargetKind::Sampling, "sampling"),
        single(TargetKind::Limits, "limits"),
    ];
    for (i, light) in items(whole, "lights").iter().enumerate() {
        let name = text(light, "name").map_or_else(|| format!("light {}", i + 1), str::to_owned);
        list.push(Target { kind: TargetKind::Light, place: root.field("lights").item(i), name, depth: 0 });
    }
    for (i, object) in items(whole, "objects").iter().enumerate() {
        solids(object, &root.field("objects").item(i), 0, TargetKind::Object, &mut list);
    }
    for (name, solid) in fields(whole, "solids") {
        let first = list.len();
        solids(solid, &root.field("solids").field(name), 0, TargetKind::Solid, &mut list);
        if let Some(target) = list.get_mut(first) {
            target.name.clone_from(name);
        }
    }
    for (name, _) in fields(whole, "materials") {
        let place = root.field("materials").field(name);
        list.push(Target { kind: TargetKind::Material, place, name: name.clone(), depth: 0 });
    }
    list
}

fn solids(solid: &Value, place: &Place, depth: usize, kind: TargetKind, list: &mut Vec<Target>) {
    let name = text(solid, "name").or_else(|| text(solid, "shape")).unwrap_or_default().to_owned();
    list.push(Target { kind, place: place.clone(), name, depth });
    if depth < MOST_DEPTH {
        for (i, part) in items(solid, "of").iter().enumerate() {
            solids(part, &place.field("of").item(i), depth + 1, TargetKind::Part, list);
        }
    }
}

fn items<'v>(value: &'v Value, name: &str) -> &'v [Value] {
    value.get(name).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

fn fields<'v>(value: &'v Value, name: &str) -> impl Iterator<Item = (&'v String, &'v Value)> {
    value.get(name).and_then(Value::as_object).into_iter().flatten()
}

fn text<'v>(value: &'v Value, name: &str) -> Option<&'v str> {
    value.get(name).and_then(Value::as_str).filter(|text| !text.is_empty())
}

/// The innermost thing that a place lies in; none for what belongs to the scene as a whole.
#[must_use]
pub fn target_at(targets: &[Target], place: &Place) -> Option<usize> {
    let holding = targets.iter().enumerate().filter(|(_, target)| target.place.holds(place));
    holding.max_by_key(|(_, target)| target.place.0.len()).map(|(i, _)| i)
}

/// The object that a place lies in, by its number in the scene; none for what is no object.
#[must_use]
pub fn object_at(place: &Place) -> Option<usize> {
    match &place.0[..] {
        [Step::Field(list), Step::Item(index), ..] if list == "objects" => Some(*index),
        _ => None,
    }
}

/// Where the object of this number stands, or where the part of it that became this leaf does.
///
/// Leaves are numbered from left to right, each copy counting as what it is a copy of.
#[must_use]
pub fn place_of_leaf(whole: &Value, object: usize, leaf: Option<usize>) -> Place {
    let place = Place::ROOT.field("objects").item(object);
    let (Some(leaf), Some(value)) = (leaf, value_at(whole, &place)) else { return place };
    let mut left = leaf;
    find_leaf(whole, value, &place, &mut left, MOST_DEPTH).unwrap_or(place)
}

fn find_leaf(whole: &Value, value: &Value, place: &Place, left: &mut usize, depth: usize) -> Option<Place> {
    let depth = depth.checked_sub(1)?;
    if value.get("shape").is_some_and(|shape| shape == "copy") {
        let original = whole.get("solids")?.get(text(value, "solid")?)?;
        return find_leaf(whole, original, place, left, depth).map(|_| place.clone());
    }
    if value.get("of").is_some() {
        let parts = items(value, "of").iter().enumerate();
        let mut parts = parts.map(|(i, part)| (part, place.field("of").item(i)));
        return parts.find_map(|(part, place)| find_leaf(whole, part, &place, left, depth));
    }
    if *left == 0 {
        return Some(place.clone());
    }
    *left -= 1;
    None
}

/// The number of the object of this name, and of its leaf of that name.
#[must_use]
pub fn object_and_leaf(objects: &[Object], object: &str, leaf: &str) -> Option<(usize, Option<usize>)> {
    let index = objects.iter().position(|candidate| candidate.name == object)?;
    Some((index, leaf_named(&objects[index].solid, leaf)))
}

/// The only leaf of this name; none where several have it, or none.
fn leaf_named(solid: &Solid, name: &str) -> Option<usize> {
    let mut named = solid.leaves.iter().enumerate().filter(|(_, leaf)| leaf.name == name).map(|(i, _)| i);
    named.next().filter(|_| named.next().is_none())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{embedded_scene, load};

    fn whole(name: &str) -> (Value, crate::scene::Scene) {
        let text = embedded_scene(name).unwrap().text;
        (serde_json::from_str(text).unwrap(), load(text, name).unwrap())
    }

    #[test]
    fn all_things_of_the_bowl_are_listed_with_the_parts_inside_their_object() {
        let (whole, _) = whole("csg/bowl");
        let names: Vec<_> = targets(&whole)
            .into_iter()
            .filter(|target| !target.name.is_empty())
            .map(|target| (target.depth, target.name))
            .collect();
        let names: Vec<_> = names.iter().map(|(depth, name)| (*depth, name.as_str())).collect();
        let expected = [
            (0, "key light"),
            (0, "fill light"),
            (0, "bowl"),
            (1, "S₁"),
            (1, "S₂"),
            (1, "C"),
            (0, "floor"),
            (0, "floor"),
            (0, "glaze"),
            (0, "inside"),
            (0, "rim"),
        ];
        assert_eq!(names, expected);
    }

    #[test]
    fn every_leaf_of_every_scene_is_found_in_its_file() {
        for scene in crate::scene::embedded_scenes() {
            let (whole, compiled) = whole(&scene.name);
            for (i, object) in compiled.objects.iter().enumerate() {
                for (j, leaf) in object.solid.leaves.iter().enumerate() {
                    let place = place_of_leaf(&whole, i, Some(j));
                    let shape = value_at(&whole, &place).and_then(|solid| text(solid, "shape")).unwrap();
                    assert!(shape == leaf.shape.name() || shape == "copy", "{}: {place}: {shape}", scene.name);
                }
            }
        }
    }

    #[test]
    fn a_place_belongs_to_the_innermost_thing_around_it() {
        let (whole, _) = whole("csg/bowl");
        let targets = targets(&whole);
        let name = |place: &str| target_at(&targets, &Place::read(place).unwrap()).map(|i| targets[i].name.as_str());
        assert_eq!(name("objects[0].of[1].transform[0].scale"), Some("S₂"));
        assert_eq!(name("objects[0].transform"), Some("bowl"));
        assert_eq!(name("title"), None);
    }
}
