//! The comparison with a foreign ray tracer in words.

use super::check::Check;
use super::report::{Comparison, ForeignDeparture, Place, StoryComparison};
use crate::compare::{Change, Said};

/// Causes that are told of a departure.
const TOLD: usize = 4;

/// The comparison as text.
#[must_use]
pub fn comparison_text(comparison: &Comparison) -> String {
    let mut text = String::new();
    for note in &comparison.notes {
        text += &format!("note: {note}\n");
    }
    let departing: Vec<&StoryComparison> =
        comparison.stories.iter().filter(|story| story.departure.is_some()).collect();
    let stories = count(comparison.stories.len(), "story", "stories");
    let numbers = count(comparison.checks(), "thing", "things");
    if departing.is_empty() {
        text += &format!("no difference in {stories}: {numbers} compared\n");
        return text;
    }
    text += &format!("{} of {stories} depart; {numbers} compared\n", departing.len());
    if departing.len() > 1
        && let Some((cause, explains)) = comparison.verdict().first()
    {
        text += &format!("explains {explains} of them: {} [{}]\n", cause.says, cause.id);
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
    *text += &format!("{} (line {}): {holding}, {} not\n", story.place.words(), story.line, story.departing);
    *text += &format!("  first departure: line {}, {} of the {}\n", check.line, check.subject.words(), departure.ray);
    *text += &format!("  at event {}: {}\n", check.event, departure.event);
    let [ours, theirs] = check.texts();
    *text += &format!("    ours:   {ours}\n    theirs: {theirs}\n");
    if check.off.is_finite() {
        let [off, allowed] = [check.off, check.allowed].map(|x| crate::view::significant(x, 2));
        *text += &format!("    they lie {off} apart; {allowed} is allowed\n");
    }
    if departure.causes.is_empty() {
        *text += "  no known mistake explains it\n";
    }
    for (number, explanation) in departure.causes.iter().take(TOLD).enumerate() {
        let head = if number == 0 { "likely cause" } else { "or" };
        *text += &format!("  {head}: {} [{}]\n", explanation.cause.says, explanation.cause.id);
        *text += &format!("    evidence: {}\n", explanation.evidence);
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
