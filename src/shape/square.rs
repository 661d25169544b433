//! The square z = 0, |x| ≤ 1, |y| ≤ 1 (§ 6.2.1). An affine map makes it any parallelogram.
//!
//! **Shape** (from above)
//! ```text
//!   (−1, 1)        (1, 1)
//!      +--------------+
//!      |      y       |
//!      |      ↑       |
//!      |      o→ x    |
//!      +--------------+
//!  (−1, −1)       (1, −1)
//! ```
//! **Equation** z = 0 with |x| ≤ 1 and |y| ≤ 1. It bounds nothing: its hits neither enter nor leave.
//!
//! **Ray equation** First the plane: t = −S_z / c_z. Then the square: |S_x + c_x t| ≤ 1, and y likewise.
//!
//! **Accuracy** t to half an ulp. The test |S_x c_z − S_z c_x| ≤ |c_z| is the same without the division; what it cannot
//! decide in its own arithmetic is decided with 32 digits. Rays that nearly lie in the plane set the error of the point.
//!
//! **Degenerate cases** c_z = 0: parallel, never a hit, not even for a ray within the square's plane. The edges belong
//! to the square.
//!
//! **Source** Hill, Computer Graphics Using OpenGL, hit() of the generic square.

use super::boundary::{Boundaries, Root};
use super::solver::{self, Attempt, Call, Solver};
use super::{Approach, Bounds, Crossing, Crossings, GenericRay, Part, Primitive, plane_table, report};
use crate::math::Real;
use crate::record::{Candidate, Entry, Recorder, Sense, format_number};
use glam::{DVec2, DVec3};

/// The square z = 0, |x| ≤ 1, |y| ≤ 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Square;

impl Square {
    /// The generic square.
    ///
    /// # Errors
    /// None: it has no parameters.
    pub const fn new() -> Result<Self, String> {
        Ok(Self)
    }
}

/// Where the ray meets the plane of the square.
pub(super) struct Meeting<A> {
    tau: A,
    /// It meets the plane at all.
    in_plane: bool,
    /// It meets the square.
    within: bool,
}

/// How much room the hit leaves to the nearer pair of sides: |c_z| − |S_x c_z − S_z c_x|, or the same with y.
fn room<A: Real>(ray: &GenericRay<A>) -> Call {
    let [_, _, s_z] = ray.origin;
    let [_, _, c_z] = ray.direction;
    let [_, _, os_z] = ray.origin_size;
    let [_, _, ds_z] = ray.direction_size;
    let side = |axis: usize| {
        let moment = A::difference_of_products(ray.origin[axis], c_z, s_z, ray.direction[axis]).abs();
        let size = ray.origin_size[axis] * ds_z + os_z * ray.direction_size[axis] + ds_z;
        Call {
            question: "Does the ray meet the plane within the square?",
            value: (c_z.abs() - moment).to_f64(),
            doubt: 8.0 * A::UNIT_ROUNDOFF * size,
            input_doubt: 2.0 * f64::UNIT_ROUNDOFF * size,
            near: -(s_z / c_z).to_f64(),
        }
    };
    let (x, y) = (side(0), side(1));
    // Both have to hold: what fails decides, else the tighter one.
    if (x.value < 0.0) == (y.value < 0.0) {
        x.closer(y)
    } else if x.value < 0.0 {
        x
    } else {
        y
    }
}

impl Solver for Square {
    type Found<A: Real> = Meeting<A>;

    #[inline]
    fn solve<A: Real>(&self, ray: &GenericRay<A>) -> Attempt<Meeting<A>> {
        let tau = -ray.origin[2] / ray.direction[2];
        let in_plane = ray.direction[2] != A::ZERO && (tau.to_f64() * ray.t_per_tau).is_finite();
        let room = room(ray);
        let slope_doubt = 4.0 * A::UNIT_ROUNDOFF * ray.direction_size[2];
        let slope_known = ray.direction[2].abs().to_f64() > slope_doubt || slope_doubt == 0.0;
        // A side may be met to the last bit: edges belong to the square.
        let within = in_plane && (room.value >= 0.0 || A::DOUBT_IS_ZERO && !room.is_beyond_doubt());
        Attempt { found: Meeting { tau, in_plane, within }, decided: slope_known && room.is_beyond_doubt() }
    }

    fn closest_call<A: Real>(&self, ray: &GenericRay<A>, _: &Meeting<A>) -> Call {
        room(ray)
    }

    fn first_sense<A: Real>(&self, _: &GenericRay<A>) -> Sense {
        Sense::Touch
    }

    fn roots<A: Real>(&self, ray: &GenericRay<A>, meeting: &Meeting<A>) -> impl Boundaries {
        meeting.within.then(|| {
            let tau = meeting.tau.to_f64();
            Root { tau, error: ray.root_error([0.0, 0.0, 1.0], tau), part: 0 }
        })
    }

    fn working<A: Real>(&self, ray: &GenericRay<A>, _: &Meeting<A>) -> Vec<Entry> {
        vec![plane_table::single_row(ray, "plane of the square")]
    }

    fn signs<A: Real>(&self, ray: &GenericRay<A>, meeting: &Meeting<A>, _: &[Crossing]) -> Entry {
        let roots = if meeting.in_plane { vec![meeting.tau.to_f64() * ray.t_per_tau] } else { Vec::new() };
        let below = if meeting.in_plane { ray.direction[2] > A::ZERO } else { ray.origin[2] < A::ZERO };
        report::implicit_with_roots(self, ray, roots, below)
    }

    fn rejected<A: Real>(&self, ray: &GenericRay<A>, meeting: &Meeting<A>, _: &[Crossing]) -> Vec<Candidate> {
        let outside = meeting.in_plane && !meeting.within;
        outside.then(|| outside_candidate(*self, ray, meeting.tau.to_f64())).into_iter().collect()
    }
}

impl Primitive for Square {
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Crossings) {
        solver::crossings(self, ray, recorder, crossings);
    }

    #[inline]
    fn first_crossing<A: Real>(&self, approach: &impl Approach) -> Option<Crossing> {
        solver::first_crossing::<A>(self, approach)
    }

    fn normal(&self, _point: DVec3, _part: Part) -> DVec3 {
        DVec3::Z
    }

    fn uv(&self, point: DVec3, _part: Part) -> DVec2 {
        ((point.truncate() + 1.0) * 0.5).clamp(DVec2::ZERO, DVec2::ONE)
    }

    fn tangents(&self, _point: DVec3, _part: Part) -> [DVec3; 2] {
        [DVec3::X * 2.0, DVec3::Y * 2.0]
    }

    fn is_flat(&self, _part: Part) -> bool {
        true
    }

    fn bounds(&self) -> Bounds {
        Bounds { low: DVec3::new(-1.0, -1.0, 0.0), high: DVec3::new(1.0, 1.0, 0.0) }
    }

    fn outline(&self) -> Vec<Vec<DVec3>> {
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0)];
        vec![corners.map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec()]
    }

    fn implicit(&self, point: DVec3) -> f64 {
        point.z
    }

    fn equation(&self) -> String {
        "z".to_owned()
    }

    fn parts(&self) -> Vec<String> {
        vec!["surface".to_owned()]
    }
}

/// The hit with the plane that is not in the square, with the coordinate that says so.
fn outside_candidate<A: Real>(square: Square, ray: &GenericRay<A>, tau: f64) -> Candidate {
    let point = ray.point(A::from_f64(tau));
    let (name, value) = if point.x.abs() >= point.y.abs() { ("x", point.x) } else { ("y", point.y) };
    let reason = format!("the plane is hit, but outside the square: |{name}| = {} > 1", format_number(value.abs()));
    report::rejected(&square, ray, (tau, 0, Sense::Touch), reason)
}

#[cfg(test)]
mod tests {
    use super::super::testing::*;
    use super::*;
    use crate::record::What;

    impl Samples for Square {
        fn samples() -> Vec<Self> {
            vec![Self::new().unwrap()]
        }
    }

    #[test]
    fn a_ray_through_the_square_touches_it() {
        expect(&Square, [0.5, -0.5, 2.0], [0.0, 0.0, -1.0], &[(2.0, Touch, "surface")]);
        expect(&Square, [0.5, -0.5, 2.0], [0.0, 0.0, 4.0], &[(-0.5, Touch, "surface")]);
    }

    #[test]
    fn edges_and_corners_belong_to_it_and_the_next_number_does_not() {
        expect(&Square, [1.0, 1.0, 1.0], [0.0, 0.0, -1.0], &[(1.0, Touch, "surface")]);
        expect(&Square, [2.0, 0.0, 1.0], [-1.0, 0.0, -1.0], &[(1.0, Touch, "surface")]);
        expect(&Square, [1.0_f64.next_up(), 0.0, 1.0], [0.0, 0.0, -1.0], &[]);
    }

    #[test]
    fn a_ray_that_hits_the_plane_beside_it_is_rejected_with_the_reason() {
        let (reports, hits) = record(&Square, DVec3::new(1.5, 0.25, 1.0), DVec3::NEG_Z);
        assert!(hits.is_empty());
        let Some(What::Roots { candidates }) = reports.last() else { panic!("{reports:?}") };
        assert_eq!(candidates[0].reason, "the plane is hit, but outside the square: |x| = 1.5 > 1");
        assert_eq!(candidates[0].t, 1.0);
    }

    #[test]
    fn a_parallel_ray_misses_even_within_the_plane() {
        expect(&Square, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], &[]);
        expect(&Square, [-3.0, 0.0, 0.0], [1.0, 0.0, 0.0], &[]);
    }

    #[test]
    fn the_corners_have_the_corners_of_the_texture() {
        assert_eq!(Square.uv(DVec3::new(-1.0, -1.0, 0.0), 0), DVec2::ZERO);
        assert_eq!(Square.uv(DVec3::new(1.0, 1.0, 0.0), 0), DVec2::ONE);
    }
}
