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
//! **Ray equation** With t measured from the foot of the perpendicular, t₀ = −(S·c) / (c·c), and l = S + c t₀, it is
//! A (t − t₀)² + 2 B (t − t₀) + C = 0 with A = c·c, B = c·l and C = l·l − 1. B is zero but for the rounding of t₀, so the
//! discriminant is −A C, and B only shifts the middle of the chord.
//!
//! **Accuracy** Without the foot the squares of a far S cancel, and digits are lost with the square of the distance. With
//! it, errors are those of S itself: about u |S| in l. Where these hide whether the ray touches, C is worked out
//! again with 32 digits. Grazing rays set the bound: t moves by the error of l over the sine of the grazing angle.
//!
//! **Degenerate cases** A tangent touches in one point and has no hits.
//!
//! **Source** Haines, Günther, Akenine-Möller, "Precision improvements for ray/sphere intersection", Ray Tracing Gems
//! (2019), ch. 7; Pharr, Jakob, Humphreys, Physically Based Rendering, 4th ed., § 6.8.

use super::boundary::{Root, Roots};
use super::solver::{self, Attempt, Call, Solver};
use super::{Bounds, Crossing, GenericRay, Part, Primitive, outline, report};
use crate::math::{Real, dot};
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

/// The quadratic about the foot, in τ.
pub(super) struct Chord<A> {
    foot: A,
    /// l, the point at the foot.
    nearest: [A; 3],
    a: A,
    /// B, zero but for the rounding of the foot.
    b: A,
    c: A,
    /// What rounding can do to C.
    doubt: f64,
}

impl<A: Real> Chord<A> {
    /// −B / A, where the roots have their middle, and half the way between them; none for a miss.
    #[inline]
    fn middle_and_half(&self) -> Option<[A; 2]> {
        let touches = A::DOUBT_IS_ZERO && self.c.abs().to_f64() <= self.doubt;
        (self.c < A::ZERO && !touches).then(|| [self.foot - self.b / self.a, (-self.c / self.a).sqrt()])
    }
}

impl Solver for Sphere {
    type Found<A: Real> = Chord<A>;

    #[inline]
    fn solve<A: Real>(&self, ray: &GenericRay<A>) -> Attempt<Chord<A>> {
        let a = dot(ray.direction, ray.direction);
        let foot = -dot(ray.origin, ray.direction) / a;
        let nearest = ray.at(foot);
        let b = dot(nearest, ray.direction);
        let square = dot(nearest, nearest);
        let c = square - A::ONE;
        // Each coordinate of l is off by at most four roundings of what it was added up from.
        let moved = moved(ray, nearest, foot);
        let doubt = 8.0 * A::UNIT_ROUNDOFF * (moved + square.to_f64() + 1.0);
        Attempt { decided: c.abs().to_f64() > doubt, found: Chord { foot, nearest, a, b, c, doubt } }
    }

    fn closest_call<A: Real>(&self, ray: &GenericRay<A>, chord: &Chord<A>) -> Call {
        Call {
            question: "Does the ray pass within the radius, C < 0?",
            value: chord.c.to_f64(),
            doubt: chord.doubt,
            input_doubt: 2.0 * f64::UNIT_ROUNDOFF * moved(ray, chord.nearest, chord.foot),
        }
    }

    #[inline]
    fn roots<A: Real>(&self, ray: &GenericRay<A>, chord: &Chord<A>) -> impl AsRef<[Root]> {
        let ends = chord.middle_and_half().map(|[middle, half]| {
            // ∇F · c / 2 = l·c + δ c·c, and l·c is nothing but rounding.
            let slope = (chord.a * half).to_f64();
            [middle - half, middle + half].map(|tau| {
                let at = ray.at(tau).map(Real::to_f64);
                let tau = tau.to_f64();
                Root { tau, error: ray.error_for_slope(at, slope, tau), part: 0 }
            })
        });
        Roots::pair(ends)
    }

    fn working<A: Real>(&self, ray: &GenericRay<A>, chord: &Chord<A>) -> Vec<Entry> {
        vec![working(ray, chord)]
    }

    fn rejected<A: Real>(&self, _: &GenericRay<A>, _: &Chord<A>, _: &[Crossing]) -> Vec<Candidate> {
        Vec::new()
    }
}

/// Σ|lᵢ| times how far lᵢ is off when S and c are off by one part in one: half of what C is off by.
#[inline]
fn moved<A: Real>(ray: &GenericRay<A>, nearest: [A; 3], foot: A) -> f64 {
    let [x, y, z] = ray.sway(foot.to_f64());
    let l = nearest.map(|x| x.abs().to_f64());
    l[0] * x + l[1] * y + l[2] * z
}

impl Primitive for Sphere {
    #[inline]
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Vec<Crossing>) {
        solver::crossings(self, ray, recorder, crossings);
    }

    fn normal(&self, point: DVec3, _part: Part) -> DVec3 {
        if point == DVec3::ZERO { DVec3::Z } else { point }
    }

    /// u is the longitude from the x axis, v the latitude from the south pole.
    fn uv(&self, point: DVec3, _part: Part) -> DVec2 {
        let latitude = point.z.atan2(point.truncate().length());
        DVec2::new(turn(point.truncate()), ((latitude + FRAC_PI_2) / PI).clamp(0.0, 1.0))
    }

    fn bounds(&self) -> Bounds {
        Bounds { low: DVec3::NEG_ONE, high: DVec3::ONE }
    }

    /// The equator, two parallels and four meridians.
    fn outline(&self) -> Vec<Vec<DVec3>> {
        let parallels = [-0.6, 0.0, 0.6].map(|z: f64| outline::circle((1.0 - z * z).sqrt(), z));
        let meridians = [0.0, 1.0, 2.0, 3.0].map(|k| {
            let (sin, cos) = (k * PI / 4.0).sin_cos();
            outline::closed_curve(|angle| DVec3::new(cos * angle.cos(), sin * angle.cos(), angle.sin()))
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
    let angle = point.y.atan2(point.x) / TAU;
    (if angle < 0.0 { angle + 1.0 } else { angle }).clamp(0.0, 1.0)
}

/// The quadratic in the shared t, with its working.
fn working<A: Real>(ray: &GenericRay<A>, chord: &Chord<A>) -> Entry {
    let scale = ray.t_per_tau;
    let (foot, a) = (report::measured(chord.foot, scale), report::measured(chord.a, 1.0 / scale / scale));
    let (b, c) = (report::measured(chord.b, 1.0 / scale), report::measured(chord.c, 1.0));
    let discriminant = report::measured(chord.b * chord.b - chord.a * chord.c, 1.0 / scale / scale);
    let roots = chord.middle_and_half().map(|[middle, half]| [middle - half, middle + half]);
    let roots: Vec<_> = roots.into_iter().flatten().map(|tau| report::measured(tau, scale)).collect();
    let nearest = report::measured_vector(chord.nearest);
    let bindings = [
        ("S", report::start(ray)),
        ("c", report::course(ray)),
        ("t₀", Value::Number(foot.value)),
        ("l", Value::Vector(nearest.value)),
        ("A", Value::Number(a.value)),
        ("B", Value::Number(b.value)),
        ("C", Value::Number(c.value)),
        ("D", Value::Number(discriminant.value)),
    ];
    let mut entry = Entry::new(What::Quadratic {
        about: "the sphere x² + y² + z² = 1".to_owned(),
        a: a.value,
        b: b.value,
        c: c.value,
        discriminant: discriminant.value,
        recentred_at: foot.value,
        roots: roots.iter().map(|root| root.value).collect(),
    })
    .line("t₀", "−(S·c) / (c·c)", &bindings, foot)
    .line("l", "S + c t₀", &bindings, nearest)
    .line("A", "c·c", &bindings, a)
    .line("B", "c·l", &bindings, b)
    .line("C", "l·l − 1", &bindings, c)
    .line("D", "B² − A C", &bindings, discriminant);
    if let [first, second] = roots[..] {
        entry = entry.line("t₁", "t₀ + (−B − √D) / A", &bindings, first).line(
            "t₂",
            "t₀ + (−B + √D) / A",
            &bindings,
            second,
        );
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
    fn the_quadratic_is_shown_about_the_foot() {
        let (reports, _) = record(&Sphere, DVec3::new(3.0, 0.6, 0.0), DVec3::new(-2.0, 0.0, 0.0));
        let What::Quadratic { a, b, c, discriminant, recentred_at, roots, .. } = &reports[0] else {
            panic!("{reports:?}")
        };
        // A = 2², C = 0.6² − 1 = −0.64, and t = 1.5 ± 0.8 / 2.
        assert_eq!((*a, *b, *recentred_at), (4.0, 0.0, 1.5));
        assert!((c + 0.64).abs() < 1e-15 && (discriminant - 2.56).abs() < 1e-15);
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
