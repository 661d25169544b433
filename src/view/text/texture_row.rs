//! Labels and key numbers of what a surface carries.

use super::format::{brief, brief_vector, count, degrees, percent};
use crate::math::portable;
use crate::record::{Bump, Detail, Environment, FrameMap, Lattice, Mapping, Octaves, Rings, Texels, Triple};

/// A word as scene files spell it, for reading.
pub(in crate::view) fn spoken(name: &str) -> String {
    name.replace('_', " ")
}

/// `(0.25, 0.5)`.
pub(in crate::view) fn place([x, y]: [f64; 2]) -> String {
    format!("({}, {})", brief(x), brief(y))
}

pub(super) fn detail_label(detail: &Detail) -> String {
    format!("detail on {}: {} lies over {}", detail.part, detail.material, detail.below)
}

pub(super) fn mapping_label(mapping: &Mapping) -> String {
    format!("(u, v) of {} to a place in the image", mapping.part)
}

pub(super) fn mapping_numbers(mapping: &Mapping) -> String {
    format!("{} → (s, t) = {}", place(mapping.uv), place(mapping.st))
}

pub(super) fn texels_label(texels: &Texels) -> String {
    if texels.texels.is_empty() {
        return format!("between two levels of the pyramid, filter {}", spoken(&texels.filter));
    }
    format!("{} of the image, filter {}", count(texels.texels.len() + texels.left_out, "texel"), spoken(&texels.filter))
}

pub(super) fn lattice_label(lattice: &Lattice) -> String {
    format!("{} noise in one cell of the lattice", spoken(&lattice.method))
}

pub(super) fn octaves_label(octaves: &Octaves) -> String {
    format!("turbulence: {}", count(octaves.rows.len(), "term"))
}

pub(super) fn rings_label(rings: &Rings) -> String {
    format!("ring {} of the log: {}", brief(rings.ring), if rings.dark { "dark" } else { "light" })
}

pub(super) fn rings_numbers(rings: &Rings) -> String {
    format!("⌊{}⌋ = {}", brief(rings.stirred), brief(rings.ring))
}

pub(super) fn bump_label(bump: &Bump) -> String {
    format!("bump, {}: the normal turns", spoken(&bump.bump))
}

pub(super) fn bump_numbers(bump: &Bump) -> String {
    format!("by {}, to {}", degrees(angle_between(bump.before, bump.after)), brief_vector(bump.after))
}

pub(super) fn frame_label(frame: &FrameMap) -> String {
    format!("frame along the grain, {}", spoken(&frame.frame))
}

pub(super) fn frame_numbers(frame: &FrameMap) -> String {
    format!("turned by {}, tilted by {}", degrees(frame.turn), place(frame.tilt))
}

pub(super) fn environment_label(environment: &Environment) -> String {
    let way = if environment.footprint.is_empty() { "the nearest texel" } else { "the average over the pixel" };
    format!("environment: {way}")
}

/// `0.01 sr, 0.0796 % of the sphere`.
pub(in crate::view) fn solid_angle(steradians: f64) -> String {
    format!("{} sr, {} of the sphere", brief(steradians), percent(steradians / (4.0 * std::f64::consts::PI)))
}

/// The angle between two unit vectors in degrees, exact for small ones too.
pub(in crate::view) fn angle_between(a: Triple, b: Triple) -> f64 {
    let [a, b] = [a, b].map(glam::DVec3::from_array);
    portable::atan2(a.cross(b).length(), a.dot(b)).to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_angle_between_a_normal_and_a_slope_of_one_is_45_degrees() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        assert!((angle_between([0.0, 0.0, 1.0], [half, 0.0, half]) - 45.0).abs() < 1e-12);
        assert_eq!(angle_between([0.0, 1.0, 0.0], [0.0, 1.0, 0.0]), 0.0);
    }

    #[test]
    fn a_whole_sphere_is_all_of_the_sphere() {
        assert_eq!(solid_angle(4.0 * std::f64::consts::PI), "12.57 sr, 100 % of the sphere");
    }
}
