//! Where a tree parts from the exact one, and why.

use super::digits::is_working;
use crate::record::{Candidate, CandidateFate, Event, EventId, What};

/// The first thing that happens otherwise than in the exact tree.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parting {
    /// The event; where something is missing, the one that it should be a part of.
    pub event: EventId,
    /// What is different, in words.
    pub reason: String,
}

/// What two events that belong together disagree on.
pub fn between(event: &Event, exact: &Event) -> Option<Parting> {
    let reason = match (&event.what, &exact.what) {
        (What::Roots { candidates }, What::Roots { candidates: exact }) => roots_differ(candidates, exact),
        (
            What::Hit { object, leaf, part, .. },
            What::Hit { object: true_object, leaf: true_leaf, part: true_part, .. },
        ) => {
            let name = |object: &str, leaf: &str, part: &str| {
                if object == leaf {
                    format!("the {part} of {object}")
                } else {
                    format!("the {part} of {leaf} in {object}")
                }
            };
            let (found, truth) = (name(object, leaf, part), name(true_object, true_leaf, true_part));
            (found != truth).then(|| format!("{found} is hit instead of {truth}"))
        }
        (What::Combine { combined, .. }, What::Combine { combined: exact, .. }) => (combined.len() != exact.len())
            .then(|| format!("{} instead of {}", intervals(combined.len()), intervals(exact.len()))),
        _ => None,
    };
    reason.map(|reason| Parting { event: event.id, reason })
}

fn roots_differ(found: &[Candidate], exact: &[Candidate]) -> Option<String> {
    let kept = |list: &[Candidate]| {
        let kept = list.iter().filter(|candidate| candidate.fate == CandidateFate::Accepted);
        kept.map(|candidate| (candidate.part.clone(), candidate.sense)).collect::<Vec<_>>()
    };
    let (found, exact) = (kept(found), kept(exact));
    if found.len() < exact.len() {
        return Some(format!("{} of {} found", missing(exact.len() - found.len()), exact.len()));
    }
    if found.len() > exact.len() {
        return Some(format!("{} hits are found where there are {}", found.len(), exact.len()));
    }
    let differs = found.iter().zip(&exact).find(|(a, b)| a != b);
    differs.map(|((found, _), (truth, _))| {
        if found == truth {
            format!("{found} is crossed the other way")
        } else {
            format!("{found} is met instead of {truth}")
        }
    })
}

fn missing(count: usize) -> String {
    if count == 1 { "one hit is not".to_owned() } else { format!("{count} hits are not") }
}

fn intervals(count: usize) -> String {
    match count {
        0 => "nothing is left".to_owned(),
        1 => "one stretch is left".to_owned(),
        count => format!("{count} stretches are left"),
    }
}

/// What happens here alone.
pub fn only_here(event: &Event) -> Option<Parting> {
    let reason = format!("{}, which with exact hits is not so", spoken(&event.what)?);
    Some(Parting { event: event.id, reason })
}

/// What happens in the exact tree alone, as a part of the event `parent`.
pub fn only_exactly(event: &Event, parent: EventId) -> Option<Parting> {
    let reason = format!("with exact hits {}; here that is not so", spoken(&event.what)?);
    Some(Parting { event: parent, reason })
}

/// An event in words; none if it does not matter who has it: solvers may work in ways of their own, and round.
fn spoken(what: &What) -> Option<String> {
    Some(match what {
        _ if is_working(what) => return None,
        What::Decision { .. }
        | What::Implicit { .. }
        | What::Extent { .. }
        | What::Ball { .. }
        | What::Projection { .. }
        | What::Moved { .. }
        | What::Object { .. }
        | What::Primitive { .. } => return None,
        What::Roots { .. } => "the ray comes near enough to be tested".to_owned(),
        What::Rejected { object, part, reason, .. } => format!("the {part} of {object} does not count ({reason})"),
        What::Hit { object, part, .. } => format!("the {part} of {object} is hit"),
        What::Nothing { .. } => "nothing is in front".to_owned(),
        What::Ray { ray, .. } => format!("a {} ray is sent", ray.name()),
        What::Shadow { object, .. } => format!("{object} stands before a light"),
        What::Light { name, .. } => format!("the light {name} shines here"),
        What::Snell { .. } => "Snell's law applies".to_owned(),
        What::Reflection { .. } => "a ray is mirrored".to_owned(),
        What::Medium { before, after, .. } => format!("the ray goes from {before} into {after}"),
        What::Limit { consequence, .. } => format!("a limit is met: {consequence}"),
        _ => "something else happens".to_owned(),
    })
}
