//! What two events say, field by field and line by line of their working.

use super::Tolerance;
use crate::record::{Event, Value as Result, What, format_number};
use serde_json::{Map, Value};

/// Something that two events say differently.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The field, such as `t` or `candidates 2 reason`, or the symbol of a line of working.
    pub name: String,
    /// What the left event says; none where it says nothing of it.
    pub left: Option<Said>,
    /// What the right event says.
    pub right: Option<Said>,
}

/// What an event says in one field.
#[derive(Clone, Debug, PartialEq)]
pub enum Said {
    /// One number, or the coordinates of a point, direction, colour or place. What is not finite is NaN.
    Numbers(Vec<f64>),
    /// Words, or a truth value.
    Words(String),
}

/// What is there to be drawn, and follows from the rest.
const DRAWN: [&str; 4] = ["samples", "curve", "outline", "footprint"];

/// A field's name and what it says.
type Field = (String, Said);

/// What the two events say differently, in the order of the left one.
pub fn changes(left: &Event, right: &Event, tolerance: &Tolerance) -> Vec<Change> {
    let mut changes = differing(fields(&left.what), fields(&right.what), tolerance);
    let known: Vec<String> = changes.iter().map(|change| change.name.clone()).collect();
    let working = differing(working(left), working(right), tolerance);
    // A line of working often has the name of the field that it works out.
    changes.extend(working.into_iter().filter(|change| !known.contains(&change.name)));
    changes
}

/// Whether two events say the same.
pub fn agree(left: &Event, right: &Event, tolerance: &Tolerance) -> bool {
    let is_equal = left.what == right.what && {
        let lines = |event: &Event| event.working.iter().map(|line| line.result).collect::<Vec<_>>();
        left.working.len() == right.working.len() && lines(left) == lines(right)
    };
    // Numbers that are none differ from themselves, so that what is not equal may still be the same.
    is_equal || changes(left, right, tolerance).is_empty()
}

fn differing(left: Vec<Field>, right: Vec<Field>, tolerance: &Tolerance) -> Vec<Change> {
    let mut changes = Vec::new();
    let mut rest: Vec<Option<Field>> = right.into_iter().map(Some).collect();
    let mut next = 0;
    for (name, left) in left {
        // Both mostly have the same fields in the same order.
        let here = |slot: &Option<Field>| slot.as_ref().is_some_and(|(other, _)| *other == name);
        let place = if rest.get(next).is_some_and(here) { Some(next) } else { rest.iter().position(here) };
        next = place.unwrap_or(next) + usize::from(place.is_some());
        let right = place.and_then(|place| rest[place].take()).map(|(_, said)| said);
        if !right.as_ref().is_some_and(|right| left.agrees(right, tolerance)) {
            changes.push(Change { name, left: Some(left), right });
        }
    }
    changes.extend(rest.into_iter().flatten().map(|(name, said)| Change { name, left: None, right: Some(said) }));
    changes
}

impl Said {
    fn agrees(&self, other: &Self, tolerance: &Tolerance) -> bool {
        match (self, other) {
            (Self::Numbers(a), Self::Numbers(b)) => tolerance.allows(a, b),
            (a, b) => a == b,
        }
    }

    /// The value as people read it, with so many digits that it can be told from `other`.
    #[must_use]
    pub fn text(&self, other: Option<&Self>) -> String {
        match (self, other) {
            (Self::Words(words), _) => words.clone(),
            (Self::Numbers(numbers), Some(Self::Numbers(others))) => {
                let short = written(numbers, &|x| format_number(x));
                if short == written(others, &|x| format_number(x)) { written(numbers, &all_digits) } else { short }
            }
            (Self::Numbers(numbers), _) => written(numbers, &|x| format_number(x)),
        }
    }
}

impl Change {
    /// Both values as people read them; `—` for what is not said.
    #[must_use]
    pub fn texts(&self) -> [String; 2] {
        let text = |one: &Option<Said>, other: &Option<Said>| {
            one.as_ref().map_or_else(|| "—".to_owned(), |said| said.text(other.as_ref()))
        };
        [text(&self.left, &self.right), text(&self.right, &self.left)]
    }
}

fn written(numbers: &[f64], one: &impl Fn(f64) -> String) -> String {
    match numbers {
        [number] => one(*number),
        numbers => format!("({})", numbers.iter().map(|&x| one(x)).collect::<Vec<_>>().join(", ")),
    }
}

/// The shortest text that is read as this very number.
fn all_digits(x: f64) -> String {
    if x.is_finite() { format!("{x:?}").replace('-', "−") } else { format_number(x) }
}

fn working(event: &Event) -> Vec<Field> {
    let said = |result: &Result| match result {
        Result::Number(x) => Said::Numbers(vec![*x]),
        Result::Vector(v) => Said::Numbers(v.to_vec()),
        Result::Truth(truth) => Said::Words(if *truth { "yes" } else { "no" }.to_owned()),
    };
    event.working.iter().map(|line| (line.symbol.to_string(), said(&line.result))).collect()
}

fn fields(what: &What) -> Vec<Field> {
    let mut found = Vec::new();
    if let Ok(Value::Object(members)) = serde_json::to_value(what) {
        collect_members("", &members, &mut found);
    }
    found
}

fn collect_members(prefix: &str, members: &Map<String, Value>, found: &mut Vec<Field>) {
    for (name, value) in members.iter().filter(|(name, _)| !DRAWN.contains(&name.as_str())) {
        collect(joined(prefix, name), value, found);
    }
}

fn collect(name: String, value: &Value, found: &mut Vec<Field>) {
    let number = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
    match value {
        Value::Number(_) | Value::Null => found.push((name, Said::Numbers(vec![number(value)]))),
        Value::Bool(truth) => found.push((name, Said::Words(if *truth { "yes" } else { "no" }.to_owned()))),
        Value::String(words) => found.push((name, Said::Words(words.clone()))),
        Value::Array(items) if is_vector(items) => {
            found.push((name, Said::Numbers(items.iter().map(number).collect())));
        }
        Value::Array(items) => {
            for (k, item) in items.iter().enumerate() {
                collect(joined(&name, &(k + 1).to_string()), item, found);
            }
        }
        Value::Object(members) => collect_members(&name, members, found),
    }
}

/// Two to four numbers, among them perhaps some that are not finite, which JSON writes as nothing.
fn is_vector(items: &[Value]) -> bool {
    (2..=4).contains(&items.len())
        && items.iter().any(Value::is_number)
        && items.iter().all(|item| item.is_number() || item.is_null())
}

fn joined(prefix: &str, name: &str) -> String {
    if prefix.is_empty() { name.to_owned() } else { format!("{prefix} {name}") }
}
