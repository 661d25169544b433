//! Real roots of quartics by Ferrari's method and of cubics by Cardano's, with fixed tolerances.
//!
//! **Where it fails** Whatever is smaller than 10⁻⁹ counts as zero, whether the coefficients are of the order of 1 or of 10¹².
//! So pairs of roots that are close together merge, and where cancellation leaves −10⁻⁸ in place of 0 all roots are lost.
//!
//! **Source** J. Schwarze, "Cubic and quartic roots", Graphics Gems (1990), pp. 404–407 and the program on pp. 738–740.

use crate::math::portable;
use std::f64::consts::FRAC_PI_3;

/// What counts as zero.
const EPSILON: f64 = 1e-9;

/// A few roots, in no order.
#[derive(Clone, Copy, Default)]
pub struct Found {
    /// The roots, `count` of them.
    pub items: [f64; 4],
    /// How many there are.
    pub count: usize,
}

impl Found {
    fn push(&mut self, root: f64) {
        if let Some(slot) = self.items.get_mut(self.count) {
            *slot = root;
            self.count += 1;
        }
    }

    fn moved(mut self, by: f64) -> Self {
        self.items[..self.count].iter_mut().for_each(|root| *root += by);
        self
    }
}

fn is_zero(x: f64) -> bool {
    x.abs() < EPSILON
}

/// Real roots of c₀ + c₁ t + c₂ t² + c₃ t³ + c₄ t⁴, double ones once.
pub fn quartic_roots(c: [f64; 5]) -> Found {
    // t⁴ + a t³ + b t² + …, and with t = y − a/4 the depressed y⁴ + p y² + q y + r.
    let [d, c, b, a] = [c[0] / c[4], c[1] / c[4], c[2] / c[4], c[3] / c[4]];
    let square = a * a;
    let p = -3.0 / 8.0 * square + b;
    let q = square * a / 8.0 - a * b / 2.0 + c;
    let r = -3.0 / 256.0 * square * square + square * b / 16.0 - a * c / 4.0 + d;
    depressed_quartic_roots(p, q, r).moved(-a / 4.0)
}

fn depressed_quartic_roots(p: f64, q: f64, r: f64) -> Found {
    if is_zero(r) {
        let mut roots = cubic_roots([q, p, 0.0]);
        roots.push(0.0);
        return roots;
    }
    // One root of the resolvent cubic splits the quartic into two quadratics.
    let z = cubic_roots([r * p / 2.0 - q * q / 8.0, -r, -p / 2.0]).items[0];
    let (Some(u), Some(v)) = (clamped_root(z * z - r), clamped_root(2.0 * z - p)) else { return Found::default() };
    let v = if q < 0.0 { -v } else { v };
    let mut roots = Found::default();
    push_quadratic_roots(v, z - u, &mut roots);
    push_quadratic_roots(-v, z + u, &mut roots);
    roots
}

/// √x, where what is within 10⁻⁹ of zero is zero; none below.
fn clamped_root(x: f64) -> Option<f64> {
    if is_zero(x) { Some(0.0) } else { (x > 0.0).then(|| x.sqrt()) }
}

/// Roots of c₀ + c₁ t + c₂ t² + t³; the first one always exists.
fn cubic_roots([c, b, a]: [f64; 3]) -> Found {
    let square = a * a;
    let p = (-square / 3.0 + b) / 3.0;
    let q = 0.5 * (2.0 / 27.0 * a * square - a * b / 3.0 + c);
    let cube = p * p * p;
    let discriminant = q * q + cube;
    let mut roots = Found::default();
    if is_zero(discriminant) {
        if is_zero(q) {
            roots.push(0.0);
        } else {
            let u = portable::cbrt(-q);
            roots.push(2.0 * u);
            roots.push(-u);
        }
    } else if discriminant < 0.0 {
        let angle = portable::acos(-q / (-cube).sqrt()) / 3.0;
        let size = 2.0 * (-p).sqrt();
        roots.push(size * portable::cos(angle));
        roots.push(-size * portable::cos(angle + FRAC_PI_3));
        roots.push(-size * portable::cos(angle - FRAC_PI_3));
    } else {
        let root = discriminant.sqrt();
        roots.push(portable::cbrt(root - q) - portable::cbrt(root + q));
    }
    roots.moved(-a / 3.0)
}

/// Roots of c₀ + c₁ t + t².
fn push_quadratic_roots(c1: f64, c0: f64, roots: &mut Found) {
    let p = c1 / 2.0;
    let discriminant = p * p - c0;
    if is_zero(discriminant) {
        roots.push(-p);
    } else if discriminant > 0.0 {
        let root = discriminant.sqrt();
        roots.push(root - p);
        roots.push(-root - p);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sorted(c: [f64; 5]) -> Vec<f64> {
        let found = quartic_roots(c);
        let mut roots = found.items[..found.count].to_vec();
        roots.sort_by(f64::total_cmp);
        roots
    }

    #[test]
    fn four_whole_roots_are_found() {
        // (t − 1)(t − 2)(t − 3)(t − 4)
        let roots = sorted([24.0, -50.0, 35.0, -10.0, 1.0]);
        assert_eq!(roots.len(), 4);
        for (root, whole) in roots.iter().zip([1.0, 2.0, 3.0, 4.0]) {
            assert!((root - whole).abs() < 1e-12, "{roots:?}");
        }
    }

    #[test]
    fn a_quartic_without_real_roots_has_none() {
        // (t² + 1)(t² + 4)
        assert_eq!(sorted([4.0, 0.0, 5.0, 0.0, 1.0]), [] as [f64; 0]);
    }

    #[test]
    fn two_roots_that_are_close_are_taken_for_one() {
        // (t² − h²)(t² + 1) with h = 10⁻⁵ has the roots ±h; y⁴ + (1 − h²) y² − h², whose r is below 10⁻⁹.
        let h = 1e-5;
        assert_eq!(sorted([-h * h, 0.0, 1.0 - h * h, 0.0, 1.0]).len(), 2, "0 twice over");
        assert!(sorted([-h * h, 0.0, 1.0 - h * h, 0.0, 1.0]).iter().all(|root| *root == 0.0));
    }
}
