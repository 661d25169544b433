//! A solid: placed primitives joined by a binary Boolean tree, and the inside set that a ray has in it (§ 6.5.3).

use super::combine::{Tie, combine};
use super::report;
use super::{Boundary, Course, Extent, IntervalList, Placement};
use crate::math::{DoubleDouble, Real};
use crate::record::{Counter, NullRecorder, Operator, Recorder, Sense};
use crate::shape::{Bounds, Crossings, Primitive, Shape};
use glam::DVec3;
use std::cell::Cell;

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
        /// The left solid: an index into [`Solid::nodes`].
        left: usize,
        /// The right solid, likewise.
        right: usize,
        /// The box that holds the result, in world space.
        extent: Extent,
    },
}

impl Node {
    /// The box that holds it, in world space.
    #[must_use]
    pub const fn extent(&self) -> Extent {
        match self {
            Self::Leaf { extent, .. } | Self::Pair { extent, .. } => *extent,
        }
    }

    /// The same node behind so many other leaves and nodes.
    fn shifted(mut self, leaves: usize, nodes: usize) -> Self {
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

/// A primitive or compound, ready to be asked for a ray's inside intervals.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// The primitives, from left to right.
    pub leaves: Vec<Leaf>,
    /// The tree over them, operands before what they are combined to; the root is the last.
    pub nodes: Vec<Node>,
    /// The largest [`Placement::skew`] of the primitives.
    pub skew: f64,
    convex: bool,
}

impl Solid {
    /// A single primitive.
    #[must_use]
    pub fn leaf(leaf: Leaf) -> Self {
        let extent = Extent::of_primitive(leaf.shape.bounds(), &leaf.placement);
        let (skew, convex) = (leaf.placement.skew(), leaf.shape.is_convex());
        Self { leaves: vec![leaf], nodes: vec![Node::Leaf { leaf: 0, extent }], skew, convex }
    }

    /// `left OP right`; the leaves of `right` are numbered after those of `left`.
    #[must_use]
    pub fn pair(name: impl Into<String>, operator: Operator, left: Self, right: Self) -> Self {
        let extent = Extent::of_pair(operator, left.extent(), right.extent());
        let (leaves_before, nodes_before) = (left.leaves.len(), left.nodes.len());
        let skew = left.skew.max(right.skew);
        let convex = operator == Operator::Intersection && left.convex && right.convex;
        let (mut leaves, mut nodes) = (left.leaves, left.nodes);
        leaves.extend(right.leaves);
        nodes.extend(right.nodes.into_iter().map(|node| node.shifted(leaves_before, nodes_before)));
        let (left, right) = (nodes_before - 1, nodes.len() - 1);
        nodes.push(Node::Pair { name: name.into(), operator, left, right, extent });
        Self { leaves, nodes, skew, convex }
    }

    /// The node that is the whole solid.
    #[must_use]
    pub fn root(&self) -> &Node {
        &self.nodes[self.nodes.len() - 1]
    }

    /// The box that holds it, in world space.
    #[must_use]
    pub fn extent(&self) -> Extent {
        *self.root_extent()
    }

    fn root_extent(&self) -> &Extent {
        match self.root() {
            Node::Leaf { extent, .. } | Node::Pair { extent, .. } => extent,
        }
    }

    /// The corners of a convex hull of the solid, up to rounding: a primitive's own box as it stands, else the extent's.
    #[must_use]
    pub fn hull(&self) -> [DVec3; 8] {
        match self.root() {
            Node::Leaf { leaf, extent } if extent.is_finite() => {
                let Leaf { shape, placement, .. } = &self.leaves[*leaf];
                let Bounds { low, high } = shape.bounds();
                Extent { low, high }.corners().map(|corner| placement.world_from_generic.transform_point3(corner))
            }
            node => node.extent().corners(),
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

    /// The same for a ray that is known to meet the solid's extent.
    pub fn inside_within(&self, course: &Course, recorder: &mut impl Recorder) -> IntervalList {
        Query { is_met: true, ..Query::new(self, course) }.whole::<f64, _>(recorder)
    }

    /// The first boundary with t > 0, for rays that need no more and are not told of: solvers report nothing. `is_met` where it is known that the ray meets the extent.
    pub fn first_in_front(
        &self,
        course: &Course,
        is_met: bool,
        recorder: &mut impl Recorder,
    ) -> Option<(Boundary, Sense)> {
        let query = Query { is_met, ..Query::new(self, course) };
        match self.root() {
            Node::Leaf { leaf, extent } => query.first_crossing(*leaf, extent, recorder),
            Node::Pair { .. } => query.whole::<f64, _>(recorder).first_in_front(),
        }
    }

    /// The unit normal at a boundary, in world space, out of the whole solid.
    #[must_use]
    pub fn normal(&self, boundary: &Boundary, world_point: DVec3) -> DVec3 {
        let leaf = &self.leaves[boundary.leaf];
        let point = among_numbers(leaf.placement.generic_from_world.transform_point3(among_numbers(world_point)));
        let normal = leaf.placement.world_normal(leaf.shape.normal(point, boundary.part));
        if boundary.flipped { -normal } else { normal }
    }
}

/// One ray's way through the tree.
struct Query<'a> {
    solid: &'a Solid,
    course: &'a Course,
    /// The ray is known to meet the extent of the whole solid.
    is_met: bool,
    /// Boundaries of two operands that could not be told apart: the first that were met.
    tie: Cell<Option<Tie>>,
}

impl<'a> Query<'a> {
    const fn new(solid: &'a Solid, course: &'a Course) -> Self {
        Self { solid, course, is_met: false, tie: Cell::new(None) }
    }

    /// The whole tree.
    fn whole<A: Real, R: Recorder>(&self, recorder: &mut R) -> IntervalList {
        if A::FINEST || matches!(self.solid.root(), Node::Leaf { .. }) {
            self.node::<A, _>(self.solid.root(), recorder)
        } else {
            self.adaptively::<A, _>(recorder)
        }
    }

    /// The whole tree, in the fast arithmetic if that is enough.
    fn adaptively<A: Real, R: Recorder>(&self, recorder: &mut R) -> IntervalList {
        let root = self.solid.root();
        // What is told is the way that decided; so it has to be known first which one that is.
        let first =
            if R::RECORDING { self.node::<A, _>(root, &mut NullRecorder) } else { self.node::<A, R>(root, recorder) };
        match self.tie.take() {
            None if R::RECORDING => self.node::<A, R>(root, recorder),
            None => first,
            Some(tie) => {
                let list = self.node::<DoubleDouble, R>(root, recorder);
                recorder.note(|| report::tie::<A>(tie, self.tie.get()));
                list
            }
        }
    }

    fn node<A: Real, R: Recorder>(&self, node: &Node, recorder: &mut R) -> IntervalList {
        match node {
            Node::Leaf { leaf, extent } => self.leaf::<A, R>(*leaf, extent, recorder),
            Node::Pair { name, operator, left, right, extent } => {
                let operands = [*left, *right].map(|index| &self.solid.nodes[index]);
                self.pair::<A, R>(name, *operator, operands, extent, recorder)
            }
        }
    }

    /// Both lists and their combination, with the early outs of § 6.5.3.
    fn pair<A: Real, R: Recorder>(
        &self,
        name: &str,
        operator: Operator,
        [left, right]: [&Node; 2],
        extent: &Extent,
        recorder: &mut R,
    ) -> IntervalList {
        let empty = IntervalList::default();
        let told = |left: &IntervalList, right: Option<&IntervalList>, combined: &IntervalList, out| {
            report::combine(self.solid, name, operator, [Some(left), right, Some(combined)], out)
        };
        recorder.begin();
        if !self.meets(name, extent, recorder) {
            let reason = "the ray misses the extent, so nothing in it was asked";
            recorder.end(|| told(&empty, None, &empty, Some(reason)));
            return empty;
        }
        let left_list = self.node::<A, R>(left, recorder);
        if left_list.is_empty() && operator != Operator::Union {
            recorder.end(|| told(&left_list, None, &empty, Some(left_is_missed(operator))));
            return empty;
        }
        let right_list = self.node::<A, R>(right, recorder);
        let combined = combine(operator, &left_list, &right_list, &mut |tie| {
            self.tie.set(Some(self.tie.get().unwrap_or(tie)));
        });
        if R::RECORDING {
            let lists = [&left_list, &right_list];
            report::rejected(self.solid, name, operator, [left, right], lists, &combined, recorder);
        }
        recorder.end(|| told(&left_list, Some(&right_list), &combined, early_out(operator, &left_list, &right_list)));
        combined
    }

    fn leaf<A: Real, R: Recorder>(&self, index: usize, extent: &Extent, recorder: &mut R) -> IntervalList {
        let leaf = &self.solid.leaves[index];
        recorder.begin();
        let list = if self.meets(&leaf.name, extent, recorder) {
            self.primitive::<A, R>(index, leaf, extent, recorder)
        } else {
            IntervalList::default()
        };
        recorder.end(|| report::primitive(leaf, index, &list));
        list
    }

    /// The primitive's own list: the ray in generic coordinates, its crossings, and the intervals between them.
    fn primitive<A: Real, R: Recorder>(
        &self,
        index: usize,
        leaf: &Leaf,
        extent: &Extent,
        recorder: &mut R,
    ) -> IntervalList {
        recorder.count(Counter::ShapeTest(leaf.shape.index()));
        recorder.note(|| report::transform(leaf, self.course.origin, self.course.direction));
        let ray = leaf.placement.generic_ray::<A>(self.course.origin, self.course.direction);
        let mut crossings = Crossings::new();
        if R::RECORDING {
            leaf.shape.crossings(&ray, recorder, &mut crossings);
        } else {
            // Solvers do not count; so all recorders that only count can share one copy of their code.
            leaf.shape.crossings(&ray, &mut NullRecorder, &mut crossings);
        }
        if crossings.is_empty() && extent.is_unbounded() && leaf.shape.implicit(ray.point(A::ZERO)) < 0.0 {
            return IntervalList::starting(true);
        }
        IntervalList::of_crossings(index, &crossings)
    }

    /// The first crossing of a primitive with t > 0: what is first in its interval list too.
    fn first_crossing(&self, index: usize, extent: &Extent, recorder: &mut impl Recorder) -> Option<(Boundary, Sense)> {
        let leaf = &self.solid.leaves[index];
        if !self.meets(&leaf.name, extent, recorder) {
            return None;
        }
        recorder.count(Counter::ShapeTest(leaf.shape.index()));
        let ray = leaf.placement.generic_ray::<f64>(self.course.origin, self.course.direction);
        let mut crossings = Crossings::new();
        leaf.shape.crossings(&ray, &mut NullRecorder, &mut crossings);
        let first = crossings.iter().find(|crossing| crossing.t > 0.0)?;
        Some((Boundary::of_crossing(index, first), first.sense))
    }

    fn meets(&self, name: &str, extent: &Extent, recorder: &mut impl Recorder) -> bool {
        let is_root = self.is_met && std::ptr::eq(extent, self.solid.root_extent());
        if is_root || !self.course.boxes || extent.is_unbounded() {
            return true;
        }
        let inside = extent.inside(self.course);
        recorder.count(Counter::ExtentTest);
        if inside.is_none() {
            recorder.count(Counter::ExtentMiss);
        }
        recorder.note(|| report::extent(name, extent, inside));
        inside.is_some()
    }
}

/// Why the right operand is not asked where the left one is missed.
const fn left_is_missed(operator: Operator) -> &'static str {
    match operator {
        Operator::Intersection => "the ray misses the left solid, and a point must be in both",
        _ => "the ray misses the left solid, and nothing can be taken from nothing",
    }
}

/// The early outs that both lists allow: nothing was left to combine.
fn early_out(operator: Operator, left: &IntervalList, right: &IntervalList) -> Option<&'static str> {
    match (operator, left.is_empty(), right.is_empty()) {
        (Operator::Union, true, true) => Some("the ray misses both solids"),
        (Operator::Intersection, _, true) => Some("the ray misses the right solid, and a point must be in both"),
        (Operator::Difference, _, true) => Some("the ray misses the right solid, so the left list is the result"),
        _ => None,
    }
}

/// The point, or the outermost one in its direction where its coordinates are too large for numbers.
#[inline]
fn among_numbers(point: DVec3) -> DVec3 {
    let outermost = |x: f64| if x.is_nan() { 0.0 } else { x.clamp(f64::MIN, f64::MAX) };
    if point.is_finite() { point } else { DVec3::from_array(point.to_array().map(outermost)) }
}
