//! What every generic primitive can do.

use crate::math::{DoubleDouble, Real, dot, scale_to_unit};
use crate::record::{Recorder, Sense};
use glam::{DVec2, DVec3};

/// A ray S + c t in a primitive's generic coordinates, in the arithmetic `A`.
///
/// Solvers see a direction whose largest component lies in [1, 2): `direction` is c times an exact power of two, and a
/// solver's own parameter τ gives the shared hit time as t = τ · `t_per_tau`.
#[derive(Clone, Copy, Debug)]
pub struct GenericRay<A> {
    /// S.
    pub origin: [A; 3],
    /// c, scaled by a power of two.
    pub direction: [A; 3],
    /// The power of two that takes a solver's parameter to the shared t.
    pub t_per_tau: f64,
}

impl<A: Real> GenericRay<A> {
    /// The ray through `origin` (S) with `direction` (c, any length but zero).
    #[must_use]
    pub fn new(origin: DVec3, direction: DVec3) -> Self {
        let scale = scale_to_unit(direction.to_array());
        Self {
            origin: origin.to_array().map(A::from_f64),
            direction: direction.to_array().map(|x| A::from_f64(x * scale)),
            t_per_tau: scale,
        }
    }

    /// S + c τ.
    #[must_use]
    pub fn at(&self, tau: A) -> [A; 3] {
        std::array::from_fn(|i| self.origin[i] + self.direction[i] * tau)
    }

    /// S + c τ, rounded to `f64`.
    #[must_use]
    pub fn point(&self, tau: A) -> DVec3 {
        DVec3::from_array(self.at(tau).map(Real::to_f64))
    }

    /// The solver's parameter at the foot of the perpendicular from the origin of generic coordinates onto the ray.
    ///
    /// Measuring τ from there is what keeps far rays accurate. The second step removes the rounding of the first.
    #[must_use]
    pub fn foot(&self) -> A {
        let length_squared = dot(self.direction, self.direction);
        let first = -dot(self.origin, self.direction) / length_squared;
        first - dot(self.at(first), self.direction) / length_squared
    }

    /// The same ray in the arithmetic with the most digits.
    #[must_use]
    pub fn widen(&self) -> GenericRay<DoubleDouble> {
        GenericRay {
            origin: self.origin.map(Real::widen),
            direction: self.direction.map(Real::widen),
            t_per_tau: self.t_per_tau,
        }
    }

    /// S as plain numbers.
    #[must_use]
    pub fn start(&self) -> [f64; 3] {
        self.origin.map(Real::to_f64)
    }

    /// c as plain numbers, at its own length.
    #[must_use]
    pub fn course(&self) -> [f64; 3] {
        self.direction.map(|x| x.to_f64() / self.t_per_tau)
    }

    /// The largest component of S: what rounding errors near the solid are in proportion to.
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.start().into_iter().fold(0.0, |largest: f64, x| largest.max(x.abs()))
    }

    /// Bound on how far the hit time of a root moves when the ray's numbers move by a rounding each.
    ///
    /// `gradient` is that of the implicit function at the hit: δt = Σ|∂F/∂xᵢ| (|Sᵢ| + |τ cᵢ|) u / |∇F · c|. At a tangent
    /// it is without bound; the caller caps it by the extent of the solid.
    #[must_use]
    pub fn root_error(&self, gradient: DVec3, tau: A) -> f64 {
        let (g, tau) = (gradient.to_array(), tau.to_f64());
        let (s, c) = (self.origin.map(Real::to_f64), self.direction.map(Real::to_f64));
        let moved: f64 = (0..3).map(|i| g[i].abs() * (s[i].abs() + (tau * c[i]).abs())).sum();
        let slope: f64 = (0..3).map(|i| g[i] * c[i]).sum();
        // Four roundings: the inverse transform of S and c, the solver's own, and that of the result.
        4.0 * A::UNIT_ROUNDOFF * (moved / slope.abs() + tau.abs())
    }
}

/// A part of a primitive's surface: an index into [`Primitive::parts`].
pub type Part = u16;

/// A place where the ray crosses a primitive's surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The hit time in the shared parameter.
    pub t: f64,
    /// Bound on its error.
    pub error: f64,
    /// What it does to the ray.
    pub sense: Sense,
    /// The part of the surface.
    pub part: Part,
}

/// The primitive's box in its generic coordinates; infinite where unbounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The corner with the smallest coordinates.
    pub low: DVec3,
    /// The corner with the largest coordinates.
    pub high: DVec3,
}

/// A generic primitive: a closed solid (or the square) in its own coordinates.
pub trait Primitive {
    /// Finds **every** crossing for all real t, ascending, and appends them to `crossings`.
    ///
    /// A closed solid's crossings alternate between [`Sense::Enter`] and [`Sense::Leave`]. Where the solid is unbounded
    /// the first may be a `Leave` and the last an `Enter`; without any crossing the sign of [`implicit`](Self::implicit)
    /// at S tells whether the whole line is inside. Touched points without length are no crossings of a closed
    /// solid. The square's are all [`Sense::Touch`].
    ///
    /// The working is reported to `recorder` (plane table, quadratic, quartic, search), then the implicit function d(t),
    /// and at last every hit time that was looked at ([`What::Roots`](crate::record::What::Roots)). The `Primitive` event
    /// around them is the caller's.
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Vec<Crossing>);

    /// An outward normal at a point of the given part, in generic coordinates; not unit.
    ///
    /// At points without a normal (apex, crease) any sensible outward direction; never zero, never NaN.
    fn normal(&self, point: DVec3, part: Part) -> DVec3;

    /// Surface coordinates from 0 to 1.
    fn uv(&self, point: DVec3, part: Part) -> DVec2;

    /// The box that holds it.
    fn bounds(&self) -> Bounds;

    /// Polylines in generic coordinates that show the shape: edges, rims, meridians.
    fn outline(&self) -> Vec<Vec<DVec3>>;

    /// F(p): positive outside, zero on the surface, negative inside (for the square: z).
    fn implicit(&self, point: DVec3) -> f64;

    /// F in words, such as `x² + y² + z² − 1`.
    fn equation(&self) -> String;

    /// The names of the parts, indexed by [`Part`].
    fn parts(&self) -> Vec<String>;
}
