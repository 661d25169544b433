//! From a solver's roots to a primitive's crossings.

use super::{Crossing, GenericRay, Part, Primitive};
use crate::math::Real;
use crate::record::Sense;

/// A place where a solver found the surface crossed, in the solver's own parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Root {
    /// τ.
    pub tau: f64,
    /// The part of the surface.
    pub part: Part,
}

/// Appends the crossings of a closed solid, given its roots in ascending order and what the first of them does.
///
/// Roots that fall on the same number in pairs bound nothing that has a length, and are left out. So far away that squares
/// overflow nothing is known, and nothing is hit.
pub(super) fn append_alternating<A: Real>(
    shape: &impl Primitive,
    ray: &GenericRay<A>,
    roots: &[Root],
    first: Sense,
    crossings: &mut Vec<Crossing>,
) {
    if roots.iter().any(|root| root.tau.is_nan()) {
        return;
    }
    let start = crossings.len();
    let mut sense = first;
    for root in roots {
        let crossing = crossing(shape, ray, *root, sense);
        let before = crossings.get(start..).and_then(<[Crossing]>::last);
        if before.is_some_and(|before| before.t >= crossing.t) {
            crossings.pop();
        } else {
            crossings.push(crossing);
        }
        sense = if sense == Sense::Enter { Sense::Leave } else { Sense::Enter };
    }
    cap_errors(&mut crossings[start..]);
}

/// A root as a crossing, with the error that follows from the slope of the surface there.
///
/// A hit time too large for a number (the direction is next to nothing) becomes the largest one.
pub(super) fn crossing<A: Real>(shape: &impl Primitive, ray: &GenericRay<A>, root: Root, sense: Sense) -> Crossing {
    let tau = A::from_f64(root.tau);
    let normal = shape.normal(ray.point(tau), root.part);
    let error = ray.root_error(normal, tau) * ray.t_per_tau;
    Crossing { t: (root.tau * ray.t_per_tau).clamp(f64::MIN, f64::MAX), error, sense, part: root.part }
}

/// Near a tangent the bound grows without limit, but two boundaries that were told apart do not change places: neither
/// is off by more than half the distance to the other.
fn cap_errors(crossings: &mut [Crossing]) {
    for i in 1..crossings.len() {
        let half = 0.5 * (crossings[i].t - crossings[i - 1].t);
        for crossing in &mut crossings[i - 1..=i] {
            crossing.error = crossing.error.min(half);
        }
    }
}
