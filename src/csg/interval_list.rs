//! The inside set of a ray: disjoint intervals, each end knowing the surface that it lies on.

use crate::record::{Certificate, Sense};
use crate::shape::Part;
use smallvec::{SmallVec, smallvec};

/// A place where a ray crosses the boundary of a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Boundary {
    /// The hit time.
    pub t: f64,
    /// Bound on its error.
    pub error: f64,
    /// The leaf, counted from 0, left to right.
    pub leaf: usize,
    /// The part of the leaf's surface.
    pub part: Part,
    /// Whether the leaf is subtracted, so that its normal points the other way.
    pub flipped: bool,
    /// How surely it is known to exist.
    pub certificate: Certificate,
}

/// A stretch of the ray inside the solid; a missing end is unbounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Where the ray goes in.
    pub enter: Option<Boundary>,
    /// Where the ray comes out.
    pub leave: Option<Boundary>,
}

/// All inside intervals of one ray, ascending and disjoint, and the touches of surfaces that bound nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct IntervalList {
    /// The inside intervals.
    pub intervals: SmallVec<[Interval; 2]>,
    /// Hits with a square, ascending.
    pub touches: SmallVec<[Boundary; 1]>,
}

/// Boundaries with what they do to the ray. Few rays meet more than four of one object; those go without the allocator.
pub type Boundaries = SmallVec<[(Boundary, Sense); 4]>;

impl IntervalList {
    /// The whole line.
    #[must_use]
    pub fn everything() -> Self {
        Self { intervals: smallvec![Interval { enter: None, leave: None }], touches: SmallVec::new() }
    }

    /// Whether the ray misses.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.intervals.is_empty() && self.touches.is_empty()
    }

    /// Whether the point at `t` is inside.
    #[must_use]
    pub fn contains(&self, t: f64) -> bool {
        self.intervals.iter().any(|interval| {
            interval.enter.is_none_or(|enter| enter.t <= t) && interval.leave.is_none_or(|leave| t <= leave.t)
        })
    }

    /// Every boundary with what it does to the ray, ascending in t.
    #[must_use]
    pub fn boundaries(&self) -> Boundaries {
        let mut all: Boundaries = self.ends().collect();
        if !self.touches.is_empty() {
            all.extend(self.touches.iter().map(|&boundary| (boundary, Sense::Touch)));
            all.sort_by(|(a, _), (b, _)| a.t.total_cmp(&b.t));
        }
        all
    }

    /// The ends of the intervals, ascending in t.
    pub fn ends(&self) -> impl Iterator<Item = (Boundary, Sense)> {
        let both = |i: &Interval| [i.enter.map(|b| (b, Sense::Enter)), i.leave.map(|b| (b, Sense::Leave))];
        self.intervals.iter().flat_map(both).flatten()
    }
}
