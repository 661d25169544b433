//! The plane z = 0 as the surface of a solid half-space.
//!
//! **Shape** (from the side)
//! ```text
//!        z ↑
//!          |        outside
//!   -------+------- plane, z = 0
//!   ///////////////
//!   //// inside ///   without end
//! ```
//! **Equation** F = z: positive above, negative below.
//!
//! **Ray equation** S_z + c_z t = 0, so t = −S_z / c_z. A ray that comes from above enters (c_z < 0).
//!
//! **Accuracy** One rounded division: half an ulp of t.
//!
//! **Degenerate cases** c_z = 0: the ray never crosses, and lies inside as a whole where S_z ≤ 0. A t too large for a
//! number counts as never.
//!
//! **Source** Hill, Computer Graphics Using OpenGL, ray tracing, the generic plane.

use super::boundary::{Boundaries, Root};
use super::solver::{self, Attempt, Call, Solver};
use super::{Approach, Bounds, Crossing, Crossings, GenericRay, Part, Primitive, plane_table};
use crate::math::Real;
use crate::record::{Candidate, Entry, Recorder, Sense};
use glam::{DVec2, DVec3};

/// The half-space z ≤ 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane;

impl Plane {
    /// The generic plane.
    ///
    /// # Errors
    /// None: it has no parameters.
    pub const fn new() -> Result<Self, String> {
        Ok(Self)
    }
}

impl Solver for Plane {
    /// The one hit time, if there is one.
    type Found<A: Real> = Option<A>;

    #[inline]
    fn solve<A: Real>(&self, ray: &GenericRay<A>) -> Attempt<Option<A>> {
        let tau = -ray.origin[2] / ray.direction[2];
        let crosses = ray.direction[2] != A::ZERO && (tau.to_f64() * ray.t_per_tau).is_finite();
        Attempt { found: crosses.then_some(tau), decided: self.closest_call(ray, &None).is_beyond_doubt() }
    }

    #[inline]
    fn closest_call<A: Real>(&self, ray: &GenericRay<A>, _: &Option<A>) -> Call {
        Call {
            question: "Does the ray rise through the plane, c_z > 0?",
            value: ray.direction[2].to_f64(),
            doubt: 4.0 * A::UNIT_ROUNDOFF * ray.direction_size[2],
            input_doubt: f64::UNIT_ROUNDOFF * ray.direction_size[2],
            near: -(ray.origin[2] / ray.direction[2]).to_f64(),
        }
    }

    fn first_sense<A: Real>(&self, ray: &GenericRay<A>) -> Sense {
        if ray.direction[2] > A::ZERO { Sense::Leave } else { Sense::Enter }
    }

    fn roots<A: Real>(&self, ray: &GenericRay<A>, time: &Option<A>) -> impl Boundaries {
        time.map(|tau| {
            let tau = tau.to_f64();
            Root { tau, error: ray.root_error([0.0, 0.0, 1.0], tau), part: 0 }
        })
    }

    fn working<A: Real>(&self, ray: &GenericRay<A>, _: &Option<A>) -> Vec<Entry> {
        vec![plane_table::single_row(ray, "surface")]
    }

    fn rejected<A: Real>(&self, _: &GenericRay<A>, _: &Option<A>, _: &[Crossing]) -> Vec<Candidate> {
        Vec::new()
    }
}

impl Primitive for Plane {
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

    /// x and y, repeating every unit.
    fn uv(&self, point: DVec3, _part: Part) -> DVec2 {
        point.truncate()
    }

    fn is_flat(&self, _part: Part) -> bool {
        true
    }

    fn tangents(&self, _point: DVec3, _part: Part) -> [DVec3; 2] {
        [DVec3::X, DVec3::Y]
    }

    fn bounds(&self) -> Bounds {
        Bounds { low: DVec3::NEG_INFINITY, high: DVec3::new(f64::INFINITY, f64::INFINITY, 0.0) }
    }

    /// A patch of the grid of whole numbers about the origin.
    fn outline(&self) -> Vec<Vec<DVec3>> {
        const HALF: f64 = 4.0;
        (-4..=4)
            .map(f64::from)
            .flat_map(|k| {
                [
                    vec![DVec3::new(k, -HALF, 0.0), DVec3::new(k, HALF, 0.0)],
                    vec![DVec3::new(-HALF, k, 0.0), DVec3::new(HALF, k, 0.0)],
                ]
            })
            .collect()
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

#[cfg(test)]
mod tests {
    use super::super::testing::*;
    use super::*;

    impl Samples for Plane {
        fn samples() -> Vec<Self> {
            vec![Self::new().unwrap()]
        }
    }

    #[test]
    fn a_ray_from_above_enters_and_one_from_below_leaves() {
        expect(&Plane, [5.0, 7.0, 3.0], [0.0, 1.0, -2.0], &[(1.5, Enter, "surface")]);
        expect(&Plane, [5.0, 7.0, -3.0], [0.0, 1.0, 2.0], &[(1.5, Leave, "surface")]);
    }

    #[test]
    fn the_hit_may_lie_behind_or_at_the_start() {
        expect(&Plane, [0.0, 0.0, 3.0], [0.0, 0.0, 2.0], &[(-1.5, Leave, "surface")]);
        expect(&Plane, [1.0, 0.0, 0.0], [1.0, 0.0, -1.0], &[(0.0, Enter, "surface")]);
    }

    #[test]
    fn a_parallel_ray_never_crosses() {
        expect(&Plane, [0.0, 0.0, 1.0], [1.0, 1.0, 0.0], &[]);
        expect(&Plane, [0.0, 0.0, -1.0], [1.0, 1.0, 0.0], &[]);
    }
}
