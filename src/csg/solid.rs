//! A solid: placed primitives joined by a binary Boolean tree, and its `inside` method (§ 6.5.3).

use super::{Extent, IntervalList, Placement};
use crate::record::Operator;
use crate::shape::Shape;

/// A placed primitive.
#[derive(Clone, Debug, PartialEq)]
pub struct Leaf {
    /// Its name, or its shape's where it has none.
    pub name: String,
    /// The generic primitive.
    pub shape: Shape,
    /// Where it stands.
    pub placement: Placement,
    /// The names of the parts of its surface.
    pub parts: Vec<String>,
}

/// A node of the Boolean tree, with the extent that holds it.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// A leaf: an index into [`Solid::leaves`].
    Leaf {
        /// The index.
        leaf: usize,
        /// The box that holds it, in world space.
        extent: Extent,
    },
    /// left OP right.
    Pair {
        /// Its name, or its operator's.
        name: String,
        /// OP.
        operator: Operator,
        /// The left solid.
        left: Box<Node>,
        /// The right solid.
        right: Box<Node>,
        /// The box that holds the result, in world space.
        extent: Extent,
    },
}

/// A primitive or compound, ready to be asked for a ray's inside intervals.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// The primitives, from left to right.
    pub leaves: Vec<Leaf>,
    /// The tree over them.
    pub root: Node,
}
