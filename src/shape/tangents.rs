//! ∂P/∂u and ∂P/∂v of surfaces whose u is the turn about the z axis.

use crate::math::scale_to_unit;
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// The unit direction away from the axis; along x for points on it.
pub(super) fn radial(point: DVec3) -> DVec2 {
    let across = point.truncate() * scale_to_unit([point.x, point.y, 0.0]);
    if across == DVec2::ZERO { DVec2::X } else { across.normalize() }
}

/// How a point moves with the turn about the axis, in whole turns.
pub(super) fn around(point: DVec3) -> DVec3 {
    DVec3::new(-point.y, point.x, 0.0) * TAU
}

/// A tube of radius 1 about the circle of radius `d`: v is the turn about the tube.
pub(super) fn of_tube(point: DVec3, d: f64) -> [DVec3; 2] {
    let up = (radial(point) * -point.z).extend(point.truncate().length() - d);
    [around(point), up * TAU]
}

/// A surface that is seen whole from the middle: u is the longitude, v the latitude from the south pole.
///
/// P = r e with the unit vector e of the two angles. When an angle moves e by e′, r moves so that P′ = r e′ + r′ e stays at
/// right angles to the normal N: P′ = r (e′ − e (N·e′) / (N·e)).
pub(super) fn seen_from_middle(point: DVec3, normal: DVec3) -> [DVec3; 2] {
    let normal = normal * scale_to_unit(normal.to_array());
    let across = radial(point);
    let along_latitude = (across * -point.z).extend(point.truncate().length());
    [around(point), along_latitude * PI].map(|turned| {
        let on_surface = turned - point * (normal.dot(turned) / normal.dot(point));
        // At a crease the surface may go straight away from the middle.
        if on_surface.is_finite() { on_surface } else { turned }
    })
}
