//! A question as a tree of terms.

use super::error::{QueryError, nearest};
use super::pattern::Pattern;
use super::term::{Names, Term, Test};
use super::token::Sign;
use super::vocabulary::Vocabulary;
use std::fmt::{self, Display};

/// A question.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Expression {
    /// A word that holds or does not.
    Word(&'static Term),
    /// A field that is compared.
    Comparison(Comparison),
    /// It does not hold.
    Not(Box<Expression>),
    /// All of them hold; at least two, none of which is an `All` itself.
    All(Vec<Expression>),
    /// One of them holds; at least two, none of which is an `Any` itself.
    Any(Vec<Expression>),
    /// It holds of the event, or of one below it.
    Has(Box<Expression>),
}

/// A field that is compared with a value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Comparison {
    pub field: &'static Term,
    pub sign: Sign,
    pub value: Value,
    /// Where the value stands in the question, in characters from 0; what is written anew has none.
    pub place: Place,
}

/// What a field is compared with.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    Number(f64),
    Name(Pattern),
}

/// A place in a text. Questions that differ in places alone are the same.
#[derive(Clone, Debug)]
pub(super) struct Place(pub std::ops::Range<usize>);

impl PartialEq for Place {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Expression {
    /// All of these; those that are such a list themselves are taken apart.
    pub fn all(terms: Vec<Self>) -> Self {
        let split = |term| if let Self::All(inner) = term { inner } else { vec![term] };
        Self::one_or(terms.into_iter().flat_map(split).collect(), Self::All)
    }

    /// One of these, likewise.
    pub fn any(terms: Vec<Self>) -> Self {
        let split = |term| if let Self::Any(inner) = term { inner } else { vec![term] };
        Self::one_or(terms.into_iter().flat_map(split).collect(), Self::Any)
    }

    fn one_or(mut terms: Vec<Self>, several: impl FnOnce(Vec<Self>) -> Self) -> Self {
        if terms.len() == 1 { terms.swap_remove(0) } else { several(terms) }
    }

    /// Shows each comparison in it.
    pub fn for_each_comparison(&self, show: &mut impl FnMut(&Comparison)) {
        match self {
            Self::Word(_) => {}
            Self::Comparison(comparison) => show(comparison),
            Self::Not(inner) | Self::Has(inner) => inner.for_each_comparison(show),
            Self::All(terms) | Self::Any(terms) => terms.iter().for_each(|term| term.for_each_comparison(show)),
        }
    }

    /// How tightly its outermost sign binds.
    const fn strength(&self) -> u8 {
        match self {
            Self::Any(_) => 0,
            Self::All(_) => 1,
            _ => 2,
        }
    }

    /// In parentheses where it binds less tightly than what it is a part of.
    fn fmt_within(&self, least: u8, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.strength() < least { write!(f, "({self})") } else { self.fmt(f) }
    }
}

impl Comparison {
    /// Why nothing in a scene can have this value, if that is so.
    pub fn unknown_name(&self, vocabulary: &Vocabulary) -> Option<QueryError> {
        let (Value::Name(pattern), Test::Names(_, Names::OfScene(names))) = (&self.value, &self.field.test) else {
            return None;
        };
        let known = names(vocabulary);
        if known.iter().any(|name| pattern.matches(name)) {
            return None;
        }
        let (name, field) = (pattern.to_string(), self.field.name);
        let message = format!("nothing in the scene has {field}={name}");
        let mut error = QueryError::new(self.place.0.start + 1, self.place.0.len(), message);
        error.nearest = nearest(&name, known.iter().map(String::as_str));
        Some(error)
    }
}

impl Display for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list = |terms: &[Self], sign: &str, least: u8, f: &mut fmt::Formatter<'_>| {
            terms.iter().enumerate().try_for_each(|(k, term)| {
                if k > 0 {
                    f.write_str(sign)?;
                }
                term.fmt_within(least, f)
            })
        };
        match self {
            Self::Word(term) => f.write_str(term.name),
            Self::Comparison(comparison) => comparison.fmt(f),
            Self::Not(inner) => {
                f.write_str("!")?;
                inner.fmt_within(2, f)
            }
            Self::All(terms) => list(terms, " & ", 2, f),
            Self::Any(terms) => list(terms, " | ", 1, f),
            Self::Has(inner) => write!(f, "has({inner})"),
        }
    }
}

impl Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.field.name, self.sign.text())?;
        match &self.value {
            Value::Number(number) => write!(f, "{number}"),
            Value::Name(pattern) => write!(f, "{pattern}"),
        }
    }
}
