//! From what a file says about glass, metal and fog to what the tracer asks.

use super::glass_file::{DispersionFile, FresnelFile, GlassFile, MediumFile, MetalFile};
use super::model::Split;
use crate::optics::{Dispersion, Medium};
use glam::DVec3;

/// What decides how much is mirrored.
pub(super) fn split(file: Option<&FresnelFile>) -> Split {
    match file {
        None => Split::Weights,
        Some(FresnelFile::Dielectric) => Split::Dielectric,
        Some(FresnelFile::Metal { metal }) => metal_of(*metal),
        Some(FresnelFile::Conductor { eta, k }) => {
            Split::Conductor { eta: DVec3::from_array(eta.0), k: DVec3::from_array(k.0) }
        }
    }
}

/// The index of a metal for light of 650, 550 and 450 nm.
fn metal_of(metal: MetalFile) -> Split {
    let (eta, k) = match metal {
        MetalFile::Silver => ([0.14, 0.13, 0.14], [4.12, 3.34, 2.48]),
        MetalFile::Gold => ([0.16, 0.42, 1.51], [3.65, 2.47, 1.87]),
        MetalFile::Copper => ([0.21, 1.02, 1.18], [3.67, 2.58, 2.21]),
        MetalFile::Aluminium => ([1.49, 0.96, 0.62], [7.82, 6.70, 5.47]),
    };
    Split::Conductor { eta: DVec3::from_array(eta), k: DVec3::from_array(k) }
}

/// The index of refraction by wavelength.
pub(super) fn dispersion(file: &DispersionFile) -> Dispersion {
    match file {
        DispersionFile::Glass { glass } => match glass {
            GlassFile::Bk7 => Dispersion::Sellmeier {
                b: [1.039_612_12, 0.231_792_344, 1.010_469_45],
                c: [0.006_000_698_67, 0.020_017_914_4, 103.560_653],
            },
            GlassFile::Sf11 => Dispersion::Sellmeier {
                b: [1.737_596_95, 0.313_747_346, 1.898_781_01],
                c: [0.013_188_707, 0.062_306_814_2, 155.236_29],
            },
            GlassFile::Water => Dispersion::Cauchy([1.3199, 6.878e-3, -1.132e-3]),
            GlassFile::Diamond => Dispersion::Sellmeier { b: [0.3306, 4.3356, 0.0], c: [0.030_625, 0.011_236, 0.0] },
        },
        DispersionFile::Cauchy { coefficients } => Dispersion::Cauchy(*coefficients),
        DispersionFile::Sellmeier { b, c } => Dispersion::Sellmeier { b: *b, c: *c },
    }
}

/// What fills an object; none where that takes nothing away.
pub(super) fn medium(file: &MediumFile) -> Option<Medium> {
    let [absorption, scattering] = [file.absorption, file.scattering].map(|colour| DVec3::from_array(colour.0));
    let medium = Medium { absorption, scattering, anisotropy: file.anisotropy, multiple: file.multiple };
    (absorption + scattering != DVec3::ZERO).then_some(medium)
}
