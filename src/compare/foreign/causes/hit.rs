//! What can be wrong with the hit that is taken, and with its point.

use super::times::{wrong_intervals, wrong_times};
use super::{
    CAP_MISSING, CAP_UNBOUNDED, Case, Cause, DIRECTION_NORMALISED, Explanation, FAR_ROOT, Guess, HIT_MISSED,
    NEGATIVE_T, NOT_CLOSEST, POINT_FROM_ORIGIN, POINT_GENERIC, POINT_UNIT_DIRECTION, REJECTED_TAKEN,
    RIGHT_OPERAND_IGNORED, SELF_HIT, WALL_UNBOUNDED, WRONG_OPERATOR, number, vector,
};
use crate::compare::Said;
use crate::compare::foreign::allowance::Allowance;
use crate::compare::foreign::check::Subject;
use crate::compare::foreign::search::intervals;
use crate::compare::foreign::walk::same_name;
use crate::record::{Candidate, CandidateFate, EventId, What};

/// Guesses about the hit time.
pub fn of_time(case: Case, guesses: &mut Vec<Guess>) {
    let ray = &case.ours.rays[case.check.ray];
    let &[theirs] = case.check.numbers() else { return };
    let near = Allowance::start(ray.origin) / ray.direction.length();
    if let Some(left) = ray.left.as_ref().filter(|_| theirs.abs() <= near) {
        let how = format!("t on {left}, which the ray starts on, is 0 but for rounding: {}", number(theirs));
        guesses.push(Guess::new(&SELF_HIT, how, [theirs]));
    }
    of_rejected(case, guesses);
    of_candidates(case, guesses);
    of_wrong_times(case, guesses);
    of_first_hits(case, guesses);
}

/// Hits that are there and are not the one that is seen.
fn of_rejected(case: Case, guesses: &mut Vec<Guess>) {
    for event in case.ours.of(case.check.ray) {
        let What::Rejected { object, part, t, reason, .. } = &event.what else { continue };
        let how = format!("the {part} of {object} ({reason}): t");
        for cause in why(reason) {
            guesses.push(Guess::new(cause, how.clone(), [*t]));
        }
    }
}

/// The mistakes that let a hit be taken which was rejected for this reason.
fn why(reason: &str) -> Vec<&'static Cause> {
    if reason.contains("started on") {
        vec![&SELF_HIT]
    } else if reason.contains("behind") {
        vec![&NEGATIVE_T]
    } else if reason.contains("same object") {
        vec![&FAR_ROOT]
    } else {
        vec![&NOT_CLOSEST, &HIT_MISSED]
    }
}

/// Hit times of primitives that do not count, or that a compound cuts away.
fn of_candidates(case: Case, guesses: &mut Vec<Guess>) {
    let hit = case.ours.hit(case.check.ray);
    let is_cap = hit.is_some_and(|hit| matches!(hit.part, "cap" | "base"));
    for object in case.ours.of(case.check.ray).filter(|event| matches!(event.what, What::Object { .. })) {
        let node = case.ours.combined(object.id);
        let is_cut_away =
            |t: f64| node.is_some_and(|node| !intervals(node.result).into_iter().flatten().any(|end| end == t));
        for (primitive, name) in case.ours.primitives(object.id) {
            let Some((_, candidates)) = case.ours.candidates(primitive.id) else { continue };
            let is_told = case.agrees(case.check.ray, |subject| subject == Subject::Hits(primitive.id));
            let is_shape = !is_told && case.ours.hit(case.check.ray).is_some();
            for candidate in candidates {
                let how = format!("the {} of {name} ({}): t", candidate.part, candidate.reason);
                let mut guess = |cause| guesses.push(Guess::new(cause, how.clone(), [candidate.t]));
                match (candidate.fate, candidate.part.as_str()) {
                    (_, "wall") if is_cap && is_shape => guess(&CAP_MISSING),
                    _ if is_told && candidate.fate == CandidateFate::Rejected => {}
                    (CandidateFate::Rejected, "wall") => guess(&WALL_UNBOUNDED),
                    (CandidateFate::Rejected, "cap" | "base") => guess(&CAP_UNBOUNDED),
                    (CandidateFate::Rejected, _) => guess(&REJECTED_TAKEN),
                    (CandidateFate::Accepted, _) if is_cut_away(candidate.t) => {
                        guess(&RIGHT_OPERAND_IGNORED);
                        guess(&WRONG_OPERATOR);
                    }
                    (CandidateFate::Accepted, _) => {}
                }
            }
        }
    }
}

/// Any wrong time of any primitive: what is hit first is then another matter.
fn of_wrong_times(case: Case, guesses: &mut Vec<Guess>) {
    let hit = case.ours.hit(case.check.ray);
    for object in case.ours.of(case.check.ray).filter(|event| matches!(event.what, What::Object { .. })) {
        for (primitive, name) in case.ours.primitives(object.id) {
            let is_hit = hit.is_some_and(|hit| hit.leaf == name);
            let right: Vec<f64> = case.ours.candidates(primitive.id).map(accepted).unwrap_or_default();
            if case.agrees(case.check.ray, |subject| subject == Subject::Hits(primitive.id)) {
                continue;
            }
            for (cause, how, times) in wrong_times(case, primitive.id) {
                // Single roots are hits of their own, and stand among those that were rejected.
                let counts = is_hit || *cause == DIRECTION_NORMALISED;
                if counts && cause.id != "one-root" {
                    let changed =
                        times.into_iter().filter(|t| !right.iter().any(|own| (own - t).abs() <= case.check.allowed));
                    let each = changed.map(|t| Guess::new(cause, format!("{name}: {how}: t"), [t]));
                    guesses.extend(each);
                }
            }
        }
    }
}

/// The hit that would be the first one on the ray if every primitive had been asked with the same mistake.
fn of_first_hits(case: Case, guesses: &mut Vec<Guess>) {
    let objects = case.ours.of(case.check.ray).filter(|event| matches!(event.what, What::Object { .. }));
    let asked: Vec<Asked> = objects.map(|object| asked(case, object.id)).collect();
    let mut mistakes: Vec<(&'static Cause, usize)> = Vec::new();
    for (cause, number, _) in asked.iter().flat_map(|asked| &asked.wrong) {
        if !mistakes.iter().any(|(known, other)| known == cause && other == number) {
            mistakes.push((cause, *number));
        }
    }
    let first = |times: &[f64]| times.iter().copied().filter(|&t| t > case.check.allowed).fold(f64::INFINITY, f64::min);
    for (cause, number) in mistakes {
        let of = |asked: &Asked| {
            let wrong = asked.wrong.iter().find(|(other, place, _)| *other == cause && *place == number);
            first(wrong.map_or(&asked.right, |(_, _, times)| times))
        };
        let seen = asked.iter().map(of).fold(f64::INFINITY, f64::min);
        guesses.push(Guess::new(cause, "with that, the first hit on the ray is at t", [seen]));
    }
}

/// The hit times of an object, as they are and as mistakes give them; the number tells apart the ways to make one mistake.
struct Asked {
    right: Vec<f64>,
    wrong: Vec<(&'static Cause, usize, Vec<f64>)>,
}

fn asked(case: Case, object: EventId) -> Asked {
    let flat = |spans: Vec<[f64; 2]>| spans.into_iter().flatten().filter(|t| t.is_finite()).collect::<Vec<_>>();
    let (right, wrong) = match (case.ours.combined(object), case.ours.primitives(object).next()) {
        (Some(node), _) => {
            let wrong = wrong_intervals(case, object).into_iter().map(|(cause, _, spans)| (cause, flat(spans)));
            (flat(intervals(node.result)), wrong.collect::<Vec<_>>())
        }
        (None, Some((primitive, _))) => {
            let wrong = wrong_times(case, primitive.id).into_iter().map(|(cause, _, times)| (cause, times));
            let right = case.ours.candidates(primitive.id).map(accepted).unwrap_or_default();
            (right, wrong.filter(|(cause, _)| cause.id != "one-root").collect())
        }
        (None, None) => (Vec::new(), Vec::new()),
    };
    let mut numbered: Vec<(&'static Cause, usize, Vec<f64>)> = Vec::new();
    for (cause, times) in wrong {
        let number = numbered.iter().filter(|(other, ..)| *other == cause).count();
        numbered.push((cause, number, times));
    }
    Asked { right, wrong: numbered }
}

/// The times of the hits that count.
fn accepted((_, candidates): (EventId, &[Candidate])) -> Vec<f64> {
    candidates
        .iter()
        .filter(|candidate| candidate.fate == CandidateFate::Accepted)
        .map(|candidate| candidate.t)
        .collect()
}

/// Guesses about a hit point, or about the start of a ray that was spawned there.
pub fn of_point(case: Case, guesses: &mut Vec<Guess>) {
    let Some(hit) = case.ours.hit(case.check.ray) else { return };
    let (origin, direction) = (case.origin(), case.direction());
    let unit = direction.normalize();
    let how = format!("origin + dir / |dir| t with |dir| = {}", number(direction.length()));
    guesses.push(Guess::vector(&POINT_UNIT_DIRECTION, how, origin + unit * hit.t));
    let how = format!("origin + dir |dir| t with |dir| = {}", number(direction.length()));
    guesses.push(Guess::vector(&POINT_UNIT_DIRECTION, how, origin + unit * (hit.t * direction.length_squared())));
    for told in case.units() {
        guesses.push(Guess::vector(
            &POINT_UNIT_DIRECTION,
            "origin + dir t in another unit of t",
            origin + direction * (hit.t / told),
        ));
    }
    guesses.push(Guess::vector(&POINT_GENERIC, "S + c t", hit.generic_point));
    guesses.push(Guess::vector(&POINT_FROM_ORIGIN, format!("P − origin {}", vector(origin)), hit.point - origin));
}

/// What speaks for a cause where another object is hit and no time is told.
pub fn of_object(case: Case) -> Vec<Explanation> {
    let Said::Words(theirs) = &case.check.theirs else { return Vec::new() };
    let ours = case.ours.hit(case.check.ray);
    let mut found = Vec::new();
    for event in case.ours.of(case.check.ray) {
        let What::Rejected { object, part, t, reason, .. } = &event.what else { continue };
        if same_name(object, theirs) {
            let evidence = format!("the {part} of {object} is met at t = {}, {reason}", number(*t));
            found.extend(why(reason).into_iter().map(|cause| Explanation {
                cause,
                evidence: evidence.clone(),
                misfit: 1.0,
            }));
        }
    }
    if let Some(hit) = ours.filter(|hit| matches!(hit.part, "cap" | "base")) {
        let evidence = format!("ours is hit on its {} at t = {}, and the wall there is not", hit.part, number(hit.t));
        found.push(Explanation { cause: &CAP_MISSING, evidence, misfit: 1.0 });
    }
    if ours.is_some() {
        let evidence = "what they hit lies behind it".to_owned();
        found.push(Explanation { cause: &HIT_MISSED, evidence, misfit: 1.0 });
    }
    found
}
