//! The gauge of a superellipsoid: g = ((|x|ⁿ + |y|ⁿ)^(m/n) + |z|ᵐ)^(1/m), the norm whose unit ball it is.
//!
//! g grows in proportion to the distance from the origin, however large the exponents, so that g − 1 is tame where F is
//! steep. For exponents of 1 and more it is a norm, and convex; for exponents of 1 and less it is concave within each octant
//! (Minkowski's inequality and its reverse: Hardy, Littlewood, Pólya, Inequalities, § 2.11).

use crate::math::Real;

/// n and m, the exponents of a superellipsoid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Exponents {
    /// The exponent of x and y.
    pub n: f64,
    /// The exponent of z.
    pub m: f64,
}

/// (uᵖ + vᵖ)^(1/p) for u, v ≥ 0, with its partial derivatives.
///
/// The larger one is taken out, so that nothing overflows. The derivatives at (0, 0) are undefined.
pub(super) fn norm<A: Real>(p: f64, u: A, v: A) -> (A, [A; 2]) {
    let (most, least) = (u.max(v), u.min(v));
    let ratio = least / most;
    let power = ratio.powf(A::from_f64(p));
    let sum = A::ONE + power;
    let factor = sum.powf(A::from_f64(1.0) / A::from_f64(p));
    let value = if most > A::ZERO { most * factor } else { A::ZERO };
    let along_most = factor / sum;
    // (least / value)^(p − 1); at least = 0 the limit.
    let along_least = if ratio > A::ZERO {
        along_most * power / ratio
    } else if p < 1.0 {
        A::from_f64(f64::INFINITY)
    } else if p > 1.0 {
        A::ZERO
    } else {
        along_most
    };
    (value, if u >= v { [along_most, along_least] } else { [along_least, along_most] })
}

impl Exponents {
    /// g at a point with no negative coordinate, and its gradient.
    pub fn gauge<A: Real>(&self, [x, y, z]: [A; 3]) -> (A, [A; 3]) {
        let (radius, along) = norm(self.n, x, y);
        let (value, [along_radius, along_z]) = norm(self.m, radius, z);
        (value, [product(along_radius, along[0]), product(along_radius, along[1]), along_z])
    }

    /// Bound on the relative error of g: five roundings, magnified by the roots.
    pub fn rounding<A: Real>(&self) -> f64 {
        16.0 * A::UNIT_ROUNDOFF * (2.0 + 1.0 / self.n + 1.0 / self.m)
    }

    /// Whether g is convex or concave on a whole stretch, if either is known.
    pub fn bend(&self) -> Bend {
        if self.n >= 1.0 && self.m >= 1.0 {
            Bend::Convex
        } else if self.n <= 1.0 && self.m <= 1.0 {
            Bend::Concave
        } else {
            Bend::Unknown
        }
    }
}

/// How g bends along a stretch.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Bend {
    Convex,
    Concave,
    Unknown,
}

/// Zero times infinity is zero: a direction that does not change a coordinate is not moved by it.
pub(super) fn product<A: Real>(a: A, b: A) -> A {
    if a == A::ZERO || b == A::ZERO { A::ZERO } else { a * b }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_norm_of_three_and_four_is_five_and_its_slopes_are_the_cosines() {
        let (value, [along_u, along_v]) = norm(2.0, 3.0_f64, 4.0);
        assert!((value - 5.0).abs() < 1e-14 && (along_u - 0.6).abs() < 1e-15 && (along_v - 0.8).abs() < 1e-15);
    }

    #[test]
    fn nothing_overflows_at_large_exponents() {
        let (value, along) = norm(5000.0, 0.5, 0.25);
        assert_eq!((value, along), (0.5, [1.0, 0.0]));
    }

    #[test]
    fn the_gauge_is_homogeneous() {
        let exponents = Exponents { n: 0.7, m: 3.0 };
        let (once, gradient) = exponents.gauge([0.1, 0.2, 0.3]);
        let (twice, same) = exponents.gauge([0.2, 0.4, 0.6]);
        assert!((twice - 2.0 * once).abs() < 1e-15);
        // Euler: g = x ∂g/∂x + y ∂g/∂y + z ∂g/∂z, and the gradient does not change.
        let sum = 0.1 * gradient[0] + 0.2 * gradient[1] + 0.3 * gradient[2];
        assert!((sum - once).abs() < 1e-15);
        assert!(gradient.iter().zip(same).all(|(a, b)| (a - b).abs() < 1e-15 * a.abs().max(1.0)));
    }
}
