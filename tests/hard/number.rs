//! The numbers that the exact answers are worked out in: 256 binary digits, with plain `f64` as a quick first look.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Binary digits. Products of a pixel's ray and a placement are exact with them; what is rounded is off by 2⁻²⁵⁶.
const DIGITS: usize = 256;

/// What the exact answers need of a number.
pub trait Number:
    Clone
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Exactly this number.
    fn of(value: f64) -> Self;
    /// The nearest `f64`.
    fn nearest(&self) -> f64;
    /// √self; 0 where self is negative.
    fn root(&self) -> Self;
    /// self to a power; self is 0 or more.
    fn power(&self, exponent: f64) -> Self;
    /// |self|.
    fn size(&self) -> Self {
        if *self < Self::of(0.0) { -self.clone() } else { self.clone() }
    }
}

impl Number for f64 {
    fn of(value: f64) -> Self {
        value
    }

    fn nearest(&self) -> f64 {
        *self
    }

    fn root(&self) -> Self {
        self.max(0.0).sqrt()
    }

    fn power(&self, exponent: f64) -> Self {
        self.powf(exponent)
    }
}

/// A number of 256 binary digits.
#[derive(Clone, PartialEq, PartialOrd)]
pub struct Big(FBig<HalfEven, 2>);

impl Number for Big {
    fn of(value: f64) -> Self {
        Self(FBig::try_from(value).expect("a finite number").with_precision(DIGITS).value())
    }

    fn nearest(&self) -> f64 {
        self.0.to_f64().value()
    }

    fn root(&self) -> Self {
        if *self <= Self::of(0.0) { Self::of(0.0) } else { Self(self.0.sqrt()) }
    }

    fn power(&self, exponent: f64) -> Self {
        if *self == Self::of(0.0) {
            return self.clone();
        }
        if (8.0 * exponent).fract() == 0.0 && (0.0..1000.0).contains(&exponent) {
            // Three square roots are far quicker than a logarithm.
            return if exponent.fract() == 0.0 { repeated(self, exponent) } else { self.root().power(2.0 * exponent) };
        }
        Self(self.0.powf(&Self::of(exponent).0))
    }
}

/// A whole power by repeated squaring.
fn repeated(base: &Big, exponent: f64) -> Big {
    let (mut square, mut rest, mut result) = (base.clone(), exponent, Big::of(1.0));
    while rest >= 1.0 {
        if rest % 2.0 == 1.0 {
            result = result * square.clone();
        }
        square = square.clone() * square;
        rest = (rest / 2.0).floor();
    }
    result
}

macro_rules! operators {
    ($($operator:ident $method:ident)*) => { $(
        impl $operator for Big {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }
    )* };
}

operators! { Add add Sub sub Mul mul Div div }

impl Neg for Big {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

/// a · b.
pub fn dot<N: Number>(a: &[N; 3], b: &[N; 3]) -> N {
    let product = |i: usize| a[i].clone() * b[i].clone();
    product(0) + product(1) + product(2)
}

/// a².
pub fn squared<N: Number>(a: &N) -> N {
    a.clone() * a.clone()
}

#[test]
fn two_hundred_and_fifty_digits_are_kept() {
    let third = Big::of(1.0) / Big::of(3.0);
    assert!((third * Big::of(3.0) - Big::of(1.0)).size() < Big::of(2.0_f64.powi(-254)));
    let root = Big::of(2.0).root();
    assert!((squared(&root) - Big::of(2.0)).size() < Big::of(2.0_f64.powi(-252)));
    let (whole, broken) = (Big::of(3.0).power(50.0), Big::of(3.0).power(0.125).power(400.0));
    assert!(((whole - broken) / Big::of(3.0).power(50.0)).size() < Big::of(2.0_f64.powi(-240)));
}
