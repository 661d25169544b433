//! Questions to recorded rays: a small language that picks out events, and searches of whole pictures by it.
//!
//! ```text
//! tir                                 a total internal reflection
//! kind=refracted & depth>=2           something on a refracted ray that is two or more rays away from the eye
//! object=lens & csg.early_out         an early out within the search of the object lens
//! hit=glass* & !(t<3 | undecidable)   a hit with an object whose name begins with glass, not before t = 3 and certain
//! pixel & !has(shadowed)              a pixel in whose whole story nothing stands before a light
//! ```
//!
//! A question is asked of one **event** at a time. A word holds of an event or it does not; a field has a value there, several, or
//! none, and a comparison holds if it does of one of them. So `a & b` asks for one event of which both hold. Fields of a larger thing
//! are those of all its parts: every event of a ray has the ray's `kind` and `depth`; every event of the search with an object has
//! its `object`; and what happens on a ray after its hit has the `object`, `leaf`, `part`, `material` and `t` of the hit, unless it
//! has its own. A ray that is spawned starts afresh. A pixel matches if one of its events does.
//!
//! `!=` holds where there is a value and none is equal; `!(…)` holds of every event of which `…` does not.

mod complete;
mod context;
mod error;
mod evaluate;
mod expression;
mod fields;
mod parser;
mod passes;
mod pattern;
mod presets;
mod scan;
mod survey;
mod term;
mod token;
mod vocabulary;
mod words;

pub use complete::{Completion, complete};
pub use error::QueryError;
pub use evaluate::Matches;
pub use passes::{FIRST_SIDE, Grid};
pub use presets::{PRESETS, Preset};
pub use scan::{Found, Search, scan};
pub use survey::{Clock, Quantity, Survey, survey};
pub use term::{Term, TermKind, terms};
pub use vocabulary::Vocabulary;

use crate::record::EventId;
use crate::trace::RayTree;
use expression::Expression;
use serde::{Deserialize, Serialize};
use std::fmt::{self, Display};
use std::str::FromStr;

/// A question that was understood. Where it is sent or kept it is its text.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct Query {
    expression: Expression,
}

impl Query {
    /// Reads a question.
    ///
    /// # Errors
    /// Where the text is none: the column, what was expected there, and the nearest word that there is.
    pub fn parse(text: &str) -> Result<Self, QueryError> {
        parser::parse(text).map(|expression| Self { expression })
    }

    /// The events of which it holds, in the order in which they happened.
    #[must_use]
    pub fn matches<'a>(&'a self, tree: &'a RayTree) -> Matches<'a> {
        Matches::new(&self.expression, tree)
    }

    /// The first event of which it holds.
    #[must_use]
    pub fn first(&self, tree: &RayTree) -> Option<EventId> {
        self.matches(tree).next()
    }

    /// The names in the question that nothing in the scene has, each with the nearest one that something has. The question may be
    /// asked all the same; but nothing can come of these names.
    #[must_use]
    pub fn unknown_names(&self, vocabulary: &Vocabulary) -> Vec<QueryError> {
        let mut problems = Vec::new();
        self.expression.for_each_comparison(&mut |comparison| problems.extend(comparison.unknown_name(vocabulary)));
        problems
    }
}

/// The same question in its plainest spelling.
impl Display for Query {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.expression.fmt(f)
    }
}

impl From<Query> for String {
    fn from(query: Query) -> Self {
        query.to_string()
    }
}

impl TryFrom<String> for Query {
    type Error = QueryError;

    fn try_from(text: String) -> Result<Self, QueryError> {
        Self::parse(&text)
    }
}

impl FromStr for Query {
    type Err = QueryError;

    fn from_str(text: &str) -> Result<Self, QueryError> {
        Self::parse(text)
    }
}
