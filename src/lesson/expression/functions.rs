//! The functions of expressions.

use super::evaluate::{Known, Question, evaluate, first, number};
use super::value::Value;
use super::{ExpressionError, Kind, Node, Operator, lists};
use crate::math::portable;
use crate::record::EventId;

type Outcome = Result<Value, ExpressionError>;

/// A function of one number, by its name.
type OfOne = (&'static str, fn(f64) -> f64);

/// Functions of one number. Of lists they are taken item by item.
const OF_ONE: [OfOne; 18] = [
    ("abs", f64::abs),
    ("sqrt", f64::sqrt),
    ("sin", portable::sin),
    ("cos", portable::cos),
    ("tan", portable::tan),
    ("asin", portable::asin),
    ("acos", portable::acos),
    ("atan", portable::atan),
    ("exp", portable::exp),
    ("ln", portable::ln),
    ("log10", portable::log10),
    ("floor", f64::floor),
    ("ceil", f64::ceil),
    ("round", f64::round),
    ("sign", |x| if x == 0.0 { 0.0 } else { x.signum() }),
    ("degrees", f64::to_degrees),
    ("radians", f64::to_radians),
    ("fract", |x| x - x.floor()),
];

/// Functions that ask a recorded ray.
const ASKING: [&str; 8] = ["first", "last", "nth", "all", "count", "exists", "within", "above"];

/// All others, for what to say about one that there is not.
const OTHERS: [&str; 17] = [
    "min",
    "max",
    "mod",
    "dot",
    "cross",
    "length",
    "normalise",
    "len",
    "sum",
    "sorted",
    "reversed",
    "map",
    "where",
    "unite",
    "intersect",
    "subtract",
    "spans",
];

/// Whether a function asks a recorded ray, so that what it gives is no typed number.
pub(super) fn asks(name: &str) -> bool {
    ASKING.contains(&name)
}

/// What a function gives.
pub(super) fn call(node: &Node, name: &str, arguments: &[Node], known: &dyn Known) -> Outcome {
    if asks(name) {
        return ask(node, name, arguments, known);
    }
    if let Some((_, function)) = OF_ONE.iter().find(|(known, _)| *known == name) {
        let [value] = values(node, name, arguments, known)?;
        return match &value {
            Value::Number(x) => Ok(Value::Number(function(*x))),
            value => each(value, function)
                .ok_or_else(|| node.error(format!("`{name}` is of numbers, not of {}", value.kind()))),
        };
    }
    match name {
        "map" | "where" => lists::by_item(node, name, arguments, known),
        "min" | "max" => extreme(node, name, arguments, known),
        "mod" => {
            let [x, by] = [first_number(node, arguments, 0, known)?, first_number(node, arguments, 1, known)?];
            Ok(Value::Number(x.rem_euclid(by)))
        }
        "dot" | "cross" => {
            let [a, b] = values(node, name, arguments, known)?;
            of_two_vectors(name, &a, &b).ok_or_else(|| node.error(format!("`{name}` is of two vectors")))
        }
        "length" | "normalise" => {
            let [value] = values(node, name, arguments, known)?;
            let vector = value
                .numbers()
                .ok_or_else(|| node.error(format!("`{name}` is of a vector, not of {}", value.kind())))?;
            let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
            Ok(if name == "length" { Value::Number(length) } else { list(vector.iter().map(|x| x / length)) })
        }
        _ => {
            let all: Vec<Value> =
                arguments.iter().map(|argument| evaluate(argument, known)).collect::<Result<_, _>>()?;
            lists::call(name, &all).unwrap_or_else(|| Err(unknown(name))).map_err(|message| node.error(message))
        }
    }
}

/// `first("…")`, `within(event, "…")` and their like.
fn ask(node: &Node, name: &str, arguments: &[Node], known: &dyn Known) -> Outcome {
    let (trace, arguments) = of_trace(arguments, known);
    let trace = trace.as_deref();
    let text = |place: usize| match arguments.get(place).map(|argument| evaluate(argument, known)) {
        Some(Ok(Value::Text(text))) => Ok(text),
        Some(Err(error)) => Err(error),
        _ => Err(node.error(format!("`{name}` needs a question in quotes"))),
    };
    let events = |question: Question| known.events(&question).map_err(|message| node.error(message));
    let event = |id: EventId| known.event(trace, id).map_err(|message| node.error(message));
    match name {
        "first" => first(node, trace, &text(0)?, known),
        "count" => Ok(Value::Number(events(Question::to_all(trace, &text(0)?))?.len() as f64)),
        "exists" => Ok(Value::Truth(!events(Question::to_all(trace, &text(0)?))?.is_empty())),
        "all" => events(Question::to_all(trace, &text(0)?))?
            .into_iter()
            .map(event)
            .collect::<Result<_, _>>()
            .map(Value::List),
        "last" | "nth" => {
            let question = text(0)?;
            let found = events(Question::to_all(trace, &question))?;
            let nth = if name == "nth" { first_number(node, arguments, 1, known)? } else { found.len() as f64 };
            let place = found.iter().enumerate().find(|(at, _)| *at as f64 + 1.0 == nth);
            let message =
                || format!("{} events answer `{question}`, and the one asked for is none of them", found.len());
            event(*place.ok_or_else(|| node.error(message()))?.1)
        }
        _ => {
            let id = id_of(node, arguments, known)?;
            let question = text(1)?;
            let (within, above) = if name == "within" { (Some(id), None) } else { (None, Some(id)) };
            let found = events(Question { trace, text: &question, within, above })?;
            // Of those that hold an event, the closest one is meant.
            let chosen = if name == "within" { found.first() } else { found.last() };
            event(*chosen.ok_or_else(|| node.error(format!("no event {name} it answers `{question}`")))?)
        }
    }
}

/// The name of the trace that is asked, where it is not the step's own, and the other arguments.
fn of_trace<'a>(arguments: &'a [Node], known: &dyn Known) -> (Option<String>, &'a [Node]) {
    if let Some((Node { kind: Kind::Name(name), .. }, rest)) = arguments.split_first()
        && let Some(Ok(Value::Trace(trace))) = known.name(name)
    {
        return (Some(trace), rest);
    }
    (None, arguments)
}

fn id_of(node: &Node, arguments: &[Node], known: &dyn Known) -> Result<EventId, ExpressionError> {
    let event = arguments.first().map(|argument| evaluate(argument, known)).transpose()?;
    let id = event.and_then(|event| event.field("id")).and_then(|id| id.number());
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it was written from such a number")]
    id.map(|id| id as EventId).ok_or_else(|| node.error("the first argument is to be an event"))
}

fn values<const N: usize>(
    node: &Node,
    name: &str,
    arguments: &[Node],
    known: &dyn Known,
) -> Result<[Value; N], ExpressionError> {
    let all: Vec<Value> = arguments.iter().map(|argument| evaluate(argument, known)).collect::<Result<_, _>>()?;
    let read = all.len();
    all.try_into().map_err(|_| node.error(format!("`{name}` takes {N} values, and here are {read}")))
}

fn first_number(node: &Node, arguments: &[Node], place: usize, known: &dyn Known) -> Result<f64, ExpressionError> {
    let argument = arguments.get(place).ok_or_else(|| node.error("a number is missing"))?;
    number(argument, known)
}

/// The least or the largest of numbers, or of one list of them.
fn extreme(node: &Node, name: &str, arguments: &[Node], known: &dyn Known) -> Outcome {
    let all: Vec<Value> = arguments.iter().map(|argument| evaluate(argument, known)).collect::<Result<_, _>>()?;
    let all = match all.as_slice() {
        [Value::List(items)] => items.clone(),
        _ => all,
    };
    let Some(numbers) = Value::List(all).numbers() else {
        return Err(node.error(format!("`{name}` is of numbers")));
    };
    let least = if name == "min" { f64::min } else { f64::max };
    numbers
        .into_iter()
        .reduce(least)
        .map(Value::Number)
        .ok_or_else(|| node.error("an empty list has no least and no largest"))
}

/// A function of every number of a list; none where there is something else in it.
pub(super) fn each(value: &Value, function: &dyn Fn(f64) -> f64) -> Option<Value> {
    Some(list(value.numbers()?.into_iter().map(function)))
}

/// Sums of vectors, and vectors times numbers.
pub(super) fn of_vectors(operator: Operator, a: &Value, b: &Value) -> Option<Value> {
    match (operator, a, b) {
        (Operator::Add, Value::Text(a), Value::Text(b)) => Some(Value::Text(format!("{a}{b}"))),
        (Operator::Add | Operator::Subtract | Operator::Multiply, Value::List(_), Value::List(_)) => {
            let (a, b) = (a.numbers()?, b.numbers()?);
            let item = |(a, b): (f64, f64)| match operator {
                Operator::Add => a + b,
                Operator::Subtract => a - b,
                _ => a * b,
            };
            (a.len() == b.len()).then(|| list(a.into_iter().zip(b).map(item)))
        }
        (Operator::Multiply, Value::Number(by), vector) | (Operator::Multiply, vector, Value::Number(by)) => {
            each(vector, &|x| x * by)
        }
        (Operator::Divide, vector, Value::Number(by)) => each(vector, &|x| x / by),
        _ => None,
    }
}

fn of_two_vectors(name: &str, a: &Value, b: &Value) -> Option<Value> {
    if name == "dot" {
        let (a, b) = (a.numbers()?, b.numbers()?);
        return (a.len() == b.len()).then(|| Value::Number(a.iter().zip(&b).map(|(a, b)| a * b).sum()));
    }
    let ([ax, ay, az], [bx, by, bz]) = (a.vector()?, b.vector()?);
    Some(list([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]))
}

/// A list of numbers.
pub(super) fn list(numbers: impl IntoIterator<Item = f64>) -> Value {
    Value::List(numbers.into_iter().map(Value::Number).collect())
}

fn unknown(name: &str) -> String {
    let all = OF_ONE.iter().map(|(known, _)| *known).chain(ASKING).chain(OTHERS);
    let near = all.min_by_key(|known| strsim::damerau_levenshtein(name, known)).unwrap_or("abs");
    format!("there is no function `{name}`; the nearest is `{near}`")
}
