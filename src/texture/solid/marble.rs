//! Marble (§ 6.3.8): undulate(sin(f h + A turb(p))), veins across an axis, stirred by turbulence.
//!
//! h is the height along the axis, f how many radians of the sine a unit of it takes, A how far the turbulence pushes the
//! veins, in radians. With A = 0 they are flat layers. (The chapter's formula shows no turbulence; its prose does.)
//!
//! **Source** K. Perlin, "An image synthesizer", SIGGRAPH 1985.

use super::turbulence::Turbulence;
use super::undulate::ColourSpline;
use crate::math::sine_cosine;
use crate::record::{Binding, Recorder};
use glam::DVec3;
use std::f64::consts::PI;

/// Veins across an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Marble {
    /// Unit: the veins lie across it.
    axis: DVec3,
    /// f: radians of the sine for a unit of height.
    frequency: f64,
    /// A: radians for a turbulence of 1.
    amplitude: f64,
    turbulence: Turbulence,
    spline: ColourSpline,
}

impl Marble {
    /// Veins across `axis` (any length but zero), `frequency` radians of the sine to a unit of height, pushed by `amplitude`
    /// radians for a turbulence of 1, coloured by `spline`.
    ///
    /// # Errors
    /// Where the axis is zero, or the frequency or the amplitude is not finite.
    pub fn new(
        axis: DVec3,
        frequency: f64,
        amplitude: f64,
        turbulence: Turbulence,
        spline: ColourSpline,
    ) -> Result<Self, String> {
        let unit = axis.normalize_or_zero();
        if unit == DVec3::ZERO {
            return Err(format!("the axis of marble needs a direction, not {axis}"));
        }
        if !(frequency.is_finite() && amplitude.is_finite()) {
            return Err(format!("frequency and amplitude of marble must be finite, not {frequency} and {amplitude}"));
        }
        Ok(Self { axis: unit, frequency, amplitude, turbulence, spline })
    }

    /// Stirs the noise to another time.
    pub fn at_time(&mut self, time: f64) {
        self.turbulence.noise.at_time(time);
    }

    /// What pushes the veins.
    pub const fn turbulence_mut(&mut self) -> &mut Turbulence {
        &mut self.turbulence
    }

    /// The colour at a point.
    pub fn colour(&self, p: DVec3, recorder: &mut impl Recorder) -> DVec3 {
        let turbulence = self.turbulence.told(p, recorder);
        let height = self.axis.dot(p);
        let phase = self.frequency * height + self.amplitude * turbulence;
        let (sine, _) = sine_cosine(phase);
        self.spline.told(sine, recorder, |entry| {
            let bindings: [Binding; 8] = [
                ("a", self.axis.to_array().into()),
                ("p", p.to_array().into()),
                ("h", height.into()),
                ("f", self.frequency.into()),
                ("A", self.amplitude.into()),
                ("T", turbulence.into()),
                ("φ", phase.into()),
                ("π", PI.into()),
            ];
            entry.line("h", "a · p", &bindings, height).line("φ", "f h + A T", &bindings, phase).line(
                "x",
                "sin(180 φ / π)",
                &bindings,
                sine,
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::noise::{Noise, NoiseKind};
    use super::super::testing::{Kept, assert_every_line_holds, points};
    use super::*;
    use crate::record::NullRecorder;

    fn marble(amplitude: f64) -> Marble {
        let turbulence = Turbulence::new(Noise::new(NoiseKind::Gradient, 1), 1.0, 6, 0.5, false).unwrap();
        let spline = ColourSpline::new(&[(-1.0, DVec3::ZERO), (1.0, DVec3::ONE)]).unwrap();
        Marble::new(DVec3::new(0.0, 3.0, 4.0), 2.0, amplitude, turbulence, spline).unwrap()
    }

    #[test]
    fn without_turbulence_the_veins_are_the_sine_of_the_height() {
        let marble = marble(0.0);
        for p in points(200, 10.0) {
            let sine = (2.0 * (0.6 * p.y + 0.8 * p.z)).sin();
            let u = 0.5 * (sine + 1.0);
            assert!((marble.colour(p, &mut NullRecorder).x - u * u * (3.0 - 2.0 * u)).abs() < 1e-13);
        }
    }

    #[test]
    fn its_working_holds_and_watching_changes_nothing() {
        let marble = marble(5.0);
        let mut kept = Kept::default();
        for p in points(100, 10.0) {
            assert_eq!(marble.colour(p, &mut kept), marble.colour(p, &mut NullRecorder));
        }
        // Six lattices, their sum, and the spline.
        assert_eq!(kept.0.len(), 800);
        assert_every_line_holds(&kept);
    }

    #[test]
    fn far_out_and_off_the_map_it_still_has_a_colour() {
        for x in [1e16, -1e300, f64::MAX, f64::INFINITY, f64::NAN] {
            let colour = marble(5.0).colour(DVec3::new(x, 0.5, x), &mut NullRecorder);
            assert!(colour.cmpge(DVec3::ZERO).all() && colour.cmple(DVec3::ONE).all(), "{colour} at {x}");
        }
    }
}
