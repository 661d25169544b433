//! Errors as they are shown: file, line, column, the line itself with a mark under it, the place in the JSON, and help.

use super::problem::Problem;
use jsonc_parser::common::Range;
use std::fmt::{self, Display};

/// One error in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The file.
    pub file: String,
    /// Line, counted from 1.
    pub line: usize,
    /// Column in characters, counted from 1.
    pub column: usize,
    /// The place in the JSON, such as `objects[2].of[0].s`; empty for the whole file.
    pub path: String,
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub help: Vec<String>,
    /// The line of the file that it is about, or a part of it.
    excerpt: String,
    /// Characters of the excerpt before the mark, and under it.
    mark: (usize, usize),
}

/// All errors of a file, in the order of the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostics {
    /// The errors.
    pub errors: Vec<Diagnostic>,
    /// How many more there are, where there are too many to list.
    pub left_out: usize,
}

impl std::error::Error for Diagnostics {}

/// Characters of a line that are shown; longer lines are cut on both sides of the mark.
const EXCERPT: usize = 100;

impl Diagnostics {
    /// Puts problems with their ranges in the text into the order of the file.
    pub(super) fn new(file: &str, text: &str, mut problems: Vec<(Range, Problem)>, left_out: usize) -> Self {
        problems.sort_by_key(|(range, _)| range.start);
        let errors = problems.into_iter().map(|(range, problem)| Diagnostic::new(file, text, range, problem)).collect();
        Self { errors, left_out }
    }
}

impl Diagnostic {
    fn new(file: &str, text: &str, range: Range, problem: Problem) -> Self {
        let start = text.floor_char_boundary(range.start.min(text.len()));
        let end = text.floor_char_boundary(range.end.clamp(start, text.len()));
        let line_start = text[..start].rfind('\n').map_or(0, |newline| newline + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |newline| start + newline);
        let before = text[line_start..start].chars().count();
        let under = text[start..end.min(line_end).max(start)].chars().count().max(1);
        let (excerpt, mark) = excerpt(text[line_start..line_end].trim_end(), before, under);
        Self {
            file: file.to_owned(),
            line: text[..line_start].matches('\n').count() + 1,
            column: before + 1,
            path: problem.path(),
            message: problem.message,
            help: problem.help,
            excerpt,
            mark,
        }
    }
}

/// The part of a line around the mark, and where the mark is in it.
fn excerpt(line: &str, before: usize, under: usize) -> (String, (usize, usize)) {
    let skipped = if before + under.min(EXCERPT / 2) > EXCERPT { before.saturating_sub(EXCERPT / 2) } else { 0 };
    let printable = |c: char| if c.is_control() { ' ' } else { c };
    let mut shown: String = line.chars().skip(skipped).take(EXCERPT).map(printable).collect();
    if skipped > 0 {
        shown = format!("…{}", shown.chars().skip(1).collect::<String>());
    }
    if line.chars().count() > skipped + EXCERPT {
        shown.push('…');
    }
    let start = before - skipped;
    let width = under.min(shown.chars().count().saturating_sub(start)).max(1);
    (shown, (start, width))
}

impl Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let number = self.line.to_string();
        let margin = " ".repeat(number.len());
        writeln!(f, "error: {}", self.message)?;
        write!(f, "{margin}--> {}:{}:{}", self.file, self.line, self.column)?;
        if !self.path.is_empty() {
            write!(f, " at {}", self.path)?;
        }
        writeln!(f)?;
        writeln!(f, "{margin} |")?;
        writeln!(f, "{number} | {}", self.excerpt)?;
        write!(f, "{margin} | {}{}", " ".repeat(self.mark.0), "^".repeat(self.mark.1))?;
        self.help.iter().try_for_each(|help| write!(f, "\n{margin} = {help}"))
    }
}

impl Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for diagnostic in &self.errors {
            writeln!(f, "{diagnostic}\n")?;
        }
        let file = self.errors.first().map_or("", |first| first.file.as_str());
        match (self.errors.len(), self.left_out) {
            (1, 0) => write!(f, "1 error in {file}"),
            (count, 0) => write!(f, "{count} errors in {file}"),
            (count, left_out) => write!(f, "{} errors in {file}; the first {count} found are shown", count + left_out),
        }
    }
}
