//! What a student has done: kept on the student's own machine, and written out only when asked for.

use super::question::Answer;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The name and version of the format.
const FORMAT: &str = "rayscope-progress/1";

/// What was done of each lesson.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Progress {
    /// By the names of the lessons.
    #[serde(default)]
    pub lessons: BTreeMap<String, LessonProgress>,
}

/// What was done of one lesson.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LessonProgress {
    /// The step that was last looked at, counted from 0.
    #[serde(default)]
    pub step: usize,
    /// The furthest step that was looked at.
    #[serde(default)]
    pub furthest: usize,
    /// Whether its last step was left with its questions answered or skipped.
    #[serde(default)]
    pub finished: bool,
    /// What was answered, by the number of the question in the lesson, counted from 0.
    #[serde(default)]
    pub answers: BTreeMap<usize, Record>,
}

/// What was answered to one question.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// How often it was answered.
    #[serde(default)]
    pub tries: u32,
    /// Whether it was answered rightly.
    #[serde(default)]
    pub solved: bool,
    /// Whether the answer was shown before that.
    #[serde(default)]
    pub revealed: bool,
    /// How many hints were looked at.
    #[serde(default)]
    pub hints: usize,
    /// The last answer, where it can be written down: not of clicks and changes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub last: Option<Answer>,
    /// The wrong answers that were expected and given, counted from 0.
    #[serde(default)]
    pub misconceptions: Vec<usize>,
}

#[derive(Serialize, Deserialize)]
struct File {
    format: String,
    /// Not flattened: the numbers of questions would then be read as texts, and refused.
    #[serde(default)]
    lessons: BTreeMap<String, LessonProgress>,
}

impl Progress {
    /// What is known of a lesson, to be changed.
    pub fn of(&mut self, lesson: &str) -> &mut LessonProgress {
        self.lessons.entry(lesson.to_owned()).or_default()
    }

    /// As it is written to a file.
    #[must_use]
    pub fn to_json(&self) -> String {
        let file = File { format: FORMAT.to_owned(), lessons: self.lessons.clone() };
        // Names and numbers cannot fail to be written.
        serde_json::to_string_pretty(&file).unwrap_or_default() + "\n"
    }

    /// Reads what [`Self::to_json`] wrote.
    ///
    /// # Errors
    /// Where in the text it is something else.
    pub fn read(text: &str) -> Result<Self, String> {
        let file: File =
            serde_json::from_str(text).map_err(|error| format!("this is no record of progress: {error}"))?;
        if file.format != FORMAT {
            return Err(format!("the format is `{}`, and `{FORMAT}` can be read", file.format));
        }
        Ok(Self { lessons: file.lessons })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_done_survives_being_written_and_read() {
        let mut progress = Progress::default();
        let lesson = progress.of("06_cube");
        (lesson.step, lesson.furthest) = (2, 3);
        lesson
            .answers
            .insert(1, Record { tries: 2, solved: true, last: Some(Answer::Number(3.25)), ..Record::default() });
        assert_eq!(Progress::read(&progress.to_json()), Ok(progress));
    }

    #[test]
    fn another_file_is_refused_with_what_was_read() {
        let error = Progress::read("{\"format\": \"rayscope-trace/1\"}").expect_err("it is another format");
        assert!(error.contains("rayscope-trace/1"), "{error}");
    }
}
