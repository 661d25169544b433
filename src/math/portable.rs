//! Sines, logarithms, powers and their like, with the same bits on every machine.
//!
//! Sums, products, quotients, square roots and roundings are exact by IEEE 754, and therefore the same everywhere. What `std`
//! offers beyond these (`f64::sin`, `f64::powf`, …) comes from the system's library: another one on each system, and with glibc
//! another one on each processor, for it has a variant with fused products. Pictures and records would differ in their last
//! digits. So these functions are taken from the crate `libm`, which is made of sums and products alone. They are called by the
//! names of `std`; `tests/architecture.rs` sees to it that those of `std` are not called.
//!
//! Where a function is asked so often that it shows in the time of a picture, [`exp`](super::exp()), [`ln`](super::ln()),
//! [`power`](super::power) and [`sine_cosine`](super::sine_cosine) are shorter ones, which are just as portable. There are none for
//! `f32`: the nearest `f32` to the result in `f64` is more accurate, and takes no longer.
//!
//! Accuracy: errors below one unit in the last place, of [`log10`] and [`asinh`] below two.
//!
//! Source: `libm` 0.2, a port of the library of musl, which has them from msun (FreeBSD) and that from fdlibm 5.3 (Sun Microsystems,
//! 1993); the cubic root is that of CORE-MATH (A. Sibidanov, P. Zimmermann, 2022), which is rounded correctly.

/// sin x.
#[must_use]
pub fn sin(x: f64) -> f64 {
    libm::sin(x)
}

/// cos x.
#[must_use]
pub fn cos(x: f64) -> f64 {
    libm::cos(x)
}

/// sin x and cos x, each as it is by itself.
#[must_use]
pub fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

/// tan x.
#[must_use]
pub fn tan(x: f64) -> f64 {
    libm::tan(x)
}

/// The angle from −π/2 to π/2 with this sine; NaN where there is none.
#[must_use]
pub fn asin(x: f64) -> f64 {
    libm::asin(x)
}

/// The angle from 0 to π with this cosine; NaN where there is none.
#[must_use]
pub fn acos(x: f64) -> f64 {
    libm::acos(x)
}

/// The angle from −π/2 to π/2 with this tangent.
#[must_use]
pub fn atan(x: f64) -> f64 {
    libm::atan(x)
}

/// The angle from −π to π of the point (x, y), seen from the x axis.
#[must_use]
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// √(x² + y²), however large or small they are.
#[must_use]
pub fn hypot(x: f64, y: f64) -> f64 {
    libm::hypot(x, y)
}

/// eˣ.
#[must_use]
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// eˣ − 1, with all its digits where x is small.
#[must_use]
pub fn exp_m1(x: f64) -> f64 {
    libm::expm1(x)
}

/// The natural logarithm.
#[must_use]
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// The logarithm to base 2; that of a power of two is exact.
#[must_use]
pub fn log2(x: f64) -> f64 {
    libm::log2(x)
}

/// The logarithm to base 10; that of the nearest number to a power of ten is exact.
#[must_use]
pub fn log10(x: f64) -> f64 {
    libm::log10(x)
}

/// The number with this hyperbolic sine: like ±ln 2|x| for large x, like x for small.
#[must_use]
pub fn asinh(x: f64) -> f64 {
    libm::asinh(x)
}

/// ∛x.
#[must_use]
pub fn cbrt(x: f64) -> f64 {
    libm::cbrt(x)
}

/// xᵖ for a real exponent.
#[must_use]
pub fn powf(x: f64, p: f64) -> f64 {
    libm::pow(x, p)
}

/// xⁿ for a whole exponent, by squaring from the exponent's lowest digit on; for a negative one 1 / x⁻ⁿ.
///
/// The order of the products is fixed here, where that of `f64::powi` is left to the compiler.
#[must_use]
#[inline]
pub fn powi(x: f64, n: i32) -> f64 {
    let (mut square, mut left, mut product) = (x, n.unsigned_abs(), 1.0);
    while left > 0 {
        if left % 2 == 1 {
            product *= square;
        }
        square *= square;
        left /= 2;
    }
    if n < 0 { 1.0 / product } else { product }
}

/// 10ⁿ for a whole number as the rounding functions return it. Exact from 0 to 22 and the nearest number from −22 on, so that
/// 10⁻¹ is the 0.1 that people write.
#[must_use]
pub fn power_of_ten(n: f64) -> f64 {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "a whole number; far beyond ±400 the power is infinite or 0 anyway"
    )]
    powi(10.0, n as i32)
}

/// 2ⁿ: infinite above 2¹⁰²³, 0 below 2⁻¹⁰⁷⁴, exact between.
#[must_use]
pub fn power_of_two(n: i32) -> f64 {
    let biased = |n: i32| f64::from_bits(u64::from(n.clamp(0, 0x7ff).unsigned_abs()) << 52);
    match n {
        -1074..-1022 => f64::from_bits(1 << (n + 1074)),
        _ => biased(n.saturating_add(1023)),
    }
}

#[cfg(test)]
mod tests;
