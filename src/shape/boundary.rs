//! From a solver's roots to a primitive's crossings.

use super::{Crossing, Part};
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

/// A few roots, ascending, without a heap.
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

impl Roots<1> {
    /// The only one, or none.
    pub fn one(root: Option<Root>) -> Self {
        match root {
            Some(root) => Self { items: [root], count: 1 },
            None => Self::new(),
        }
    }
}

impl Roots<2> {
    /// Both, or none.
    #[inline]
    pub fn pair(ends: Option<[Root; 2]>) -> Self {
        match ends {
            Some(items) => Self { items, count: 2 },
            None => Self::new(),
        }
    }
}

impl<const N: usize> AsRef<[Root]> for Roots<N> {
    fn as_ref(&self) -> &[Root] {
        &self.items[..self.count]
    }
}

/// Appends the crossings of a primitive, given its roots in ascending order and what the first of them does.
///
/// Roots that fall on the same number in pairs bound nothing that has a length, and are left out. So far away that squares
/// overflow nothing is known, and nothing is hit.
#[inline]
pub(super) fn append_alternating(
    roots: &[Root],
    first: Sense,
    t_per_tau: f64,
    certificate: Certificate,
    crossings: &mut Vec<Crossing>,
) {
    if roots.iter().any(|root| root.tau.is_nan()) {
        return;
    }
    let start = crossings.len();
    let mut sense = first;
    for root in roots {
        let crossing = crossing(*root, t_per_tau, sense, certificate);
        let before = crossings.get(start..).and_then(<[Crossing]>::last);
        if before.is_some_and(|before| before.t >= crossing.t) {
            crossings.pop();
        } else {
            crossings.push(crossing);
        }
        sense = match sense {
            Sense::Enter => Sense::Leave,
            Sense::Leave => Sense::Enter,
            Sense::Touch => Sense::Touch,
        };
    }
    cap_errors(&mut crossings[start..]);
}

/// A root as a crossing.
///
/// A hit time too large for a number (the direction is next to nothing) becomes the largest one.
#[inline]
pub(super) fn crossing(root: Root, t_per_tau: f64, sense: Sense, certificate: Certificate) -> Crossing {
    Crossing {
        t: (root.tau * t_per_tau).clamp(f64::MIN, f64::MAX),
        error: root.error * t_per_tau,
        sense,
        part: root.part,
        certificate,
    }
}

/// Near a tangent the bound grows without limit, but two boundaries that were told apart do not change places: neither
/// is off by more than half the distance to the other.
#[inline]
fn cap_errors(crossings: &mut [Crossing]) {
    for i in 1..crossings.len() {
        let half = 0.5 * (crossings[i].t - crossings[i - 1].t);
        for crossing in &mut crossings[i - 1..=i] {
            crossing.error = crossing.error.min(half);
        }
    }
}
