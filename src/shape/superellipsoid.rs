//! The superellipsoid (§ 6.2.4): a numeric search for every zero of d(t), with proof.
//!
//! **Shape** (a quarter of the section z = 0, for three exponents n)
//! ```text
//!   y ↑
//!   1 +-------.___    n = 4
//!     |'.  '-.    '.
//!     |  '.   '.    \
//!     |.   '.   \    |
//!     | '-.  '.  |   |     n = 2: circle, n = 1: straight,
//!     +------'-'-+---+→ x  n < 1: hollow, with sharp tips
//! ```
//! **Equation** F = (|x|ⁿ + |y|ⁿ)^(m/n) + |z|ᵐ − 1 with n, m > 0.
//!
//! **Ray equation** F itself is far too steep for large exponents. The search works on the gauge g = (F + 1)^(1/m), which is
//! homogeneous of degree 1: it grows along the ray at most as fast as the point moves. g − 1 has the sign and zeros of F.
//! With u = x ∂g/∂x / g and so on, the shares of the coordinates in g, (ln g)′ = Σ uᵢ cᵢ / xᵢ.
//!
//! **Proof** that no root is missed: for n, m ≥ 1 g is convex along the ray; for n, m ≤ 1 it is concave between the coordinate
//! planes (`superellipsoid_search.rs`); else it is the sign of a difference of two convex or two concave functions
//! (`superellipsoid_mixed.rs`). Tangents and chords of such functions are bounds.
//!
//! **Accuracy** The last step to each root is taken from coordinates S + c t without error but their last rounding. What is
//! left is the rounding of the powers, a few u (1 + 1/n + 1/m) in g. Creases and tips (exponents below 1) make t as bad as
//! the power of the error there. Signs that double precision cannot tell are asked for again with 32 digits.
//!
//! **Degenerate cases** Rays that touch have no hit. Where the gradient does not exist (tips, creases) the normal is that of
//! the nearest smooth direction.
//!
//! **Source** A. H. Barr, "Superquadrics and angle-preserving transformations", IEEE CG&A 1(1), 1981; D. P. Mitchell,
//! "Robust ray intersection with interval arithmetic", Graphics Interface 1990.

use super::boundary::Boundaries;
use super::gauge::Exponents;
use super::solver::{self, Attempt, Call, Solver};
use super::superellipsoid_line::Line;
use super::superellipsoid_search::{Findings, Wanted, search};
use super::{Approach, Bounds, Crossing, Crossings, GenericRay, Part, Primitive, report, tangents};
use crate::math::{Real, portable};
use crate::record::{Candidate, Entry, Recorder, Value, What, format_number};
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// (|x|ⁿ + |y|ⁿ)^(m/n) + |z|ᵐ ≤ 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Superellipsoid {
    pub(super) exponents: Exponents,
}

impl Superellipsoid {
    /// The superellipsoid with exponent `n` in x and y, and `m` in z.
    ///
    /// # Errors
    /// Says so when an exponent is 0 or less, or not finite.
    pub fn new(n: f64, m: f64) -> Result<Self, String> {
        for (name, exponent) in [("n", n), ("m", m)] {
            if !(exponent.is_finite() && exponent > 0.0) {
                return Err(format!("{name} is {exponent}; an exponent needs to be more than 0"));
            }
        }
        Ok(Self { exponents: Exponents::new(n, m) })
    }

    /// The exponents n, of x and y, and m, of z.
    #[must_use]
    pub fn exponents(&self) -> [f64; 2] {
        [self.exponents.of_axis(0), self.exponents.of_axis(2)]
    }
}

/// cos and sin to the power 2 / exponent, with their signs: a curve on which |a|^exponent + |b|^exponent = 1.
fn super_circle(angle: f64, exponent: f64) -> DVec2 {
    let power = |x: f64| x.signum() * portable::powf(x.abs(), 2.0 / exponent);
    // The quarter turns exactly: there the sine or cosine is zero but for rounding.
    let (sin, cos) = portable::sin_cos(angle);
    let clean = |x: f64| if x.abs() < 1e-15 { 0.0 } else { x };
    DVec2::new(power(clean(cos)), power(clean(sin)))
}

impl Solver for Superellipsoid {
    type Found<A: Real> = Findings<A>;

    #[inline]
    fn solve<A: Real>(&self, ray: &GenericRay<A>) -> Attempt<Findings<A>> {
        search(&self.exponents, ray, Wanted::All)
    }

    #[inline]
    fn solve_ahead<A: Real>(&self, ray: &GenericRay<A>) -> Attempt<Findings<A>> {
        search(&self.exponents, ray, Wanted::FirstAhead)
    }

    fn closest_call<A: Real>(&self, ray: &GenericRay<A>, found: &Findings<A>) -> Call {
        let line = Line::new(&self.exponents, ray);
        // Where nothing was asked, the ray is clear of all that holds the solid.
        let probe = line.probe(found.closest.map_or(A::ZERO, |closest| closest.at));
        Call {
            question: "Is the ray inside at the closest place, g < 1?",
            value: portable::exp_m1(probe.log),
            doubt: line.doubt(&probe).log,
            input_doubt: line.input_doubt(probe.at),
            near: (line.foot + probe.at).to_f64(),
        }
    }

    #[inline]
    fn roots<A: Real>(&self, _: &GenericRay<A>, found: &Findings<A>) -> impl Boundaries {
        &found.roots
    }

    fn working<A: Real>(&self, ray: &GenericRay<A>, found: &Findings<A>) -> Vec<Entry> {
        vec![self.working(ray, found)]
    }

    fn rejected<A: Real>(&self, _: &GenericRay<A>, _: &Findings<A>, _: &[Crossing]) -> Vec<Candidate> {
        Vec::new()
    }
}

impl Superellipsoid {
    /// The search in the shared t, with F at each root.
    fn working<A: Real>(&self, ray: &GenericRay<A>, found: &Findings<A>) -> Entry {
        let scale = ray.t_per_tau;
        let roots = found.roots.as_ref();
        let Exponents { n, m, .. } = self.exponents;
        let mut entry = Entry::new(What::Search {
            range: found.range.map(|ends| ends.map(|tau| tau * scale)),
            stretches: found.stretches,
            undecided: found.undecided,
            roots: roots.iter().map(|root| root.tau * scale).collect(),
        });
        for (k, root) in roots.iter().enumerate() {
            let place = ray.at(A::from_f64(root.tau));
            let [x, y, z] = place.map(|x| Value::Number(x.to_f64()));
            let bindings = [("x", x), ("y", y), ("z", z), ("n", Value::Number(n)), ("m", Value::Number(m))];
            let symbol = format!("F(t{})", ['₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈'].get(k).unwrap_or(&'ₖ'));
            let excess = report::measured(self.exponents.level(place.map(Real::abs)).excess, 1.0);
            entry = entry.line(symbol, "(|x|^n + |y|^n)^(m/n) + |z|^m − 1", &bindings, excess);
        }
        entry
    }
}

impl Primitive for Superellipsoid {
    #[inline]
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Crossings) {
        solver::crossings(self, ray, recorder, crossings);
    }

    #[inline]
    fn first_crossing<A: Real>(&self, approach: &impl Approach) -> Option<Crossing> {
        solver::first_crossing::<A>(self, approach)
    }

    fn normal(&self, point: DVec3, _part: Part) -> DVec3 {
        let (_, gradient) = self.exponents.gauge(point.abs().to_array());
        let normal = DVec3::from_array(gradient) * point.signum();
        // In a crease the gradient is infinite across it; one infinite component outweighs the rest.
        let infinite = |x: f64| if x.is_infinite() { x.signum() } else { 0.0 };
        let sharp = DVec3::new(infinite(normal.x), infinite(normal.y), infinite(normal.z));
        [normal, sharp, point].into_iter().find(|n| n.is_finite() && *n != DVec3::ZERO).unwrap_or(DVec3::Z)
    }

    /// u is the longitude from the x axis, v the latitude from the south pole.
    fn uv(&self, point: DVec3, _part: Part) -> DVec2 {
        let latitude = portable::atan2(point.z, point.truncate().length());
        DVec2::new(super::sphere::turn(point.truncate()), ((latitude + FRAC_PI_2) / PI).clamp(0.0, 1.0))
    }

    fn uv_period(&self, _part: Part) -> [Option<f64>; 2] {
        [Some(1.0), None]
    }

    fn is_convex(&self) -> bool {
        self.exponents.n >= 1.0 && self.exponents.m >= 1.0
    }

    fn tangents(&self, point: DVec3, part: Part) -> [DVec3; 2] {
        tangents::seen_from_middle(point, self.normal(point, part))
    }

    fn bounds(&self) -> Bounds {
        Bounds { low: DVec3::NEG_ONE, high: DVec3::ONE }
    }

    /// Exponents up to 2 make sums of powers no smaller than the sum of squares.
    fn ball_radius(&self) -> f64 {
        if self.exponents.n <= 2.0 && self.exponents.m <= 2.0 { 1.0 } else { 3.0_f64.sqrt() }
    }

    /// The equator, two parallels and four meridians.
    fn outline(&self) -> Vec<Vec<DVec3>> {
        const STEPS: i32 = 96;
        let Exponents { n, m, .. } = self.exponents;
        let angle = |step: i32| TAU * f64::from(step) / f64::from(STEPS);
        let curve = |point: &dyn Fn(f64) -> DVec3| (0..=STEPS).map(|step| point(angle(step % STEPS))).collect();
        let parallels = [-1.0, 0.0, 1.0].map(|k: f64| {
            let section = super_circle(k * PI / 6.0, m);
            curve(&|angle| (super_circle(angle, n) * section.x).extend(section.y))
        });
        let meridians = [0.0, 1.0, 2.0, 3.0].map(|k: f64| {
            let direction = super_circle(k * PI / 4.0, n);
            curve(&|angle| {
                let section = super_circle(angle, m);
                (direction * section.x).extend(section.y)
            })
        });
        parallels.into_iter().chain(meridians).collect()
    }

    fn implicit(&self, point: DVec3) -> f64 {
        let Exponents { n, m, .. } = self.exponents;
        let [x, y, z] = point.abs().to_array();
        // The larger of x and y is taken out of the sum, which then lies between 1 and 2.
        let (most, least) = (x.max(y), x.min(y));
        let ratio = if most > 0.0 { least / most } else { 0.0 };
        let sum = 1.0 + portable::powf(ratio, n);
        let (large, wide) = (portable::powf(most, m), portable::powf(sum, m / n));
        // The one may vanish where the other one overflows, though their product does neither.
        let is_plain = wide.is_finite() && (large.is_normal() || most == 0.0);
        let radius = if is_plain { large * wide } else { portable::powf(most * portable::powf(sum, 1.0 / n), m) };
        radius + portable::powf(z, m) - 1.0
    }

    fn equation(&self) -> String {
        let Exponents { n, m, .. } = self.exponents;
        format!("(|x|ⁿ + |y|ⁿ)^(m/n) + |z|ᵐ − 1, n = {}, m = {}", format_number(n), format_number(m))
    }

    fn parts(&self) -> Vec<String> {
        vec!["surface".to_owned()]
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::*;
    use super::*;

    impl Samples for Superellipsoid {
        fn samples() -> Vec<Self> {
            [(2.0, 2.0), (0.6, 0.6), (1.0, 1.0), (4.0, 0.8), (0.7, 3.0), (8.0, 8.0)]
                .map(|(n, m)| Self::new(n, m).unwrap())
                .to_vec()
        }
    }

    fn times(n: f64, m: f64, origin: [f64; 3], direction: [f64; 3]) -> Vec<f64> {
        let shape = Superellipsoid::new(n, m).unwrap();
        solve::<f64>(&shape, origin.into(), direction.into()).iter().map(|hit| hit.t).collect()
    }

    #[track_caller]
    fn near(found: &[f64], expected: &[f64]) {
        assert_eq!(found.len(), expected.len(), "{found:?} for {expected:?}");
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?} for {expected:?}");
    }

    #[test]
    fn far_inside_where_one_factor_vanishes_and_the_other_overflows_the_value_is_minus_one() {
        // (0.4759^0.3 + 0.0043^0.3)^(10000/3) = 7.84 · 10⁻⁸, by 40 digits; 0.4759¹⁰⁰⁰ alone is below the range of f64.
        let shape = Superellipsoid::new(0.3, 1000.0).unwrap();
        let value = shape.implicit(DVec3::new(-0.475_896, -0.004_285_28, -0.679_34));
        assert!((value + 1.0).abs() < 2e-7, "{value}");
    }

    #[test]
    fn with_exponents_of_two_it_is_the_sphere() {
        near(&times(2.0, 2.0, [3.0, 0.0, 0.0], [-1.0, 0.0, 0.0]), &[2.0, 4.0]);
        near(&times(2.0, 2.0, [-2.0, 0.6, 0.0], [1.0, 0.0, 0.0]), &[1.2, 2.8]);
        assert!(times(2.0, 2.0, [-2.0, 1.0, 0.0], [1.0, 0.0, 0.0]).is_empty());
        assert!(times(2.0, 2.0, [-2.0, 1.5, 0.0], [1.0, 0.0, 0.0]).is_empty());
    }

    #[test]
    fn with_exponents_of_one_it_is_the_octahedron() {
        near(&times(1.0, 1.0, [2.0, 2.0, 2.0], [-1.0, -1.0, -1.0]), &[5.0 / 3.0, 7.0 / 3.0]);
        near(&times(1.0, 1.0, [-2.0, 0.25, 0.25], [1.0, 0.0, 0.0]), &[1.5, 2.5]);
        assert!(times(1.0, 1.0, [-2.0, 0.5, 0.5], [1.0, 0.0, 0.0]).is_empty());
    }

    #[test]
    fn inside_and_behind() {
        near(&times(4.0, 4.0, [0.0, 0.0, 0.5], [0.0, 0.0, 1.0]), &[-1.5, 0.5]);
        near(&times(4.0, 4.0, [3.0, 0.0, 0.0], [2.0, 0.0, 0.0]), &[-2.0, -1.0]);
    }

    #[test]
    fn a_hollow_one_is_met_where_the_roots_add_up_to_one() {
        // √|x| + √0.25 = 1 at x = ±0.25.
        near(&times(0.5, 0.5, [-1.0, 0.25, 0.0], [1.0, 0.0, 0.0]), &[0.75, 1.25]);
    }

    #[test]
    fn a_ray_past_the_hollow_cuts_two_tips() {
        // On x + y = 0.9: √x + √y = 1 at x = ((1 ± √0.8) / 2)², and past the axes √0.9025 + √0.0025 = 1.
        let inner = f64::midpoint(1.0, 0.8_f64.sqrt()).powi(2);
        let found = times(0.5, 0.5, [1.0, -0.1, 0.0], [-1.0, 1.0, 0.0]);
        near(&found, &[0.0975, 1.0 - inner, 0.1 + inner, 1.0025]);
    }

    #[test]
    fn a_ray_that_touches_a_flat_pole_has_no_hits() {
        assert!(times(4.0, 4.0, [-2.0, 0.0, 1.0], [1.0, 0.0, 0.0]).is_empty());
        assert!(times(0.5, 3.0, [-2.0, -2.0, 1.0], [1.0, 1.0, 0.0]).is_empty());
    }

    #[test]
    fn an_easy_ray_leaves_nothing_undecided() {
        let shape = Superellipsoid::new(0.7, 3.0).unwrap();
        let (reports, _) = record(&shape, DVec3::new(3.0, 1.0, 0.5), DVec3::new(-3.0, -0.8, -0.4));
        let What::Search { stretches, undecided, roots, range } = &reports[0] else { panic!("{reports:?}") };
        assert!(*undecided == 0 && *stretches < 100 && range.is_some() && roots.len() == 2, "{reports:?}");
    }

    #[test]
    fn exponents_of_zero_are_refused() {
        assert_eq!(Superellipsoid::new(0.0, 2.0).unwrap_err(), "n is 0; an exponent needs to be more than 0");
        assert_eq!(Superellipsoid::new(2.0, -1.0).unwrap_err(), "m is -1; an exponent needs to be more than 0");
    }
}
