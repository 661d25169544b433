//! A colour from a spline over [−1, 1] (§ 6.3.8).
//!
//! **Which spline** Cubic pieces whose slopes at the stops are chosen by Fritsch and Carlson, colour component by
//! component: it goes through all stops, its first derivative is continuous, and between two stops it never leaves their
//! range. A spline with a continuous second derivative overshoots, and would give colours below black.
//!
//! **Source** F. N. Fritsch, R. E. Carlson, "Monotone piecewise cubic interpolation", SIAM J. Numer. Anal. 17 (1980); the
//! slopes are the weighted harmonic means of F. N. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984).

use crate::record::{Binding, Entry, Recorder, Stop, Undulate, What};
use glam::DVec3;

/// How many steps the recorded curve has.
const STEPS: u32 = 64;

/// From one stop to the next: c₀ + u (c₁ + u (c₂ + u c₃)) with u measured from the first.
#[derive(Clone, Debug, PartialEq)]
struct Segment {
    at: f64,
    coefficients: [DVec3; 4],
}

/// A colour for each number from −1 to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct ColourSpline {
    stops: Vec<(f64, DVec3)>,
    segments: Vec<Segment>,
}

impl ColourSpline {
    /// The spline through stops, each a place from −1 to 1 and a colour. Before the first and after the last the colour
    /// stays as it is.
    ///
    /// # Errors
    /// Where there are fewer than two stops, or their places do not ascend within −1 to 1, or a colour is not finite.
    pub fn new(stops: &[(f64, DVec3)]) -> Result<Self, String> {
        let [(first, _), .., (last, _)] = stops else {
            return Err(format!("a colour spline needs two stops or more, not {}", stops.len()));
        };
        if !(*first >= -1.0 && *last <= 1.0) {
            return Err(format!("the stops of a colour spline lie between −1 and 1, not between {first} and {last}"));
        }
        if let Some(pair) =
            stops.windows(2).find(|pair| pair[0].0.partial_cmp(&pair[1].0) != Some(std::cmp::Ordering::Less))
        {
            return Err(format!("the stops of a colour spline ascend, but {} stands before {}", pair[0].0, pair[1].0));
        }
        if let Some((at, colour)) = stops.iter().find(|(_, colour)| !colour.is_finite()) {
            return Err(format!("the colour {colour} at {at} is not finite"));
        }
        let mut stops = stops.to_vec();
        if stops[0].0 > -1.0 {
            stops.insert(0, (-1.0, stops[0].1));
        }
        if stops[stops.len() - 1].0 < 1.0 {
            stops.push((1.0, stops[stops.len() - 1].1));
        }
        let segments = segments(&stops);
        Ok(Self { stops, segments })
    }

    /// The colour at a number, which is brought into [−1, 1].
    #[must_use]
    #[inline]
    pub fn colour(&self, argument: f64) -> DVec3 {
        self.look_up(brought_in(argument)).1
    }

    /// The same, told. `before` adds the lines that lead to the argument.
    pub fn told<R: Recorder>(&self, argument: f64, recorder: &mut R, before: impl FnOnce(Entry) -> Entry) -> DVec3 {
        let argument = brought_in(argument);
        let (segment, colour) = self.look_up(argument);
        recorder.note(|| self.describe(argument, segment, colour, before));
        colour
    }

    #[inline]
    fn look_up(&self, argument: f64) -> (usize, DVec3) {
        // There are few stops, and the first segment begins at −1.
        let segment = self.segments[1..].iter().take_while(|segment| segment.at <= argument).count();
        let Segment { at, coefficients: [a, b, c, d] } = &self.segments[segment];
        let u = argument - at;
        (segment, *a + (*b + (*c + *d * u) * u) * u)
    }

    fn describe(&self, argument: f64, segment: usize, colour: DVec3, before: impl FnOnce(Entry) -> Entry) -> Entry {
        let stop = |at: f64, colour: DVec3| Stop { at, colour: colour.to_array() };
        let curve = (0..=STEPS).map(|k| f64::from(k) * 2.0 / f64::from(STEPS) - 1.0);
        let Segment { at, coefficients: [a, b, c, d] } = &self.segments[segment];
        let u = argument - at;
        let bindings: [Binding; 7] = [
            ("x", argument.into()),
            ("x₀", (*at).into()),
            ("u", u.into()),
            ("C₀", a.to_array().into()),
            ("C₁", b.to_array().into()),
            ("C₂", c.to_array().into()),
            ("C₃", d.to_array().into()),
        ];
        before(Entry::new(What::Undulate(Undulate {
            argument,
            stops: self.stops.iter().map(|(at, colour)| stop(*at, *colour)).collect(),
            segment,
            curve: curve.map(|at| stop(at, self.colour(at))).collect(),
            colour: colour.to_array(),
        })))
        .line("u", "x − x₀", &bindings, u)
        .line("C", "C₀ + u (C₁ + u (C₂ + u C₃))", &bindings, colour.to_array())
    }
}

/// The number within [−1, 1]; what is no number counts as −1.
#[inline]
fn brought_in(x: f64) -> f64 {
    let x = if x > -1.0 { x } else { -1.0 };
    if x < 1.0 { x } else { 1.0 }
}

fn segments(stops: &[(f64, DVec3)]) -> Vec<Segment> {
    let width = |k: usize| stops[k + 1].0 - stops[k].0;
    let rise = |k: usize| (stops[k + 1].1 - stops[k].1) / width(k);
    let last = stops.len() - 1;
    // At the ends the spline is level, so that it goes on into the constant colour beyond.
    let slope = |k: usize| {
        if k == 0 || k == last { DVec3::ZERO } else { inner_slope([width(k - 1), width(k)], [rise(k - 1), rise(k)]) }
    };
    let segment = |k: usize| {
        let (h, from, to, rise) = (width(k), slope(k), slope(k + 1), rise(k));
        let second = (rise * 3.0 - from * 2.0 - to) / h;
        let third = (from + to - rise * 2.0) / (h * h);
        Segment { at: stops[k].0, coefficients: [stops[k].1, from, second, third] }
    };
    (0..last).map(segment).collect()
}

/// The slope at a stop between two segments: their weighted harmonic mean, or level at a peak or in a valley.
fn inner_slope([before, after]: [f64; 2], rises: [DVec3; 2]) -> DVec3 {
    let (w, v) = (2.0 * after + before, after + 2.0 * before);
    let component = |axis: usize| {
        let (left, right) = (rises[0][axis], rises[1][axis]);
        if left * right > 0.0 { (w + v) / (w / left + v / right) } else { 0.0 }
    };
    DVec3::from_array(std::array::from_fn(component))
}

#[cfg(test)]
mod tests {
    use super::super::testing::{Kept, assert_every_line_holds};
    use super::*;
    use proptest::prelude::*;

    fn grey(x: f64) -> DVec3 {
        DVec3::splat(x)
    }

    #[test]
    fn two_stops_make_the_smooth_step_between_them() {
        let spline = ColourSpline::new(&[(-1.0, grey(0.0)), (1.0, grey(1.0))]).unwrap();
        for (x, y) in [(-1.0, 0.0), (-0.5, 0.15625), (0.0, 0.5), (0.5, 0.84375), (1.0, 1.0)] {
            assert!((spline.colour(x) - grey(y)).length() < 1e-15, "{x}");
        }
    }

    #[test]
    fn what_lies_outside_has_the_colour_of_the_end() {
        let spline = ColourSpline::new(&[(-0.5, DVec3::X), (0.25, DVec3::Y)]).unwrap();
        for x in [f64::NEG_INFINITY, -7.0, -1.0, -0.75, -0.5, f64::NAN] {
            assert_eq!(spline.colour(x), DVec3::X);
        }
        for x in [0.25, 0.9, 1.0, 1e300] {
            assert!((spline.colour(x) - DVec3::Y).length() < 1e-15);
        }
    }

    #[test]
    fn wrong_stops_are_named() {
        for (stops, word) in [
            (vec![(0.0, grey(0.0))], "two stops"),
            (vec![(-2.0, grey(0.0)), (0.0, grey(1.0))], "between −1 and 1"),
            (vec![(0.5, grey(0.0)), (0.5, grey(1.0))], "ascend"),
            (vec![(0.0, grey(0.0)), (0.5, grey(f64::NAN))], "finite"),
        ] {
            assert!(ColourSpline::new(&stops).unwrap_err().contains(word));
        }
    }

    #[test]
    fn its_working_holds() {
        let stops = [(-1.0, DVec3::new(0.1, 0.2, 0.3)), (-0.2, DVec3::new(0.9, 0.1, 0.3)), (1.0, DVec3::ONE)];
        let spline = ColourSpline::new(&stops).unwrap();
        let mut kept = Kept::default();
        for x in [-1.0, -0.9, -0.2, 0.3, 1.0, 4.0] {
            assert_eq!(spline.told(x, &mut kept, |entry| entry), spline.colour(x));
        }
        assert_every_line_holds(&kept);
    }

    proptest! {
        #[test]
        fn it_goes_through_its_stops_smoothly_and_stays_between_them(
            colours in prop::collection::vec(0.0..1.0_f64, 2..7), gaps in prop::collection::vec(0.05..1.0_f64, 7),
        ) {
            let total: f64 = gaps[..colours.len()].iter().sum();
            let mut at = -1.0;
            let stops: Vec<_> = colours.iter().zip(&gaps).map(|(y, gap)| { let x = at; at += 2.0 * gap / total; (x, grey(*y)) }).collect();
            let spline = ColourSpline::new(&stops).unwrap();
            for (x, y) in &stops {
                prop_assert!((spline.colour(*x) - y).length() < 1e-12);
                // No step in the value, and none in the slope.
                let [before, after] = [-1e-5, 1e-5].map(|h| (spline.colour(x + h) - spline.colour(*x)) / h);
                prop_assert!(x.abs() == 1.0 || (before - after).length() < 2e-1, "{x}: {before} {after}");
            }
            for pair in stops.windows(2) {
                let (low, high) = (pair[0].1.min(pair[1].1), pair[0].1.max(pair[1].1));
                for k in 0..=20 {
                    let x = pair[0].0 + (pair[1].0 - pair[0].0) * f64::from(k) / 20.0;
                    let colour = spline.colour(x);
                    prop_assert!(colour.cmpge(low - 1e-12).all() && colour.cmple(high + 1e-12).all());
                }
            }
        }
    }
}
