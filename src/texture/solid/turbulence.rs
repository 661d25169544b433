//! Turbulence (§ 6.3.7): noise of several sizes added up, turb(s, p) = ½ Σ gainᵏ n(2ᵏ s p) for k = 0 … octaves − 1.
//!
//! The chapter's gain is ½: each octave is half as large and half as high as the one before. With the magnitude |n| in place
//! of n the valleys become creases, as in Perlin's first turbulence; granite is made of that.
//!
//! **Source** K. Perlin, "An image synthesizer", SIGGRAPH 1985; the factor ½ is the chapter's.

use super::noise::Noise;
use crate::record::{Binding, Entry, NullRecorder, Octave, Octaves, Recorder, What};
use glam::DVec3;

/// A sum of octaves of noise.
#[derive(Clone, Debug, PartialEq)]
pub struct Turbulence {
    /// The noise of all octaves.
    pub noise: Noise,
    /// s: how many cells of the first octave fit into a unit of length.
    pub scale: f64,
    /// How many octaves, 1 to 16.
    pub octaves: u32,
    /// How much lower each octave is than the one before.
    pub gain: f64,
    /// Whether magnitudes are added.
    pub absolute: bool,
}

/// Where the second and the third component of a vector are looked up, in cells of the first octave from the first: far
/// enough for them to have nothing in common, and at no whole number, for at these gradient noise is zero.
const APART: [DVec3; 2] = [DVec3::new(19.41, -47.26, 31.67), DVec3::new(-38.83, 23.39, 53.58)];

impl Turbulence {
    /// A sum of `octaves` octaves, the first with `scale` cells to a unit of length.
    ///
    /// # Errors
    /// Where the scale is not positive, there are no octaves or too many, or the gain is not between 0 and 1.
    pub fn new(noise: Noise, scale: f64, octaves: u32, gain: f64, absolute: bool) -> Result<Self, String> {
        if !(scale > 0.0 && scale.is_finite()) {
            return Err(format!("the scale of a turbulence must be more than 0, not {scale}"));
        }
        if !(1..=16).contains(&octaves) {
            return Err(format!("a turbulence has 1 to 16 octaves, not {octaves}"));
        }
        if !(gain > 0.0 && gain <= 1.0) {
            return Err(format!("the gain of a turbulence must be more than 0 and at most 1, not {gain}"));
        }
        Ok(Self { noise, scale, octaves, gain, absolute })
    }

    /// The sum at a point.
    #[must_use]
    pub fn value(&self, p: DVec3) -> f64 {
        self.told(p, &mut NullRecorder)
    }

    /// The sum at a point, told octave by octave.
    pub fn told(&self, p: DVec3, recorder: &mut impl Recorder) -> f64 {
        self.told_with(p, recorder, |entry, _| entry)
    }

    /// The same, with more lines of working that start from the sum.
    pub(super) fn told_with<R: Recorder>(
        &self,
        p: DVec3,
        recorder: &mut R,
        more: impl FnOnce(Entry, f64) -> Entry,
    ) -> f64 {
        recorder.begin();
        let mut rows = Vec::new();
        let (mut frequency, mut weight, mut sum) = (self.scale, 0.5, 0.0);
        for k in 0..self.octaves {
            let noise = self.noise.told(p * frequency, recorder);
            let noise = if self.absolute { noise.abs() } else { noise };
            let term = weight * noise;
            sum += term;
            if R::RECORDING {
                rows.push(Octave { k, frequency, weight, noise, term });
            }
            frequency *= 2.0;
            weight *= self.gain;
        }
        recorder.end(|| more(describe(rows, sum), sum));
        sum
    }

    /// The sum at a point, and its gradient; where a magnitude has its crease, that of one side.
    #[must_use]
    pub fn value_and_slope(&self, p: DVec3) -> (f64, DVec3) {
        let (mut frequency, mut weight) = (self.scale, 0.5);
        let mut sum = (0.0, DVec3::ZERO);
        for _ in 0..self.octaves {
            let (noise, slope) = self.noise.value_and_slope(p * frequency);
            let signed = if self.absolute && noise < 0.0 { -weight } else { weight };
            sum = (sum.0 + signed * noise, sum.1 + slope * (signed * frequency));
            frequency *= 2.0;
            weight *= self.gain;
        }
        sum
    }

    /// Where the three components of a vector are looked up for a point.
    pub(super) fn places(&self, p: DVec3) -> [DVec3; 3] {
        [p, p + APART[0] / self.scale, p + APART[1] / self.scale]
    }
}

fn describe(rows: Vec<Octave>, sum: f64) -> Entry {
    let mut lines = Vec::new();
    let mut so_far = 0.0;
    for row in &rows {
        let bindings: [Binding; 3] = [("T", so_far.into()), ("w", row.weight.into()), ("n", row.noise.into())];
        so_far += row.term;
        lines.push((bindings, so_far));
    }
    let entry = Entry::new(What::Octaves(Octaves { rows, sum }));
    lines.iter().fold(entry, |entry, (bindings, sum)| entry.line("T", "T + w n", bindings, *sum))
}

#[cfg(test)]
mod tests {
    use super::super::noise::NoiseKind;
    use super::super::testing::points;
    use super::*;

    fn turbulence(octaves: u32, absolute: bool) -> Turbulence {
        Turbulence::new(Noise::new(NoiseKind::Gradient, 5), 1.5, octaves, 0.5, absolute).unwrap()
    }

    #[test]
    fn three_octaves_are_the_three_terms_of_the_chapter() {
        let (three, noise) = (turbulence(3, false), Noise::new(NoiseKind::Gradient, 5));
        for p in points(100, 20.0) {
            let terms = 0.5 * noise.value(p * 1.5) + 0.25 * noise.value(p * 3.0) + 0.125 * noise.value(p * 6.0);
            assert!((three.value(p) - terms).abs() < 1e-15);
        }
    }

    #[test]
    fn magnitudes_add_up_to_no_less_than_the_signed_sum() {
        for p in points(1000, 20.0) {
            let (signed, magnitudes) = (turbulence(6, false).value(p), turbulence(6, true).value(p));
            assert!(magnitudes >= signed.abs() && magnitudes < 1.0);
        }
    }

    #[test]
    fn the_gradient_is_that_of_the_differences() {
        const H: f64 = 1e-6;
        for absolute in [false, true] {
            let turbulence = turbulence(4, absolute);
            for p in points(300, 20.0) {
                let (value, slope) = turbulence.value_and_slope(p);
                assert!((value - turbulence.value(p)).abs() < 1e-15);
                let difference =
                    |axis: DVec3| (turbulence.value(p + axis * H) - turbulence.value(p - axis * H)) / (2.0 * H);
                let crease =
                    absolute && (0..4).any(|k| turbulence.noise.value(p * 1.5 * f64::from(1 << k)).abs() < 1e-4);
                let found = DVec3::new(difference(DVec3::X), difference(DVec3::Y), difference(DVec3::Z));
                assert!(crease || (found - slope).length() < 1e-7, "{found} {slope}");
            }
        }
    }

    #[test]
    fn wrong_parameters_are_named() {
        let noise = || Noise::new(NoiseKind::Value, 1);
        for (scale, octaves, gain, word) in
            [(0.0, 3, 0.5, "scale"), (1.0, 0, 0.5, "octaves"), (1.0, 17, 0.5, "octaves"), (1.0, 3, 1.5, "gain")]
        {
            assert!(Turbulence::new(noise(), scale, octaves, gain, false).unwrap_err().contains(word));
        }
    }
}
