//! Expressions: where the numbers of a lesson come from.
//!
//! ```text
//! hit.t                                          the hit time of the first hit
//! planes.rows["top"].t                           a row of the plane table, by its name
//! max(map(where(planes.rows, "item.entering"), "item.t"))
//! degrees(acos(-dot(hit.n_geometric, normalise(first("ray").direction)))) ~ snell.theta1
//! ```
//!
//! An expression has no state and no loops; it asks a recorded ray and the scene's file for values and works with them.

mod evaluate;
mod format;
mod functions;
mod lists;
mod parser;
mod token;
mod value;

pub use evaluate::{Known, Question};
pub use format::Format;
pub use value::Value;

use std::fmt;
use std::ops::Range;

/// An expression that was understood, with the text that it was read from.
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    root: Node,
    text: String,
}

/// What is wrong with an expression, and with which of its bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExpressionError {
    /// What is wrong, and what to do.
    pub message: String,
    /// The bytes of the expression that it is about.
    pub range: Range<usize>,
}

/// A part of an expression, and the bytes that it was read from.
#[derive(Clone, Debug, PartialEq)]
struct Node {
    kind: Kind,
    range: Range<usize>,
}

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Literal(Value),
    /// A name, which may have dots in it: `hit`, `csg.early_out`.
    Name(String),
    Field(Box<Node>, String),
    Item(Box<Node>, Box<Node>),
    List(Vec<Node>),
    Call(String, Vec<Node>),
    Not(Box<Node>),
    Minus(Box<Node>),
    Binary(Operator, Box<Node>, Box<Node>),
    /// Whether two are equal within a third.
    Near(Box<Node>, Box<Node>, Option<Box<Node>>),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Equal,
    Unequal,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    And,
    Or,
}

impl Expression {
    /// Reads an expression.
    ///
    /// # Errors
    /// Where the text is none: what stands there and what was expected.
    pub fn parse(text: &str) -> Result<Self, ExpressionError> {
        parser::parse(text).map(|root| Self { root, text: text.to_owned() })
    }

    /// The text that it was read from.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Its value, by what is known.
    ///
    /// # Errors
    /// If a name is unknown, an event or field is not there, or an operation does not go with its operands.
    pub fn evaluate(&self, known: &dyn Known) -> Result<Value, ExpressionError> {
        evaluate::evaluate(&self.root, known)
    }

    /// Its value as a number.
    ///
    /// # Errors
    /// As [`Self::evaluate`]; and if it is something else.
    pub fn number(&self, known: &dyn Known) -> Result<f64, ExpressionError> {
        let value = self.evaluate(known)?;
        value.number().ok_or_else(|| self.error(format!("`{}` is {}, and a number is needed", self.text, value.kind())))
    }

    /// Whether it holds.
    ///
    /// # Errors
    /// As [`Self::evaluate`]; and if it is neither true nor false.
    pub fn holds(&self, known: &dyn Known) -> Result<bool, ExpressionError> {
        match self.evaluate(known)? {
            Value::Truth(truth) => Ok(truth),
            value => Err(self.error(format!("`{}` is {}, neither true nor false", self.text, value.kind()))),
        }
    }

    /// The two sides of a comparison, for saying why it does not hold.
    #[must_use]
    pub fn sides(&self, known: &dyn Known) -> Option<[Value; 2]> {
        let (left, right) = match &self.root.kind {
            Kind::Binary(operator, left, right) if operator.compares() => (left, right),
            Kind::Near(left, right, _) => (left, right),
            _ => return None,
        };
        Some([evaluate::evaluate(left, known).ok()?, evaluate::evaluate(right, known).ok()?])
    }

    /// Whether it asks for anything but numbers that stand in it.
    #[must_use]
    pub fn refers(&self) -> bool {
        self.root.refers()
    }

    fn error(&self, message: String) -> ExpressionError {
        ExpressionError { message, range: 0..self.text.len() }
    }
}

impl Operator {
    const fn compares(self) -> bool {
        matches!(
            self,
            Self::Equal | Self::Unequal | Self::Less | Self::LessOrEqual | Self::Greater | Self::GreaterOrEqual
        )
    }
}

impl Node {
    fn refers(&self) -> bool {
        match &self.kind {
            Kind::Literal(_) => false,
            Kind::Name(_) => true,
            Kind::Field(of, _) | Kind::Not(of) | Kind::Minus(of) => of.refers(),
            Kind::Item(a, b) | Kind::Binary(_, a, b) | Kind::Near(a, b, _) => a.refers() || b.refers(),
            Kind::List(items) => items.iter().any(Self::refers),
            Kind::Call(name, items) => functions::asks(name) || items.iter().any(Self::refers),
        }
    }

    fn error(&self, message: impl Into<String>) -> ExpressionError {
        ExpressionError { message: message.into(), range: self.range.clone() }
    }
}

impl fmt::Display for ExpressionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

#[cfg(test)]
mod tests;
