//! Numbers that know how wrong they may be: a value with a running bound on its rounding error.
//!
//! The value is bit for bit what the plain arithmetic gives, so a solver can be run once more with this type to say of
//! every line of its working how many digits it has lost. Comparisons look at the value alone, so that the run takes the
//! same way through the solver. Inputs count as exact.
//!
//! Source: J. H. Wilkinson, "Error analysis revisited", IMA Bulletin 22 (1986); N. J. Higham, Accuracy and Stability of
//! Numerical Algorithms, 2nd ed., § 3.3 (running error analysis).

use super::{DoubleDouble, Real, portable};
use std::cell::Cell;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number of `A` with a bound on its error.
#[derive(Clone, Copy, Debug)]
pub struct Traced<A> {
    /// What `A` alone gives.
    pub value: A,
    /// Bound on its distance from what exact arithmetic gives.
    pub error: f64,
}

thread_local! {
    /// Operations since the last count began, on this thread.
    static OPERATIONS: Cell<u64> = const { Cell::new(0) };
}

/// The result of `work`, and how many operations on [`Traced`] numbers it took.
pub fn counted<T>(work: impl FnOnce() -> T) -> (T, u64) {
    let before = OPERATIONS.get();
    let result = work();
    (result, OPERATIONS.get() - before)
}

impl<A: Real> Traced<A> {
    /// A number that counts as exact.
    #[must_use]
    pub fn exact(value: A) -> Self {
        Self { value, error: 0.0 }
    }

    /// The outcome of an operation: what its operands' errors make of it, and the rounding of the operation itself.
    fn rounded(value: A, inherited: f64) -> Self {
        OPERATIONS.set(OPERATIONS.get() + 1);
        Self { value, error: inherited + A::UNIT_ROUNDOFF * value.abs().to_f64() }
    }

    fn size(self) -> f64 {
        self.value.abs().to_f64()
    }

    /// A power, worked out with a relative error of `own` and one rounding. The relative error of xᵖ is p times that of x,
    /// and ln x times the error of p.
    fn raised(self, exponent: Self, value: A, own: f64) -> Self {
        let size = value.abs().to_f64();
        let relative = if self.error > 0.0 { exponent.size() * self.error / (self.size() - self.error) } else { 0.0 };
        let by_exponent = if exponent.error > 0.0 { portable::ln(self.size()).abs() * exponent.error } else { 0.0 };
        let relative = if relative < 0.0 { f64::INFINITY } else { relative };
        let inherited = if size > 0.0 { size * (relative + by_exponent + own) } else { 0.0 };
        Self::rounded(value, inherited)
    }
}

impl<A: Real> PartialEq for Traced<A> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<A: Real> PartialOrd for Traced<A> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<A: Real> Add for Traced<A> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::rounded(self.value + other.value, self.error + other.error)
    }
}

impl<A: Real> Sub for Traced<A> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::rounded(self.value - other.value, self.error + other.error)
    }
}

impl<A: Real> Mul for Traced<A> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let inherited = self.size() * other.error + other.size() * self.error + self.error * other.error;
        Self::rounded(self.value * other.value, inherited)
    }
}

impl<A: Real> Div for Traced<A> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let room = other.size() - other.error;
        let inherited = if self.error == 0.0 && other.error == 0.0 {
            0.0
        } else if room > 0.0 {
            (self.error + value.abs().to_f64() * other.error) / room
        } else {
            f64::INFINITY
        };
        Self::rounded(value, inherited)
    }
}

impl<A: Real> Neg for Traced<A> {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, error: self.error }
    }
}

impl<A: Real> Real for Traced<A> {
    const UNIT_ROUNDOFF: f64 = A::UNIT_ROUNDOFF;
    const NAME: &'static str = A::NAME;
    const F64_OPERATIONS: u64 = A::F64_OPERATIONS;
    const FINEST: bool = A::FINEST;
    const DOUBT_IS_ZERO: bool = A::DOUBT_IS_ZERO;
    const ZERO: Self = Self { value: A::ZERO, error: 0.0 };
    const ONE: Self = Self { value: A::ONE, error: 0.0 };

    fn from_f64(x: f64) -> Self {
        Self { value: A::from_f64(x), error: 0.0 }
    }

    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }

    fn error(self) -> Option<f64> {
        Some(self.error)
    }

    fn widen(self) -> DoubleDouble {
        self.value.widen()
    }

    fn narrow(wide: DoubleDouble) -> Self {
        Self { value: A::narrow(wide), error: 0.0 }
    }

    /// |√a − √b| = |a − b| / (√a + √b).
    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        let least = (self.value.to_f64() - self.error).max(0.0).sqrt();
        let inherited = if self.error > 0.0 { self.error / (value.to_f64() + least) } else { 0.0 };
        Self::rounded(value, inherited)
    }

    fn abs(self) -> Self {
        Self { value: self.value.abs(), error: self.error }
    }

    /// Powers are right to within an ulp, two roundings.
    fn pow(self, exponent: Self) -> Self {
        self.raised(exponent, self.value.pow(exponent.value), A::UNIT_ROUNDOFF)
    }

    fn power(self, exponent: Self) -> Self {
        let value = self.value.power(exponent.value);
        let log = exponent.size() * if self.size() > 0.0 { portable::ln(self.size()).abs() } else { 0.0 };
        self.raised(exponent, value, A::UNIT_ROUNDOFF * (2.0 + 2.0 * log))
    }

    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        let value = A::difference_of_products(a.value, b.value, c.value, d.value);
        let of = |a: Self, b: Self| a.size() * b.error + b.size() * a.error + a.error * b.error;
        let rounding = A::UNIT_ROUNDOFF * value.abs().to_f64();
        Self::rounded(value, of(a, b) + of(c, d) + rounding)
    }
}

#[cfg(test)]
mod tests {
    use super::super::dot;
    use super::*;
    use proptest::prelude::*;

    fn traced(x: f64) -> Traced<f64> {
        Traced::from_f64(x)
    }

    #[test]
    fn cancellation_shows_in_the_bound() {
        // (1 + 2⁻⁵³) − 1: the sum is rounded to 1, and all that is left is wrong.
        let difference = traced(1.0) + traced(2.0_f64.powi(-53)) - traced(1.0);
        assert_eq!(difference.value, 0.0);
        assert!(difference.error >= 2.0_f64.powi(-53));
    }

    #[test]
    fn exact_inputs_have_no_error_and_one_rounding_has_half_an_ulp() {
        assert_eq!(traced(0.1).error, 0.0);
        assert_eq!((traced(1.0) / traced(3.0)).error, f64::EPSILON / 2.0 / 3.0);
    }

    #[test]
    fn operations_are_counted() {
        let ((), operations) = counted(|| {
            let _ = dot([traced(1.0); 3], [traced(2.0); 3]).sqrt();
        });
        assert_eq!(operations, 6);
    }

    /// One expression with every operation, in any arithmetic.
    fn expression<A: Real>(x: A, y: A) -> A {
        let hypotenuse = (x * x + y * y).sqrt();
        let minor = A::difference_of_products(x, y, hypotenuse, x - y);
        (minor / hypotenuse).abs().pow(A::from_f64(1.5)) - x / y
    }

    proptest! {
        #[test]
        fn the_value_is_the_plain_one_and_the_truth_lies_within_the_bound(x in 0.1..10.0_f64, y in 0.1..10.0_f64) {
            let (plain, exact) = (expression(x, y), expression(DoubleDouble::from_f64(x), DoubleDouble::from_f64(y)));
            let traced = expression(traced(x), traced(y));
            prop_assert_eq!(plain.to_bits(), traced.value.to_bits());
            let off = (DoubleDouble::from_f64(plain) - exact).to_f64().abs();
            prop_assert!(off <= traced.error, "{} is off by {:e}, more than {:e}", plain, off, traced.error);
        }
    }
}
