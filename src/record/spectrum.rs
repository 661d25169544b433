//! Light by wavelength, and metals, as plain data.

use super::Triple;
use schemars::JsonSchema;
use serde::Serialize;

/// A ray takes one wavelength out of many, where a dispersive surface bends each by another angle.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Wavelength {
    /// Its number among those that are sent from here, from 0.
    pub number: u32,
    /// How many are sent.
    pub of: u32,
    /// λ in nanometres.
    pub nanometres: f64,
    /// The width of the band of wavelengths about it that it stands for, in nanometres.
    pub band: f64,
    /// The share of white light in that band, linear sRGB. A channel may be negative: most pure colours lie outside sRGB.
    pub share: Triple,
    /// The index of refraction on the incoming side at λ.
    pub n1: f64,
    /// The index of refraction on the far side at λ.
    pub n2: f64,
    /// The angle of incidence in degrees.
    pub theta1: f64,
    /// The angle of refraction in degrees; none for total internal reflection.
    pub theta2: Option<f64>,
    /// The refracted unit direction; none for total internal reflection.
    pub direction: Option<Triple>,
    /// Unpolarised Fresnel reflectance at λ.
    pub reflectance: f64,
}

/// The reflectance of a metal by Fresnel's equations with a complex index η + i k.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Conductor {
    /// η, for red, green and blue light.
    pub eta: Triple,
    /// k, likewise.
    pub k: Triple,
    /// The index of refraction of the medium outside.
    pub n1: f64,
    /// The angle of incidence in degrees.
    pub theta: f64,
    /// The reflectance of unpolarised light.
    pub reflectance: Triple,
}
