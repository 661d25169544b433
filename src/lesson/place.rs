//! Places in a lesson's file, and what is wrong there.

use super::prose::Target;
use std::fmt;

/// A line and a column, counted from 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// The line.
    pub line: usize,
    /// The column, in characters.
    pub column: usize,
}

impl Place {
    /// The place of a byte of a text.
    #[must_use]
    pub fn of(text: &str, offset: usize) -> Self {
        let before = text.get(..offset).unwrap_or(text);
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        Self { line: before.matches('\n').count() + 1, column: before[line_start..].chars().count() + 1 }
    }
}

/// Something that is wrong with a lesson.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Finding {
    /// The file, as it was named.
    pub file: String,
    /// Where.
    pub place: Place,
    /// What is wrong, and what to do.
    pub message: String,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Place { line, column } = self.place;
        write!(f, "{}:{line}:{column}: {}", self.file, self.message)
    }
}

/// What is found wrong while one file is read or checked.
#[derive(Debug)]
pub struct Findings<'a> {
    file: &'a str,
    text: &'a str,
    list: Vec<Finding>,
    links: Vec<(Target, Place)>,
}

impl<'a> Findings<'a> {
    /// None yet, of a file with this text.
    #[must_use]
    pub const fn new(file: &'a str, text: &'a str) -> Self {
        Self { file, text, list: Vec::new(), links: Vec::new() }
    }

    /// Adds one at a byte of the text.
    pub fn add(&mut self, offset: usize, message: impl Into<String>) {
        self.add_at(Place::of(self.text, offset), message);
    }

    /// Adds one at a place.
    pub fn add_at(&mut self, place: Place, message: impl Into<String>) {
        self.list.push(Finding { file: self.file.to_owned(), place, message: message.into() });
    }

    /// Keeps a link, to be followed once everything is read.
    pub fn keep_link(&mut self, offset: usize, target: Target) {
        self.links.push((target, self.place(offset)));
    }

    /// The links, in the order in which they were met.
    pub fn take_links(&mut self) -> Vec<(Target, Place)> {
        std::mem::take(&mut self.links)
    }

    /// Whether nothing is wrong so far.
    #[must_use]
    pub fn is_clean(&self) -> bool {
        self.list.is_empty()
    }

    /// The place of a byte of the text.
    #[must_use]
    pub fn place(&self, offset: usize) -> Place {
        Place::of(self.text, offset)
    }

    /// All of them, in the order of the file.
    #[must_use]
    pub fn sorted(mut self) -> Vec<Finding> {
        self.list.sort();
        self.list.dedup();
        self.list
    }
}
