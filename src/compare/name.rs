//! What an event is called when two trees are laid side by side: its kind, and what it is about.

use crate::record::What;

/// The kind of an event and what it is about. Events of one name belong together, whatever their numbers are.
pub type Name = (&'static str, String);

/// The name of an event.
pub fn name(what: &What) -> Name {
    let (kind, about) = story(what)
        .or_else(|| search(what))
        .or_else(|| surface(what))
        .unwrap_or_else(|| (light(what), light_about(what)));
    (kind, about)
}

fn story(what: &What) -> Option<Name> {
    Some(match what {
        // The story of a pixel and that of a ray tell the same, after their first step.
        What::Pixel { .. } | What::LooseRay { .. } => ("root", String::new()),
        What::Sample(sample) => ("sample", sample.number.to_string()),
        What::Average(_) => ("average", String::new()),
        What::Step { number, .. } => ("step", number.to_string()),
        What::Lens(_) => ("lens", String::new()),
        What::Ray { ray, wavelength, .. } => {
            let band = wavelength.map(|nanometres| format!("{nanometres}")).unwrap_or_default();
            ("ray", format!("{} {band}", ray.name()))
        }
        What::Limit { limit, .. } => ("limit", limit.clone()),
        What::Written { .. } => ("written", String::new()),
        _ => return None,
    })
}

fn search(what: &What) -> Option<Name> {
    Some(match what {
        What::Object { name, .. } => ("object", name.clone()),
        What::Extent { of, .. } => ("extent", of.clone()),
        What::Ball { of, .. } => ("ball", of.clone()),
        What::Projection { of, .. } => ("projection", of.clone()),
        What::Transform { of, .. } => ("transform", of.clone()),
        What::Primitive { name, leaf, .. } => ("primitive", format!("{leaf} {name}")),
        What::Planes { .. } => ("planes", String::new()),
        What::Quadratic { about, .. } => ("quadratic", about.clone()),
        What::Quartic { .. } => ("quartic", String::new()),
        What::Search { .. } => ("search", String::new()),
        What::Decision { question, .. } => ("decision", question.clone()),
        What::Implicit { .. } => ("implicit", String::new()),
        What::Roots { .. } => ("roots", String::new()),
        What::Combine { name, operator, .. } => ("combine", format!("{} {name}", operator.name())),
        What::Moved { object, .. } => ("moved", object.clone()),
        What::Rejected { object, leaf, part, .. } => ("rejected", format!("{object} {leaf} {part}")),
        What::Hit { .. } => ("hit", String::new()),
        What::Nothing { .. } => ("nothing", String::new()),
        What::Confusion(_) => ("confusion", String::new()),
        _ => return None,
    })
}

fn surface(what: &What) -> Option<Name> {
    Some(match what {
        What::Detail(detail) => ("detail", detail.material.clone()),
        What::Texture(texture) => ("texture", texture.texture.clone()),
        What::Mapping(_) => ("mapping", String::new()),
        What::Texels(texels) => ("texels", texels.filter.clone()),
        What::Lattice(lattice) => ("lattice", lattice.method.clone()),
        What::Octaves(_) => ("octaves", String::new()),
        What::Undulate(_) => ("undulate", String::new()),
        What::Rings(_) => ("rings", String::new()),
        What::Bump(_) => ("bump", String::new()),
        What::FrameMap(_) => ("frame map", String::new()),
        What::Environment(_) => ("environment", String::new()),
        What::Segment(segment) => ("segment", segment.medium.clone()),
        What::Scatter(scatter) => ("scatter", scatter.medium.clone()),
        What::Phase(phase) => ("phase", phase.towards.clone()),
        What::Passage(passage) => ("passage", passage.medium.clone()),
        _ => return None,
    })
}

fn light(what: &What) -> &'static str {
    match what {
        What::Ambient { .. } => "ambient",
        What::Light { .. } => "light",
        What::LightSample(_) => "light sample",
        What::Shadow { .. } => "shadow",
        What::Reflection { .. } => "reflection",
        What::Snell { .. } => "snell",
        What::Wavelength(_) => "wavelength",
        What::Conductor(_) => "conductor",
        What::Overlap(_) => "overlap",
        What::Medium { .. } => "medium",
        What::Colour { .. } => "colour",
        _ => "event",
    }
}

fn light_about(what: &What) -> String {
    match what {
        What::Light { name, .. } => name.clone(),
        What::LightSample(sample) => sample.number.to_string(),
        What::Shadow { object, .. } | What::Medium { object, .. } => object.clone(),
        What::Overlap(overlap) => format!("{} {}", overlap.first, overlap.second),
        What::Wavelength(wavelength) => wavelength.number.to_string(),
        _ => String::new(),
    }
}
