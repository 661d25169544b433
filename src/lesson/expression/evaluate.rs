//! What an expression comes to.

use super::value::Value;
use super::{ExpressionError, Kind, Node, Operator, functions};
use crate::math::portable;
use crate::query::terms;
use crate::record::EventId;

/// What expressions are about: recorded rays, a scene's file, names.
pub trait Known {
    /// The value of a name that is no word of the query language; none where there is no such name.
    ///
    /// # Errors
    /// If the name stands for something that has no value here.
    fn name(&self, name: &str) -> Option<Result<Value, String>>;

    /// All such names, for what to say about one that there is not.
    fn names(&self) -> Vec<String>;

    /// The events that answer a question, in their order.
    ///
    /// # Errors
    /// If the question cannot be read, or there is no such trace.
    fn events(&self, question: &Question) -> Result<Vec<EventId>, String>;

    /// An event as a record: as it is written to JSON.
    ///
    /// # Errors
    /// If there is no such trace.
    fn event(&self, trace: Option<&str>, id: EventId) -> Result<Value, String>;
}

/// A question to a recorded ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Question<'a> {
    /// The name of the trace; none for the step's own.
    pub trace: Option<&'a str>,
    /// The question in the query language.
    pub text: &'a str,
    /// Only events below this one.
    pub within: Option<EventId>,
    /// Only events that hold this one.
    pub above: Option<EventId>,
}

impl<'a> Question<'a> {
    /// A question to the whole of a trace.
    #[must_use]
    pub const fn to_all(trace: Option<&'a str>, text: &'a str) -> Self {
        Self { trace, text, within: None, above: None }
    }
}

/// Relative to the larger of two numbers: what a few dozen roundings can do. Smaller, and two ways to the same number would differ;
/// larger, and different numbers would be taken for the same.
const ROUNDING: f64 = 1e-9;

/// The value of a part of an expression.
pub(super) fn evaluate(node: &Node, known: &dyn Known) -> Result<Value, ExpressionError> {
    match &node.kind {
        Kind::Literal(value) => Ok(value.clone()),
        Kind::Name(name) => named(node, name, known),
        Kind::Field(of, field) => field_of(node, of, field, known),
        Kind::Item(of, place) => item_of(&evaluate(of, known)?, place, known),
        Kind::List(items) => items.iter().map(|item| evaluate(item, known)).collect::<Result<_, _>>().map(Value::List),
        Kind::Call(name, arguments) => functions::call(node, name, arguments, known),
        Kind::Not(of) => Ok(Value::Truth(!truth(of, known)?)),
        Kind::Minus(of) => match evaluate(of, known)? {
            Value::Number(number) => Ok(Value::Number(-number)),
            value => functions::each(&value, &|x| -x).ok_or_else(|| of.error(format!("{} has no minus", value.kind()))),
        },
        Kind::Binary(operator, left, right) => binary(node, *operator, left, right, known),
        Kind::Near(left, right, within) => {
            let (a, b) = (evaluate(left, known)?, evaluate(right, known)?);
            let within = match within {
                Some(within) => number(within, known)?,
                None => ROUNDING * a.magnitude().max(b.magnitude()),
            };
            Ok(Value::Truth(a.is_near(&b, within)))
        }
    }
}

fn named(node: &Node, name: &str, known: &dyn Known) -> Result<Value, ExpressionError> {
    if let Some(value) = known.name(name) {
        return value.map_err(|message| node.error(message));
    }
    if !is_word(name) {
        let mut all = known.names();
        all.extend(terms().filter(|term| !term.is_field()).map(|term| term.name.to_owned()));
        return Err(node.error(format!("there is nothing named `{name}`{}", nearest(name, &all))));
    }
    first(node, None, name, known)
}

/// The first event that answers a question.
pub(super) fn first(
    node: &Node,
    trace: Option<&str>,
    question: &str,
    known: &dyn Known,
) -> Result<Value, ExpressionError> {
    let events = known.events(&Question::to_all(trace, question)).map_err(|message| node.error(message))?;
    let Some(id) = events.first() else {
        return Err(node.error(format!("no event of the trace answers `{question}`")));
    };
    known.event(trace, *id).map_err(|message| node.error(message))
}

fn field_of(node: &Node, of: &Node, field: &str, known: &dyn Known) -> Result<Value, ExpressionError> {
    // `csg.early_out` is one word of the query language, where `csg` has no such field.
    let word = match &of.kind {
        Kind::Name(name) if known.name(name).is_none() => Some(format!("{name}.{field}")).filter(|word| is_word(word)),
        _ => None,
    };
    let value = match (evaluate(of, known), word) {
        (Ok(value), Some(word)) => match value.field(field) {
            Some(value) => return Ok(value),
            None => return first(node, None, &word, known),
        },
        (Err(_), Some(word)) => return first(node, None, &word, known),
        (value, None) => value?,
    };
    if let Value::Trace(trace) = &value {
        if field == "event" {
            let message =
                format!("only the step has an event of its own: ask the trace, as in `{trace}.first(\"hit\")`");
            return Err(node.error(message));
        }
        return first(node, Some(trace), field, known);
    }
    value.field(field).ok_or_else(|| {
        let names: Vec<String> = value.field_names().into_iter().map(str::to_owned).collect();
        let what = if names.is_empty() { format!("{} has no fields", value.kind()) } else { String::new() };
        let list = if names.is_empty() {
            String::new()
        } else {
            format!("there is no field `{field}`: there are {}", names.join(", "))
        };
        node.error(format!("{what}{list}"))
    })
}

fn item_of(of: &Value, place: &Node, known: &dyn Known) -> Result<Value, ExpressionError> {
    let index = evaluate(place, known)?;
    match (&index, of) {
        (Value::Text(name), Value::List(_)) => {
            of.named(name).ok_or_else(|| place.error(format!("no item of the list is called `{name}`")))
        }
        (Value::Text(name), Value::Record(_)) => {
            of.field(name).ok_or_else(|| place.error(format!("there is no field `{name}`")))
        }
        (Value::Number(number), Value::List(items)) => {
            let found = items.iter().enumerate().find(|(at, _)| *at as f64 == *number).map(|(_, item)| item.clone());
            let message = || format!("there is no item {number}: the list has {}, counted from 0", items.len());
            found.ok_or_else(|| place.error(message()))
        }
        _ => Err(place.error(format!("{} is no list of which to take an item by {}", of.kind(), index.kind()))),
    }
}

fn binary(
    node: &Node,
    operator: Operator,
    left: &Node,
    right: &Node,
    known: &dyn Known,
) -> Result<Value, ExpressionError> {
    match operator {
        Operator::And => return Ok(Value::Truth(truth(left, known)? && truth(right, known)?)),
        Operator::Or => return Ok(Value::Truth(truth(left, known)? || truth(right, known)?)),
        _ => {}
    }
    let (a, b) = (evaluate(left, known)?, evaluate(right, known)?);
    match operator {
        Operator::Equal => return Ok(Value::Truth(a == b)),
        Operator::Unequal => return Ok(Value::Truth(a != b)),
        _ => {}
    }
    if let (Value::Number(a), Value::Number(b)) = (&a, &b) {
        return Ok(numbers(operator, *a, *b));
    }
    functions::of_vectors(operator, &a, &b)
        .ok_or_else(|| node.error(format!("{} and {} cannot be worked with in this way", a.kind(), b.kind())))
}

fn numbers(operator: Operator, a: f64, b: f64) -> Value {
    match operator {
        Operator::Add => Value::Number(a + b),
        Operator::Subtract => Value::Number(a - b),
        Operator::Multiply => Value::Number(a * b),
        Operator::Divide => Value::Number(a / b),
        Operator::Power => Value::Number(portable::powf(a, b)),
        Operator::Less => Value::Truth(a < b),
        Operator::LessOrEqual => Value::Truth(a <= b),
        Operator::Greater => Value::Truth(a > b),
        Operator::GreaterOrEqual => Value::Truth(a >= b),
        Operator::Equal | Operator::Unequal | Operator::And | Operator::Or => Value::None,
    }
}

/// The number that a part comes to.
pub(super) fn number(node: &Node, known: &dyn Known) -> Result<f64, ExpressionError> {
    let value = evaluate(node, known)?;
    value.number().ok_or_else(|| node.error(format!("this is {}, and a number is needed", value.kind())))
}

fn truth(node: &Node, known: &dyn Known) -> Result<bool, ExpressionError> {
    match evaluate(node, known)? {
        Value::Truth(truth) => Ok(truth),
        value => Err(node.error(format!("this is {}, neither true nor false", value.kind()))),
    }
}

fn is_word(name: &str) -> bool {
    terms().any(|term| !term.is_field() && term.name == name)
}

/// `; did you mean …?`, where something is called much the same.
fn nearest(read: &str, known: &[String]) -> String {
    let near = known.iter().min_by_key(|name| strsim::damerau_levenshtein(read, name));
    match near {
        Some(name) if strsim::damerau_levenshtein(read, name) <= 2 => format!("; did you mean `{name}`?"),
        _ => String::new(),
    }
}
