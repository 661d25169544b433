//! What is known of the object list before a ray is sent, worked out once for a scene.

use super::projection::Blur;
use super::{Camera, Material, Object, Projection};
use crate::csg::{Extent, Hierarchy};

/// The objects, arranged so that a ray need not ask all of them.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjectIndex {
    /// Over the boxes of the bounded objects, numbered as in `bounded`.
    pub hierarchy: Hierarchy,
    /// The objects that have a box, by their places in the list.
    pub bounded: Vec<usize>,
    /// The objects that have none, by their places in the list.
    pub unbounded: Vec<usize>,
    /// For each object whether no part of it lets light through.
    pub opaque: Vec<bool>,
    /// For each object where it is in the picture.
    pub projections: Vec<Projection>,
    /// The objects that are filled with a transparent material.
    pub transparent: Vec<usize>,
    /// For each of them, by its place in the list, the other ones whose boxes meet its own, ascending; none for opaque objects.
    pub touching: Vec<Vec<usize>>,
    /// Those of them that may hold the eye: those whose boxes do.
    pub around_the_eye: Vec<usize>,
    /// The largest [`Placement::skew`](crate::csg::Placement::skew) of all.
    pub skew: f64,
}

impl ObjectIndex {
    /// Looks at all objects.
    #[must_use]
    pub fn new(objects: &[Object], materials: &[Material], camera: &Camera) -> Self {
        let extents: Vec<Extent> = objects.iter().map(|object| object.solid.extent()).collect();
        let has_box = |object: &usize| extents[*object].is_finite();
        let (bounded, unbounded): (Vec<_>, Vec<_>) = (0..objects.len()).partition(has_box);
        let boxes: Vec<Extent> = bounded.iter().map(|&object| extents[object]).collect();
        let lets_through = |material: usize| materials[material].transparency > 0.0;
        let transparent: Vec<_> = (0..objects.len()).filter(|&o| lets_through(objects[o].material)).collect();
        let around_the_eye = transparent.iter().copied().filter(|&object| extents[object].holds(camera.eye)).collect();
        let skew = objects.iter().map(|object| object.solid.skew).fold(1.0, f64::max);
        let blur = Blur { skew, reach: camera.eye.abs().max_element() };
        Self {
            hierarchy: Hierarchy::new(&boxes),
            bounded,
            unbounded,
            opaque: objects.iter().map(|object| !object.surface_materials().any(lets_through)).collect(),
            projections: objects.iter().map(|object| Projection::new(camera, &object.solid.hull(), blur)).collect(),
            touching: touching(&extents, &transparent),
            transparent,
            around_the_eye,
            skew,
        }
    }
}

/// For each object the other transparent ones whose boxes meet its own: swept along x.
fn touching(extents: &[Extent], transparent: &[usize]) -> Vec<Vec<usize>> {
    let mut touching = vec![Vec::new(); extents.len()];
    let mut sorted = transparent.to_vec();
    sorted.sort_by(|&a, &b| extents[a].low.x.total_cmp(&extents[b].low.x));
    let mut open: Vec<usize> = Vec::new();
    for object in sorted {
        let own = extents[object];
        open.retain(|&other| extents[other].high.x >= own.low.x);
        for &other in open.iter().filter(|&&other| own.meets(extents[other])) {
            touching[object].push(other);
            touching[other].push(object);
        }
        open.push(object);
    }
    touching.iter_mut().for_each(|others| others.sort_unstable());
    touching
}
