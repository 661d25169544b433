//! The Boolean tree: placed primitives, and the nodes over them with what holds each.

use super::ball::Ball;
use super::wide_union::WideUnion;
use super::{Boundary, Extent, Placement};
use crate::record::Operator;
use crate::shape::{Primitive, Shape};

/// A placed primitive.
#[derive(Clone, Debug, PartialEq)]
pub struct Leaf {
    /// Its name.
    pub name: String,
    /// The generic primitive.
    pub shape: Shape,
    /// Where it stands.
    pub placement: Placement,
    /// The names of the parts of its surface.
    pub parts: Vec<String>,
}

impl Leaf {
    /// Places a primitive.
    #[must_use]
    pub fn new(name: impl Into<String>, shape: Shape, placement: Placement) -> Self {
        let parts = shape.parts();
        Self { name: name.into(), shape, placement, parts }
    }

    /// The name of a part of its surface.
    #[must_use]
    pub fn part(&self, boundary: &Boundary) -> &str {
        self.parts.get(usize::from(boundary.part)).map_or("surface", String::as_str)
    }
}

/// What holds a node, in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure {
    /// A box.
    pub extent: Extent,
    /// A ball.
    pub ball: Ball,
    /// Whether the ball is so much smaller than the box that it pays to ask it too.
    pub asks_ball: bool,
}

/// A ball is asked where rays that meet the box miss it so often. Asked more often it costs more than it saves.
const WORTHWHILE: f64 = 0.75;

impl Enclosure {
    /// What holds a placed primitive. A sphere's own solver asks no more than its ball would.
    #[must_use]
    pub fn of_primitive(shape: &Shape, placement: &Placement) -> Self {
        let extent = Extent::of_primitive(shape.bounds(), placement);
        let ball = Ball::of_primitive(shape, placement);
        Self { asks_ball: !matches!(shape, Shape::Sphere(_)) && is_worthwhile(&ball, &extent), extent, ball }
    }

    /// What holds a compound. A ball that is the left operand's is not asked: that operand is the first to be asked anyway.
    #[must_use]
    pub fn of_pair(operator: Operator, left: &Self, right: &Self) -> Self {
        let extent = Extent::of_pair(operator, left.extent, right.extent);
        let ball = Ball::of_pair(operator, left.ball, right.ball);
        Self { asks_ball: ball != left.ball && is_worthwhile(&ball, &extent), extent, ball }
    }

    /// Its ball, where many of the lines that meet the box miss it.
    #[must_use]
    pub fn worthwhile_ball(&self) -> Option<Ball> {
        is_worthwhile(&self.ball, &self.extent).then_some(self.ball)
    }
}

fn is_worthwhile(ball: &Ball, extent: &Extent) -> bool {
    ball.half_surface() < WORTHWHILE * extent.half_surface()
}

/// A node of the Boolean tree, with the extent that holds it.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// A leaf: an index into [`Solid::leaves`](super::Solid::leaves).
    Leaf {
        /// The index.
        leaf: usize,
        /// What holds it.
        enclosure: Enclosure,
    },
    /// left OP right.
    Pair {
        /// Its name, or its operator's.
        name: String,
        /// OP.
        operator: Operator,
        /// The left solid: an index into [`Solid::nodes`](super::Solid::nodes).
        left: usize,
        /// The right solid, likewise.
        right: usize,
        /// What holds the result.
        enclosure: Enclosure,
        /// If it is the union of many solids: a hierarchy over them.
        wide: Option<Box<WideUnion>>,
    },
}

impl Node {
    /// What holds it.
    #[must_use]
    pub const fn enclosure(&self) -> &Enclosure {
        match self {
            Self::Leaf { enclosure, .. } | Self::Pair { enclosure, .. } => enclosure,
        }
    }

    /// The same node behind so many other leaves and nodes.
    pub(super) fn shifted(mut self, leaves: usize, nodes: usize) -> Self {
        match &mut self {
            Self::Leaf { leaf, .. } => *leaf += leaves,
            Self::Pair { left, right, .. } => {
                *left += nodes;
                *right += nodes;
            }
        }
        self
    }
}
