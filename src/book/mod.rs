//! The course as a book: a static site that reads well with no program running, and a lesson as a PDF.
//!
//! Everything here makes bytes and writes nothing; the command line puts them into files. A page asks for nothing from outside the
//! book, and says everything without its script. The same lessons give the same bytes.

mod colours;
mod drawings;
mod examples;
mod frame;
mod glossary;
mod index;
mod lesson;
mod links;
mod map;
mod page;
mod picture;
mod print;
mod prose;
mod questions;
mod search;
mod sections;
mod step;
mod workbench;
mod worked_example;

pub use print::lesson_pdf;

use crate::lesson::model::Lesson;
use crate::lesson::{Course, Finding, Shelf};
use examples::{Example, all_examples};
use page::Page;
use picture::Pictures;
use search::Entry;
use workbench::Workbench;

/// What is made, and how large.
#[derive(Clone, Debug)]
pub struct BookOptions {
    /// The width of rendered pictures in pixels.
    pub picture_width: u32,
    /// How many worked examples there are at most.
    pub most_examples: usize,
    /// The folder of the workbench's pages, as seen from the root of the book or in full, if there are any: steps come alive there.
    pub workbench: Option<String>,
}

impl Default for BookOptions {
    fn default() -> Self {
        Self { picture_width: PICTURE_WIDTH, most_examples: usize::MAX, workbench: None }
    }
}

/// Smaller pictures do not show what a ray hits; larger ones take a minute each where a scene is costly.
const PICTURE_WIDTH: u32 = 320;

/// A file of the book.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BookFile {
    /// Its path from the root of the book, with `/` between its parts.
    pub path: String,
    /// What it holds.
    pub bytes: Vec<u8>,
}

/// A part of the book, made at a time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// What it is called.
    pub title: String,
    kind: LeafKind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LeafKind {
    Style,
    Lesson(usize),
    Example(usize),
    Examples,
    Glossary,
    Sections,
    Search,
    Index,
}

/// A book in the making.
pub struct Book<'a> {
    course: &'a Course,
    shelf: &'a dyn Shelf,
    examples: Vec<Example>,
    pictures: Pictures,
    workbench: Workbench,
    /// What can be searched for, as the pages that were made hold it.
    entries: Vec<Entry>,
    findings: Vec<Finding>,
}

impl<'a> Book<'a> {
    /// The book of a course.
    #[must_use]
    pub fn new(course: &'a Course, shelf: &'a dyn Shelf, options: &BookOptions) -> Self {
        let mut examples = all_examples();
        examples.truncate(options.most_examples);
        let pictures = Pictures::new(options.picture_width);
        let workbench = Workbench::at(options.workbench.as_deref());
        Self { course, shelf, examples, pictures, workbench, entries: Vec::new(), findings: course.findings.clone() }
    }

    /// All parts, in the order in which they are to be made: the search and the contents are about those before.
    #[must_use]
    pub fn leaves(&self) -> Vec<Leaf> {
        let leaf = |title: &str, kind| Leaf { title: title.to_owned(), kind };
        let mut leaves = vec![leaf("style and fonts", LeafKind::Style)];
        let lessons = self.course.lessons.iter().enumerate();
        leaves.extend(lessons.map(|(place, lesson)| leaf(&lesson.header.title, LeafKind::Lesson(place))));
        leaves.push(leaf("Glossary", LeafKind::Glossary));
        let examples = self.examples.iter().enumerate();
        leaves.extend(examples.map(|(place, example)| leaf(&example.title(), LeafKind::Example(place))));
        leaves.push(leaf("Worked examples", LeafKind::Examples));
        leaves.push(leaf("Sections", LeafKind::Sections));
        leaves.push(leaf("Search", LeafKind::Search));
        leaves.push(leaf("Contents", LeafKind::Index));
        leaves
    }

    /// Makes a part of the book.
    pub fn make(&mut self, leaf: &Leaf) -> Vec<BookFile> {
        match leaf.kind {
            LeafKind::Style => frame::files(),
            LeafKind::Lesson(place) => lesson::files(self, place),
            LeafKind::Example(place) => worked_example::files(self, place),
            LeafKind::Examples => vec![examples::list(self)],
            LeafKind::Glossary => vec![glossary::file(self)],
            LeafKind::Sections => vec![sections::file(self)],
            LeafKind::Search => search::files(self),
            LeafKind::Index => vec![index::file(self)],
        }
    }

    /// What is wrong with the lessons, as far as pages were made: what has no value is left out of them.
    #[must_use]
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// A page at the root of the book.
    fn page(&self) -> Page<'a> {
        Page::new(self.course, "", self.workbench.clone())
    }

    /// A page in a folder of the book.
    fn page_in_folder(&self) -> Page<'a> {
        Page::new(self.course, "../", self.workbench.clone())
    }

    /// Keeps what was found while a page was made.
    fn keep(&mut self, page: &mut Page) {
        self.findings.append(&mut page.findings);
        self.entries.append(&mut page.entries);
    }
}

/// The path of a lesson's page from the root.
fn lesson_path(id: &str) -> String {
    format!("lessons/{}.html", links::slug(id))
}

/// The number that a lesson's folder begins with, as it is shown: `6` of `06_cube`; none where there is none.
fn number_of(lesson: &Lesson) -> String {
    let digits: String = lesson.id.chars().take_while(char::is_ascii_digit).collect();
    digits.trim_start_matches('0').to_owned()
}

/// `6 The cube and its plane table`.
fn numbered_title(lesson: &Lesson) -> String {
    format!("{} {}", number_of(lesson), lesson.header.title).trim().to_owned()
}
