//! The tapered cylinder: radius 1 at z = 0, radius s at z = 1, closed by discs (§ 6.2.2).
//!
//! **Shape** (from the side)
//! ```text
//!              s
//!   z = 1   +-----+      cap
//!          /   |   \
//!         /    |    \    wall
//!        /     |     \
//!   z = 0 +----+------+  base
//!              1
//! ```
//! **Equation** With w = 1 + (s − 1) z, the radius at height z: F = max(x² + y² − w², −z, z − 1).
//!
//! **Ray equation** For the wall A t² + 2 B t + C = 0 with d = (s − 1) c_z: A = c_x² + c_y² − d²,
//! B = S_x c_x + S_y c_y − w d, C = S_x² + S_y² − w², where S is taken at the foot of the perpendicular from the origin. For
//! the discs t = −S_z / c_z and t = (1 − S_z) / c_z. The solid is convex: inside is where the ray is inside the wall
//! **and** between the discs, so entering is the later and leaving the earlier of two times. That settles all combinations of
//! wall, base and cap at once.
//!
//! **Accuracy** The discriminant is the sum p² + q² − r² of 2×2 minors of S and c, which cancels less than B² − A C. Where
//! rounding hides its sign, or which of two times comes first, all is worked out again with 32 digits. The hard case is the
//! ray along a side of the cone.
//!
//! **Degenerate cases** A = 0: the ray is parallel to a side, and the wall is met once. A < 0: the ray is steeper than the
//! side; it meets the wall once, and the other nappe of the double cone once, which does not count. A ray through the apex
//! (s = 0) meets both nappes there. Rays within a disc are inside the closed solid; rays within the wall only touch it.
//!
//! **Source** Hill, Computer Graphics Using OpenGL, the generic tapered cylinder; Numerical Recipes § 5.6 for the roots.

use super::tapered_wall::{End, Wall};
use super::{
    Bounds, Crossing, GenericRay, HalfSpace, Part, Primitive, boundary, boundary::Root, outline, planes, report,
};
use crate::math::{Quadratic, Real};
use crate::record::{Candidate, Certificate, Entry, Recorder, Sense, Value, What, format_number};
use glam::{DVec2, DVec3};

pub(super) const WALL: Part = 0;
const BASE: Part = 1;
const CAP: Part = 2;

/// Radius 1 at z = 0, radius s at z = 1, closed by discs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaperedCylinder {
    pub(super) s: f64,
}

/// What the solver found, in τ.
struct Solution {
    /// Where the ray goes in and out.
    inside: Option<[Root; 2]>,
    /// The wall's quadratic about the foot.
    wall: Quadratic<f64>,
    foot: f64,
    /// The point at the foot.
    nearest: [f64; 3],
    /// The roots of the wall's quadratic, double cone and all; infinite where A = 0.
    wall_roots: Option<[f64; 2]>,
    /// Base and cap times; none where the ray is parallel to them.
    discs: Option<[f64; 2]>,
}

impl TaperedCylinder {
    /// The tapered cylinder whose cap has radius `s`.
    ///
    /// # Errors
    /// Says so when `s` is negative or not finite.
    pub fn new(s: f64) -> Result<Self, String> {
        if s.is_finite() && s >= 0.0 {
            return Ok(Self { s });
        }
        Err(format!("s is {s}; the cap's radius needs to be 0 or more"))
    }

    /// The radius at height z.
    #[must_use]
    pub fn radius(self, z: f64) -> f64 {
        1.0 + self.slope() * z
    }

    fn slope(self) -> f64 {
        self.s - 1.0
    }

    /// Finds where the ray goes in and out; none where rounding hides the answer.
    fn solve<A: Real>(self, ray: &GenericRay<A>) -> Option<Solution> {
        let foot = ray.foot();
        let l = ray.at(foot);
        let wall = Wall::new(self.s, ray, l)?;
        let discs = Self::discs(ray);
        let inside = match Self::between_discs(ray, discs) {
            None => None,
            Some(slab) => wall.clip(ray, foot, slab)?,
        };
        let plain = |x: A| x.to_f64();
        let q = &wall.quadratic;
        Some(Solution {
            inside,
            wall: Quadratic { a: plain(q.a), b: plain(q.b), c: plain(q.c), discriminant: plain(q.discriminant) },
            foot: foot.to_f64(),
            nearest: l.map(plain),
            wall_roots: q.roots().map(|roots| roots.map(|delta| plain(foot + delta))),
            discs: discs.map(|times| times.map(plain)),
        })
    }

    /// The times at which the ray meets the planes of base and cap.
    fn discs<A: Real>(ray: &GenericRay<A>) -> Option<[A; 2]> {
        let (s_z, c_z) = (ray.origin[2], ray.direction[2]);
        (c_z != A::ZERO).then(|| [-s_z / c_z, (A::ONE - s_z) / c_z])
    }

    /// The stretch between the planes of the discs; infinite ends for a ray that runs between them, none for a miss.
    fn between_discs<A: Real>(ray: &GenericRay<A>, discs: Option<[A; 2]>) -> Option<[End<A>; 2]> {
        let end = |tau: A, part| End { tau, error: A::from_f64(4.0 * A::UNIT_ROUNDOFF) * tau.abs(), part };
        let infinity = A::from_f64(f64::INFINITY);
        match discs {
            None if ray.origin[2] < A::ZERO || ray.origin[2] > A::ONE => None,
            None => Some([-infinity, infinity].map(|tau| End { tau, error: A::ZERO, part: WALL })),
            Some([base, cap]) if ray.direction[2] > A::ZERO => Some([end(base, BASE), end(cap, CAP)]),
            Some([base, cap]) => Some([end(cap, CAP), end(base, BASE)]),
        }
    }
}

impl Primitive for TaperedCylinder {
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Vec<Crossing>) {
        let begin = crossings.len();
        let Some(solution) = self.solve(ray).or_else(|| self.solve(&ray.widen())) else { return };
        if let Some(inside) = solution.inside {
            let inside = inside.map(|root| {
                let normal = self.normal(ray.point(A::from_f64(root.tau)), root.part).to_array();
                Root { error: ray.root_error(normal, root.tau), ..root }
            });
            boundary::append_alternating(&inside, Sense::Enter, ray.t_per_tau, Certificate::Certain, crossings);
        }
        let found = &crossings[begin..];
        recorder.note(|| planes::axis_table(ray, &DISCS));
        recorder.note(|| self.working(ray, &solution));
        recorder.note(|| report::implicit(self, ray, found));
        recorder.note(|| report::roots(self, ray, found, self.rejected(ray, &solution, found)));
    }

    fn normal(&self, point: DVec3, part: Part) -> DVec3 {
        match part {
            BASE => DVec3::NEG_Z,
            CAP => DVec3::Z,
            _ => {
                let radius = point.truncate().length();
                // At the apex every direction between the sides would do; along the axis is the fair one.
                if radius > 0.0 { DVec3::new(point.x, point.y, -self.slope() * radius) } else { DVec3::Z }
            }
        }
    }

    /// On the wall u is the turn about the axis and v the height; on the discs x and y.
    fn uv(&self, point: DVec3, part: Part) -> DVec2 {
        let flat = |radius: f64| ((point.truncate() / radius + 1.0) * 0.5).clamp(DVec2::ZERO, DVec2::ONE);
        match part {
            BASE => flat(1.0),
            CAP if self.s > 0.0 => flat(self.s),
            CAP => DVec2::splat(0.5),
            _ => DVec2::new(super::sphere::turn(point.truncate()), point.z.clamp(0.0, 1.0)),
        }
    }

    fn bounds(&self) -> Bounds {
        let radius = self.s.max(1.0);
        Bounds { low: DVec3::new(-radius, -radius, 0.0), high: DVec3::new(radius, radius, 1.0) }
    }

    /// The rims, and eight lines up the wall.
    fn outline(&self) -> Vec<Vec<DVec3>> {
        let side = |k: u32| {
            let (sin, cos) = (f64::from(k) * std::f64::consts::FRAC_PI_4).sin_cos();
            vec![DVec3::new(cos, sin, 0.0), DVec3::new(self.s * cos, self.s * sin, 1.0)]
        };
        let cap = (self.s > 0.0).then(|| outline::circle(self.s, 1.0));
        [outline::circle(1.0, 0.0)].into_iter().chain(cap).chain((0..8).map(side)).collect()
    }

    fn implicit(&self, point: DVec3) -> f64 {
        let radius = self.radius(point.z);
        (point.truncate().length_squared() - radius * radius).max(-point.z).max(point.z - 1.0)
    }

    fn equation(&self) -> String {
        let (radius, given) = match self.s {
            1.0 => ("1", String::new()),
            0.0 => ("(1 − z)²", String::new()),
            s => ("(1 + (s − 1) z)²", format!(", s = {}", format_number(s))),
        };
        format!("max(x² + y² − {radius}, −z, z − 1){given}")
    }

    fn parts(&self) -> Vec<String> {
        ["wall", "base", "cap"].map(str::to_owned).to_vec()
    }
}

/// The planes of the discs.
const DISCS: [(HalfSpace, &str); 2] =
    [(HalfSpace { normal: DVec3::NEG_Z, offset: 0.0 }, "base"), (HalfSpace { normal: DVec3::Z, offset: 1.0 }, "cap")];

impl TaperedCylinder {
    /// The wall's quadratic in the shared t, with its working.
    #[expect(clippy::many_single_char_names, reason = "the symbols of the head of the file")]
    fn working<A: Real>(self, ray: &GenericRay<A>, solution: &Solution) -> Entry {
        let scale = ray.t_per_tau;
        let Quadratic { a, b, c, discriminant } = solution.wall;
        let (a, b, discriminant) = (a / scale / scale, b / scale, discriminant / scale / scale);
        let (foot, [x, y, z], [c_x, c_y, c_z]) = (solution.foot * scale, solution.nearest, ray.course());
        let roots: Vec<_> =
            solution.wall_roots.into_iter().flatten().map(|tau| tau * scale).filter(|t| t.is_finite()).collect();
        let number = Value::Number;
        let bindings = [
            ("S", report::start(ray)),
            ("c", report::course(ray)),
            ("s", number(self.s)),
            ("t₀", number(foot)),
            ("l_x", number(x)),
            ("l_y", number(y)),
            ("l_z", number(z)),
            ("c_x", number(c_x)),
            ("c_y", number(c_y)),
            ("c_z", number(c_z)),
            ("w", number(self.radius(z))),
            ("d", number(self.slope() * c_z)),
            ("A", number(a)),
            ("B", number(b)),
            ("C", number(c)),
            ("D", number(discriminant)),
        ];
        let about = "the wall x² + y² = (1 + (s − 1) z)²".to_owned();
        let mut entry =
            Entry::new(What::Quadratic { about, a, b, c, discriminant, recentred_at: foot, roots: roots.clone() })
                .line("t₀", "−(S·c) / (c·c)", &bindings, foot)
                .line("l", "S + c t₀", &bindings, solution.nearest)
                .line("w", "1 + (s − 1) l_z", &bindings, self.radius(z))
                .line("d", "(s − 1) c_z", &bindings, self.slope() * c_z)
                .line("A", "c_x² + c_y² − d²", &bindings, a)
                .line("B", "l_x c_x + l_y c_y − w d", &bindings, b)
                .line("C", "l_x² + l_y² − w²", &bindings, c)
                .line("D", "B² − A C", &bindings, discriminant);
        if let [first, second] = roots[..] {
            let (low, high) = if a > 0.0 { ("−", "+") } else { ("+", "−") };
            entry = entry.line("t₁", &format!("t₀ + (−B {low} √D) / A"), &bindings, first).line(
                "t₂",
                &format!("t₀ + (−B {high} √D) / A"),
                &bindings,
                second,
            );
        } else if let [only] = roots[..] {
            entry = entry.line("t", "t₀ − C / (2 B)", &bindings, only);
        }
        entry
    }

    /// The times that were looked at and are not on the solid.
    fn rejected<A: Real>(self, ray: &GenericRay<A>, solution: &Solution, found: &[Crossing]) -> Vec<Candidate> {
        let [enters, leaves] = [Sense::Enter, Sense::Leave];
        let upward = ray.direction[2] > A::ZERO;
        let (base, cap) = if upward { (enters, leaves) } else { (leaves, enters) };
        let [first, second] = if solution.wall.a < 0.0 { [leaves, enters] } else { [enters, leaves] };
        let wall =
            solution.wall_roots.into_iter().flatten().zip([first, second]).map(|(tau, sense)| (tau, WALL, sense));
        let discs = solution.discs.into_iter().flat_map(|[b, c]| [(b, BASE, base), (c, CAP, cap)]);
        wall.chain(discs)
            .filter(|&(tau, part, _)| {
                let t = tau * ray.t_per_tau;
                t.is_finite() && !found.iter().any(|hit| hit.part == part && hit.t.to_bits() == t.to_bits())
            })
            .map(|hit| report::rejected(&self, ray, hit, self.reason(ray.point(A::from_f64(hit.0)), hit.1)))
            .collect()
    }

    /// Why a point of the given part's surface is not on the solid.
    fn reason(self, point: DVec3, part: Part) -> String {
        let radius = point.truncate().length();
        let beyond = |limit: f64, name: &str| {
            format!("{} from the axis, beyond the {name}'s radius {}", format_number(radius), format_number(limit))
        };
        match part {
            BASE if radius > 1.0 => beyond(1.0, "base"),
            CAP if radius > self.s => beyond(self.s, "cap"),
            WALL if point.z < 0.0 => format!("z = {}, below the base", format_number(point.z)),
            WALL if point.z > 1.0 => format!("z = {}, above the cap", format_number(point.z)),
            _ => "only touched there, without a length inside".to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::*;
    use super::*;

    impl Samples for TaperedCylinder {
        fn samples() -> Vec<Self> {
            [0.0, 0.4, 1.0, 2.5].map(|s| Self::new(s).unwrap()).to_vec()
        }
    }

    fn tapered(s: f64) -> TaperedCylinder {
        TaperedCylinder::new(s).unwrap()
    }

    #[test]
    fn wall_and_wall() {
        // The radius at half height is 0.75.
        expect(&tapered(0.5), [-2.0, 0.0, 0.5], [1.0, 0.0, 0.0], &[(1.25, Enter, "wall"), (2.75, Leave, "wall")]);
        expect(&tapered(2.0), [-3.0, 0.0, 0.5], [1.0, 0.0, 0.0], &[(1.5, Enter, "wall"), (4.5, Leave, "wall")]);
    }

    #[test]
    fn wall_and_cap_in_either_order() {
        // In at (−0.8, 0, 0.4), where the radius is 0.8, and out at (0.2, 0, 1).
        let (forth, back) = ([1.0, 0.0, 0.6], [-1.0, 0.0, -0.6]);
        expect(&tapered(0.5), [-1.8, 0.0, -0.2], forth, &[(1.0, Enter, "wall"), (2.0, Leave, "cap")]);
        expect(&tapered(0.5), [1.2, 0.0, 1.6], back, &[(1.0, Enter, "cap"), (2.0, Leave, "wall")]);
    }

    #[test]
    fn base_and_wall_in_either_order() {
        // In at the origin, out at (0.75, 0, 0.5).
        let (forth, back) = ([0.75, 0.0, 0.5], [-0.75, 0.0, -0.5]);
        expect(&tapered(0.5), [-0.75, 0.0, -0.5], forth, &[(1.0, Enter, "base"), (2.0, Leave, "wall")]);
        expect(&tapered(0.5), [1.5, 0.0, 1.0], back, &[(1.0, Enter, "wall"), (2.0, Leave, "base")]);
    }

    #[test]
    fn base_and_cap_in_either_order() {
        expect(&tapered(0.5), [0.1, 0.0, -1.0], [0.0, 0.0, 1.0], &[(1.0, Enter, "base"), (2.0, Leave, "cap")]);
        expect(&tapered(0.5), [0.1, 0.0, 2.0], [0.0, 0.0, -1.0], &[(1.0, Enter, "cap"), (2.0, Leave, "base")]);
    }

    #[test]
    fn a_ray_that_touches_the_rim_alone_has_no_hits() {
        // Through (0.5, 0, 1) and down, flatter than the wall.
        expect(&tapered(0.5), [-0.5, 0.0, 1.25], [1.0, 0.0, -0.25], &[]);
    }

    #[test]
    fn a_ray_in_the_plane_of_the_cap_crosses_from_rim_to_rim() {
        expect(&tapered(0.5), [-2.0, 0.0, 1.0], [1.0, 0.0, 0.0], &[(1.5, Enter, "wall"), (2.5, Leave, "wall")]);
    }

    #[test]
    fn misses_above_below_and_beside() {
        expect(&tapered(0.5), [-2.0, 0.0, 1.5], [1.0, 0.0, 0.0], &[]);
        expect(&tapered(0.5), [-2.0, 0.0, -0.5], [1.0, 0.0, 0.0], &[]);
        expect(&tapered(0.5), [-2.0, 2.0, 0.5], [1.0, 0.0, 0.0], &[]);
        expect(&tapered(0.5), [2.0, 0.0, -1.0], [0.0, 0.0, 1.0], &[]);
    }

    #[test]
    fn a_tangent_of_the_wall_has_no_hits() {
        expect(&tapered(1.0), [-2.0, 1.0, 0.5], [1.0, 0.0, 0.0], &[]);
        expect(&tapered(0.5), [-2.0, 0.75, 0.5], [1.0, 0.0, 0.0], &[]);
    }

    #[test]
    fn inside_and_behind() {
        expect(&tapered(1.0), [0.0, 0.0, 0.25], [0.0, 0.0, 1.0], &[(-0.25, Enter, "base"), (0.75, Leave, "cap")]);
        expect(&tapered(1.0), [3.0, 0.0, 0.5], [1.0, 0.0, 0.0], &[(-4.0, Enter, "wall"), (-2.0, Leave, "wall")]);
    }

    #[test]
    fn a_ray_parallel_to_the_side_of_the_cone_meets_the_wall_once() {
        // A = 0. In at the middle of the base, out at (−0.5, 0, 0.5).
        let cone = tapered(0.0);
        expect(&cone, [1.0, 0.0, -1.0], [-1.0, 0.0, 1.0], &[(1.0, Enter, "base"), (1.5, Leave, "wall")]);
    }

    #[test]
    fn a_ray_along_the_side_of_the_cone_only_touches_it() {
        expect(&tapered(0.0), [2.0, 0.0, -1.0], [-1.0, 0.0, 1.0], &[]);
    }

    #[test]
    fn the_axis_of_the_cone_runs_from_base_to_apex() {
        let hits = hits(&tapered(0.0), [0.0, 0.0, -1.0], [0.0, 0.0, 1.0]);
        assert_eq!(hits.iter().map(|hit| hit.0).collect::<Vec<_>>(), [1.0, 2.0]);
    }

    #[test]
    fn a_ray_along_the_wall_of_a_cylinder_is_inside_it_or_not_as_a_whole() {
        expect(&tapered(1.0), [0.5, 0.0, -1.0], [0.0, 0.0, 1.0], &[(1.0, Enter, "base"), (2.0, Leave, "cap")]);
        expect(&tapered(1.0), [1.0, 0.0, -1.0], [0.0, 0.0, 1.0], &[]);
        expect(&tapered(1.0), [1.5, 0.0, -1.0], [0.0, 0.0, 1.0], &[]);
    }

    #[test]
    fn the_coefficients_are_those_of_the_substitution() {
        let (reports, _) = record(&tapered(0.5), DVec3::new(-2.0, 0.0, 0.5), DVec3::X);
        let What::Quadratic { a, b, c, discriminant, recentred_at, roots, .. } = &reports[1] else {
            panic!("{reports:?}")
        };
        // About (0, 0, 0.5): t² − 0.75².
        assert_eq!((*a, *b, *c, *discriminant, *recentred_at), (1.0, 0.0, -0.5625, 0.5625, 2.0));
        assert_eq!(roots, &[1.25, 2.75]);
    }

    #[test]
    fn rejected_times_say_what_they_lie_beyond() {
        // Base and cap are passed outside of their discs.
        let (reports, _) = record(&tapered(0.5), DVec3::new(-3.0, 0.0, -0.25), DVec3::new(2.0, 0.0, 0.5));
        let Some(What::Roots { candidates }) = reports.last() else { panic!("{reports:?}") };
        let base = candidates.iter().find(|candidate| candidate.part == "base").unwrap();
        assert_eq!((base.t, base.reason.as_str()), (0.5, "2 from the axis, beyond the base's radius 1"));
        let cap = candidates.iter().find(|candidate| candidate.part == "cap").unwrap();
        assert_eq!((cap.t, cap.reason.as_str()), (2.5, "2 from the axis, beyond the cap's radius 0.5"));
    }

    #[test]
    fn a_negative_radius_is_refused() {
        assert_eq!(TaperedCylinder::new(-0.5).unwrap_err(), "s is -0.5; the cap's radius needs to be 0 or more");
        assert!(TaperedCylinder::new(f64::NAN).is_err());
    }
}
