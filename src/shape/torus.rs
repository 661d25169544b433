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
//! **Accuracy** At every turning point of G its value is compared with a bound on its rounding error. Where a double root may
//! hide, all is worked out again with 32 digits; what these cannot tell from zero is a touch. The roots are then
//! polished on F itself, which cancels less than G. Thin tori (large d) and rays that touch set the bound.
//!
//! **Degenerate cases** Rays that touch from outside or from inside have no hit there. d = 1: the hole is one point, a ray
//! through it passes from inside to inside.
//!
//! **Source** Hill, Computer Graphics Using OpenGL, the generic torus; Yuksel, HPG 2022, for the roots.

use super::{Bounds, Crossing, GenericRay, Part, Primitive, boundary, boundary::Root, outline, report};
use crate::math::{Quartic, Real, dot};
use crate::record::{Candidate, Certificate, Entry, Recorder, Sense, Value, What};
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_PI_4, TAU};

/// A tube of radius 1 about the circle of radius d in the plane z = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torus {
    d: f64,
}

/// The quartic about the foot and its roots in τ.
struct Solution {
    foot: f64,
    nearest: [f64; 3],
    coefficients: [f64; 5],
    /// The roots that bound the solid.
    boundaries: Vec<f64>,
    /// The roots in the overlap of a spindle.
    hidden: Vec<f64>,
}

/// The parts of the quartic G(δ) = (a δ² + k)² − 4d² (α δ² + 2 β δ + γ), with the errors of k, β and γ.
struct Terms<A> {
    a: A,
    k: A,
    alpha: A,
    beta: A,
    gamma: A,
    k_error: f64,
    beta_error: f64,
    gamma_error: f64,
}

/// A place between roots: there G has this sign, 0 where it cannot be told from zero.
#[derive(Clone, Copy)]
struct Node<A> {
    delta: A,
    sign: i8,
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

    fn terms<A: Real>(self, ray: &GenericRay<A>, l: [A; 3]) -> Terms<A> {
        let d = A::from_f64(self.d);
        let [c_x, c_y, _] = ray.direction;
        let u = A::UNIT_ROUNDOFF;
        let l_error = 8.0 * u * (ray.reach() + 1.0);
        let size = l.iter().map(|x| x.abs().to_f64()).sum::<f64>();
        let l_squared = dot(l, l);
        let gamma = l[0] * l[0] + l[1] * l[1];
        Terms {
            a: dot(ray.direction, ray.direction),
            k: l_squared + d * d - A::ONE,
            alpha: c_x * c_x + c_y * c_y,
            beta: l[0] * c_x + l[1] * c_y,
            gamma,
            k_error: 2.0 * size * l_error + 4.0 * u * (l_squared.to_f64() + self.d * self.d + 1.0),
            beta_error: 4.0 * l_error + 8.0 * u * size,
            gamma_error: 2.0 * size * l_error + 4.0 * u * gamma.to_f64(),
        }
    }

    /// Bound on the error of G(δ).
    fn doubt<A: Real>(self, terms: &Terms<A>, delta: A) -> f64 {
        let u = A::UNIT_ROUNDOFF;
        let delta = delta.abs().to_f64();
        let [a, k, alpha, beta, gamma] =
            [terms.a, terms.k, terms.alpha, terms.beta, terms.gamma].map(|x| x.abs().to_f64());
        let radial = alpha * delta * delta + 2.0 * beta * delta + gamma;
        let whole = a * delta * delta + k;
        2.0 * whole * (terms.k_error + 8.0 * u * whole)
            + 4.0 * self.d * self.d * (8.0 * u * radial + 2.0 * terms.beta_error * delta + terms.gamma_error)
    }

    /// Solves about the foot; none where rounding hides how many roots there are.
    fn solve<A: Real>(self, ray: &GenericRay<A>) -> Option<Solution> {
        let foot = ray.foot();
        let l = ray.at(foot);
        let terms = self.terms(ray, l);
        let quartic = self.quartic(&terms, l);
        let mut solution = Solution {
            foot: foot.to_f64(),
            nearest: l.map(Real::to_f64),
            coefficients: quartic.coefficients.map(Real::to_f64),
            boundaries: Vec::new(),
            hidden: Vec::new(),
        };
        // A ball that holds the torus with room to spare: at its surface G is positive beyond doubt.
        let ball = 1.01 * (1.0 + self.d);
        let room = A::from_f64(ball * ball) - dot(l, l);
        if room <= A::ZERO {
            return Some(solution);
        }
        let end = (room / terms.a).sqrt();
        let nodes = self.nodes(&quartic, &terms, end)?;
        self.sort_roots(ray, &quartic, (foot, l), &nodes, &mut solution);
        Some(solution)
    }

    /// G as a quartic in δ. Its constant term is F times the other factor, for that cancels less.
    fn quartic<A: Real>(self, terms: &Terms<A>, l: [A; 3]) -> Quartic<A> {
        let d = A::from_f64(self.d);
        let four_d_squared = A::from_f64(4.0) * d * d;
        let radius = terms.gamma.sqrt();
        let height = l[2] * l[2] - A::ONE;
        let near = (radius - d) * (radius - d) + height;
        let far = (radius + d) * (radius + d) + height;
        let two = A::from_f64(2.0);
        Quartic {
            coefficients: [
                near * far,
                -(two * four_d_squared * terms.beta),
                two * terms.a * terms.k - four_d_squared * terms.alpha,
                A::ZERO,
                terms.a * terms.a,
            ],
        }
    }

    /// The ends and the turning points of G with its signs; none where a sign is in doubt.
    fn nodes<A: Real>(self, quartic: &Quartic<A>, terms: &Terms<A>, end: A) -> Option<Vec<Node<A>>> {
        let mut nodes = Vec::with_capacity(7);
        nodes.push(Node { delta: -end, sign: 1 });
        for &delta in quartic.separators(-end, end).as_slice() {
            let value = quartic.at(delta);
            let doubtful = value.abs().to_f64() <= self.doubt(terms, delta);
            if doubtful && !A::FINEST {
                return None;
            }
            let sign = if doubtful {
                0
            } else if value < A::ZERO {
                -1
            } else {
                1
            };
            nodes.push(Node { delta, sign });
        }
        nodes.push(Node { delta: end, sign: 1 });
        Some(nodes)
    }

    /// Finds the roots of G between the nodes and tells boundaries from roots within the overlap of a spindle.
    fn sort_roots<A: Real>(
        self,
        ray: &GenericRay<A>,
        quartic: &Quartic<A>,
        (foot, l): (A, [A; 3]),
        nodes: &[Node<A>],
        solution: &mut Solution,
    ) {
        let mut last = nodes[0];
        let mut touched = None;
        for node in &nodes[1..] {
            if node.sign == 0 {
                touched = Some(node.delta);
                continue;
            }
            let inside = |node: &Node<A>| node.sign < 0 || self.in_overlap(ray, l, node.delta);
            let crosses = inside(&last) != inside(node);
            if node.sign != last.sign {
                let rough = quartic.root_between(last.delta, node.delta, last.sign < 0);
                let root = (foot + self.polish(ray, l, rough, last.delta, node.delta)).to_f64();
                if crosses { &mut solution.boundaries } else { &mut solution.hidden }.push(root);
            } else if let Some(delta) = touched.filter(|_| crosses) {
                // Through the tip of a spindle, from the outside right into the overlap: a double root of G.
                solution.boundaries.push((foot + delta).to_f64());
            }
            (last, touched) = (*node, None);
        }
    }

    /// Two steps of Newton's method on F, not beyond `low` and `high`.
    #[expect(clippy::many_single_char_names, reason = "the symbols of the head of the file")]
    fn polish<A: Real>(self, ray: &GenericRay<A>, l: [A; 3], start: A, low: A, high: A) -> A {
        let d = A::from_f64(self.d);
        let [c_x, c_y, c_z] = ray.direction;
        let mut delta = start;
        for _ in 0..2 {
            let [x, y, z] = std::array::from_fn(|i| l[i] + ray.direction[i] * delta);
            let radius = (x * x + y * y).sqrt();
            let value = (radius - d) * (radius - d) + z * z - A::ONE;
            let half_slope = (radius - d) * (x * c_x + y * c_y) / radius + z * c_z;
            let next = delta - value / (half_slope + half_slope);
            if !(low < next && next < high) {
                break;
            }
            delta = next;
        }
        delta
    }

    /// Whether a place with G > 0 lies in the overlap of a spindle: there both factors of G are negative, and so is their
    /// sum, 2 (|p|² + d² − 1).
    fn in_overlap<A: Real>(self, ray: &GenericRay<A>, l: [A; 3], delta: A) -> bool {
        let p = std::array::from_fn(|i| l[i] + ray.direction[i] * delta);
        self.d < 1.0 && dot(p, p) < A::ONE - A::from_f64(self.d) * A::from_f64(self.d)
    }
}

impl Primitive for Torus {
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Vec<Crossing>) {
        let begin = crossings.len();
        let Some(solution) = self.solve(ray).or_else(|| self.solve(&ray.widen())) else { return };
        let root = |&tau: &f64| {
            let normal = self.normal(ray.point(A::from_f64(tau)), 0).to_array();
            Root { tau, error: ray.root_error(normal, tau), part: 0 }
        };
        let roots: Vec<_> = solution.boundaries.iter().map(root).collect();
        boundary::append_alternating(&roots, Sense::Enter, ray.t_per_tau, Certificate::Certain, crossings);
        let found = &crossings[begin..];
        recorder.note(|| self.working(ray, &solution));
        recorder.note(|| report::implicit(self, ray, found));
        recorder.note(|| report::roots(self, ray, found, self.rejected(ray, &solution)));
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

    fn bounds(&self) -> Bounds {
        let high = DVec3::new(self.d + 1.0, self.d + 1.0, 1.0);
        Bounds { low: -high, high }
    }

    /// Four circles about the axis and eight about the tube; of a spindle only what lies outside.
    fn outline(&self) -> Vec<Vec<DVec3>> {
        let outward = |radius: f64, z: f64| (radius > 0.0).then(|| outline::circle(radius, z));
        let about_axis = [(self.d + 1.0, 0.0), (self.d, 1.0), (self.d - 1.0, 0.0), (self.d, -1.0)];
        // A spindle's tube meets the axis at the angle ±reach from outward.
        let reach = if self.d < 1.0 { (-self.d).acos() } else { TAU / 2.0 };
        let about_tube = (0..8).map(|k| {
            let (sin, cos) = (f64::from(k) * FRAC_PI_4).sin_cos();
            let steps = 64;
            (-steps..=steps)
                .map(|step| {
                    let angle = reach * f64::from(step) / f64::from(steps);
                    let radius = self.d + angle.cos();
                    DVec3::new(radius * cos, radius * sin, angle.sin())
                })
                .collect()
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
    fn working<A: Real>(self, ray: &GenericRay<A>, solution: &Solution) -> Entry {
        let scale = ray.t_per_tau;
        let mut power = 1.0;
        let coefficients = solution.coefficients.map(|coefficient| {
            let shown = coefficient / power;
            power *= scale;
            shown
        });
        let mut roots: Vec<_> = solution.boundaries.iter().chain(&solution.hidden).map(|tau| tau * scale).collect();
        roots.sort_by(f64::total_cmp);
        let foot = solution.foot * scale;
        let (c, l) = (DVec3::from(ray.course()), DVec3::from(solution.nearest));
        let k = l.length_squared() + self.d * self.d - 1.0;
        let bindings = [
            ("S", report::start(ray)),
            ("c", report::course(ray)),
            ("t₀", Value::Number(foot)),
            ("l", Value::Vector(solution.nearest)),
            ("l_x", Value::Number(l.x)),
            ("l_y", Value::Number(l.y)),
            ("c_x", Value::Number(c.x)),
            ("c_y", Value::Number(c.y)),
            ("d", Value::Number(self.d)),
            ("k", Value::Number(k)),
        ];
        let [c0, c1, c2, c3, c4] = coefficients;
        Entry::new(What::Quartic { coefficients, recentred_at: foot, roots })
            .line("t₀", "−(S·c) / (c·c)", &bindings, foot)
            .line("l", "S + c t₀", &bindings, solution.nearest)
            .line("k", "l·l + d² − 1", &bindings, k)
            .line("c₄", "(c·c)²", &bindings, c4)
            .line("c₃", "4 c·c c·l", &bindings, c3)
            .line("c₂", "2 c·c k − 4 d² (c_x² + c_y²)", &bindings, c2)
            .line("c₁", "−8 d² (l_x c_x + l_y c_y)", &bindings, c1)
            .line("c₀", "k² − 4 d² (l_x² + l_y²)", &bindings, c0)
    }

    fn rejected<A: Real>(self, ray: &GenericRay<A>, solution: &Solution) -> Vec<Candidate> {
        let senses = [Sense::Leave, Sense::Enter];
        let reason = "a root of the quartic, but F is negative on both sides: it lies where the tube overlaps itself";
        solution
            .hidden
            .iter()
            .zip(senses.into_iter().cycle())
            .map(|(&tau, sense)| report::rejected(&self, ray, (tau, 0, sense), reason.to_owned()))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::*;
    use super::*;

    impl Samples for Torus {
        fn samples() -> Vec<Self> {
            [0.3, 1.0, 1.6, 5.0].map(|d| Self::new(d).unwrap()).to_vec()
        }
    }

    fn torus(d: f64) -> Torus {
        Torus::new(d).unwrap()
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
    fn a_distance_of_zero_is_refused() {
        let message = "d is 0; the distance from the axis to the middle of the tube needs to be more than 0";
        assert_eq!(Torus::new(0.0).unwrap_err(), message);
        assert!(Torus::new(f64::INFINITY).is_err());
    }
}
