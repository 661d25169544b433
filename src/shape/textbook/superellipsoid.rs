//! The superellipsoid: d(t) = F(S + c t) sampled at equal steps where the ray is in the box from −1 to 1, and each change of
//! sign closed in on by halving.
//!
//! **Where it fails** A chord that lies between two samples is never seen, nor are two of four roots that do: that is every ray
//! that grazes, and many at hollow shapes (exponents below 1). More steps only move the limit. For large exponents F
//! overflows far from the surface, which does no harm; near an edge of a nearly square shape it jumps from −1 to huge
//! values, and the root is as good as t's last digits.
//!
//! **Source** The search of any numerical textbook, such as W. H. Press et al., Numerical Recipes, 3rd ed., § 9.1.

use super::append_alternating;
use crate::math::portable;
use crate::shape::gauge::Exponents;
use crate::shape::{Crossings, GenericRay, Part};
use smallvec::SmallVec;

/// Halvings of a stretch: enough for every digit of a number of the size of the box.
const HALVINGS: u8 = 54;

/// Wrong wherever the ray is inside for less than one step.
pub fn crossings(exponents: Exponents, stretches: u32, ray: &GenericRay<f64>, crossings: &mut Crossings) {
    let Some([from, to]) = in_box(ray) else { return };
    let step = (to - from) / f64::from(stretches);
    let d = |tau: f64| implicit(exponents, ray.at(tau));
    let mut hits: SmallVec<[(f64, Part); 4]> = SmallVec::new();
    let (mut before, mut inside) = (from, false);
    for k in 1..=stretches {
        let tau = from + step * f64::from(k);
        // At its far end the ray leaves the box, and the solid at the latest there.
        let now_inside = k < stretches && d(tau) < 0.0;
        if now_inside != inside {
            hits.push((halve(before, tau, inside, d), 0));
        }
        (before, inside) = (tau, now_inside);
    }
    append_alternating(ray, &mut hits, crossings);
}

/// F = (|x|ⁿ + |y|ⁿ)^(m/n) + |z|ᵐ − 1.
fn implicit(Exponents { n, m, .. }: Exponents, [x, y, z]: [f64; 3]) -> f64 {
    portable::powf(portable::powf(x.abs(), n) + portable::powf(y.abs(), n), m / n) + portable::powf(z.abs(), m) - 1.0
}

/// Where the sign of d changes between two places.
fn halve(mut low: f64, mut high: f64, inside_at_low: bool, d: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        if (d(middle) < 0.0) == inside_at_low {
            low = middle;
        } else {
            high = middle;
        }
    }
    f64::midpoint(low, high)
}

/// The stretch of the ray in the box from −1 to 1.
fn in_box(ray: &GenericRay<f64>) -> Option<[f64; 2]> {
    let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
    for (start, speed) in ray.origin.into_iter().zip(ray.direction) {
        if speed == 0.0 {
            if start.abs() > 1.0 {
                return None;
            }
            continue;
        }
        let (a, b) = ((-1.0 - start) / speed, (1.0 - start) / speed);
        from = from.max(a.min(b));
        to = to.min(a.max(b));
    }
    (from < to).then_some([from, to])
}
