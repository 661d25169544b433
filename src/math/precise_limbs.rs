//! Whole numbers of many digits to the base 2⁶⁴, the least significant first.
//!
//! Source: D. E. Knuth, TAOCP vol. 2, § 4.3.1, algorithms A, S, M and D.

use std::cmp::Ordering;

/// The upper and the lower half of a product or sum.
#[expect(clippy::cast_possible_truncation, reason = "the halves are what is asked for")]
const fn halves(wide: u128) -> (u64, u64) {
    ((wide >> 64) as u64, wide as u64)
}

/// Compares numbers of the same length.
pub fn compare(a: &[u64], b: &[u64]) -> Ordering {
    a.iter().rev().cmp(b.iter().rev())
}

/// Adds `b` to the lowest digits of `a`; whether something is carried out of `a`.
pub fn add(a: &mut [u64], b: &[u64]) -> bool {
    let mut carry = 0;
    for (k, digit) in a.iter_mut().enumerate() {
        let sum = u128::from(*digit) + u128::from(b.get(k).copied().unwrap_or(0)) + u128::from(carry);
        (carry, *digit) = halves(sum);
    }
    carry > 0
}

/// Takes `b` away from `a`, which is of the same length and not less.
pub fn subtract(a: &mut [u64], b: &[u64]) {
    let mut borrow = false;
    for (digit, &other) in a.iter_mut().zip(b) {
        let (less, first) = digit.overflowing_sub(other);
        let (less, second) = less.overflowing_sub(u64::from(borrow));
        (*digit, borrow) = (less, first || second);
    }
}

/// How many bits stand before the first that is set.
pub fn leading_zeros(a: &[u64]) -> usize {
    let first = a.iter().rev().position(|&digit| digit != 0);
    first.map_or(64 * a.len(), |k| 64 * k + a[a.len() - 1 - k].leading_zeros() as usize)
}

/// Moves all bits up; those that leave are lost.
pub fn shift_left(a: &mut [u64], by: usize) {
    let (digits, bits) = (by / 64, by % 64);
    for k in (0..a.len()).rev() {
        let digit = |k: usize| k.checked_sub(digits).map_or(0, |k| a[k]);
        let below = if k == 0 || bits == 0 { 0 } else { digit(k - 1) >> (64 - bits) };
        a[k] = digit(k) << bits | below;
    }
}

/// Moves all bits down. If one of those that leave is set, the lowest that stays is set too: what is rounded later thus
/// knows of it.
pub fn shift_right(a: &mut [u64], by: usize) {
    let (digits, bits) = (by / 64, by % 64);
    let whole = digits.min(a.len());
    let lost =
        a[..whole].iter().any(|&digit| digit != 0) || whole < a.len() && bits > 0 && a[whole] << (64 - bits) != 0;
    for k in 0..a.len() {
        let digit = |k: usize| a.get(k).copied().unwrap_or(0);
        let above = if bits == 0 { 0 } else { digit(k + digits + 1) << (64 - bits) };
        a[k] = digit(k + digits) >> bits | above;
    }
    a[0] |= u64::from(lost);
}

/// Adds a · b to `product`, which is as long as both together and zero.
pub fn multiply(a: &[u64], b: &[u64], product: &mut [u64]) {
    for (i, &x) in a.iter().enumerate() {
        let mut carry = 0;
        for (j, &y) in b.iter().enumerate() {
            let sum = u128::from(x) * u128::from(y) + u128::from(product[i + j]) + u128::from(carry);
            (carry, product[i + j]) = halves(sum);
        }
        product[i + b.len()] = carry;
    }
}

/// Divides by a single digit and returns the remainder.
pub fn divide_by_digit(a: &mut [u64], divisor: u64) -> u64 {
    let mut remainder = 0;
    for digit in a.iter_mut().rev() {
        let part = u128::from(remainder) << 64 | u128::from(*digit);
        let quotient = part / u128::from(divisor);
        (*digit, remainder) = (halves(quotient).1, halves(part % u128::from(divisor)).1);
    }
    remainder
}

/// The quotient of `a` by `b`, whose highest bit is set and which has two digits or more; `a` has one digit more than `b`
/// and the quotient together, the highest of which is zero. What is left of `a` is the remainder.
pub fn divide(a: &mut [u64], b: &[u64], quotient: &mut [u64]) {
    let n = b.len();
    let (first, second) = (u128::from(b[n - 1]), u128::from(b[n - 2]));
    for j in (0..quotient.len()).rev() {
        let top = u128::from(a[j + n]) << 64 | u128::from(a[j + n - 1]);
        let (mut guess, mut rest) = (top / first, top % first);
        // At most two too large, and mostly seen here (step D3).
        while guess >> 64 != 0 || guess * second > (rest << 64 | u128::from(a[j + n - 2])) {
            guess -= 1;
            rest += first;
            if rest >> 64 != 0 {
                break;
            }
        }
        let mut digit = halves(guess).1;
        if subtract_multiple(&mut a[j..=j + n], b, digit) {
            // One too large after all (step D6).
            digit -= 1;
            add(&mut a[j..=j + n], b);
        }
        quotient[j] = digit;
    }
}

/// Takes `times` · b away from `a`; whether that was too much, so that what is left is off by 2⁶⁴ to the length of `a`.
fn subtract_multiple(a: &mut [u64], b: &[u64], times: u64) -> bool {
    let (mut carry, mut borrow) = (0, false);
    for (k, digit) in a.iter_mut().enumerate() {
        let multiple = u128::from(times) * u128::from(b.get(k).copied().unwrap_or(0)) + u128::from(carry);
        let low;
        (carry, low) = halves(multiple);
        let (less, one) = digit.overflowing_sub(low);
        let (less, two) = less.overflowing_sub(u64::from(borrow));
        (*digit, borrow) = (less, one || two);
    }
    borrow
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shifts_keep_a_trace_of_what_leaves_below() {
        for (by, expected) in [(0, [2, 0, 12]), (1, [1, 0, 6]), (2, [1, 0, 3]), (66, [1, 3, 0]), (400, [1, 0, 0])] {
            let mut a = [2, 0, 12];
            shift_right(&mut a, by);
            assert_eq!(a, expected, "by {by}");
        }
        let mut a = [3, 1, 0];
        shift_left(&mut a, 65);
        assert_eq!(a, [0, 6, 2]);
        assert_eq!(leading_zeros(&a), 62);
    }

    #[test]
    fn a_quotient_times_its_divisor_and_the_remainder_is_the_dividend() {
        // The divisor that makes the first guess two too large: b = 2¹²⁷ + 2⁶⁴ − 1, a = 2¹²⁷ (2⁶⁴ − 1).
        let b = [u64::MAX, 1 << 63];
        for a in [[0, 1 << 63, (1 << 63) - 1, 0], [u64::MAX; 4].map(|x| x >> 1), [3, 0, u64::MAX, 0]] {
            let (mut rest, mut quotient) = ([a[0], a[1], a[2], 0, 0], [0; 3]);
            divide(&mut rest, &b, &mut quotient);
            let mut product = [0; 5];
            multiply(&quotient, &b, &mut product);
            add(&mut product, &rest);
            assert_eq!(product[..3], a[..3]);
            assert_eq!((compare(&rest[..2], &b), &rest[2..]), (Ordering::Less, &[0, 0, 0][..]));
        }
    }
}
