//! The gauge of a superellipsoid: g = ((|x|ⁿ + |y|ⁿ)^(m/n) + |z|ᵐ)^(1/m), the norm whose unit ball it is.
//!
//! g grows in proportion to the distance from the origin, however large the exponents, so that g − 1 is tame where F is
//! steep. For exponents of 1 and more it is a norm, and convex; for exponents of 1 and less it is concave within each octant
//! (Minkowski's inequality and its reverse: Hardy, Littlewood, Pólya, Inequalities, § 2.11).
//!
//! Powers cost more than all else here. Those with small whole or half exponents are products and square roots.

use crate::math::{Real, ln, portable};

/// How x^p is worked out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Power {
    /// p = k / 2, by products and a square root.
    Halves(u32),
    /// p as a quotient, and rounded.
    Any { over: f64, under: f64, rounded: f64 },
}

impl Power {
    /// Larger ones have more roundings than a power by logarithms.
    const MOST_HALVES: f64 = 48.0;

    pub fn new(over: f64, under: f64) -> Self {
        let rounded = over / under;
        let halves = 2.0 * rounded;
        if (1.0..=Self::MOST_HALVES).contains(&halves) && halves.fract() == 0.0 && halves * under == 2.0 * over {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a whole number from 1 to 48"
            )]
            return Self::Halves(halves as u32);
        }
        Self::Any { over, under, rounded }
    }

    /// x^p for x ≥ 0. In f64 its error is at most u (1 + p + 2 |ln x^p|) x^p.
    #[inline]
    pub fn of<A: Real>(self, x: A) -> A {
        match self {
            Self::Halves(1) => x.sqrt(),
            Self::Halves(2) => x,
            Self::Halves(4) => x * x,
            Self::Halves(k) => halves(x, k),
            Self::Any { rounded, .. } if A::UNIT_ROUNDOFF >= f64::UNIT_ROUNDOFF => x.power(A::from_f64(rounded)),
            Self::Any { over, under, .. } => x.power(A::from_f64(over) / A::from_f64(under)),
        }
    }
}

/// x^(k/2) by squaring.
#[inline]
fn halves<A: Real>(x: A, k: u32) -> A {
    let mut result = if k % 2 == 1 { x.sqrt() } else { A::ONE };
    let (mut square, mut rest) = (x, k / 2);
    loop {
        if rest % 2 == 1 {
            result = result * square;
        }
        rest /= 2;
        if rest == 0 {
            return result;
        }
        square = square * square;
    }
}

/// n and m, the exponents of a superellipsoid, with how their powers are worked out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Exponents {
    /// The exponent of x and y.
    pub n: f64,
    /// The exponent of z.
    pub m: f64,
    across: Power,
    up: Power,
    /// m / n, which takes |x|ⁿ + |y|ⁿ to the power of m.
    rise: Power,
    /// 1 / n.
    root: Power,
    /// 1 / m.
    last: Power,
    /// Whether |x|ⁿ may vanish where |x|ᵐ does not.
    vanishes: bool,
}

/// F = T − 1 at a point, where T = (|x|ⁿ + |y|ⁿ)^(m/n) + |z|ᵐ = gᵐ.
#[derive(Clone, Copy, Debug)]
pub(super) struct Level<A> {
    /// F, which has the sign of g − 1.
    pub excess: A,
    /// ln g.
    pub log: f64,
    /// The shares of x, y and z in g: share i is xᵢ/g ∂g/∂xᵢ, and together they are 1.
    pub shares: [f64; 3],
}

impl Exponents {
    pub fn new(n: f64, m: f64) -> Self {
        Self {
            n,
            m,
            across: Power::new(n, 1.0),
            up: Power::new(m, 1.0),
            rise: Power::new(m, n),
            root: Power::new(1.0, n),
            last: Power::new(1.0, m),
            // Where |x|ⁿ < 1e-308, |x|ᵐ < 1e-18 all the same.
            vanishes: n > 17.0 * m,
        }
    }

    /// F at a point with no negative coordinate, and who has which share in it.
    #[inline]
    pub fn level<A: Real>(&self, [x, y, z]: [A; 3]) -> Level<A> {
        let up = self.up.of(z);
        let ([first, second], radius) = self.radius_power(x, y);
        // The larger term less 1 is exact where it matters.
        let excess = if up > radius { (up - A::ONE) + radius } else { (radius - A::ONE) + up };
        let (first, second, radius, up) = (first.to_f64(), second.to_f64(), radius.to_f64(), up.to_f64());
        let both = first + second;
        let total = radius + up;
        let log = self.logarithm(excess.to_f64(), total);
        let per_total = if total > 0.0 { 1.0 / total } else { 0.0 };
        let across = if radius.is_finite() { radius * per_total } else { 1.0 };
        let each = if both > 0.0 { across / both } else { 0.0 };
        Level { excess, log, shares: [first * each, second * each, up * per_total] }
    }

    /// |x|ⁿ and |y|ⁿ or numbers in proportion to them, and (|x|ⁿ + |y|ⁿ)^(m/n).
    #[inline]
    fn radius_power<A: Real>(&self, x: A, y: A) -> ([A; 2], A) {
        if self.vanishes {
            let most = x.max(y);
            let (terms, sum) = self.in_proportion(x, y, most);
            return (terms, self.up.of(most * self.root.of(sum)));
        }
        let terms = [self.across.of(x), self.across.of(y)];
        (terms, self.rise.of(terms[0] + terms[1]))
    }

    /// (x / most)ⁿ and (y / most)ⁿ, and their sum.
    fn in_proportion<A: Real>(&self, x: A, y: A, most: A) -> ([A; 2], A) {
        if most == A::ZERO {
            return ([A::ZERO; 2], A::ZERO);
        }
        let terms = [x, y].map(|x| if x == most { A::ONE } else { self.across.of(x / most) });
        (terms, terms[0] + terms[1])
    }

    /// ρ = (|x|ⁿ + |y|ⁿ)^(1/n) at a point with no negative coordinate, and the shares of x and y in it.
    #[inline]
    pub fn radius<A: Real>(&self, x: A, y: A) -> (A, [f64; 2]) {
        let (terms, radius) = if self.n > 1.0 {
            let most = x.max(y);
            let (terms, sum) = self.in_proportion(x, y, most);
            (terms, most * self.root.of(sum))
        } else {
            let terms = [self.across.of(x), self.across.of(y)];
            (terms, self.root.of(terms[0] + terms[1]))
        };
        let [first, second] = terms.map(Real::to_f64);
        let both = first + second;
        (radius, if both > 0.0 { [first / both, second / both] } else { [0.0; 2] })
    }

    /// σ = (1 − |z|ᵐ)^(1/m), the radius of the solid at the height z ≥ 0, and |z|ᵐ / (1 − |z|ᵐ).
    #[inline]
    pub fn section<A: Real>(&self, z: A) -> (A, f64) {
        let up = self.up.of(z);
        let rest = (A::ONE - up).max(A::ZERO);
        (self.last.of(rest), up.to_f64() / rest.to_f64())
    }

    /// ln g from F and F + 1, of which the former has the digits near the surface and the latter inside.
    #[inline]
    fn logarithm(&self, excess: f64, total: f64) -> f64 {
        let log = if excess.abs() < 1e-4 {
            excess * (1.0 - excess * (0.5 - excess * (1.0 / 3.0 - 0.25 * excess)))
        } else {
            ln(total.clamp(f64::MIN_POSITIVE, f64::MAX))
        };
        log / self.m
    }

    /// Bound on the rounding error of ln g near the surface, in units of u: each power loses a few roundings, and the
    /// roots magnify them.
    pub fn roundings(&self) -> f64 {
        6.0 * (1.0 + 1.0 / self.n + 1.0 / self.m)
    }

    /// Whether the steps to a root are so good that the first one gets next to it.
    pub fn is_smooth(&self) -> bool {
        self.n == 2.0 && self.m == 2.0
    }

    /// How g bends.
    pub fn bend(&self) -> Bend {
        if self.n >= 1.0 && self.m >= 1.0 {
            Bend::Convex
        } else if self.n <= 1.0 && self.m <= 1.0 {
            Bend::Concave
        } else {
            Bend::Mixed
        }
    }

    /// The exponent of a coordinate.
    pub fn of_axis(&self, axis: usize) -> f64 {
        if axis == 2 { self.m } else { self.n }
    }

    /// g at a point with no negative coordinate, and its gradient.
    pub fn gauge(&self, [x, y, z]: [f64; 3]) -> (f64, [f64; 3]) {
        let (radius, along) = norm(self.n, x, y);
        let (value, [along_radius, along_z]) = norm(self.m, radius, z);
        (value, [product(along_radius, along[0]), product(along_radius, along[1]), along_z])
    }
}

/// (uᵖ + vᵖ)^(1/p) for u, v ≥ 0, with its partial derivatives.
///
/// The larger one is taken out, so that nothing overflows. The derivatives at (0, 0) are undefined.
fn norm(p: f64, u: f64, v: f64) -> (f64, [f64; 2]) {
    let (most, least) = (u.max(v), u.min(v));
    let ratio = least / most;
    let power = portable::powf(ratio, p);
    let sum = 1.0 + power;
    let factor = portable::powf(sum, 1.0 / p);
    let value = if most > 0.0 { most * factor } else { 0.0 };
    let along_most = factor / sum;
    // (least / value)^(p − 1); at least = 0 the limit.
    let along_least = if ratio > 0.0 {
        along_most * power / ratio
    } else if p < 1.0 {
        f64::INFINITY
    } else if p > 1.0 {
        0.0
    } else {
        along_most
    };
    (value, if u >= v { [along_most, along_least] } else { [along_least, along_most] })
}

/// How g bends along a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Bend {
    /// Upwards everywhere.
    Convex,
    /// Downwards between the coordinate planes.
    Concave,
    /// Neither.
    Mixed,
}

/// Zero times infinity is zero: a direction that does not change a coordinate is not moved by it.
fn product(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { a * b }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DoubleDouble;

    #[test]
    fn the_norm_of_three_and_four_is_five_and_its_slopes_are_the_cosines() {
        let (value, [along_u, along_v]) = norm(2.0, 3.0_f64, 4.0);
        assert!((value - 5.0).abs() < 1e-14 && (along_u - 0.6).abs() < 1e-15 && (along_v - 0.8).abs() < 1e-15);
    }

    #[test]
    fn nothing_overflows_at_large_exponents() {
        let (value, along) = norm(5000.0, 0.5, 0.25);
        assert_eq!((value, along), (0.5, [1.0, 0.0]));
        // (0.5^1000 + 0.25^1000)^(1/1000) + 0.5 is a bit more than 1, though 0.5^1000 and 0.25^1000 are nothing.
        let level = Exponents::new(1e4, 1.0).level([0.5, 0.25, 0.5]);
        assert!(level.excess.abs() < 1e-15 && level.shares == [0.5, 0.0, 0.5], "{level:?}");
        let level = Exponents::new(0.05, 1000.0).level([0.9, 0.9, 0.5]);
        assert!(level.excess > 1.0 && level.shares == [0.5, 0.5, 0.0], "{level:?}");
    }

    #[test]
    fn the_gauge_is_homogeneous() {
        let exponents = Exponents::new(0.7, 3.0);
        let (once, gradient) = exponents.gauge([0.1, 0.2, 0.3]);
        let (twice, same) = exponents.gauge([0.2, 0.4, 0.6]);
        assert!((twice - 2.0 * once).abs() < 1e-15);
        // Euler: g = x ∂g/∂x + y ∂g/∂y + z ∂g/∂z, and the gradient does not change.
        let sum = 0.1 * gradient[0] + 0.2 * gradient[1] + 0.3 * gradient[2];
        assert!((sum - once).abs() < 1e-15);
        assert!(gradient.iter().zip(same).all(|(a, b)| (a - b).abs() < 1e-15 * a.abs().max(1.0)));
    }

    #[test]
    fn whole_and_half_powers_are_the_powers() {
        for halves in 1..=48 {
            let power = f64::from(halves) / 2.0;
            assert_eq!(Power::new(power, 1.0), Power::Halves(halves));
            let relative = Power::Halves(halves).of(0.9_f64) / 0.9_f64.powf(power) - 1.0;
            assert!(relative.abs() < power * f64::EPSILON + f64::EPSILON, "{power}: {relative:e}");
        }
        // A tenth is no binary number: 0.3 / 0.1 only looks like 3.
        assert!(matches!(Power::new(0.3, 0.1), Power::Any { .. }));
    }

    #[test]
    fn level_gauge_and_sections_agree() {
        for (n, m) in [(2.0, 2.0), (0.5, 0.5), (3.0, 0.7), (0.7, 3.0), (1.5, 6.0), (50.0, 1.3), (0.05, 4.0)] {
            let exponents = Exponents::new(n, m);
            let place = [0.31, 0.12, 0.47];
            let (value, gradient) = exponents.gauge(place);
            let level = exponents.level(place);
            assert!((level.log - value.ln()).abs() < 1e-13, "{n} {m}");
            for i in 0..3 {
                assert!((level.shares[i] - place[i] * gradient[i] / value).abs() < 1e-13, "{n} {m}: {level:?}");
            }
            let wide = exponents.level(place.map(DoubleDouble::from_f64));
            assert!((wide.excess.to_f64() - level.excess).abs() <= 1e-13 * (1.0 + level.excess), "{n} {m}");
            // On the surface ρ = σ.
            let place = place.map(|x| x / value);
            let (radius, section) = (exponents.radius(place[0], place[1]).0, exponents.section(place[2]).0);
            assert!((radius - section).abs() < 1e-12, "{n} {m}: {radius} and {section}");
        }
    }
}
