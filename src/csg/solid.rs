//! A solid: placed primitives joined by a binary Boolean tree, and the inside set that a ray has in it (§ 6.5.3).

use super::query::Query;
use super::wide_union::WideUnion;
use super::{Boundary, Course, Enclosure, Extent, IntervalList, Leaf, Node};
use crate::math::Real;
use crate::record::{NullRecorder, Operator, Recorder, Sense};
use crate::shape::{Bounds, Primitive, Solving};
use glam::DVec3;
use smallvec::{SmallVec, smallvec};

/// A primitive or compound, ready to be asked for a ray's inside intervals.
///
/// Most objects are one primitive; that one is kept in the object itself, next to what else a ray asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// The primitives, from left to right.
    pub leaves: SmallVec<[Leaf; 1]>,
    /// The tree over them, operands before what they are combined to; the root is the last.
    pub nodes: SmallVec<[Node; 1]>,
    /// The largest [`Placement::skew`](super::Placement::skew) of the primitives.
    pub skew: f64,
    convex: bool,
}

impl Solid {
    /// A single primitive.
    #[must_use]
    pub fn leaf(leaf: Leaf) -> Self {
        let enclosure = Enclosure::of_primitive(&leaf.shape, &leaf.placement);
        let (skew, convex) = (leaf.placement.skew(), leaf.shape.is_convex());
        Self { leaves: smallvec![leaf], nodes: smallvec![Node::Leaf { leaf: 0, enclosure }], skew, convex }
    }

    /// `left OP right`; the leaves of `right` are numbered after those of `left`.
    #[must_use]
    pub fn pair(name: impl Into<String>, operator: Operator, left: Self, right: Self) -> Self {
        let enclosure = Enclosure::of_pair(operator, left.enclosure(), right.enclosure());
        let (leaves_before, nodes_before) = (left.leaves.len(), left.nodes.len());
        let skew = left.skew.max(right.skew);
        let convex = operator == Operator::Intersection && left.convex && right.convex;
        let (mut leaves, mut nodes) = (left.leaves, left.nodes);
        leaves.extend(right.leaves);
        nodes.extend(right.nodes.into_iter().map(|node| node.shifted(leaves_before, nodes_before)));
        let (left, right) = (nodes_before - 1, nodes.len() - 1);
        nodes.push(Node::Pair { name: name.into(), operator, left, right, enclosure, wide: None });
        Self { leaves, nodes, skew, convex }
    }

    /// The node that is the whole solid.
    #[must_use]
    pub fn root(&self) -> &Node {
        &self.nodes[self.nodes.len() - 1]
    }

    /// The same solid, with a hierarchy over the operands of each union of many.
    #[must_use]
    pub fn with_wide_unions(mut self) -> Self {
        for (index, union) in WideUnion::all_in(&self.nodes) {
            if let Node::Pair { wide, .. } = &mut self.nodes[index] {
                *wide = Some(Box::new(union));
            }
        }
        self
    }

    /// What holds it.
    #[must_use]
    pub fn enclosure(&self) -> &Enclosure {
        self.root().enclosure()
    }

    /// The box that holds it, in world space.
    #[must_use]
    pub fn extent(&self) -> Extent {
        self.enclosure().extent
    }

    /// The corners of a convex hull of the solid, up to rounding: a primitive's own box as it stands, else the extent's.
    #[must_use]
    pub fn hull(&self) -> [DVec3; 8] {
        match self.root() {
            Node::Leaf { leaf, enclosure } if enclosure.extent.is_finite() => {
                let Leaf { shape, placement, .. } = &self.leaves[*leaf];
                let Bounds { low, high } = shape.bounds();
                Extent { low, high }.corners().map(|corner| placement.world_from_generic().transform_point3(corner))
            }
            node => node.enclosure().extent.corners(),
        }
    }

    /// Whether it is known that a line meets it in one interval at most.
    #[must_use]
    pub const fn is_convex(&self) -> bool {
        self.convex
    }

    /// The inside intervals of the ray origin + direction t, for **all** real t.
    ///
    /// Where the arithmetic cannot tell boundaries of two operands apart whose times differ, all is asked again with 32
    /// digits. What these cannot tell apart either, the ray's own numbers leave open: it is crossed together.
    pub fn inside<A: Real>(&self, origin: DVec3, direction: DVec3, recorder: &mut impl Recorder) -> IntervalList {
        self.inside_along::<A>(&Course::new(origin, direction, self.skew), recorder)
    }

    /// The same for a ray that is ready to be tested against extents.
    pub fn inside_along<A: Real>(&self, course: &Course, recorder: &mut impl Recorder) -> IntervalList {
        Query::new(self, course).whole::<A, _>(recorder)
    }

    /// The same in the way that the course says. `is_met` where it is known that the ray meets the box.
    pub fn inside_as_asked(&self, course: &Course, is_met: bool, recorder: &mut impl Recorder) -> IntervalList {
        Query::new(self, course).with_box_met(is_met).as_asked(recorder)
    }

    /// The same for the ray from an origin, of which nothing is known and nothing told.
    #[must_use]
    pub fn inside_by(&self, solving: Solving, origin: DVec3, direction: DVec3) -> IntervalList {
        let course = Course::new(origin, direction, self.skew).solving(solving);
        self.inside_as_asked(&course, false, &mut NullRecorder)
    }

    /// The first boundary with t > 0, for rays that need no more and are not told of: solvers report nothing. `is_met`
    /// where it is known that the ray meets the box.
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "measured: it is asked for every ray, and its answer is large")]
    pub fn first_in_front(
        &self,
        course: &Course,
        is_met: bool,
        recorder: &mut impl Recorder,
    ) -> Option<(Boundary, Sense)> {
        let query = Query::new(self, course).with_box_met(is_met);
        match self.root() {
            Node::Leaf { leaf, enclosure } => query.first_crossing(*leaf, enclosure, recorder),
            Node::Pair { .. } => first_boundary(&query, recorder),
        }
    }

    /// The unit normal at a boundary, in world space, out of the whole solid.
    #[must_use]
    pub fn normal(&self, boundary: &Boundary, world_point: DVec3) -> DVec3 {
        let leaf = &self.leaves[boundary.leaf];
        let point = among_numbers(leaf.placement.generic_point(among_numbers(world_point)));
        let normal = leaf.placement.world_normal(leaf.shape.normal(point, boundary.part));
        if boundary.flipped { -normal } else { normal }
    }
}

/// The first boundary with t > 0 of a compound, whose lists primitives should not make room for.
#[inline(never)]
fn first_boundary<R: Recorder>(query: &Query, recorder: &mut R) -> Option<(Boundary, Sense)> {
    query.as_asked(recorder).first_in_front()
}

/// The point, or the outermost one in its direction where its coordinates are too large for numbers.
#[inline]
fn among_numbers(point: DVec3) -> DVec3 {
    let outermost = |x: f64| if x.is_nan() { 0.0 } else { x.clamp(f64::MIN, f64::MAX) };
    if point.is_finite() { point } else { DVec3::from_array(point.to_array().map(outermost)) }
}
