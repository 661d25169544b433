//! `rayscope book`: the course as a static site, or a lesson as a PDF.

use super::failure::{Failure, reason, warn};
use super::output::Output;
use super::progress::stop_on_ctrl_c;
use crate::book::{Book as Site, BookFile, BookOptions, lesson_pdf};
use crate::lesson::Finding;
use crate::lesson_folder::Lessons;
use clap::Args;
use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Write the course as a site that needs no program to read, or a lesson as a PDF
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope book -o book                           the course, the glossary and all worked examples
  rayscope book my_lessons -o my_book --no-examples    lessons of your own
  rayscope book -o dist/book --workbench ..       the course beside the workbench's pages, alive
  rayscope book --pdf 06_cube -o cube.pdf         one lesson to print

The site is plain files: open index.html from the disk, or put them on any server. Nothing in them asks for anything from elsewhere, and
all can be read without JavaScript. Ctrl-C ends after the page that is being made; pages are written whole or not at all.")]
pub struct Book {
    /// A folder of lessons [default: the course that comes with the program]
    #[arg(value_name = "LESSONS", conflicts_with = "pdf")]
    lessons: Option<String>,
    /// The folder to write to; with --pdf the file
    #[arg(short, long, value_name = "PATH")]
    output: PathBuf,
    /// Write this lesson as a PDF: its name, its folder or its file
    #[arg(long, value_name = "LESSON")]
    pdf: Option<String>,
    /// Where the workbench's pages are, as web/README.md builds them: a folder as seen from the book, such as `..`, or an address.
    /// Each step of a lesson can then be stepped through on its page
    #[arg(long, value_name = "FOLDER", conflicts_with = "pdf")]
    workbench: Option<String>,
    /// Leave out the worked examples of the scenes that come with the program
    #[arg(long, conflicts_with = "pdf")]
    no_examples: bool,
}

impl Book {
    /// Writes the book.
    pub fn run(&self) -> Result<(), Failure> {
        match &self.pdf {
            Some(lesson) => self.write_pdf(lesson),
            None => self.write_site(),
        }
    }

    fn write_pdf(&self, name: &str) -> Result<(), Failure> {
        let lessons = Lessons::named(name).map_err(Failure::usage)?;
        let chosen = lessons.chosen.as_deref().and_then(|id| lessons.course.lesson(id));
        let lesson = chosen.ok_or_else(|| Failure::usage(format!("{name} is not one lesson: name one to print")))?;
        let output = Output::create(Some(&self.output))?;
        let (bytes, findings) = lesson_pdf(&lessons.course, lesson, &lessons.shelf);
        output.write(&bytes)?;
        told(&findings)
    }

    fn write_site(&self) -> Result<(), Failure> {
        let lessons = match &self.lessons {
            Some(name) => Lessons::named(name).map_err(Failure::usage)?,
            None => Lessons::embedded(),
        };
        let most_examples = if self.no_examples { 0 } else { usize::MAX };
        let options = BookOptions { most_examples, workbench: self.workbench.clone(), ..BookOptions::default() };
        let mut site = Site::new(&lessons.course, &lessons.shelf, &options);
        let stopped = Arc::new(AtomicBool::new(false));
        let asked = Arc::clone(&stopped);
        stop_on_ctrl_c(move || asked.swap(true, Ordering::Relaxed));
        let leaves = site.leaves();
        for (place, leaf) in leaves.iter().enumerate() {
            if stopped.load(Ordering::Relaxed) {
                let message = format!("interrupted: {place} of {} parts are written", leaves.len());
                return Err(Failure::interrupted(message));
            }
            for file in site.make(leaf) {
                self.write(&file)?;
            }
            said(&format!("{} of {}  {}", place + 1, leaves.len(), leaf.title))?;
        }
        said(&format!("open {}", self.output.join("index.html").display()))?;
        told(site.findings())
    }

    fn write(&self, file: &BookFile) -> Result<(), Failure> {
        let path = self.output.join(&file.path);
        let folder = path.parent().unwrap_or(Path::new("."));
        fs::create_dir_all(folder).map_err(|error| {
            Failure::refused(format!("cannot make the folder {}: {}", folder.display(), reason(&error)))
        })?;
        Output::create(Some(&path))?.write(&file.bytes)
    }
}

fn said(line: &str) -> Result<(), Failure> {
    writeln!(io::stdout(), "{line}").map_err(|error| Failure::from_stdout(&error))
}

/// What is wrong with the lessons; the book is written all the same.
fn told(findings: &[Finding]) -> Result<(), Failure> {
    if findings.is_empty() {
        return Ok(());
    }
    for finding in findings {
        warn(&finding.to_string());
    }
    let count = findings.len();
    Err(Failure::refused(format!(
        "{count} places in the lessons are wrong, and left out: `rayscope lesson check` says more"
    )))
}
