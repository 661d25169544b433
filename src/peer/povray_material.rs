//! A material as a POV-Ray texture.
//!
//! POV-Ray colours a hit with pigment (1 − transmit) (ambient + diffuse max(0, n·l)) + phong max(0, r·l)^phong_size, where
//! ambient is a colour, and diffuse and phong are numbers. So the pigment takes the diffuse colour, and ambient is what
//! the ambient colour is to it.

use super::povray::vector;
use crate::scene::{Material, Rgb, Split};

/// The texture.
///
/// # Errors
/// Says what in the material a texture cannot say.
pub(super) fn texture(material: &Material) -> Result<String, String> {
    let at_fault = |message: &str| format!("material `{}`: {message}", material.name);
    if material.coat.is_some() {
        return Err(at_fault("it carries a texture, a bump or a grain, and these have no equal in POV-Ray's language"));
    }
    if material.split != Split::Weights || material.dispersion.is_some() || material.medium.is_some() {
        let what = "it has weights by Fresnel's equations, dispersion or a medium";
        return Err(at_fault(&format!("{what}, and these are not written in POV-Ray's language")));
    }
    let (opaque, highlight) = (1.0 - material.transparency, material.specular.x);
    if material.specular != Rgb::splat(highlight) {
        return Err(at_fault("its highlights are coloured, and POV-Ray's have the colour of the light"));
    }
    if opaque == 0.0 && material.ambient + material.diffuse != Rgb::ZERO {
        return Err(at_fault("its transparency is 1, and POV-Ray gives a surface that passes all light no colour"));
    }
    let only_ambient = |channel: usize| material.diffuse[channel] == 0.0 && material.ambient[channel] > 0.0;
    if (0..3).any(only_ambient) {
        return Err(at_fault(
            "a channel has an ambient part and no diffuse part, and POV-Ray's pigment stands for both",
        ));
    }
    let share = |part: Rgb, of: Rgb| {
        Rgb::from_array(std::array::from_fn(|k| if part[k] == 0.0 { 0.0 } else { part[k] / of[k] }))
    };
    let pigment = share(material.diffuse, Rgb::splat(opaque));
    let ambient = share(material.ambient, material.diffuse);
    let reflection =
        if material.reflectivity > 0.0 { format!(" reflection {:?}", material.reflectivity) } else { String::new() };
    Ok(format!(
        "texture {{ pigment {{ rgbt <{:?}, {:?}, {:?}, {:?}> }} finish {{ ambient rgb {} diffuse 1 phong {highlight:?} phong_size {:?}{reflection} }} }}",
        pigment.x,
        pigment.y,
        pigment.z,
        material.transparency,
        vector(ambient),
        material.exponent
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn material() -> Material {
        Material {
            name: "m".to_owned(),
            ambient: Rgb::splat(0.25),
            diffuse: Rgb::splat(0.5),
            specular: Rgb::splat(0.75),
            exponent: 40.0,
            reflectivity: 0.0,
            transparency: 0.5,
            index_of_refraction: 1.5,
            split: Split::Weights,
            dispersion: None,
            medium: None,
            coat: None,
        }
    }

    #[test]
    fn a_pigment_makes_up_for_what_passes_through_it() {
        let expected = "texture { pigment { rgbt <1.0, 1.0, 1.0, 0.5> } finish { ambient rgb <0.5, 0.5, 0.5> diffuse 1 phong 0.75 phong_size 40.0 } }";
        assert_eq!(texture(&material()).unwrap(), expected);
    }

    #[test]
    fn what_a_texture_cannot_say_is_refused_by_name() {
        let refused = |material: Material| texture(&material).unwrap_err();
        let coloured = refused(Material { specular: Rgb::new(1.0, 0.5, 0.5), ..material() });
        assert!(coloured.starts_with("material `m`: its highlights are coloured"), "{coloured}");
        assert!(refused(Material { transparency: 1.0, ..material() }).contains("transparency is 1"));
        assert!(refused(Material { diffuse: Rgb::X, ..material() }).contains("no diffuse part"));
    }

    #[test]
    fn clear_water_without_a_colour_of_its_own_can_be_said() {
        let clear = Material { transparency: 1.0, ambient: Rgb::ZERO, diffuse: Rgb::ZERO, ..material() };
        assert!(texture(&clear).unwrap().contains("rgbt <0.0, 0.0, 0.0, 1.0>"));
    }
}
