//! One ray by every method, for reading.

use super::{OutlineRow, Story, ThisRay, Told};
use crate::laboratory::Timing;
use crate::record::{EventId, What};
use crate::trace::RayTree;
use crate::view::{brief, indent, row};
use std::fmt::Write;

/// Losses from here on are marked.
const MARKED: f64 = 1.0;

/// The losses of a method that are listed, largest first.
const LISTED: usize = 4;

/// Columns of the outline's events; longer labels are cut.
const LABELS: usize = 58;

/// Columns of a method in the outline.
const CELL: usize = 15;

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
    if let Some(timings) = timings {
        put_noise(text, ray, timings);
    }
}

/// The median and half the distance between the quartiles, where the median is not lost in noise.
fn nanoseconds(timing: &Timing) -> String {
    let nanoseconds = |seconds: f64| format!("{:.0}", seconds * 1e9);
    timing.told().map_or_else(
        || "noise".to_owned(),
        |median| format!("{} ± {}", nanoseconds(median), nanoseconds(timing.spread)),
    )
}

/// Of how many repeats the times are, and why some of them are not told.
fn put_noise(text: &mut String, ray: &ThisRay, timings: &[Timing]) {
    let repeats = timings.iter().map(|timing| timing.repeats).min().unwrap_or(0);
    let _ = writeln!(
        text,
        "Times are medians of {repeats} in turn, ± half the distance between the quartiles, on one thread."
    );
    for (story, timing) in ray.stories.iter().zip(timings) {
        if let Some(noise) = timing.noise {
            let _ = writeln!(text, "The time of {} is {}.", story.method.name(), noise.describe());
        }
    }
}

/// Digits right, with one place behind the point.
fn digits(right: f64) -> String {
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
    let label = format!("{}{}", indent(outlined.depth), row(outlined.event).label);
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
            let place = story.place(event);
            let _ = writeln!(text, "{name:<14} {:>4.1} in {}   ({place})", told.lost, number.unwrap_or_default());
        }
        if losses.len() > LISTED {
            let _ = writeln!(text, "{:<14}      and in {} other events", "", losses.len() - LISTED);
        }
    }
}

fn number_in_words(name: &str, parts: &[f64], error: f64) -> String {
    let numbers: Vec<_> = parts.iter().map(|&x| brief(x)).collect();
    let value = if let [one] = &numbers[..] { one.clone() } else { format!("({})", numbers.join(", ")) };
    // Errors are told to two digits.
    let error = format!("{error:.1e}").parse().map_or_else(|_| String::new(), brief);
    format!("{} = {value}, off by {error}", spoken(name))
}

/// The pixel as it is stored; none for a ray that is no pixel's.
fn written(tree: &RayTree) -> Option<[u8; 3]> {
    tree.events.iter().find_map(|event| if let What::Written { srgb, .. } = event.what { Some(srgb) } else { None })
}

/// `point of hit time 2` for `hit 2 point`.
fn spoken(name: &str) -> String {
    let words: Vec<&str> = name.split(' ').collect();
    match words[..] {
        ["hit", number, "t"] => format!("hit time {number}"),
        ["hit", number, what] => format!("{what} of hit time {number}"),
        _ => name.to_owned(),
    }
}

impl Story {
    /// An event in words, with the ray that it is about if that is not the camera's.
    #[must_use]
    pub fn place(&self, event: EventId) -> String {
        let label = row(self.tree.event(event)).label;
        let path = self.tree.path(event);
        let is_spawned = |what: &What| matches!(what, What::Ray { depth, .. } if *depth > 0);
        let rays = path.iter().rev().map(|&id| self.tree.event(id)).find(|event| is_spawned(&event.what));
        match rays.filter(|ray| ray.id != event) {
            Some(ray) => format!("{label}, {}", row(ray).label.to_lowercase()),
            None => label,
        }
    }

    /// What became of the ray by this method, in words.
    #[must_use]
    pub fn verdict(&self, exact: &RayTree) -> String {
        if let Some(parting) = &self.parting {
            let place = self.place(parting.event);
            let differs = self.tree.colour() != exact.colour();
            let consequence = if differs { "another colour" } else { "the same colour" };
            return format!("goes another way: {} ({place}); {consequence}", parting.reason);
        }
        let outcome = if !self.colour_digits(exact).is_finite() {
            "to the same colour"
        } else if written(&self.tree) == written(exact) {
            "to the same pixel"
        } else {
            "to another pixel"
        };
        format!("goes the exact way, {outcome}")
    }
}
