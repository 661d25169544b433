//! Two trees side by side as text: a mark, a word where something differs, and both values of what changed.

use super::departure::one_change;
use super::difference::{Standing, TreeDifference};
use super::{Departure, Tolerance};
use crate::record::Event;
use crate::trace::RayTree;
use crate::view::{indent, row};
use std::fmt::Write as _;

/// The difference as text. What is the same all the way down is one line with the number of events below it.
#[must_use]
pub fn difference_text(pairs: &TreeDifference, trees: [&RayTree; 2], tolerance: &Tolerance) -> String {
    if pairs.is_empty() {
        return format!("no difference in {} events\n", pairs.pairs.len());
    }
    let [same, changed, left, right] = pairs.counts();
    let mut text = format!("{same} events are the same (=), {changed} changed (~), ");
    let _ = writeln!(text, "{left} happen only here (-), {right} only there (+)");
    let first = pairs.first_departure(trees[0], trees[1], tolerance);
    put_departure(&mut text, "first difference", first.as_ref(), trees);
    let parting = pairs
        .first_parting(trees[0], trees[1], tolerance)
        .filter(|parting| first.as_ref().is_none_or(|first| first.row != parting.row));
    put_departure(&mut text, "first that goes another way", parting.as_ref(), trees);
    text.push('\n');
    put_rows(&mut text, pairs, trees, tolerance);
    text
}

fn put_departure(text: &mut String, head: &str, departure: Option<&Departure>, [left, right]: [&RayTree; 2]) {
    let Some(departure) = departure else { return };
    let numbers = format!("event {} of {}", departure.left, left.end());
    let others = format!("{} of {}", departure.right, right.end());
    let _ = writeln!(text, "{head}: {} ({numbers} here, {others} there)\n  {}", departure.event, departure.why);
}

fn put_rows(text: &mut String, pairs: &TreeDifference, trees: [&RayTree; 2], tolerance: &Tolerance) {
    let mut place = 0;
    while let Some(pair) = pairs.pairs.get(place) {
        let event = match (pair.left, pair.right) {
            (_, Some(id)) if pair.left.is_none() => trees[1].event(id),
            (Some(id), _) => trees[0].event(id),
            _ => return,
        };
        let indent = indent(pair.depth as usize);
        let is_whole = pair.different == 0 || matches!(pair.standing, Standing::OnlyLeft | Standing::OnlyRight);
        let below = pair.end as usize - place - 1;
        let word = match pair.standing {
            Standing::Same | Standing::Changed => "",
            Standing::OnlyLeft => " [only here]",
            Standing::OnlyRight => " [only there]",
        };
        let counted = if is_whole && below > 0 { format!("   ({below} more below)") } else { String::new() };
        let _ = writeln!(text, "{} {indent}{}{word}{counted}", pair.standing.mark(), line(event));
        if pair.standing == Standing::Changed {
            for change in pairs.changes(place, trees, tolerance) {
                let _ = writeln!(text, "  {indent}    {}", one_change(&change));
            }
        }
        place = if is_whole { pair.end as usize } else { place + 1 };
    }
}

fn line(event: &Event) -> String {
    let row = row(event);
    let gap = if row.numbers.is_empty() { "" } else { "   " };
    format!("{} {}{gap}{}", row.icon, row.label, row.numbers)
}
