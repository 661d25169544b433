//! The reference: what a picture would be if time did not count.
//!
//! Every knob is at its best, and where chance decides, the reference is the mean of several pictures with random numbers of
//! their own, none of them those of the scene.
//!
//! **What is true** is what the scene asks for. A scene that is looked at through the centres of its pixels, without a lens, without
//! lights that have a size, asks for exactly these colours: its reference is looked at through the centres, too, and steps along
//! edges are no error of it. A scene that is sampled asks for means over pixels, lens and lights, however few samples it takes: its
//! reference converges to these. The octaves of noise are part of what the scene asks for: more of them are another texture.
//! Light that was mirrored more often than the deepest ray is missing from the reference, too, and where light is taken apart
//! without chance its colours are still those of a number of wavelengths.
//!
//! Hits have 32 digits. Only where chance decides they are found as surely as pictures find them anyway, in less time: the last digits
//! of a hit count for nothing beside what chance leaves open.
//!
//! **How sure it is.** The error of the mean of n pictures is estimated by what they differ from each other: the standard error
//! s / √n of each channel of each pixel, as a root mean square over all of them. Wavelengths that stand evenly, one set for all
//! pixels, know no chance: what half of them would change bounds what is left of their error.

use super::{Knob, Reference};
use crate::scene::{Profile, Rgb, Scene, Shortcuts};
use crate::shape::{Method, Search};
use crate::texture::image::Filter;
use crate::texture::relief::BumpDerivative;
use crate::trace::Picture;

/// The fewest samples of each of the reference's pictures.
const SAMPLES: u32 = 64;

/// The fewest wavelengths that its light is taken apart into.
const WAVELENGTHS: u32 = 64;

/// How deep its trees of rays are, at least.
const DEPTH: u32 = 16;

/// Pictures that it takes at least where chance decides: one alone says nothing of how sure it is.
pub const FEWEST_PICTURES: u32 = 2;

/// Every knob that matters to the scene, at its best.
#[must_use]
pub fn best_profile(scene: &Scene) -> Profile {
    let matters = |knob: Knob| knob.matters_to(scene);
    Profile {
        method: Some(if is_random(scene) { Method::Adaptive } else { Method::DoubleDouble }),
        search: matters(Knob::Search).then_some(Search::Certified),
        samples: matters(Knob::Samples).then_some(scene.sampling.samples.max(SAMPLES)),
        lens_samples: None,
        wavelengths: matters(Knob::Wavelengths).then_some(scene.sampling.wavelengths.max(WAVELENGTHS)),
        depth: matters(Knob::Depth).then_some(scene.limits.depth.max(DEPTH)),
        contribution: matters(Knob::Contribution).then_some(0.0),
        octaves: None,
        filter: matters(Knob::Filter).then_some(Filter::Area),
        bump: matters(Knob::Bump).then_some(BumpDerivative::Exact),
        shortcuts: Some(Shortcuts::ALL),
    }
}

/// Whether chance decides over the scene's colours.
#[must_use]
pub fn is_random(scene: &Scene) -> bool {
    Knob::Samples.matters_to(scene)
}

/// What is true of the scene, in words.
#[must_use]
pub fn what_is_true(scene: &Scene) -> &'static str {
    if Knob::Samples.matters_to(scene) {
        "means over pixels, lens and lights"
    } else {
        "colours at the centres of pixels"
    }
}

/// The scene as the reference's `number`-th picture shows it.
#[must_use]
pub fn reference_scene(scene: &Scene, number: u32) -> Scene {
    let mut best = scene.with_profile(&best_profile(scene));
    // Odd steps from the scene's own seed never come back to it within 2³² pictures.
    best.sampling.seed = scene.sampling.seed.wrapping_add((number + 1).wrapping_mul(0x9e37_79b9));
    best
}

/// Sums over pictures of one size, from which their mean and its error follow.
#[derive(Clone, Debug, PartialEq)]
pub struct Sums {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// How many pictures.
    pub count: u32,
    /// Of the colours, row by row from the top.
    pub colours: Vec<Rgb>,
    /// Of their squares.
    pub squares: Vec<Rgb>,
}

impl Sums {
    /// Of no pictures yet.
    #[must_use]
    pub fn new(width: u32, height: u32) -> Self {
        let nothing = vec![Rgb::ZERO; width as usize * height as usize];
        Self { width, height, count: 0, colours: nothing.clone(), squares: nothing }
    }

    /// Adds a picture of this size; others are passed over.
    pub fn add(&mut self, picture: &Picture) {
        if [picture.width, picture.height] != [self.width, self.height] {
            return;
        }
        self.count += 1;
        let sums = self.colours.iter_mut().zip(&mut self.squares);
        for ((sum, squares), &colour) in sums.zip(picture.pixels()) {
            *sum += colour;
            *squares += colour * colour;
        }
    }

    /// The mean of the pictures; none if there are none.
    #[must_use]
    pub fn mean(&self) -> Option<Picture> {
        let count = f64::from(self.count);
        let mean = || self.colours.iter().map(|&sum| sum / count).collect();
        (self.count > 0).then(mean).and_then(|pixels| Picture::from_pixels(self.width, self.height, pixels))
    }

    /// The standard error of the mean as a root mean square; infinite for fewer than two pictures.
    #[must_use]
    pub fn error(&self) -> f64 {
        if self.count < 2 || self.colours.is_empty() {
            return f64::INFINITY;
        }
        let count = f64::from(self.count);
        let squared = |(&sum, &squares): (&Rgb, &Rgb)| {
            let mean = sum / count;
            let variance = ((squares - mean * mean * count) / (count - 1.0)).max(Rgb::ZERO);
            // Errors are of what is stored, where all that is lighter than 1 is the same.
            let stored = |k: usize| ((variance[k] / count).sqrt() - (mean[k] - 1.0).max(0.0)).max(0.0);
            (0..3).map(|k| stored(k) * stored(k)).sum::<f64>()
        };
        let sum: f64 = self.colours.iter().zip(&self.squares).map(squared).sum();
        (sum / (3 * self.colours.len()) as f64).sqrt()
    }

    /// What they are of a scene; none if there are no pictures yet.
    #[must_use]
    pub fn reference(&self, scene: &Scene, cached: bool) -> Option<Reference> {
        Some(Reference {
            profile: best_profile(scene),
            picture: self.mean()?,
            pictures: self.count,
            error: if is_random(scene) { self.error() } else { 0.0 },
            cached,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grey(value: f64) -> Picture {
        Picture::from_pixels(2, 1, vec![Rgb::splat(value); 2]).unwrap()
    }

    fn sums(values: &[f64]) -> Sums {
        let mut sums = Sums::new(2, 1);
        for &value in values {
            sums.add(&grey(value));
        }
        sums
    }

    #[test]
    fn the_mean_and_its_standard_error_are_those_of_the_pictures() {
        let sums = sums(&[0.25, 0.5, 0.75, 0.5]);
        assert_eq!(sums.mean().unwrap(), grey(0.5));
        // Their standard deviation is √(0.125 / 3); the mean of four errs by half of that.
        assert!((sums.error() - 0.5 * (0.125_f64 / 3.0).sqrt()).abs() < 1e-15, "{}", sums.error());
    }

    #[test]
    fn equal_pictures_leave_no_error_and_one_alone_says_nothing_of_it() {
        assert_eq!(sums(&[0.5, 0.5, 0.5]).error(), 0.0);
        assert_eq!(sums(&[0.5]).error(), f64::INFINITY);
        assert_eq!(sums(&[]).mean(), None);
    }

    #[test]
    fn what_is_lighter_than_white_is_sure_to_be_white() {
        assert_eq!(sums(&[5.0, 6.0]).error(), 0.0);
    }

    #[test]
    fn a_picture_of_another_size_is_not_added() {
        let mut sums = Sums::new(3, 1);
        sums.add(&grey(1.0));
        assert_eq!(sums.count, 0);
    }
}
