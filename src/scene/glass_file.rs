//! What glass, metal and fog do to light, as scene files say it.

use super::file::Colour;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Fresnel's equations in place of fixed weights for the mirrored ray and the one that goes through.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
#[schemars(deny_unknown_fields)]
pub enum FresnelFile {
    /// Glass, water, varnish: R is mirrored and 1 − R, times the transparency, goes through.
    Dielectric,
    /// A metal by its name.
    Metal {
        /// Which.
        metal: MetalFile,
    },
    /// A metal by its complex index η + i k for red, green and blue light.
    Conductor {
        /// η.
        eta: Colour,
        /// k.
        k: Colour,
    },
}

/// Metals whose indices are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MetalFile {
    /// Ag.
    Silver,
    /// Au.
    Gold,
    /// Cu.
    Copper,
    /// Al.
    Aluminium,
}

/// An index of refraction that depends on the wavelength; it takes the place of `index_of_refraction`.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
#[schemars(deny_unknown_fields)]
pub enum DispersionFile {
    /// A real glass by its name.
    Glass {
        /// Which.
        glass: GlassFile,
    },
    /// n = A + B / λ² + C / λ⁴, with λ in micrometres.
    Cauchy {
        /// A, B and C.
        coefficients: [f64; 3],
    },
    /// n² = 1 + Σ Bᵢ λ² / (λ² − Cᵢ), with λ in micrometres.
    Sellmeier {
        /// B₁, B₂, B₃.
        b: [f64; 3],
        /// C₁, C₂, C₃ in µm².
        c: [f64; 3],
    },
}

/// Glasses whose coefficients are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
pub enum GlassFile {
    /// Schott N-BK7, a crown glass.
    #[serde(rename = "BK7")]
    Bk7,
    /// Schott N-SF11, a dense flint glass.
    #[serde(rename = "SF11")]
    Sf11,
    /// Water at 20 °C.
    #[serde(rename = "water")]
    Water,
    /// Diamond.
    #[serde(rename = "diamond")]
    Diamond,
}

/// A medium that fills the object and takes light away: coloured glass, fog, milk.
#[derive(Clone, Copy, Debug, Default, Deserialize, Serialize, JsonSchema)]
#[serde(default)]
#[schemars(deny_unknown_fields)]
pub struct MediumFile {
    /// The share of red, green and blue light that is absorbed, per unit of length.
    pub absorption: Colour,
    /// The share that is turned into other directions, per unit of length.
    pub scattering: Colour,
    /// The mean cosine of the angle by which it is turned: −1 is all back, 0 is every way alike, 1 is all straight on.
    #[schemars(extend("exclusiveMinimum" = -1, "exclusiveMaximum" = 1))]
    pub anisotropy: f64,
    /// Whether light that was turned once may be turned again.
    pub multiple: bool,
}
