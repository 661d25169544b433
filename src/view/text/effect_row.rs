//! Labels and key numbers of what cameras, wavelengths and media add to a ray.

use super::format::{brief, brief_vector, count, degrees};
use crate::record::{Average, Confusion, Lens, LightSample, Overlap, Phase, Scatter, Segment, Wavelength};

pub(super) fn average_label(average: &Average) -> String {
    format!("the mean of {}", count(average.samples as usize, "sample"))
}

pub(super) fn lens_label(lens: &Lens) -> String {
    let aperture = match lens.aperture.as_str() {
        "disc" => "round",
        "polygon" => "polygonal",
        _ => "shaped",
    };
    format!("through a point of the {aperture} lens")
}

pub(super) fn confusion_numbers(confusion: &Confusion) -> String {
    format!("{} across, {}", brief(confusion.diameter), pixels(confusion.pixels))
}

fn pixels(size: f64) -> String {
    format!("{} {}", brief(size), if size == 1.0 { "pixel" } else { "pixels" })
}

pub(super) fn light_sample_label(sample: &LightSample) -> String {
    format!("point {} of {} of the {}", sample.number + 1, sample.of, sample.shape)
}

pub(super) fn wavelength_label(wavelength: &Wavelength) -> String {
    format!("wavelength {} of {}", wavelength.number + 1, wavelength.of)
}

pub(super) fn wavelength_numbers(wavelength: &Wavelength) -> String {
    let Wavelength { nanometres, n1, n2, theta2, .. } = wavelength;
    let bent = theta2.map_or("no θ₂".to_owned(), |angle| format!("θ₂ = {}", degrees(angle)));
    format!("λ = {} nm, n {} → {}, {bent}", brief(*nanometres), brief(*n1), brief(*n2))
}

pub(super) fn segment_numbers(segment: &Segment) -> String {
    let length = if segment.length.is_finite() { brief(segment.length) } else { "∞".to_owned() };
    format!("length {length}, {} is left", brief_vector(segment.transmittance))
}

pub(super) fn scatter_label(scatter: &Scatter) -> String {
    format!("scattered in {}, time {}", scatter.medium, scatter.number)
}

pub(super) fn phase_label(phase: &Phase) -> String {
    if phase.towards == "on" {
        return "phase function: the way that the path goes on".to_owned();
    }
    format!("phase function: from light {}", phase.towards)
}

pub(super) fn overlap_numbers(overlap: &Overlap) -> String {
    let [from, to] = overlap.interval.map(brief);
    format!("t from {from} to {to}")
}
