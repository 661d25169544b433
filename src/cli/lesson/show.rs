//! `rayscope lesson show`: a lesson as text.

use super::written::{Answers, lesson_text};
use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::lesson::Scenes;
use crate::lesson_folder::Lessons;
use clap::Args;
use std::fmt::Write;

/// Print a lesson as text, its values put in
#[derive(Args, Debug)]
pub struct Show {
    /// A lesson's name, its folder or its file
    #[arg(value_name = "LESSON")]
    lesson: String,
    /// Print the answers, too, and what is said of wrong ones
    #[arg(long)]
    answers: bool,
}

impl Show {
    /// Prints the lesson.
    pub fn run(&self) -> Result<(), Failure> {
        let lessons = Lessons::named(&self.lesson).map_err(Failure::usage)?;
        let ids: Vec<String> = match &lessons.chosen {
            Some(id) => vec![id.clone()],
            None => lessons.course.lessons.iter().map(|lesson| lesson.id.clone()).collect(),
        };
        let answers = if self.answers { Answers::Shown } else { Answers::Hidden };
        let mut text = String::new();
        for finding in &lessons.course.findings {
            let _ = writeln!(text, "{finding}");
        }
        for lesson in ids.iter().filter_map(|id| lessons.course.lesson(id)) {
            text.push_str(&lesson_text(lesson, answers, &Scenes::default(), &lessons.shelf));
        }
        Output::Standard.write(text.as_bytes())
    }
}
