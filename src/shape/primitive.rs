//! What every generic primitive can do.

use super::report;
use crate::math::{DoubleDouble, Lanes, Precise, Real, Shadowed, Traced, WideMap, coordinates, dot, scale_to_unit};
use crate::record::{Certificate, Measured, NullRecorder, Recorder, Sense, Triple};
use glam::{DVec2, DVec3};
use smallvec::SmallVec;

/// A ray S + c t in a primitive's generic coordinates, in the arithmetic `A`.
///
/// Solvers see a direction whose largest component lies in [1, 2): `direction` is c times an exact power of two, and a
/// solver's own parameter τ gives the shared hit time as t = τ · `t_per_tau`.
#[derive(Clone, Copy, Debug)]
pub struct GenericRay<'a, A> {
    /// S.
    pub origin: [A; 3],
    /// c, scaled by a power of two.
    pub direction: [A; 3],
    /// The power of two that takes a solver's parameter to the shared t.
    pub t_per_tau: f64,
    /// The sizes of the numbers that were added up to S: what its rounding errors are in proportion to.
    pub origin_size: [f64; 3],
    /// The same of the scaled c.
    pub direction_size: [f64; 3],
    /// Bounds on the lengths of these two.
    pub lengths: [f64; 2],
    /// What it was made from, if its numbers are rounded.
    source: Option<Source<'a>>,
}

/// A ray before its transform, and the map that takes it to generic coordinates.
#[derive(Clone, Copy, Debug)]
struct Source<'a> {
    line: &'a [DVec3; 2],
    generic_from_world: &'a WideMap,
}

/// A ray that can be had in any arithmetic.
///
/// Solvers that need a ray in one arithmetic, and hardly ever in a second one, make it themselves: so the numbers of the
/// first stay in registers.
pub trait Approach {
    /// The ray in generic coordinates.
    fn generic<A: Real>(&self) -> GenericRay<'_, A>;
}

impl<A: Real> GenericRay<'static, A> {
    /// The ray through `origin` (S) with `direction` (c, any length but zero), given in generic coordinates.
    #[must_use]
    pub fn new(origin: DVec3, direction: DVec3) -> Self {
        let scale = scale_to_unit(direction.to_array());
        let direction = direction * scale;
        Self {
            origin: origin.to_array().map(A::from_f64),
            direction: direction.to_array().map(A::from_f64),
            t_per_tau: scale,
            origin_size: origin.abs().to_array(),
            direction_size: direction.abs().to_array(),
            lengths: [origin, direction].map(|v| length(v.abs().to_array())),
            source: None,
        }
    }
}

impl GenericRay<'static, DoubleDouble> {
    /// A line that is known with 32 digits, with its parameter as it is.
    #[must_use]
    pub fn wide(origin: [DoubleDouble; 3], direction: [DoubleDouble; 3]) -> Self {
        let plain = |v: [DoubleDouble; 3]| DVec3::from_array(v.map(Real::to_f64));
        let [origin_size, direction_size] = [origin, direction].map(|v| plain(v).abs().to_array());
        let lengths = [origin_size, direction_size].map(length);
        Self { origin, direction, t_per_tau: 1.0, origin_size, direction_size, lengths, source: None }
    }
}

impl<'a, A: Real> GenericRay<'a, A> {
    /// The world ray `line` (its origin and direction), taken to generic coordinates.
    ///
    /// `plain` is S and c in double precision, `sizes` the sizes of what was added up to them, `map` the same map with 32
    /// digits. Arithmetics with more digits than `f64` take theirs from there.
    #[must_use]
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "so that a solver leaves out what it does not need")]
    pub fn mapped(line: &'a [DVec3; 2], plain: [Lanes; 2], sizes: [Lanes; 2], map: &'a WideMap) -> Self {
        let scale = scale_to_unit(coordinates(plain[1]));
        // What the transform rounds off comes to what the solver itself does.
        let origin_size = coordinates(plain[0].abs() + sizes[0]);
        let direction_size = coordinates((plain[1].abs() + sizes[1]) * Lanes::splat(scale));
        let course = plain[1] * Lanes::splat(scale);
        let from_plain = Self {
            origin: coordinates(plain[0]).map(A::from_f64),
            direction: coordinates(course).map(A::from_f64),
            t_per_tau: scale,
            origin_size,
            direction_size,
            lengths: [origin_size, direction_size].map(length),
            source: Some(Source { line, generic_from_world: map }),
        };
        if A::UNIT_ROUNDOFF < f64::UNIT_ROUNDOFF { from_plain.exactly() } else { from_plain }
    }

    /// The same ray in another arithmetic, from its numbers with 32 digits, or with 77 where it can tell the difference.
    #[must_use]
    pub fn exactly<B: Real>(&self) -> GenericRay<'a, B> {
        let [origin, direction] = if B::UNIT_ROUNDOFF < DoubleDouble::UNIT_ROUNDOFF {
            self.truth().map(|v| v.map(B::from_exact))
        } else {
            self.widened().map(|v| v.map(B::narrow))
        };
        GenericRay {
            origin,
            direction,
            t_per_tau: self.t_per_tau,
            origin_size: self.origin_size,
            direction_size: self.direction_size,
            lengths: self.lengths,
            source: self.source,
        }
    }

    /// S and the scaled c with 32 digits.
    fn widened(&self) -> [[DoubleDouble; 3]; 2] {
        let Some(Source { line: [origin, direction], generic_from_world }) = self.source else {
            return [self.origin, self.direction].map(|v| v.map(Real::widen));
        };
        let scale = DoubleDouble::from_f64(self.t_per_tau);
        let course = generic_from_world.vector(direction.to_array()).map(|x| x * scale);
        [generic_from_world.point(origin.to_array()), course]
    }

    /// S and the scaled c as exact arithmetic gives them: the exact inverse of the placement, applied to the ray as it was
    /// given.
    fn truth(&self) -> [[Precise; 3]; 2] {
        let Some(Source { line: [origin, direction], generic_from_world }) = self.source else {
            return [self.origin, self.direction].map(|v| v.map(Real::to_exact));
        };
        let scale = Precise::from_f64(self.t_per_tau);
        let [origin, course] = generic_from_world.exact_line(origin.to_array(), direction.to_array());
        [origin, course.map(|x| x * scale)]
    }

    /// The same ray with 32 digits.
    #[must_use]
    pub fn widen(&self) -> GenericRay<'a, DoubleDouble> {
        self.exactly()
    }

    /// The same numbers, with an account of their errors.
    #[must_use]
    pub fn traced(&self) -> GenericRay<'a, Traced<A>> {
        GenericRay {
            origin: self.origin.map(Traced::exact),
            direction: self.direction.map(Traced::exact),
            t_per_tau: self.t_per_tau,
            origin_size: self.origin_size,
            direction_size: self.direction_size,
            lengths: self.lengths,
            source: self.source,
        }
    }

    /// The same numbers, each with the exact one that it stands for.
    #[must_use]
    pub fn shadowed(&self) -> GenericRay<'a, Shadowed<A>> {
        let ([origin, direction], [true_origin, true_direction]) = ([self.origin, self.direction], self.truth());
        let pair = |values: [A; 3], exact: [Precise; 3]| {
            std::array::from_fn(|i| Shadowed { value: values[i], exact: exact[i] })
        };
        GenericRay {
            origin: pair(origin, true_origin),
            direction: pair(direction, true_direction),
            t_per_tau: self.t_per_tau,
            origin_size: self.origin_size,
            direction_size: self.direction_size,
            lengths: self.lengths,
            source: self.source,
        }
    }

    /// S and c as they are shown, with their errors if these are measured.
    #[must_use]
    pub fn shown(&self, is_measuring: bool) -> [Measured<Triple>; 2] {
        let per_t = 1.0 / self.t_per_tau;
        if is_measuring {
            let ray = self.shadowed();
            [report::measured_vector(ray.origin, 1.0), report::measured_vector(ray.direction, per_t)]
        } else {
            [report::measured_vector(self.origin, 1.0), report::measured_vector(self.direction, per_t)]
        }
    }

    /// S + c τ.
    #[must_use]
    #[inline]
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

    /// What rounding errors near the solid are in proportion to: the largest number that went into S, and what as large a
    /// share of c moves over the way from S to the solid.
    #[must_use]
    #[inline]
    pub fn reach(&self) -> f64 {
        let [x, y, z] = self.origin_size;
        let [u, v, w] = self.direction_size;
        x.max(y).max(z) * u.max(v).max(w).max(1.0)
    }

    /// How far each coordinate of S + c τ is off when S and c are off by one part in one.
    #[must_use]
    #[inline]
    pub fn sway(&self, tau: f64) -> [f64; 3] {
        let tau = tau.abs();
        std::array::from_fn(|i| self.origin_size[i] + tau * self.direction_size[i])
    }

    /// Bound on how far the hit time of a root moves when the ray's numbers move by a rounding each.
    ///
    /// `gradient` is that of the implicit function at the hit: δτ = Σ|∂F/∂xᵢ| (|Sᵢ| + |τ cᵢ|) u / |∇F · c|. At a tangent
    /// it is without bound; the caller caps it by the extent of the solid.
    #[must_use]
    #[inline]
    pub fn root_error(&self, gradient: [f64; 3], tau: f64) -> f64 {
        let c = self.direction.map(Real::to_f64);
        self.error_for_slope(gradient, gradient[0] * c[0] + gradient[1] * c[1] + gradient[2] * c[2], tau)
    }

    /// The same, where ∇F · c is known.
    #[must_use]
    #[inline]
    pub fn error_for_slope(&self, gradient: [f64; 3], slope: f64, tau: f64) -> f64 {
        let [x, y, z] = self.sway(tau);
        let moved = gradient[0].abs() * x + gradient[1].abs() * y + gradient[2].abs() * z;
        self.error_of_time(moved / slope.abs(), tau)
    }

    /// The same, where it is known that τ moves by `moved` when the ray's numbers move by one part in one.
    #[must_use]
    #[inline]
    pub fn error_of_time(&self, moved: f64, tau: f64) -> f64 {
        // Four roundings of the arithmetic, and those of the numbers that were given.
        (4.0 * A::UNIT_ROUNDOFF + f64::UNIT_ROUNDOFF) * (moved + tau.abs())
    }
}

/// A bound on the length of a vector without negative coordinates, at most a third more than it.
#[inline]
fn length([x, y, z]: [f64; 3]) -> f64 {
    const ROOT_3: f64 = 1.732_050_807_568_878;
    let larger = |a: f64, b: f64| if a > b { a } else { b };
    let (sum, largest) = (x + y + z, larger(larger(x, y), z) * ROOT_3);
    if sum < largest { sum } else { largest }
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
    /// How surely it is known to exist.
    pub certificate: Certificate,
}

/// The crossings of a ray with one primitive. A torus has four at most, and few rays have more; so the allocator is seldom
/// asked.
pub type Crossings = SmallVec<[Crossing; 4]>;

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
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Crossings);

    /// The first crossing with t > 0 that [`crossings`](Self::crossings) finds, and nothing about it told.
    fn first_crossing<A: Real>(&self, approach: &impl Approach) -> Option<Crossing> {
        let mut crossings = Crossings::new();
        self.crossings(&approach.generic::<A>(), &mut NullRecorder, &mut crossings);
        crossings.into_iter().find(|crossing| crossing.t > 0.0)
    }

    /// An outward normal at a point of the given part, in generic coordinates; not unit.
    ///
    /// At points without a normal (apex, crease) any sensible outward direction; never zero, never NaN.
    fn normal(&self, point: DVec3, part: Part) -> DVec3;

    /// Surface coordinates, from 0 to 1 where the part is bounded.
    fn uv(&self, point: DVec3, part: Part) -> DVec2;

    /// ∂P/∂u and ∂P/∂v for the (u, v) of [`uv`](Self::uv), in generic coordinates.
    ///
    /// Where u or v has no say (poles, apex) its vector is zero or any that is finite.
    fn tangents(&self, point: DVec3, part: Part) -> [DVec3; 2];

    /// Whether the part is flat, so that (u, v) is an affine map of it.
    fn is_flat(&self, _part: Part) -> bool {
        false
    }

    /// After what change of u and of v the surface comes back to the same place, where it closes on itself.
    fn uv_period(&self, _part: Part) -> [Option<f64>; 2] {
        [None; 2]
    }

    /// The box that holds it.
    fn bounds(&self) -> Bounds;

    /// The radius of a ball about the middle of its box that holds it; infinite where unbounded.
    fn ball_radius(&self) -> f64 {
        let Bounds { low, high } = self.bounds();
        0.5 * (high - low).length()
    }

    /// Whether a line meets it in one interval at most.
    fn is_convex(&self) -> bool {
        true
    }

    /// Polylines in generic coordinates that show the shape: edges, rims, meridians.
    fn outline(&self) -> Vec<Vec<DVec3>>;

    /// F(p): positive outside, zero on the surface, negative inside (for the square: z).
    fn implicit(&self, point: DVec3) -> f64;

    /// F in words, such as `x² + y² + z² − 1`.
    fn equation(&self) -> String;

    /// The names of the parts, indexed by [`Part`].
    fn parts(&self) -> Vec<String>;
}
