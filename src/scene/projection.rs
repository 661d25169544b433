//! Projection extents (§ 6.5.4): the rectangle of the picture outside which no ray from the eye meets an object.

use super::Camera;
use crate::csg::Extent;
use glam::{DVec2, DVec3};

/// A rectangle on the image plane at distance 1, in units of that plane: across and upwards from its middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// Left and bottom.
    pub low: DVec2,
    /// Right and top.
    pub high: DVec2,
}

/// Roundings by which a rectangle is widened, times the skew of the solids. Fewer than those of the projection and of the
/// ray could cut off a hit at a silhouette; more would only cost a test now and then.
const PADDING: f64 = 64.0 * f64::EPSILON;

impl Projection {
    /// The whole plane: for what is unbounded, or not wholly in front of the eye.
    pub const EVERYWHERE: Self = Self { low: DVec2::NEG_INFINITY, high: DVec2::INFINITY };

    /// The rectangle that holds the eight corners of a box.
    #[must_use]
    pub fn new(camera: &Camera, extent: &Extent, skew: f64) -> Self {
        if !extent.is_finite() {
            return Self::EVERYWHERE;
        }
        let nothing = Self { low: DVec2::INFINITY, high: DVec2::NEG_INFINITY };
        let corner = |k: usize| {
            let pick = |axis: usize| if k >> axis & 1 == 0 { extent.low[axis] } else { extent.high[axis] };
            DVec3::new(pick(0), pick(1), pick(2))
        };
        (0..8).map(corner).fold(nothing, |all, corner| all.joined(Self::of_point(camera, corner, skew)))
    }

    /// Whether a ray through this point of the image plane may meet the object.
    #[must_use]
    #[inline]
    pub fn holds(&self, [across, upwards]: [f64; 2]) -> bool {
        self.low.x <= across && across <= self.high.x && self.low.y <= upwards && upwards <= self.high.y
    }

    fn of_point(camera: &Camera, point: DVec3, skew: f64) -> Self {
        let from_eye = point - camera.eye;
        let depth = from_eye.dot(camera.forward);
        let blur = PADDING * skew * (point.abs() + camera.eye.abs()).max_element();
        // Not `depth <= 2 blur`: what is not a number lies everywhere too.
        if !(depth > 2.0 * blur) {
            return Self::EVERYWHERE;
        }
        let place = DVec2::new(from_eye.dot(camera.right), from_eye.dot(camera.up)) / depth;
        let padding = blur * (1.0 + place.abs().max_element()) / (depth - blur);
        Self { low: place - padding, high: place + padding }
    }

    fn joined(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CAMERA: Camera =
        Camera { eye: DVec3::ZERO, right: DVec3::X, up: DVec3::Z, forward: DVec3::Y, half_height: 0.5 };

    fn rectangle(low: [f64; 3], high: [f64; 3]) -> Projection {
        Projection::new(&CAMERA, &Extent { low: low.into(), high: high.into() }, 1.0)
    }

    #[test]
    fn the_nearest_face_sets_the_rectangle_of_a_box_straight_ahead() {
        let Projection { low, high } = rectangle([-1.0, 2.0, -0.5], [1.0, 4.0, 0.5]);
        assert!((low - DVec2::new(-0.5, -0.25)).abs().max_element() < 1e-13, "{low}");
        assert!((high - DVec2::new(0.5, 0.25)).abs().max_element() < 1e-13, "{high}");
        assert!(low.x <= -0.5 && high.y >= 0.25);
    }

    #[test]
    fn what_reaches_behind_the_eye_is_everywhere() {
        assert_eq!(rectangle([-1.0, -0.1, -1.0], [1.0, 4.0, 1.0]), Projection::EVERYWHERE);
        assert_eq!(Projection::new(&CAMERA, &Extent::UNBOUNDED, 1.0), Projection::EVERYWHERE);
        assert!(Projection::EVERYWHERE.holds([1e300, -1e300]));
    }

    #[test]
    fn a_box_behind_the_eye_is_not_taken_for_one_in_front() {
        assert_eq!(rectangle([-1.0, -4.0, -1.0], [1.0, -2.0, 1.0]), Projection::EVERYWHERE);
    }
}
