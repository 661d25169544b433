//! Words that hold of an event or do not.

use super::context::View;
use super::term::{Term, Test};
use crate::record::{CandidateFate, Certificate, Operator, RayKind, Sense, What};

const fn word(name: &'static str, meaning: &'static str, test: fn(&View) -> bool) -> Term {
    Term { name, meaning, example: name, test: Test::Word(test) }
}

/// Terms that have a question in parentheses.
pub(super) const GROUPS: [Term; 1] = [Term {
    name: "has",
    meaning: "the event itself, or one below it, is one of which the question in parentheses holds",
    example: "pixel & !has(shadowed)",
    test: Test::Group,
}];

/// All words.
pub(super) static WORDS: [Term; 80] = [
    word("pixel", "the whole story of a pixel", |v| matches!(v.what(), What::Pixel { .. })),
    word("sample", "one of several samples of a pixel", |v| matches!(v.what(), What::Sample(_))),
    word("ray", "a ray of any kind", |v| matches!(v.what(), What::Ray { .. } | What::LooseRay { .. })),
    word("camera", "a ray from the eye", |v| is_ray(v, RayKind::Camera)),
    word("reflected", "a ray mirrored at a surface", |v| is_ray(v, RayKind::Reflected)),
    word("refracted", "a ray through a surface", |v| is_ray(v, RayKind::Refracted)),
    word("shadow", "a ray towards a light", |v| is_ray(v, RayKind::Shadow)),
    word("scattered", "a ray turned in a medium", |v| is_ray(v, RayKind::Scattered)),
    word("hit", "the closest hit of a ray", |v| matches!(v.what(), What::Hit { .. })),
    word("hit.enter", "a hit where the ray goes into the object", |v| is_hit(v, Sense::Enter)),
    word("hit.leave", "a hit from inside the object", |v| is_hit(v, Sense::Leave)),
    word("hit.touch", "a hit with a surface that bounds nothing", |v| is_hit(v, Sense::Touch)),
    word("nothing", "a ray that hits nothing and sees the background", |v| matches!(v.what(), What::Nothing { .. })),
    word("rejected", "a hit that is not the one that is seen", |v| matches!(v.what(), What::Rejected { .. })),
    word("moved", "a start that rounding had put on the wrong side", |v| matches!(v.what(), What::Moved { .. })),
    word("undecidable", "the ray's own numbers do not say which it is", |v| is_known(v, Certificate::Undecidable)),
    word("fallback", "a decision that needed finer arithmetic", |v| is_known(v, Certificate::Fallback)),
    word("candidate.accepted", "hit times of a primitive, one of which counts", |v| {
        has_candidate(v, CandidateFate::Accepted)
    }),
    word("candidate.rejected", "hit times of a primitive, one of which does not count", |v| {
        has_candidate(v, CandidateFate::Rejected)
    }),
    word("object", "the search for hits with one object", |v| matches!(v.what(), What::Object { .. })),
    word("primitive", "the search for hits with one primitive", |v| matches!(v.what(), What::Primitive { .. })),
    word("transform", "the ray in generic coordinates", |v| matches!(v.what(), What::Transform { .. })),
    word("planes", "the plane table", |v| matches!(v.what(), What::Planes { .. })),
    word("planes.stopped", "a plane table that was left before its last row", |v| {
        matches!(v.what(), What::Planes { stopped: Some(_), .. })
    }),
    word("quadratic", "a quadratic equation", |v| matches!(v.what(), What::Quadratic { .. })),
    word("quartic", "a quartic equation", |v| matches!(v.what(), What::Quartic { .. })),
    word("search", "a search for the zeros of d(t)", |v| matches!(v.what(), What::Search { .. })),
    word("extent", "a test of a box, a ball or a rectangle", |v| meets_extent(v).is_some()),
    word("extent.met", "such a test that the ray passes", |v| meets_extent(v) == Some(true)),
    word("extent.missed", "such a test that spares the work behind it", |v| meets_extent(v) == Some(false)),
    word("csg", "a node of a Boolean tree", |v| matches!(v.what(), What::Combine { .. })),
    word("csg.union", "a union", |v| combines(v, Operator::Union)),
    word("csg.intersection", "an intersection", |v| combines(v, Operator::Intersection)),
    word("csg.difference", "a difference", |v| combines(v, Operator::Difference)),
    word("csg.early_out", "a node that did not need both of its operands", |v| {
        matches!(v.what(), What::Combine { early_out: Some(_), .. })
    }),
    word(
        "csg.empty",
        "a node of which nothing is left",
        |v| matches!(v.what(), What::Combine { combined, .. } if combined.is_empty()),
    ),
    word("csg.rejected", "a boundary of an operand that the node takes away", |v| {
        v.object().is_some() && matches!(v.what(), What::Rejected { .. })
    }),
    word("light", "the terms of one light", |v| matches!(v.what(), What::Light { .. })),
    word(
        "shadowed",
        "an opaque object stands before a light",
        |v| matches!(v.what(), What::Shadow { passes, .. } if *passes == 0.0),
    ),
    word(
        "dimmed",
        "a transparent object stands before a light",
        |v| matches!(v.what(), What::Shadow { passes, .. } if *passes > 0.0),
    ),
    word("snell", "Snell's law at a surface", |v| matches!(v.what(), What::Snell { .. } | What::Wavelength(_))),
    word("tir", "total internal reflection", |v| match v.what() {
        What::Snell { total_internal_reflection, .. } => *total_internal_reflection,
        What::Wavelength(wavelength) => wavelength.theta2.is_none(),
        _ => false,
    }),
    word("wavelength", "a ray that is split by wavelength", |v| matches!(v.what(), What::Wavelength(_))),
    word("metal", "Fresnel's equations for a metal", |v| matches!(v.what(), What::Conductor(_))),
    word("medium", "a boundary between media", |v| matches!(v.what(), What::Medium { .. })),
    word("medium.hidden", "a boundary inside a medium that wins over it", |v| {
        matches!(v.what(), What::Medium { hidden: true, .. })
    }),
    word("overlap", "transparent objects that fill the same space", |v| {
        matches!(v.what(), What::Overlap(_) | What::Medium { interpenetration: true, .. })
    }),
    word("segment", "a way through a medium that takes light away", |v| matches!(v.what(), What::Segment(_))),
    word("scatter", "a point of a medium where light is turned", |v| matches!(v.what(), What::Scatter(_))),
    word("lens", "a ray through a point of a lens", |v| matches!(v.what(), What::Lens(_))),
    word("texture", "the colour of a textured surface", |v| matches!(v.what(), What::Texture(_))),
    word("bump", "a normal that a bump or a grain turns", |v| matches!(v.what(), What::Bump(_) | What::FrameMap(_))),
    word("detail", "a polygon that lies over a face", |v| matches!(v.what(), What::Detail(_))),
    word("environment", "a look-up in the environment", |v| matches!(v.what(), What::Environment(_))),
    word("limit", "something that a limit stops or leaves out", |v| matches!(v.what(), What::Limit { .. })),
    word("limit.depth", "a ray that is not sent because it would be too deep", |v| is_limit(v, "depth")),
    word("limit.contribution", "a ray that is not sent because it would count too little", |v| {
        is_limit(v, "contribution")
    }),
    word("ball", "a test of a ball", |v| matches!(v.what(), What::Ball { .. })),
    word("projection", "a test of a rectangle of the picture", |v| matches!(v.what(), What::Projection { .. })),
    word("decision", "how a solver came to be sure", |v| matches!(v.what(), What::Decision { .. })),
    word("implicit", "d(t) along the ray", |v| matches!(v.what(), What::Implicit { .. })),
    word("roots", "all hit times of a primitive that were looked at", |v| matches!(v.what(), What::Roots { .. })),
    word("combine", "a node of a Boolean tree", |v| matches!(v.what(), What::Combine { .. })),
    word("average", "the mean of a pixel's samples", |v| matches!(v.what(), What::Average(_))),
    word("confusion", "how far a hit is out of focus", |v| matches!(v.what(), What::Confusion(_))),
    word("mapping", "from a surface to a place in an image", |v| matches!(v.what(), What::Mapping(_))),
    word("texels", "the texels that are averaged", |v| matches!(v.what(), What::Texels(_))),
    word("lattice", "noise from the corners of a lattice cell", |v| matches!(v.what(), What::Lattice(_))),
    word("octaves", "turbulence: noise of several sizes added up", |v| matches!(v.what(), What::Octaves(_))),
    word("undulate", "a colour from a spline", |v| matches!(v.what(), What::Undulate(_))),
    word("rings", "the ring of a log", |v| matches!(v.what(), What::Rings(_))),
    word("frame_map", "a frame that a grain turns", |v| matches!(v.what(), What::FrameMap(_))),
    word("phase", "by how much light is turned in a medium", |v| matches!(v.what(), What::Phase(_))),
    word("passage", "what comes out of a stretch of a medium", |v| matches!(v.what(), What::Passage(_))),
    word("conductor", "Fresnel's equations for a metal", |v| matches!(v.what(), What::Conductor(_))),
    word("ambient", "the ambient term", |v| matches!(v.what(), What::Ambient { .. })),
    word("light_sample", "a point of a light that has a size", |v| matches!(v.what(), What::LightSample(_))),
    word("reflection", "the mirrored direction", |v| matches!(v.what(), What::Reflection { .. })),
    word("colour", "the sum of a hit's terms", |v| matches!(v.what(), What::Colour { .. })),
    word("written", "the bytes of a pixel", |v| matches!(v.what(), What::Written { .. })),
];

fn is_ray(view: &View, kind: RayKind) -> bool {
    match view.what() {
        What::Ray { ray, .. } => *ray == kind,
        What::LooseRay { .. } => kind == RayKind::Camera,
        _ => false,
    }
}

fn is_hit(view: &View, wanted: Sense) -> bool {
    matches!(view.what(), What::Hit { sense, .. } if *sense == wanted)
}

fn is_known(view: &View, wanted: Certificate) -> bool {
    match view.what() {
        What::Decision { certificate, .. } | What::Hit { certificate, .. } => *certificate == wanted,
        _ => false,
    }
}

fn has_candidate(view: &View, wanted: CandidateFate) -> bool {
    matches!(view.what(), What::Roots { candidates } if candidates.iter().any(|candidate| candidate.fate == wanted))
}

/// Whether the ray meets an extent; none where the event is no test of one.
fn meets_extent(view: &View) -> Option<bool> {
    match view.what() {
        What::Extent { inside, .. } => Some(inside.is_some()),
        What::Ball { is_met, .. } => Some(*is_met),
        What::Projection { holds, .. } => Some(*holds),
        _ => None,
    }
}

fn combines(view: &View, wanted: Operator) -> bool {
    matches!(view.what(), What::Combine { operator, .. } if *operator == wanted)
}

fn is_limit(view: &View, wanted: &str) -> bool {
    matches!(view.what(), What::Limit { limit, .. } if limit == wanted)
}
