//! Layers: a colour spline along an axis, once or over and over.

use super::undulate::ColourSpline;
use crate::record::{Binding, Recorder};
use glam::DVec3;

/// A colour spline along an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Gradient {
    point: DVec3,
    /// Unit.
    axis: DVec3,
    length: f64,
    repeats: bool,
    spline: ColourSpline,
}

impl Gradient {
    /// The spline from −1 at `point` to 1 a `length` further along `axis` (any length but zero); beyond, it either begins
    /// again or stays as it ends.
    ///
    /// # Errors
    /// Where the axis is zero, the point not finite or the length not positive.
    pub fn new(point: DVec3, axis: DVec3, length: f64, repeats: bool, spline: ColourSpline) -> Result<Self, String> {
        let unit = axis.normalize_or_zero();
        if unit == DVec3::ZERO || !point.is_finite() {
            return Err(format!("the axis of a gradient needs a point and a direction, not {point} and {axis}"));
        }
        if !(length > 0.0 && length.is_finite()) {
            return Err(format!("the length of a gradient must be more than 0, not {length}"));
        }
        Ok(Self { point, axis: unit, length, repeats, spline })
    }

    /// The colour at a point.
    pub fn colour(&self, p: DVec3, recorder: &mut impl Recorder) -> DVec3 {
        let share = (p - self.point).dot(self.axis) / self.length;
        let argument = if self.repeats { 2.0 * (share - share.floor()) - 1.0 } else { 2.0 * share - 1.0 };
        self.spline.told(argument, recorder, |entry| {
            let bindings: [Binding; 5] = [
                ("p", p.to_array().into()),
                ("c", self.point.to_array().into()),
                ("a", self.axis.to_array().into()),
                ("M", self.length.into()),
                ("h", share.into()),
            ];
            let formula = if self.repeats { "2 (h − ⌊h⌋) − 1" } else { "2 h − 1" };
            entry.line("h", "(p − c) · a / M", &bindings, share).line("x", formula, &bindings, argument)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{Kept, assert_every_line_holds, points};
    use super::*;
    use crate::record::NullRecorder;

    fn gradient(repeats: bool) -> Gradient {
        let spline = ColourSpline::new(&[(-1.0, DVec3::ZERO), (1.0, DVec3::ONE)]).unwrap();
        Gradient::new(DVec3::new(0.0, 1.0, 0.0), DVec3::Y * 3.0, 2.0, repeats, spline).unwrap()
    }

    #[test]
    fn it_ends_where_it_is_said_to_and_begins_again_if_asked() {
        let at = |repeats: bool, y: f64| gradient(repeats).colour(DVec3::new(5.0, y, 5.0), &mut NullRecorder).x;
        for (y, once, again) in
            [(0.0, 0.0, 0.5), (1.0, 0.0, 0.0), (1.5, 0.156_25, 0.156_25), (2.0, 0.5, 0.5), (4.0, 1.0, 0.5)]
        {
            assert!((at(false, y) - once).abs() < 1e-15 && (at(true, y) - again).abs() < 1e-15, "{y}");
        }
    }

    #[test]
    fn its_working_holds() {
        let mut kept = Kept::default();
        for repeats in [false, true] {
            points(100, 4.0).for_each(|p| {
                gradient(repeats).colour(p, &mut kept);
            });
        }
        assert_every_line_holds(&kept);
    }

    #[test]
    fn wrong_parameters_are_named() {
        let spline = || gradient(true).spline;
        assert!(Gradient::new(DVec3::ZERO, DVec3::ZERO, 1.0, true, spline()).unwrap_err().contains("direction"));
        assert!(Gradient::new(DVec3::ZERO, DVec3::X, 0.0, true, spline()).unwrap_err().contains("length"));
    }
}
