//! Where two stories part for the first time, in words.

use super::Tolerance;
use super::difference::{Standing, TreeDifference};
use super::fields::Change;
use crate::record::{EventId, What};
use crate::trace::RayTree;
use crate::view::row;

/// An event at which two trees differ, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Departure {
    /// Its row among the pairs.
    pub row: usize,
    /// The event in the left tree; where it has none, the one that it should be a part of.
    pub left: EventId,
    /// The event in the right tree, likewise.
    pub right: EventId,
    /// What the event is.
    pub event: String,
    /// Why it differs: `t: 4.5 here, 4.7 there`.
    pub why: String,
    /// What the two say differently, if the event is in both.
    pub changes: Vec<Change>,
}

/// The words for changes that are told; the rest is counted.
const TOLD: usize = 3;

impl Departure {
    /// The departure at a row.
    pub(super) fn at(
        pairs: &TreeDifference,
        place: usize,
        trees: [&RayTree; 2],
        tolerance: &Tolerance,
    ) -> Option<Self> {
        let pair = *pairs.pairs.get(place)?;
        let changes = pairs.changes(place, trees, tolerance);
        let (what, why) = match (pair.left, pair.right) {
            (Some(a), Some(b)) => {
                let [left, right] = [trees[0].event(a), trees[1].event(b)];
                (left, why_changed(&left.what, &right.what, &changes))
            }
            (Some(a), None) => (trees[0].event(a), only_one(&trees[0].event(a).what, ["here", "there"])),
            (None, Some(b)) => (trees[1].event(b), only_one(&trees[1].event(b).what, ["there", "here"])),
            (None, None) => return None,
        };
        let above = |side: usize| {
            let known = |place: &usize| [pairs.pairs[*place].left, pairs.pairs[*place].right][side].is_some();
            let place = std::iter::successors(Some(place), |&place| pairs.above(place)).find(known);
            place.and_then(|place| [pairs.pairs[place].left, pairs.pairs[place].right][side]).unwrap_or(0)
        };
        Some(Self { row: place, left: above(0), right: above(1), event: row(what).label, why, changes })
    }
}

impl TreeDifference {
    /// The row that a row is a part of.
    #[must_use]
    pub fn above(&self, row: usize) -> Option<usize> {
        let depth = self.pairs.get(row)?.depth.checked_sub(1)?;
        (0..row).rev().find(|&k| self.pairs[k].depth == depth)
    }

    /// The rows that are not the same, in order.
    #[must_use]
    pub fn different(&self) -> impl DoubleEndedIterator<Item = usize> {
        (0..self.pairs.len()).filter(|&k| self.pairs[k].standing != Standing::Same)
    }
}

fn why_changed(left: &What, right: &What, changes: &[Change]) -> String {
    let mut told: Vec<String> = telling(left, right, changes).into_iter().collect();
    if told.is_empty() {
        told.extend(changes.iter().take(TOLD).map(one_change));
        if changes.len() > TOLD {
            told.push(format!("and {} more", changes.len() - TOLD));
        }
    }
    told.join("; ")
}

/// `t: 4.5 here, 4.7 there`.
pub(super) fn one_change(change: &Change) -> String {
    let [left, right] = change.texts();
    match (&change.left, &change.right) {
        (Some(_), None) => format!("{}: {left} here, nothing there", change.name),
        (None, Some(_)) => format!("{}: nothing here, {right} there", change.name),
        _ => format!("{}: {left} here, {right} there", change.name),
    }
}

/// What matters most of a hit comes first: which surface it is, then when.
fn telling(left: &What, right: &What, changes: &[Change]) -> Option<String> {
    let (What::Hit { .. }, What::Hit { .. }) = (left, right) else { return None };
    let [ours, theirs] = [left, right].map(surface);
    if ours != theirs {
        return Some(format!("{ours} is hit here, {theirs} there"));
    }
    changes.iter().find(|change| change.name == "t").map(one_change)
}

fn surface(what: &What) -> String {
    match what {
        What::Hit { object, leaf, part, .. } if object == leaf => format!("the {part} of {object}"),
        What::Hit { object, leaf, part, .. } => format!("the {part} of {leaf} in {object}"),
        _ => String::new(),
    }
}

/// Whether the same event goes another way in the two trees.
pub(super) fn parts(left: &What, right: &What) -> bool {
    match (left, right) {
        (What::Hit { .. }, What::Hit { .. }) => surface(left) != surface(right),
        (What::Snell { refracted: a, .. }, What::Snell { refracted: b, .. }) => a.is_some() != b.is_some(),
        (What::Medium { after: a, .. }, What::Medium { after: b, .. }) => a != b,
        _ => false,
    }
}

/// Whether it changes the story that an event happens in one tree alone: solvers and boxes are means to an end.
pub(super) fn matters(what: &What) -> bool {
    matches!(
        what,
        What::Hit { .. }
            | What::Nothing { .. }
            | What::Ray { .. }
            | What::Shadow { .. }
            | What::Light { .. }
            | What::Snell { .. }
            | What::Reflection { .. }
            | What::Medium { .. }
            | What::Limit { .. }
            | What::Sample(_)
            | What::Scatter(_)
            | What::Texture(_)
            | What::Detail(_)
    )
}

/// What happens on one side alone, in words.
fn only_one(what: &What, [there_is, there_is_not]: [&str; 2]) -> String {
    match what {
        What::Object { name, .. } => format!("{name} is asked {there_is}, and was never asked {there_is_not}"),
        What::Hit { .. } => format!("{} is hit {there_is}, and nothing {there_is_not}", surface(what)),
        What::Nothing { .. } => format!("nothing is hit {there_is}, something {there_is_not}"),
        What::Ray { ray, .. } => format!("a {} ray is sent {there_is}, and none {there_is_not}", ray.name()),
        What::Shadow { object, .. } => {
            format!("{object} stands before the light {there_is}, and not {there_is_not}")
        }
        What::Light { name, .. } => format!("the light {name} shines {there_is}, and there is none {there_is_not}"),
        What::Rejected { object, part, .. } => {
            format!("the ray's line meets the {part} of {object} {there_is}, and not {there_is_not}")
        }
        What::Limit { consequence, .. } => format!("a limit is met {there_is} ({consequence}), and not {there_is_not}"),
        _ => format!("this happens {there_is}, and not {there_is_not}"),
    }
}
