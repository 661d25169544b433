//! The knobs, with the values that are tried of each.

use crate::record::Effect;
use crate::scene::{Profile, Scene, Shortcuts};
use crate::shape::{Method, Search, Shape};
use crate::texture::image::Filter;
use crate::texture::relief::BumpDerivative;
use serde::{Deserialize, Serialize};

/// What trades accuracy for time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Knob {
    /// The numbers that hits are computed with.
    Arithmetic,
    /// What finds the roots, in double precision.
    Roots,
    /// How hits with superellipsoids are searched for.
    Search,
    /// Rays through a pixel.
    Samples,
    /// Points on the lens for each ray through a pixel.
    LensSamples,
    /// Wavelengths that light is taken apart into.
    Wavelengths,
    /// How deep the tree of rays may be.
    Depth,
    /// How little a ray may count.
    Contribution,
    /// The octaves of noise.
    Octaves,
    /// How images are filtered.
    Filter,
    /// The terms that are dropped from bumpy normals.
    Bump,
    /// Extents, hierarchy and what else spares rays their tests: the control, for no picture depends on it.
    Shortcuts,
}

/// One value of one knob, all else being as the scene says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Setting {
    /// The knob.
    pub knob: Knob,
    /// Its value, as it is shown.
    pub value: String,
    /// The same as a profile.
    pub profile: Profile,
}

/// Stretches of a search by equal steps, each twice as fine.
const STRETCHES: [u32; 4] = [16, 32, 64, 128];
/// Powers of four: each has half the noise of the one before.
const SAMPLES: [u32; 4] = [1, 4, 16, 64];
const WAVELENGTHS: [u32; 5] = [1, 4, 8, 16, 32];
const DEPTHS: [u32; 6] = [0, 1, 2, 4, 8, 16];
const CONTRIBUTIONS: [f64; 4] = [0.0, 0.001, 0.01, 0.1];
const OCTAVES: [u32; 5] = [1, 2, 4, 6, 8];
const FILTERS: [Filter; 5] = [Filter::Nearest, Filter::Bilinear, Filter::Trilinear, Filter::Ewa, Filter::Area];

impl Knob {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 12] = [
        Self::Arithmetic,
        Self::Roots,
        Self::Search,
        Self::Samples,
        Self::LensSamples,
        Self::Wavelengths,
        Self::Depth,
        Self::Contribution,
        Self::Octaves,
        Self::Filter,
        Self::Bump,
        Self::Shortcuts,
    ];

    /// Its name, as it is shown and as the command line takes it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Arithmetic => "arithmetic",
            Self::Roots => "roots",
            Self::Search => "search",
            Self::Samples => "samples",
            Self::LensSamples => "lens_samples",
            Self::Wavelengths => "wavelengths",
            Self::Depth => "depth",
            Self::Contribution => "contribution",
            Self::Octaves => "octaves",
            Self::Filter => "filter",
            Self::Bump => "bump",
            Self::Shortcuts => "shortcuts",
        }
    }

    /// Whether no picture depends on it, so that its error is zero, exactly.
    #[must_use]
    pub const fn is_control(self) -> bool {
        matches!(self, Self::Shortcuts)
    }

    /// Whether more of it makes the picture surer by chance: its error is that of sampling.
    #[must_use]
    pub const fn is_sampled(self) -> bool {
        matches!(self, Self::Samples | Self::LensSamples)
    }

    /// Whether anything in the scene depends on it.
    #[must_use]
    pub fn matters_to(self, scene: &Scene) -> bool {
        let called = |effect| scene.effects.has(effect);
        let sends = [Effect::Reflection, Effect::Refraction, Effect::Fresnel].into_iter().any(called);
        match self {
            Self::Arithmetic | Self::Roots | Self::Shortcuts => true,
            Self::Search => has_superellipsoid(scene),
            Self::Samples => called(Effect::Antialiasing) || scene.effects.meets(crate::scene::Effects::SAMPLED),
            Self::LensSamples => called(Effect::DepthOfField),
            Self::Wavelengths => called(Effect::Dispersion),
            Self::Depth | Self::Contribution => sends,
            Self::Octaves => has_octaves(scene),
            Self::Filter => called(Effect::ImageTextures),
            Self::Bump => called(Effect::Bumps),
        }
    }

    /// The values that are tried, from the cheapest to the dearest by expectation.
    #[must_use]
    pub fn settings(self) -> Vec<Setting> {
        let setting = |value: String, profile| Setting { knob: self, value, profile };
        let plain = Profile::STANDARD;
        match self {
            Self::Arithmetic => [Method::Single, Method::Double, Method::Adaptive, Method::DoubleDouble]
                .map(|method| setting(method.name().to_owned(), Profile { method: Some(method), ..plain }))
                .to_vec(),
            Self::Roots => {
                [("textbook", Method::Textbook), ("recentred", Method::Double), ("certified", Method::Adaptive)]
                    .map(|(name, method)| setting(name.to_owned(), Profile { method: Some(method), ..plain }))
                    .to_vec()
            }
            Self::Search => STRETCHES
                .map(|n| (n.to_string(), Search::Stretches(n)))
                .into_iter()
                .chain([("certified".to_owned(), Search::Certified)])
                .map(|(name, search)| setting(name, Profile { search: Some(search), ..plain }))
                .collect(),
            Self::Samples => SAMPLES.map(|n| setting(n.to_string(), Profile { samples: Some(n), ..plain })).to_vec(),
            Self::LensSamples => {
                SAMPLES.map(|n| setting(n.to_string(), Profile { lens_samples: Some(n), ..plain })).to_vec()
            }
            Self::Wavelengths => {
                WAVELENGTHS.map(|n| setting(n.to_string(), Profile { wavelengths: Some(n), ..plain })).to_vec()
            }
            Self::Depth => DEPTHS.map(|n| setting(n.to_string(), Profile { depth: Some(n), ..plain })).to_vec(),
            Self::Contribution => CONTRIBUTIONS
                .map(|least| setting(least.to_string(), Profile { contribution: Some(least), ..plain }))
                .to_vec(),
            Self::Octaves => OCTAVES.map(|n| setting(n.to_string(), Profile { octaves: Some(n), ..plain })).to_vec(),
            Self::Filter => FILTERS
                .map(|filter| setting(filter.name().to_owned(), Profile { filter: Some(filter), ..plain }))
                .to_vec(),
            Self::Bump => [("dropped", BumpDerivative::Dropped), ("exact", BumpDerivative::Exact)]
                .map(|(name, bump)| setting(name.to_owned(), Profile { bump: Some(bump), ..plain }))
                .to_vec(),
            Self::Shortcuts => [("none", Shortcuts::NONE), ("all", Shortcuts::ALL)]
                .map(|(name, shortcuts)| setting(name.to_owned(), Profile { shortcuts: Some(shortcuts), ..plain }))
                .to_vec(),
        }
    }
}

/// Whether any noise has more octaves than one.
fn has_octaves(scene: &Scene) -> bool {
    let one = Profile { octaves: Some(1), ..Profile::STANDARD };
    let coats =
        [Effect::SolidTextures, Effect::Bumps, Effect::Frames].into_iter().any(|effect| scene.effects.has(effect));
    coats && scene.with_profile(&one).materials != scene.materials
}

fn has_superellipsoid(scene: &Scene) -> bool {
    let leaves = scene.objects.iter().flat_map(|object| &object.solid.leaves);
    leaves.into_iter().any(|leaf| matches!(leaf.shape, Shape::Superellipsoid(_)))
}
