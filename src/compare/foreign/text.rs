//! The comparison with a foreign ray tracer in words.

use super::check::Check;
use super::report::{Comparison, ForeignDeparture, Place, StoryComparison};
use crate::compare::{Change, Said};
use std::fmt::Write as _;

/// Causes that are told of a departure.
const TOLD: usize = 4;

/// The comparison as text.
#[must_use]
pub fn comparison_text(comparison: &Comparison) -> String {
    let mut text = String::new();
    for note in &comparison.notes {
        let _ = writeln!(text, "note: {note}");
    }
    let departing: Vec<&StoryComparison> =
        comparison.stories.iter().filter(|story| story.departure.is_some()).collect();
    let stories = count(comparison.stories.len(), "story", "stories");
    let numbers = count(comparison.checks(), "thing", "things");
    if departing.is_empty() {
        let _ = writeln!(text, "no difference in {stories}: {numbers} compared");
        return text;
    }
    let _ = writeln!(text, "{} of {stories} depart; {numbers} compared", departing.len());
    if departing.len() > 1
        && let Some((cause, explains)) = comparison.verdict().first()
    {
        let _ = writeln!(text, "explains {explains} of them: {} [{}]", cause.says, cause.id);
    }
    for story in departing {
        if let Some(departure) = &story.departure {
            text.push('\n');
            put_departure(&mut text, story, departure);
        }
    }
    text
}

fn put_departure(text: &mut String, story: &StoryComparison, departure: &ForeignDeparture) {
    let check = &departure.check;
    let holding = count(story.checks - story.departing, "thing agrees", "things agree");
    let _ = writeln!(text, "{} (line {}): {holding}, {} not", story.place.words(), story.line, story.departing);
    let _ =
        writeln!(text, "  first departure: line {}, {} of the {}", check.line, check.subject.words(), departure.ray);
    let _ = writeln!(text, "  at event {}: {}", check.event, departure.event);
    let [ours, theirs] = check.texts();
    let _ = writeln!(text, "    ours:   {ours}\n    theirs: {theirs}");
    if check.off.is_finite() {
        let [off, allowed] = [check.off, check.allowed].map(|x| crate::view::significant(x, 2));
        let _ = writeln!(text, "    they lie {off} apart; {allowed} is allowed");
    }
    if departure.causes.is_empty() {
        *text += "  no known mistake explains it\n";
    }
    for (number, explanation) in departure.causes.iter().take(TOLD).enumerate() {
        let head = if number == 0 { "likely cause" } else { "or" };
        let _ = writeln!(text, "  {head}: {} [{}]", explanation.cause.says, explanation.cause.id);
        let _ = writeln!(text, "    evidence: {}", explanation.evidence);
    }
}

impl Check {
    /// Ours and theirs as people read them.
    #[must_use]
    pub fn texts(&self) -> [String; 2] {
        let [left, right] = [&self.ours, &self.theirs].map(|said| Some(none_in_words(said)));
        Change { name: String::new(), left, right }.texts()
    }
}

/// Numbers that are none stand for nothing there.
fn none_in_words(said: &Said) -> Said {
    match said {
        Said::Numbers(numbers) if numbers.is_empty() || numbers.iter().all(|x| x.is_nan()) => {
            Said::Words("none".to_owned())
        }
        other => other.clone(),
    }
}

impl Place {
    /// `pixel (3, 4)`.
    #[must_use]
    pub fn words(&self) -> String {
        match self {
            Self::Pixel([x, y]) => format!("pixel ({x}, {y})"),
            Self::Ray(_) => "a given ray".to_owned(),
        }
    }
}

fn count(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}
