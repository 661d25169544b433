//! Boxes that hold a solid, so that a ray that misses the box need not be tested against what is in it (§ 6.5.4).

use super::{Course, Placement};
use crate::record::Operator;
use crate::shape::Bounds;
use glam::DVec3;

/// A box with its sides along the world's axes; infinite where the solid is unbounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// The corner with the smallest coordinates.
    pub low: DVec3,
    /// The corner with the largest coordinates.
    pub high: DVec3,
}

/// Roundings by which a box is widened, times the skew of what is in it. Fewer than the eight of transform and slab test
/// could cut off a grazing hit; more would only cost a test now and then.
const PADDING: f64 = 16.0 * f64::EPSILON;

impl Extent {
    /// The box of everything.
    pub const UNBOUNDED: Self = Self { low: DVec3::NEG_INFINITY, high: DVec3::INFINITY };

    /// The box of nothing.
    pub const EMPTY: Self = Self { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    /// The box of a placed primitive: that of the eight transformed corners of its own box.
    #[must_use]
    pub fn of_primitive(bounds: Bounds, placement: &Placement) -> Self {
        if !(bounds.low.is_finite() && bounds.high.is_finite()) {
            return Self::UNBOUNDED;
        }
        let centre = (bounds.low + bounds.high) * 0.5;
        let half = (bounds.high - bounds.low) * 0.5;
        let matrix = placement.world_from_generic().matrix3;
        let world_centre = placement.world_from_generic().transform_point3(centre);
        let world_half = matrix.abs() * half;
        let size = world_half + matrix.abs() * centre.abs() + placement.world_from_generic().translation.abs();
        let padding = size.max_element() * PADDING * placement.skew();
        let padding = if padding.is_finite() { padding } else { f64::INFINITY };
        Self { low: world_centre - world_half - padding, high: world_centre + world_half + padding }
    }

    /// The box of a compound, from those of its operands.
    #[must_use]
    pub fn of_pair(operator: Operator, left: Self, right: Self) -> Self {
        match operator {
            Operator::Union => left.joined(right),
            Operator::Intersection => Self { low: left.low.max(right.low), high: left.high.min(right.high) },
            Operator::Difference => left,
        }
    }

    /// The box of two boxes.
    #[must_use]
    pub fn joined(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The times between which the ray is in the box, or none if it misses.
    #[must_use]
    #[inline]
    pub fn inside(&self, course: &Course) -> Option<[f64; 2]> {
        let slabs = course.slabs();
        let (low, high) = (self.low.to_array(), self.high.to_array());
        let (mut t_in, mut t_out) = (f64::NEG_INFINITY, f64::INFINITY);
        for axis in 0..3 {
            let is_backwards = slabs.backwards[axis] == 1;
            let [near, far] = if is_backwards { [high[axis], low[axis]] } else { [low[axis], high[axis]] };
            let near = (near - slabs.near_start[axis]) * slabs.per_direction[axis];
            let far = (far - slabs.far_start[axis]) * slabs.per_direction[axis];
            // A ray that lies in a side gives 0 · ∞ = NaN, which both comparisons pass over.
            t_in = if near > t_in { near } else { t_in };
            t_out = if far < t_out { far } else { t_out };
        }
        let [t_in, t_out] = slabs.widened([t_in, t_out]);
        (t_in <= t_out).then_some([t_in, t_out])
    }

    /// Whether it holds everything, so that testing it is idle.
    #[must_use]
    pub fn is_unbounded(&self) -> bool {
        *self == Self::UNBOUNDED
    }

    /// Whether it ends on all sides.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }

    /// Whether it holds a point.
    #[must_use]
    pub fn holds(&self, point: DVec3) -> bool {
        self.low.cmple(point).all() && point.cmple(self.high).all()
    }

    /// Whether it holds a point, or would if it were wider by `slack` on all sides.
    #[must_use]
    pub fn holds_nearly(&self, point: DVec3, slack: f64) -> bool {
        self.grown(slack).holds(point)
    }

    /// Whether some point is in both.
    #[must_use]
    pub fn meets(&self, other: Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }

    /// The box with all of its faces moved outwards.
    #[must_use]
    pub fn grown(&self, by: f64) -> Self {
        Self { low: self.low - by, high: self.high + by }
    }

    /// Its eight corners.
    #[must_use]
    pub fn corners(&self) -> [DVec3; 8] {
        std::array::from_fn(|k| {
            let pick = |axis: usize| if k >> axis & 1 == 0 { self.low[axis] } else { self.high[axis] };
            DVec3::new(pick(0), pick(1), pick(2))
        })
    }

    /// Half its surface: in proportion to the share of random rays that meet it (Cauchy). Nothing for an empty box.
    #[must_use]
    pub fn half_surface(&self) -> f64 {
        let DVec3 { x, y, z } = (self.high - self.low).max(DVec3::ZERO);
        x * y + y * z + z * x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Extent = Extent { low: DVec3::NEG_ONE, high: DVec3::ONE };

    fn course(origin: [f64; 3], direction: [f64; 3]) -> Course {
        Course::new(origin.into(), direction.into(), 1.0)
    }

    #[test]
    fn a_ray_through_the_box_has_its_two_times() {
        let [t_in, t_out] = UNIT.inside(&course([-3.0, 0.5, 0.5], [1.0, 0.0, 0.0])).expect("it hits");
        assert!((t_in - 2.0).abs() < 1e-13 && t_in <= 2.0);
        assert!((t_out - 4.0).abs() < 1e-13 && t_out >= 4.0);
    }

    #[test]
    fn a_ray_beside_the_box_misses() {
        assert_eq!(UNIT.inside(&course([-3.0, 1.5, 0.0], [1.0, 0.0, 0.0])), None);
        assert_eq!(UNIT.inside(&course([-3.0, 0.0, 0.0], [1.0, 1.0, 0.0])), None);
    }

    #[test]
    fn a_ray_in_a_side_of_the_box_is_not_lost() {
        assert!(UNIT.inside(&course([-3.0, 1.0, 0.0], [1.0, 0.0, 0.0])).is_some());
    }

    #[test]
    fn nothing_meets_an_empty_box_and_everything_one_without_end() {
        let ray = course([-3.0, 1.0, 0.0], [1.0, -0.0, 0.0]);
        assert_eq!(Extent::EMPTY.inside(&ray), None);
        assert!(Extent::UNBOUNDED.inside(&ray).is_some());
    }

    #[test]
    fn an_intersection_is_held_by_less_than_either_operand() {
        let other = Extent { low: DVec3::ZERO, high: DVec3::splat(3.0) };
        let both = Extent::of_pair(Operator::Intersection, UNIT, other);
        assert_eq!(both, Extent { low: DVec3::ZERO, high: DVec3::ONE });
        assert_eq!(Extent::of_pair(Operator::Difference, UNIT, other), UNIT);
        assert_eq!(Extent::of_pair(Operator::Union, UNIT, other).high, DVec3::splat(3.0));
    }
}
