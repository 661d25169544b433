//! A solid: placed primitives joined by a binary Boolean tree, and the inside set that a ray has in it (§ 6.5.3).

use super::combine::{Tie, combine};
use super::report;
use super::{Boundary, Extent, Interval, IntervalList, Placement};
use crate::math::{DoubleDouble, Real};
use crate::record::{Counter, NullRecorder, Operator, Recorder, Sense};
use crate::shape::{Crossing, Primitive, Shape};
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
        /// The left solid.
        left: Box<Node>,
        /// The right solid.
        right: Box<Node>,
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

    fn shift_leaves(&mut self, by: usize) {
        match self {
            Self::Leaf { leaf, .. } => *leaf += by,
            Self::Pair { left, right, .. } => {
                left.shift_leaves(by);
                right.shift_leaves(by);
            }
        }
    }
}

/// A primitive or compound, ready to be asked for a ray's inside intervals.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// The primitives, from left to right.
    pub leaves: Vec<Leaf>,
    /// The tree over them.
    pub root: Node,
}

impl Solid {
    /// A single primitive.
    #[must_use]
    pub fn leaf(leaf: Leaf) -> Self {
        let extent = Extent::of_primitive(leaf.shape.bounds(), &leaf.placement);
        Self { leaves: vec![leaf], root: Node::Leaf { leaf: 0, extent } }
    }

    /// `left OP right`; the leaves of `right` are numbered after those of `left`.
    #[must_use]
    pub fn pair(name: impl Into<String>, operator: Operator, left: Self, mut right: Self) -> Self {
        right.root.shift_leaves(left.leaves.len());
        let extent = Extent::of_pair(operator, left.root.extent(), right.root.extent());
        let (left_root, right_root) = (Box::new(left.root), Box::new(right.root));
        let root = Node::Pair { name: name.into(), operator, left: left_root, right: right_root, extent };
        let leaves = left.leaves.into_iter().chain(right.leaves).collect();
        Self { leaves, root }
    }

    /// The box that holds it, in world space.
    #[must_use]
    pub const fn extent(&self) -> Extent {
        self.root.extent()
    }

    /// The inside intervals of the ray origin + direction t, for **all** real t.
    ///
    /// Where the arithmetic cannot tell boundaries of two operands apart whose times differ, all is asked again with 32
    /// digits. What these cannot tell apart either, the ray's own numbers leave open: it is crossed together.
    pub fn inside<A: Real>(&self, origin: DVec3, direction: DVec3, recorder: &mut impl Recorder) -> IntervalList {
        let query = Query { solid: self, origin, direction, tie: Cell::new(None) };
        if A::FINEST || matches!(self.root, Node::Leaf { .. }) {
            return query.node::<A, _>(&self.root, recorder);
        }
        query.adaptively::<A, _>(recorder)
    }

    /// The unit normal at a boundary, in world space, out of the whole solid.
    #[must_use]
    pub fn normal(&self, boundary: &Boundary, world_point: DVec3) -> DVec3 {
        let leaf = &self.leaves[boundary.leaf];
        let point = leaf.placement.generic_from_world.transform_point3(world_point);
        let normal = leaf.placement.world_normal(leaf.shape.normal(point, boundary.part));
        if boundary.flipped { -normal } else { normal }
    }
}

/// One ray's way through the tree.
struct Query<'a> {
    solid: &'a Solid,
    origin: DVec3,
    direction: DVec3,
    /// Boundaries of two operands that could not be told apart: the first that were met.
    tie: Cell<Option<Tie>>,
}

impl Query<'_> {
    /// The whole tree, in the fast arithmetic if that is enough.
    fn adaptively<A: Real, R: Recorder>(&self, recorder: &mut R) -> IntervalList {
        let root = &self.solid.root;
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
                recorder.begin();
                let (lists, early_out) = self.pair::<A, R>(name, *operator, [left, right], extent, recorder);
                recorder.end(|| report::combine(self.solid, name, *operator, &lists, early_out));
                lists.combined
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
    ) -> (Lists, Option<&'static str>) {
        if !self.meets(name, extent, recorder) {
            return (Lists::default(), Some("the ray misses the extent, so nothing in it was asked"));
        }
        let left_list = self.node::<A, R>(left, recorder);
        if left_list.is_empty() && operator != Operator::Union {
            let reason = match operator {
                Operator::Intersection => "the ray misses the left solid, and a point must be in both",
                _ => "the ray misses the left solid, and nothing can be taken from nothing",
            };
            return (Lists { left: left_list, ..Lists::default() }, Some(reason));
        }
        let right_list = self.node::<A, R>(right, recorder);
        let combined = combine(operator, &left_list, &right_list, &mut |tie| {
            self.tie.set(Some(self.tie.get().unwrap_or(tie)));
        });
        let early_out = early_out(operator, &left_list, &right_list);
        if R::RECORDING {
            let lists = [&left_list, &right_list];
            report::rejected(self.solid, name, operator, [left, right], lists, &combined, recorder);
        }
        (Lists { left: left_list, right: Some(right_list), combined }, early_out)
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
        recorder.note(|| report::transform(leaf, self.origin, self.direction));
        let ray = leaf.placement.generic_ray::<A>(self.origin, self.direction);
        let mut crossings = Vec::with_capacity(4);
        leaf.shape.crossings(&ray, recorder, &mut crossings);
        if crossings.is_empty() && extent.is_unbounded() && leaf.shape.implicit(ray.point(A::ZERO)) < 0.0 {
            let everything = Interval { enter: None, leave: None };
            return IntervalList { intervals: vec![everything], touches: Vec::new() };
        }
        paired(index, &crossings)
    }

    fn meets(&self, name: &str, extent: &Extent, recorder: &mut impl Recorder) -> bool {
        if extent.is_unbounded() {
            return true;
        }
        let inside = extent.inside(self.origin, self.direction);
        recorder.count(Counter::ExtentTest);
        if inside.is_none() {
            recorder.count(Counter::ExtentMiss);
        }
        recorder.note(|| report::extent(name, extent, inside));
        inside.is_some()
    }
}

/// What a node of the tree worked out.
#[derive(Default)]
pub struct Lists {
    /// The left solid's inside set.
    pub left: IntervalList,
    /// The right solid's; none if it was never asked.
    pub right: Option<IntervalList>,
    /// The result's.
    pub combined: IntervalList,
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

/// Crossings in order make intervals; a leading `Leave` or trailing `Enter` makes an unbounded one.
fn paired(leaf: usize, crossings: &[Crossing]) -> IntervalList {
    let mut list = IntervalList::default();
    let mut enter = None;
    for &Crossing { t, error, sense, part, certificate } in crossings {
        let boundary = Boundary { t, error, leaf, part, flipped: false, certificate };
        match sense {
            Sense::Enter => enter = Some(boundary),
            Sense::Leave => list.intervals.push(Interval { enter: enter.take(), leave: Some(boundary) }),
            Sense::Touch => list.touches.push(boundary),
        }
    }
    if enter.is_some() {
        list.intervals.push(Interval { enter, leave: None });
    }
    list
}
