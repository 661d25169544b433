//! A formula with a ray's numbers in place of its symbols.
//!
//! A recorded pixel has thousands of them, of which a person reads a few. So what is kept is the formula and the numbers, and
//! they are written out when somebody asks.

use super::Value;
use serde::{Serialize, Serializer};
use std::fmt;
use std::sync::Arc;

/// A symbol, and what is put in its place.
pub type Binding = (&'static str, Value);

/// A formula with numbers in place of its symbols. No number is ever typed: each comes from the value that the tracer used.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbers {
    formula: &'static str,
    bindings: Arc<[Binding]>,
}

impl Numbers {
    /// Puts `bindings` into `formula`.
    #[must_use]
    pub fn new(formula: &'static str, bindings: &[Binding]) -> Self {
        Self { formula, bindings: bindings.into() }
    }

    /// The same for another formula. The lines of an event mostly have the same bindings, and then share them.
    #[must_use]
    pub fn next(&self, formula: &'static str, bindings: &[Binding]) -> Self {
        if *self.bindings == *bindings {
            Self { formula, bindings: Arc::clone(&self.bindings) }
        } else {
            Self::new(formula, bindings)
        }
    }

    fn bound(&self, symbol: &str) -> Option<&Value> {
        self.bindings.iter().find(|(bound, _)| *bound == symbol).map(|(_, value)| value)
    }
}

/// Replaces each symbol that has a binding; negative numbers are put in parentheses.
impl fmt::Display for Numbers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut rest = self.formula;
        while !rest.is_empty() {
            let (between, from_symbol) = rest.split_at(rest.find(is_symbol).unwrap_or(rest.len()));
            let end = from_symbol.find(|c| !is_symbol(c)).unwrap_or(from_symbol.len());
            let (symbol, after) = from_symbol.split_at(end);
            f.write_str(between)?;
            match self.bound(symbol) {
                Some(value) => f.write_str(&in_place(value))?,
                None => f.write_str(symbol)?,
            }
            rest = after;
        }
        Ok(())
    }
}

impl Serialize for Numbers {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// Letters, subscripts and marks that belong to a symbol; superscripts do not (`c²` is the square of `c`).
fn is_symbol(c: char) -> bool {
    c.is_alphanumeric() && !matches!(c, '⁰' | '¹' | '²' | '³' | '⁴' | '⁵'..='⁹') || matches!(c, '_' | '′' | '₀'..='₉')
}

fn in_place(value: &Value) -> String {
    let text = value.to_string();
    if text.starts_with('−') || text.contains('·') { format!("({text})") } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_are_replaced_whole_and_squares_stay() {
        let bindings = [("c_x", Value::Number(-2.0)), ("c", Value::Number(7.0)), ("θ₁", Value::Number(0.5))];
        let numbers = Numbers::new("c_x² + c·sin θ₁ + r", &bindings);
        assert_eq!(numbers.to_string(), "(−2)² + 7·sin 0.5 + r");
    }

    #[test]
    fn a_line_has_its_own_bindings_whatever_the_line_before_it_has() {
        let first = Numbers::new("a + b", &[("a", Value::Number(1.0)), ("b", Value::Number(2.0))]);
        let shared = first.next("b − a", &[("a", Value::Number(1.0)), ("b", Value::Number(2.0))]);
        let other = first.next("b − a", &[("a", Value::Number(1.0)), ("b", Value::Number(3.0))]);
        assert_eq!([shared.to_string(), other.to_string()], ["2 − 1", "3 − 1"]);
    }
}
