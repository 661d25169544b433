//! The inside set of a ray: disjoint intervals, each end knowing the surface that it lies on.

use crate::record::{Certificate, Sense};
use crate::shape::{Crossing, Part};
use smallvec::SmallVec;

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

/// All inside intervals of one ray, ascending and disjoint, or the touches of a surface that bounds nothing.
///
/// Only the ends are kept: they lead in and out by turns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct IntervalList {
    ends: SmallVec<[Boundary; 4]>,
    /// Whether the ray begins, infinitely far back, inside.
    starts_inside: bool,
    /// The ends are touches.
    touches: bool,
}

/// Boundaries with what they do to the ray. Few rays meet more than four of one object; those go without the allocator.
pub type Boundaries = SmallVec<[(Boundary, Sense); 4]>;

impl IntervalList {
    /// A ray that is inside from the beginning, or not, before its first boundary.
    #[must_use]
    pub fn starting(inside: bool) -> Self {
        Self { ends: SmallVec::new(), starts_inside: inside, touches: false }
    }

    /// The crossings of one primitive, in order.
    #[must_use]
    #[inline]
    pub fn of_crossings(leaf: usize, crossings: &[Crossing]) -> Self {
        let mut ends = SmallVec::new();
        for crossing in crossings {
            ends.push(Boundary::of_crossing(leaf, crossing));
        }
        let first = crossings.first().map(|crossing| crossing.sense);
        Self { ends, starts_inside: first == Some(Sense::Leave), touches: first == Some(Sense::Touch) }
    }

    /// Adds the next boundary, behind all others, unless the ray comes in again where it went out: a gap without length is
    /// none.
    #[inline]
    pub(super) fn push(&mut self, boundary: Boundary, enters: bool) {
        match self.ends.last() {
            Some(last) if enters && last.t == boundary.t => drop(self.ends.pop()),
            _ => self.ends.push(boundary),
        }
    }

    /// Whether the ray misses.
    #[must_use]
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty() && !self.starts_inside
    }

    /// Whether the ray begins, infinitely far back, inside.
    #[must_use]
    #[inline]
    pub const fn starts_inside(&self) -> bool {
        self.starts_inside
    }

    /// The boundaries of the inside set, ascending; none for touches, which bound nothing.
    #[must_use]
    #[inline]
    pub fn ends(&self) -> &[Boundary] {
        if self.touches { &[] } else { &self.ends }
    }

    /// The inside intervals, ascending.
    #[must_use]
    pub fn intervals(&self) -> impl ExactSizeIterator<Item = Interval> {
        let ends = self.ends();
        // Where the ray begins inside, the first interval has no beginning.
        let shift = usize::from(self.starts_inside);
        let end = move |place: Option<usize>| place.and_then(|place| ends.get(place)).copied();
        (0..(ends.len() + shift).div_ceil(2)).map(move |k| Interval {
            enter: end((2 * k).checked_sub(shift)),
            leave: end((2 * k + 1).checked_sub(shift)),
        })
    }

    /// Whether the point at `t` is inside.
    #[must_use]
    pub fn contains(&self, t: f64) -> bool {
        self.intervals().any(|interval| {
            interval.enter.is_none_or(|enter| enter.t <= t) && interval.leave.is_none_or(|leave| t <= leave.t)
        })
    }

    /// The places where the ray crosses or touches the surface, ascending.
    #[must_use]
    #[inline]
    pub fn crossed(&self) -> &[Boundary] {
        &self.ends
    }

    /// Every boundary with what it does to the ray, ascending in t.
    #[must_use]
    pub fn boundaries(&self) -> Boundaries {
        (0..).zip(&self.ends).map(|(k, boundary)| (*boundary, self.sense(k))).collect()
    }

    /// The first boundary, with what it does to the ray.
    #[must_use]
    pub fn first(&self) -> Option<(Boundary, Sense)> {
        self.ends.first().map(|boundary| (*boundary, self.sense(0)))
    }

    /// The first boundary with t > 0, with what it does to the ray.
    #[must_use]
    pub fn first_in_front(&self) -> Option<(Boundary, Sense)> {
        let k = self.ends.iter().position(|boundary| boundary.t > 0.0)?;
        Some((self.ends[k], self.sense(k)))
    }

    /// The same ray from behind its first `count` boundaries on.
    #[must_use]
    pub fn after(&self, count: usize) -> Self {
        let starts_inside = !self.touches && self.starts_inside != (count % 2 == 1);
        Self { ends: SmallVec::from_slice(&self.ends[count..]), starts_inside, touches: self.touches }
    }

    /// The same ray from t = 0 on.
    #[must_use]
    pub fn in_front(&self) -> Self {
        self.after(self.ends.iter().take_while(|boundary| boundary.t <= 0.0).count())
    }

    /// Puts a boundary before all others: the ray begins on its other side.
    pub fn begin_with(&mut self, boundary: Boundary) {
        self.ends.insert(0, boundary);
        self.starts_inside = !self.touches && !self.starts_inside;
    }

    /// What the ray does at a boundary, counted from 0.
    #[must_use]
    #[inline]
    pub const fn sense(&self, k: usize) -> Sense {
        match (self.touches, self.starts_inside == (k % 2 == 1)) {
            (true, _) => Sense::Touch,
            (false, true) => Sense::Enter,
            (false, false) => Sense::Leave,
        }
    }
}

impl Boundary {
    /// A leaf's crossing as a boundary of the solid.
    #[must_use]
    #[inline]
    pub const fn of_crossing(leaf: usize, crossing: &Crossing) -> Self {
        let Crossing { t, error, part, certificate, .. } = *crossing;
        Self { t, error, leaf, part, flipped: false, certificate }
    }
}
