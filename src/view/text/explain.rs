//! What an event means, in a sentence or two for somebody who meets it for the first time.

use super::effect_detail::explain_effect;
use super::texture_detail::explain_texture;
use crate::record::{Certificate, Operator, RayKind, Sense, What};

/// The sentence for an event. It depends on the kind of event and on how it ended, never on its numbers.
pub(super) fn explain(what: &What) -> &'static str {
    explain_search(what)
        .or_else(|| explain_hit(what))
        .or_else(|| explain_texture(what))
        .or_else(|| explain_effect(what))
        .unwrap_or_else(|| explain_light(what))
}

/// The ray and the search for its hits.
fn explain_search(what: &What) -> Option<&'static str> {
    Some(match what {
        What::Pixel { .. } => "Everything that decides the colour of this pixel, in six steps.",
        What::LooseRay { .. } => "Everything that decides the colour that returns along this ray.",
        What::Step { number, .. } => step(*number),
        What::Ray { ray, .. } => sent_because(*ray),
        What::Object { .. } => {
            "All stretches of the ray inside this object are found, for every t, in front of the eye and behind it."
        }
        What::Ball { is_met: true, .. } => "The ray passes through the ball, so what the ball holds must be tested.",
        What::Ball { is_met: false, .. } => {
            "The ray passes the middle of the ball at more than its radius, so it misses all that the ball holds."
        }
        What::Extent { inside: Some(_), .. } => "The ray passes through the box, so what the box holds must be tested.",
        What::Extent { inside: None, .. } => {
            "The ray misses the box, so nothing that the box holds needs to be tested."
        }
        What::Projection { holds: true, .. } => {
            "The pixel lies in the rectangle of the picture outside which the object cannot be seen, so the object must be \
             tested."
        }
        What::Projection { .. } => {
            "The pixel lies outside the rectangle of the picture that holds the object, so this ray from the eye cannot \
             meet it."
        }
        What::Transform { .. } => {
            "The inverse transform takes the ray to the shape's own coordinates, where its equation is simple. \
             c is not normalised, so that t means the same in both."
        }
        What::Primitive { .. } => "The hits with this one shape alone, before it is combined with others.",
        What::Planes { .. } => {
            "Each plane gives a time t = m·(spot − S) / m·c. The ray is inside after the latest entering time and \
             before the earliest leaving time; when the first passes the second, the ray misses."
        }
        What::Quadratic { roots, .. } if roots.is_empty() => {
            "S + c t put into the surface's equation gives A t² + 2 B t + C = 0, which has no real root: the ray \
             never meets the surface."
        }
        What::Quadratic { .. } => "S + c t put into the surface's equation gives A t² + 2 B t + C = 0.",
        What::Quartic { .. } => "S + c t put into the surface's equation gives a polynomial of degree four.",
        What::Search { .. } => {
            "No formula gives the zeros of d(t), so the ray is cut into ever shorter stretches; a stretch on which a \
             bound shows that d(t) keeps its sign is done."
        }
        What::Decision { certificate, .. } => decided(*certificate),
        What::Implicit { .. } => "d(t) is positive outside the shape, zero on its surface and negative inside.",
        What::Roots { .. } => "Each hit time that a solver offers is kept or turned down, for a reason.",
        What::Moved { .. } => {
            "By rounding the ray started on the wrong side of the surface that it leaves, at so flat an angle that it \
             would have stayed there. It is asked again from as far beside the surface as rounding can have moved it."
        }
        What::Combine { operator, early_out, .. } => combined(*operator, early_out.is_some()),
        _ => return None,
    })
}

const fn decided(certificate: Certificate) -> &'static str {
    match certificate {
        Certificate::Certain => {
            "Of all decisions on the way this one was the closest: the number is larger than all rounding errors in it, \
             so its sign is sure."
        }
        Certificate::Fallback => {
            "The number is smaller than the rounding errors of the fast arithmetic, so its sign is not sure. With 32 \
             digits it is."
        }
        Certificate::Undecidable => {
            "The ray's own numbers do not say: half a unit in their last places turns the sign of this number. What \
             follows is the answer for the numbers exactly as they stand."
        }
    }
}

const fn step(number: u8) -> &'static str {
    match number {
        1 => "A ray is built from the eye through the pixel: P(t) = eye + dir t.",
        2 => "Every object in the scene is asked where this ray is inside it.",
        3 => "Of all the hits, the one with the smallest positive t is the one that is seen.",
        4 => "The hit time put into the ray gives the point, and the surface there gives the normal.",
        5 => "Light that reaches the point, directly or along spawned rays, gives the colour.",
        6 => "The colour is clamped, encoded and written into the picture.",
        _ => "A part of the work.",
    }
}

const fn sent_because(ray: RayKind) -> &'static str {
    match ray {
        RayKind::Camera => "The ray from the eye through the pixel.",
        RayKind::Reflected => "A ray is sent from the hit in the mirrored direction; its colour is added, weighted.",
        RayKind::Refracted => "A ray is sent on through the surface; its colour is added, weighted.",
        RayKind::Shadow => "A ray is sent towards the light to see whether anything stands in the way.",
        RayKind::Scattered => {
            "Light that arrives here comes from another direction: the path is followed back that way."
        }
    }
}

const fn combined(operator: Operator, early: bool) -> &'static str {
    match (operator, early) {
        (Operator::Union, _) => "Inside left or right. Only when both lists are empty does the ray miss the union.",
        (Operator::Intersection, false) => "Inside both left and right: from the later entry to the earlier exit.",
        (Operator::Intersection, true) => "One of the two lists is empty, so nothing can be inside both.",
        (Operator::Difference, false) => {
            "Inside left but not inside right. Where right's surface remains, its normal is turned round."
        }
        (Operator::Difference, true) => "The list of one side decides the difference without the other's.",
    }
}

/// Which hit counts.
fn explain_hit(what: &What) -> Option<&'static str> {
    Some(match what {
        What::Rejected { .. } => "This place lies on the ray too, but it is not the one that is seen.",
        What::Hit { sense: Sense::Leave, .. } => {
            "The closest hit in front. The ray is inside the object here and comes out of it."
        }
        What::Hit { .. } => "The closest hit in front of the ray's start: this is what is seen.",
        What::Nothing { .. } => "No object has a hit with t > 0, so the ray sees the background.",
        _ => return None,
    })
}

/// What light does there.
fn explain_light(what: &What) -> &'static str {
    match what {
        What::Ambient { .. } => "Light that comes from everywhere: the same on every point of the material.",
        What::Light { arriving, .. } if *arriving == [0.0; 3] => {
            "No light arrives from here, because the surface faces away or something stands in the way."
        }
        What::Light { .. } => {
            "The diffuse term grows as the surface turns towards the light, the specular term as the eye nears the \
             mirrored direction."
        }
        What::Shadow { .. } => "Something lies between the hit and the light.",
        What::Reflection { .. } => {
            "r = dir − 2 (dir·m) m: the part along the normal is turned round, the rest is kept."
        }
        What::Snell { total_internal_reflection: true, .. } => {
            "The angle of incidence is past the critical angle: no light gets through, all of it is reflected."
        }
        What::Snell { .. } => "n₁ sin θ₁ = n₂ sin θ₂: light bends towards the normal where it enters a denser medium.",
        What::Medium { interpenetration: true, .. } => {
            "Two transparent objects overlap here. Which of them fills the overlap is a rule of the scene."
        }
        What::Medium { hidden: true, .. } => "Another medium wins over this one, so the boundary has no effect.",
        What::Medium { .. } => "The ray carries the medium that it travels in from boundary to boundary.",
        What::Limit { .. } => "The work was stopped by a limit; what is missing for that reason is stated.",
        What::Colour { .. } => "The colour that returns along this ray is the sum of five components.",
        _ => "The linear colour is clamped to the range from 0 to 1, encoded as sRGB and rounded to bytes.",
    }
}
