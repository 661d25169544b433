//! Projection extents (§ 6.5.4): the rectangle of the picture outside which no ray from the eye meets an object.
//!
//! Seen from another point of a lens than its middle, everything that is not in focus slides in the picture: a point at
//! depth z by (1/f − 1/z) times the way on the lens, with f the distance of the plane of focus. So a rectangle slides
//! too, and it slides by no more and no less than its corners do, for what is straight stays straight.

use super::{Camera, Lens};
use glam::{DVec2, DVec3};

/// A rectangle on the image plane at distance 1, in units of that plane: across and upwards from its middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// Left and bottom.
    pub low: DVec2,
    /// Right and top.
    pub high: DVec2,
    /// By how much its corners slide for each unit of the way across a lens, at least and at most; 0 for a pinhole.
    pub slides: [f64; 2],
}

/// A place that a ray from the eye passes through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glance {
    /// On the image plane at distance 1, across and upwards from its middle. All rays of a lens that go through the same point
    /// of the plane of focus have the same place.
    pub place: [f64; 2],
    /// Where on the lens it starts, across and upwards from its middle in the world's units; none for a pinhole.
    pub on_lens: Option<[f64; 2]>,
}

/// The eye, as far as it decides what is seen where.
#[derive(Clone, Copy, Debug)]
pub struct View<'a> {
    /// The camera.
    pub camera: &'a Camera,
    /// Its lens, if it has one.
    pub lens: Option<&'a Lens>,
}

impl View<'_> {
    /// How far the opening reaches from its middle, across or upwards.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.lens.map_or(0.0, |lens| lens.radius)
    }

    /// Bound on the coordinates of the points that rays start from.
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.camera.eye.abs().max_element() + 2.0 * self.radius()
    }

    /// By how much a point at a depth slides for each unit of the way across the lens.
    fn slide(&self, depth: f64) -> f64 {
        self.lens.map_or(0.0, |lens| 1.0 / lens.focus - 1.0 / depth)
    }
}

/// Roundings by which a rectangle is widened, times the skew of the solids. Fewer than those of the projection and of the
/// ray could cut off a hit at a silhouette; more would only cost a test now and then.
const PADDING: f64 = 64.0 * f64::EPSILON;

/// How far rounding can move a corner or a ray: in proportion to the coordinates of the corner, of the eye, and of the points
/// that rays are sent from.
#[derive(Clone, Copy, Debug)]
pub struct Blur {
    /// [`Placement::skew`](crate::csg::Placement::skew) of what is looked at.
    pub skew: f64,
    /// Bound on the coordinates of the eye and of all points that rays are sent from.
    pub reach: f64,
}

impl Blur {
    /// At a point.
    #[must_use]
    pub fn at(&self, point: DVec3) -> f64 {
        PADDING * self.skew * (point.abs().max_element() + self.reach)
    }
}

impl Projection {
    /// The whole plane: for what is unbounded, or not wholly in front of the eye.
    pub const EVERYWHERE: Self = Self { low: DVec2::NEG_INFINITY, high: DVec2::INFINITY, slides: [0.0; 2] };

    /// No place at all.
    pub const NOWHERE: Self =
        Self { low: DVec2::INFINITY, high: DVec2::NEG_INFINITY, slides: [f64::INFINITY, f64::NEG_INFINITY] };

    /// The rectangle that holds the corners of a solid's hull.
    #[must_use]
    pub fn new(view: View, corners: &[DVec3; 8], blur: Blur) -> Self {
        let of = |corner: &DVec3| Self::of_point(view, *corner, blur.at(*corner));
        corners.iter().map(of).fold(Self::NOWHERE, Self::joined)
    }

    /// Whether a ray through this point of the image plane may meet the object.
    #[must_use]
    #[inline]
    pub fn holds(&self, [across, upwards]: [f64; 2]) -> bool {
        self.low.x <= across && across <= self.high.x && self.low.y <= upwards && upwards <= self.high.y
    }

    /// The rectangle as it is seen from a point of the lens.
    #[must_use]
    #[inline]
    pub fn slid(&self, on_lens: [f64; 2]) -> Self {
        let by = self.slides.map(|slide| DVec2::from_array(on_lens) * slide);
        Self { low: self.low + by[0].min(by[1]), high: self.high + by[0].max(by[1]), ..*self }
    }

    /// The rectangle that holds it wherever on a lens of this radius it is seen from.
    #[must_use]
    pub fn slid_all_ways(&self, radius: f64) -> Self {
        let by = radius * self.slides[0].abs().max(self.slides[1].abs());
        if by > 0.0 { Self { low: self.low - by, high: self.high + by, ..*self } } else { *self }
    }

    /// Whether a ray may meet the object.
    #[must_use]
    #[inline]
    pub fn holds_glance(&self, glance: Glance) -> bool {
        match glance.on_lens {
            Some(on_lens) => self.slid(on_lens).holds(glance.place),
            None => self.holds(glance.place),
        }
    }

    /// Whether the two have a point in common.
    #[must_use]
    pub fn meets(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }

    fn of_point(view: View, point: DVec3, blur: f64) -> Self {
        let camera = view.camera;
        let from_eye = point - camera.eye;
        let depth = from_eye.dot(camera.forward);
        // What is not a number lies everywhere too.
        if depth.is_nan() || blur.is_nan() || depth <= 2.0 * blur {
            return Self::EVERYWHERE;
        }
        let place = DVec2::new(from_eye.dot(camera.right), from_eye.dot(camera.up)) / depth;
        // A lens adds the roundings of the way on it, as it is seen at this depth and in focus.
        let on_lens = view.lens.map_or(0.0, |lens| lens.radius * (1.0 / lens.focus + 1.0 / (depth - blur)));
        let padding = blur * (1.0 + place.abs().max_element() + on_lens) / (depth - blur);
        Self { low: place - padding, high: place + padding, slides: [view.slide(depth); 2] }
    }

    fn joined(self, other: Self) -> Self {
        let slides = [self.slides[0].min(other.slides[0]), self.slides[1].max(other.slides[1])];
        Self { low: self.low.min(other.low), high: self.high.max(other.high), slides }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::csg::Extent;
    use crate::sample::Aperture;

    const CAMERA: Camera =
        Camera { eye: DVec3::ZERO, right: DVec3::X, up: DVec3::Z, forward: DVec3::Y, half_height: 0.5 };

    const BLUR: Blur = Blur { skew: 1.0, reach: 0.0 };

    fn rectangle(low: [f64; 3], high: [f64; 3]) -> Projection {
        let view = View { camera: &CAMERA, lens: None };
        Projection::new(view, &Extent { low: low.into(), high: high.into() }.corners(), BLUR)
    }

    /// A lens of radius 1/2 with its focus at 4.
    fn lens() -> Lens {
        Lens { radius: 0.5, focus: 4.0, aperture: Aperture::Disc }
    }

    /// A box from depth 2 to 8, seen from the right rim: its near side slides to the left by ½ (1/2 − 1/4) = 1/8, and its far
    /// side to the right by ½ (1/4 − 1/8) = 1/16.
    #[test]
    fn what_is_out_of_focus_slides_as_the_eye_moves_on_the_lens() {
        let (lens, corners) =
            (lens(), Extent { low: [-1.0, 2.0, -1.0].into(), high: [1.0, 8.0, 1.0].into() }.corners());
        let seen = Projection::new(View { camera: &CAMERA, lens: Some(&lens) }, &corners, BLUR);
        assert_eq!(seen.slides, [-0.25, 0.125]);
        let Projection { low, high, .. } = seen.slid([0.5, 0.0]);
        assert!((low - DVec2::new(-0.625, -0.5)).abs().max_element() < 1e-13, "{low}");
        assert!((high - DVec2::new(0.5625, 0.5)).abs().max_element() < 1e-13, "{high}");
        let all = seen.slid_all_ways(0.5);
        assert!((all.low - DVec2::splat(-0.625)).abs().max_element() < 1e-13, "{}", all.low);
    }

    /// Rays from points of the lens to points of a box, each at the place where it passes the plane of focus.
    #[test]
    fn no_ray_through_the_lens_to_a_box_passes_beside_its_rectangle() {
        let lens = lens();
        let (low, high) = (DVec3::new(0.5, 1.5, -1.0), DVec3::new(1.0, 7.0, 2.0));
        let seen = Projection::new(View { camera: &CAMERA, lens: Some(&lens) }, &Extent { low, high }.corners(), BLUR);
        for n in 0..4096 {
            let share = |prime: u32| f64::from(n * prime % 4093) / 4093.0;
            let point = low + (high - low) * DVec3::new(share(7), share(131), share(1009));
            let on_lens = [share(17) - 0.5, share(599) - 0.5];
            let towards = (point - DVec3::new(on_lens[0], 0.0, on_lens[1])) / point.y;
            let place = [towards.x + on_lens[0] / lens.focus, towards.z + on_lens[1] / lens.focus];
            assert!(seen.holds_glance(Glance { place, on_lens: Some(on_lens) }), "{point} from {on_lens:?}");
            assert!(seen.slid_all_ways(lens.radius).holds(place));
        }
    }

    #[test]
    fn the_nearest_face_sets_the_rectangle_of_a_box_straight_ahead() {
        let Projection { low, high, .. } = rectangle([-1.0, 2.0, -0.5], [1.0, 4.0, 0.5]);
        assert!((low - DVec2::new(-0.5, -0.25)).abs().max_element() < 1e-13, "{low}");
        assert!((high - DVec2::new(0.5, 0.25)).abs().max_element() < 1e-13, "{high}");
        assert!(low.x <= -0.5 && high.y >= 0.25);
    }

    #[test]
    fn what_reaches_behind_the_eye_is_everywhere() {
        assert_eq!(rectangle([-1.0, -0.1, -1.0], [1.0, 4.0, 1.0]), Projection::EVERYWHERE);
        let view = View { camera: &CAMERA, lens: None };
        assert_eq!(Projection::new(view, &Extent::UNBOUNDED.corners(), BLUR), Projection::EVERYWHERE);
        assert!(Projection::EVERYWHERE.holds([1e300, -1e300]));
    }

    #[test]
    fn a_box_behind_the_eye_is_not_taken_for_one_in_front() {
        assert_eq!(rectangle([-1.0, -4.0, -1.0], [1.0, -2.0, 1.0]), Projection::EVERYWHERE);
    }
}
