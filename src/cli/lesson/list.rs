//! `rayscope lesson list`: the lessons of the course.

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::lesson::Lesson;
use crate::lesson_folder::Lessons;
use clap::{Args, ValueEnum};
use serde::Serialize;

/// List the lessons of the course, or of a folder
#[derive(Args, Debug)]
pub struct List {
    /// A folder of lessons [default: the course that comes with the program]
    #[arg(value_name = "DIR")]
    folder: Option<String>,
    /// How to list them
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    /// A table
    Text,
    /// A JSON array of {"id", "title", "section", "steps", "questions"}
    Json,
}

#[derive(Serialize)]
struct Listed<'a> {
    id: &'a str,
    title: &'a str,
    section: &'a str,
    steps: usize,
    questions: usize,
    minutes: u32,
    needs: Vec<&'a str>,
}

impl List {
    /// Prints the list.
    pub fn run(&self) -> Result<(), Failure> {
        let lessons = match &self.folder {
            Some(folder) => Lessons::named(folder).map_err(Failure::usage)?,
            None => Lessons::embedded(),
        };
        let listed: Vec<Listed> = lessons.course.lessons.iter().map(listed).collect();
        let text = match self.format {
            Format::Text => table(&listed),
            Format::Json => {
                serde_json::to_string_pretty(&listed).map_err(|error| Failure::refused(error.to_string()))? + "\n"
            }
        };
        Output::Standard.write(text.as_bytes())
    }
}

fn listed(lesson: &Lesson) -> Listed<'_> {
    let header = &lesson.header;
    Listed {
        id: &lesson.id,
        title: &header.title,
        section: &header.section.value,
        steps: lesson.steps.len(),
        questions: lesson.questions().count(),
        minutes: header.minutes.value,
        needs: header.needs.iter().map(|need| need.value.as_str()).collect(),
    }
}

fn table(lessons: &[Listed]) -> String {
    let width = |text: fn(&Listed) -> usize| lessons.iter().map(text).max().unwrap_or(0);
    let (ids, sections) = (width(|l| l.id.chars().count()), width(|l| l.section.len()));
    let row = |l: &Listed| {
        format!(
            "{:ids$}  § {:sections$}  {:>2} min  {:>2} steps  {:>2} questions  {}\n",
            l.id, l.section, l.minutes, l.steps, l.questions, l.title
        )
    };
    lessons.iter().map(row).collect()
}
