//! The solvers that are compared.

use super::oracle::Target;
use crate::csg::{Node, Solid};
use crate::math::{Alone, DoubleDouble, Real};
use crate::record::{NullRecorder, Operator};
use crate::shape::{Crossings, GenericRay, Primitive, textbook};
use glam::DVec3;

/// A way to find hits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Contender {
    /// The program's solver in single precision, with nothing to fall back on.
    Single,
    /// The same in double precision.
    Double,
    /// What the program renders with: double precision, and 32 digits where these leave the answer open.
    Adaptive,
    /// 32 digits from the start.
    DoubleDouble,
    /// The textbook's solver in double precision.
    Textbook,
}

impl Contender {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 5] = [Self::Single, Self::Double, Self::Adaptive, Self::DoubleDouble, Self::Textbook];

    /// Its name, as it is shown.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Single => "f32",
            Self::Double => "f64",
            Self::Adaptive => "adaptive",
            Self::DoubleDouble => "double-double",
            Self::Textbook => "textbook",
        }
    }

    /// How much coarser than those of `f64` the last digits of its numbers are.
    #[must_use]
    pub fn coarseness(self) -> f64 {
        match self {
            Self::Single => f32::UNIT_ROUNDOFF / f64::UNIT_ROUNDOFF,
            _ => 1.0,
        }
    }

    /// The hit times that it finds, ascending.
    #[must_use]
    pub fn hits(self, target: &Target, origin: DVec3, direction: DVec3) -> Vec<f64> {
        match self {
            Self::Single => with::<Alone<f32>>(target, origin, direction),
            Self::Double => with::<Alone<f64>>(target, origin, direction),
            Self::Adaptive => with::<f64>(target, origin, direction),
            Self::DoubleDouble => with::<DoubleDouble>(target, origin, direction),
            Self::Textbook => by_the_book(target, origin, direction).iter().map(|hit| hit.t).collect(),
        }
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
