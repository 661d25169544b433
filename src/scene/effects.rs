//! Which effects a scene calls for, and why: derived from what it holds, never declared.

use super::{Coat, Lens, LightKind, Material, Object, Scene, Split, Texture};
use crate::record::Effect;
use crate::sample::Aperture;
use serde::{Deserialize, Serialize};

/// An effect, and what calls for it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Reason {
    /// The effect.
    pub effect: Effect,
    /// Whether the scene calls for it.
    pub called_for: bool,
    /// What in the scene does; or what would have to be there.
    pub why: String,
}

/// The effects that a scene calls for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Effects(u32);

impl Effects {
    /// Whether the scene calls for the effect.
    #[inline]
    #[must_use]
    pub const fn has(self, effect: Effect) -> bool {
        self.0 & 1 << effect as u32 != 0
    }

    /// All effects.
    pub const ALL: Self = Self((1 << Effect::ALL.len()) - 1);

    /// What scenes of opaque surfaces in plain colours may call for.
    pub const OPAQUE: Self = Self::PLAIN
        .with(Effect::Antialiasing)
        .with(Effect::DepthOfField)
        .with(Effect::ApertureShape)
        .with(Effect::Reflection);

    /// What scenes of opaque, dull surfaces call for.
    pub const PLAIN: Self = Self(0).with(Effect::Shadows);

    /// Those that this build has. The one with the feature `bare` has the plain ones alone: it is there to measure what the others
    /// cost a scene that does not call for them.
    pub const BUILT: Self = if cfg!(feature = "bare") { Self::PLAIN } else { Self::ALL };

    /// What makes surfaces send rays on.
    pub const SENDING: Self = Self(0).with(Effect::Reflection).with(Effect::Refraction).with(Effect::Fresnel);

    /// What one ray a pixel shows as noise: these ask for several.
    pub const SAMPLED: Self = Self(0).with(Effect::DepthOfField).with(Effect::SoftShadows).with(Effect::Scattering);

    /// What materials carry besides plain colours.
    pub const COATS: Self =
        Self(0).with(Effect::ImageTextures).with(Effect::SolidTextures).with(Effect::Bumps).with(Effect::Frames);

    /// Whether the two sets have an effect in common.
    #[inline]
    #[must_use]
    pub const fn meets(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// Those that both sets have.
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// Whether all of the set are in the other one.
    #[inline]
    #[must_use]
    pub const fn are_within(self, other: Self) -> bool {
        self.apart_from(other).0 == 0
    }

    /// The same set without an effect.
    #[must_use]
    pub const fn without(self, effect: Effect) -> Self {
        Self(self.0 & !(1 << effect as u32))
    }

    /// The same set with an effect.
    #[must_use]
    pub const fn with(self, effect: Effect) -> Self {
        Self(self.0 | 1 << effect as u32)
    }

    /// Those of the set that are not in another one.
    #[must_use]
    pub const fn apart_from(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    /// Those of a list of reasons.
    #[must_use]
    pub fn of(reasons: &[Reason]) -> Self {
        let called = reasons.iter().filter(|reason| reason.called_for);
        Self(called.fold(0, |set, reason| set | 1 << reason.effect as u32))
    }
}

/// Every effect, with the reason for which the scene calls for it, or does not.
#[must_use]
pub fn reasons(scene: &Scene) -> Vec<Reason> {
    Effect::ALL.into_iter().map(|effect| reason(scene, effect)).collect()
}

fn reason(scene: &Scene, effect: Effect) -> Reason {
    let (what, named) = callers(scene, effect);
    let called_for = !named.is_empty();
    let why = if called_for { format!("{what}: {}", named.join(", ")) } else { format!("no {what}") };
    Reason { effect, called_for, why }
}

/// What calls for an effect: the kind of thing, and those of the kind that the scene has.
fn callers(scene: &Scene, effect: Effect) -> (&'static str, Vec<String>) {
    let using = |uses: &dyn Fn(&Material) -> bool| materials(scene, uses);
    let coated = |has: fn(&Coat) -> bool| using(&|material| material.coat.as_deref().is_some_and(has));
    let scatters = |material: &Material| {
        is_clear(material) && material.medium.is_some_and(|medium| medium.scattering != glam::DVec3::ZERO)
    };
    match effect {
        Effect::Antialiasing => ("samples beyond the first in each pixel", samples(scene)),
        Effect::DepthOfField => ("lens", scene.lens.as_deref().map(lens_in_words).into_iter().collect()),
        Effect::ApertureShape => ("lens with a shaped opening", shaped_aperture(scene)),
        Effect::Shadows => ("lights", lights(scene, |_| true)),
        Effect::SoftShadows => ("lights with a size", lights(scene, |kind| matches!(kind, LightKind::Area(_)))),
        Effect::Reflection => ("reflecting materials", using(&mirrors)),
        Effect::Refraction => ("transparent materials", using(&is_clear)),
        Effect::Fresnel => ("materials by Fresnel's equations", using(&|material| material.split != Split::Weights)),
        Effect::Dispersion => {
            ("dispersive materials", using(&|material| is_clear(material) && material.dispersion.is_some()))
        }
        Effect::Attenuation => {
            ("media that take light away", using(&|material| is_clear(material) && material.medium.is_some()))
        }
        Effect::Scattering => ("media that turn light", using(&scatters)),
        Effect::Details => ("objects with details", detailed(scene)),
        Effect::ImageTextures => {
            ("materials with pictures", coated(|coat| matches!(coat.texture, Some(Texture::Image { .. }))))
        }
        Effect::SolidTextures => {
            ("materials with solid textures", coated(|coat| matches!(coat.texture, Some(Texture::Solid(_)))))
        }
        Effect::Bumps => ("bumpy materials", coated(|coat| coat.bump.is_some())),
        Effect::Frames => ("materials with a grain", coated(|coat| coat.frame.is_some())),
        Effect::Environment => {
            let layout = scene.environment.as_ref().map(|environment| environment.map.layout().name().to_owned());
            ("environment", layout.into_iter().collect())
        }
    }
}

/// The materials that some object uses and for which `uses` holds, each with the objects that use it.
fn materials(scene: &Scene, uses: &dyn Fn(&Material) -> bool) -> Vec<String> {
    let used = scene.materials.iter().enumerate().filter(|(_, material)| uses(material));
    let named = used.filter_map(|(index, material)| {
        let has_it = |object: &&Object| object.material == index || object.surface_materials().any(|m| m == index);
        let mut names = scene.objects.iter().filter(has_it).map(|object| object.name.as_str());
        let first = names.next()?;
        let others = names.count();
        let more = if others > 0 { format!(" and {others} more") } else { String::new() };
        Some(format!("`{}` on `{first}`{more}", material.name))
    });
    named.collect()
}

fn is_clear(material: &Material) -> bool {
    material.transparency > 0.0
}

fn mirrors(material: &Material) -> bool {
    material.reflectivity > 0.0 || material.split != Split::Weights
}

fn lights(scene: &Scene, counts: impl Fn(&LightKind) -> bool) -> Vec<String> {
    scene.lights.iter().filter(|light| counts(&light.kind)).map(|light| format!("`{}`", light.name)).collect()
}

fn samples(scene: &Scene) -> Vec<String> {
    let sampling = scene.sampling;
    if !sampling.is_many() {
        return Vec::new();
    }
    let most = sampling.adaptive.map(|adaptive| format!(" to {}", adaptive.most)).unwrap_or_default();
    vec![format!("{}{most} in all, filter {}", sampling.samples, sampling.filter.name())]
}

fn lens_in_words(lens: &Lens) -> String {
    format!("radius {}, focus at {}", lens.radius, lens.focus)
}

fn shaped_aperture(scene: &Scene) -> Vec<String> {
    let shaped = scene.lens.as_deref().filter(|lens| lens.aperture != Aperture::Disc);
    shaped.map(|lens| lens.aperture.name().to_owned()).into_iter().collect()
}

fn detailed(scene: &Scene) -> Vec<String> {
    let has_details = |object: &&Object| object.coats.iter().flatten().any(|coat| !coat.details.is_empty());
    scene.objects.iter().filter(has_details).map(|object| format!("`{}`", object.name)).collect()
}
