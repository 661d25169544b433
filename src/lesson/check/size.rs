//! How long a lesson and its steps may be, and how it ends.

use super::Check;
use crate::lesson::model::{Lesson, Part, QuestionKind, Step};
use crate::lesson::place::Place;
use crate::lesson::prose::words;

/// The minutes that a lesson may take: shorter ones have no room for a prediction and a change, longer ones are not finished.
const MINUTES: std::ops::RangeInclusive<u32> = 5..=15;
/// The most words of a step: about what fits beside a drawing.
const MOST_WORDS: usize = 220;
/// Words a minute: half the speed of a novel, because there are formulas.
const WORDS_A_MINUTE: f64 = 150.0;
/// Minutes that a question takes.
const MINUTES_A_QUESTION: f64 = 1.0;
/// How far the reckoned minutes may be from those of the header, as factors.
const FACTORS: [f64; 2] = [0.5, 1.5];

/// The sections of the syllabus.
pub const SECTIONS: [&str; 22] = [
    "6.1", "6.2", "6.2.1", "6.2.2", "6.2.3", "6.2.4", "6.3.0", "6.3.1", "6.3.2", "6.3.3", "6.3.4", "6.3.5", "6.3.6",
    "6.3.7", "6.3.8", "6.4", "6.4.1", "6.5", "6.5.1", "6.5.2", "6.5.3", "6.5.4",
];

impl Check<'_> {
    pub(super) fn sizes(&mut self) {
        let header = &self.lesson.header;
        let (section, minutes) = (header.section.clone(), header.minutes.clone());
        if !SECTIONS.contains(&section.value.as_str()) {
            self.add(
                section.place,
                format!("§ {} is no section of the syllabus: there are {}", section.value, SECTIONS.join(", ")),
            );
        }
        if !MINUTES.contains(&minutes.value) {
            self.add(minutes.place, "a lesson takes 5 to 15 minutes");
        }
        let reckoned = reckoned_minutes(self.lesson);
        let stated = f64::from(minutes.value);
        if reckoned < FACTORS[0] * stated || reckoned > FACTORS[1] * stated {
            let message = format!(
                "by its words and questions the lesson takes {reckoned:.1} minutes, which is too far from the {stated} of the header"
            );
            self.add(minutes.place, message);
        }
        for step in &self.lesson.steps {
            let count = words_of(step);
            if count > MOST_WORDS {
                self.add(
                    step.place,
                    format!("this step has {count} words, and {MOST_WORDS} at most are read: split it"),
                );
            }
        }
    }

    /// A lesson ends with something that the student makes.
    pub(super) fn ending(&mut self) {
        let Some(step) = self.lesson.steps.last() else { return };
        if !step.questions().any(|question| matches!(question.kind, QuestionKind::Edit(_))) {
            let place: Place = step.place;
            self.add(place, "the last step ends with a question of the kind `edit`: what the student changes");
        }
    }
}

fn words_of(step: &Step) -> usize {
    step.parts
        .iter()
        .map(|part| match part {
            Part::Prose(prose) => words(prose),
            Part::Slip(slip) => words(&slip.printed) + words(&slip.right),
            Part::Claims(_) | Part::Table(_) | Part::Question(_) => 0,
        })
        .sum()
}

/// The minutes that a lesson takes, by its words and its questions.
pub(super) fn reckoned_minutes(lesson: &Lesson) -> f64 {
    let read: usize = words(&lesson.opening) + lesson.steps.iter().map(words_of).sum::<usize>();
    read as f64 / WORDS_A_MINUTE + MINUTES_A_QUESTION * lesson.questions().count() as f64
}
