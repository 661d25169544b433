//! An arithmetic that never turns to a finer one: what its own digits suggest is the answer, right or wrong.
//!
//! It serves as an exhibit: the difference between `Alone<f64>` and `f64` is what the fallback is worth.

use super::{DoubleDouble, Real};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The numbers of `A`, with nothing finer to turn to.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Alone<A>(pub A);

impl<A: Real> Add for Alone<A> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl<A: Real> Sub for Alone<A> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl<A: Real> Mul for Alone<A> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl<A: Real> Div for Alone<A> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl<A: Real> Neg for Alone<A> {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<A: Real> Real for Alone<A> {
    const UNIT_ROUNDOFF: f64 = A::UNIT_ROUNDOFF;
    const NAME: &'static str = A::NAME;
    const F64_OPERATIONS: u64 = A::F64_OPERATIONS;
    const FINEST: bool = true;
    const DOUBT_IS_ZERO: bool = A::DOUBT_IS_ZERO;
    const ZERO: Self = Self(A::ZERO);
    const ONE: Self = Self(A::ONE);

    fn from_f64(x: f64) -> Self {
        Self(A::from_f64(x))
    }

    fn to_f64(self) -> f64 {
        self.0.to_f64()
    }

    fn widen(self) -> DoubleDouble {
        self.0.widen()
    }

    fn narrow(wide: DoubleDouble) -> Self {
        Self(A::narrow(wide))
    }

    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    fn pow(self, exponent: Self) -> Self {
        Self(self.0.pow(exponent.0))
    }

    fn power(self, exponent: Self) -> Self {
        Self(self.0.power(exponent.0))
    }

    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        Self(A::difference_of_products(a.0, b.0, c.0, d.0))
    }
}
