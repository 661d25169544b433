//! From what a file says about glass, metal and fog to what the tracer asks.

use super::glass_file::{DispersionFile, FresnelFile, GlassFile, MediumFile, MetalFile};
use super::model::{Material, Split};
use super::problem::{Path, Problems};
use crate::optics::{Dispersion, LONGEST, Medium, Metal, SHORTEST};
use crate::record::format_number;
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

/// The index of refraction of a metal.
fn metal_of(metal: MetalFile) -> Split {
    let Metal { eta, k } = match metal {
        MetalFile::Silver => Metal::SILVER,
        MetalFile::Gold => Metal::GOLD,
        MetalFile::Copper => Metal::COPPER,
        MetalFile::Aluminium => Metal::ALUMINIUM,
    };
    Split::Conductor { eta, k }
}

/// The index of refraction by wavelength.
pub(super) fn dispersion(file: &DispersionFile) -> Dispersion {
    match file {
        DispersionFile::Glass { glass: GlassFile::Bk7 } => Dispersion::BK7,
        DispersionFile::Glass { glass: GlassFile::Sf11 } => Dispersion::SF11,
        DispersionFile::Glass { glass: GlassFile::Water } => Dispersion::WATER,
        DispersionFile::Glass { glass: GlassFile::Diamond } => Dispersion::DIAMOND,
        DispersionFile::Cauchy { coefficients } => Dispersion::Cauchy(*coefficients),
        DispersionFile::Sellmeier { b: [b1, b2, b3], c: [c1, c2, c3] } => {
            Dispersion::Sellmeier { b: [*b1, *b2, *b3, 0.0], c: [*c1, *c2, *c3, 0.0] }
        }
    }
}

/// What fills an object; none where that takes nothing away.
pub(super) fn medium(file: &MediumFile) -> Option<Medium> {
    let [absorption, scattering] = [file.absorption, file.scattering].map(|colour| DVec3::from_array(colour.0));
    let medium = Medium { absorption, scattering, anisotropy: file.anisotropy, multiple: file.multiple };
    (absorption + scattering != DVec3::ZERO).then_some(medium)
}

/// No light could have a smaller index: it bends by angles that lie between the last digits.
const LEAST_INDEX: f64 = 1e-3;

/// Metals of larger indices are not known, and their squares might not be numbers.
const LARGEST_INDEX: f64 = 1e6;

/// Notes what materials say about light that cannot be.
pub(super) fn check_materials(materials: &[Material], problems: &mut Problems) {
    let list = Path::Root.field("materials");
    for material in materials {
        let path = list.field(&material.name);
        check_split(material, path, problems);
        check_filling(material, path, problems);
        check_index(material, path, problems);
    }
}

/// What is mirrored is decided once, and metals let nothing through.
fn check_split(material: &Material, path: Path, problems: &mut Problems) {
    let name = &material.name;
    if material.split == Split::Weights {
        return;
    }
    if material.reflectivity != 0.0 {
        let found = format_number(material.reflectivity);
        problems
            .add(path.field("reflectivity"), format!("`{name}` has both `fresnel` and a `reflectivity` of {found}"))
            .help("Fresnel's equations decide how much is mirrored: leave `reflectivity` out, or `fresnel`");
    }
    let Split::Conductor { eta, k } = material.split else { return };
    if material.transparency != 0.0 {
        let found = format_number(material.transparency);
        problems
            .add(path.field("transparency"), format!("`{name}` is a metal with a `transparency` of {found}"))
            .help("light does not come through metals: leave `transparency` out, or take `dielectric`");
    }
    let is_usable = |channel: usize| {
        let (eta, k) = (eta[channel], k[channel]);
        eta + k > 0.0 && eta <= LARGEST_INDEX && k <= LARGEST_INDEX
    };
    if !(0..3).all(is_usable) {
        let message = "an index of refraction η + i k that no metal has".to_owned();
        problems.add(path.field("fresnel"), message).help(format!(
            "for each colour `eta` and `k` are at most {}, and not both 0",
            format_number(LARGEST_INDEX)
        ));
    }
}

/// What fills an object is of no use where no light comes in.
fn check_filling(material: &Material, path: Path, problems: &mut Problems) {
    let fillings = [("dispersion", material.dispersion.is_some()), ("medium", material.medium.is_some())];
    for (field, _) in fillings.into_iter().filter(|(_, is_there)| *is_there && material.transparency == 0.0) {
        problems
            .add(path.field(field), format!("`{}` has a `{field}`, and no light comes in to meet it", material.name))
            .help(format!("give it a `transparency` above 0, or leave `{field}` out"));
    }
}

/// An index follows for every wavelength that is seen.
fn check_index(material: &Material, path: Path, problems: &mut Problems) {
    let Some(dispersion) = &material.dispersion else { return };
    if let Some(nanometres) = dispersion.fails_at(LEAST_INDEX) {
        let index = format_number(dispersion.index(nanometres));
        problems
            .add(
                path.field("dispersion"),
                format!("the index of refraction of `{}` at {} nm is {index}", material.name, format_number(nanometres)),
            )
            .help(format!(
                "expected a number of at least {LEAST_INDEX} for every wavelength from {SHORTEST} to {LONGEST} nm; λ is in \
                 micrometres in the formula"
            ));
    }
}
