//! The words of the language, as one list: the parser, the completion, the help and the tests come from it.

use super::context::View;
use super::fields::{OfName, OfNumber};
use super::vocabulary::Vocabulary;
use super::{fields, words};

/// A word or a field of the language.
#[derive(Clone, Copy, Debug)]
pub struct Term {
    /// How it is written.
    pub name: &'static str,
    /// What it means, in half a sentence.
    pub meaning: &'static str,
    /// A question that has it.
    pub example: &'static str,
    pub(super) test: Test,
}

/// What kind of term it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TermKind {
    /// It holds or does not.
    Word,
    /// A field with names as values.
    Names,
    /// A field with numbers as values.
    Numbers,
    /// It has a question in parentheses.
    Group,
}

/// How it is found out.
#[derive(Clone, Copy, Debug)]
pub(super) enum Test {
    /// Whether it holds.
    Word(fn(&View) -> bool),
    /// Whether one of the names passes.
    Names(fn(&View, OfName) -> bool, Names),
    /// Whether one of the numbers passes.
    Numbers(fn(&View, OfNumber) -> bool),
    /// What is in the parentheses holds of the event or of one below it.
    Group,
}

/// Where the names come from that a field can have.
#[derive(Clone, Copy, Debug)]
pub(super) enum Names {
    /// These and no others.
    Listed(fn() -> &'static [&'static str]),
    /// Those of the scene.
    OfScene(fn(&Vocabulary) -> &[String]),
    /// Any text.
    Any,
}

/// There is one term of a kind with a name.
impl PartialEq for Term {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && self.kind() == other.kind()
    }
}

impl Term {
    /// What kind of term it is.
    #[must_use]
    pub const fn kind(&self) -> TermKind {
        match self.test {
            Test::Word(_) => TermKind::Word,
            Test::Names(..) => TermKind::Names,
            Test::Numbers(_) => TermKind::Numbers,
            Test::Group => TermKind::Group,
        }
    }

    /// Whether it is compared with a value.
    #[must_use]
    pub const fn is_field(&self) -> bool {
        matches!(self.test, Test::Names(..) | Test::Numbers(_))
    }

    /// What a comparison with it needs.
    pub(super) fn expects(&self) -> &'static str {
        match self.test {
            Test::Numbers(_) => "a number",
            _ => "a name",
        }
    }
}

/// All terms, in the order in which they are shown: words first, then fields.
pub fn terms() -> impl Iterator<Item = &'static Term> {
    words::WORDS.iter().chain(&words::GROUPS).chain(fields::FIELDS)
}

/// The word of this name.
pub(super) fn word(name: &str) -> Option<&'static Term> {
    words::WORDS.iter().find(|word| word.name.eq_ignore_ascii_case(name))
}

/// The field of this name; indices may be written as in texts (`θ₁`).
pub(super) fn field(name: &str) -> Option<&'static Term> {
    let plain: String = name
        .chars()
        .map(|c| {
            if let '₁' = c {
                '1'
            } else if let '₂' = c {
                '2'
            } else {
                c
            }
        })
        .collect();
    let plain = plain.replace('θ', "theta");
    fields::FIELDS.iter().find(|field| field.name.eq_ignore_ascii_case(&plain))
}
