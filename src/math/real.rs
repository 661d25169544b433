//! The arithmetic that a solver is written in, as a type.
//!
//! `f32`, `f64` and [`DoubleDouble`](super::DoubleDouble) hold numbers; [`Traced`](super::Traced) holds a number of one of
//! these with a running bound on its error, [`Shadowed`](super::Shadowed) one with its true error; [`Alone`](super::Alone) is
//! one of these that never turns to another. [`Precise`](super::Precise) is what all are measured against.

use super::{DoubleDouble, Precise, portable};
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A real number type that the solvers can be instantiated with.
pub trait Real:
    Copy
    + Debug
    + PartialEq
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Unit roundoff u: the largest relative error of one rounding, as an `f64`.
    const UNIT_ROUNDOFF: f64;
    /// Its name, as it is shown.
    const NAME: &'static str;
    /// Whether there is no finer arithmetic to turn to when a question cannot be decided in this one.
    const FINEST: bool = Self::UNIT_ROUNDOFF <= DoubleDouble::UNIT_ROUNDOFF;
    /// Whether what lies within the doubt of this arithmetic is as good as zero: only where doubt is far below what the
    /// inputs themselves leave open.
    const DOUBT_IS_ZERO: bool = Self::UNIT_ROUNDOFF <= DoubleDouble::UNIT_ROUNDOFF;
    /// Operations of `f64` that one operation takes, as an average of sums and products.
    const F64_OPERATIONS: u64 = 1;
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;

    /// The nearest number of this type.
    fn from_f64(x: f64) -> Self;
    /// The nearest `f64`.
    fn to_f64(self) -> f64;
    /// The error of the number, or a bound on it, for arithmetics that keep account.
    fn error(self) -> Option<f64> {
        None
    }
    /// The same number with more digits.
    fn widen(self) -> DoubleDouble;
    /// The nearest number of this type to one with more digits.
    fn narrow(wide: DoubleDouble) -> Self;
    /// The number itself, with digits to spare.
    fn to_exact(self) -> Precise {
        Precise::narrow(self.widen())
    }
    /// The nearest number of this type, or next to it.
    #[must_use]
    fn from_exact(exact: Precise) -> Self {
        Self::narrow(exact.widen())
    }
    /// The square root; NaN for negative numbers.
    #[must_use]
    fn sqrt(self) -> Self;
    /// The magnitude.
    #[must_use]
    fn abs(self) -> Self;
    /// A non-negative number to a real power.
    #[must_use]
    fn pow(self, exponent: Self) -> Self;
    /// A non-negative number to a real power, fast: with an error of about u (1 + 2 |ln r|) r for the result r.
    #[must_use]
    fn power(self, exponent: Self) -> Self {
        self.pow(exponent)
    }
    /// a·b − c·d with an error of at most 2 ulp of the result (Kahan; Jeannerod, Louvet, Muller 2013).
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self;

    /// The smaller one.
    #[must_use]
    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }

    /// The larger one.
    #[must_use]
    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }

    /// Whether it is neither infinite nor NaN.
    fn is_finite(self) -> bool {
        self.to_f64().is_finite()
    }
}

impl Real for f64 {
    const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;
    const NAME: &'static str = "f64";
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;

    fn from_f64(x: f64) -> Self {
        x
    }

    fn to_f64(self) -> f64 {
        self
    }

    fn widen(self) -> DoubleDouble {
        DoubleDouble::from_f64(self)
    }

    fn narrow(wide: DoubleDouble) -> Self {
        wide.to_f64()
    }

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn abs(self) -> Self {
        self.abs()
    }

    fn pow(self, exponent: Self) -> Self {
        portable::powf(self, exponent)
    }

    #[inline]
    fn power(self, exponent: Self) -> Self {
        super::elementary::power(self, exponent)
    }

    #[inline]
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        let (cd, cd_error) = super::double_double::two_product(c, d);
        let (ab, ab_error) = super::double_double::two_product(a, b);
        (ab - cd) + (ab_error - cd_error)
    }
}

impl Real for f32 {
    const UNIT_ROUNDOFF: f64 = 0.5 * f32::EPSILON as f64;
    const NAME: &'static str = "f32";
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;

    #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
    fn from_f64(x: f64) -> Self {
        x as Self
    }

    fn to_f64(self) -> f64 {
        f64::from(self)
    }

    fn widen(self) -> DoubleDouble {
        DoubleDouble::from_f64(f64::from(self))
    }

    fn narrow(wide: DoubleDouble) -> Self {
        Self::from_f64(wide.to_f64())
    }

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn abs(self) -> Self {
        self.abs()
    }

    fn pow(self, exponent: Self) -> Self {
        Self::from_f64(portable::powf(self.into(), exponent.into()))
    }

    #[expect(clippy::cast_possible_truncation, reason = "the products are exact in f64, one rounding is left")]
    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        (f64::from(a) * f64::from(b) - f64::from(c) * f64::from(d)) as Self
    }
}

/// The scalar product.
pub fn dot<A: Real>(a: [A; 3], b: [A; 3]) -> A {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The vector product.
pub fn cross<A: Real>(a: [A; 3], b: [A; 3]) -> [A; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The power of two that brings the largest component of `v` into [1, 2), so that squares neither overflow nor vanish.
///
/// Multiplying by a power of two is exact. Zero and non-finite vectors get 1.
#[must_use]
#[inline]
pub fn scale_to_unit(v: [f64; 3]) -> f64 {
    // One instruction, for nothing is asked about NaN.
    let larger = |a: f64, b: f64| if a > b { a } else { b };
    let largest = larger(larger(v[0].abs(), v[1].abs()), v[2].abs());
    // The exponents of a number and of its reciprocal add up to twice the bias. The two ends of the range, subnormals among
    // them, have no normal reciprocal.
    match largest.to_bits() >> 52 {
        0x7ff => 1.0,
        _ if largest == 0.0 => 1.0,
        exponent => f64::from_bits((2046 - exponent).max(1) << 52),
    }
}
