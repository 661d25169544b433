//! Logarithm, exponential and power of plain numbers, short enough to be put in place and run side by side.
//!
//! The library's own power takes three times as long, for it has to be right in the last digit of results of any size. A
//! surface asks for powers up to about 1, where the error of exp(p ln x), in proportion to |ln xᵖ|, does no harm. Being
//! sums and products, they also come out the same on every machine.
//!
//! Source: the approximations of `e_log.c` and `e_exp.c` in fdlibm 5.3 (K. C. Ng, Sun Microsystems, 1993): errors below one
//! unit in the last place.

const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;

/// ln x for normal positive numbers.
#[inline]
#[must_use]
pub fn ln(x: f64) -> f64 {
    // x = 2ᵏ (1 + f) with 1 + f from √½ to √2: the constant is the difference of the bits of 1 and of √½.
    const ONE: u64 = 0x3ff0_0000_0000_0000;
    const ROOT_OF_HALF: u64 = 0x3fe6_a09e_0000_0000;
    let bits = x.to_bits().wrapping_add(ONE - ROOT_OF_HALF);
    let k = ((bits >> 52) as i32 - 1023).into();
    let f = f64::from_bits((bits & 0x000f_ffff_ffff_ffff) + ROOT_OF_HALF) - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    let w = z * z;
    let even = w * (3.999_999_999_940_942e-1 + w * (2.222_219_843_214_978_4e-1 + w * 1.531_383_769_920_937_3e-1));
    let odd = z
        * (6.666_666_666_666_735e-1
            + w * (2.857_142_874_366_239e-1 + w * (1.818_357_216_161_805e-1 + w * 1.479_819_860_511_658_6e-1)));
    let half_square = 0.5 * f * f;
    let low: f64 = k;
    k * LN_2_HIGH - ((half_square - (s * (half_square + (even + odd)) + low * LN_2_LOW)) - f)
}

/// eˣ for x up to 700; 0 below −700.
#[inline]
#[must_use]
pub fn exp(x: f64) -> f64 {
    // Adding 1.5 · 2⁵² rounds to a whole number, whose bits then stand at the end.
    const ROUNDER: f64 = 6_755_399_441_055_744.0;
    let x = x.min(700.0);
    let rounded = x * std::f64::consts::LOG2_E + ROUNDER;
    let k = rounded - ROUNDER;
    let (high, low) = (x - k * LN_2_HIGH, k * LN_2_LOW);
    let r = high - low;
    let t = r * r;
    let c = r - t
        * (1.666_666_666_666_660_2e-1
            + t * (-2.777_777_777_701_559_3e-3
                + t * (6.613_756_321_437_934e-5 + t * (-1.653_390_220_546_525_2e-6 + t * 4.138_136_797_057_238_5e-8))));
    let mantissa = 1.0 - ((low - (r * c) / (2.0 - c)) - high);
    let power_of_two = f64::from_bits(rounded.to_bits().wrapping_add(1023) << 52);
    if x < -700.0 { 0.0 } else { mantissa * power_of_two }
}

/// xᵖ for x ≥ 0, with an error of about u (1 + 2 |ln xᵖ|) xᵖ; up to e⁷⁰⁰ at most.
#[inline]
pub fn power(x: f64, p: f64) -> f64 {
    if x >= f64::MIN_POSITIVE { exp(p * ln(x)) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const ULP: f64 = f64::EPSILON;

    #[test]
    fn one_and_zero_are_exact() {
        assert_eq!((ln(1.0), exp(0.0), power(1.0, 1e6), power(0.0, 0.05)), (0.0, 1.0, 1.0, 0.0));
    }

    #[test]
    fn what_is_too_small_is_zero_and_nothing_else() {
        assert_eq!((exp(-1e6), power(1e-300, 50.0)), (0.0, 0.0));
        assert!(exp(-699.0) > 0.0 && exp(1e9).is_finite());
    }

    proptest! {
        #[test]
        fn both_agree_with_the_library_within_two_units(x in -690.0..690.0_f64) {
            let expected = x.exp();
            prop_assert!((exp(x) - expected).abs() <= 2.0 * ULP * expected);
            let back = ln(expected);
            prop_assert!((back - expected.ln()).abs() <= 2.0 * ULP * back.abs());
        }

        #[test]
        fn logarithms_near_one_keep_their_digits(x in 0.5..2.0_f64) {
            prop_assert!((ln(x) - x.ln()).abs() <= 2.0 * ULP * x.ln().abs());
        }

        #[test]
        fn powers_up_to_one_are_right_within_two_roundings_of_one(x in 0.0..1.0_f64, p in 0.05..1000.0_f64) {
            prop_assert!((power(x, p) - x.powf(p)).abs() <= ULP);
        }
    }
}
