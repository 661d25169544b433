//! Functions of lists, and of interval lists among them.

use super::evaluate::{Known, Question, evaluate};
use super::functions::list;
use super::value::Value;
use super::{Expression, ExpressionError, Node};
use crate::record::EventId;

/// A function of whole values; none where there is none of that name.
pub(super) fn call(name: &str, arguments: &[Value]) -> Option<Result<Value, String>> {
    Some(match (name, arguments) {
        ("len", [Value::List(items)]) => Ok(Value::Number(items.len() as f64)),
        ("sum", [Value::List(items)]) => sum(items),
        ("reversed", [Value::List(items)]) => Ok(Value::List(items.iter().rev().cloned().collect())),
        ("sorted", [value]) => numbers(name, value).map(|mut numbers| {
            numbers.sort_by(f64::total_cmp);
            list(numbers)
        }),
        ("spans", [value]) => spans(value),
        ("unite" | "intersect" | "subtract", [a, b]) => {
            pairs(a).and_then(|a| Ok(written(&combine(name, &a, &pairs(b)?))))
        }
        ("len" | "sum" | "reversed" | "sorted" | "spans", _) => Err(format!("`{name}` is of one list")),
        ("unite" | "intersect" | "subtract", _) => Err(format!("`{name}` is of two interval lists")),
        _ => return None,
    })
}

/// Of numbers their sum, of vectors the sum of each coordinate.
fn sum(items: &[Value]) -> Result<Value, String> {
    if let Some(numbers) = Value::List(items.to_vec()).numbers() {
        return Ok(Value::Number(numbers.iter().sum()));
    }
    let vectors: Option<Vec<Vec<f64>>> = items.iter().map(Value::numbers).collect();
    match vectors {
        Some(vectors) if vectors.windows(2).all(|pair| pair[0].len() == pair[1].len()) => {
            Ok(list((0..vectors[0].len()).map(|k| vectors.iter().map(|vector| vector[k]).sum())))
        }
        _ => Err("`sum` is of numbers, or of vectors of one length".to_owned()),
    }
}

fn numbers(name: &str, value: &Value) -> Result<Vec<f64>, String> {
    value.numbers().ok_or_else(|| format!("`{name}` is of a list of numbers"))
}

/// `map(list, "item.t")` and `where(list, "item.t > 0")`.
pub(super) fn by_item(
    node: &Node,
    name: &str,
    arguments: &[Node],
    known: &dyn Known,
) -> Result<Value, ExpressionError> {
    let [of, by] = arguments else {
        return Err(node.error(format!("`{name}` takes a list and an expression in quotes")));
    };
    let (Value::List(items), Value::Text(text)) = (evaluate(of, known)?, evaluate(by, known)?) else {
        return Err(node.error(format!("`{name}` takes a list and an expression in quotes")));
    };
    let expression = Expression::parse(&text).map_err(|error| by.error(error.message))?;
    let inner = |error: ExpressionError| by.error(error.message);
    let mut kept = Vec::new();
    for item in items {
        let known = WithItem { known, item: &item };
        if name == "map" {
            kept.push(expression.evaluate(&known).map_err(inner)?);
        } else if expression.holds(&known).map_err(inner)? {
            kept.push(item);
        }
    }
    Ok(Value::List(kept))
}

/// What is known, and one item of a list.
struct WithItem<'a> {
    known: &'a dyn Known,
    item: &'a Value,
}

impl Known for WithItem<'_> {
    fn name(&self, name: &str) -> Option<Result<Value, String>> {
        if name == "item" { Some(Ok(self.item.clone())) } else { self.known.name(name) }
    }

    fn names(&self) -> Vec<String> {
        let mut names = self.known.names();
        names.push("item".to_owned());
        names
    }

    fn events(&self, question: &Question) -> Result<Vec<EventId>, String> {
        self.known.events(question)
    }

    fn event(&self, trace: Option<&str>, id: EventId) -> Result<Value, String> {
        self.known.event(trace, id)
    }
}

type Pair = [f64; 2];

/// Recorded intervals as plain pairs of times.
fn spans(value: &Value) -> Result<Value, String> {
    Ok(written(&pairs(value)?))
}

/// The intervals of a list: recorded ones, or pairs. An unbounded end is none.
fn pairs(value: &Value) -> Result<Vec<Pair>, String> {
    let expected = || "an interval list is needed: recorded ones, or pairs of times".to_owned();
    let end = |value: Option<Value>, unbounded: f64| match value {
        Some(Value::Number(t)) => Ok(t),
        None | Some(Value::None) => Ok(unbounded),
        Some(edge) => edge.field("t").and_then(|t| t.number()).ok_or_else(expected),
    };
    let pair = |item: &Value| match item {
        Value::List(ends) if ends.len() == 2 => {
            Ok([end(Some(ends[0].clone()), f64::NEG_INFINITY)?, end(Some(ends[1].clone()), f64::INFINITY)?])
        }
        Value::Record(_) => {
            Ok([end(item.field("enter"), f64::NEG_INFINITY)?, end(item.field("leave"), f64::INFINITY)?])
        }
        _ => Err(expected()),
    };
    match value {
        Value::None => Ok(Vec::new()),
        Value::List(items) => items.iter().map(pair).collect(),
        _ => Err(expected()),
    }
}

fn written(pairs: &[Pair]) -> Value {
    let end = |t: f64| if t.is_finite() { Value::Number(t) } else { Value::None };
    Value::List(pairs.iter().map(|pair| Value::List(pair.iter().map(|&t| end(t)).collect())).collect())
}

/// Two lists as sets of times. What has no length is dropped, what abuts is merged, as everywhere.
fn combine(name: &str, a: &[Pair], b: &[Pair]) -> Vec<Pair> {
    let mut times: Vec<f64> = a.iter().chain(b).flatten().copied().collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let holds = |pairs: &[Pair], t: f64| pairs.iter().any(|[from, to]| *from < t && t < *to);
    let mut combined: Vec<Pair> = Vec::new();
    for ends in times.windows(2) {
        let middle = between(ends[0], ends[1]);
        let (a, b) = (holds(a, middle), holds(b, middle));
        let is_inside = match name {
            "unite" => a || b,
            "intersect" => a && b,
            _ => a && !b,
        };
        match combined.last_mut() {
            Some(last) if is_inside && last[1] == ends[0] => last[1] = ends[1],
            _ if is_inside => combined.push([ends[0], ends[1]]),
            _ => {}
        }
    }
    combined
}

/// A time between two others, either of which may be unbounded.
fn between(from: f64, to: f64) -> f64 {
    match (from.is_finite(), to.is_finite()) {
        (true, true) => f64::midpoint(from, to),
        (true, false) => from + 1.0,
        (false, true) => to - 1.0,
        (false, false) => 0.0,
    }
}
