//! `rayscope lesson check`: runs lessons, and says what is wrong with them.

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::progress::{stopped_by_ctrl_c, with_bar};
use crate::lesson::{Scenes, check_course, check_lesson};
use crate::lesson_folder::Lessons;
use clap::Args;
use std::fmt::Write;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Run every step, value, claim and answer of lessons, and say what is wrong
#[derive(Args, Debug)]
pub struct Check {
    /// A folder of lessons, one lesson's folder, or a lesson's name [default: the course that comes with the program]
    #[arg(value_name = "DIR")]
    folder: Option<String>,
}

impl Check {
    /// Checks; what is wrong is printed with file, line and column.
    pub fn run(&self) -> Result<(), Failure> {
        let lessons = match &self.folder {
            Some(folder) => Lessons::named(folder).map_err(Failure::usage)?,
            None => Lessons::embedded(),
        };
        let checked = match &lessons.chosen {
            Some(id) => {
                let mut checked = lessons
                    .course
                    .lesson(id)
                    .map_or_else(Default::default, |lesson| check_lesson(lesson, &Scenes::default(), &lessons.shelf));
                checked
                    .findings
                    .extend(lessons.course.findings.iter().filter(|finding| finding.file.contains(id)).cloned());
                checked.findings.sort();
                checked.findings.dedup();
                checked
            }
            None => {
                let progress = stopped_by_ctrl_c();
                let done = AtomicUsize::new(0);
                let total = lessons.course.lessons.len();
                let checked = with_bar(
                    total,
                    || done.load(Ordering::Relaxed),
                    || {
                        check_course(&lessons.course, &lessons.shelf, &mut |number, _| {
                            done.store(number, Ordering::Relaxed);
                            !progress.cancelled()
                        })
                    },
                );
                if progress.cancelled() {
                    return Err(Failure::interrupted("interrupted: not all lessons were checked"));
                }
                checked
            }
        };
        let mut text = String::new();
        for finding in &checked.findings {
            let _ = writeln!(text, "{finding}");
        }
        let count = if lessons.chosen.is_some() { 1 } else { lessons.course.lessons.len() };
        let of = if count == 1 { "1 lesson".to_owned() } else { format!("{count} lessons") };
        let _ = writeln!(
            text,
            "{of}: {} values, {} claims and {} answers checked; {}",
            checked.values,
            checked.claims,
            checked.answers,
            match checked.findings.len() {
                0 => "everything holds".to_owned(),
                1 => "1 thing is wrong".to_owned(),
                wrong => format!("{wrong} things are wrong"),
            }
        );
        Output::Standard.write(text.as_bytes())?;
        if checked.findings.is_empty() { Ok(()) } else { Err(Failure::differs()) }
    }
}
