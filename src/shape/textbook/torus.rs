//! The torus: (α t² + 2 β t + γ)² − 4 d² ((S_x + c_x t)² + (S_y + c_y t)²) = 0 with α = c·c, β = S·c, γ = S·S + d² − 1, as a
//! quartic in t, solved by Ferrari's method, with two steps of Newton's for each root.
//!
//! **Where it fails** From afar: the coefficients grow with the fourth power of the distance and what tells a hit from a
//! miss is what is left when they cancel; from 10⁴ sizes away most answers are wrong. Newton's steps sharpen the roots that
//! were found, and bring no lost one back. Near tangents the 10⁻⁹ of `ferrari.rs` decides. And for d < 1, where the tube
//! overlaps itself, it counts the surface within the overlap as a boundary.
//!
//! **Source** F. S. Hill, Computer Graphics Using OpenGL, 2nd ed., § 14.7; J. Schwarze, "Cubic and quartic roots", Graphics Gems
//! (1990), for the solver.

use super::append_alternating;
use super::ferrari::quartic_roots;
use crate::math::dot;
use crate::shape::{Crossings, GenericRay};

/// Wrong from afar, near tangents, and in the overlap of a spindle.
pub fn crossings(d: f64, ray: &GenericRay<f64>, crossings: &mut Crossings) {
    let coefficients = quartic(d, ray);
    let roots = quartic_roots(coefficients);
    let mut hits = roots.items.map(|tau| (tau, 0));
    let hits = &mut hits[..roots.count];
    for (tau, _) in hits.iter_mut() {
        *tau = newton(coefficients, newton(coefficients, *tau));
    }
    append_alternating(ray, hits, crossings);
}

/// The coefficients, from that of t⁰ to that of t⁴.
fn quartic(d: f64, ray: &GenericRay<f64>) -> [f64; 5] {
    let (s, c) = (ray.origin, ray.direction);
    let (alpha, beta, gamma) = (dot(c, c), dot(s, c), dot(s, s) + d * d - 1.0);
    let around = [s[0] * s[0] + s[1] * s[1], 2.0 * (s[0] * c[0] + s[1] * c[1]), c[0] * c[0] + c[1] * c[1]];
    let four = 4.0 * d * d;
    [
        gamma * gamma - four * around[0],
        4.0 * beta * gamma - four * around[1],
        4.0 * beta * beta + 2.0 * alpha * gamma - four * around[2],
        4.0 * alpha * beta,
        alpha * alpha,
    ]
}

/// One step of Newton's method.
fn newton([c0, c1, c2, c3, c4]: [f64; 5], t: f64) -> f64 {
    let value = (((c4 * t + c3) * t + c2) * t + c1) * t + c0;
    let slope = ((4.0 * c4 * t + 3.0 * c3) * t + 2.0 * c2) * t + c1;
    if slope == 0.0 { t } else { t - value / slope }
}
