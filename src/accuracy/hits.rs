//! The hits that a method finds, with one primitive or compound.

use super::oracle::Target;
use crate::csg::{Node, Solid};
use crate::math::{Alone, DoubleDouble, Precise, Real};
use crate::record::{NullRecorder, Operator};
use crate::shape::{Crossings, GenericRay, Method, Primitive, textbook};
use glam::DVec3;

/// The hit times that a method finds, ascending.
#[must_use]
pub fn hits(method: Method, target: &Target, origin: DVec3, direction: DVec3) -> Vec<f64> {
    match method {
        Method::Single => with::<Alone<f32>>(target, origin, direction),
        Method::Double => with::<Alone<f64>>(target, origin, direction),
        Method::Adaptive => with::<f64>(target, origin, direction),
        Method::DoubleDouble => with::<DoubleDouble>(target, origin, direction),
        Method::Exact => with::<Precise>(target, origin, direction),
        Method::Textbook => by_the_book(target, origin, direction).iter().map(|hit| hit.t).collect(),
    }
}

fn with<A: Real>(target: &Target, origin: DVec3, direction: DVec3) -> Vec<f64> {
    match target {
        Target::Shape(shape) => {
            let mut found = Crossings::new();
            shape.crossings(&GenericRay::<A>::new(origin, direction), &mut NullRecorder, &mut found);
            found.iter().map(|hit| hit.t).collect()
        }
        Target::Solid(solid) => {
            let inside = solid.inside::<A>(origin, direction, &mut NullRecorder);
            inside.boundaries().iter().map(|(boundary, _)| boundary.t).collect()
        }
    }
}

fn by_the_book(target: &Target, origin: DVec3, direction: DVec3) -> Crossings {
    match target {
        Target::Shape(shape) => {
            let mut found = Crossings::new();
            textbook::crossings(shape, &GenericRay::new(origin, direction), &mut found);
            found
        }
        Target::Solid(solid) => node_by_the_book(solid, solid.root(), origin, direction),
    }
}

fn node_by_the_book(solid: &Solid, node: &Node, origin: DVec3, direction: DVec3) -> Crossings {
    match node {
        Node::Leaf { leaf, .. } => {
            let leaf = &solid.leaves[*leaf];
            let mut found = Crossings::new();
            textbook::crossings(&leaf.shape, &leaf.placement.generic_ray(&[origin, direction]), &mut found);
            found
        }
        Node::Pair { operator, left, right, .. } => {
            let [left, right] =
                [*left, *right].map(|node| node_by_the_book(solid, &solid.nodes[node], origin, direction));
            let holds = |in_left, in_right| Operator::holds(*operator, in_left, in_right);
            textbook::combine(holds, &left, &right).into()
        }
    }
}
