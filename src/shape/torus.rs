//! The torus: a tube of radius 1 about the circle of radius d in the plane z = 0 (§ 6.2.4).
//!
//! **Shape** (cut through the axis)
//! ```text
//!         z
//!    .-.  |  .-.
//!   (   ) |  ( o )---→ x      o at distance d from the axis
//!    '-'  |  '-'              tube of radius 1
//! ```
//! **Equation** F = (√(x² + y²) − d)² + z² − 1. For d < 1 the tube overlaps itself about the axis (a spindle): the lens of
//! the overlap is inside.
//!
//! **Ray equation** Without the root, G = (x² + y² + z² + d² − 1)² − 4 d² (x² + y²) is a quartic in t. Measured from the foot
//! of the perpendicular it has no cubic term. G is F times (√(x² + y²) + d)² + z² − 1, which is below zero only within the
//! overlap of a spindle: there the quartic has roots that are no boundary.
//!
//! **Accuracy** The signs of G at its turning points tell how often the ray crosses the surface; each is compared with a bound
//! on its rounding error. Where that leaves one open, a double root may hide, and all is worked out again with 32 digits;
//! what these cannot tell from zero is a touch. The hit times come from Chebyshev's method on F itself, which cancels less
//! than G. Thin tori (large d) and rays that touch set the bound.
//!
//! **Degenerate cases** Rays that touch from outside or from inside have no hit there. d = 1: the hole is one point, a ray
//! through it passes from inside to inside.
//!
//! **Source** Hill, Computer Graphics Using OpenGL, the generic torus; Yuksel, HPG 2022, for the roots.

use super::boundary::{self, Boundaries};
use super::solver::{self, Attempt, Call, Solver};
use super::torus_quartic::{Line, Quartic, Turn, Turns};
use super::torus_roots;
use super::{Approach, Bounds, Crossing, Crossings, GenericRay, Part, Primitive, outline, report, tangents};
use crate::math::{Real, portable};
use crate::record::{Candidate, Certificate, Entry, Recorder, Sense, Value, What};
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_PI_4, TAU};

/// A tube of radius 1 about the circle of radius d in the plane z = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torus {
    pub(super) d: f64,
}

/// What is known of a ray and a torus.
pub(super) enum Found<A> {
    /// The ray passes outside of the ball of radius d + 1.
    Far(Line<A>),
    /// It passes within it, or nearly so.
    Near(Quartic<A>, Turns<A>),
}

impl Torus {
    /// The torus whose tube runs at distance `d` from the axis.
    ///
    /// # Errors
    /// Says so when `d` is 0 or less, or not finite.
    pub fn new(d: f64) -> Result<Self, String> {
        if d.is_finite() && d > 0.0 {
            return Ok(Self { d });
        }
        Err(format!("d is {d}; the distance from the axis to the middle of the tube needs to be more than 0"))
    }

    /// The distance from the axis to the middle of the tube.
    #[must_use]
    pub const fn d(self) -> f64 {
        self.d
    }

    /// How far the line passes outside of the ball of radius d + 1, in squares.
    fn distance_call<A: Real>(self, line: &Line<A>) -> Call {
        let reach = (self.d + 1.0) * (self.d + 1.0);
        let size = line.nearest.iter().map(|x| x.abs().to_f64()).fold(0.0, f64::max);
        let moved = 2.0 * size * line.sway;
        Call {
            question: "Does the ray pass within d + 1 of the middle, l·l < (d + 1)²?",
            value: (line.square - A::from_f64(self.d + 1.0) * A::from_f64(self.d + 1.0)).to_f64(),
            doubt: 4.0 * A::UNIT_ROUNDOFF * (moved + line.square.to_f64() + reach),
            input_doubt: f64::UNIT_ROUNDOFF * (moved + 2.0 * self.d * (self.d + 1.0)),
            near: line.foot.to_f64(),
        }
    }

    /// Whether the ray is inside the tube at a turning point.
    fn turn_call<A: Real>(ray: &GenericRay<A>, quartic: &Quartic<A>, turns: &Turns<A>, turn: &Turn<A>) -> Call {
        let [near, far] = quartic.factors(turn.at);
        let a = quartic.line.a.to_f64();
        let by_quartic = turns.doubt * a * a / far.abs().to_f64();
        let doubt = if A::DOUBT_IS_ZERO { by_quartic.min(quartic.surface_doubt()) } else { by_quartic };
        let [x, y, z] = quartic.point(turn.at).map(|x| x.abs().to_f64());
        let [sway_x, sway_y, sway_z] = ray.sway(quartic.tau(turn.at).to_f64());
        let radius = portable::hypot(x, y);
        let outward = if radius > 0.0 { (x * sway_x + y * sway_y) / radius } else { sway_x + sway_y };
        let d = quartic.d.to_f64();
        let moved = 2.0 * (radius - d).abs() * (outward + d) + 2.0 * z * sway_z;
        Call {
            question: "Is the ray inside the tube where the quartic turns, F < 0?",
            value: near.to_f64(),
            doubt,
            input_doubt: f64::UNIT_ROUNDOFF * moved,
            near: quartic.tau(turn.at).to_f64(),
        }
    }
}

impl Solver for Torus {
    type Found<A: Real> = Found<A>;

    #[inline]
    fn solve<A: Real>(&self, ray: &GenericRay<A>) -> Attempt<Found<A>> {
        // A ball that holds the torus with room to spare.
        let ball = 1.01 * (self.d + 1.0);
        let line = Line::new(ray);
        let near = line.square.to_f64() <= ball * ball;
        if !near {
            return Attempt { decided: self.distance_call(&line).is_beyond_doubt(), found: Found::Far(line) };
        }
        let quartic = Quartic::new(self.d, ball, ray, line);
        let turns = quartic.turns();
        Attempt { decided: turns.decided(), found: Found::Near(quartic, turns) }
    }

    fn closest_call<A: Real>(&self, ray: &GenericRay<A>, found: &Found<A>) -> Call {
        match found {
            Found::Far(line) => self.distance_call(line),
            Found::Near(quartic, turns) => {
                let call = |turn| Self::turn_call(ray, quartic, turns, turn);
                let [first, rest @ ..] = turns.as_slice() else { return self.distance_call(&quartic.line) };
                rest.iter().map(call).fold(call(first), Call::closer)
            }
        }
    }

    #[inline]
    fn roots<'a, A: Real>(&self, ray: &'a GenericRay<'a, A>, found: &'a Found<A>) -> impl Boundaries {
        Stretches { ray, found }
    }

    fn working<A: Real>(&self, ray: &GenericRay<A>, found: &Found<A>) -> Vec<Entry> {
        let Found::Near(quartic, turns) = found else { return Vec::new() };
        let mut roots = Vec::new();
        turns.each_stretch(quartic.end, |stretch| {
            roots.extend(torus_roots::crossings(ray, quartic, turns.slope, &stretch).map(|root| root.tau));
        });
        roots.extend(hidden_times(quartic, turns));
        vec![self.entry(ray, quartic, roots)]
    }

    fn rejected<A: Real>(&self, ray: &GenericRay<A>, found: &Found<A>, _: &[Crossing]) -> Vec<Candidate> {
        let Found::Near(quartic, turns) = found else { return Vec::new() };
        let senses = [Sense::Leave, Sense::Enter];
        let reason = "a root of the quartic, but F is negative on both sides: it lies where the tube overlaps itself";
        hidden_times(quartic, turns)
            .into_iter()
            .zip(senses.into_iter().cycle())
            .map(|(tau, sense)| report::rejected(self, ray, (tau, 0, sense), reason.to_owned()))
            .collect()
    }
}

/// The stretches of the ray inside the torus, on their way to becoming crossings.
struct Stretches<'a, A> {
    ray: &'a GenericRay<'a, A>,
    found: &'a Found<A>,
}

impl<A: Real> Boundaries for Stretches<'_, A> {
    #[inline]
    fn append(self, _first: Sense, t_per_tau: f64, certificate: Certificate, crossings: &mut Crossings) {
        let Found::Near(quartic, turns) = self.found else { return };
        let start = crossings.len();
        turns.each_stretch(quartic.end, |stretch| {
            let roots = torus_roots::crossings(self.ray, quartic, turns.slope, &stretch);
            boundary::append_stretch(roots, start, certificate, t_per_tau, crossings);
        });
    }

    /// The entry into the first stretch, if that lies ahead: nothing that comes later can change it.
    fn first_ahead(self, first: Sense, t_per_tau: f64, certificate: Certificate) -> Option<Crossing> {
        let Found::Near(quartic, turns) = self.found else { return None };
        let mut stretch = None;
        turns.each_stretch(quartic.end, |next| stretch = stretch.take().or(Some(next)));
        let roots = torus_roots::crossings(self.ray, quartic, turns.slope, &stretch?);
        let entry = boundary::stretch(roots, Sense::Enter, t_per_tau, certificate).map(|[enter, _]| enter);
        entry.filter(|enter| enter.t > 0.0).or_else(|| boundary::first_of_all(self, first, t_per_tau, certificate))
    }
}

/// The roots of the quartic that are no boundaries, τ ascending.
fn hidden_times<A: Real>(quartic: &Quartic<A>, turns: &Turns<A>) -> Vec<f64> {
    let mut times: Vec<_> = quartic.hidden_roots(turns).into_iter().map(|delta| quartic.tau(delta).to_f64()).collect();
    times.sort_by(f64::total_cmp);
    times
}

impl Primitive for Torus {
    #[inline]
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Crossings) {
        solver::crossings(self, ray, recorder, crossings);
    }

    #[inline]
    fn first_crossing<A: Real>(&self, approach: &impl Approach) -> Option<Crossing> {
        solver::first_crossing::<A>(self, approach)
    }

    fn normal(&self, point: DVec3, _part: Part) -> DVec3 {
        let radius = point.truncate().length();
        let share = 1.0 - self.d / radius;
        let normal = DVec3::new(point.x * share, point.y * share, point.z);
        // On the axis a spindle has its two tips, and the horn torus its one point.
        if normal.is_finite() && normal != DVec3::ZERO {
            normal
        } else if point.z < 0.0 {
            DVec3::NEG_Z
        } else {
            DVec3::Z
        }
    }

    /// u is the turn about the axis, v that about the tube, from the outermost circle upwards.
    fn uv(&self, point: DVec3, _part: Part) -> DVec2 {
        let radius = point.truncate().length();
        DVec2::new(super::sphere::turn(point.truncate()), super::sphere::turn(DVec2::new(radius - self.d, point.z)))
    }

    fn uv_period(&self, _part: Part) -> [Option<f64>; 2] {
        [Some(1.0); 2]
    }

    fn is_convex(&self) -> bool {
        false
    }

    fn tangents(&self, point: DVec3, _part: Part) -> [DVec3; 2] {
        tangents::of_tube(point, self.d)
    }

    fn bounds(&self) -> Bounds {
        let high = DVec3::new(self.d + 1.0, self.d + 1.0, 1.0);
        Bounds { low: -high, high }
    }

    fn ball_radius(&self) -> f64 {
        self.d + 1.0
    }

    /// Four circles about the axis and eight about the tube; of a spindle only what lies outside.
    fn outline(&self) -> Vec<Vec<DVec3>> {
        let outward = |radius: f64, z: f64| (radius > 0.0).then(|| outline::circle(radius, z));
        let about_axis = [(self.d + 1.0, 0.0), (self.d, 1.0), (self.d - 1.0, 0.0), (self.d, -1.0)];
        // A spindle's tube meets the axis at the angle ±reach from outward.
        let reach = if self.d < 1.0 { portable::acos(-self.d) } else { TAU / 2.0 };
        let about_tube = (0..8).map(|k| {
            let (sin, cos) = portable::sin_cos(f64::from(k) * FRAC_PI_4);
            let point = |(up, out): (f64, f64)| (DVec2::new(cos, sin) * (self.d + out)).extend(up);
            (-64..=64).map(|step| point(portable::sin_cos(reach * f64::from(step) / 64.0))).collect()
        });
        about_axis.into_iter().filter_map(|(radius, z)| outward(radius, z)).chain(about_tube).collect()
    }

    fn implicit(&self, point: DVec3) -> f64 {
        let from_middle = point.truncate().length() - self.d;
        from_middle * from_middle + point.z * point.z - 1.0
    }

    fn equation(&self) -> String {
        format!("(√(x² + y²) − d)² + z² − 1, d = {}", crate::record::format_number(self.d))
    }

    fn parts(&self) -> Vec<String> {
        vec!["surface".to_owned()]
    }
}

impl Torus {
    /// The quartic in the shared t, with its working.
    fn entry<A: Real>(self, ray: &GenericRay<A>, quartic: &Quartic<A>, roots: Vec<f64>) -> Entry {
        let scale = ray.t_per_tau;
        let (line, number) = (&quartic.line, A::from_f64);
        let foot = report::measured(line.foot, scale);
        let nearest = report::measured_vector(line.nearest, 1.0);
        let a = report::measured(line.a, 1.0 / scale / scale);
        let k = report::measured(quartic.k, scale * scale);
        let p = report::measured(quartic.half_p + quartic.half_p, scale * scale);
        let q = number(4.0) * quartic.quarter_q;
        let q = report::measured(q, scale * scale * scale);
        let r = report::measured(quartic.r, scale * scale * scale * scale);
        let mut roots: Vec<_> = roots.into_iter().map(|tau| tau * scale).collect();
        roots.sort_by(f64::total_cmp);
        let ([l_x, l_y, _], [c_x, c_y, _]) = (nearest.value, ray.course());
        let bindings = [
            ("S", report::start(ray)),
            ("c", report::course(ray)),
            ("t₀", Value::Number(foot.value)),
            ("l", Value::Vector(nearest.value)),
            ("l_x", Value::Number(l_x)),
            ("l_y", Value::Number(l_y)),
            ("c_x", Value::Number(c_x)),
            ("c_y", Value::Number(c_y)),
            ("d", Value::Number(self.d)),
            ("A", Value::Number(a.value)),
            ("k", Value::Number(k.value)),
        ];
        let coefficients = [r.value, q.value, p.value, 0.0, 1.0];
        Entry::new(What::Quartic { coefficients, recentred_at: foot.value, roots })
            .line("A", "c·c", &bindings, a)
            .line("t₀", "−(S·c) / A", &bindings, foot)
            .line("l", "S + c t₀", &bindings, nearest)
            .line("k", "(l·l + d² − 1) / A", &bindings, k)
            .line("p", "2 k − 4 d² (c_x² + c_y²) / A²", &bindings, p)
            .line("q", "−8 d² (l_x c_x + l_y c_y) / A²", &bindings, q)
            .line("r", "k² − 4 d² (l_x² + l_y²) / A²", &bindings, r)
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::*;
    use super::*;
    use crate::record::Certificate;
    use proptest::prelude::*;

    impl Samples for Torus {
        fn samples() -> Vec<Self> {
            [0.3, 1.0, 1.6, 5.0].map(|d| Self::new(d).unwrap()).to_vec()
        }
    }

    fn torus(d: f64) -> Torus {
        Torus::new(d).unwrap()
    }

    fn appended<A: Real>(ray: &GenericRay<A>, found: &Found<A>) -> Crossings {
        let mut crossings = Crossings::new();
        Stretches { ray, found }.append(Sense::Enter, ray.t_per_tau, Certificate::Certain, &mut crossings);
        crossings
    }

    fn times(d: f64, origin: [f64; 3], direction: [f64; 3]) -> Vec<f64> {
        hits(&torus(d), origin, direction).into_iter().map(|hit| hit.0).collect()
    }

    #[test]
    fn a_ray_across_the_ring_enters_twice() {
        let surface = [(2.0, Enter), (4.0, Leave), (6.0, Enter), (8.0, Leave)].map(|(t, sense)| (t, sense, "surface"));
        expect(&torus(2.0), [-5.0, 0.0, 0.0], [1.0, 0.0, 0.0], &surface);
    }

    #[test]
    fn a_ray_through_the_hole_misses() {
        assert!(times(2.0, [0.0, 0.0, 5.0], [0.0, 0.0, -1.0]).is_empty());
        assert!(times(2.0, [0.5, 0.0, 5.0], [0.0, 0.1, -1.0]).is_empty());
    }

    #[test]
    fn rays_that_touch_from_outside_have_no_hits() {
        assert!(times(2.0, [3.0, -5.0, 0.0], [0.0, 1.0, 0.0]).is_empty());
        assert!(times(2.0, [-5.0, 0.0, 1.0], [1.0, 0.0, 0.0]).is_empty());
        assert!(times(2.0, [1.0, 0.0, 5.0], [0.0, 0.0, -1.0]).is_empty());
    }

    #[test]
    fn a_ray_that_touches_the_hole_from_inside_passes_through() {
        // x = 1 touches the inner equator; the outer one is met at y = ±√8.
        let found = times(2.0, [1.0, -5.0, 0.0], [0.0, 1.0, 0.0]);
        assert_eq!(found.len(), 2);
        assert!((found[0] - (5.0 - 8.0_f64.sqrt())).abs() < 1e-11);
    }

    #[test]
    fn a_ray_that_just_leaves_into_the_hole_is_right_where_the_slope_turns() {
        // At the height 0.28 the hole has the radius 1 − 0.96; its chord at x ends where y² = (0.04 − x) (0.04 + x).
        for gap in [1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10] {
            let found = times(1.0, [0.04 - gap, -1.0, 0.28], [0.0, 1.0, 0.0]);
            let half = (gap * (0.08 - gap)).sqrt();
            assert_eq!(found.len(), 4);
            assert!((found[1] - (1.0 - half)).abs() < 1e-15 / half, "{gap}: {found:?}");
            assert!((found[2] - (1.0 + half)).abs() < 1e-15 / half, "{gap}: {found:?}");
        }
    }

    #[test]
    fn inside_the_tube_and_behind() {
        assert_eq!(times(2.0, [2.0, 0.0, 0.0], [0.0, 0.0, 1.0]), [-1.0, 1.0]);
        assert_eq!(times(2.0, [5.0, 0.0, 0.0], [2.0, 0.0, 0.0]), [-4.0, -3.0, -2.0, -1.0]);
    }

    #[test]
    fn a_spindle_has_no_boundary_where_the_tube_overlaps_itself() {
        let (reports, crossings) = record(&torus(0.5), DVec3::new(-5.0, 0.0, 0.0), DVec3::X);
        let found: Vec<_> = crossings.iter().map(|hit| (hit.t * 1e9).round() / 1e9).collect();
        assert_eq!(found, [3.5, 6.5]);
        let Some(What::Roots { candidates }) = reports.last() else { panic!("{reports:?}") };
        let all: Vec<_> = candidates.iter().map(|candidate| (candidate.t * 1e9).round() / 1e9).collect();
        assert_eq!(all, [3.5, 4.5, 5.5, 6.5]);
    }

    #[test]
    fn the_axis_of_a_spindle_runs_from_tip_to_tip() {
        let found = times(0.6, [0.0, 0.0, -5.0], [0.0, 0.0, 1.0]);
        assert_eq!(found, [4.2, 5.8]);
    }

    #[test]
    fn the_hole_of_a_horn_torus_is_passed_from_inside_to_inside() {
        assert_eq!(times(1.0, [-5.0, 0.0, 0.0], [1.0, 0.0, 0.0]), [3.0, 7.0]);
        assert!(times(1.0, [0.0, 0.0, 5.0], [0.0, 0.0, -1.0]).is_empty());
    }

    #[test]
    fn the_quartic_is_that_of_the_substitution() {
        let (reports, _) = record(&torus(2.0), DVec3::new(-5.0, 0.0, 0.0), DVec3::X);
        let What::Quartic { coefficients, recentred_at, roots } = &reports[0] else { panic!("{reports:?}") };
        // (t² + 3)² − 16 t² = t⁴ − 10 t² + 9 about t = 5.
        assert_eq!((coefficients, *recentred_at), (&[9.0, 0.0, -10.0, 0.0, 1.0], 5.0));
        assert_eq!(roots.len(), 4);
    }

    #[test]
    fn a_ray_in_at_one_tip_of_a_spindle_comes_out_of_the_tube() {
        // With x = s and z = 0.8 − s it is F = 2 s² + 0.4 |s| before the tip and 2 s² − 2.8 s beyond it.
        assert_eq!(times(0.6, [-5.0, 0.0, 5.8], [1.0, 0.0, -1.0]), [5.0, 6.4]);
        assert_eq!(times(0.6, [5.0, 0.0, -5.8], [-1.0, 0.0, 1.0]), [5.0, 6.4]);
    }

    #[test]
    fn a_ray_that_grazes_a_tip_of_a_spindle_stays_inside() {
        assert_eq!(times(0.6, [-5.0, 0.0, 0.8], [1.0, 0.0, 0.0]), [3.8, 6.2]);
    }

    #[test]
    fn a_thin_torus_has_its_width() {
        for d in [1e3, 1e6] {
            let found = times(d, [-2.0 * d, 0.0, 0.0], [1.0, 0.0, 0.0]);
            assert_eq!(found, [d - 1.0, d + 1.0, 3.0 * d - 1.0, 3.0 * d + 1.0]);
        }
    }

    #[test]
    fn a_hundred_million_radii_away_it_still_has_its_width() {
        // At the height 0.6 the tube reaches 0.8 to either side of its middle.
        let hits = solve::<f64>(&torus(2.0), DVec3::new(1e8, 0.0, 0.6), DVec3::NEG_X);
        let expected = [-2.8, -1.2, 1.2, 2.8].map(|t| (1e8 + t) - 1e8);
        assert_eq!(hits.iter().map(|hit| hit.t - 1e8).collect::<Vec<_>>(), expected);
        assert!(hits.iter().all(|hit| hit.certificate == Certificate::Certain));
    }

    #[test]
    fn rays_that_touch_are_undecidable_and_ordinary_ones_certain() {
        let certificate = |origin: DVec3, direction: DVec3| {
            let (reports, _) = record(&torus(2.0), origin, direction);
            reports.into_iter().find_map(|what| match what {
                What::Decision { certificate, .. } => Some(certificate),
                _ => None,
            })
        };
        assert_eq!(certificate(DVec3::new(-5.0, 0.0, 1.0), DVec3::X), Some(Certificate::Undecidable));
        assert_eq!(certificate(DVec3::new(-5.0, 0.0, 0.5), DVec3::X), Some(Certificate::Certain));
        assert_eq!(certificate(DVec3::new(-5.0, 0.0, 3.5), DVec3::X), Some(Certificate::Certain));
        // 2⁻⁴² below the top: too near for f64, far enough for its inputs.
        let close = DVec3::new(-5.0, 0.0, 1.0 - 2.0_f64.powi(-42));
        assert_eq!(certificate(close, DVec3::X), Some(Certificate::Fallback));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        #[test]
        fn what_is_certain_near_a_tangent_is_so_with_more_digits(
            (u, v, turn) in (0.0..TAU, 0.0..TAU, 0.0..TAU),
            (gap, above) in (2.0..16.0_f64, any::<bool>()),
            (which, far) in (0..6_usize, 0.0..8.0_f64),
        ) {
            let d = [0.4, 1.0, 1.3, 2.0, 10.0, 1000.0][which];
            let normal = DVec3::new(u.cos() * v.cos(), u.sin() * v.cos(), v.sin());
            let on_surface = DVec3::new(u.cos() * d, u.sin() * d, 0.0) + normal;
            let across = DVec3::new(-u.sin(), u.cos(), 0.0);
            let along = across * turn.cos() + normal.cross(across) * turn.sin();
            let point = on_surface + normal * 10.0_f64.powf(-gap) * if above { 1.0 } else { -1.0 };
            let origin = point - along * 10.0_f64.powf(far);
            let ray = GenericRay::<f64>::new(origin, along);
            let (fast, sure) = (torus(d).solve(&ray), torus(d).solve(&ray.widen()));
            if fast.decided {
                let fast_hits = appended(&ray, &fast.found);
                let sure_hits = appended(&ray.widen(), &sure.found);
                prop_assert_eq!(fast_hits.len(), sure_hits.len());
                for (a, b) in fast_hits.iter().zip(&sure_hits) {
                    prop_assert!((a.t - b.t).abs() <= a.error, "{:?} {:?}", a, b);
                }
            }
        }
    }

    #[test]
    fn a_distance_of_zero_is_refused() {
        let message = "d is 0; the distance from the axis to the middle of the tube needs to be more than 0";
        assert_eq!(Torus::new(0.0).unwrap_err(), message);
        assert!(Torus::new(f64::INFINITY).is_err());
    }
}
