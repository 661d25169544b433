//! Polylines from which outlines are made.

use crate::math::portable;
use glam::DVec3;

/// Corners of a drawn circle. Fewer would show as corners on a large drawing.
const CORNERS: u32 = 96;

/// A closed curve: `point` is given angles from 0 to 2π, and the first point is repeated at the end.
pub(super) fn closed_curve(point: impl Fn(f64) -> DVec3) -> Vec<DVec3> {
    (0..=CORNERS).map(|k| point(std::f64::consts::TAU * f64::from(k % CORNERS) / f64::from(CORNERS))).collect()
}

/// The circle of this radius about the z axis at this height.
pub(super) fn circle(radius: f64, z: f64) -> Vec<DVec3> {
    closed_curve(|angle| DVec3::new(radius * portable::cos(angle), radius * portable::sin(angle), z))
}

/// Two points that span the plane across `normal`, together with it a right-handed frame; not zero.
pub(super) fn across(normal: DVec3) -> (DVec3, DVec3) {
    let unit = (normal * crate::math::scale_to_unit(normal.to_array())).normalize();
    unit.any_orthonormal_pair()
}
