//! Accuracy profiles: what a picture is asked to be, where that trades accuracy for time.
//!
//! A scene says how it is to be looked at; a profile says otherwise for some of that. Only what it names changes.

use super::model::needs_beams;
use super::{Coat, Effects, Scene, Shortcuts, Texture, reasons};
use crate::shape::{Method, Search};
use crate::texture::image::Filter;
use crate::texture::relief::BumpDerivative;
use serde::{Deserialize, Serialize};

/// Values for what trades accuracy for time; none where the scene itself decides.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// How hits are found.
    pub method: Option<Method>,
    /// How hits with superellipsoids are searched for.
    pub search: Option<Search>,
    /// Places in a pixel that rays are sent through, 1 or more; as many for every pixel.
    pub samples: Option<u32>,
    /// Points of the lens for each place in a pixel, 1 or more.
    pub lens_samples: Option<u32>,
    /// Wavelengths that a ray is split into where it first meets a dispersive surface, 1 or more.
    pub wavelengths: Option<u32>,
    /// Rays deeper than this are not spawned.
    pub depth: Option<u32>,
    /// Rays whose colour would count less than this in the pixel are not spawned, 0 to 1.
    pub contribution: Option<f64>,
    /// The most octaves of every sum of noise, 1 to 16.
    pub octaves: Option<u32>,
    /// How every image is filtered.
    pub filter: Option<Filter>,
    /// How normals of bumpy surfaces are worked out.
    pub bump: Option<BumpDerivative>,
    /// What rays are spared. No picture depends on it.
    pub shortcuts: Option<Shortcuts>,
}

impl Profile {
    /// The scene as it stands.
    pub const STANDARD: Self = Self {
        method: None,
        search: None,
        samples: None,
        lens_samples: None,
        wavelengths: None,
        depth: None,
        contribution: None,
        octaves: None,
        filter: None,
        bump: None,
        shortcuts: None,
    };

    /// For a first look: everything that costs time is left at its cheapest that still shows the scene.
    pub const DRAFT: Self = Self {
        method: Some(Method::Double),
        samples: Some(1),
        lens_samples: Some(1),
        wavelengths: Some(4),
        depth: Some(3),
        contribution: Some(0.02),
        octaves: Some(3),
        filter: Some(Filter::Nearest),
        ..Self::STANDARD
    };

    /// Nothing left out and nothing unsure: every hit with a certificate, every weak ray followed, every pixel's share of
    /// an image averaged exactly.
    pub const CERTIFIED: Self = Self {
        method: Some(Method::Adaptive),
        search: Some(Search::Certified),
        contribution: Some(0.0),
        filter: Some(Filter::Area),
        bump: Some(BumpDerivative::Exact),
        ..Self::STANDARD
    };

    /// The profiles that have a name.
    pub const NAMED: [(&str, Self); 3] =
        [("draft", Self::DRAFT), ("standard", Self::STANDARD), ("certified", Self::CERTIFIED)];

    /// What this profile says, and for the rest what the other one does.
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        Self {
            method: self.method.or(other.method),
            search: self.search.or(other.search),
            samples: self.samples.or(other.samples),
            lens_samples: self.lens_samples.or(other.lens_samples),
            wavelengths: self.wavelengths.or(other.wavelengths),
            depth: self.depth.or(other.depth),
            contribution: self.contribution.or(other.contribution),
            octaves: self.octaves.or(other.octaves),
            filter: self.filter.or(other.filter),
            bump: self.bump.or(other.bump),
            shortcuts: self.shortcuts.or(other.shortcuts),
        }
    }
}

impl Scene {
    /// The same scene, looked at as a profile says. What it then calls for is worked out anew; an effect that was switched
    /// off stays so.
    #[must_use]
    pub fn with_profile(&self, profile: &Profile) -> Self {
        let mut scene = self.clone();
        scene.origin = scene.origin.by_profile(profile);
        scene.solving.method = profile.method.unwrap_or(scene.solving.method);
        scene.solving.search = profile.search.unwrap_or(scene.solving.search);
        if let Some(samples) = profile.samples {
            scene.sampling.samples = samples;
            scene.sampling.adaptive = None;
        }
        scene.sampling.lens_samples = profile.lens_samples.unwrap_or(scene.sampling.lens_samples);
        scene.sampling.wavelengths = profile.wavelengths.unwrap_or(scene.sampling.wavelengths);
        scene.limits.depth = profile.depth.unwrap_or(scene.limits.depth);
        scene.limits.contribution = profile.contribution.unwrap_or(scene.limits.contribution);
        scene.shortcuts = profile.shortcuts.unwrap_or(scene.shortcuts);
        for coat in scene.materials.iter_mut().filter_map(|material| material.coat.as_deref_mut()) {
            coat.look_as(profile);
        }
        scene.needs_beams = needs_beams(scene.environment.as_ref(), &scene.materials);
        let switched_off = Effects::of(&reasons(self)).apart_from(self.effects);
        scene.effects = Effects::of(&reasons(&scene)).apart_from(switched_off);
        scene
    }
}

impl Coat {
    fn look_as(&mut self, profile: &Profile) {
        if let Some(most) = profile.octaves {
            self.turbulences_mut().for_each(|turbulence| turbulence.octaves = turbulence.octaves.min(most.max(1)));
        }
        if let (Some(filter), Some(Texture::Image { image, .. })) = (profile.filter, &mut self.texture) {
            image.filter = filter;
        }
        self.bump_derivative = profile.bump.unwrap_or(self.bump_derivative);
    }
}

#[cfg(test)]
mod tests {
    use super::super::{embedded_scene, load};
    use super::*;
    use crate::record::Effect;

    fn scene(name: &str) -> Scene {
        load(embedded_scene(name).unwrap().text, name).unwrap()
    }

    #[test]
    fn a_profile_that_says_nothing_changes_nothing() {
        for name in ["lens/focus", "textures/marble", "spectrum/prism"] {
            let scene = scene(name);
            assert_eq!(scene.with_profile(&Profile::STANDARD), scene, "{name}");
        }
    }

    #[test]
    fn one_sample_calls_for_no_antialiasing_and_an_effect_that_is_off_stays_off() {
        let scene = scene("sampling/antialiasing");
        let one = Profile { samples: Some(1), ..Profile::STANDARD };
        assert!(scene.effects.has(Effect::Antialiasing) && !scene.with_profile(&one).effects.has(Effect::Antialiasing));
        let dark = scene.with_effects(scene.effects.without(Effect::Shadows));
        assert!(!dark.with_profile(&one).effects.has(Effect::Shadows));
    }

    #[test]
    fn filters_that_ask_what_a_pixel_covers_make_rays_go_with_beams() {
        let scene = scene("textures/scanning");
        let looked_at = |filter| scene.with_profile(&Profile { filter: Some(filter), ..Profile::STANDARD });
        assert!(looked_at(Filter::Area).needs_beams && !looked_at(Filter::Nearest).needs_beams);
    }

    #[test]
    fn no_sum_of_noise_has_more_octaves_than_the_profile_says() {
        let scene = scene("textures/marble").with_profile(&Profile { octaves: Some(2), ..Profile::STANDARD });
        let mut coats: Vec<_> = scene.materials.into_iter().filter_map(|material| material.coat).collect();
        let octaves: Vec<u32> = coats.iter_mut().flat_map(|coat| coat.turbulences_mut().map(|t| t.octaves)).collect();
        assert!(!octaves.is_empty() && octaves.iter().all(|&octaves| octaves <= 2), "{octaves:?}");
    }
}
