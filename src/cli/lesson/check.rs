//! `rayscope lesson check`: runs lessons, and says what is wrong with them.

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::progress::{stopped_by_ctrl_c, with_bar};
use crate::lesson::{Checked, check_course, check_in_course};
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
        let (checked, count) = match &lessons.chosen {
            Some(id) => (one(&lessons, id), 1),
            None => (all(&lessons)?, lessons.course.lessons.len()),
        };
        Output::Standard.write(written(&checked, count).as_bytes())?;
        if checked.findings.is_empty() { Ok(()) } else { Err(Failure::differs()) }
    }
}

/// One lesson, with its links and what it needs.
fn one(lessons: &Lessons, id: &str) -> Checked {
    match lessons.course.lesson(id) {
        Some(lesson) => check_in_course(lesson, &lessons.course, &lessons.shelf),
        None => Checked { findings: lessons.course.findings.clone(), ..Checked::default() },
    }
}

/// All lessons, with a bar.
fn all(lessons: &Lessons) -> Result<Checked, Failure> {
    let progress = stopped_by_ctrl_c();
    let done = AtomicUsize::new(0);
    let mut watch = |number: usize, _: usize| {
        done.store(number, Ordering::Relaxed);
        !progress.cancelled()
    };
    let work = || check_course(&lessons.course, &lessons.shelf, &mut watch);
    let checked = with_bar(lessons.course.lessons.len(), || done.load(Ordering::Relaxed), work);
    if progress.cancelled() {
        return Err(Failure::interrupted("interrupted: not all lessons were checked"));
    }
    Ok(checked)
}

fn written(checked: &Checked, count: usize) -> String {
    let mut text = String::new();
    for finding in &checked.findings {
        let _ = writeln!(text, "{finding}");
    }
    let lessons = if count == 1 { "1 lesson".to_owned() } else { format!("{count} lessons") };
    let outcome = match checked.findings.len() {
        0 => "everything holds".to_owned(),
        1 => "1 thing is wrong".to_owned(),
        wrong => format!("{wrong} things are wrong"),
    };
    let Checked { values, claims, answers, .. } = checked;
    let _ = writeln!(text, "{lessons}: {values} values, {claims} claims and {answers} answers checked; {outcome}");
    text
}
