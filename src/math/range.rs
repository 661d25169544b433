//! Ranges of numbers that are sure to hold the true value: interval arithmetic, rounded outwards.
//!
//! Neither Rust nor WebAssembly can set the direction of rounding, so every end is moved out by one step after a
//! correctly rounded operation (Moore, Kearfott, Cloud, Introduction to Interval Analysis, SIAM 2009, ch. 2).

use std::ops::{Add, Mul};

/// All numbers from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The smallest.
    pub low: f64,
    /// The largest.
    pub high: f64,
}

impl Range {
    /// From `a` to `b`, in either order. What is undefined may be anything.
    #[must_use]
    pub fn between(a: f64, b: f64) -> Self {
        if a.is_nan() || b.is_nan() {
            return Self { low: f64::NEG_INFINITY, high: f64::INFINITY };
        }
        Self { low: a.min(b), high: a.max(b) }
    }

    /// Moved out at both ends by a share of their size.
    #[must_use]
    pub fn widened(self, share: f64) -> Self {
        Self { low: self.low - self.low.abs() * share, high: self.high + self.high.abs() * share }.stepped_out()
    }

    /// Whether every number in it is above zero.
    #[must_use]
    pub fn is_positive(self) -> bool {
        self.low > 0.0
    }

    /// Whether every number in it is below zero.
    #[must_use]
    pub fn is_negative(self) -> bool {
        self.high < 0.0
    }

    /// Whether no number in it is above zero, or none below.
    #[must_use]
    pub fn keeps_sign(self) -> bool {
        self.low >= 0.0 || self.high <= 0.0
    }

    fn stepped_out(self) -> Self {
        Self { low: self.low.next_down(), high: self.high.next_up() }
    }
}

impl Add for Range {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let low = self.low + other.low;
        let high = self.high + other.high;
        // ∞ − ∞ says nothing about that end.
        let low = if low.is_nan() { f64::NEG_INFINITY } else { low };
        let high = if high.is_nan() { f64::INFINITY } else { high };
        Self { low, high }.stepped_out()
    }
}

impl Mul for Range {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        // Zero times infinity is zero here: the ends are bounds of finite numbers.
        let product = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * b };
        let ends = [
            product(self.low, other.low),
            product(self.low, other.high),
            product(self.high, other.low),
            product(self.high, other.high),
        ];
        let exact_zero = ends.iter().all(|&end| end == 0.0);
        let low = ends.iter().copied().fold(f64::INFINITY, f64::min);
        let high = ends.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if exact_zero { Self { low, high } } else { Self { low, high }.stepped_out() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn signs_are_told_only_when_they_are_sure() {
        assert!(Range::between(1.0, 2.0).is_positive());
        assert!(Range::between(-1.0, -2.0).is_negative());
        assert!(!Range::between(-1.0, 2.0).keeps_sign());
        assert!(!Range::between(f64::NAN, 2.0).keeps_sign());
    }

    proptest! {
        #[test]
        fn sums_and_products_of_members_are_members(
            a in -1e3..1e3_f64, b in -1e3..1e3_f64, c in -1e3..1e3_f64, d in -1e3..1e3_f64, s in 0.0..=1.0_f64, t in 0.0..=1.0_f64,
        ) {
            let (first, second) = (Range::between(a, b), Range::between(c, d));
            let x = (first.low + (first.high - first.low) * s).clamp(first.low, first.high);
            let y = (second.low + (second.high - second.low) * t).clamp(second.low, second.high);
            let (sum, product) = (first + second, first * second);
            prop_assert!(sum.low <= x + y && x + y <= sum.high);
            prop_assert!(product.low <= x * y && x * y <= product.high);
        }
    }
}
