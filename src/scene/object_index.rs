//! What is known of the object list before a ray is sent, worked out once for a scene.

use super::projection::{Blur, View};
use super::{Material, Object, Projection};
use crate::csg::{Ball, Extent, Hierarchy};

/// The objects, arranged so that a ray need not ask all of them.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjectIndex {
    /// Over the boxes of the bounded objects, numbered as in `bounded`.
    pub hierarchy: Hierarchy,
    /// The objects that have a box, by their places in the list.
    pub bounded: Vec<usize>,
    /// The objects that have none, by their places in the list.
    pub unbounded: Vec<usize>,
    /// For each object its ball, where that is worthwhile. Objects that touch others are asked even where a ray seems to pass by:
    /// the ray may start on them, and on the wrong side by rounding.
    pub balls: Vec<Option<Ball>>,
    /// For each object whether no part of it lets light through.
    pub opaque: Vec<bool>,
    /// Whether none of them lets light through, and none is filled with what would.
    pub all_opaque: bool,
    /// For each object where it is in the picture.
    pub projections: Vec<Projection>,
    /// The objects that are filled with a transparent material.
    pub transparent: Vec<usize>,
    /// For each of them, by its place in the list, the other ones whose boxes meet its own, ascending; none for opaque objects.
    pub touching: Vec<Vec<usize>>,
    /// Those of them that may hold the eye, or a point of its lens: those whose boxes do.
    pub around_the_eye: Vec<usize>,
    /// How far from the middle of the lens a point may lie for that list to hold; 0 for a pinhole.
    pub eye_reach: f64,
    /// The largest [`Placement::skew`](crate::csg::Placement::skew) of all.
    pub skew: f64,
}

/// How far from its middle a point of the lens lies at most, in radii: a picture fills the square around it, whose corners lie
/// √2 away.
const EYE_REACH: f64 = 1.5;

impl ObjectIndex {
    /// Looks at all objects.
    #[must_use]
    pub fn new(objects: &[Object], materials: &[Material], view: View) -> Self {
        let extents: Vec<Extent> = objects.iter().map(|object| object.solid.extent()).collect();
        let has_box = |object: &usize| extents[*object].is_finite();
        let (bounded, unbounded): (Vec<_>, Vec<_>) = (0..objects.len()).partition(has_box);
        let boxes: Vec<Extent> = bounded.iter().map(|&object| extents[object]).collect();
        let lets_through = |material: usize| materials[material].transparency > 0.0;
        let transparent: Vec<_> = (0..objects.len()).filter(|&o| lets_through(objects[o].material)).collect();
        let eye_reach = EYE_REACH * view.radius();
        let may_hold_eye = |object: &usize| extents[*object].grown(2.0 * eye_reach).holds(view.camera.eye);
        let around_the_eye = transparent.iter().copied().filter(may_hold_eye).collect();
        let skew = objects.iter().map(|object| object.solid.skew).fold(1.0, f64::max);
        let blur = Blur { skew, reach: view.reach() };
        let opaque: Vec<_> = objects.iter().map(|object| !object.surface_materials().any(lets_through)).collect();
        let touching = touching(&extents, &transparent);
        let ball = |object: usize| objects[object].solid.enclosure().worthwhile_ball();
        let balls: Vec<_> =
            (0..objects.len()).map(|object| ball(object).filter(|_| touching[object].is_empty())).collect();
        Self {
            hierarchy: Hierarchy::new(&boxes).with_balls(|item| balls[bounded[item]]),
            bounded,
            unbounded,
            all_opaque: transparent.is_empty() && !opaque.contains(&false),
            opaque,
            projections: objects.iter().map(|object| Projection::new(view, &object.solid.hull(), blur)).collect(),
            touching,
            balls,
            transparent,
            around_the_eye,
            eye_reach,
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
    for others in &mut touching {
        others.sort_unstable();
    }
    touching
}
