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
/// overflow nothing is known, and nothing is hit. Near a tangent the bound on the error grows without limit, but two
/// boundaries that were told apart do not change places: neither is off by more than half the distance to the other. A hit
/// time too large for a number (the direction is next to nothing) becomes the largest one.
#[inline]
pub(super) fn append_alternating(
    roots: &[Root],
    first: Sense,
    t_per_tau: f64,
    certificate: Certificate,
    crossings: &mut Vec<Crossing>,
) {
    let start = crossings.len();
    let (mut sense, mut before) = (first, f64::NEG_INFINITY);
    for root in roots {
        let t = (root.tau * t_per_tau).clamp(f64::MIN, f64::MAX);
        if t > before {
            let room = 0.5 * (t - before);
            if let Some(last) = crossings[start..].last_mut() {
                last.error = last.error.min(room);
            }
            let error = (root.error * t_per_tau).min(room);
            crossings.push(Crossing { t, error, sense, part: root.part, certificate });
            before = t;
        } else if t.is_nan() {
            crossings.truncate(start);
            return;
        } else {
            crossings.pop();
            before = crossings[start..].last().map_or(f64::NEG_INFINITY, |last| last.t);
        }
        sense = match sense {
            Sense::Enter => Sense::Leave,
            Sense::Leave => Sense::Enter,
            Sense::Touch => Sense::Touch,
        };
    }
}
