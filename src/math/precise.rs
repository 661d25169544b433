//! Numbers of 77 digits, against which all others are measured.
//!
//! Floating-point numbers in software: a sign, a whole number of N digits to the base 2⁶⁴ whose highest bit is set, and an
//! exponent that neither overflows nor underflows for anything that began as an `f64`. Sums, products and quotients are
//! rounded to nearest, ties to even; square roots and powers are within one unit in the last place. Infinite and undefined
//! numbers are those of `f64`.
//!
//! **Why not a library.** Solvers are written for types that can be copied; libraries keep the digits in a vector.

use super::precise_limbs as limbs;
use super::{DoubleDouble, Real};
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number of 256 bits.
pub type Precise = Float<4>;

/// The most digits that a number can have; twice that and two more are what the widest intermediate result takes.
const MOST_DIGITS: usize = 5;
const SCRATCH: usize = 2 * MOST_DIGITS + 2;

/// Beyond 2 to this power numbers are infinite, below its reciprocal they are zero. Far larger could overflow an `i64` in a
/// product; much smaller could meet a product of many `f64`.
const MOST_EXPONENT: i64 = 1 << 40;

/// ± (digits / 2⁶⁴ᴺ) · 2 to the power of the exponent.
#[derive(Clone, Copy, Debug)]
pub struct Float<const N: usize> {
    class: Class,
    negative: bool,
    exponent: i64,
    digits: [u64; N],
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Class {
    Zero,
    Normal,
    Infinite,
    Undefined,
}

impl<const N: usize> Float<N> {
    pub(super) const ZERO: Self = Self { class: Class::Zero, negative: false, exponent: 0, digits: [0; N] };
    pub(super) const ONE: Self = {
        let mut digits = [0; N];
        digits[N - 1] = 1 << 63;
        Self { class: Class::Normal, negative: false, exponent: 1, digits }
    };

    /// A number between ½ and 1, by its digits.
    pub(super) const fn fraction(digits: [u64; N]) -> Self {
        Self { class: Class::Normal, negative: false, exponent: 0, digits }
    }

    /// The number itself: every `f64` is one of these.
    #[must_use]
    pub fn from_f64(x: f64) -> Self {
        let negative = x.is_sign_negative();
        if x.is_nan() {
            return Self { class: Class::Undefined, ..Self::ZERO };
        }
        if x.is_infinite() {
            return Self { class: Class::Infinite, negative, ..Self::ZERO };
        }
        let bits = x.abs().to_bits();
        let (fraction, exponent) = (bits & ((1 << 52) - 1), (bits >> 52).cast_signed());
        // x = whole · 2 to the power of exponent − 1075; subnormal numbers have no leading one and count as the next exponent.
        let (whole, exponent) = if exponent == 0 { (fraction, 1) } else { (fraction | 1 << 52, exponent) };
        Self::rounded(negative, exponent - 1075 + 64, &mut [whole])
    }

    /// The nearest `f64`.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        let size = match self.class {
            Class::Zero => 0.0,
            Class::Normal => self.magnitude_to_f64(),
            Class::Infinite => f64::INFINITY,
            Class::Undefined => f64::NAN,
        };
        if self.negative { -size } else { size }
    }

    fn magnitude_to_f64(&self) -> f64 {
        const LEAST_NORMAL: i64 = -1021;
        // Numbers below the least normal one have fewer digits.
        let kept = 53 - (LEAST_NORMAL - self.exponent).max(0);
        if self.exponent > 1024 {
            return f64::INFINITY;
        }
        if kept < 0 {
            return 0.0;
        }
        let (top, rest) = (self.digits[N - 1], self.digits[..N - 1].iter().any(|&digit| digit != 0));
        let wide = u128::from(top | u64::from(rest)) << kept;
        let (whole, below) = ((wide >> 64) as u64, wide & u128::from(u64::MAX));
        let round_up = below > 1 << 63 || below == 1 << 63 && whole % 2 == 1;
        (whole + u64::from(round_up)) as f64 * power_of_two(self.exponent - kept)
    }

    /// The number with more or fewer digits.
    #[must_use]
    pub fn resized<const M: usize>(self) -> Float<M> {
        match self.class {
            Class::Normal => Float::rounded(self.negative, self.exponent, &mut { self.digits }),
            class => Float { class, negative: self.negative, ..Float::ZERO },
        }
    }

    /// ± (digits / 2 to the power of their bits) · 2 to the power of the exponent, rounded to the nearest.
    fn rounded(negative: bool, exponent: i64, digits: &mut [u64]) -> Self {
        let zeros = limbs::leading_zeros(digits);
        if zeros == 64 * digits.len() {
            return Self { negative, ..Self::ZERO };
        }
        limbs::shift_left(digits, zeros);
        let mut exponent = exponent - i64::try_from(zeros).unwrap_or(0);
        let mut kept = [0; N];
        if let Some(dropped) = digits.len().checked_sub(N) {
            kept.copy_from_slice(&digits[dropped..]);
            let half = 1 << 63;
            let (next, rest) = digits[..dropped]
                .split_last()
                .map_or((0, false), |(&next, rest)| (next, rest.iter().any(|&digit| digit != 0)));
            let round_up = next > half || next == half && (rest || kept[0] % 2 == 1);
            if round_up && limbs::add(&mut kept, &[1]) {
                kept[N - 1] = half;
                exponent += 1;
            }
        } else {
            kept[N - digits.len()..].copy_from_slice(digits);
        }
        match exponent {
            MOST_EXPONENT.. => Self { class: Class::Infinite, negative, ..Self::ZERO },
            exponent if exponent < -MOST_EXPONENT => Self { negative, ..Self::ZERO },
            _ => Self { class: Class::Normal, negative, exponent, digits: kept },
        }
    }

    /// Times a power of two, exactly.
    #[must_use]
    pub fn scaled(self, power: i64) -> Self {
        if self.class != Class::Normal {
            return self;
        }
        Self::rounded(self.negative, self.exponent.saturating_add(power), &mut { self.digits })
    }

    /// The magnitude.
    #[must_use]
    pub fn abs(self) -> Self {
        Self { negative: false, ..self }
    }

    /// x = m · 2 to the power of e with ½ ≤ |m| < 1: m and e; none for zero and what is not finite.
    pub(super) fn parts(self) -> Option<(Self, i64)> {
        (self.class == Class::Normal).then_some((Self { exponent: 0, ..self }, self.exponent))
    }

    /// The square root; NaN for negative numbers.
    ///
    /// Newton's method for 1/√m from the root of `f64`, and a last step for √m that makes roots of squares exact.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let Some((fraction, exponent)) = self.parts().filter(|_| !self.negative) else {
            return Self::from_f64(self.stand_in().sqrt());
        };
        let odd = exponent.rem_euclid(2);
        let m = fraction.scaled(odd);
        let mut per_root = Self::from_f64(1.0 / m.to_f64().sqrt());
        // 53 bits, then 106, 212 and 424.
        for _ in 0..3 {
            per_root = per_root + (per_root * (Self::ONE - m * per_root * per_root)).scaled(-1);
        }
        let root = m * per_root;
        let root = root + ((m - root * root) * per_root).scaled(-1);
        root.scaled((exponent - odd) / 2)
    }

    /// Divided by a whole number.
    pub(super) fn divided_by(self, divisor: u64) -> Self {
        if self.class != Class::Normal {
            return self;
        }
        let mut wide = [0; SCRATCH];
        let wide = &mut wide[..=N];
        wide[1..].copy_from_slice(&self.digits);
        let rest = limbs::divide_by_digit(wide, divisor);
        wide[0] |= u64::from(rest != 0);
        Self::rounded(self.negative, self.exponent, wide)
    }

    /// A plain number that is as infinite, undefined, zero or negative as this one.
    fn stand_in(self) -> f64 {
        let size = match self.class {
            Class::Zero => 0.0,
            Class::Normal => 1.0,
            Class::Infinite => f64::INFINITY,
            Class::Undefined => f64::NAN,
        };
        if self.negative { -size } else { size }
    }

    fn are_normal(self, other: Self) -> bool {
        self.class == Class::Normal && other.class == Class::Normal
    }

    fn compare_sizes(&self, other: &Self) -> Ordering {
        self.exponent.cmp(&other.exponent).then_with(|| limbs::compare(&self.digits, &other.digits))
    }

    /// The sum of two numbers that are neither zero nor infinite, |a| ≥ |b|.
    fn sum(a: Self, b: Self) -> Self {
        let ([mut sum, mut other], n) = ([[0; SCRATCH]; 2], N + 1);
        sum[1..n].copy_from_slice(&a.digits);
        other[1..n].copy_from_slice(&b.digits);
        let distance = usize::try_from(a.exponent - b.exponent).unwrap_or(usize::MAX).min(64 * n);
        limbs::shift_right(&mut other[..n], distance);
        let mut exponent = a.exponent;
        if a.negative == b.negative {
            if limbs::add(&mut sum[..n], &other[..n]) {
                limbs::shift_right(&mut sum[..n], 1);
                sum[n - 1] |= 1 << 63;
                exponent += 1;
            }
        } else {
            limbs::subtract(&mut sum[..n], &other[..n]);
        }
        let sum = Self::rounded(a.negative, exponent, &mut sum[..n]);
        if sum.class == Class::Zero { Self::ZERO } else { sum }
    }
}

/// 2 to a power from −1074 to 1023.
fn power_of_two(power: i64) -> f64 {
    let bits = if power >= -1022 { (power + 1023) << 52 } else { 1 << (power + 1074) };
    f64::from_bits(bits.unsigned_abs())
}

impl<const N: usize> Add for Float<N> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        match (self.class, other.class) {
            (Class::Normal, Class::Normal) if self.compare_sizes(&other).is_lt() => Self::sum(other, self),
            (Class::Normal, Class::Normal) => Self::sum(self, other),
            (Class::Normal, Class::Zero) => self,
            (Class::Zero, Class::Normal) => other,
            _ => Self::from_f64(self.stand_in() + other.stand_in()),
        }
    }
}

impl<const N: usize> Neg for Float<N> {
    type Output = Self;

    fn neg(self) -> Self {
        Self { negative: !self.negative, ..self }
    }
}

impl<const N: usize> Sub for Float<N> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<const N: usize> Mul for Float<N> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if !self.are_normal(other) {
            return Self::from_f64(self.stand_in() * other.stand_in());
        }
        let mut product = [0; SCRATCH];
        limbs::multiply(&self.digits, &other.digits, &mut product[..2 * N]);
        Self::rounded(self.negative != other.negative, self.exponent + other.exponent, &mut product[..2 * N])
    }
}

impl<const N: usize> Div for Float<N> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if !self.are_normal(other) {
            return Self::from_f64(self.stand_in() / other.stand_in());
        }
        // One digit more than is kept, so that there is something to round, and one for a quotient above 1.
        let ([mut rest, mut quotient], n) = ([[0; SCRATCH]; 2], N + 2);
        rest[N + 1..=2 * N].copy_from_slice(&self.digits);
        limbs::divide(&mut rest[..2 * N + 2], &other.digits, &mut quotient[..n]);
        quotient[0] |= u64::from(rest.iter().any(|&digit| digit != 0));
        Self::rounded(self.negative != other.negative, self.exponent - other.exponent + 64, &mut quotient[..n])
    }
}

impl<const N: usize> PartialEq for Float<N> {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl<const N: usize> PartialOrd for Float<N> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        if self.are_normal(*other) && self.negative == other.negative {
            let order = self.compare_sizes(other);
            return Some(if self.negative { order.reverse() } else { order });
        }
        self.stand_in().partial_cmp(&other.stand_in())
    }
}

impl Real for Precise {
    /// 2⁻²⁵⁶.
    const UNIT_ROUNDOFF: f64 = DoubleDouble::UNIT_ROUNDOFF * DoubleDouble::UNIT_ROUNDOFF * f64::EPSILON * 4.0;
    const NAME: &'static str = "exact, 77 digits";
    /// About as long as a product takes.
    const F64_OPERATIONS: u64 = 100;
    const ZERO: Self = Self::ZERO;
    const ONE: Self = Self::ONE;

    fn from_f64(x: f64) -> Self {
        Self::from_f64(x)
    }

    fn to_f64(self) -> f64 {
        self.to_f64()
    }

    fn widen(self) -> DoubleDouble {
        let high = self.to_f64();
        if !high.is_finite() {
            return DoubleDouble::from_f64(high);
        }
        DoubleDouble::new(high, (self - Self::from_f64(high)).to_f64())
    }

    fn narrow(wide: DoubleDouble) -> Self {
        let (high, low) = wide.parts();
        Self::from_f64(high) + Self::from_f64(low)
    }

    fn to_exact(self) -> Precise {
        self
    }

    fn from_exact(exact: Precise) -> Self {
        exact
    }

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn abs(self) -> Self {
        self.abs()
    }

    fn pow(self, exponent: Self) -> Self {
        super::precise_power::power(self, exponent)
    }

    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        a * b - c * d
    }
}

#[cfg(test)]
#[path = "precise_tests.rs"]
mod tests;
