//! From a solver's roots to a primitive's crossings.

use super::{Crossing, Crossings, Part};
use crate::record::{Certificate, Sense};

/// A place where a solver found the surface crossed, in the solver's own parameter.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Root {
    /// τ.
    pub tau: f64,
    /// Bound on its error.
    pub error: f64,
    /// The part of the surface.
    pub part: Part,
}

/// The roots of a solver, ascending, on their way to becoming crossings.
pub(super) trait Boundaries {
    /// Appends them to a primitive's crossings, where `first` is what the first of them does.
    ///
    /// Solvers hand out roots that differ, in their true order. Where two of them fall on the same number, what lies between
    /// is thinner than the last digit of t: a stretch inside is there all the same, a gap is none. So far away that squares overflow nothing is known, and nothing is hit.
    /// Near a tangent the bound on the error grows without limit, but two boundaries that were told apart do not change
    /// places: neither is off by more than half the distance to the other.
    fn append(self, first: Sense, t_per_tau: f64, certificate: Certificate, crossings: &mut Crossings);

    /// The first of these crossings with t > 0.
    fn first_ahead(self, first: Sense, t_per_tau: f64, certificate: Certificate) -> Option<Crossing>
    where
        Self: Sized,
    {
        first_of_all(self, first, t_per_tau, certificate)
    }
}

/// The first crossing with t > 0, out of all of them.
pub(super) fn first_of_all(
    boundaries: impl Boundaries,
    first: Sense,
    t_per_tau: f64,
    certificate: Certificate,
) -> Option<Crossing> {
    let mut crossings = Crossings::new();
    boundaries.append(first, t_per_tau, certificate, &mut crossings);
    crossings.into_iter().find(|crossing| crossing.t > 0.0)
}

/// At most one, of a surface that a line meets once.
impl Boundaries for Option<Root> {
    #[inline]
    fn append(self, first: Sense, t_per_tau: f64, certificate: Certificate, crossings: &mut Crossings) {
        let crossing = self.map(|root| crossing(root, t_per_tau, first, certificate));
        if let Some(crossing) = crossing.filter(|crossing| !crossing.t.is_nan()) {
            crossings.push(crossing);
        }
    }

    #[inline]
    fn first_ahead(self, first: Sense, t_per_tau: f64, certificate: Certificate) -> Option<Crossing> {
        self.map(|root| crossing(root, t_per_tau, first, certificate)).filter(|crossing| crossing.t > 0.0)
    }
}

/// None or two, of a convex solid.
impl Boundaries for Option<[Root; 2]> {
    // Inlined always: roots that go through memory on their way are waited for.
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "measured: a call costs a quarter of what the cube's solver takes")]
    fn append(self, first: Sense, t_per_tau: f64, certificate: Certificate, crossings: &mut Crossings) {
        let ends = self.and_then(|roots| stretch(roots, first, t_per_tau, certificate));
        if let Some([enter, leave]) = ends {
            crossings.push(enter);
            crossings.push(leave);
        }
    }

    #[inline]
    fn first_ahead(self, first: Sense, t_per_tau: f64, certificate: Certificate) -> Option<Crossing> {
        let [enter, leave] = self.and_then(|roots| stretch(roots, first, t_per_tau, certificate))?;
        if enter.t > 0.0 { Some(enter) } else { Some(leave).filter(|leave| leave.t > 0.0) }
    }
}

/// The two ends of a stretch, if they are numbers.
#[inline]
pub(super) fn stretch(
    [near, far]: [Root; 2],
    first: Sense,
    t_per_tau: f64,
    certificate: Certificate,
) -> Option<[Crossing; 2]> {
    let mut enter = crossing(near, t_per_tau, first, certificate);
    let mut leave = crossing(far, t_per_tau, opposite(first), certificate);
    leave.t = if leave.t < enter.t { enter.t } else { leave.t };
    let room = 0.5 * (leave.t - enter.t);
    enter.error = smaller(enter.error, room);
    leave.error = smaller(leave.error, room);
    (enter.t <= leave.t).then_some([enter, leave])
}

/// Appends the two ends of a stretch to the crossings of a solid, which begin at `start`.
#[inline]
pub(super) fn append_stretch(
    roots: [Root; 2],
    start: usize,
    certificate: Certificate,
    t_per_tau: f64,
    crossings: &mut Crossings,
) {
    let Some([mut enter, leave]) = stretch(roots, Sense::Enter, t_per_tau, certificate) else { return };
    if let Some(before) = crossings[start..].last_mut() {
        if enter.t <= before.t {
            // No gap is left between the two stretches.
            *before = Crossing { t: if leave.t < before.t { before.t } else { leave.t }, ..leave };
            return;
        }
        let room = 0.5 * (enter.t - before.t);
        before.error = smaller(before.error, room);
        enter.error = smaller(enter.error, room);
    }
    crossings.push(enter);
    crossings.push(leave);
}

/// A few roots without a heap.
#[derive(Clone, Copy, Debug)]
pub(super) struct Roots<const N: usize> {
    items: [Root; N],
    count: usize,
}

impl<const N: usize> Roots<N> {
    /// None yet.
    pub fn new() -> Self {
        Self { items: [Root::default(); N], count: 0 }
    }

    /// Adds one; more than there is room for are not kept.
    pub fn push(&mut self, root: Root) {
        if let Some(slot) = self.items.get_mut(self.count) {
            *slot = root;
            self.count += 1;
        }
    }
}

impl<const N: usize> AsRef<[Root]> for Roots<N> {
    fn as_ref(&self) -> &[Root] {
        &self.items[..self.count]
    }
}

impl<const N: usize> Boundaries for Roots<N> {
    #[inline]
    fn append(self, first: Sense, t_per_tau: f64, certificate: Certificate, crossings: &mut Crossings) {
        append_alternating(self.as_ref(), first, t_per_tau, certificate, crossings);
    }
}

impl<const N: usize> Boundaries for &Roots<N> {
    fn append(self, first: Sense, t_per_tau: f64, certificate: Certificate, crossings: &mut Crossings) {
        append_alternating(self.as_ref(), first, t_per_tau, certificate, crossings);
    }
}

/// Appends any number of roots.
pub(super) fn append_alternating(
    roots: &[Root],
    first: Sense,
    t_per_tau: f64,
    certificate: Certificate,
    crossings: &mut Crossings,
) {
    let start = crossings.len();
    let (mut sense, mut before) = (first, f64::NEG_INFINITY);
    for root in roots {
        let mut crossing = crossing(*root, t_per_tau, sense, certificate);
        if crossing.t.is_nan() {
            crossings.truncate(start);
            return;
        }
        crossing.t = crossing.t.max(before);
        if crossing.t == before && sense == Sense::Enter {
            crossings.pop();
            before = crossings[start..].last().map_or(f64::NEG_INFINITY, |last| last.t);
        } else {
            let room = 0.5 * (crossing.t - before);
            if let Some(last) = crossings[start..].last_mut() {
                last.error = smaller(last.error, room);
            }
            crossing.error = smaller(crossing.error, room);
            before = crossing.t;
            crossings.push(crossing);
        }
        sense = opposite(sense);
    }
}

/// What the next crossing does.
#[inline]
const fn opposite(sense: Sense) -> Sense {
    match sense {
        Sense::Enter => Sense::Leave,
        Sense::Leave => Sense::Enter,
        Sense::Touch => Sense::Touch,
    }
}

/// The smaller one, `b` where `a` is not a number.
#[inline]
fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// A root as a crossing.
///
/// A hit time too large for a number (the direction is next to nothing) becomes the largest one.
#[inline]
fn crossing(root: Root, t_per_tau: f64, sense: Sense, certificate: Certificate) -> Crossing {
    let t = (root.tau * t_per_tau).clamp(f64::MIN, f64::MAX);
    Crossing { t, error: root.error * t_per_tau, sense, part: root.part, certificate }
}
