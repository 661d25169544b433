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

use super::{Bounds, Crossing, GenericRay, Part, Primitive, boundary, boundary::Root, planes, report};
use crate::math::Real;
use crate::record::{Candidate, Certificate, Recorder, Sense, format_number};
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

/// Whether the ray meets z = 0 within |x| ≤ 1 and |y| ≤ 1; none where rounding hides the answer.
fn meets_within<A: Real>(ray: &GenericRay<A>) -> Option<bool> {
    let [_, _, s_z] = ray.origin;
    let [_, _, c_z] = ray.direction;
    let mut within = true;
    for axis in 0..2 {
        let moment = A::difference_of_products(ray.origin[axis], c_z, s_z, ray.direction[axis]).abs();
        let doubt = 4.0 * A::UNIT_ROUNDOFF * (moment + c_z.abs()).to_f64();
        if !A::FINEST && (moment - c_z.abs()).abs().to_f64() <= doubt {
            return None;
        }
        within &= moment <= c_z.abs();
    }
    Some(within)
}

impl Primitive for Square {
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Vec<Crossing>) {
        let begin = crossings.len();
        let tau = (-ray.origin[2] / ray.direction[2]).to_f64();
        let meets_plane = ray.direction[2] != A::ZERO && (tau * ray.t_per_tau).is_finite();
        let within = meets_plane && meets_within(ray).or_else(|| meets_within(&ray.widen())).unwrap_or(false);
        if within {
            let error = ray.root_error([0.0, 0.0, 1.0], tau);
            let root = Root { tau, error, part: 0 };
            crossings.push(boundary::crossing(root, ray.t_per_tau, Sense::Touch, Certificate::Certain));
        }
        let found = &crossings[begin..];
        recorder.note(|| planes::single_row(ray, "plane of the square"));
        recorder.note(|| {
            let roots = if meets_plane { vec![tau * ray.t_per_tau] } else { Vec::new() };
            let below = if meets_plane { ray.direction[2] > A::ZERO } else { ray.origin[2] < A::ZERO };
            report::implicit_with_roots(self, ray, roots, below)
        });
        recorder.note(|| {
            let rejected = (meets_plane && !within).then(|| outside(*self, ray, tau));
            report::roots(self, ray, found, rejected.into_iter().collect())
        });
    }

    fn normal(&self, _point: DVec3, _part: Part) -> DVec3 {
        DVec3::Z
    }

    fn uv(&self, point: DVec3, _part: Part) -> DVec2 {
        ((point.truncate() + 1.0) * 0.5).clamp(DVec2::ZERO, DVec2::ONE)
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
fn outside<A: Real>(square: Square, ray: &GenericRay<A>, tau: f64) -> Candidate {
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
