//! What was skipped, cut off or rejected, with its name and the reason: nothing of it is ever silent.

use crate::record::{Candidate, CandidateFate, Certificate, Event, EventId, What};
use crate::trace::RayTree;
use crate::view::{brief, row};

/// In which way something was left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Cut {
    /// Never asked: a cheaper test showed that there was no need.
    Missed,
    /// Left before its end, because the rest could not change the answer.
    Early,
    /// Found, and then not taken.
    Rejected,
    /// Stopped by a limit; something is missing.
    Limited,
    /// Not decided by the numbers that there are.
    Undecidable,
    /// Passed as if it were not there.
    Passed,
}

impl Cut {
    /// All of them, in the order in which they are listed.
    pub const ALL: [Self; 6] =
        [Self::Limited, Self::Undecidable, Self::Early, Self::Missed, Self::Rejected, Self::Passed];

    /// The word for it, which is also its key in the catalogue of words.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Missed => "missed",
            Self::Early => "early-out",
            Self::Rejected => "rejected",
            Self::Limited => "limited",
            Self::Undecidable => "undecidable",
            Self::Passed => "passed",
        }
    }
}

/// Something that was left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Skip {
    /// The event that says so.
    pub event: EventId,
    /// In which way.
    pub cut: Cut,
    /// What was left out.
    pub what: String,
    /// Why.
    pub reason: String,
}

/// In which way an event left something out, if it did.
#[must_use]
pub fn cut(what: &What) -> Option<Cut> {
    match what {
        What::Extent { inside: None, .. }
        | What::Ball { is_met: false, .. }
        | What::Projection { holds: false, .. } => Some(Cut::Missed),
        What::Planes { stopped: Some(_), .. } | What::Combine { early_out: Some(_), .. } => Some(Cut::Early),
        What::Roots { candidates } if candidates.iter().any(is_rejected) => Some(Cut::Rejected),
        What::Rejected { .. } => Some(Cut::Rejected),
        What::Limit { .. } => Some(Cut::Limited),
        What::Decision { certificate: Certificate::Undecidable, .. } => Some(Cut::Undecidable),
        What::Search { undecided, .. } if *undecided > 0 => Some(Cut::Undecidable),
        What::Medium { hidden: true, .. } => Some(Cut::Passed),
        _ => None,
    }
}

fn is_rejected(candidate: &Candidate) -> bool {
    candidate.fate == CandidateFate::Rejected
}

/// Everything that an event left out, each with its reason; empty where it left nothing out.
#[must_use]
pub fn skips(event: &Event) -> Vec<Skip> {
    let Some(cut) = cut(&event.what) else { return Vec::new() };
    let one = |what: String, reason: String| Skip { event: event.id, cut, what, reason };
    match &event.what {
        What::Extent { of, .. } => vec![one(of.clone(), "the ray misses the box around it".to_owned())],
        What::Ball { of, distance, radius, .. } => {
            let reason = format!("the ray passes its middle at {}, further than {}", brief(*distance), brief(*radius));
            vec![one(of.clone(), reason)]
        }
        What::Projection { of, .. } => {
            vec![one(of.clone(), "the ray passes the picture outside its rectangle".to_owned())]
        }
        What::Planes { rows, stopped: Some(stopped) } => {
            vec![one(format!("the plane table after row {}", rows.len()), stopped.clone())]
        }
        What::Combine { early_out: Some(reason), .. } => vec![one(row(event).label, reason.clone())],
        What::Roots { candidates } => candidates
            .iter()
            .filter(|candidate| is_rejected(candidate))
            .map(|candidate| one(format!("{} at t = {}", candidate.part, brief(candidate.t)), candidate.reason.clone()))
            .collect(),
        What::Rejected { t, reason, .. } => {
            vec![one(format!("{}, t = {}", row(event).label, brief(*t)), reason.clone())]
        }
        What::Limit { limit, consequence, .. } => vec![one(format!("stopped by {limit}"), consequence.clone())],
        What::Decision { question, .. } => {
            vec![one(
                question.clone(),
                "half a unit in the last places of the ray's own numbers would change it".to_owned(),
            )]
        }
        What::Search { undecided, .. } => vec![one(
            format!("stretches of the search: {undecided}"),
            "bounds on d(t) do not tell its sign, down to the last bit".to_owned(),
        )],
        What::Medium { decided, .. } => vec![one(row(event).label, decided.clone())],
        _ => Vec::new(),
    }
}

/// Everything that was left out in a tree, in the order in which it happened.
pub fn all_skips(tree: &RayTree) -> impl Iterator<Item = Skip> {
    tree.events.iter().flat_map(skips)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{embedded_scenes, load};
    use crate::trace::record_pixel;

    #[test]
    fn whatever_is_left_out_in_any_scene_has_a_name_and_a_reason() {
        for embedded in embedded_scenes() {
            let scene = load(embedded.text, &embedded.name).unwrap();
            let tree = record_pixel(&scene, scene.pixels[0][0], scene.pixels[0][1]);
            for event in tree.events.iter().filter(|event| cut(&event.what).is_some()) {
                let skips = skips(event);
                assert!(!skips.is_empty(), "{}: {:?}", embedded.name, event.what);
                for Skip { what, reason, .. } in skips {
                    assert!(!what.is_empty() && !reason.is_empty(), "{}: {:?}", embedded.name, event.what);
                }
            }
        }
    }

    #[test]
    fn an_object_without_intervals_says_why_below_it_or_was_asked_in_full() {
        for embedded in embedded_scenes() {
            let scene = load(embedded.text, &embedded.name).unwrap();
            let tree = record_pixel(&scene, scene.pixels[0][0], scene.pixels[0][1]);
            let empty = |event: &&Event| matches!(event.what, What::Object { intervals: 0, .. });
            for object in tree.events.iter().filter(empty) {
                let has_parts = object.id + 1 < tree.subtree_end(object.id);
                assert!(has_parts, "{}: {:?} says nothing", embedded.name, object.what);
            }
        }
    }
}
