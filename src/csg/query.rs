//! One ray's way through the Boolean tree of a solid (§ 6.5.3).

use super::combine::{Tie, combine};
use super::placement::PlacedRay;
use super::report;
use super::wide_union::WideUnion;
use super::{Boundary, Course, Enclosure, Extent, IntervalList, Leaf, Node, Solid};
use crate::math::{Alone, DoubleDouble, Precise, Real};
use crate::record::{Counter, NullRecorder, Operator, Recorder, Sense};
use crate::shape::textbook::Exhibit;
use crate::shape::{Crossings, Method, Primitive};
use smallvec::SmallVec;
use std::cell::Cell;

/// One ray's way through the tree.
pub(super) struct Query<'a> {
    solid: &'a Solid,
    course: &'a Course,
    /// The ray is known to meet the box of the whole solid.
    is_met: bool,
    /// Boundaries of two operands that could not be told apart: the first that were met.
    tie: Cell<Option<Tie>>,
    /// The leaves that are asked with 32 digits.
    widened: &'a [usize],
}

impl<'a> Query<'a> {
    pub fn new(solid: &'a Solid, course: &'a Course) -> Self {
        Self { solid, course, is_met: false, tie: Cell::new(None), widened: &[] }
    }

    /// For a ray that is known to meet the box of the whole solid, or not known to.
    pub fn with_box_met(self, is_met: bool) -> Self {
        Self { is_met, ..self }
    }

    /// The same with 32 digits for these leaves.
    fn widening<'b>(&'b self, leaves: &'b [usize]) -> Query<'b> {
        let Self { solid, course, is_met, .. } = *self;
        Query { solid, course, is_met, tie: Cell::new(None), widened: leaves }
    }

    /// The whole tree, in the way that the course says.
    #[inline]
    pub fn as_asked<R: Recorder>(&self, recorder: &mut R) -> IntervalList {
        match self.course.solving.method {
            Method::Adaptive => self.whole::<f64, _>(recorder),
            method => self.by(method, recorder),
        }
    }

    // Out of line: what renders pictures every day is not to grow by what experiments ask for.
    #[inline(never)]
    fn by<R: Recorder>(&self, method: Method, recorder: &mut R) -> IntervalList {
        match method {
            Method::Single => self.whole::<Alone<f32>, _>(recorder),
            Method::Double | Method::Textbook => self.whole::<Alone<f64>, _>(recorder),
            Method::Adaptive => self.whole::<f64, _>(recorder),
            Method::DoubleDouble => self.whole::<DoubleDouble, _>(recorder),
            Method::Exact => self.whole::<Precise, _>(recorder),
        }
    }

    /// The whole tree.
    pub fn whole<A: Real, R: Recorder>(&self, recorder: &mut R) -> IntervalList {
        if A::FINEST || matches!(self.solid.root(), Node::Leaf { .. }) {
            self.node::<A, _>(self.solid.root(), recorder)
        } else {
            self.adaptively::<A, _>(recorder)
        }
    }

    /// The whole tree, in the fast arithmetic where that is enough.
    fn adaptively<A: Real, R: Recorder>(&self, recorder: &mut R) -> IntervalList {
        let first = self.tried::<A, R>(recorder);
        match self.tie.take() {
            None if R::RECORDING => self.node::<A, R>(self.solid.root(), recorder),
            None => first,
            Some(tie) => self.untied::<A, R>(&tie, recorder),
        }
    }

    /// The whole tree. What is told is the way that decided; so it has to be known first which one that is.
    fn tried<A: Real, R: Recorder>(&self, recorder: &mut R) -> IntervalList {
        let root = self.solid.root();
        if R::RECORDING { self.node::<A, _>(root, &mut NullRecorder) } else { self.node::<A, R>(root, recorder) }
    }

    /// The whole tree again, with 32 digits for the leaves whose boundaries could not be told apart, until no others are
    /// left of which that is so.
    #[cold]
    #[inline(never)]
    fn untied<A: Real, R: Recorder>(&self, first: &Tie, recorder: &mut R) -> IntervalList {
        let mut open = first.clone();
        let mut widened: SmallVec<[usize; 4]> = SmallVec::new();
        let (list, last) = loop {
            widened.extend(open.leaves);
            let query = self.widening(&widened);
            let list = query.tried::<A, R>(recorder);
            match query.tie.take() {
                Some(other) if query.is_open(&other) => open = other,
                last => break (list, last),
            }
        };
        if R::RECORDING {
            self.widening(&widened).node::<A, R>(self.solid.root(), recorder);
        }
        recorder.note(|| report::tie::<A>(first, last.as_ref()));
        list
    }

    fn node<A: Real, R: Recorder>(&self, node: &Node, recorder: &mut R) -> IntervalList {
        match node {
            Node::Leaf { leaf, enclosure } => self.leaf::<A, R>(*leaf, enclosure, recorder),
            // What is told is told pair by pair.
            Node::Pair { enclosure, wide: Some(wide), .. } if !R::RECORDING && self.course.hierarchies => {
                self.wide_union::<A, R>(wide, enclosure, recorder)
            }
            Node::Pair { name, operator, left, right, enclosure, .. } => {
                let operands = [*left, *right].map(|index| &self.solid.nodes[index]);
                self.pair::<A, R>(name, *operator, operands, enclosure, recorder)
            }
        }
    }

    /// Both lists and their combination, with the early outs of § 6.5.3.
    fn pair<A: Real, R: Recorder>(
        &self,
        name: &str,
        operator: Operator,
        [left, right]: [&Node; 2],
        enclosure: &Enclosure,
        recorder: &mut R,
    ) -> IntervalList {
        let empty = IntervalList::default();
        let told = |left: &IntervalList, right: Option<&IntervalList>, combined: &IntervalList, out| {
            report::combine(self.solid, name, operator, [Some(left), right, Some(combined)], out)
        };
        recorder.begin();
        if !self.meets(name, enclosure, recorder) {
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
        let result = || combine(operator, &left_list, &right_list, &mut |tie| self.note(tie));
        if !R::RECORDING {
            // Nobody looks at it, so it is built where the caller wants it and not copied there.
            return result();
        }
        let combined = result();
        let lists = [&left_list, &right_list];
        report::rejected(self.solid, name, operator, [left, right], lists, &combined, recorder);
        recorder.end(|| told(&left_list, Some(&right_list), &combined, early_out(operator, &left_list, &right_list)));
        combined
    }

    /// The lists of those operands of a wide union whose boxes the ray meets, combined from the left. The others are empty.
    fn wide_union<A: Real, R: Recorder>(
        &self,
        wide: &WideUnion,
        enclosure: &Enclosure,
        recorder: &mut R,
    ) -> IntervalList {
        if !self.meets("", enclosure, recorder) {
            return IntervalList::default();
        }
        let add = |all: IntervalList, node: usize| {
            let list = self.node::<A, R>(&self.solid.nodes[node], recorder);
            combine(Operator::Union, &all, &list, &mut |tie| self.note(tie))
        };
        wide.reached(self.course).into_iter().fold(IntervalList::default(), add)
    }

    /// Keeps the first tie, or the first one that is open.
    fn note(&self, tie: Tie) {
        let kept = self.tie.take().filter(|kept| self.is_open(kept) || !self.is_open(&tie));
        self.tie.set(Some(kept.unwrap_or(tie)));
    }

    /// Whether more digits may tell boundaries apart that are tied.
    fn is_open(&self, tie: &Tie) -> bool {
        tie.leaves.iter().any(|leaf| !self.widened.contains(leaf))
    }

    fn leaf<A: Real, R: Recorder>(&self, index: usize, enclosure: &Enclosure, recorder: &mut R) -> IntervalList {
        let leaf = &self.solid.leaves[index];
        let list = |recorder: &mut R| {
            if !self.meets(&leaf.name, enclosure, recorder) {
                IntervalList::default()
            } else if !A::FINEST && self.widened.contains(&index) {
                self.widened_primitive(index, leaf, &enclosure.extent, recorder)
            } else {
                self.primitive::<A, R>(index, leaf, &enclosure.extent, recorder)
            }
        };
        recorder.event(list, |list| report::primitive(leaf, index, list))
    }

    /// The same list with 32 digits.
    // Out of line, as are the exhibits: few rays need it, and all would make room for it.
    #[cold]
    #[inline(never)]
    fn widened_primitive<R: Recorder>(
        &self,
        index: usize,
        leaf: &Leaf,
        extent: &Extent,
        recorder: &mut R,
    ) -> IntervalList {
        self.primitive::<DoubleDouble, R>(index, leaf, extent, recorder)
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
        let ray = leaf.placement.generic_ray::<A>(&self.course.line);
        let is_measuring = recorder.is_measuring();
        recorder.note(|| report::transform(leaf, self.course.line, ray.shown(is_measuring)));
        let mut crossings = Crossings::new();
        if let Some(exhibit) = self.course.solving.exhibit(&leaf.shape) {
            self.exhibited(exhibit, leaf, recorder, &mut crossings);
        } else if R::RECORDING {
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

    /// The crossings by one of the textbook's solvers.
    #[cold]
    #[inline(never)]
    fn exhibited(&self, exhibit: Exhibit, leaf: &Leaf, recorder: &mut impl Recorder, crossings: &mut Crossings) {
        exhibit.crossings(&leaf.shape, &leaf.placement.generic_ray(&self.course.line), recorder, crossings);
    }

    /// The first crossing of a primitive with t > 0: what is first in its interval list too.
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "measured with `first_in_front`")]
    pub fn first_crossing(
        &self,
        index: usize,
        enclosure: &Enclosure,
        recorder: &mut impl Recorder,
    ) -> Option<(Boundary, Sense)> {
        let leaf = &self.solid.leaves[index];
        if !self.meets(&leaf.name, enclosure, recorder) {
            return None;
        }
        recorder.count(Counter::ShapeTest(leaf.shape.index()));
        let approach = PlacedRay { placement: &leaf.placement, line: &self.course.line };
        let first = self.course.solving.first_crossing(&leaf.shape, &approach)?;
        Some((Boundary::of_crossing(index, &first), first.sense))
    }

    /// Whether the ray may meet what a node's enclosure holds.
    fn meets(&self, name: &str, enclosure: &Enclosure, recorder: &mut impl Recorder) -> bool {
        let is_root = self.is_met && std::ptr::eq(enclosure, self.solid.enclosure());
        (is_root || self.meets_box(name, &enclosure.extent, recorder)) && self.meets_ball(name, enclosure, recorder)
    }

    fn meets_box(&self, name: &str, extent: &Extent, recorder: &mut impl Recorder) -> bool {
        if !self.course.boxes || extent.is_unbounded() {
            return true;
        }
        let inside = extent.inside(self.course);
        count(inside.is_some(), recorder);
        recorder.note(|| report::extent(name, extent, inside));
        inside.is_some()
    }

    fn meets_ball(
        &self,
        name: &str,
        Enclosure { ball, asks_ball, .. }: &Enclosure,
        recorder: &mut impl Recorder,
    ) -> bool {
        if !self.course.balls || !asks_ball {
            return true;
        }
        let is_met = !ball.is_missed(self.course);
        count(is_met, recorder);
        recorder.note(|| report::ball(name, ball, self.course, is_met));
        is_met
    }
}

/// Counts the test of an extent.
fn count(is_met: bool, recorder: &mut impl Recorder) {
    recorder.count(Counter::ExtentTest);
    if !is_met {
        recorder.count(Counter::ExtentMiss);
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
