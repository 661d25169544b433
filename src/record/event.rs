//! The events of a traced pixel, in the order in which they happen.

use super::{Binding, Numbers, Outcome, What, Working};
use schemars::JsonSchema;
use serde::Serialize;
use std::borrow::Cow;

/// A point, direction or linear RGB colour.
pub type Triple = [f64; 3];

/// An event's place in the order of events.
pub type EventId = u32;

/// Where in the source a number was computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Source {
    /// Path from the root of the repository.
    pub file: &'static str,
    /// Line, counted from 1.
    pub line: u32,
}

/// One thing that happened, with its place in the tree.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Event {
    /// Its number: events are numbered in the order in which they began.
    pub id: EventId,
    /// The event that it is a part of; none for the root.
    pub parent: Option<EventId>,
    /// What happened.
    #[serde(flatten)]
    pub what: What,
    /// The working behind the numbers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub working: Vec<Working>,
    /// Where it was computed.
    pub source: Source,
}

/// The description of an event, before it has a place in a tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// What happened.
    pub what: What,
    /// The working behind the numbers.
    pub working: Vec<Working>,
    /// Where it was computed.
    pub source: Source,
}

impl Entry {
    /// Describes an event; the caller's place in the source is kept with it.
    #[must_use]
    #[track_caller]
    pub fn new(what: What) -> Self {
        let place = std::panic::Location::caller();
        Self { what, working: Vec::new(), source: Source { file: place.file(), line: place.line() } }
    }

    /// Adds a line of working: `symbol = formula`, with `bindings` put in, `= result`.
    #[must_use]
    pub fn line(
        mut self,
        symbol: impl Into<Cow<'static, str>>,
        formula: &'static str,
        bindings: &[Binding],
        result: impl Into<Outcome>,
    ) -> Self {
        let numbers = match self.working.last() {
            Some(last) => last.numbers.next(formula, bindings),
            None => Numbers::new(formula, bindings),
        };
        let Outcome { value: result, accuracy } = result.into();
        self.working.push(Working { symbol: symbol.into(), formula, numbers, result, accuracy });
        self
    }
}
