//! Triangles on the sphere of directions.

use crate::math::portable;
use glam::DVec3;

/// The signed solid angle of the triangle between three directions of any lengths: positive where they turn to the left about
/// their middle, seen from outside.
///
/// Source: A. van Oosterom and J. Strackee, The Solid Angle of a Plane Triangle, IEEE Trans. Biomed. Eng. 30 (1983), eq. 8.
pub(super) fn solid_angle([a, b, c]: [DVec3; 3]) -> f64 {
    // By differences, so that small triangles keep their digits.
    let volume = (b - a).cross(c - a).dot(a);
    let [x, y, z] = [a.length(), b.length(), c.length()];
    2.0 * portable::atan2(volume, x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn an_octant_is_an_eighth_of_the_sphere() {
        assert!((solid_angle([DVec3::X, DVec3::Y * 3.0, DVec3::Z]) - PI / 2.0).abs() < 1e-15);
        assert!((solid_angle([DVec3::Y, DVec3::X, DVec3::Z]) + PI / 2.0).abs() < 1e-15);
        // A small triangle is flat.
        let small = [DVec3::Z, DVec3::new(1e-6, 0.0, 1.0), DVec3::new(0.0, 1e-6, 1.0)];
        assert!((solid_angle(small) / 0.5e-12 - 1.0).abs() < 1e-9);
    }
}
