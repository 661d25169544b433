//! Why a light arrives that should not, or does not arrive though it should.

use super::{
    BEYOND_LIGHT, CAP_MISSING, Case, Cause, Explanation, NEGATIVE_T, SELF_HIT, SHADOW_FROM_GLASS, SHADOW_MISSED, number,
};
use crate::compare::Said;
use crate::compare::foreign::allowance::Allowance;
use crate::compare::foreign::ours::OurRay;
use crate::compare::foreign::walk::same_name;
use crate::record::{Event, EventId, RayKind, What};

/// The causes for a light that is told otherwise than ours.
pub fn of_shadow(case: Case, light: EventId) -> Vec<Explanation> {
    let rays = case.ours.rays.iter().enumerate();
    let sent = rays
        .into_iter()
        .find(|(_, ray)| ray.kind == RayKind::Shadow && case.ours.tree.event(ray.event).parent == Some(light));
    let Some((place, ray)) = sent else { return Vec::new() };
    let is_lit_there = matches!(&case.check.theirs, Said::Words(words) if words == "light arrives");
    if is_lit_there { missed(case, place) } else { invented(case, place, ray) }
}

/// Ours finds something in the way, and they do not.
fn missed(case: Case, ray: usize) -> Vec<Explanation> {
    let mut found = Vec::new();
    for event in case.ours.of(ray) {
        let What::Shadow { object, t, .. } = &event.what else { continue };
        let evidence = format!("{object} is met at t = {} on the way to the light", number(*t));
        found.push(Explanation { cause: &SHADOW_MISSED, evidence: evidence.clone(), misfit: 0.5 });
        if is_cap(case, ray, object, *t) {
            found.push(Explanation { cause: &CAP_MISSING, evidence: format!("{evidence}, on a cap"), misfit: 0.5 });
        }
    }
    found
}

fn is_cap(case: Case, ray: usize, object: &str, t: f64) -> bool {
    let asked = case.ours.object(ray, object).map(|event| case.ours.below(event.id)).unwrap_or_default();
    candidates(asked).any(|(_, part, time)| time == t && matches!(part, "cap" | "base"))
}

/// They find something in the way, and ours does not.
fn invented(case: Case, place: usize, ray: &OurRay) -> Vec<Explanation> {
    let blocker = match &case.check.theirs {
        Said::Words(words) if !matches!(words.as_str(), "no light arrives") => Some(words.as_str()),
        _ => None,
    };
    let near = Allowance::start(ray.origin) / ray.direction.length();
    let end = case.ours.scene.lights.iter().find(|light| Some(&light.name) == ray.light.as_ref());
    let is_point = end.is_some_and(|light| !matches!(light.kind, crate::scene::LightKind::Directional(_)));
    // In our unit t is 1 at the light; programs that normalise have the distance there.
    let told: Vec<f64> = case.check.time.map(|t| vec![t, t / ray.direction.length()]).unwrap_or_default();
    let mut found = Vec::new();
    for object in case.ours.of(place).filter(|event| matches!(event.what, What::Object { .. })) {
        let What::Object { name, .. } = &object.what else { continue };
        let is_meant = blocker.is_none_or(|blocker| same_name(blocker, name));
        for (leaf, part, t) in candidates(case.ours.below(object.id)).filter(|_| is_meant) {
            let is_own = ray.left.as_deref() == Some(name.as_str()) && t.abs() <= near;
            let cause: &'static Cause = if is_own {
                &SELF_HIT
            } else if t < 0.0 {
                &NEGATIVE_T
            } else if is_point && t > 1.0 {
                &BEYOND_LIGHT
            } else if is_transparent(case, name) {
                &SHADOW_FROM_GLASS
            } else {
                continue;
            };
            let fits = told.iter().any(|told| (told - t).abs() <= near.max(1e-6 * t.abs()));
            let misfit = match (fits, told.is_empty(), blocker.is_some()) {
                (true, _, _) => 0.0,
                (false, true, true) => 0.5,
                (false, true, false) => 0.9,
                (false, false, _) => continue,
            };
            let said = case.check.time.map_or_else(String::new, |t| format!("; theirs: t = {}", number(t)));
            let evidence = format!("the {part} of {leaf} is met at t = {}{said}", number(t));
            found.push(Explanation { cause, evidence, misfit });
        }
    }
    found
}

/// Primitive, part and time of all hits that count, of the events below an object.
fn candidates(events: &[Event]) -> impl Iterator<Item = (&str, &str, f64)> {
    let mut leaf = "";
    events.iter().flat_map(move |event| {
        if let What::Primitive { name, .. } = &event.what {
            leaf = name;
        }
        let list = match &event.what {
            What::Roots { candidates } => candidates.as_slice(),
            _ => &[],
        };
        list.iter().map(move |candidate| (leaf, candidate.part.as_str(), candidate.t))
    })
}

fn is_transparent(case: Case, object: &str) -> bool {
    let found = case.ours.scene_object(object);
    found.is_some_and(|object| case.ours.scene.materials[object.material].transparency > 0.0)
}
