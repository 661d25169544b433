//! Quartic equations: every real root at which the sign changes.
//!
//! Between two neighbouring turning points a polynomial is monotone, so its signs there tell whether a root lies between
//! them, and bisection cannot miss it. The turning points are the roots of the derivative, found the same way (C. Yuksel,
//! "High-performance polynomial root finding for graphics", HPG 2022). Turning points at which the value is lost in
//! rounding are where a double root may hide; [`Quartic::separators`] hands them out so that the caller can look.

use super::{Quadratic, Real};

/// The polynomial with these coefficients, constant term first, at `x` (Horner's scheme).
pub fn evaluate<A: Real>(coefficients: &[A], x: A) -> A {
    coefficients.iter().rev().fold(A::ZERO, |sum, &coefficient| sum * x + coefficient)
}

/// c₀ + c₁ x + … + c₄ x⁴.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quartic<A> {
    /// Constant term first.
    pub coefficients: [A; 5],
}

/// At most five numbers, ascending.
#[derive(Clone, Copy, Debug)]
pub struct Separators<A> {
    points: [A; 5],
    count: usize,
}

impl<A: Real> Separators<A> {
    fn insert(&mut self, x: A) {
        let place = self.as_slice().iter().position(|&point| x < point).unwrap_or(self.count);
        self.points.copy_within(place..self.count, place + 1);
        self.points[place] = x;
        self.count += 1;
    }

    /// The numbers.
    pub fn as_slice(&self) -> &[A] {
        &self.points[..self.count]
    }
}

impl<A: Real> Quartic<A> {
    /// The value at `x`.
    pub fn at(&self, x: A) -> A {
        evaluate(&self.coefficients, x)
    }

    /// The turning points and the points of inflection between `low` and `high`.
    ///
    /// The polynomial is monotone between neighbours. A root of even multiplicity lies at one of them, and so does a
    /// triple one.
    pub fn separators(&self, low: A, high: A) -> Separators<A> {
        let [_, c1, c2, c3, c4] = self.coefficients;
        let number = A::from_f64;
        let slope = [c1, number(2.0) * c2, number(3.0) * c3, number(4.0) * c4];
        let curvature = [slope[1], number(2.0) * slope[2], number(3.0) * slope[3]];
        let mut separators = Separators { points: [A::ZERO; 5], count: 0 };
        let mut ends = [low, high, high, high];
        let mut count = 1;
        let half = number(0.5) * curvature[1];
        for x in Quadratic::new(curvature[2], half, curvature[0]).roots().into_iter().flatten() {
            if low < x && x < high {
                separators.insert(x);
                ends[count] = x;
                count += 1;
            }
        }
        ends[count] = high;
        for pair in ends[..=count].windows(2) {
            let (at_start, at_end) = (evaluate(&slope, pair[0]), evaluate(&slope, pair[1]));
            if (at_start < A::ZERO) != (at_end < A::ZERO) {
                let value_and_slope = |x| (evaluate(&slope, x), evaluate(&curvature, x));
                separators.insert(root_between(pair[0], pair[1], at_start < A::ZERO, value_and_slope));
            }
        }
        separators
    }

    /// The root between `low` and `high`, where the signs at these two differ.
    pub fn root_between(&self, low: A, high: A, rising: bool) -> A {
        let [_, c1, c2, c3, c4] = self.coefficients;
        let number = A::from_f64;
        let slope = [c1, number(2.0) * c2, number(3.0) * c3, number(4.0) * c4];
        root_between(low, high, rising, |x| (self.at(x), evaluate(&slope, x)))
    }
}

/// The root of a function between `low` and `high`: Newton's method, kept in a bracket that only ever shrinks.
///
/// `function` returns value and slope; `rising` says that it is negative at `low` and positive at `high`. A step that
/// leaves the bracket, or that shrinks by less than half, is replaced by bisection, so the work is bounded.
pub fn root_between<A: Real>(mut low: A, mut high: A, rising: bool, function: impl Fn(A) -> (A, A)) -> A {
    let half = A::from_f64(0.5);
    // A step this short makes the next one shorter than the last digit. Longer would lose digits; at a few roundings
    // the noise of the function keeps the steps from ever getting there.
    let short = A::from_f64(64.0 * A::UNIT_ROUNDOFF) * low.abs().max(high.abs());
    let mut x = low + (high - low) * half;
    let mut last_step = high - low;
    // Bisection alone ends after as many steps as a number has bits, even with a Newton step before each.
    for _ in 0..256 {
        let (value, slope) = function(x);
        if value == A::ZERO {
            return x;
        }
        if (value < A::ZERO) == rising {
            low = x;
        } else {
            high = x;
        }
        let step = value / slope;
        let newton = x - step;
        if low < newton && newton < high && step.abs() < last_step * half {
            if step.abs() <= short {
                return newton;
            }
            (x, last_step) = (newton, step.abs());
        } else {
            last_step = (high - low) * half;
            let middle = low + last_step;
            if middle == low || middle == high {
                return middle;
            }
            x = middle;
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use super::super::DoubleDouble;
    use super::*;
    use proptest::prelude::*;

    /// The quartic with leading coefficient 1 and these four roots.
    fn with_roots(roots: [f64; 4]) -> Quartic<f64> {
        let mut coefficients = [1.0, 0.0, 0.0, 0.0, 0.0];
        for (degree, root) in roots.into_iter().enumerate() {
            for k in (0..=degree + 1).rev() {
                let below = if k > 0 { coefficients[k - 1] } else { 0.0 };
                coefficients[k] = below - root * coefficients[k];
            }
        }
        Quartic { coefficients }
    }

    fn sign_changes(quartic: &Quartic<f64>, low: f64, high: f64) -> Vec<f64> {
        let separators = quartic.separators(low, high);
        let ends: Vec<_> = [low].into_iter().chain(separators.as_slice().iter().copied()).chain([high]).collect();
        ends.windows(2)
            .filter(|pair| (quartic.at(pair[0]) < 0.0) != (quartic.at(pair[1]) < 0.0))
            .map(|pair| quartic.root_between(pair[0], pair[1], quartic.at(pair[0]) < 0.0))
            .collect()
    }

    #[test]
    fn horner_evaluates_from_the_constant_up() {
        assert_eq!(evaluate(&[1.0, 2.0, 3.0], 2.0), 17.0);
    }

    #[test]
    fn four_integer_roots_are_found_to_the_last_digits() {
        // (x + 2)(x + 1)(x − 1)(x − 3) = (x² − 1)(x² − x − 6) = x⁴ − x³ − 7x² + x + 6
        let quartic = with_roots([-2.0, -1.0, 1.0, 3.0]);
        assert_eq!(quartic.coefficients, [6.0, 1.0, -7.0, -1.0, 1.0]);
        for (found, root) in sign_changes(&quartic, -10.0, 10.0).into_iter().zip([-2.0, -1.0, 1.0, 3.0]) {
            assert!((found - root).abs() <= 4.0 * f64::EPSILON);
        }
    }

    #[test]
    fn a_double_root_is_no_sign_change_but_a_separator() {
        // (x − 1)² (x² + 1)
        let quartic = Quartic { coefficients: [1.0, -2.0, 2.0, -2.0, 1.0] };
        assert!(sign_changes(&quartic, -4.0, 4.0).is_empty());
        assert!(quartic.separators(-4.0, 4.0).as_slice().iter().any(|x: &f64| (x - 1.0).abs() < 1e-15));
    }

    #[test]
    fn double_double_finds_the_fourth_root_of_two() {
        let number = DoubleDouble::from_f64;
        let quartic = Quartic { coefficients: [-2.0, 0.0, 0.0, 0.0, 1.0].map(number) };
        let root = quartic.root_between(DoubleDouble::ONE, number(2.0), true);
        assert!((root - number(2.0).sqrt().sqrt()).to_f64().abs() < 1e-30);
    }

    proptest! {
        #[test]
        fn well_separated_roots_are_all_found(first in -3.0..-1.0, gaps in prop::array::uniform3(0.1..1.0)) {
            let mut roots = [first; 4];
            for k in 1..4 {
                roots[k] = roots[k - 1] + gaps[k - 1];
            }
            let found = sign_changes(&with_roots(roots), -8.0, 8.0);
            prop_assert_eq!(found.len(), 4);
            for (a, b) in found.iter().zip(roots) {
                prop_assert!((a - b).abs() < 1e-10);
            }
        }
    }
}
