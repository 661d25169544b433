//! A root of any function, where it is known between which two points the sign changes.

use super::Real;

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

    #[test]
    fn double_double_finds_the_fourth_root_of_two() {
        let number = DoubleDouble::from_f64;
        let fourth_power = |x: DoubleDouble| (x * x * x * x - number(2.0), number(4.0) * x * x * x);
        let root = root_between(DoubleDouble::ONE, number(2.0), true, fourth_power);
        assert!((root - number(2.0).sqrt().sqrt()).to_f64().abs() < 1e-30);
    }

    #[test]
    fn a_slope_that_misleads_does_no_harm() {
        // Newton's method leaves for infinity on the flanks of the arc tangent.
        let root = root_between(-1e6, 3e6, true, |x: f64| ((x - 1.0).atan(), 1.0 / (1.0 + (x - 1.0) * (x - 1.0))));
        assert!((root - 1.0).abs() < 1e-15);
        let root = root_between(0.0, 4.0, false, |x: f64| (2.0 - x, 0.0));
        assert!((root - 2.0).abs() < 1e-15);
    }

    proptest! {
        #[test]
        fn roots_of_quadratics_are_found_to_the_last_digits(root in 0.1..10.0_f64, other in -10.0..0.0_f64) {
            let product = |x: f64| ((x - root) * (x - other), 2.0 * x - root - other);
            let found = root_between(0.0, 20.0, true, product);
            prop_assert!((found - root).abs() <= 4.0 * f64::EPSILON * root);
        }
    }
}
