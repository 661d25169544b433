//! Numbers with 200 bits, and rays in them.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use glam::{DAffine3, DVec3};

/// A number with [`BITS`] bits.
pub type Big = FBig<HalfEven, 2>;

/// The foot of a ray from 10⁸ away cancels 30 bits and a near tangent 100 more; what is left is more than an `f64` holds.
const BITS: usize = 200;

/// The number itself: every finite `f64` is one of these.
pub fn big(x: f64) -> Big {
    Big::try_from(x).unwrap().with_precision(BITS).value()
}

/// The nearest `f64`.
pub fn near(x: &Big) -> f64 {
    x.to_f64().value()
}

/// The magnitude.
pub fn size(x: &Big) -> Big {
    if *x < Big::ZERO { -x.clone() } else { x.clone() }
}

/// x to a power that is a multiple of 1/16, by multiplications and square roots.
pub fn power(x: &Big, exponent: f64) -> Big {
    if *x == Big::ZERO {
        return big(0.0);
    }
    let sixteenths = exponent * 16.0;
    assert!(sixteenths.fract() == 0.0 && sixteenths > 0.0, "{exponent} is no multiple of 1/16");
    let (mut numerator, mut roots) = (sixteenths, 4);
    while roots > 0 && numerator % 2.0 == 0.0 {
        (numerator, roots) = (numerator / 2.0, roots - 1);
    }
    let (mut result, mut square, mut rest) = (big(1.0), x.clone(), numerator);
    while rest > 0.0 {
        if rest % 2.0 == 1.0 {
            result *= &square;
        }
        rest = (rest / 2.0).floor();
        square = &square * &square;
    }
    (0..roots).fold(result, |x, _| x.sqrt())
}

/// The ray l + c δ, with δ measured from the foot of the perpendicular from the origin and c brought to a length near 1
/// by a power of two: t = (foot + δ) · `unit`.
pub struct Line {
    foot: Big,
    unit: Big,
    pub nearest: [Big; 3],
    pub direction: [Big; 3],
    /// What one unit of length is in δ.
    pub per_length: Big,
}

impl Line {
    pub fn new(origin: DVec3, direction: DVec3) -> Self {
        Self::through(&origin.to_array().map(big), direction.to_array().map(big))
    }

    /// The ray of the world in the generic coordinates of what stands at `world_from_generic`, by Cramer's rule.
    pub fn placed(origin: DVec3, direction: DVec3, world_from_generic: &DAffine3) -> Self {
        let DAffine3 { matrix3, translation } = world_from_generic;
        let columns = [matrix3.x_axis, matrix3.y_axis, matrix3.z_axis].map(|column| column.to_array().map(big));
        let [x, y, z] = &columns;
        let determinant = dot(x, &cross(y, z));
        let inverse =
            |v: &[Big; 3]| [cross(y, z), cross(z, x), cross(x, y)].map(|cofactors| dot(&cofactors, v) / &determinant);
        let from_middle: [Big; 3] = std::array::from_fn(|i| big(origin[i]) - big(translation[i]));
        Self::through(&inverse(&from_middle), inverse(&direction.to_array().map(big)))
    }

    fn through(s: &[Big; 3], c: [Big; 3]) -> Self {
        let largest = c.iter().map(|x| near(x).abs()).fold(0.0, f64::max);
        let unit = (-largest.log2().floor()).exp2();
        let c = c.map(|x| x * big(unit));
        let foot = -dot(s, &c) / dot(&c, &c);
        let nearest = std::array::from_fn(|i| &s[i] + &c[i] * &foot);
        let per_length = big(1.0) / dot(&c, &c).sqrt();
        Self { foot, unit: big(unit), nearest, direction: c, per_length }
    }

    pub fn at(&self, delta: &Big) -> [Big; 3] {
        std::array::from_fn(|i| &self.nearest[i] + &self.direction[i] * delta)
    }

    /// The ray's own parameter.
    pub fn time(&self, delta: &Big) -> Big {
        (&self.foot + delta) * &self.unit
    }
}

fn cross(a: &[Big; 3], b: &[Big; 3]) -> [Big; 3] {
    let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

pub fn dot(a: &[Big; 3], b: &[Big; 3]) -> Big {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}
