//! Boxes that hold a solid, so that a ray that misses the box need not be tested against what is in it (§ 6.5.4).

use super::Placement;
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

/// Roundings by which a box is widened. Fewer than the eight of transform and slab test could cut off a grazing hit;
/// more would only cost a test now and then.
const PADDING: f64 = 16.0 * f64::EPSILON;

impl Extent {
    /// The box of everything.
    pub const UNBOUNDED: Self = Self { low: DVec3::NEG_INFINITY, high: DVec3::INFINITY };

    /// The box of a placed primitive: that of the eight transformed corners of its own box.
    #[must_use]
    pub fn of_primitive(bounds: Bounds, placement: &Placement) -> Self {
        if !(bounds.low.is_finite() && bounds.high.is_finite()) {
            return Self::UNBOUNDED;
        }
        let centre = (bounds.low + bounds.high) * 0.5;
        let half = (bounds.high - bounds.low) * 0.5;
        let matrix = placement.world_from_generic.matrix3;
        let world_centre = placement.world_from_generic.transform_point3(centre);
        let world_half = matrix.abs() * half;
        let size = world_half + matrix.abs() * centre.abs() + placement.world_from_generic.translation.abs();
        Self { low: world_centre - world_half, high: world_centre + world_half }.padded(size)
    }

    /// The box of a compound, from those of its operands.
    #[must_use]
    pub fn of_pair(operator: Operator, left: Self, right: Self) -> Self {
        match operator {
            Operator::Union => Self { low: left.low.min(right.low), high: left.high.max(right.high) },
            Operator::Intersection => Self { low: left.low.max(right.low), high: left.high.min(right.high) },
            Operator::Difference => left,
        }
    }

    /// The times between which the ray is in the box, or none if it misses.
    ///
    /// Slabs widened by four roundings at both ends, so that a hit is never lost (after Ize, JCGT 2(2), 2013). A ray
    /// that lies in a side gives 0 · ∞ = NaN, which `min` and `max` pass over.
    #[must_use]
    pub fn inside(&self, origin: DVec3, direction: DVec3) -> Option<[f64; 2]> {
        const WIDENING: f64 = 4.0 * f64::EPSILON;
        let (mut t_in, mut t_out) = (f64::NEG_INFINITY, f64::INFINITY);
        for axis in 0..3 {
            let reciprocal = 1.0 / direction[axis];
            let low = (self.low[axis] - origin[axis]) * reciprocal;
            let high = (self.high[axis] - origin[axis]) * reciprocal;
            let (near, far) = if reciprocal.is_sign_negative() { (high, low) } else { (low, high) };
            t_in = t_in.max(near * (1.0 - WIDENING.copysign(near)));
            t_out = t_out.min(far * (1.0 + WIDENING.copysign(far)));
        }
        (t_in <= t_out).then_some([t_in, t_out])
    }

    /// Whether it holds everything, so that testing it is idle.
    #[must_use]
    pub fn is_unbounded(&self) -> bool {
        *self == Self::UNBOUNDED
    }

    fn padded(self, size: DVec3) -> Self {
        Self { low: self.low - size * PADDING, high: self.high + size * PADDING }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Extent = Extent { low: DVec3::NEG_ONE, high: DVec3::ONE };

    #[test]
    fn a_ray_through_the_box_has_its_two_times() {
        let [t_in, t_out] = UNIT.inside(DVec3::new(-3.0, 0.5, 0.5), DVec3::X).expect("it hits");
        assert!((t_in - 2.0).abs() < 1e-14 && t_in <= 2.0);
        assert!((t_out - 4.0).abs() < 1e-14 && t_out >= 4.0);
    }

    #[test]
    fn a_ray_beside_the_box_misses() {
        assert_eq!(UNIT.inside(DVec3::new(-3.0, 1.5, 0.0), DVec3::X), None);
        assert_eq!(UNIT.inside(DVec3::new(-3.0, 0.0, 0.0), DVec3::new(1.0, 1.0, 0.0)), None);
    }

    #[test]
    fn a_ray_in_a_side_of_the_box_is_not_lost() {
        assert!(UNIT.inside(DVec3::new(-3.0, 1.0, 0.0), DVec3::X).is_some());
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
