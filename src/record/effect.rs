//! What a scene may or may not call for.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Something that costs time and that many a scene can do without. One that a scene does not call for runs no code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Effect {
    /// Several samples of a pixel, weighted by a reconstruction filter.
    Antialiasing,
    /// A thin lens in place of a pinhole.
    DepthOfField,
    /// An aperture that is not a disc.
    ApertureShape,
    /// Shadow rays towards lights.
    Shadows,
    /// Shadow rays towards points of lights that have a size.
    SoftShadows,
    /// Mirrored rays.
    Reflection,
    /// Rays through surfaces.
    Refraction,
    /// Shares of mirrored and transmitted light by Fresnel's equations.
    Fresnel,
    /// An index of refraction for each wavelength.
    Dispersion,
    /// Light that fades on its way through a medium.
    Attenuation,
    /// Light that is turned on its way through a medium.
    Scattering,
    /// Polygons on faces.
    Details,
    /// Pictures on surfaces.
    ImageTextures,
    /// Textures that fill space.
    SolidTextures,
    /// Normals that are turned.
    Bumps,
    /// Frames that are turned.
    Frames,
    /// A picture of the surroundings.
    Environment,
}

impl Effect {
    /// All of them, in the order in which they are listed everywhere.
    pub const ALL: [Self; 17] = [
        Self::Antialiasing,
        Self::DepthOfField,
        Self::ApertureShape,
        Self::Shadows,
        Self::SoftShadows,
        Self::Reflection,
        Self::Refraction,
        Self::Fresnel,
        Self::Dispersion,
        Self::Attenuation,
        Self::Scattering,
        Self::Details,
        Self::ImageTextures,
        Self::SolidTextures,
        Self::Bumps,
        Self::Frames,
        Self::Environment,
    ];

    /// The words for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Antialiasing => "antialiasing",
            Self::DepthOfField => "depth of field",
            Self::ApertureShape => "aperture shape",
            Self::Shadows => "shadows",
            Self::SoftShadows => "soft shadows",
            Self::Reflection => "reflection",
            Self::Refraction => "refraction",
            Self::Fresnel => "Fresnel",
            Self::Dispersion => "dispersion",
            Self::Attenuation => "attenuation",
            Self::Scattering => "scattering",
            Self::Details => "details",
            Self::ImageTextures => "image textures",
            Self::SolidTextures => "solid textures",
            Self::Bumps => "bumps",
            Self::Frames => "frames",
            Self::Environment => "environment",
        }
    }
}
