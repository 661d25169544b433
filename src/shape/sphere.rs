//! The unit sphere about the origin, as a solid ball.
//!
//! **Shape**
//! ```text
//!            z
//!         .--|--.
//!       /    |    \
//!      |     o-----|→ y      radius 1
//!       \         /
//!         '-----'
//! ```
//! **Equation** F = x² + y² + z² − 1.
//!
//! **Ray equation** A t² + 2 B t + C = 0 with A = c·c, B = S·c and C = S·S − 1. With m = S × c Lagrange's identity gives
//! the discriminant without the squares of a far S: B² − A C = A − m·m, for |m| / |c| is the distance of the ray from the
//! middle.
//!
//! **Accuracy** B² − A C loses digits with the square of the distance; A − m·m does not: its errors are those of S itself,
//! about u |S| |c| in m, as if S stood at the foot of the perpendicular. Where these hide whether the ray touches, all is
//! worked out again with 32 digits. What cancels in B is made good by a second step from the point at −B / A. Grazing rays
//! set the bound: t moves by the error of the distance over the sine of the grazing angle.
//!
//! **Degenerate cases** A tangent touches in one point and has no hits.
//!
//! **Source** Haines, Günther, Akenine-Möller, "Precision improvements for ray/sphere intersection", Ray Tracing Gems
//! (2019), ch. 7; Pharr, Jakob, Humphreys, Physically Based Rendering, 4th ed., § 6.8.

use super::boundary::{Boundaries, Root};
use super::solver::{self, Attempt, Call, Solver};
use super::{Approach, Bounds, Crossing, Crossings, GenericRay, Part, Primitive, outline, report, tangents};
use crate::math::{Real, cross, dot, portable};
use crate::record::{Candidate, Entry, Recorder, Value, What};
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The ball of radius 1 about the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere;

impl Sphere {
    /// The generic sphere.
    ///
    /// # Errors
    /// None: it has no parameters.
    pub const fn new() -> Result<Self, String> {
        Ok(Self)
    }
}

/// The quadratic A τ² + 2 B τ + C = 0, and where its roots lie.
pub(super) struct Chord<A> {
    a: A,
    b: A,
    /// m = S × c: its length is |c| times the distance of the ray from the middle.
    moment: [A; 3],
    /// A − m·m, the discriminant B² − A C.
    discriminant: A,
    /// What rounding can do to it.
    doubt: f64,
    hits: bool,
}

impl<A: Real> Chord<A> {
    /// −B / A and √D / A: the middle of the chord and half its length, in τ.
    ///
    /// What cancels in B is made good by a second step: the point at the first middle is near the origin, where nothing
    /// cancels.
    #[inline]
    fn middle_and_half(&self, ray: &GenericRay<A>) -> [A; 2] {
        let per_a = A::ONE / self.a;
        let first = -(self.b * per_a);
        let rest = dot(ray.at(first), ray.direction);
        [first - rest * per_a, self.discriminant.sqrt() * per_a]
    }
}

impl Solver for Sphere {
    type Found<A: Real> = Chord<A>;

    #[inline]
    fn solve<A: Real>(&self, ray: &GenericRay<A>) -> Attempt<Chord<A>> {
        let a = dot(ray.direction, ray.direction);
        let b = dot(ray.origin, ray.direction);
        let moment = cross(ray.origin, ray.direction);
        let square = dot(moment, moment);
        let discriminant = a - square;
        // Each of the three is off by at most four roundings of the products that it was added up from.
        let [p, q, r] = moment.map(|m| m.abs().to_f64());
        let size = (p + q + r) * ray.lengths[0] * ray.lengths[1];
        let doubt = 4.0 * A::UNIT_ROUNDOFF * (2.0 * size + square.to_f64() + a.to_f64());
        let decided = discriminant.abs().to_f64() > doubt;
        let hits = discriminant > A::ZERO && (decided || !A::DOUBT_IS_ZERO);
        Attempt { found: Chord { a, b, moment, discriminant, doubt, hits }, decided }
    }

    fn closest_call<A: Real>(&self, ray: &GenericRay<A>, chord: &Chord<A>) -> Call {
        Call {
            question: "Does the ray pass within the radius, D > 0?",
            value: chord.discriminant.to_f64(),
            doubt: chord.doubt,
            input_doubt: 2.0 * f64::UNIT_ROUNDOFF * moved(ray, chord.moment),
            near: -(chord.b / chord.a).to_f64(),
        }
    }

    #[inline]
    fn roots<A: Real>(&self, ray: &GenericRay<A>, chord: &Chord<A>) -> impl Boundaries {
        chord.hits.then(|| {
            let [middle, half] = chord.middle_and_half(ray);
            // ∇F · c / 2 is √D, and ∇F / 2 has the length 1.
            let per_slope = 1.0 / (half * chord.a).to_f64();
            let [start, course] = ray.lengths.map(|length| length * per_slope);
            [middle - half, middle + half].map(|tau| {
                let tau = tau.to_f64();
                Root { tau, error: ray.error_of_time(start + tau.abs() * course, tau), part: 0 }
            })
        })
    }

    fn working<A: Real>(&self, ray: &GenericRay<A>, chord: &Chord<A>) -> Vec<Entry> {
        vec![working(ray, chord)]
    }

    fn rejected<A: Real>(&self, _: &GenericRay<A>, _: &Chord<A>, _: &[Crossing]) -> Vec<Candidate> {
        Vec::new()
    }
}

/// Σ|mᵢ| times how far mᵢ is off when S and c are off by one part in one: half of what D is off by.
#[inline]
fn moved<A: Real>(ray: &GenericRay<A>, moment: [A; 3]) -> f64 {
    let ([x, y, z], [u, v, w]) = (ray.origin_size, ray.direction_size);
    let [p, q, r] = moment.map(|m| m.abs().to_f64());
    p * (y * w + z * v) + q * (z * u + x * w) + r * (x * v + y * u)
}

impl Primitive for Sphere {
    #[inline]
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Crossings) {
        solver::crossings(self, ray, recorder, crossings);
    }

    #[inline]
    fn first_crossing<A: Real>(&self, approach: &impl Approach) -> Option<Crossing> {
        solver::first_crossing::<A>(self, approach)
    }

    fn normal(&self, point: DVec3, _part: Part) -> DVec3 {
        if point == DVec3::ZERO { DVec3::Z } else { point }
    }

    /// u is the longitude from the x axis, v the latitude from the south pole.
    fn uv(&self, point: DVec3, _part: Part) -> DVec2 {
        let latitude = portable::atan2(point.z, point.truncate().length());
        DVec2::new(turn(point.truncate()), ((latitude + FRAC_PI_2) / PI).clamp(0.0, 1.0))
    }

    fn tangents(&self, point: DVec3, _part: Part) -> [DVec3; 2] {
        let radial = tangents::radial(point);
        let up = (radial * -point.z).extend(point.truncate().length());
        [tangents::around(point), up * PI]
    }

    fn uv_period(&self, _part: Part) -> [Option<f64>; 2] {
        [Some(1.0), None]
    }

    fn bounds(&self) -> Bounds {
        Bounds { low: DVec3::NEG_ONE, high: DVec3::ONE }
    }

    fn ball_radius(&self) -> f64 {
        1.0
    }

    /// The equator, two parallels and four meridians.
    fn outline(&self) -> Vec<Vec<DVec3>> {
        let parallels = [-0.6, 0.0, 0.6].map(|z: f64| outline::circle((1.0 - z * z).sqrt(), z));
        let meridians = [0.0, 1.0, 2.0, 3.0].map(|k| {
            let (sin, cos) = portable::sin_cos(k * PI / 4.0);
            outline::closed_curve(|angle| {
                DVec3::new(cos * portable::cos(angle), sin * portable::cos(angle), portable::sin(angle))
            })
        });
        parallels.into_iter().chain(meridians).collect()
    }

    fn implicit(&self, point: DVec3) -> f64 {
        point.length_squared() - 1.0
    }

    fn equation(&self) -> String {
        "x² + y² + z² − 1".to_owned()
    }

    fn parts(&self) -> Vec<String> {
        vec!["surface".to_owned()]
    }
}

/// The angle about the z axis as a share of a full turn.
pub(super) fn turn(point: DVec2) -> f64 {
    let angle = portable::atan2(point.y, point.x) / TAU;
    (if angle < 0.0 { angle + 1.0 } else { angle }).clamp(0.0, 1.0)
}

/// The quadratic in the shared t, with its working.
fn working<A: Real>(ray: &GenericRay<A>, chord: &Chord<A>) -> Entry {
    let scale = ray.t_per_tau;
    let per_t = 1.0 / scale;
    let (a, b) = (report::measured(chord.a, per_t * per_t), report::measured(chord.b, per_t));
    let c = report::measured(dot(ray.origin, ray.origin) - A::ONE, 1.0);
    let moment = report::measured_vector(chord.moment, per_t);
    let discriminant = report::measured(chord.discriminant, per_t * per_t);
    let ends = chord.hits.then(|| chord.middle_and_half(ray)).map(|[middle, half]| [middle - half, middle + half]);
    let roots: Vec<_> = ends.into_iter().flatten().map(|tau| report::measured(tau, scale)).collect();
    let bindings = [
        ("S", report::start(ray)),
        ("c", report::course(ray)),
        ("A", Value::Number(a.value)),
        ("B", Value::Number(b.value)),
        ("C", Value::Number(c.value)),
        ("m", Value::Vector(moment.value)),
        ("D", Value::Number(discriminant.value)),
    ];
    let mut entry = Entry::new(What::Quadratic {
        about: "the sphere x² + y² + z² = 1".to_owned(),
        a: a.value,
        b: b.value,
        c: c.value,
        discriminant: discriminant.value,
        recentred_at: 0.0,
        roots: roots.iter().map(|root| root.value).collect(),
    })
    .line("A", "c·c", &bindings, a)
    .line("B", "S·c", &bindings, b)
    .line("C", "S·S − 1", &bindings, c)
    .line("m", "S × c", &bindings, moment)
    .line("D", "A − m·m", &bindings, discriminant);
    if let [first, second] = roots[..] {
        entry = entry.line("t₁", "(−B − √D) / A", &bindings, first).line("t₂", "(−B + √D) / A", &bindings, second);
    }
    entry
}

#[cfg(test)]
mod tests {
    use super::super::testing::*;
    use super::*;

    impl Samples for Sphere {
        fn samples() -> Vec<Self> {
            vec![Self::new().unwrap()]
        }
    }

    #[test]
    fn a_ray_through_the_middle_enters_and_leaves() {
        expect(&Sphere, [3.0, 0.0, 0.0], [-1.0, 0.0, 0.0], &[(2.0, Enter, "surface"), (4.0, Leave, "surface")]);
    }

    #[test]
    fn the_direction_keeps_its_length() {
        expect(&Sphere, [3.0, 0.0, 0.0], [-0.5, 0.0, 0.0], &[(4.0, Enter, "surface"), (8.0, Leave, "surface")]);
    }

    #[test]
    fn a_tangent_ray_has_no_hits() {
        expect(&Sphere, [-2.0, 1.0, 0.0], [1.0, 0.0, 0.0], &[]);
        expect(&Sphere, [-3.0, 0.6, 0.8], [7.0, 0.0, 0.0], &[]);
    }

    #[test]
    fn a_ray_beside_it_misses() {
        expect(&Sphere, [-2.0, 1.5, 0.0], [1.0, 0.0, 0.0], &[]);
    }

    #[test]
    fn a_ray_from_inside_has_one_hit_on_either_side() {
        expect(&Sphere, [0.0; 3], [0.0, 0.0, 2.0], &[(-0.5, Enter, "surface"), (0.5, Leave, "surface")]);
    }

    #[test]
    fn hits_behind_the_start_are_found_too() {
        expect(&Sphere, [3.0, 0.0, 0.0], [1.0, 0.0, 0.0], &[(-4.0, Enter, "surface"), (-2.0, Leave, "surface")]);
    }

    #[test]
    fn a_hundred_million_radii_away_it_still_has_its_width() {
        // The half chord at the height 0.6 is 0.8.
        let hits = solve::<f64>(&Sphere, DVec3::new(1e8, 0.6, 0.0), DVec3::NEG_X);
        assert_eq!(hits.iter().map(|hit| hit.t - 1e8).collect::<Vec<_>>(), [-0.8, 0.8].map(|t| (1e8 + t) - 1e8));
    }

    #[test]
    fn the_quadratic_is_that_of_the_substitution() {
        let (reports, _) = record(&Sphere, DVec3::new(3.0, 0.6, 0.0), DVec3::new(-2.0, 0.0, 0.0));
        let What::Quadratic { a, b, c, discriminant, recentred_at, roots, .. } = &reports[0] else {
            panic!("{reports:?}")
        };
        // A = 2², B = 3 (−2), C = 3² + 0.6² − 1, m = (0, 0, 1.2), and t = 1.5 ± 0.8 / 2.
        assert_eq!((*a, *b, *recentred_at), (4.0, -6.0, 0.0));
        assert!((c - 8.36).abs() < 1e-14 && (discriminant - 2.56).abs() < 1e-15);
        assert!((roots[0] - 1.1).abs() < 1e-15 && (roots[1] - 1.9).abs() < 1e-15);
    }

    #[test]
    fn poles_and_equator_have_their_coordinates() {
        assert_eq!(Sphere.uv(DVec3::X, 0), DVec2::new(0.0, 0.5));
        assert_eq!(Sphere.uv(DVec3::Y, 0), DVec2::new(0.25, 0.5));
        assert_eq!(Sphere.uv(DVec3::Z, 0).y, 1.0);
        assert_eq!(Sphere.uv(DVec3::NEG_Z, 0).y, 0.0);
    }
}
