//! Of which events a question holds.

use super::context::{Contexts, View};
use super::expression::{Comparison, Expression, Value};
use super::term::{Term, Test};
use super::token::Sign;
use crate::record::EventId;
use crate::trace::RayTree;

/// The events of which a question holds, in the order in which they happened.
#[derive(Debug)]
pub struct Matches<'a> {
    tree: &'a RayTree,
    contexts: Contexts,
    asked: Asked<'a>,
    next: EventId,
}

/// A question as it is asked of one tree: what has to look below an event is worked out for all events beforehand.
#[derive(Debug)]
enum Asked<'a> {
    Word(&'static Term),
    Comparison(&'a Comparison),
    Not(Box<Asked<'a>>),
    All(Vec<Asked<'a>>),
    Any(Vec<Asked<'a>>),
    Known(Vec<bool>),
}

impl<'a> Matches<'a> {
    pub(super) fn new(expression: &'a Expression, tree: &'a RayTree) -> Self {
        let contexts = Contexts::of(tree);
        let asked = Asked::of(expression, tree, &contexts);
        Self { tree, contexts, asked, next: 0 }
    }
}

impl Iterator for Matches<'_> {
    type Item = EventId;

    fn next(&mut self) -> Option<EventId> {
        let found =
            (self.next..self.tree.end()).find(|&id| self.asked.holds(id, &View::new(self.tree, &self.contexts, id)));
        self.next = found.map_or(self.tree.end(), |id| id + 1);
        found
    }
}

impl<'a> Asked<'a> {
    fn of(expression: &'a Expression, tree: &RayTree, contexts: &Contexts) -> Self {
        let each = |terms: &'a [Expression]| terms.iter().map(|term| Self::of(term, tree, contexts)).collect();
        match expression {
            Expression::Word(term) => Self::Word(term),
            Expression::Comparison(comparison) => Self::Comparison(comparison),
            Expression::Not(inner) => Self::Not(Box::new(Self::of(inner, tree, contexts))),
            Expression::All(terms) => Self::All(each(terms)),
            Expression::Any(terms) => Self::Any(each(terms)),
            Expression::Has(inner) => Self::Known(Self::of(inner, tree, contexts).at_or_below(tree, contexts)),
        }
    }

    /// For each event, whether it holds of it or of one below it.
    fn at_or_below(&self, tree: &RayTree, contexts: &Contexts) -> Vec<bool> {
        let mut holds: Vec<bool> = (0..tree.end()).map(|id| self.holds(id, &View::new(tree, contexts, id))).collect();
        // Parents come before their parts, so from the end on each event is done when its parent is told.
        for (id, event) in tree.events.iter().enumerate().rev() {
            if let (true, Some(parent)) = (holds[id], event.parent) {
                holds[parent as usize] = true;
            }
        }
        holds
    }

    fn holds(&self, id: EventId, view: &View) -> bool {
        match self {
            Self::Word(term) => matches!(term.test, Test::Word(test) if test(view)),
            Self::Comparison(comparison) => comparison.holds(view),
            Self::Not(inner) => !inner.holds(id, view),
            Self::All(terms) => terms.iter().all(|term| term.holds(id, view)),
            Self::Any(terms) => terms.iter().any(|term| term.holds(id, view)),
            Self::Known(known) => known.get(id as usize).copied().unwrap_or(false),
        }
    }
}

impl Comparison {
    fn holds(&self, view: &View) -> bool {
        match (&self.field.test, &self.value) {
            (Test::Names(field, _), Value::Name(pattern)) => {
                let is_equal = field(view, &mut |name| pattern.matches(name));
                if self.sign == Sign::Unequal { !is_equal && field(view, &mut |_| true) } else { is_equal }
            }
            (Test::Numbers(field), Value::Number(number)) => self.holds_of_number(*field, *number, view),
            _ => false,
        }
    }

    fn holds_of_number(&self, field: super::fields::Numbers, wanted: f64, view: &View) -> bool {
        let one = |passes: fn(f64, f64) -> bool| field(view, &mut |number| passes(number, wanted));
        match self.sign {
            Sign::Equal => one(|a, b| a == b),
            Sign::Unequal => !one(|a, b| a == b) && one(|_, _| true),
            Sign::Less => one(|a, b| a < b),
            Sign::AtMost => one(|a, b| a <= b),
            Sign::More => one(|a, b| a > b),
            Sign::AtLeast => one(|a, b| a >= b),
        }
    }
}
