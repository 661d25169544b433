//! [`Precise`] against a library for numbers of any size.

use super::{Class, Float, Precise};
use crate::math::{DoubleDouble, Real};
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use proptest::prelude::*;

type Big = FBig<HalfEven, 2>;

/// More bits than any sum of two numbers here can have.
const BITS: usize = 4_000;
/// For what goes on without end.
const ENOUGH: usize = 700;

fn big(x: f64) -> Big {
    Big::try_from(x).unwrap().with_precision(BITS).value()
}

fn shifted(x: Big, power: i64) -> Big {
    x << isize::try_from(power).unwrap()
}

/// The same number.
fn exactly<const N: usize>(x: Float<N>) -> Big {
    if x.class == Class::Zero {
        return big(0.0);
    }
    assert_eq!(x.class, Class::Normal);
    let half = |digit: u64| big((digit >> 32) as f64) * big(4_294_967_296.0) + big((digit & 0xffff_ffff) as f64);
    let whole = x.digits.iter().rev().fold(big(0.0), |sum, &digit| shifted(sum, 64) + half(digit));
    let size = shifted(whole, x.exponent - 64 * i64::try_from(N).unwrap());
    if x.negative { -size } else { size }
}

/// Half a unit in the last place.
fn half_unit(x: Precise) -> Big {
    if x.class == Class::Zero { big(0.0) } else { shifted(big(1.0), x.exponent - 257) }
}

fn size(x: Big) -> Big {
    if x < big(0.0) { -x } else { x }
}

/// Whether a number is the nearest one to the exact result, or as many half units away at most.
fn assert_near(found: Precise, exact: &Big, half_units: f64, what: &str) {
    let off = size(exactly(found) - exact);
    assert!(off <= half_unit(found) * big(half_units), "{what}: {found:?}");
}

/// Numbers that are hard to round: with long runs of ones and zeros, far apart in size, and full of digits.
fn nasty() -> Vec<Precise> {
    let plain = [1.0, -1.0, 3.0, 0.1, 1e300, -1e-300, f64::MIN_POSITIVE, 5e-324, f64::MAX, 1.0 - f64::EPSILON / 2.0];
    let plain = plain.map(Precise::from_f64);
    let one = Precise::ONE;
    let last = one.scaled(-255);
    let made = [one + last, one - last.scaled(-1), one + one.scaled(-128), one / plain[2], plain[2].sqrt(), last];
    let wide = [one.scaled(5_000) / plain[2], one.scaled(-5_000), -(one - one.scaled(-200))];
    plain.into_iter().chain(made).chain(wide).collect()
}

#[test]
fn sums_products_and_quotients_of_nasty_numbers_are_rounded_to_the_nearest() {
    for a in nasty() {
        for b in nasty() {
            // Sums of numbers that are further apart than the digits that are compared with: the larger one.
            let apart = (a.exponent - b.exponent).abs();
            if apart < 3_000 {
                assert_near(a + b, &(exactly(a) + exactly(b)), 1.0, "sum");
                assert_near(a - b, &(exactly(a) - exactly(b)), 1.0, "difference");
            } else {
                assert!(a + b == a || a + b == b);
            }
            assert_near(a * b, &(exactly(a) * exactly(b)), 1.0, "product");
            let quotient = a / b;
            let rest = size(exactly(quotient) * exactly(b) - exactly(a));
            assert!(rest <= half_unit(quotient) * size(exactly(b)), "quotient {quotient:?}");
        }
    }
}

#[test]
fn square_roots_of_nasty_numbers_are_right_and_those_of_squares_exact() {
    for a in nasty() {
        let a = a.abs();
        assert_near(a.sqrt(), &exactly(a).with_precision(ENOUGH).value().sqrt(), 2.0, "root");
        let short = Precise::from_f64(a.to_f64());
        assert!(short.class != Class::Normal || (short * short).sqrt() == short, "{short:?}");
    }
}

#[test]
fn logarithms_and_powers_at_hard_places_are_right() {
    let bases =
        [2.0, 0.5, 0.1, 1.0 + f64::EPSILON, 1.0 - f64::EPSILON, 1e-300, 1e300, 7.25, std::f64::consts::FRAC_1_SQRT_2];
    for base in bases {
        for exponent in [0.5, 1.0 / 3.0, 2.0, -3.5, 16.0, 1e-9, 60.0] {
            let found = Precise::from_f64(base).pow(Precise::from_f64(exponent));
            let exact = big(base).with_precision(ENOUGH).value().powf(&big(exponent).with_precision(ENOUGH).value());
            assert_near(found, &exact, 2.0, &format!("{base}^{exponent}"));
        }
    }
    assert_eq!(Precise::from_f64(4.0).pow(Precise::from_f64(0.5)), Precise::from_f64(2.0));
}

#[test]
fn every_f64_comes_back_as_it_went_in() {
    let plain = [0.0, -0.0, 1.0, 0.1, 5e-324, -5e-324, f64::MIN_POSITIVE, 2.5e-310, f64::MAX, f64::INFINITY];
    for x in plain {
        assert_eq!(Precise::from_f64(x).to_f64().to_bits(), x.to_bits(), "{x:e}");
    }
    assert!(Precise::from_f64(f64::NAN).to_f64().is_nan());
}

#[test]
fn numbers_between_two_f64_go_to_the_nearer_and_half_way_to_the_even_one() {
    let (one, ulp) = (Precise::ONE, Precise::from_f64(f64::EPSILON));
    assert_eq!((one + ulp.scaled(-1)).to_f64(), 1.0);
    assert_eq!((one + ulp.scaled(-1) + ulp.scaled(-150)).to_f64(), 1.0 + f64::EPSILON);
    assert_eq!((one + ulp + ulp.scaled(-1)).to_f64(), 1.0 + 2.0 * f64::EPSILON);
    let least = Precise::from_f64(5e-324);
    assert_eq!(least.scaled(-1).to_f64(), 0.0);
    assert_eq!((least.scaled(-1) + least.scaled(-200)).to_f64(), 5e-324);
    assert_eq!((least + least.scaled(-1)).to_f64(), 1e-323);
    assert_eq!(Precise::from_f64(f64::MAX).scaled(1).to_f64(), f64::INFINITY);
    assert_eq!(least.scaled(-3_000).to_f64(), 0.0);
}

#[test]
fn what_is_no_number_goes_as_with_f64() {
    let plain = [0.0, -0.0, 1.0, -2.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
    let same = |exact: Precise, plain: f64| {
        assert!(
            exact.to_f64().to_bits() == plain.to_bits() || exact.to_f64().is_nan() && plain.is_nan(),
            "{exact:?} {plain}"
        );
    };
    for a in plain {
        for b in plain {
            let (p, q) = (Precise::from_f64(a), Precise::from_f64(b));
            same(p + q, a + b);
            same(p - q, a - b);
            same(p * q, a * b);
            same(p / q, a / b);
            assert_eq!(p.partial_cmp(&q), a.partial_cmp(&b), "{a} {b}");
        }
        same(Precise::from_f64(a).abs(), a.abs());
        same(Precise::from_f64(a).pow(Precise::from_f64(2.0)), a.powf(2.0));
        if a >= 0.0 && a != 1.0 {
            same(Precise::from_f64(a).sqrt(), a.sqrt());
        }
    }
    assert!(Precise::from_f64(-2.0).sqrt().to_f64().is_nan());
}

#[test]
fn what_is_too_large_is_infinite_and_what_is_too_small_is_zero() {
    let mut x = Precise::from_f64(2.0);
    for _ in 0..100 {
        x = x * x;
    }
    assert_eq!(x.to_f64(), f64::INFINITY);
    assert_eq!((Precise::ONE / x).to_f64(), 0.0);
    assert_eq!(Precise::from_f64(1e300).pow(Precise::from_f64(1e300)).to_f64(), f64::INFINITY);
    assert_eq!(Precise::from_f64(1e300).pow(Precise::from_f64(-1e300)).to_f64(), 0.0);
}

#[test]
fn thirty_two_digits_come_back_as_they_went_in() {
    let third = DoubleDouble::ONE / DoubleDouble::from_f64(3.0);
    assert_eq!(third.to_exact().widen(), third);
    assert_eq!(Precise::UNIT_ROUNDOFF, 2.0_f64.powi(-256));
}

fn any_size() -> impl Strategy<Value = f64> {
    (-1.0..1.0_f64, -300..300).prop_map(|(x, power)| x * 2.0_f64.powi(power))
}

/// A number with all of its digits.
fn full() -> impl Strategy<Value = Precise> {
    (any_size(), any_size(), 1.0..3.0_f64)
        .prop_map(|(x, y, z)| Precise::from_f64(x) / Precise::from_f64(z) + Precise::from_f64(y).abs().sqrt())
}

proptest! {
    #[test]
    fn sums_and_products_are_rounded_to_the_nearest(a in full(), b in full()) {
        assert_near(a + b, &(exactly(a) + exactly(b)), 1.0, "sum");
        assert_near(a - b, &(exactly(a) - exactly(b)), 1.0, "difference");
        assert_near(a * b, &(exactly(a) * exactly(b)), 1.0, "product");
        prop_assert_eq!(a < b, exactly(a) < exactly(b));
    }

    #[test]
    fn quotients_roots_and_powers_are_right(a in full(), b in full(), p in -8.0..8.0_f64) {
        let (a, b) = (a.abs(), b.abs());
        let quotient = a / b;
        let rest = size(exactly(quotient) * exactly(b) - exactly(a));
        prop_assert!(rest <= half_unit(quotient) * exactly(b));
        assert_near(a.sqrt(), &exactly(a).with_precision(ENOUGH).value().sqrt(), 2.0, "root");
        let exact = exactly(a).with_precision(ENOUGH).value().powf(&big(p).with_precision(ENOUGH).value());
        assert_near(a.pow(Precise::from_f64(p)), &exact, 2.0, "power");
    }

    #[test]
    fn the_nearest_f64_is_found(a in full()) {
        prop_assert_eq!(a.to_f64(), exactly(a).to_f64().value());
    }
}
