//! The place on a surface that a bump or a frame is asked for.

use glam::{DMat3, DVec2, DVec3};

/// A place on a surface. All vectors are in world space but for `texture_point`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Site {
    /// The point in the texture's own space, which moves with the object.
    pub texture_point: DVec3,
    /// The linear part of the map from world space to the texture's.
    pub texture_from_world: DMat3,
    /// (u, v) of the surface.
    pub uv: DVec2,
    /// ∂P/∂u and ∂P/∂v.
    pub tangents: [DVec3; 2],
    /// The outward unit normal.
    pub normal: DVec3,
}

/// n_u and n_v: how the unit normal turns with u and v, by central differences along the tangents.
///
/// `normal_beside` is the outward normal, of any length, at the point that lies beside the site by a displacement in world
/// space; it need not lie on the surface, for what is off by the square of the step cancels. With a step of 10⁻⁵ of the
/// surface's (u, v) the result is right to about 9 digits where the normal is smooth. None where it is undefined there.
pub fn turning(tangents: [DVec3; 2], normal_beside: impl Fn(DVec3) -> DVec3) -> Option<[DVec3; 2]> {
    const STEP: f64 = 1e-5;
    let unit = |displacement: DVec3| normal_beside(displacement).try_normalize();
    let along = |tangent: DVec3| Some((unit(tangent * STEP)? - unit(tangent * -STEP)?) / (2.0 * STEP));
    Some([along(tangents[0])?, along(tangents[1])?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_normal_of_a_unit_sphere_turns_as_the_point_moves() {
        let point = DVec3::new(0.48, 0.6, 0.64);
        let tangents = [DVec3::new(-0.6, 0.48, 0.0) * 6.0, DVec3::new(-0.4, -0.5, 0.76875)];
        let found = turning(tangents, |beside| point + beside).unwrap();
        for (turned, tangent) in found.iter().zip(tangents) {
            assert!((*turned - tangent).length() < 1e-8, "{turned} {tangent}");
        }
    }

    #[test]
    fn the_normal_of_a_plane_does_not_turn() {
        assert_eq!(turning([DVec3::X, DVec3::Y], |_| DVec3::Z * 3.0), Some([DVec3::ZERO; 2]));
        assert_eq!(turning([DVec3::X, DVec3::Y], |_| DVec3::ZERO), None);
    }
}
