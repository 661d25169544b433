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
//! **Ray equation** With t measured from the foot of the perpendicular, t₀ = −(S·c) / (c·c), and l = S + c t₀, the linear term
//! is gone: c·c (t − t₀)² + l·l − 1 = 0. The hits lie at t₀ ± √(−C / A) with A = c·c and C = l·l − 1.
//!
//! **Accuracy** Without the foot the squares of a far S cancel, and digits are lost with the square of the distance. With
//! it, errors are those of S itself: about u |S| in l. Where these hide whether the ray touches, C is worked out
//! again with 32 digits. Grazing rays set the bound: t moves by the error of l over the sine of the grazing angle.
//!
//! **Degenerate cases** A tangent touches in one point and has no hits.
//!
//! **Source** Haines, Günther, Akenine-Möller, "Precision improvements for ray/sphere intersection", Ray Tracing Gems
//! (2019), ch. 7; Pharr, Jakob, Humphreys, Physically Based Rendering, 4th ed., § 6.8.

use super::{Bounds, Crossing, GenericRay, Part, Primitive, boundary, boundary::Root, outline, report};
use crate::math::{Real, dot};
use crate::record::{Entry, Recorder, Sense, Value, What};
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

/// The quadratic about the foot, with its roots in τ.
struct Chord {
    foot: f64,
    a: f64,
    c: f64,
    nearest: [f64; 3],
    roots: Option<[f64; 2]>,
}

/// Solves about the foot; none where rounding hides whether there are roots.
fn chord<A: Real>(ray: &GenericRay<A>) -> Option<Chord> {
    let foot = ray.foot();
    let nearest = ray.at(foot);
    let a = dot(ray.direction, ray.direction);
    let c = dot(nearest, nearest) - A::ONE;
    // Each coordinate of l is off by up to 4u (|S| + 1), and l·l by twice that for each of the three.
    let doubt = 30.0 * A::UNIT_ROUNDOFF * (ray.reach() + 1.0);
    let undecided = c.abs().to_f64() <= doubt;
    if undecided && !A::FINEST {
        return None;
    }
    let roots = (c < A::ZERO && !undecided).then(|| {
        let half = (-c / a).sqrt();
        [(foot - half).to_f64(), (foot + half).to_f64()]
    });
    Some(Chord { foot: foot.to_f64(), a: a.to_f64(), c: c.to_f64(), nearest: nearest.map(Real::to_f64), roots })
}

impl Primitive for Sphere {
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Vec<Crossing>) {
        let begin = crossings.len();
        let Some(chord) = chord(ray).or_else(|| chord(&ray.widen())) else { return };
        if let Some(roots) = chord.roots {
            let roots = roots.map(|tau| Root { tau, part: 0 });
            boundary::append_alternating(self, ray, &roots, Sense::Enter, crossings);
        }
        let found = &crossings[begin..];
        recorder.note(|| working(ray, &chord));
        recorder.note(|| report::implicit(self, ray, found));
        recorder.note(|| report::roots(self, ray, found, Vec::new()));
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
fn working<A: Real>(ray: &GenericRay<A>, chord: &Chord) -> Entry {
    let scale = ray.t_per_tau;
    let (foot, a, c) = (chord.foot * scale, chord.a / scale / scale, chord.c);
    let discriminant = -a * c;
    let roots: Vec<_> = chord.roots.into_iter().flatten().map(|tau| tau * scale).collect();
    let bindings = [
        ("S", report::start(ray)),
        ("c", report::course(ray)),
        ("t₀", Value::Number(foot)),
        ("l", Value::Vector(chord.nearest)),
        ("A", Value::Number(a)),
        ("B", Value::Number(0.0)),
        ("C", Value::Number(c)),
    ];
    let mut entry = Entry::new(What::Quadratic {
        about: "the sphere x² + y² + z² = 1".to_owned(),
        a,
        b: 0.0,
        c,
        discriminant,
        recentred_at: foot,
        roots: roots.clone(),
    })
    .line("t₀", "−(S·c) / (c·c)", &bindings, foot)
    .line("l", "S + c t₀", &bindings, chord.nearest)
    .line("A", "c·c", &bindings, a)
    .line("B", "c·l", &bindings, 0.0)
    .line("C", "l·l − 1", &bindings, c)
    .line("B² − A C", "B² − A C", &bindings, discriminant);
    if let [first, second] = roots[..] {
        entry = entry.line("t₁", "t₀ − √(−C / A)", &bindings, first).line("t₂", "t₀ + √(−C / A)", &bindings, second);
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
