//! Powers of [`Precise`] numbers: logarithm and exponential function with 64 bits to spare.
//!
//! Source: R. P. Brent, P. Zimmermann, Modern Computer Arithmetic (2010), § 4.3 (reduction of the argument) and § 4.4.2
//! (power series).

use super::portable;
use super::precise::{Float, Precise};
use std::f64::consts;

/// With 64 bits more than what is asked for: the squarings below lose 16 of them, large exponents 10 or so.
type Wide = Float<5>;

/// ln 2 to 320 bits.
const LN_2: Wide = Float::fraction([
    0xe7b8_7620_6deb_ac98,
    0x8a0d_175b_8baa_fa2b,
    0x40f3_4326_7298_b62d,
    0xc9e3_b398_03f2_f6af,
    0xb172_17f7_d1cf_79ab,
]);

/// How often eʳ − 1 is squared up. Fewer need more terms of the series, more lose more bits.
const SQUARINGS: u8 = 16;

/// Terms of the series of eʳ − 1: with |r| < 2⁻¹⁷ the next one is below 2⁻³²⁰ of the first.
const TERMS: u64 = 17;

/// A non-negative number to a real power. Zero, infinite and undefined numbers go as with `f64`.
pub fn power(x: Precise, exponent: Precise) -> Precise {
    if x == Precise::ONE {
        return x;
    }
    let wide = x.resized::<5>();
    match (wide.parts(), exponent.resized::<5>().parts()) {
        (Some(_), Some(_)) if x > Precise::ZERO => exp(exponent.resized() * ln(wide)).resized(),
        _ => Precise::from_f64(portable::powf(x.to_f64(), exponent.to_f64())),
    }
}

/// eˣ: x = k ln 2 + 2¹⁶ r, the series of eʳ − 1, squared up in the form that keeps its digits.
fn exp(x: Wide) -> Wide {
    let multiples = (x.to_f64() * consts::LOG2_E).round();
    if multiples.abs() > 1e13 {
        return if multiples > 0.0 { Wide::from_f64(f64::INFINITY) } else { Wide::ZERO };
    }
    let r = (x - LN_2 * Wide::from_f64(multiples)).scaled(-i64::from(SQUARINGS));
    let (mut term, mut sum) = (r, r);
    for k in 2..=TERMS {
        term = (term * r).divided_by(k);
        sum = sum + term;
    }
    for _ in 0..SQUARINGS {
        sum = sum.scaled(1) + sum * sum;
    }
    #[expect(clippy::cast_possible_truncation, reason = "a whole number below 10¹³")]
    let power = multiples as i64;
    (Wide::ONE + sum).scaled(power)
}

/// ln x for x > 0: two steps of Halley's method for exp(y) = m, where x = m 2ᵉ. Each step multiplies the digits by three.
fn ln(x: Wide) -> Wide {
    let Some((mut m, mut exponent)) = x.parts() else { return Wide::from_f64(portable::ln(x.to_f64())) };
    if m.to_f64() < consts::FRAC_1_SQRT_2 {
        m = m.scaled(1);
        exponent -= 1;
    }
    let mut y = Wide::from_f64(portable::ln(m.to_f64()));
    for _ in 0..2 {
        let reached = exp(y);
        y = y + ((m - reached) / (m + reached)).scaled(1);
    }
    // Exponents are far below 2⁵³.
    y + LN_2 * Wide::from_f64(exponent as f64)
}
