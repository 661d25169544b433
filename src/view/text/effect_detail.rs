//! Everything that the events of cameras, wavelengths and media hold, and what they mean.

use super::detail::{DetailLine, pair};
use super::format::{degrees, percent, vector};
use super::texture_row::place;
use crate::record::{
    Average, Conductor, Confusion, Lens, LightSample, Overlap, Passage, Phase, Sample, Scatter, Segment, Wavelength,
    What, format_number,
};

/// The lines of an event of this kind.
pub(super) fn effect_lines(what: &What) -> Option<Vec<DetailLine>> {
    Some(match what {
        What::Sample(Sample { number, at, offset, weight }) => vec![
            pair("number", format_number(f64::from(*number) + 1.0)),
            pair("place in the picture", place(*at)),
            pair("from the pixel's centre", place(*offset)),
            pair("weight", format_number(*weight)),
        ],
        What::Average(average) => average_lines(average),
        What::Lens(lens) => lens_lines(lens),
        What::Confusion(Confusion { depth, diameter, pixels }) => vec![
            pair("distance along the view", format_number(*depth)),
            pair("diameter on the image plane at 1", format_number(*diameter)),
            pair("diameter in pixels", format_number(*pixels)),
        ],
        What::LightSample(sample) => light_sample_lines(sample),
        What::Wavelength(wavelength) => wavelength_lines(wavelength),
        What::Conductor(Conductor { eta, k, n1, theta, reflectance }) => vec![
            pair("η", vector(*eta)),
            pair("k", vector(*k)),
            pair("n₁", format_number(*n1)),
            pair("θ₁", degrees(*theta)),
            pair("R", vector(*reflectance)),
        ],
        What::Segment(segment) => segment_lines(segment),
        What::Scatter(scatter) => scatter_lines(scatter),
        What::Phase(Phase { towards, anisotropy, cosine, value, direction }) => vec![
            pair("towards", towards.clone()),
            pair("g", format_number(*anisotropy)),
            pair("cosθ", format_number(*cosine)),
            pair("p per steradian", format_number(*value)),
            pair("direction", vector(*direction)),
        ],
        What::Passage(Passage { medium, behind, passes, scattered, colour }) => vec![
            pair("medium", medium.clone()),
            pair("light from the far end", vector(*behind)),
            pair("share of it", vector(*passes)),
            pair("light turned on the way", vector(*scattered)),
            pair("colour", vector(*colour)),
        ],
        What::Overlap(Overlap { first, second, interval: [from, to] }) => vec![
            pair("first", first.clone()),
            pair("second", second.clone()),
            pair("in both", format!("t from {} to {}", format_number(*from), format_number(*to))),
        ],
        _ => return None,
    })
}

/// What an event of this kind means.
pub(super) fn explain_effect(what: &What) -> Option<&'static str> {
    Some(match what {
        What::Sample(_) => {
            "A pixel is an area, not a point. This is one of several places in it, each with a ray of its own."
        }
        What::Average(_) => {
            "The colours of all samples are averaged. The more they differ, the less sure their mean is: its standard \
             error says by how much."
        }
        What::Lens(_) => {
            "All rays of a thin lens that belong to one place in the picture meet in one point of the plane of focus. \
             What lies there is sharp; what lies before or behind it is seen from every point of the lens at another \
             place."
        }
        What::Confusion(_) => {
            "A point at this distance is spread over a disc in the picture: its diameter follows from the lens and from \
             how far the point is from the plane of focus."
        }
        What::LightSample(_) => {
            "A light that has a size is seen whole, in part or not at all from here. Each of its points is asked as if it \
             were a light of its own, and the answers are averaged."
        }
        What::Wavelength(_) => {
            "Glass bends blue light more than red, so from here on each wavelength goes its own way. The ray stands for a \
             band of wavelengths, and counts as much as white light has in that band."
        }
        What::Conductor(_) => {
            "A metal lets no light through. What it does not mirror it absorbs, and it mirrors each colour by another \
             share."
        }
        What::Segment(_) => {
            "A medium takes the same share of the light from every unit of length, so what is left falls exponentially."
        }
        What::Scatter(_) => {
            "Something in the medium has turned light towards the eye here. The distance is chosen by chance, as often as \
             light is turned there."
        }
        What::Phase(_) => "Not every angle is alike: the phase function says how much light is turned by this one.",
        What::Passage(_) => {
            "What is left of the light from the far end, and what the medium has turned towards the start of the ray on the \
             way."
        }
        What::Overlap(_) => {
            "Design policy 1: transparent objects may not fill the same space. These two do, so the scene should be mended."
        }
        _ => return None,
    })
}

fn average_lines(average: &Average) -> Vec<DetailLine> {
    let mut lines = vec![
        pair("samples", format_number(f64::from(average.samples))),
        pair("filter", average.filter.clone()),
        pair("sum of the weights", format_number(average.weights)),
    ];
    lines.extend(average.error.map(|error| pair("standard error", format_number(error))));
    lines.extend([pair("stopped because", average.stopped.clone()), pair("colour", vector(average.colour))]);
    lines
}

fn lens_lines(lens: &Lens) -> Vec<DetailLine> {
    vec![
        pair("aperture", lens.aperture.clone()),
        pair("radius", format_number(lens.radius)),
        pair("distance of the plane of focus", format_number(lens.focus_distance)),
        pair("place on the lens", place(lens.at)),
        pair("point of the lens", vector(lens.point)),
        pair("point of the plane of focus", vector(lens.focus)),
    ]
}

fn light_sample_lines(sample: &LightSample) -> Vec<DetailLine> {
    vec![
        pair("shape", sample.shape.clone()),
        pair("place in the unit square", place(sample.at)),
        pair("point", vector(sample.point)),
        pair("towards it", vector(sample.towards)),
        pair("distance", format_number(sample.distance)),
        pair("share that arrives", vector(sample.arriving)),
        pair("diffuse term", vector(sample.diffuse)),
        pair("specular term", vector(sample.specular)),
    ]
}

fn wavelength_lines(wavelength: &Wavelength) -> Vec<DetailLine> {
    let mut lines = vec![
        pair("λ in nm", format_number(wavelength.nanometres)),
        pair("width of its band in nm", format_number(wavelength.band)),
        pair("S, the share of white", vector(wavelength.share)),
        pair("n₁", format_number(wavelength.n1)),
        pair("n₂", format_number(wavelength.n2)),
    ];
    lines.push(pair("θ₁", degrees(wavelength.theta1)));
    lines.extend(wavelength.theta2.map(|theta2| pair("θ₂", degrees(theta2))));
    lines.extend(wavelength.direction.map(|direction| pair("direction", vector(direction))));
    lines.push(pair("Fresnel reflectance, unpolarised", percent(wavelength.reflectance)));
    lines
}

fn segment_lines(segment: &Segment) -> Vec<DetailLine> {
    let mut lines = vec![pair("medium", segment.medium.clone()), pair("from", vector(segment.from))];
    lines.extend(segment.to.map(|to| pair("to", vector(to))));
    lines.extend([
        pair("length", format_number(segment.length)),
        pair("σ_a, absorbed", vector(segment.absorption)),
        pair("σ_s, turned", vector(segment.scattering)),
        pair("transmittance", vector(segment.transmittance)),
    ]);
    lines
}

fn scatter_lines(scatter: &Scatter) -> Vec<DetailLine> {
    vec![
        pair("medium", scatter.medium.clone()),
        pair("time", format_number(f64::from(scatter.number))),
        pair("random number", format_number(scatter.chance)),
        pair("distance", format_number(scatter.distance)),
        pair("point", vector(scatter.point)),
        pair("density of the distance", format_number(scatter.density)),
        pair("weight", vector(scatter.weight)),
        pair("light sent back", vector(scatter.colour)),
    ]
}
