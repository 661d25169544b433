//! A ray, made ready to be tested against many extents.

use glam::DVec3;

/// A ray with what every extent test asks of it, worked out once.
///
/// An extent must never lose a hit that its solid's solver finds. So the box is tested as if it were wider by what
/// rounding can do to the ray on its way into generic coordinates: `near_start` and `far_start` are the origin moved
/// outwards by that much, and the times are widened by as many roundings (after Ize, JCGT 2(2), 2013).
#[derive(Clone, Copy, Debug)]
pub struct Course {
    /// Where the ray starts.
    pub origin: DVec3,
    /// Where it goes.
    pub direction: DVec3,
    /// Whether it is tested against the boxes of solids at all.
    pub(super) boxes: bool,
    pub(super) per_direction: [f64; 3],
    pub(super) backwards: [bool; 3],
    pub(super) near_start: [f64; 3],
    pub(super) far_start: [f64; 3],
    widening: f64,
}

/// Roundings in the way of a ray into generic coordinates and in a slab test. Fewer could cut off a grazing hit; more would
/// only cost a test now and then.
const ROUNDINGS: f64 = 16.0 * f64::EPSILON;

impl Course {
    /// The ray through `origin`; `skew` is the largest of the solids that it will be tested against
    /// ([`Placement::skew`](super::Placement::skew)).
    #[must_use]
    #[inline]
    pub fn new(origin: DVec3, direction: DVec3, skew: f64) -> Self {
        let slack = ROUNDINGS * skew * origin.abs().max_element();
        let (start, course) = (origin.to_array(), direction.to_array());
        let per_direction = course.map(|d| 1.0 / d);
        let backwards = per_direction.map(f64::is_sign_negative);
        let moved = |by: f64| std::array::from_fn(|axis| if backwards[axis] { start[axis] - by } else { start[axis] + by });
        Self {
            origin,
            direction,
            boxes: true,
            per_direction,
            backwards,
            near_start: moved(slack),
            far_start: moved(-slack),
            widening: ROUNDINGS * skew,
        }
    }

    /// The same ray, tested against the boxes of solids or not.
    #[must_use]
    pub const fn testing_boxes(self, boxes: bool) -> Self {
        Self { boxes, ..self }
    }

    /// The times of a box, further apart by what they can be off.
    #[inline]
    pub(super) fn widened(&self, [t_in, t_out]: [f64; 2]) -> [f64; 2] {
        [t_in - self.widening * t_in.abs(), t_out + self.widening * t_out.abs()]
    }
}
