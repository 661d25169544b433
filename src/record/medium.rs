//! Light on its way through a medium, as plain data. Coefficients are per unit of length in the world, by colour.

use super::Triple;
use schemars::JsonSchema;
use serde::Serialize;

/// A stretch of a ray inside a medium that takes light away.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Segment {
    /// The object that the medium fills.
    pub medium: String,
    /// Where it begins, in world space.
    pub from: Triple,
    /// Where it ends; none where the medium is not left.
    pub to: Option<Triple>,
    /// Its length; infinite lengths are `null`.
    pub length: f64,
    /// σ_a: what is absorbed.
    pub absorption: Triple,
    /// σ_s: what is turned into other directions.
    pub scattering: Triple,
    /// exp(−(σ_a + σ_s) length): what is left.
    pub transmittance: Triple,
}

/// A point at which light is turned.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Scatter {
    /// The object that the medium fills.
    pub medium: String,
    /// How often the path has been turned, this time included.
    pub number: u32,
    /// How far the point is along the ray, in the world's units.
    pub distance: f64,
    /// The point in world space.
    pub point: Triple,
    /// The random number in [0, 1) that chose the colour and the distance.
    pub chance: f64,
    /// The probability density of that distance, per unit of length: the mean over the colours.
    pub density: f64,
    /// What the light from this point counts: σ_s exp(−σ_t distance) / density.
    pub weight: Triple,
    /// The light that the point sends back along the ray.
    pub colour: Triple,
}

/// The phase function: how much light is turned by which angle.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Phase {
    /// What the light is turned towards: a light's name, or `on` for the path itself.
    pub towards: String,
    /// g: −1 is all back, 0 is every way alike, 1 is all straight on.
    pub anisotropy: f64,
    /// The cosine of the angle between the way that light comes and the way that it goes.
    pub cosine: f64,
    /// p, per steradian.
    pub value: f64,
    /// The unit direction from the point, towards the light or along the path.
    pub direction: Triple,
}

/// What comes out of a stretch of a medium towards the start of the ray.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Passage {
    /// The object that the medium fills.
    pub medium: String,
    /// The light from the far end.
    pub behind: Triple,
    /// The share of it that is left; of a path that goes on by chance, what it counts.
    pub passes: Triple,
    /// The light that was turned towards the start on the way.
    pub scattered: Triple,
    /// All of it.
    pub colour: Triple,
}

/// Two transparent objects fill the same space, which design policy 1 forbids.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Overlap {
    /// The object that the ray was in first.
    pub first: String,
    /// The object that it has come into.
    pub second: String,
    /// The hit times between which it is in both, on the ray that found it.
    pub interval: [f64; 2],
}
