//! Noise or turbulence as a colour: undulate(bias + contrast · n).
//!
//! Gradient noise mostly lies within ±½, so a contrast of 2 uses the whole spline. Turbulence of magnitudes lies from 0
//! to 1; a bias of −1 with a contrast of 3 or so makes granite of it.

use super::noise::Noise;
use super::turbulence::Turbulence;
use super::undulate::ColourSpline;
use crate::record::{Binding, Recorder};
use glam::DVec3;

/// What is made into a colour.
#[derive(Clone, Debug, PartialEq)]
pub enum Mottle {
    /// Noise with this many cells to a unit of length.
    Noise(Noise, f64),
    /// Turbulence.
    Turbulence(Turbulence),
}

/// Noise or turbulence as a colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Mottled {
    mottle: Mottle,
    bias: f64,
    contrast: f64,
    spline: ColourSpline,
}

impl Mottled {
    /// The colour at bias + contrast n of the spline.
    ///
    /// # Errors
    /// Where the bias or the contrast is not finite, or the scale of the noise is not positive.
    pub fn new(mottle: Mottle, bias: f64, contrast: f64, spline: ColourSpline) -> Result<Self, String> {
        if !(bias.is_finite() && contrast.is_finite()) {
            return Err(format!("bias and contrast must be finite, not {bias} and {contrast}"));
        }
        match mottle {
            Mottle::Noise(_, scale) if !(scale > 0.0 && scale.is_finite()) => {
                Err(format!("the scale of noise must be more than 0, not {scale}"))
            }
            _ => Ok(Self { mottle, bias, contrast, spline }),
        }
    }

    /// Stirs the noise to another time.
    pub fn at_time(&mut self, time: f64) {
        match &mut self.mottle {
            Mottle::Noise(noise, _) => noise.at_time(time),
            Mottle::Turbulence(turbulence) => turbulence.noise.at_time(time),
        }
    }

    /// The turbulence, if it is one.
    pub fn turbulence_mut(&mut self) -> Option<&mut Turbulence> {
        match &mut self.mottle {
            Mottle::Noise(..) => None,
            Mottle::Turbulence(turbulence) => Some(turbulence),
        }
    }

    /// The colour at a point.
    pub fn colour(&self, p: DVec3, recorder: &mut impl Recorder) -> DVec3 {
        let n = match &self.mottle {
            Mottle::Noise(noise, scale) => noise.told(p * *scale, recorder),
            Mottle::Turbulence(turbulence) => turbulence.told(p, recorder),
        };
        let argument = self.bias + self.contrast * n;
        self.spline.told(argument, recorder, |entry| {
            let bindings: [Binding; 3] = [("b", self.bias.into()), ("c", self.contrast.into()), ("n", n.into())];
            entry.line("x", "b + c n", &bindings, argument)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::noise::NoiseKind;
    use super::super::testing::{Kept, assert_every_line_holds, points};
    use super::*;

    #[test]
    fn the_colour_is_that_of_the_noise_and_its_working_holds() {
        let noise = Noise::new(NoiseKind::Value, 8);
        let spline = ColourSpline::new(&[(-1.0, DVec3::X), (0.2, DVec3::ZERO), (1.0, DVec3::ONE)]).unwrap();
        let turbulence = Turbulence::new(noise.clone(), 3.0, 4, 0.5, true).unwrap();
        let mottled = |mottle| Mottled::new(mottle, -0.1, 2.0, spline.clone()).unwrap();
        let (plain, granite) =
            (mottled(Mottle::Noise(noise.clone(), 2.0)), mottled(Mottle::Turbulence(turbulence.clone())));
        let mut kept = Kept::default();
        for p in points(100, 9.0) {
            assert_eq!(plain.colour(p, &mut kept), spline.colour(2.0 * noise.value(p * 2.0) - 0.1));
            assert_eq!(granite.colour(p, &mut kept), spline.colour(2.0 * turbulence.value(p) - 0.1));
        }
        assert_every_line_holds(&kept);
        assert!(Mottled::new(Mottle::Noise(noise, 0.0), 0.0, 1.0, spline).unwrap_err().contains("scale"));
    }
}
