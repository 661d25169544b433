//! The quartic of a ray and a torus: where it turns, and on which side of the surface it does.
//!
//! F = (ρ − d)² + z² − 1 with ρ = √(x² + y²) loses its root when it is multiplied by H = (ρ + d)² + z² − 1:
//! G = F H = (x² + y² + z² + d² − 1)² − 4 d² (x² + y²). Along the ray, with δ measured from the foot of the perpendicular
//! and all divided by (c·c)², it has no cubic term:
//!
//! G(δ) = (δ² + k)² − (2 d / c·c)² (α δ² + 2 β δ + γ) = δ⁴ + p δ² + q δ + r
//!
//! G is lowest at −y, with y the root of y³ + (p/2) y − q/4 = 0 that has the sign of q, the only such one, and a ray with
//! G(−y) > 0 misses. The other two turning points are those of a quadratic, for
//! −y can be divided out. Between neighbours G is monotone, so the signs at the turning points tell the crossings: inside
//! is where G < 0, and the overlap of a spindle, where F and H both are negative, and so is their mean, δ² + k.
//!
//! **Certainty** What is divided out leaves ε = y³ + (p/2) y − q/4: the turning points are exactly those of G + 4 ε δ. So
//! an inexact y does no harm as long as each |G| there is above what rounding and 8 |ε| |δ| can do; only where it is not, y
//! is improved. What is known of y by iteration is thus checked by its residual.

use super::GenericRay;
use crate::math::{Pair, Real, dot, root_between};

/// Steps towards a turning point: each multiplies the number of right digits by four, so three do for 32 digits.
const MOST_STEPS: u32 = 6;

/// A ray about the foot of the perpendicular from the middle of the torus.
#[derive(Clone, Copy)]
pub(super) struct Line<A> {
    /// τ at the foot.
    pub foot: A,
    /// l, the point at the foot.
    pub nearest: [A; 3],
    /// l·l.
    pub square: A,
    /// c·c.
    pub a: A,
    /// How far the coordinates of l together are off when S and c are off by one part in one.
    pub sway: f64,
}

impl<A: Real> Line<A> {
    #[inline]
    pub fn new(ray: &GenericRay<A>) -> Self {
        let a = dot(ray.direction, ray.direction);
        let foot = -dot(ray.origin, ray.direction) / a;
        let nearest = ray.at(foot);
        let [x, y, z] = ray.sway(foot.to_f64());
        Self { foot, nearest, square: dot(nearest, nearest), a, sway: x + y + z }
    }
}

/// A turning point of G.
#[derive(Clone, Copy)]
pub(super) struct Turn<A> {
    /// δ.
    pub at: A,
    /// G there.
    pub value: A,
    /// Below zero inside the solid, above it outside, and zero where rounding hides on which side it is.
    pub level: A,
}

/// The turning points that matter, ascending.
pub(super) struct Turns<A> {
    points: [Turn<A>; 3],
    count: usize,
    /// G′ at all of them: what is left of it.
    pub slope: A,
    /// Bound on the error of each value, and on what the slope can change nearby.
    pub doubt: f64,
    /// Every value is above its doubt.
    pub sure: bool,
}

/// A stretch inside the solid, as far as the turning points tell of it.
pub(super) struct Stretch<A> {
    /// The first and the last turning point in it.
    pub inside: Pair<A>,
    /// G there.
    pub value: Pair<A>,
    /// The places before and after it that are known to be outside.
    pub outside: Pair<A>,
}

/// δ⁴ + p δ² + q δ + r.
#[derive(Clone, Copy)]
pub(super) struct Quartic<A> {
    pub line: Line<A>,
    /// c.
    pub course: [A; 3],
    /// d.
    pub d: A,
    pub k: A,
    /// p / 2.
    pub half_p: A,
    /// q / 4.
    pub quarter_q: A,
    pub r: A,
    /// Beyond ±end the ray is outside a ball that holds the torus with room to spare.
    pub end: A,
    /// Bound on the error of G on this side of the end.
    doubt: f64,
    /// What rounding can do to p/2 and y².
    blur: f64,
}

impl<A: Real> Quartic<A> {
    /// The quartic of a ray that passes within `ball`, 1.01 (d + 1).
    #[inline]
    pub fn new(d: f64, ball: f64, ray: &GenericRay<A>, line: Line<A>) -> Self {
        let number = A::from_f64;
        let ([l_x, l_y, _], [c_x, c_y, _]) = (line.nearest, ray.direction);
        let per_a = A::ONE / line.a;
        let d = number(d);
        let k = (line.square + d * d - A::ONE) * per_a;
        let ratio = (d + d) * per_a;
        let ratio_squared = ratio * ratio;
        let half = number(0.5) * ratio_squared;
        let beta = l_x * c_x + l_y * c_y;
        // No term of G (c·c)² is above 25 ball⁴; its relative error is that of some 12 roundings. The distance of the exact
        // line from the computed one is at most 4 u sway, that of its foot from zero at most three times as much.
        let scale = per_a.to_f64();
        let terms = ball * ball * ball * (160.0 * line.sway + 1200.0 * ball);
        Self {
            line,
            course: ray.direction,
            d,
            k,
            half_p: k - half * (c_x * c_x + c_y * c_y),
            quarter_q: A::ZERO - half * beta,
            r: k * k - ratio_squared * (l_x * l_x + l_y * l_y),
            end: ((number(ball * ball) - line.square) * per_a).sqrt(),
            doubt: A::UNIT_ROUNDOFF * terms * scale * scale,
            blur: 32.0 * A::UNIT_ROUNDOFF * ball * ball * scale,
        }
    }

    /// Finds the turning points, to as many digits as it takes to know the signs of G there.
    #[inline]
    pub fn turns(&self) -> Turns<A> {
        let quarter_q = self.quarter_q.to_f64();
        let y = rough_root(self.half_p.to_f64(), quarter_q.abs()).copysign(quarter_q);
        let y = self.improved(A::from_f64(y));
        let turns = self.turns_from(y);
        if turns.sure { turns } else { Self::refined(*self, y, turns) }
    }

    /// The turning points with ever more digits.
    #[cold]
    #[inline(never)]
    fn refined(self, mut y: A, mut turns: Turns<A>) -> Turns<A> {
        for _ in 0..MOST_STEPS {
            if turns.sure || turns.doubt <= 2.0 * self.doubt {
                break;
            }
            y = self.improved(y);
            turns = self.turns_from(y);
        }
        turns
    }

    /// One step of Householder's method of the third order for y³ + (p/2) y − q/4 = 0.
    #[inline]
    fn improved(&self, y: A) -> A {
        let value = self.residual(y);
        if value == A::ZERO {
            return y;
        }
        let three_y = y + y + y;
        let slope = three_y * y + self.half_p;
        let square = slope * slope;
        let bend = value * three_y;
        y - value * (square - bend) / (slope * (square - (bend + bend)) + value * value)
    }

    /// ε.
    #[inline]
    fn residual(&self, y: A) -> A {
        y * (y * y + self.half_p) - self.quarter_q
    }

    /// The turning points, given y.
    #[inline]
    fn turns_from(&self, y: A) -> Turns<A> {
        let epsilon = self.residual(y);
        let doubt = self.doubt + 8.0 * (epsilon.abs() * self.end).to_f64();
        // G less δ G′/4, which has no powers above the second; G′ is −4 ε at each of the three.
        let linear = self.quarter_q + self.quarter_q + self.quarter_q - epsilon;
        let turn = |at: A| self.turn(at, (self.half_p * at + linear) * at + self.r, doubt);
        let lowest = turn(-y);
        let slope = A::from_f64(-4.0) * epsilon;
        let one = Turns { points: [lowest; 3], count: 1, slope, doubt, sure: lowest.value.abs().to_f64() > doubt };
        if one.sure && lowest.level > A::ZERO {
            return one;
        }
        let discriminant = -self.half_p - A::from_f64(0.75) * y * y;
        if discriminant.to_f64() < -self.blur {
            return one;
        }
        let (middle, half) = (A::from_f64(0.5) * y, discriminant.max(A::ZERO).sqrt());
        let (second, third) = (turn(middle - half), turn(middle + half));
        let sure = one.sure && [second, third].iter().all(|turn| turn.value.abs().to_f64() > doubt);
        // −y lies on the other side of zero than y/2.
        let points = if y < A::ZERO { [second, third, lowest] } else { [lowest, second, third] };
        Turns { points, count: 3, sure, ..one }
    }

    #[inline]
    fn turn(&self, at: A, value: A, doubt: f64) -> Turn<A> {
        let level = if value.abs().to_f64() <= doubt && A::DOUBT_IS_ZERO {
            self.level_by_surface(at)
        } else if value < A::ZERO {
            value
        } else {
            at * at + self.k
        };
        Turn { at, value, level }
    }

    /// F, where it is not zero but for rounding: at the overlap of a spindle G may be zero where F is not.
    #[cold]
    fn level_by_surface(&self, at: A) -> A {
        let [near, _] = self.factors(at);
        if near.abs().to_f64() > self.surface_doubt() { near } else { A::ZERO }
    }

    /// Bound on the error of F where it is nearly zero: there neither ρ − d nor z is above 1 by much.
    pub fn surface_doubt(&self) -> f64 {
        16.0 * A::UNIT_ROUNDOFF * (self.line.sway + self.d.to_f64() + 1.0)
    }

    /// l + c δ.
    #[inline]
    pub fn point(&self, delta: A) -> [A; 3] {
        std::array::from_fn(|i| self.line.nearest[i] + self.course[i] * delta)
    }

    /// F and H.
    pub fn factors(&self, delta: A) -> [A; 2] {
        let [x, y, z] = self.point(delta);
        let radius = (x * x + y * y).sqrt();
        let height = z * z - A::ONE;
        [radius - self.d, radius + self.d].map(|x| x * x + height)
    }

    /// τ, given δ.
    #[inline]
    pub fn tau(&self, delta: A) -> A {
        self.line.foot + delta
    }

    /// The roots of G between turning points on the inside, δ ascending: there the tube of a spindle overlaps itself.
    pub fn hidden_roots(&self, turns: &Turns<A>) -> Vec<A> {
        let [p, q] = [self.half_p + self.half_p, A::from_f64(4.0) * self.quarter_q];
        let value_and_slope = |x: A| {
            let value = ((x * x + p) * x + q) * x + self.r;
            (value, (A::from_f64(4.0) * x * x + (p + p)) * x + q)
        };
        let hides = |pair: &&[Turn<A>]| {
            pair.iter().all(|turn| turn.level < A::ZERO) && (pair[0].value < A::ZERO) != (pair[1].value < A::ZERO)
        };
        let root = |pair: &[Turn<A>]| root_between(pair[0].at, pair[1].at, pair[0].value < A::ZERO, value_and_slope);
        turns.as_slice().windows(2).filter(hides).map(root).collect()
    }
}

impl<A: Real> Turns<A> {
    /// The turning points.
    pub fn as_slice(&self) -> &[Turn<A>] {
        &self.points[..self.count]
    }

    /// Whether the side of each is known.
    #[inline]
    pub fn decided(&self) -> bool {
        self.sure || A::DOUBT_IS_ZERO && self.as_slice().iter().all(|turn| turn.level != A::ZERO)
    }

    /// Hands out the stretches inside the solid, δ ascending; at −`end` and `end` the ray is outside.
    #[inline]
    pub fn each_stretch(&self, end: A, mut found: impl FnMut(Stretch<A>)) {
        let (mut before, mut inside) = (-end, None);
        let last = Turn { at: end, value: A::ONE, level: A::ONE };
        for turn in self.as_slice().iter().chain([&last]) {
            if turn.level < A::ZERO {
                let first = inside.map_or(turn, |[first, _]: [&Turn<A>; 2]| first);
                inside = Some([first, turn]);
            } else if turn.level > A::ZERO {
                if let Some([first, last]) = inside.take() {
                    found(Stretch {
                        inside: Pair([first.at, last.at]),
                        value: Pair([first.value, last.value]),
                        outside: Pair([before, turn.at]),
                    });
                }
                before = turn.at;
            }
        }
    }
}

/// The positive root of y³ + p y − q = 0 with q ≥ 0, to within a fifth of its size.
///
/// With b = q^⅔ it is q (b + p) / (b² + b p + p²) for p ≥ 0 and √−p + q / (b − 2 p) for p < 0: right where either
/// coefficient is small beside the other, and close in between.
#[inline]
fn rough_root(p: f64, q: f64) -> f64 {
    let root = rough_cube_root(q);
    let b = root * root;
    let falls = p < 0.0;
    let above = if falls { q } else { q * (b + p) };
    let below = if falls { b - 2.0 * p } else { b * b + p * (b + p) };
    // Where p and q both are zero, so is the root, and the quotient is not a number.
    (above / below).max(0.0) + (-p).max(0.0).sqrt()
}

/// ∛x for x ≥ 0 to within 6%: a third of the exponent, and of the digits with it (W. Kahan, in FreeBSD's `s_cbrt.c`).
#[inline]
fn rough_cube_root(x: f64) -> f64 {
    f64::from_bits(x.to_bits() / 3 + (715_094_163 << 32))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_rough_root_is_right_to_a_fifth(p in -1.0..1.0_f64, q in 0.0..1.0_f64, size in -40..40_i32) {
            let (p, q) = (p * 4.0_f64.powi(size), q * 8.0_f64.powi(size));
            let exact = root_between(0.0, 4.0 * 2.0_f64.powi(size), true, |y| (y * y * y + p * y - q, 3.0 * y * y + p));
            prop_assert!((rough_root(p, q) - exact).abs() <= 0.2 * exact, "{} for {exact}", rough_root(p, q));
        }

        #[test]
        fn the_rough_cube_root_is_right_to_six_hundredths(mantissa in 1.0..2.0_f64, exponent in -300..300_i32) {
            let x = mantissa * 2.0_f64.powi(exponent);
            prop_assert!((rough_cube_root(x) / x.cbrt() - 1.0).abs() < 0.06);
        }
    }

    #[test]
    fn without_coefficients_the_root_is_zero() {
        assert_eq!(rough_root(0.0, 0.0), 0.0);
        assert_eq!(rough_root(-4.0, 0.0), 2.0);
    }
}
