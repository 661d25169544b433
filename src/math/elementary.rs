//! Logarithm, exponential, power, sine and cosine of plain numbers, short enough to be put in place and run side by side.
//!
//! The power of [`portable`](super::portable) takes several times as long, for it has to be right in the last digit of
//! results of any size. A surface asks for powers up to about 1, where the error of exp(p ln x), in proportion to |ln xᵖ|,
//! does no harm. Being sums and products, they also come out the same on every machine.
//!
//! Source: the approximations of `e_log.c`, `e_exp.c`, `k_sin.c`, `k_cos.c` and `e_rem_pio2.c` in fdlibm 5.3 (K. C. Ng, Sun
//! Microsystems, 1993): errors below one unit in the last place.

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

/// Adding 1.5 · 2⁵² rounds to a whole number, whose bits then stand at the end.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// eˣ for x up to 700; 0 below −700.
#[inline]
#[must_use]
pub fn exp(x: f64) -> f64 {
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
#[must_use]
pub fn power(x: f64, p: f64) -> f64 {
    if x >= f64::MIN_POSITIVE { exp(p * ln(x)) } else { 0.0 }
}

/// π/2 in four pieces. Of the first three each has 33 bits, so that its product with a number of 20 bits is exact.
const HALF_PI: [f64; 4] =
    [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_711_166_5e-21, 8.478_427_660_368_9e-32];

/// sin x and cos x, with errors below two units in the last place for |x| up to 10⁶.
///
/// Further out the period that is used is the `f64` nearest to 2π, which is off by 2 · 10⁻¹⁶.
#[inline]
#[must_use]
pub fn sine_cosine(x: f64) -> (f64, f64) {
    const FAR: f64 = 1_048_576.0;
    let x = if x.abs() < FAR { x } else { x % std::f64::consts::TAU };
    let rounded = x * std::f64::consts::FRAC_2_PI + ROUNDER;
    let n = rounded - ROUNDER;
    // x − n π/2 piece by piece, keeping what the sums round off: x may lie next to a multiple of π/2.
    let (first, lost) = two_sum(x - n * HALF_PI[0], -(n * HALF_PI[1]));
    let (second, lost_again) = two_sum(first, -(n * HALF_PI[2]));
    let tail = (lost + lost_again) - n * HALF_PI[3];
    let r = second + tail;
    let low = (second - r) + tail;
    let (sine, cosine) = (sine_near_zero(r, low), cosine_near_zero(r, low));
    // By quarter turns: (s, c), (c, −s), (−s, −c), (−c, s). Without branches, which would be guessed wrong for every other angle.
    let quarters = rounded.to_bits();
    let (sine, cosine) = if quarters & 1 == 0 { (sine, cosine) } else { (cosine, sine) };
    (negated_if(quarters & 2, sine), negated_if(quarters.wrapping_add(1) & 2, cosine))
}

/// The number, with its sign turned where the second bit is set; no other may be.
#[inline]
fn negated_if(second_bit: u64, x: f64) -> f64 {
    f64::from_bits(x.to_bits() ^ second_bit << 62)
}

/// The same for |x| up to π/4, in less time.
#[inline]
#[must_use]
pub fn sine_cosine_of_eighth(x: f64) -> (f64, f64) {
    (sine_near_zero(x, 0.0), cosine_near_zero(x, 0.0))
}

/// The rounded sum of two numbers, and what was rounded off (Knuth).
#[inline]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_in_sum = sum - a;
    (sum, (a - (sum - b_in_sum)) + (b - b_in_sum))
}

/// sin(x + low) for |x| up to π/4.
#[inline]
fn sine_near_zero(x: f64, low: f64) -> f64 {
    let z = x * x;
    let cube = z * x;
    let r = 8.333_333_333_322_49e-3
        + z * (-1.984_126_982_985_795e-4
            + z * (2.755_731_370_707_006_8e-6 + z * (-2.505_076_025_340_686_3e-8 + z * 1.589_690_995_211_55e-10)));
    x - ((z * (0.5 * low - cube * r) - low) + cube * 1.666_666_666_666_663_2e-1)
}

/// cos(x + low) for |x| up to π/4.
#[inline]
fn cosine_near_zero(x: f64, low: f64) -> f64 {
    let z = x * x;
    let r = z
        * (4.166_666_666_666_66e-2
            + z * (-1.388_888_888_887_411e-3
                + z * (2.480_158_728_947_673e-5
                    + z * (-2.755_731_435_139_066_3e-7
                        + z * (2.087_572_321_298_175e-9 + z * -1.135_964_755_778_819_5e-11)))));
    let half = 0.5 * z;
    let near = 1.0 - half;
    near + (((1.0 - near) - half) + (z * r - x * low))
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

        #[test]
        fn sines_agree_with_the_library_within_two_units(x in -1e6..1e6_f64, near in -600_000_i32..600_000, by in -60..0_i32) {
            // Anywhere, next to a multiple of π/2, and small.
            let beside = f64::from(near) * std::f64::consts::FRAC_PI_2;
            for x in [x, beside, beside.next_up(), beside + 2.0_f64.powi(by), 2.0_f64.powi(by)] {
                let (sine, cosine) = sine_cosine(x);
                let (expected_sine, expected_cosine) = x.sin_cos();
                prop_assert!((sine - expected_sine).abs() <= 2.0 * ULP * expected_sine.abs(), "sin {x} = {sine}");
                prop_assert!((cosine - expected_cosine).abs() <= 2.0 * ULP * expected_cosine.abs(), "cos {x} = {cosine}");
            }
        }
    }

    #[test]
    fn sines_of_any_number_stay_within_one() {
        assert_eq!(sine_cosine(0.0), (0.0, 1.0));
        for x in [1e7, -1e15, 1e300, f64::MAX, f64::MIN_POSITIVE] {
            let (sine, cosine) = sine_cosine(x);
            assert!((sine.hypot(cosine) - 1.0).abs() < 1e-15, "{x}");
        }
        assert!(sine_cosine(f64::NAN).0.is_nan() && sine_cosine(f64::INFINITY).1.is_nan());
    }
}
