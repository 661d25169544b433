//! A chequered block: cubes of two colours, by the parity of ⌊x / s⌋ + ⌊y / s⌋ + ⌊z / s⌋.
//!
//! A flat face that lies just between two layers of cubes takes its colour from rounding; moving the corner of the cubes
//! off the face (by half a cube, say) cures that.

use super::wood::is_odd;
use crate::record::{Binding, Entry};
use glam::DVec3;

/// Cubes of two colours.
#[derive(Clone, Debug, PartialEq)]
pub struct Checker {
    corner: DVec3,
    size: f64,
    even: DVec3,
    odd: DVec3,
}

impl Checker {
    /// Cubes of this size, one with a corner at `corner`; that one, upwards from there, has the colour `even`.
    ///
    /// # Errors
    /// Where the size is not positive, or the corner or a colour is not finite.
    pub fn new(corner: DVec3, size: f64, even: DVec3, odd: DVec3) -> Result<Self, String> {
        if !(size > 0.0 && size.is_finite()) {
            return Err(format!("the cubes of a checker must be larger than 0, not {size}"));
        }
        if !(corner.is_finite() && even.is_finite() && odd.is_finite()) {
            return Err("the corner and the colours of a checker must be finite".to_owned());
        }
        Ok(Self { corner, size, even, odd })
    }

    /// The colour at a point.
    #[must_use]
    pub fn colour(&self, p: DVec3) -> DVec3 {
        if is_odd(self.cube(p)) { self.odd } else { self.even }
    }

    /// The sum of the three whole numbers of the point's cube.
    fn cube(&self, p: DVec3) -> f64 {
        ((p - self.corner) / self.size).floor().element_sum()
    }

    /// The working behind the colour.
    pub(super) fn lines(&self, p: DVec3, entry: Entry) -> Entry {
        let place = (p - self.corner) / self.size;
        let sum = self.cube(p);
        let bindings: [Binding; 7] = [
            ("p", p.to_array().into()),
            ("c", self.corner.to_array().into()),
            ("s", self.size.into()),
            ("x", place.x.into()),
            ("y", place.y.into()),
            ("z", place.z.into()),
            ("k", sum.into()),
        ];
        entry
            .line("(x, y, z)", "(p − c) / s", &bindings, place.to_array())
            .line("k", "⌊x⌋ + ⌊y⌋ + ⌊z⌋", &bindings, sum)
            .line("odd", "k mod 2 = 1", &bindings, is_odd(sum))
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::points;
    use super::*;

    #[test]
    fn neighbours_differ_and_diagonal_neighbours_agree() {
        let checker = Checker::new(DVec3::ZERO, 0.5, DVec3::ONE, DVec3::ZERO).unwrap();
        assert_eq!(checker.colour(DVec3::splat(0.1)), DVec3::ONE);
        for p in points(500, 8.0) {
            let here = checker.colour(p);
            for axis in DVec3::AXES {
                assert_ne!(checker.colour(p + axis * 0.5), here);
                assert_eq!(checker.colour(p - axis), here);
            }
            assert_eq!(checker.colour(p + DVec3::new(0.5, 0.5, 0.0)), here);
        }
    }

    #[test]
    fn wrong_parameters_are_named() {
        assert!(Checker::new(DVec3::ZERO, -1.0, DVec3::ONE, DVec3::ZERO).unwrap_err().contains("larger than 0"));
        assert!(Checker::new(DVec3::NAN, 1.0, DVec3::ONE, DVec3::ZERO).unwrap_err().contains("finite"));
    }
}
