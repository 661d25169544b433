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
    /// Slabs with the far side two ulps out, so that a hit is never lost to rounding (Ize, JCGT 2(2), 2013). A ray
    /// that lies in a side gives 0 · ∞ = NaN, which the order of `min` and `max` passes over.
    #[must_use]
    pub fn inside(&self, origin: DVec3, direction: DVec3) -> Option<[f64; 2]> {
        const FAR_PADDING: f64 = 1.0 + 4.0 * f64::EPSILON;
        let (mut t_in, mut t_out) = (f64::NEG_INFINITY, f64::INFINITY);
        for axis in 0..3 {
            let reciprocal = 1.0 / direction[axis];
            let near = (self.low[axis] - origin[axis]) * reciprocal;
            let far = (self.high[axis] - origin[axis]) * reciprocal;
            let (near, far) = if reciprocal.is_sign_negative() { (far, near) } else { (near, far) };
            t_in = t_in.max(near - near.abs() * (FAR_PADDING - 1.0));
            t_out = t_out.min(far + far.abs() * (FAR_PADDING - 1.0));
        }
        (t_in <= t_out).then_some([t_in, t_out])
    }

    fn padded(self, size: DVec3) -> Self {
        Self { low: self.low - size * PADDING, high: self.high + size * PADDING }
    }
}
