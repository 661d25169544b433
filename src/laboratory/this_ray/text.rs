//! One ray by every method, for reading.

use super::{OutlineRow, Story, ThisRay, Told};
use crate::laboratory::Timing;
use crate::view::{brief, row};
use std::fmt::Write;

/// Losses from here on are marked.
pub const MARKED: f64 = 1.0;

/// The losses of a method that are listed, largest first.
const LISTED: usize = 4;

/// Columns of the outline's events; longer labels are cut.
const LABELS: usize = 58;

/// Columns of a method in the outline.
const CELL: usize = 13;

/// The report: what each method takes and has right, the tree, and where digits were lost.
#[must_use]
pub fn this_ray_text(ray: &ThisRay, timings: Option<&[Timing]>) -> String {
    let mut text = String::new();
    put_methods(&mut text, ray, timings);
    put_outline(&mut text, ray);
    put_losses(&mut text, ray);
    text
}

fn put_methods(text: &mut String, ray: &ThisRay, timings: Option<&[Timing]>) {
    let _ = writeln!(text, "{:<14} {:>17} {:>9} {:>7}  verdict", "method", "ns per ray", "hit time", "colour");
    for (k, story) in ray.stories.iter().enumerate() {
        let time = timings.and_then(|timings| timings.get(k)).map_or_else(|| "–".to_owned(), nanoseconds);
        let hit = story.hit_digits().map_or_else(|| "–".to_owned(), digits);
        let colour = digits(story.colour_digits(&ray.exact));
        let (name, verdict) = (story.method.name(), story.verdict(&ray.exact));
        let _ = writeln!(text, "{name:<14} {time:>17} {hit:>9} {colour:>7}  {verdict}");
    }
}

/// The median and half the distance between the quartiles, or why not.
#[must_use]
pub fn nanoseconds(timing: &Timing) -> String {
    match timing.noise {
        None => format!("{} ± {}", brief_nanoseconds(timing.seconds), brief_nanoseconds(timing.spread)),
        Some(noise) => noise.describe(),
    }
}

fn brief_nanoseconds(seconds: f64) -> String {
    format!("{:.0}", seconds * 1e9)
}

/// Digits right, with one place behind the point.
#[must_use]
pub fn digits(right: f64) -> String {
    if right.is_finite() { format!("{right:.1}") } else { "all".to_owned() }
}

fn put_outline(text: &mut String, ray: &ThisRay) {
    let _ = write!(text, "\n{:<LABELS$}", "Digits right of the worst number of each event");
    for story in &ray.stories {
        let _ = write!(text, "{:>CELL$}", story.method.name());
    }
    text.push('\n');
    for row in ray.outline() {
        put_row(text, &row);
    }
    text.push_str("all: no digit is wrong. ↓: so many digits are lost in this event. –: the event is missing.\n");
}

fn put_row(text: &mut String, outlined: &OutlineRow) {
    let label = format!("{}{}", "  ".repeat(outlined.depth), row(outlined.event).label);
    let mut cut: String = label.chars().take(LABELS - 2).collect();
    if cut.len() < label.len() {
        cut.pop();
        cut.push('…');
    }
    let _ = write!(text, "{cut:<LABELS$}");
    for told in &outlined.by_method {
        let _ = write!(text, "{:>CELL$}", told.map_or_else(|| "–".to_owned(), |(_, told)| cell(told)));
    }
    while text.ends_with(' ') {
        text.pop();
    }
    text.push('\n');
}

fn cell(told: &Told) -> String {
    let lost = if told.lost >= MARKED { format!(" ↓{:<4.1}", told.lost) } else { " ".repeat(6) };
    told.right.map_or_else(String::new, |right| format!("{}{lost}", digits(right)))
}

fn put_losses(text: &mut String, ray: &ThisRay) {
    text.push_str("\nWhere digits were lost\n");
    for story in &ray.stories {
        let losses = story.losses(MARKED);
        if losses.is_empty() {
            let _ = writeln!(text, "{:<14} nowhere as much as one", story.method.name());
        }
        for (k, &event) in losses.iter().take(LISTED).enumerate() {
            let name = if k == 0 { story.method.name() } else { "" };
            let told = &story.told[event as usize];
            let number = told.worst().map(|number| number_in_words(&number.name, &number.parts, number.error));
            let label = row(story.tree.event(event)).label;
            let _ = writeln!(text, "{name:<14} {:>4.1} in {label}: {}", told.lost, number.unwrap_or_default());
        }
        if losses.len() > LISTED {
            let _ = writeln!(text, "{:<14}      and in {} other events", "", losses.len() - LISTED);
        }
    }
}

fn number_in_words(name: &str, parts: &[f64], error: f64) -> String {
    let numbers: Vec<_> = parts.iter().map(|&x| brief(x)).collect();
    let value = if let [one] = &numbers[..] { one.clone() } else { format!("({})", numbers.join(", ")) };
    format!("{name} = {value}, off by {}", brief_error(error))
}

/// Errors are told to two digits.
fn brief_error(error: f64) -> String {
    format!("{error:.1e}")
}

impl Story {
    /// What became of the ray by this method, in words.
    #[must_use]
    pub fn verdict(&self, exact: &crate::trace::RayTree) -> String {
        if let Some(parting) = &self.parting {
            let place = row(self.tree.event(parting.event)).label;
            let differs = self.tree.colour() != exact.colour();
            let consequence = if differs { "another colour" } else { "the same colour" };
            return format!("goes another way: {} ({place}); {consequence}", parting.reason);
        }
        let digits = self.colour_digits(exact);
        if digits.is_finite() {
            "goes the exact way".to_owned()
        } else {
            "goes the exact way, to the same colour".to_owned()
        }
    }
}
