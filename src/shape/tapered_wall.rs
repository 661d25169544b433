//! The wall of a tapered cylinder: the double cone x² + y² = w² with w = 1 + (s − 1) z, and the part of a ray inside of it.

use super::boundary::Root;
use super::tapered_cylinder::WALL;
use super::{GenericRay, Part};
use crate::math::{Quadratic, Real};

/// One end of the inside, and how well it is known.
#[derive(Clone, Copy)]
pub(super) struct End<A> {
    /// τ.
    pub tau: A,
    /// Bound on its error.
    pub error: A,
    /// The part of the surface.
    pub part: Part,
}

/// The wall of the double cone that a ray meets.
pub(super) struct Wall<A> {
    /// F along the ray, in τ − τ of the foot.
    pub quadratic: Quadratic<A>,
    /// The discriminant is zero, as far as can be told.
    touches: bool,
    /// The ray is parallel to a side of the cone, as far as can be told.
    parallel: bool,
    /// Bound on the error of F near the roots.
    doubt: f64,
    /// s − 1.
    slope: A,
}

impl<A: Real> Wall<A> {
    /// The quadratic of the wall about the point `l` of the ray; none where rounding hides the sign of the discriminant.
    #[expect(clippy::many_single_char_names, reason = "the symbols of the shape's own head")]
    pub fn new(s: f64, ray: &GenericRay<A>, l: [A; 3]) -> Option<Self> {
        let k = A::from_f64(s) - A::ONE;
        let [c_x, c_y, c_z] = ray.direction;
        let (w, d) = (A::ONE + k * l[2], k * c_z);
        let a = c_x * c_x + c_y * c_y - d * d;
        let b = l[0] * c_x + l[1] * c_y - w * d;
        let c = l[0] * l[0] + l[1] * l[1] - w * w;
        let minors = [l[0] * d - w * c_x, l[1] * d - w * c_y, l[0] * c_y - l[1] * c_x];
        let [p, q, r] = minors;
        let mut discriminant = p * p + q * q - r * r;
        let steep = 1.0 + k.abs().to_f64();
        // Every minor is off by at most this: eight roundings of l and w, times components of c below 2.
        let minor_error = 48.0 * A::UNIT_ROUNDOFF * steep * (ray.reach() + 1.0);
        let size: f64 = minors.iter().map(|x| x.abs().to_f64()).sum();
        let doubt = 2.0 * size * minor_error + 3.0 * minor_error * minor_error + 4.0 * A::UNIT_ROUNDOFF * size * size;
        let touches = discriminant.abs().to_f64() <= doubt;
        if touches && !A::FINEST {
            return None;
        }
        if touches {
            discriminant = A::ZERO;
        }
        let parallel = a.abs().to_f64() <= 64.0 * A::UNIT_ROUNDOFF * steep * steep;
        let extent = l.iter().map(|x| x.abs().to_f64()).sum::<f64>() + 4.0 * steep;
        let doubt = 32.0 * A::UNIT_ROUNDOFF * steep * extent * (ray.reach() + extent);
        let quadratic = Quadratic::with_discriminant(a, b, c, discriminant);
        Some(Self { quadratic, touches, parallel, doubt, slope: k })
    }

    /// Cuts the stretch between the discs down to what is inside the wall.
    ///
    /// The outer option is none where the order of two times is hidden by rounding; the inner one where the ray misses.
    #[expect(clippy::option_option, reason = "undecided and missed are two things")]
    pub fn clip(&self, ray: &GenericRay<A>, foot: A, [mut enter, mut leave]: [End<A>; 2]) -> Option<Option<[Root; 2]>> {
        let root = |end: End<A>| Root { tau: end.tau.to_f64(), error: 0.0, part: end.part };
        if self.touches && self.parallel {
            // F is the same all along the ray: it runs inside the wall, or in it, or outside.
            let inside = self.quadratic.c.to_f64() < -self.doubt;
            return Some(inside.then(|| [root(enter), root(leave)]));
        }
        let steep = self.quadratic.a < A::ZERO;
        let Some(roots) = self.quadratic.roots().filter(|_| steep || !self.touches) else {
            return Some(None);
        };
        let [first, second] = roots.map(|delta| self.end(foot, delta));
        if steep {
            // The nappe with w > 0 lies ahead where w grows along the ray, and behind where it shrinks.
            if self.slope * ray.direction[2] > A::ZERO {
                enter = later(enter, second);
            } else {
                leave = earlier(leave, first);
            }
        } else {
            enter = later(enter, first);
            leave = earlier(leave, second);
        }
        let doubtful = (enter.tau - leave.tau).abs() <= enter.error + leave.error;
        if doubtful && !A::FINEST {
            return None;
        }
        Some((!doubtful && enter.tau < leave.tau).then(|| [root(enter), root(leave)]))
    }

    /// A root of the quadratic with its error: that of F over the slope of F.
    fn end(&self, foot: A, delta: A) -> End<A> {
        let slope = self.quadratic.discriminant.sqrt() * A::from_f64(2.0);
        let own = if slope > A::ZERO { A::from_f64(self.doubt) / slope } else { A::ZERO };
        let rounding = A::from_f64(4.0 * A::UNIT_ROUNDOFF) * (foot.abs() + delta.abs());
        End { tau: foot + delta, error: own + rounding, part: WALL }
    }
}

fn later<A: Real>(a: End<A>, b: End<A>) -> End<A> {
    if b.tau > a.tau { b } else { a }
}

fn earlier<A: Real>(a: End<A>, b: End<A>) -> End<A> {
    if b.tau < a.tau { b } else { a }
}
