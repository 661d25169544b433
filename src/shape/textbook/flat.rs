//! Plane and square: t = −S_z / c_z, and for the square the hit point compared with its sides.
//!
//! **Where they fail** The plane hardly does: one division. The square takes a ray with |c_z| < 10⁻⁴ for parallel and loses
//! a hit that may lie in its very middle; and near an edge the rounding of the point decides.
//!
//! **Source** F. S. Hill, Computer Graphics Using OpenGL, 2nd ed., § 14.5, `hit()` of the generic square.

use super::crossing;
use crate::record::Sense;
use crate::shape::{Crossings, GenericRay};

/// Slopes below this count as parallel.
const PARALLEL: f64 = 1e-4;

/// Right but for half a unit in the last place of t.
pub fn plane(ray: &GenericRay<f64>, crossings: &mut Crossings) {
    let slope = ray.direction[2];
    if slope != 0.0 {
        let sense = if slope > 0.0 { Sense::Leave } else { Sense::Enter };
        crossings.push(crossing(ray, -ray.origin[2] / slope, sense, 0));
    }
}

/// Wrong for slanting rays, which it calls parallel, and within rounding of an edge.
pub fn square(ray: &GenericRay<f64>, crossings: &mut Crossings) {
    if ray.direction[2].abs() < PARALLEL {
        return;
    }
    let tau = -ray.origin[2] / ray.direction[2];
    let [x, y, _] = ray.at(tau);
    if x.abs() <= 1.0 && y.abs() <= 1.0 {
        crossings.push(crossing(ray, tau, Sense::Touch, 0));
    }
}
