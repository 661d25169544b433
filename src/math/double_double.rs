//! Numbers of about 32 digits: the unevaluated sum of two `f64`, by error-free transformations.
//!
//! Sources: T. J. Dekker, Numerische Mathematik 18 (1971); D. E. Knuth, TAOCP vol. 2, § 4.2.2; M. Joldeş, J.-M. Muller,
//! V. Popescu, ACM TOMS 44(2), 2017, "Tight and rigorous error bounds for basic building blocks of double-word
//! arithmetic" (the algorithm numbers below are theirs).

use super::{Real, portable};
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `high + low`, where `high` is the nearest `f64` to the sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

/// ln 2 to 106 bits.
const LN_2: DoubleDouble = DoubleDouble { high: std::f64::consts::LN_2, low: 2.319_046_813_846_299_6e-17 };

/// The exact sum of two numbers, as the rounded sum and its error (Knuth).
pub(super) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_in_sum = sum - a;
    (sum, (a - (sum - b_in_sum)) + (b - b_in_sum))
}

/// The exact sum where |a| ≥ |b| or a = 0 (Dekker).
fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// The exact product of two numbers, as the rounded product and its error.
///
/// Dekker's product, unless the processor multiplies and adds in one rounding: in software that is ten times slower.
pub(super) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    if cfg!(target_feature = "fma") {
        return (product, a.mul_add(b, -product));
    }
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    let error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    // The halves of numbers above 2⁹⁹⁶ overflow; so large, the product alone has to do.
    (product, if error.is_finite() { error } else { 0.0 })
}

/// Two halves of at most 26 bits each (Veltkamp).
fn split(a: f64) -> (f64, f64) {
    const FACTOR: f64 = 134_217_729.0; // 2²⁷ + 1
    let scaled = FACTOR * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

impl DoubleDouble {
    /// `high + low`, in normal form.
    #[must_use]
    pub fn new(high: f64, low: f64) -> Self {
        let (high, low) = two_sum(high, low);
        Self { high, low }
    }

    /// The leading `f64` and what is missing from it.
    #[must_use]
    pub const fn parts(self) -> (f64, f64) {
        (self.high, self.low)
    }

    /// eˣ, for results that neither overflow nor underflow.
    ///
    /// x = k ln 2 + 512 r; the Taylor series of eʳ − 1, squared up nine times in the form that keeps its digits.
    fn exponential(self) -> Self {
        const SQUARINGS: i32 = 9;
        let multiples = (self.high / LN_2.high).round();
        let reduced = self - LN_2 * Self::from_f64(multiples);
        let r = reduced.scaled(portable::power_of_two(-SQUARINGS));
        let (mut term, mut sum) = (r, r);
        for k in 2..=10 {
            term = term * r / Self::from_f64(f64::from(k));
            sum = sum + term;
        }
        for _ in 0..SQUARINGS {
            sum = sum + sum + sum * sum;
        }
        let result = Self::ONE + sum;
        // Two steps, for 2ᵏ itself may be subnormal where the result is not.
        #[expect(clippy::cast_possible_truncation, reason = "a whole number of at most four digits")]
        let whole = multiples as i32;
        let half = whole / 2;
        result.scaled(portable::power_of_two(half)).scaled(portable::power_of_two(whole - half))
    }

    /// The natural logarithm of a positive number: one step of Newton's method for exp(y) = x.
    fn logarithm(self) -> Self {
        let start = Self::from_f64(portable::ln(self.high));
        let next = start + self * (-start).exponential() - Self::ONE;
        // The first step leaves the square of an error of 1e-16; near x = 1 that is relative to a small result.
        next + self * (-next).exponential() - Self::ONE
    }

    /// Times a power of two, exactly.
    fn scaled(self, power_of_two: f64) -> Self {
        Self { high: self.high * power_of_two, low: self.low * power_of_two }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    /// Algorithm 6, `AccurateDWPlusDW`: relative error at most 3u².
    fn add(self, other: Self) -> Self {
        let (sum, error) = two_sum(self.high, other.high);
        if !sum.is_finite() {
            return Self::from_f64(sum);
        }
        let (low_sum, low_error) = two_sum(self.low, other.low);
        let (high, low) = fast_two_sum(sum, error + low_sum);
        let (high, low) = fast_two_sum(high, low_error + low);
        Self { high, low }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    /// Algorithm 11, `DWTimesDW2`: relative error at most 5u².
    fn mul(self, other: Self) -> Self {
        let (product, error) = two_product(self.high, other.high);
        if !product.is_finite() {
            return Self::from_f64(product);
        }
        let cross = self.high * other.low + self.low * other.high;
        let (high, low) = fast_two_sum(product, error + (cross + self.low * other.low));
        Self { high, low }
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    /// Long division with two corrections. Infinite and undefined quotients are those of `f64`, and so are those so large
    /// that their products have no error term.
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let has_room = first.abs() < 1e290 && other.high.is_finite();
        if !has_room {
            return Self { high: first, low: 0.0 };
        }
        let rest = self - other * Self::from_f64(first);
        let second = rest.high / other.high;
        let rest = rest - other * Self::from_f64(second);
        let (high, low) = fast_two_sum(first, second);
        Self { high, low } + Self::from_f64(rest.high / other.high)
    }
}

impl PartialOrd for DoubleDouble {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.high.partial_cmp(&other.high) {
            Some(Ordering::Equal) => self.low.partial_cmp(&other.low),
            order => order,
        }
    }
}

impl Real for DoubleDouble {
    /// 2⁻¹⁰³: the worst of the operations above, rounded up.
    const UNIT_ROUNDOFF: f64 = f64::EPSILON * f64::EPSILON * 2.0;
    const NAME: &'static str = "double-double";
    /// A sum takes 20, a product 17 + 9 where it is split by Dekker's method.
    const F64_OPERATIONS: u64 = 23;
    const ZERO: Self = Self { high: 0.0, low: 0.0 };
    const ONE: Self = Self { high: 1.0, low: 0.0 };

    fn from_f64(x: f64) -> Self {
        Self { high: x, low: 0.0 }
    }

    fn to_f64(self) -> f64 {
        self.high
    }

    fn widen(self) -> DoubleDouble {
        self
    }

    fn narrow(wide: DoubleDouble) -> Self {
        wide
    }

    /// Karp's method: the square root in `f64` and one step of Newton's method.
    fn sqrt(self) -> Self {
        let root = self.high.sqrt();
        if root == 0.0 || !root.is_finite() {
            return Self::from_f64(root);
        }
        let (square, error) = two_product(root, root);
        let rest = self - Self { high: square, low: error };
        let (high, low) = fast_two_sum(root, rest.high / (2.0 * root));
        Self { high, low }
    }

    fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    fn pow(self, exponent: Self) -> Self {
        let rough = portable::powf(self.high, exponent.high);
        // At the ends of the range of f64 there is no room for a low part.
        if self.high <= 0.0 || !(1e-280..1e280).contains(&rough) || !self.high.is_normal() {
            return Self::from_f64(rough);
        }
        (exponent * self.logarithm()).exponential()
    }

    fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
        a * b - c * d
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dd(high: f64, low: f64) -> DoubleDouble {
        DoubleDouble::new(high, low)
    }

    fn close(a: DoubleDouble, b: DoubleDouble, relative: f64) {
        let difference = (a - b).to_f64().abs();
        assert!(difference <= relative * b.to_f64().abs(), "{a:?} and {b:?} differ by {difference:e}");
    }

    #[test]
    fn sums_and_products_lose_nothing() {
        assert_eq!(two_sum(1.0, 2.0_f64.powi(-80)), (1.0, 2.0_f64.powi(-80)));
        let x = 1.0 + 2.0_f64.powi(-30);
        assert_eq!(two_product(x, x), (1.0 + 2.0_f64.powi(-29), 2.0_f64.powi(-60)));
    }

    #[test]
    fn a_third_times_three_is_one() {
        let third = DoubleDouble::ONE / DoubleDouble::from_f64(3.0);
        close(third * DoubleDouble::from_f64(3.0), DoubleDouble::ONE, 1e-31);
    }

    #[test]
    fn the_root_of_two_has_thirty_two_digits() {
        // √2 = 1.4142135623730950488016887242096980785696718753769…
        let root = DoubleDouble::from_f64(2.0).sqrt();
        close(root, dd(std::f64::consts::SQRT_2, -9.667_293_313_452_913e-17), 1e-31);
        close(root * root, DoubleDouble::from_f64(2.0), 1e-31);
    }

    #[test]
    fn the_logarithm_of_two_and_the_exponential_of_one_are_right() {
        close(DoubleDouble::from_f64(2.0).logarithm(), LN_2, 1e-30);
        // e = 2.71828182845904523536028747135266249775724709369995…
        close(DoubleDouble::ONE.exponential(), dd(std::f64::consts::E, 1.445_646_891_729_250_2e-16), 1e-30);
    }

    #[test]
    fn powers_agree_with_products_and_roots() {
        let x = dd(1.7, 1e-17);
        close(x.pow(DoubleDouble::from_f64(3.0)), x * x * x, 1e-29);
        close(x.pow(DoubleDouble::from_f64(0.5)), x.sqrt(), 1e-30);
        close(dd(1e-9, 0.0).pow(DoubleDouble::from_f64(0.5)), dd(1e-9, 0.0).sqrt(), 1e-28);
        assert_eq!(DoubleDouble::ZERO.pow(DoubleDouble::from_f64(0.3)), DoubleDouble::ZERO);
        assert_eq!(DoubleDouble::ONE.pow(DoubleDouble::from_f64(1e6)), DoubleDouble::ONE);
    }

    #[test]
    fn what_is_too_large_is_infinite_and_nothing_else() {
        let large = DoubleDouble::from_f64(1e300);
        assert_eq!((large * large).to_f64(), f64::INFINITY);
        assert_eq!((large + large).to_f64(), 2e300);
        assert_eq!((DoubleDouble::ONE / DoubleDouble::from_f64(1e-305)).to_f64(), 1e305);
        let infinite = DoubleDouble::from_f64(f64::INFINITY);
        assert_eq!((infinite + large).to_f64(), f64::INFINITY);
        assert_eq!((infinite * large).to_f64(), f64::INFINITY);
    }

    #[test]
    fn division_by_zero_is_that_of_f64() {
        assert_eq!((DoubleDouble::ONE / DoubleDouble::ZERO).to_f64(), f64::INFINITY);
        assert!((DoubleDouble::ZERO / DoubleDouble::ZERO).to_f64().is_nan());
    }
}
