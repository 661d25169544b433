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
//! B = S_x c_x + S_y c_y − w d, C = S_x² + S_y² − w², where w is that at S. For
//! the discs t = −S_z / c_z and t = (1 − S_z) / c_z. The solid is convex: inside is where the ray is inside the wall
//! **and** between the discs, so entering is the later and leaving the earlier of two times. That settles all combinations of
//! wall, base and cap at once.
//!
//! **Accuracy** The discriminant is p² + q² − r² with the 2×2 minors p = S_x d − w c_x, q = S_y d − w c_y and
//! r = S_x c_y − S_y c_x, which cancel less than B² − A C: they are as good at any distance as S itself, so that no
//! recentring is needed. Where rounding hides its sign, or which of two times comes first, all is worked out again with 32
//! digits. The hard case is the ray along a side of the cone.
//!
//! **Degenerate cases** A = 0: the ray is parallel to a side, and the wall is met once. A < 0: the ray is steeper than the
//! side; it meets the wall once, and the other nappe of the double cone once, which does not count. A ray through the apex
//! (s = 0) meets both nappes there. Rays within a disc are inside the closed solid; rays within the wall only touch it.
//!
//! **Source** Hill, Computer Graphics Using OpenGL, the generic tapered cylinder; Numerical Recipes § 5.6 for the roots.

use super::boundary::{Boundaries, Root};
use super::solver::{self, Attempt, Call, Solver};
use super::tapered_wall::Wall;
use super::{
    Approach, Bounds, Crossing, Crossings, GenericRay, HalfSpace, Part, Primitive, outline, plane_table, report,
    tangents,
};
use crate::math::{Pair, Real, portable, scale_to_unit};
use crate::record::{Candidate, Entry, Recorder, Sense, format_number};
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
pub(super) struct Solution<A> {
    wall: Wall<A>,
    /// The latest entering time.
    enter: End<A>,
    /// The earliest leaving time.
    leave: End<A>,
    hits: bool,
}

/// The latest entering or the earliest leaving time.
#[derive(Clone, Copy)]
struct End<A> {
    tau: A,
    part: Part,
    /// Bounds of the true latest or earliest time, whichever part's it is.
    low: A,
    high: A,
}

impl<A: Real> End<A> {
    /// The time at which a part is met, with its error.
    #[inline]
    fn new(tau: A, error: f64, part: Part) -> Self {
        let error = A::from_f64(if tau.is_finite() { error } else { 0.0 });
        Self { tau, part, low: tau - error, high: tau + error }
    }

    #[inline]
    fn later(self, other: Self) -> Self {
        let (low, high) = (self.low.max(other.low), self.high.max(other.high));
        Self { low, high, ..if other.tau > self.tau { other } else { self } }
    }

    #[inline]
    fn earlier(self, other: Self) -> Self {
        let (low, high) = (self.low.min(other.low), self.high.min(other.high));
        Self { low, high, ..if other.tau < self.tau { other } else { self } }
    }
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

    /// The radius of the cap.
    #[must_use]
    pub const fn s(self) -> f64 {
        self.s
    }

    /// The radius at height z.
    #[must_use]
    pub fn radius(self, z: f64) -> f64 {
        1.0 + self.slope() * z
    }

    fn slope(self) -> f64 {
        self.s - 1.0
    }

    /// How far the time of a hit with a part moves when S and c are off by one part in one.
    #[inline]
    fn moved<A: Real>(ray: &GenericRay<A>, wall: &Wall<A>, tau: f64, part: Part) -> f64 {
        if part == WALL { wall.moved(tau) } else { ray.sway(tau)[2] * (1.0 / ray.direction[2].abs().to_f64()) }
    }

    /// A time at which a part is met, with what eight roundings do to it.
    #[inline]
    fn end<A: Real>(ray: &GenericRay<A>, wall: &Wall<A>, tau: A, part: Part) -> End<A> {
        let plain = tau.to_f64();
        End::new(tau, 8.0 * A::UNIT_ROUNDOFF * (Self::moved(ray, wall, plain, part) + plain.abs()), part)
    }

    /// The times of base and cap; none where the ray is parallel to them, as far as can be told.
    #[inline]
    fn discs<A: Real>(ray: &GenericRay<A>) -> Option<[A; 2]> {
        let (s_z, c_z) = (ray.origin[2], ray.direction[2]);
        let parallel = c_z.abs().to_f64() <= 4.0 * A::UNIT_ROUNDOFF * ray.direction_size[2];
        (!parallel).then(|| [-s_z / c_z, (A::ONE - s_z) / c_z])
    }
}

impl Solver for TaperedCylinder {
    type Found<A: Real> = Solution<A>;

    #[inline]
    fn solve<A: Real>(&self, ray: &GenericRay<A>) -> Attempt<Solution<A>> {
        let infinity = A::from_f64(f64::INFINITY);
        let wall = Wall::new(self.s, ray);
        let (enter, leave) = (End::new(-infinity, 0.0, WALL), End::new(infinity, 0.0, WALL));
        let mut found = Solution { wall, enter, leave, hits: false };
        let mut decided = wall.is_beyond_doubt();
        if wall.is_level() {
            if !wall.holds_all() {
                return Attempt { found, decided };
            }
        } else if let Some([first, second]) = wall.times() {
            found.enter = Self::end(ray, &wall, first, WALL);
            found.leave = Self::end(ray, &wall, second, WALL);
        } else {
            return Attempt { found, decided };
        }
        if let Some([base, cap]) = Self::discs(ray) {
            let (base, cap) = (Self::end(ray, &wall, base, BASE), Self::end(ray, &wall, cap, CAP));
            let upward = ray.direction[2] > A::ZERO;
            let (enter, leave) = if upward { (base, cap) } else { (cap, base) };
            (found.enter, found.leave) = (enter.later(found.enter), leave.earlier(found.leave));
        } else {
            let height = height(ray);
            // What is zero only by cancellation is not known to be zero.
            decided &= height.is_beyond_doubt() && ray.direction_size[2] == 0.0;
            if height.value < 0.0 && (height.is_beyond_doubt() || !A::DOUBT_IS_ZERO) {
                return Attempt { found, decided };
            }
        }
        let surely = found.enter.high < found.leave.low;
        decided &= surely || found.enter.low > found.leave.high;
        found.hits = if A::DOUBT_IS_ZERO { surely } else { found.enter.tau < found.leave.tau };
        Attempt { found, decided }
    }

    fn closest_call<A: Real>(&self, ray: &GenericRay<A>, solution: &Solution<A>) -> Call {
        let Solution { wall, enter, leave, .. } = solution;
        let moved = |end: &End<A>| {
            let tau = end.tau.to_f64();
            f64::UNIT_ROUNDOFF * Self::moved(ray, wall, tau, end.part)
        };
        let order = Call {
            question: "Does the ray enter the last part before it leaves the first?",
            value: (leave.tau - enter.tau).to_f64(),
            doubt: 0.5 * ((leave.high - leave.low) + (enter.high - enter.low)).to_f64(),
            input_doubt: moved(enter) + moved(leave),
            near: 0.5 * (enter.tau + leave.tau).to_f64(),
        };
        let met = wall.is_level() || wall.times().is_some();
        let beside = Self::discs(ray).is_none().then(|| height(ray));
        [met.then_some(order), beside].into_iter().flatten().fold(wall.call(), Call::closer)
    }

    #[inline]
    fn roots<A: Real>(&self, ray: &GenericRay<A>, solution: &Solution<A>) -> impl Boundaries {
        solution.hits.then(|| {
            // Both ways for both ends, for which part a ray meets is beyond guessing.
            let (wall, ends) = (&solution.wall, Pair([&solution.enter, &solution.leave]));
            let (tau, is_wall) = (ends.map(|end| end.tau), ends.map(|end| end.part == WALL));
            let tau = is_wall.choose(tau.map(|tau| wall.polished(ray, tau)), tau).map(A::to_f64);
            let moved = |part| tau.map(|tau| Self::moved(ray, wall, tau, part));
            let moved = is_wall.choose(moved(WALL), moved(BASE));
            ends.zip(tau.zip(moved))
                .map(|(end, (tau, moved))| Root { tau, error: ray.error_of_time(moved, tau), part: end.part })
                .0
        })
    }

    fn working<A: Real>(&self, ray: &GenericRay<A>, solution: &Solution<A>) -> Vec<Entry> {
        vec![plane_table::axis_table(ray, &DISCS), solution.wall.working(self.s, ray)]
    }

    /// The times that were looked at and are not on the solid.
    fn rejected<A: Real>(&self, ray: &GenericRay<A>, solution: &Solution<A>, found: &[Crossing]) -> Vec<Candidate> {
        let [enters, leaves] = [Sense::Enter, Sense::Leave];
        let upward = ray.direction[2] > A::ZERO;
        let (base, cap) = if upward { (enters, leaves) } else { (leaves, enters) };
        let quadratic = &solution.wall.quadratic;
        let senses = if quadratic.a < A::ZERO { [leaves, enters] } else { [enters, leaves] };
        let polished = solution.wall.roots().into_iter().flatten().map(|tau| solution.wall.polished(ray, tau));
        let wall = polished.zip(senses).map(|(tau, sense)| (tau, WALL, sense));
        let discs = Self::discs(ray).into_iter().flat_map(|[b, c]| [(b, BASE, base), (c, CAP, cap)]);
        wall.chain(discs)
            .map(|(tau, part, sense)| (tau.to_f64(), part, sense))
            .filter(|&(tau, part, _)| {
                let t = tau * ray.t_per_tau;
                t.is_finite() && !found.iter().any(|hit| hit.part == part && hit.t.to_bits() == t.to_bits())
            })
            .map(|hit| report::rejected(self, ray, hit, self.reason(ray.point(A::from_f64(hit.0)), hit.1)))
            .collect()
    }
}

/// How far inside the nearer disc's plane a ray runs that is parallel to them.
fn height<A: Real>(ray: &GenericRay<A>) -> Call {
    let z = ray.origin[2];
    Call {
        question: "Does the ray run between base and cap?",
        value: z.min(A::ONE - z).to_f64(),
        doubt: 4.0 * A::UNIT_ROUNDOFF * ray.origin_size[2],
        input_doubt: f64::UNIT_ROUNDOFF * ray.origin_size[2],
        near: ray.foot().to_f64(),
    }
}

impl Primitive for TaperedCylinder {
    #[inline]
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Crossings) {
        solver::crossings(self, ray, recorder, crossings);
    }

    #[inline]
    fn first_crossing<A: Real>(&self, approach: &impl Approach) -> Option<Crossing> {
        solver::first_crossing::<A>(self, approach)
    }

    fn normal(&self, point: DVec3, part: Part) -> DVec3 {
        match part {
            BASE => DVec3::NEG_Z,
            CAP => DVec3::Z,
            _ => {
                // Brought to size, so that neither the square nor the product overflows on the widest of walls.
                let across = point.truncate() * scale_to_unit([point.x, point.y, 0.0]);
                let steep = (-self.slope() * across.length()).clamp(f64::MIN, f64::MAX);
                // At the apex every direction between the sides would do; along the axis is the fair one.
                if across == DVec2::ZERO { DVec3::Z } else { across.extend(steep) }
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

    fn tangents(&self, point: DVec3, part: Part) -> [DVec3; 2] {
        match part {
            BASE => [DVec3::X * 2.0, DVec3::Y * 2.0],
            CAP => [DVec3::X * (2.0 * self.s), DVec3::Y * (2.0 * self.s)],
            _ => [tangents::around(point), (tangents::radial(point) * self.slope()).extend(1.0)],
        }
    }

    fn is_flat(&self, part: Part) -> bool {
        part == BASE || part == CAP
    }

    fn uv_period(&self, part: Part) -> [Option<f64>; 2] {
        [(!self.is_flat(part)).then_some(1.0), None]
    }

    fn bounds(&self) -> Bounds {
        let radius = self.s.max(1.0);
        Bounds { low: DVec3::new(-radius, -radius, 0.0), high: DVec3::new(radius, radius, 1.0) }
    }

    fn ball_radius(&self) -> f64 {
        portable::hypot(self.s.max(1.0), 0.5)
    }

    /// The rims, and eight lines up the wall.
    fn outline(&self) -> Vec<Vec<DVec3>> {
        let side = |k: u32| {
            let (sin, cos) = portable::sin_cos(f64::from(k) * std::f64::consts::FRAC_PI_4);
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
    use crate::record::What;

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
        // (t − 2)² − 0.75² = t² − 4 t + 3.4375.
        assert_eq!((*a, *b, *c, *discriminant, *recentred_at), (1.0, -2.0, 3.4375, 0.5625, 0.0));
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
