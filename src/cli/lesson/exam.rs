//! `rayscope lesson exam`: questions on paper, and the teacher's sheet.

use super::written::{Answers, prose_text, question_text, table_text};
use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::lesson::{Before, Exam as Drawn, Scenes};
use crate::lesson_folder::Lessons;
use clap::Args;
use std::fmt::Write;
use std::path::PathBuf;

/// Draw an examination: questions of the course about rays that follow from a seed
#[derive(Args, Debug)]
pub struct Exam {
    /// The lessons to ask about [default: all]
    #[arg(value_name = "LESSON")]
    lessons: Vec<String>,
    /// A folder of lessons [default: the course that comes with the program]
    #[arg(long, value_name = "DIR")]
    from: Option<String>,
    /// What the questions, their rays and the order of choices follow from
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// How many questions
    #[arg(long, default_value_t = 10)]
    count: usize,
    /// Print the teacher's sheet: the same questions with their answers
    #[arg(long)]
    answers: bool,
    /// Where to write it [default: the standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Exam {
    /// Prints the questions.
    pub fn run(&self) -> Result<(), Failure> {
        let lessons = match &self.from {
            Some(folder) => Lessons::named(folder).map_err(Failure::usage)?,
            None => Lessons::embedded(),
        };
        if let Some(id) = self.lessons.iter().find(|id| lessons.course.lesson(id).is_none()) {
            return Err(Failure::usage(format!("there is no lesson {id}: `rayscope lesson list` lists them")));
        }
        let output = Output::create(self.output.as_deref())?;
        let ids: Vec<&str> = self.lessons.iter().map(String::as_str).collect();
        let scenes = Scenes::default();
        let exam = Drawn::draw(&lessons.course, &ids, self.count, self.seed, &scenes, &lessons.shelf);
        let sheet = if self.answers { "Answers" } else { "Questions" };
        let mut text = format!("# {sheet}: examination {}\n\n", exam.seed);
        for (number, question) in exam.questions.iter().enumerate() {
            let aim = question.stage.aim_in_words();
            let _ = writeln!(text, "## {}. {}\n\n{aim}.\n", number + 1, question.step);
            for before in &question.before {
                text.push_str(&match before {
                    Before::Prose(prose) => prose_text(prose),
                    Before::Table(table) => table_text(&table.head, &table.rows),
                });
            }
            text.push_str(&question_text(&question.posed, if self.answers { Answers::Shown } else { Answers::Hidden }));
            text.push('\n');
        }
        output.write(text.as_bytes())
    }
}
