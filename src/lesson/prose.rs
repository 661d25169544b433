//! The text of a lesson as a tree: one for the workbench, the book, the printed page and the terminal.
//!
//! As it was read, a value is the expression that it comes from ([`Reference`]). As it is told, it is what that came to ([`Told`]).

use super::expression::{Expression, Format};
use super::place::Place;
use crate::record::EventId;

/// Paragraphs, lists, tables and the like, in order.
pub type Prose<V> = Vec<Block<V>>;

/// A run of words and values.
pub type Line<V> = Vec<Inline<V>>;

/// A value in the text: where it comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// What it is.
    pub expression: Expression,
    /// How it is written.
    pub format: Format,
    /// Where it stands in the file.
    pub place: Place,
}

/// A value in the text: what came out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Told {
    /// As it is written.
    pub text: String,
    /// The expression that it comes from.
    pub from: String,
    /// The event that it is a value of; none where it comes from several, or from the scene's file.
    pub event: Option<EventId>,
}

/// A paragraph, or something as large.
#[derive(Clone, Debug, PartialEq)]
pub enum Block<V> {
    /// A paragraph.
    Paragraph(Line<V>),
    /// A heading within a step.
    Heading(Line<V>),
    /// A list; numbered or not.
    List {
        /// Whether its items are numbered.
        numbered: bool,
        /// Its items.
        items: Vec<Prose<V>>,
    },
    /// Something set apart.
    Quote(Prose<V>),
    /// Code, in lines.
    Code(Vec<Piece<V>>),
    /// A formula on a line of its own, in LaTeX.
    Formula(Vec<Piece<V>>),
    /// A table.
    Table {
        /// The cells of its head.
        head: Vec<Line<V>>,
        /// The cells of its rows.
        rows: Vec<Vec<Line<V>>>,
    },
}

/// A part of a paragraph.
#[derive(Clone, Debug, PartialEq)]
pub enum Inline<V> {
    /// Words.
    Text(String),
    /// A value.
    Value(V),
    /// Words that are stressed.
    Emphasis(Line<V>),
    /// Words that are strongly stressed.
    Strong(Line<V>),
    /// Code.
    Code(Vec<Piece<V>>),
    /// A formula, in LaTeX.
    Formula(Vec<Piece<V>>),
    /// A link.
    Link(Target, Line<V>),
    /// A new line.
    Break,
}

/// A part of a formula or of code.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece<V> {
    /// As it stands.
    Text(String),
    /// A value.
    Value(V),
}

/// Where a link leads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// To a term of the glossary.
    Term(String),
    /// To another lesson.
    Lesson(String),
    /// To a file of the program's source.
    Source(String),
}

/// A formula in LaTeX, with the values as LaTeX writes them.
#[must_use]
pub fn latex(pieces: &[Piece<Told>]) -> String {
    pieces
        .iter()
        .map(|piece| match piece {
            Piece::Text(text) => text.clone(),
            Piece::Value(value) => as_latex(&value.text),
        })
        .collect()
}

/// Code, with the values put in.
#[must_use]
pub fn code(pieces: &[Piece<Told>]) -> String {
    pieces
        .iter()
        .map(|piece| match piece {
            Piece::Text(text) => text.as_str(),
            Piece::Value(value) => value.text.as_str(),
        })
        .collect()
}

/// A value as LaTeX writes it: a sign that belongs to its number, powers of ten, names upright.
fn as_latex(text: &str) -> String {
    let is_numeric =
        |c: char| c.is_ascii_digit() || matches!(c, '.' | '−' | '·' | ' ' | '(' | ')' | ',' | '∞' | '°' | '%');
    let is_power = |c: char| "⁻⁰¹²³⁴⁵⁶⁷⁸⁹".contains(c);
    if !text.chars().all(|c| is_numeric(c) || is_power(c)) {
        return format!("\\text{{{}}}", text.replace('%', "\\%").replace('_', "\\_"));
    }
    let mut latex = String::new();
    let mut in_power = false;
    for c in text.chars() {
        if is_power(c) != in_power {
            in_power = !in_power;
            latex.push_str(if in_power { "^{" } else { "}" });
        }
        match c {
            '−' => latex.push_str("{-}"),
            '·' => latex.push_str("\\cdot "),
            '∞' => latex.push_str("\\infty "),
            '°' => latex.push_str("^{\\circ}"),
            '%' => latex.push_str("\\%"),
            ',' => latex.push_str(",\\;"),
            '⁻' => latex.push('-'),
            c if is_power(c) => latex.push(plain_digit(c)),
            c => latex.push(c),
        }
    }
    if in_power {
        latex.push('}');
    }
    latex
}

fn plain_digit(superscript: char) -> char {
    let digits = "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().zip('0'..='9');
    digits.into_iter().find(|(raised, _)| *raised == superscript).map_or(superscript, |(_, digit)| digit)
}

/// A line as plain text, formulas in LaTeX.
#[must_use]
pub fn plain(line: &[Inline<Told>]) -> String {
    line.iter()
        .map(|inline| match inline {
            Inline::Text(text) => text.clone(),
            Inline::Value(value) => value.text.clone(),
            Inline::Emphasis(line) | Inline::Strong(line) | Inline::Link(_, line) => plain(line),
            Inline::Code(pieces) => code(pieces),
            Inline::Formula(pieces) => latex(pieces),
            Inline::Break => " ".to_owned(),
        })
        .collect()
}

impl<V> Block<V> {
    /// Calls `show` with every line in it, in order.
    pub fn for_each_line<'a>(&'a self, show: &mut impl FnMut(&'a Line<V>)) {
        match self {
            Self::Paragraph(line) | Self::Heading(line) => show(line),
            Self::List { items, .. } => items.iter().flatten().for_each(|block| block.for_each_line(show)),
            Self::Quote(blocks) => blocks.iter().for_each(|block| block.for_each_line(show)),
            Self::Table { head, rows } => {
                head.iter().for_each(&mut *show);
                rows.iter().flatten().for_each(show);
            }
            Self::Code(_) | Self::Formula(_) => {}
        }
    }
}

/// How many words a text has; a formula or a value counts as one.
#[must_use]
pub fn words<V>(prose: &[Block<V>]) -> usize {
    let mut count = 0;
    for block in prose {
        block.for_each_line(&mut |line| count += words_of(line));
        count += usize::from(matches!(block, Block::Code(_) | Block::Formula(_)));
    }
    count
}

fn words_of<V>(line: &[Inline<V>]) -> usize {
    line.iter()
        .map(|inline| match inline {
            Inline::Text(text) => {
                text.split_whitespace().filter(|word| word.chars().any(char::is_alphanumeric)).count()
            }
            Inline::Value(_) | Inline::Code(_) | Inline::Formula(_) => 1,
            Inline::Emphasis(line) | Inline::Strong(line) | Inline::Link(_, line) => words_of(line),
            Inline::Break => 0,
        })
        .sum()
}
