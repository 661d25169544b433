//! A page that is being written, and what it gathers on the way.

use super::BookFile;
use super::colours::Colours;
use super::search::Entry;
use super::workbench::Workbench;
use crate::lesson::{Course, Finding};
use crate::view::{Formula, SharedLetters, escaped};
use std::fmt;

/// A page that is being written.
pub struct Page<'a> {
    /// The lessons and terms that it may lead to.
    pub course: &'a Course,
    /// The way from its folder to the root of the book.
    pub root: &'static str,
    /// Where its links to the workbench lead.
    pub workbench: Workbench,
    /// What is written of it.
    pub body: String,
    /// The letters of its formulas.
    pub letters: SharedLetters,
    /// The colours of its drawings.
    pub colours: Colours,
    /// What can be found on it.
    pub entries: Vec<Entry>,
    /// Terms of the glossary that it links to.
    pub terms: Vec<String>,
    /// What is wrong with what it shows.
    pub findings: Vec<Finding>,
    /// Files that belong to it.
    pub files: Vec<BookFile>,
}

impl<'a> Page<'a> {
    /// An empty page.
    pub fn new(course: &'a Course, root: &'static str, workbench: Workbench) -> Self {
        Self {
            course,
            root,
            workbench,
            body: String::new(),
            letters: SharedLetters::default(),
            colours: Colours::default(),
            entries: Vec::new(),
            terms: Vec::new(),
            findings: Vec::new(),
            files: Vec::new(),
        }
    }

    /// Adds HTML.
    pub fn put(&mut self, html: impl fmt::Display) {
        use fmt::Write as _;
        // Writing to a string does not fail.
        let _ = write!(self.body, "{html}");
    }

    /// A formula. One that cannot be set is shown as it was written, and told among the findings by the check of lessons.
    pub fn formula(&mut self, latex: &str, display: bool) -> String {
        match Formula::typeset(latex, display) {
            Ok(formula) if display => {
                let svg = formula.svg_sharing(&mut self.letters);
                format!("<div class=\"formula-line\" tabindex=\"0\">{svg}</div>\n")
            }
            Ok(formula) => formula.svg_sharing(&mut self.letters),
            Err(_) => format!("<code class=\"latex\">{}</code>", escaped(latex)),
        }
    }
}

/// Text of several lines with what means something in HTML written as entities.
pub fn escaped_lines(text: &str) -> String {
    text.lines().map(|line| escaped(line) + "\n").collect()
}
