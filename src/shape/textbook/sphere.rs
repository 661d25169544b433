//! The sphere: A t² + 2 B t + C = 0 with A = c·c, B = S·c, C = S·S − 1, and t = (−B ± √(B² − A C)) / A.
//!
//! **Where it fails** Far away. B² and A C are both about |S|², and their difference is about 1: at |S| = 10⁴ half of the
//! digits have cancelled, at 10⁸ all of them, and whether the ray hits is a matter of chance. Rays that touch fail sooner.
//!
//! **Source** F. S. Hill, Computer Graphics Using OpenGL, 2nd ed., § 14.5; A. Glassner (ed.), An Introduction to Ray Tracing
//! (1989), ch. 2.

use super::append_alternating;
use crate::math::dot;
use crate::shape::{Crossings, GenericRay};

/// Wrong from afar: the squares of S cancel.
pub fn crossings(ray: &GenericRay<f64>, crossings: &mut Crossings) {
    let a = dot(ray.direction, ray.direction);
    let b = dot(ray.origin, ray.direction);
    let c = dot(ray.origin, ray.origin) - 1.0;
    let discriminant = b * b - a * c;
    if discriminant < 0.0 {
        return;
    }
    let root = discriminant.sqrt();
    append_alternating(ray, &mut [((-b - root) / a, 0), ((-b + root) / a, 0)], crossings);
}
