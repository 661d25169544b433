//! An environment by longitude and latitude.
//!
//! Seen from inside: the middle column looks along +x, right of it comes −y, left of it +y, and both edges look along −x. The
//! top row is the zenith +z, the bottom row the nadir −z, and all rows are of the same height in latitude:
//! column = (½ − φ / 360°) W with φ from +x towards +y, row = θ / 180° H with θ from +z.

use super::chart::Region;
use super::sphere::solid_angle;
use crate::math::portable;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// The part of a triangle's solid angle that the straight pieces of a side may be off by: a fortieth of a step of 1/255 where it
/// tells most. Smaller costs time for small footprints, whose sides are all but straight; larger is seen.
const TOLERANCE: f64 = 1e-4;

/// How often a side is halved at most: 2¹⁴ pieces follow one that passes a pole at 10⁻⁴ of its length.
const MOST_HALVINGS: u32 = 14;

/// φ of a direction in radians, above −π and up to π.
pub(super) fn longitude(direction: DVec3) -> f64 {
    // −0 + 0 is 0: both zeros of y lie on the same side of the seam.
    portable::atan2(direction.y + 0.0, direction.x)
}

/// A unit direction on the chart.
pub(super) fn place(direction: DVec3) -> DVec2 {
    DVec2::new(0.5 - longitude(direction) / TAU, -direction.z)
}

/// A unit direction on the chart, with its column as near to `beside` as whole turns bring it.
fn place_beside(direction: DVec3, beside: f64) -> DVec2 {
    let place = place(direction);
    DVec2::new(place.x - (place.x - beside).round(), place.y)
}

/// The outline of a polygon of unit directions, whose sides are great circles, in straight pieces; around a pole it does not
/// come back to where it began but to a turn from there. It begins at the last corner, as near to the column `beside` as can be.
pub(super) fn outline(corners: &[DVec3], beside: f64, tolerance: f64) -> Vec<DVec2> {
    let Some(&last) = corners.last() else { return Vec::new() };
    let mut points = vec![place_beside(last, beside)];
    let mut from = last;
    for &to in corners {
        side(&mut points, from, to, tolerance, MOST_HALVINGS);
        from = to;
    }
    points
}

/// Adds the side from the last point, which is at `from`, to `to`. Its halves share what it may be off by.
fn side(points: &mut Vec<DVec2>, from: DVec3, to: DVec3, tolerance: f64, halvings: u32) {
    let Some(&start) = points.last() else { return };
    let middle = (from + to).normalize_or_zero();
    let quarter = (from + middle).normalize_or_zero();
    let at_quarter = place_beside(quarter, start.x);
    let at_middle = place_beside(middle, at_quarter.x);
    let end = place_beside(to, at_middle.x);
    let area = |a: DVec2, b: DVec2| (a - start).perp_dot(b - start).abs() * TAU;
    // Two places: a side that bends one way and then the other may have its middle where a straight one has it.
    if halvings == 0 || area(at_middle, end) + area(at_quarter, at_middle) < tolerance {
        points.push(end);
    } else {
        side(points, from, middle, tolerance / 2.0, halvings - 1);
        side(points, middle, to, tolerance / 2.0, halvings - 1);
    }
}

/// A triangle of unit directions on the chart.
pub(super) fn region(corners: [DVec3; 3]) -> Region {
    let whole = solid_angle(corners);
    let mut polygon = outline(&corners, 0.5, TOLERANCE * whole.abs());
    if let (Some(&first), Some(&last)) = (polygon.first(), polygon.last())
        && (first.x - last.x).abs() > 0.5
    {
        // Around a pole the outline is closed along the pole's own edge of the image.
        let pole = if holds_zenith(corners, whole) { -1.0 } else { 1.0 };
        polygon.extend([DVec2::new(last.x, pole), DVec2::new(first.x, pole)]);
    }
    Region { chart: 0, polygon }
}

/// Whether the zenith rather than the nadir lies in a triangle: that it is on the inner side of all sides.
fn holds_zenith([a, b, c]: [DVec3; 3], orientation: f64) -> bool {
    let sides = [a.cross(b), b.cross(c), c.cross(a)].map(|normal| normal.z * orientation.signum());
    let least = sides.into_iter().fold(f64::INFINITY, f64::min);
    let most = sides.into_iter().fold(f64::NEG_INFINITY, f64::max);
    least > -most
}
