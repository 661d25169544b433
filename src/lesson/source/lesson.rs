//! A whole file: header, opening, steps.

use super::blocks::{HeaderFile, SlipFile, StepFile, TableFile, Text};
use super::markdown::{self, parts, read_prose};
use crate::lesson::expression::{Expression, Format};
use crate::lesson::model::{Aim, Column, Header, Lesson, Part, Sited, Slip, Step, Table, first_line};
use crate::lesson::place::{Finding, Findings, Place};
use crate::lesson::prose::{Prose, Reference};
use serde::de::DeserializeOwned;
use std::ops::Range;

/// Reads a lesson. What could be understood is there, with all that is wrong; none where there is no header.
#[must_use]
pub fn read(id: &str, file: &str, text: &str) -> (Option<Lesson>, Vec<Finding>) {
    let mut findings = Findings::new(file, text);
    let lesson = Reader { text, findings: &mut findings }.lesson(id, file);
    (lesson, findings.sorted())
}

struct Reader<'r, 'f> {
    text: &'r str,
    findings: &'r mut Findings<'f>,
}

/// A fenced block while it is read: what is wrong is told where it stands in the file.
pub struct Site<'r, 'f> {
    /// The bytes of the file that the block's text is.
    base: usize,
    /// The byte that is named where nothing more exact is known.
    offset: usize,
    text: &'r str,
    findings: &'r mut Findings<'f>,
}

impl Reader<'_, '_> {
    fn lesson(&mut self, id: &str, file: &str) -> Option<Lesson> {
        let (header, body) = self.header()?;
        let all = parts(&self.text[body..], body, self.findings);
        let mut lesson = Lesson {
            id: id.to_owned(),
            file: file.to_owned(),
            header,
            opening: Vec::new(),
            steps: Vec::new(),
            links: Vec::new(),
            is_whole: false,
        };
        let mut title: Option<(String, usize)> = None;
        for part in all {
            match part {
                markdown::Part::Step { title: words, offset } => {
                    self.begin(&mut lesson, title.take());
                    title = Some((words, offset));
                }
                markdown::Part::Fenced { word, range, offset } if word == "step" => match title.take() {
                    Some((words, _)) => self.step(&mut lesson, words, range, offset),
                    None => {
                        self.findings.add(offset, "a `step` block stands directly below the heading of its step, once");
                    }
                },
                markdown::Part::Fenced { word, range, offset } => {
                    self.begin(&mut lesson, title.take());
                    let part = self.fenced(&word, range, offset);
                    self.put(&mut lesson, part, offset);
                }
                markdown::Part::Block(block) => {
                    self.begin(&mut lesson, title.take());
                    match lesson.steps.last_mut() {
                        None => lesson.opening.push(block),
                        Some(step) => match step.parts.last_mut() {
                            Some(Part::Prose(prose)) => prose.push(block),
                            _ => step.parts.push(Part::Prose(vec![block])),
                        },
                    }
                }
            }
        }
        self.begin(&mut lesson, title.take());
        if lesson.steps.is_empty() {
            self.findings.add(body, "there are no steps: begin the first one with `## ` and its title");
        }
        lesson.links = self.findings.take_links();
        lesson.is_whole = self.findings.is_clean();
        Some(lesson)
    }

    /// Begins a step that has no block of its own: it looks at what the step before it looked at.
    fn begin(&mut self, lesson: &mut Lesson, title: Option<(String, usize)>) {
        let Some((title, offset)) = title else { return };
        let before = lesson.steps.last().map(|step| step.aim.clone()).unwrap_or_default();
        let mut site = Site { base: offset, offset, text: self.text, findings: self.findings };
        let step = site.step(&StepFile::default(), title, &before);
        lesson.steps.push(step);
    }

    fn step(&mut self, lesson: &mut Lesson, title: String, range: Range<usize>, offset: usize) {
        let before = lesson.steps.last().map(|step| step.aim.clone()).unwrap_or_default();
        let read = self.toml(range.clone());
        let before = Aim { is_lost: before.is_lost || read.is_none(), ..before };
        let file: StepFile = read.unwrap_or_default();
        let mut site = Site { base: range.start, offset, text: self.text, findings: self.findings };
        let step = site.step(&file, title, &before);
        lesson.steps.push(step);
    }

    fn put(&mut self, lesson: &mut Lesson, part: Option<Part>, offset: usize) {
        match (part, lesson.steps.last_mut()) {
            (Some(part), Some(Step { parts, .. })) => parts.push(part),
            (Some(_), None) => {
                self.findings.add(offset, "this block belongs into a step: put it below a `## ` heading");
            }
            (None, _) => {}
        }
    }

    fn fenced(&mut self, word: &str, range: Range<usize>, offset: usize) -> Option<Part> {
        match word {
            "claim" => Some(Part::Claims(self.claims(range))),
            "slip" => {
                let file: SlipFile = self.toml(range.clone())?;
                let mut site = Site { base: range.start, offset, text: self.text, findings: self.findings };
                let (printed, right) = (site.prose(&file.printed), site.prose(&file.right));
                Some(Part::Slip(Slip { printed, right, shown: site.expression(&file.shown)? }))
            }
            "table" => {
                let file: TableFile = self.toml(range.clone())?;
                let mut site = Site { base: range.start, offset, text: self.text, findings: self.findings };
                site.table(&file).map(Part::Table)
            }
            "question" => {
                let file = self.toml(range.clone())?;
                let mut site = Site { base: range.start, offset, text: self.text, findings: self.findings };
                site.question(&file).map(|question| Part::Question(Box::new(question)))
            }
            _ => {
                let message =
                    format!("`{word}` is no block: there are `step`, `claim`, `slip`, `table` and `question`");
                self.findings.add(offset, message);
                None
            }
        }
    }

    fn claims(&mut self, range: Range<usize>) -> Vec<Sited<Expression>> {
        let mut claims = Vec::new();
        let mut offset = range.start;
        for line in self.text[range].split_inclusive('\n') {
            let claim = line.split(" #").next().unwrap_or("").trim();
            if !claim.is_empty() && !claim.starts_with('#') {
                match Expression::parse(claim) {
                    Ok(expression) => claims.push(Sited::new(expression, self.findings.place(offset))),
                    Err(error) => {
                        self.findings.add(offset + error.range.start, format!("`{claim}`: {}", error.message));
                    }
                }
            }
            offset += line.len();
        }
        claims
    }

    fn header(&mut self) -> Option<(Header, usize)> {
        let missing = "a lesson begins with a header between two lines `+++`: title, section, minutes, needs, idea";
        let Some(start) = self.text.starts_with("+++").then(|| self.text.find('\n')).flatten().map(|at| at + 1) else {
            self.findings.add(0, missing);
            return None;
        };
        let Some(end) = self.text[start..].find("\n+++").map(|at| start + at + 1) else {
            self.findings.add(0, missing);
            return None;
        };
        let body = self.text[end..].find('\n').map_or(self.text.len(), |at| end + at + 1);
        let file: HeaderFile = self.toml(start..end)?;
        let place = |text: &Text| self.findings.place(start + text.span().start);
        let header = Header {
            title: file.title.get_ref().clone(),
            section: Sited::new(file.section.get_ref().clone(), place(&file.section)),
            minutes: Sited::new(*file.minutes.get_ref(), self.findings.place(start + file.minutes.span().start)),
            needs: file.needs.iter().map(|id| Sited::new(id.get_ref().clone(), place(id))).collect(),
            idea: file.idea.get_ref().clone(),
        };
        Some((header, body))
    }

    fn toml<T: DeserializeOwned>(&mut self, range: Range<usize>) -> Option<T> {
        match toml::from_str(&self.text[range.clone()]) {
            Ok(file) => Some(file),
            Err(error) => {
                let at = error.span().map_or(0, |span| span.start);
                let message = error.message();
                // What TOML calls an escape is LaTeX's backslash.
                let help = if message.contains("escape") {
                    "; double the backslash, or put the text between single quotes"
                } else {
                    ""
                };
                self.findings.add(range.start + at, format!("{message}{help}"));
                None
            }
        }
    }
}

impl Site<'_, '_> {
    /// Where the block begins.
    pub fn place(&self) -> Place {
        self.findings.place(self.offset)
    }

    /// Where a text of the block stands.
    pub fn place_of(&self, text: &Text) -> Place {
        self.findings.place(self.base + text.span().start)
    }

    /// Says what is wrong with the block as a whole.
    pub fn add(&mut self, message: impl Into<String>) {
        self.findings.add(self.offset, message);
    }

    /// Says what is wrong with a text of it.
    pub fn add_to(&mut self, text: &Text, message: impl Into<String>) {
        self.findings.add(self.base + text.span().start, message);
    }

    /// A text of the block as Markdown.
    pub fn prose(&mut self, text: &Text) -> Prose<Reference> {
        if text.get_ref().contains(|c: char| c.is_control() && c != '\n') {
            let message = "a backslash and a letter make a control character here, as in `\\theta`: double the backslash, or put the text between single quotes";
            self.add_to(text, message);
        }
        let written = &self.text[self.base + text.span().start..self.base + text.span().end];
        let quotes = if written.starts_with("\"\"\"") || written.starts_with("'''") { 3 } else { 1 };
        // Where nothing was escaped the text stands in the file as it is, and its places are exact.
        let exact = written.len() == text.get_ref().len() + 2 * quotes;
        let base = self.base + text.span().start + if exact { quotes } else { 0 };
        read_prose(text.get_ref(), base, self.findings)
    }

    fn table(&mut self, file: &TableFile) -> Option<Table> {
        let of = self.expression(&file.of)?;
        let mut columns = Vec::new();
        for column in &file.columns {
            let format = column.format.as_ref().map_or("", |format| format.get_ref());
            let Some(format) = Format::parse(format) else {
                self.add(format!("`{format}` is no format"));
                continue;
            };
            let head = first_line(self.prose(&column.head));
            columns.extend(self.expression(&column.cell).map(|cell| Column { head, cell, format }));
        }
        Some(Table { of, columns })
    }
}
