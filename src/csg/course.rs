//! A ray on its way past many extents.

use super::Ball;
use crate::shape::Solving;
use glam::DVec3;
use std::cell::OnceCell;

/// A ray that can be tested against extents; what these tests ask of it is worked out when the first one does.
#[derive(Clone, Debug)]
pub struct Course {
    /// Where the ray starts, and where it goes.
    pub line: [DVec3; 2],
    /// Whether it is tested against the boxes of solids at all.
    pub(super) boxes: bool,
    /// The same for their balls.
    pub(super) balls: bool,
    /// Whether it goes through the hierarchies of wide unions.
    pub(super) hierarchies: bool,
    /// How hits are found.
    pub(super) solving: Solving,
    pub(super) skew: f64,
    slabs: OnceCell<Slabs>,
}

/// What every extent test asks of a ray.
///
/// An extent must never lose a hit that its solid's solver finds. So the box is tested as if it were wider by what
/// rounding can do to the ray on its way into generic coordinates: `near_start` and `far_start` are the origin moved
/// outwards by that much, and the times are widened by as many roundings (after Ize, JCGT 2(2), 2013).
#[derive(Clone, Copy, Debug)]
pub(super) struct Slabs {
    pub per_direction: [f64; 3],
    /// 1 along axes against which the ray goes, 0 along the others.
    pub backwards: [usize; 3],
    pub near_start: [f64; 3],
    pub far_start: [f64; 3],
    pub widening: f64,
    /// How far the origin was moved.
    pub slack: f64,
    /// What squared reaches are multiplied with before they are compared with squared moments; infinite where balls are not
    /// asked.
    pub per_reach: f64,
}

/// Roundings in the way of a ray into generic coordinates and in a slab test. Fewer could cut off a grazing hit; more would
/// only cost a test now and then.
pub(super) const ROUNDINGS: f64 = 16.0 * f64::EPSILON;

impl Course {
    /// The ray through `origin`; `skew` is the largest of the solids that it will be tested against
    /// ([`Placement::skew`](super::Placement::skew)).
    #[must_use]
    #[inline]
    pub const fn new(origin: DVec3, direction: DVec3, skew: f64) -> Self {
        let (boxes, balls, hierarchies) = (true, true, true);
        let solving = Solving::STANDARD;
        Self { line: [origin, direction], boxes, balls, hierarchies, solving, skew, slabs: OnceCell::new() }
    }

    /// The same ray, tested against the boxes of solids or not.
    #[must_use]
    pub fn testing_boxes(self, boxes: bool) -> Self {
        Self { boxes, ..self }
    }

    /// The same ray, tested against the balls of solids or not.
    #[must_use]
    pub fn testing_balls(self, balls: bool) -> Self {
        Self { balls, slabs: OnceCell::new(), ..self }
    }

    /// The same ray, led through the hierarchies of wide unions or not.
    #[must_use]
    pub fn using_hierarchies(self, hierarchies: bool) -> Self {
        Self { hierarchies, ..self }
    }

    /// The same ray, whose hits are found in another way.
    #[must_use]
    pub fn solving(self, solving: Solving) -> Self {
        Self { solving, ..self }
    }

    /// Whether its line surely passes a ball outside; never where balls are not asked.
    #[must_use]
    #[inline]
    pub fn passes_by(&self, ball: &Ball) -> bool {
        self.balls && ball.is_missed(self)
    }

    #[inline]
    pub(super) fn slabs(&self) -> &Slabs {
        // Put in place here: `get_or_init` alone takes that for a rare case.
        if self.slabs.get().is_none() {
            let _ = self.slabs.set(Slabs::new(self));
        }
        self.slabs.get_or_init(|| Slabs::new(self))
    }
}

impl Slabs {
    #[inline]
    fn new(&Course { line: [origin, direction], skew, balls, .. }: &Course) -> Self {
        let slack = ROUNDINGS * skew * origin.abs().max_element();
        let (start, course) = (origin.to_array(), direction.to_array());
        let per_direction = course.map(|d| 1.0 / d);
        let backwards = per_direction.map(|d| usize::from(d.is_sign_negative()));
        let widening = ROUNDINGS * skew;
        let moved = |by: f64| {
            std::array::from_fn(|axis| if backwards[axis] == 1 { start[axis] - by } else { start[axis] + by })
        };
        Self {
            per_direction,
            backwards,
            near_start: moved(slack),
            far_start: moved(-slack),
            widening,
            slack,
            per_reach: if balls { ball_scale(direction) } else { f64::INFINITY },
        }
    }

    /// The times of a box, further apart by what they can be off.
    #[inline]
    pub fn widened(&self, [t_in, t_out]: [f64; 2]) -> [f64; 2] {
        [t_in - self.widening * t_in.abs(), t_out + self.widening * t_out.abs()]
    }
}

/// |c|², and a little more than rounding can add to it: a line passes a ball outside where its squared moment about the middle
/// is larger than this times the square of the radius. Infinite where squares overflow or lose digits.
#[inline]
pub(super) fn ball_scale(direction: DVec3) -> f64 {
    let square = direction.length_squared();
    if (1e-200..1e200).contains(&square) { square * (1.0 + ROUNDINGS) } else { f64::INFINITY }
}
