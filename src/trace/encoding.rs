//! Colours as bytes, by the curve of sRGB (IEC 61966-2-1).

use crate::math::{DoubleDouble, Real};
use crate::scene::Rgb;
use std::sync::LazyLock;

/// Linear RGB, clamped to [0, 1], as sRGB bytes.
#[must_use]
pub fn srgb(linear: Rgb) -> [u8; 3] {
    let least = &*LEAST;
    linear.to_array().map(|channel| {
        // Those that the channel reaches come first, and there are as many as its byte says. NaN reaches none.
        let byte = least.partition_point(|least| channel >= *least);
        #[expect(clippy::cast_possible_truncation, reason = "there are 255")]
        let byte = byte as u8;
        byte
    })
}

/// For each byte from 1 on the least channel that is stored as it. Looking a channel up among these takes a fraction of the time of
/// a power, and rounds correctly however the power would have been rounded.
static LEAST: LazyLock<[f64; 255]> = LazyLock::new(|| std::array::from_fn(|index| least(index as f64 + 1.0)));

/// The least linear value that is stored as a byte: there the curve is half a step below it.
fn least(byte: f64) -> f64 {
    // The decimals of the standard, with 32 digits.
    let ratio =
        |numerator: f64, denominator: f64| DoubleDouble::from_f64(numerator) / DoubleDouble::from_f64(denominator);
    let stored = ratio(byte - 0.5, 255.0);
    let linear = if stored <= ratio(4_045.0, 100_000.0) {
        stored / ratio(1_292.0, 100.0)
    } else {
        ((stored + ratio(55.0, 1_000.0)) / ratio(1_055.0, 1_000.0)).pow(ratio(24.0, 10.0))
    };
    let (high, low) = linear.parts();
    if low > 0.0 { high.next_up() } else { high }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Precise;
    use proptest::prelude::*;

    #[test]
    fn srgb_bytes_are_those_of_the_standard() {
        assert_eq!(srgb(Rgb::ZERO), [0, 0, 0]);
        assert_eq!(srgb(Rgb::ONE), [255, 255, 255]);
        assert_eq!(srgb(Rgb::new(0.5, 0.214_041, 0.002)), [188, 127, 7]);
        assert_eq!(srgb(Rgb::new(-1.0, 2.0, f64::INFINITY)), [0, 255, 255]);
        assert_eq!(srgb(Rgb::new(f64::NAN, f64::NEG_INFINITY, -0.0)), [0, 0, 0]);
    }

    /// 255 times the curve, with 77 digits.
    fn curve(linear: f64) -> Precise {
        let ratio = |a: f64, b: f64| Precise::from_f64(a) / Precise::from_f64(b);
        let linear = Precise::from_f64(linear);
        let stored = if linear <= ratio(31_308.0, 1e7) {
            linear * ratio(1_292.0, 100.0)
        } else {
            linear.pow(ratio(10.0, 24.0)) * ratio(1_055.0, 1_000.0) - ratio(55.0, 1_000.0)
        };
        stored * Precise::from_f64(255.0)
    }

    #[test]
    fn each_byte_begins_where_the_exact_curve_reaches_half_a_step_below_it() {
        for (index, &least) in LEAST.iter().enumerate() {
            let middle = Precise::from_f64(index as f64 + 0.5);
            assert!(curve(least) >= middle && curve(least.next_down()) < middle, "byte {}", index + 1);
        }
    }

    proptest! {
        #[test]
        fn bytes_are_those_of_the_formula(channel in 0.0..1.0_f64) {
            let stored = if channel <= 0.003_130_8 { 12.92 * channel } else { 1.055 * channel.powf(1.0 / 2.4) - 0.055 };
            prop_assert_eq!(f64::from(srgb(Rgb::splat(channel))[0]), (255.0 * stored).round());
        }
    }
}
