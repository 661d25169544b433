//! The wall of a tapered cylinder: the double cone x² + y² = w² with w = 1 + (s − 1) z, and where a ray meets it.

use super::GenericRay;
use super::solver::Call;
use crate::math::{Quadratic, Real};

/// The double cone and a ray.
#[derive(Clone, Copy)]
pub(super) struct Wall<A> {
    /// s − 1.
    pub slope: A,
    /// w at S.
    pub w: A,
    /// d = (s − 1) c_z.
    pub d: A,
    /// p = S_x d − w c_x, q = S_y d − w c_y, r = S_x c_y − S_y c_x: the discriminant is p² + q² − r².
    pub minors: [A; 3],
    /// F along the ray, with its discriminant, 0 where that cannot be told from 0 with all digits.
    pub quadratic: Quadratic<A>,
    /// How far p, q and r are off when S and c are off by one part in one.
    sway: [f64; 3],
    /// Bound on the rounding error of the discriminant.
    doubt: f64,
    /// The ray is parallel to a side of the cone, as far as can be told.
    parallel: bool,
    /// Bound on the rounding error of C.
    c_doubt: f64,
}

impl<A: Real> Wall<A> {
    /// The quadratic of the wall.
    #[inline]
    pub fn new(s: f64, ray: &GenericRay<A>) -> Self {
        let slope = A::from_f64(s) - A::ONE;
        let ([x, y, z], [c_x, c_y, c_z]) = (ray.origin, ray.direction);
        let (w, d) = (A::ONE + slope * z, slope * c_z);
        let a = c_x * c_x + c_y * c_y - d * d;
        let b = x * c_x + y * c_y - w * d;
        let c = x * x + y * y - w * w;
        let minors = [x * d - w * c_x, y * d - w * c_y, x * c_y - y * c_x];
        let [p, q, r] = minors;
        let exact = p * p + q * q - r * r;

        let ([os_x, os_y, os_z], [ds_x, ds_y, ds_z]) = (ray.origin_size, ray.direction_size);
        let steep = slope.abs().to_f64();
        let (w_size, d_size) = (1.0 + steep * os_z, steep * ds_z);
        let sway = [os_x * d_size + w_size * ds_x, os_y * d_size + w_size * ds_y, os_x * ds_y + os_y * ds_x];
        let rounding = 4.0 * A::UNIT_ROUNDOFF;
        let sizes = minors.map(|minor| minor.abs().to_f64());
        let doubt = (0..3)
            .map(|i| (2.0 * sizes[i] + rounding * sway[i]) * rounding * sway[i] + rounding * sizes[i] * sizes[i])
            .sum::<f64>();
        let touches = A::DOUBT_IS_ZERO && exact.abs().to_f64() <= doubt;
        let discriminant = if touches { A::ZERO } else { exact };
        Self {
            slope,
            w,
            d,
            minors,
            quadratic: Quadratic::with_discriminant(a, b, c, discriminant),
            sway,
            doubt,
            parallel: a.abs().to_f64() <= 2.0 * rounding * (ds_x * ds_x + ds_y * ds_y + d_size * d_size),
            c_doubt: 2.0 * rounding * (os_x * os_x + os_y * os_y + w_size * w_size),
        }
    }

    /// Whether the line meets the double cone.
    #[inline]
    pub fn call(&self) -> Call {
        let [p, q, r] = self.minors.map(|minor| minor.abs().to_f64());
        Call {
            question: "Does the line meet the wall, D > 0?",
            value: self.quadratic.discriminant.to_f64(),
            doubt: self.doubt,
            input_doubt: 2.0 * f64::UNIT_ROUNDOFF * (p * self.sway[0] + q * self.sway[1] + r * self.sway[2]),
        }
    }

    /// Whether the numbers of the quadratic leave no other answer: D is not near zero, nor A where D does not tell.
    #[inline]
    pub fn is_beyond_doubt(&self) -> bool {
        self.doubt == 0.0 || self.quadratic.discriminant.abs().to_f64() > self.doubt
    }

    /// Whether F is the same all along the ray, as far as can be told: it runs inside the wall, or in it, or outside.
    #[inline]
    pub fn is_level(&self) -> bool {
        self.parallel && self.quadratic.discriminant == A::ZERO
    }

    /// Whether a ray along which F is the same runs inside.
    pub fn holds_all(&self) -> bool {
        self.quadratic.c.to_f64() < -self.c_doubt
    }

    /// Both times at which the line meets the double cone, ascending, after a step of Newton's method on F; infinite where
    /// A = 0. None for a miss.
    #[inline]
    pub fn roots(&self, ray: &GenericRay<A>) -> Option<[A; 2]> {
        let [first, second] = self.quadratic.roots()?;
        // Half the slope of F at the first root is −√D, at the second √D, the other way round where A < 0.
        let root = self.quadratic.discriminant.sqrt();
        let rising = if self.quadratic.a < A::ZERO { -root } else { root };
        let per_slope = A::from_f64(0.5) / rising;
        Some([self.polished(ray, first, -per_slope), self.polished(ray, second, per_slope)])
    }

    #[inline]
    fn polished(&self, ray: &GenericRay<A>, tau: A, per_slope: A) -> A {
        let [x, y, _] = ray.at(tau);
        let w = self.w + self.d * tau;
        let step = (x * x + y * y - w * w) * per_slope;
        // At the apex there is no slope, and at infinity no F.
        if step.is_finite() { tau - step } else { tau }
    }

    /// Where the ray goes into the part with w > 0, and where it comes out; infinite where it never does. None for a miss.
    ///
    /// A < 0: the ray is steeper than the side, and meets each nappe once. That with w > 0 lies ahead where w grows along
    /// the ray, and behind where it shrinks.
    #[inline]
    pub fn times(&self, ray: &GenericRay<A>) -> Option<[A; 2]> {
        let steep = self.quadratic.a < A::ZERO;
        if !steep && self.quadratic.discriminant <= A::ZERO {
            return None;
        }
        let [first, second] = self.roots(ray)?;
        let infinity = A::from_f64(f64::INFINITY);
        Some(match (steep, self.d > A::ZERO) {
            (false, _) => [first, second],
            (true, true) => [second, infinity],
            (true, false) => [-infinity, first],
        })
    }

    /// What bounds the errors of wall hits.
    #[inline]
    pub fn sensitivity(&self, ray: &GenericRay<A>) -> Sensitivity {
        let steep = self.slope.abs().to_f64();
        let sum = |[x, y, z]: [f64; 3]| x + y + steep * z;
        Sensitivity {
            start: sum(ray.origin_size),
            course: sum(ray.direction_size),
            per_slope: 1.0 / self.quadratic.discriminant.to_f64().sqrt(),
            w: self.w.to_f64(),
            d: self.d.to_f64(),
        }
    }
}

/// How the time of a wall hit moves when S and c do.
#[derive(Clone, Copy)]
pub(super) struct Sensitivity {
    start: f64,
    course: f64,
    per_slope: f64,
    w: f64,
    d: f64,
}

impl Sensitivity {
    /// How far it moves when S and c are off by one part in one: δF over the slope of F, which is √D.
    #[inline]
    pub fn moved(&self, tau: f64) -> f64 {
        // On the wall neither |x| nor |y| is more than w.
        (self.w + tau * self.d).abs() * (self.start + tau.abs() * self.course) * self.per_slope
    }
}
