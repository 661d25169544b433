//! Reflection and refraction at an interface: Snell's law and Fresnel's equations.
//!
//! **Equations.** Snell: n₁ sin θ₁ = n₂ sin θ₂. With η = n₁ / n₂ and w = cos² θ₂ = 1 − η² sin² θ₁, all light is
//! reflected where w < 0. Fresnel: R_s and R_p for the two polarisations, R = (R_s + R_p) / 2 for unpolarised light.
//!
//! **Accuracy.** The hard case is w near zero, at the critical angle: whether light passes hangs on the last bit.
//! w is therefore the quotient of two sums that are taken in double-double arithmetic, straight from the vectors as
//! they were given, so that no length is rounded before the decision. sin θ₁ comes from the cross product and cos θ₁
//! from the scalar product, each accurate where the other is not. Fresnel's numerators are written without the
//! difference of nearly equal products (n₁² cos² θ₁ − n₂² cos² θ₂ = n₁² − n₂²).
//!
//! **Source.** de Greve, "Reflections and Refractions in Ray Tracing" (2006), eqs. 14, 21 and 22, rearranged as above.

use crate::math::{DoubleDouble, Real, dot, portable, scale_to_unit};
use glam::DVec3;

/// Indices are kept from being smaller than this beside the larger one, which lies in [1, 2). Smaller ones would
/// vanish when squared; much larger ones would be told apart from what was asked for.
const SMALLEST_INDEX: f64 = 1e-150;

/// What becomes of a ray at an interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Optics {
    /// The mirrored direction; it has the length of the incoming direction.
    pub reflected: DVec3,
    /// The refracted unit direction; none for total internal reflection.
    pub refracted: Option<DVec3>,
    /// cos θ₁, never negative.
    pub cos_i: f64,
    /// sin θ₁.
    pub sin_i: f64,
    /// cos² θ₂ = 1 − (n₁ / n₂)² sin² θ₁; negative for total internal reflection.
    pub w: f64,
    /// cos θ₂; none for total internal reflection.
    pub cos_t: Option<f64>,
    /// The indices of refraction on the side that the ray comes from and beyond, scaled alike.
    indices: [f64; 2],
    /// The ray runs exactly along the interface.
    along: bool,
}

/// The mirrored direction r = dir − 2 (dir · m) m.
#[must_use]
pub fn reflect(direction: DVec3, unit_normal: DVec3) -> DVec3 {
    direction - 2.0 * direction.dot(unit_normal) * unit_normal
}

/// What becomes of a ray that runs in `direction` into an interface with the given `normal`.
///
/// Neither has to be a unit vector and the normal may point to either side; `n1` is the index of refraction on the
/// side that the ray comes from. A ray that runs exactly along the interface is reflected wholly, and its refracted
/// direction lies on the side that the normal points away from. Vectors of no length and indices that are not
/// positive and finite are answered as if the interface were a mirror; callers who read them from a file refuse them.
#[must_use]
pub fn refract(direction: DVec3, normal: DVec3, n1: f64, n2: f64) -> Optics {
    let usable = |v: DVec3| v.is_finite() && v != DVec3::ZERO;
    let positive = |n: f64| n.is_finite() && n > 0.0;
    if !(usable(direction) && usable(normal) && positive(n1) && positive(n2)) {
        return Optics::mirror(direction);
    }
    let scales = (scale_to_unit(direction.to_array()), scale_to_unit(normal.to_array()));
    let incidence = Incidence::new(direction * scales.0, normal * scales.1);
    let scale = scale_to_unit([n1, n2, 0.0]);
    let mut optics = incidence.meet((n1 * scale).max(SMALLEST_INDEX), (n2 * scale).max(SMALLEST_INDEX));
    // A direction close to the largest number has no mirror image that could be written down in full.
    optics.reflected = (optics.reflected / scales.0).clamp(DVec3::MIN, DVec3::MAX);
    optics
}

/// The geometry of a ray at an interface, from vectors whose largest component lies in [1, 2).
struct Incidence {
    direction: DVec3,
    normal: DVec3,
    /// dir · m.
    projection: DoubleDouble,
    /// |dir × m|².
    cross_squared: DoubleDouble,
    /// |dir|² |m|².
    lengths_squared: DoubleDouble,
    /// m × (dir × m): the part of the direction along the interface, times |m|².
    along: DVec3,
    cos_i: f64,
    sin_i: f64,
}

impl Incidence {
    fn new(direction: DVec3, normal: DVec3) -> Self {
        let dir = direction.to_array().map(DoubleDouble::from_f64);
        let m = normal.to_array().map(DoubleDouble::from_f64);
        let across = cross(dir, m);
        let (projection, cross_squared) = (dot(dir, m), dot(across, across));
        let lengths_squared = dot(dir, dir) * dot(m, m);
        let length = lengths_squared.to_f64().sqrt();
        // Near grazing and near normal incidence one of the two is tiny; both keep their leading digits.
        let sine = DVec3::from_array(across.map(Real::to_f64)).length();
        Self {
            direction,
            normal,
            projection,
            cross_squared,
            lengths_squared,
            along: DVec3::from_array(cross(m, across).map(Real::to_f64)),
            cos_i: (projection.to_f64().abs() / length).min(1.0),
            sin_i: (sine / length).min(1.0),
        }
    }

    /// Puts media on both sides; the larger index lies in [1, 2).
    fn meet(&self, n1: f64, n2: f64) -> Optics {
        let w = self.cos_squared_beyond(n1, n2);
        let cos_t = (w >= 0.0).then(|| w.sqrt().min(1.0));
        Optics {
            reflected: self.reflected(),
            refracted: cos_t.map(|cos_t| self.refracted(n1 / n2, cos_t)),
            cos_i: self.cos_i,
            sin_i: self.sin_i,
            w,
            cos_t,
            indices: [n1, n2],
            // cos θ₁ can be too small to be told from 0 beside |dir| |m|; the scalar product itself cannot.
            along: self.projection.to_f64() == 0.0,
        }
    }

    /// w = 1 − (n₁ / n₂)² sin² θ₁ over a common denominator.
    ///
    /// Into the denser medium nothing cancels when sin² is written as 1 − cos²; into the thinner one the two terms
    /// are accurate to 30 digits each, so their difference is decided by the numbers as given and not by rounding.
    fn cos_squared_beyond(&self, n1: f64, n2: f64) -> f64 {
        if self.cross_squared.to_f64() == 0.0 {
            return 1.0;
        }
        let (n1, n2) = (DoubleDouble::from_f64(n1), DoubleDouble::from_f64(n2));
        let whole = n2 * n2 * self.lengths_squared;
        let part = if n1 > n2 {
            whole - n1 * n1 * self.cross_squared
        } else {
            n1 * n1 * (self.projection * self.projection) + (n2 - n1) * (n2 + n1) * self.lengths_squared
        };
        // The quotient in f64: it has the sign of `part`, and its one rounding is relative.
        part.to_f64() / whole.to_f64()
    }

    /// dir − 2 (dir · m) m / |m|².
    fn reflected(&self) -> DVec3 {
        self.direction - self.normal * (2.0 * self.projection.to_f64() / self.normal.length_squared())
    }

    /// η times the part of the unit direction along the interface, and cos θ₂ of the normal beyond it.
    fn refracted(&self, eta: f64, cos_t: f64) -> DVec3 {
        let forward = if self.projection.to_f64() > 0.0 { self.normal } else { -self.normal };
        let along = self.along / (self.normal.length_squared() * self.direction.length());
        (along * eta + forward * (cos_t / self.normal.length())).normalize()
    }
}

impl Optics {
    /// θ₁ in degrees.
    #[must_use]
    pub fn theta1_degrees(&self) -> f64 {
        portable::atan2(self.sin_i, self.cos_i).to_degrees()
    }

    /// θ₂ in degrees; none for total internal reflection.
    #[must_use]
    pub fn theta2_degrees(&self) -> Option<f64> {
        let [n1, n2] = self.indices;
        self.cos_t.map(|cos_t| portable::atan2(n1 / n2 * self.sin_i, cos_t).to_degrees())
    }

    /// The angle of incidence in degrees beyond which all light is reflected; none where n₁ < n₂.
    #[must_use]
    pub fn critical_angle_degrees(&self) -> Option<f64> {
        let [n1, n2] = self.indices;
        (n1 >= n2).then(|| portable::asin(n2 / n1).to_degrees())
    }

    /// Fresnel's R_s and R_p: the reflectance of light that swings across the plane of incidence, and in it.
    #[must_use]
    pub fn fresnel(&self) -> [f64; 2] {
        let (Some(cos_t), [n1, n2]) = (self.cos_t, self.indices) else { return [1.0, 1.0] };
        if self.along {
            return [1.0, 1.0];
        }
        if n1 == n2 {
            return [0.0, 0.0];
        }
        let across = n1 * self.cos_i + n2 * cos_t;
        let within = n2 * self.cos_i + n1 * cos_t;
        let amplitude_s = ((n1 - n2) / across) * ((n1 + n2) / across);
        let amplitude_p = ((n2 - n1) / within) * ((n2 + n1) / within) * self.beside_brewster();
        let passes = |sum: f64| 4.0 * (n1 * self.cos_i / sum) * (n2 * cos_t / sum);
        [share(amplitude_s, passes(across)), share(amplitude_p, passes(within))]
    }

    /// cos² θ₁ − (n₁ / n₂)² sin² θ₁ = cos² θ₂ − sin² θ₁, which is 0 at Brewster's angle. Near grazing the second form is the
    /// difference of two ones, and near normal incidence the first may be.
    fn beside_brewster(&self) -> f64 {
        let [n1, n2] = self.indices;
        if self.sin_i < self.cos_i {
            return self.w - self.sin_i * self.sin_i;
        }
        let sin_t = n1 / n2 * self.sin_i;
        (self.cos_i - sin_t) * (self.cos_i + sin_t)
    }

    /// Reflectance of unpolarised light: the mean of the two.
    #[must_use]
    pub fn reflectance(&self) -> f64 {
        let [r_s, r_p] = self.fresnel();
        f64::midpoint(r_s, r_p)
    }

    /// The answer where there is nothing to work with.
    fn mirror(direction: DVec3) -> Self {
        Self {
            reflected: if direction.is_finite() { direction } else { DVec3::ZERO },
            refracted: None,
            cos_i: 0.0,
            sin_i: 1.0,
            w: -1.0,
            cos_t: None,
            indices: [1.0, f64::INFINITY],
            along: true,
        }
    }
}

/// The reflected share, from the reflected amplitude or from the share that passes: whichever is the smaller number.
fn share(amplitude: f64, passes: f64) -> f64 {
    if passes < 0.5 { 1.0 - passes } else { amplitude * amplitude }
}

fn cross(a: [DoubleDouble; 3], b: [DoubleDouble; 3]) -> [DoubleDouble; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
