//! Numbers that know how wrong they are: a value with what exact arithmetic gives in its place.
//!
//! The value is bit for bit what the plain arithmetic gives. Beside it the same formula is worked out in [`Precise`] numbers,
//! from the exact inputs. Comparisons look at the value alone, so that the run takes the same way through the solver. So the
//! error is not a bound but the error itself: errors that cancel each other count for nothing.
//!
//! Where a solver guesses and improves, both begin with the same guess. What an iteration has not yet reached is then
//! missing from both; hit times are therefore judged by exact hits, not by shadows.
//!
//! **Source** F. Benz, A. Hildebrandt, S. Hack, "A dynamic program analysis to find floating-point accuracy problems",
//! PLDI 2012 (a shadow value for each number); A. Sanchez-Stern, P. Panchekha, S. Lerner, Z. Tatlock, "Finding root causes
//! of floating point error", PLDI 2018 (Herbgrind: the same in 1,000 bits); S. Chowdhary, J. P. Lim, S. Nagarakatte,
//! "Debugging and detecting numerical errors in computation with posits", PLDI 2020.

use super::{DoubleDouble, Precise, Real};
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number of `A`, and the exact one that it stands for.
#[derive(Clone, Copy, Debug)]
pub struct Shadowed<A> {
    /// What `A` alone gives.
    pub value: A,
    /// What exact arithmetic gives for the same formula.
    pub exact: Precise,
}

impl<A: Real> Shadowed<A> {
    /// A number that counts as exact.
    #[must_use]
    pub fn exact(value: A) -> Self {
        Self { value, exact: value.to_exact() }
    }
}

impl<A: PartialEq> PartialEq for Shadowed<A> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<A: PartialOrd> PartialOrd for Shadowed<A> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<A: Real> Add for Shadowed<A> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, exact: self.exact + other.exact }
    }
}

impl<A: Real> Sub for Shadowed<A> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, exact: self.exact - other.exact }
    }
}

impl<A: Real> Mul for Shadowed<A> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self { value: self.value * other.value, exact: self.exact * other.exact }
    }
}

impl<A: Real> Div for Shadowed<A> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        Self { value: self.value / other.value, exact: self.exact / other.exact }
    }
}

impl<A: Real> Neg for Shadowed<A> {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, exact: -self.exact }
    }
}

impl<A: Real> Real for Shadowed<A> {
    const UNIT_ROUNDOFF: f64 = A::UNIT_ROUNDOFF;
    const NAME: &'static str = A::NAME;
    const F64_OPERATIONS: u64 = A::F64_OPERATIONS;
    const FINEST: bool = A::FINEST;
    const DOUBT_IS_ZERO: bool = A::DOUBT_IS_ZERO;
    const ZERO: Self = Self { value: A::ZERO, exact: Precise::ZERO };
    const ONE: Self = Self { value: A::ONE, exact: Precise::ONE };

    /// The exact number is the one that was asked for, though `A` may have to round it.
    fn from_f64(x: f64) -> Self {
        Self { value: A::from_f64(x), exact: Precise::from_f64(x) }
    }

    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }

    /// |value − exact|, rounded once; infinite where only one of them is a number.
    fn error(self) -> Option<f64> {
        let value = self.value.to_exact();
        if value == self.exact {
            return Some(0.0);
        }
        let error = (value - self.exact).abs().to_f64();
        Some(if error.is_nan() { f64::INFINITY } else { error })
    }

    fn widen(self) -> DoubleDouble {
        self.value.widen()
    }

    fn narrow(wide: DoubleDouble) -> Self {
        Self { value: A::narrow(wide), exact: wide.to_exact() }
    }

    fn to_exact(self) -> Precise {
        self.value.to_exact()
    }

    fn from_exact(exact: Precise) -> Self {
        Self { value: A::from_exact(exact), exact }
    }

    fn sqrt(self) -> Self {
        Self { value: self.value.sqrt(), exact: self.exact.sqrt() }
    }

    fn abs(self) -> Self {
        Self { value: self.value.abs(), exact: self.exact.abs() }
    }

    fn pow(self, exponent: Self) -> Self {
        Self { value: self.value.pow(exponent.value), exact: self.exact.pow(exponent.exact) }
    }

    fn power(self, exponent: Self) -> Self {
        Self { value: self.value.power(exponent.value), exact: self.exact.pow(exponent.exact) }
    }

    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        Self {
            value: A::difference_of_products(a.value, b.value, c.value, d.value),
            exact: a.exact * b.exact - c.exact * d.exact,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn shadowed<A: Real>(x: f64) -> Shadowed<A> {
        Shadowed::from_f64(x)
    }

    #[test]
    fn what_cancellation_leaves_is_known_to_be_wrong() {
        // (1 + 2⁻⁵³) − 1: the sum is rounded to 1, and all that is left is wrong.
        let difference = shadowed::<f64>(1.0) + shadowed(2.0_f64.powi(-53)) - shadowed(1.0);
        assert_eq!((difference.value, difference.error()), (0.0, Some(2.0_f64.powi(-53))));
    }

    #[test]
    fn powers_of_two_lose_nothing() {
        let x = shadowed::<f32>(f64::from(1.1_f32)) * shadowed(2.0_f64.powi(-40)) / shadowed(2.0_f64.powi(-20));
        assert_eq!(x.error(), Some(0.0));
        assert_eq!((x * x).sqrt().error(), Some((f64::from((x * x).value.sqrt()) - x.exact.to_f64()).abs()));
    }

    #[test]
    fn what_an_arithmetic_cannot_hold_is_an_error_from_the_start() {
        assert_eq!(shadowed::<f32>(0.1).error(), Some((f64::from(0.1_f32) - 0.1).abs()));
        assert_eq!(shadowed::<DoubleDouble>(0.1).error(), Some(0.0));
    }

    #[test]
    fn the_error_of_32_digits_is_told_though_it_is_below_those_of_f64() {
        let third = Shadowed::<DoubleDouble>::ONE / shadowed(3.0);
        let error = third.error().unwrap();
        assert!(error > 0.0 && error <= DoubleDouble::UNIT_ROUNDOFF / 3.0, "{error:e}");
    }

    #[test]
    fn equal_infinities_have_no_error_and_unequal_ones_have_nothing_but() {
        let overflow = shadowed::<f64>(1e200) * shadowed(1e200);
        assert_eq!(overflow.error(), Some(f64::INFINITY));
        assert_eq!((shadowed::<f64>(1.0) / shadowed(0.0)).error(), Some(0.0));
    }

    /// One expression with every operation, in any arithmetic.
    fn expression<A: Real>(x: A, y: A) -> A {
        let hypotenuse = (x * x + y * y).sqrt();
        let minor = A::difference_of_products(x, y, hypotenuse, x - y);
        (minor / hypotenuse).abs().pow(A::from_f64(1.5)) - x / y
    }

    proptest! {
        #[test]
        fn the_value_is_the_plain_one_and_the_error_that_of_more_digits(x in 0.1..10.0_f64, y in 0.1..10.0_f64) {
            let (plain, exact) = (expression(x, y), expression(DoubleDouble::from_f64(x), DoubleDouble::from_f64(y)));
            let shadowed = expression(shadowed::<f64>(x), shadowed(y));
            prop_assert_eq!(plain.to_bits(), shadowed.value.to_bits());
            let off = (DoubleDouble::from_f64(plain) - exact).to_f64().abs();
            prop_assert!((off - shadowed.error().unwrap()).abs() <= 1e-27, "{:e} and {:?}", off, shadowed.error());
        }
    }
}
