//! Values of expressions.

use crate::record::format_number;
use serde_json::Value as Json;
use std::fmt;

/// What an expression can be.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Nothing: a field that is not there for this event.
    None,
    /// True or false.
    Truth(bool),
    /// A number.
    Number(f64),
    /// A text.
    Text(String),
    /// A list: a point, a table's rows.
    List(Vec<Self>),
    /// Something with named fields: an event, a row, an object of the scene file.
    Record(Json),
    /// Another recorded ray, by its name.
    Trace(String),
}

impl Value {
    /// The number, if it is one.
    #[must_use]
    pub const fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            _ => None,
        }
    }

    /// The numbers of a list that has no others.
    #[must_use]
    pub fn numbers(&self) -> Option<Vec<f64>> {
        match self {
            Self::List(items) => items.iter().map(Self::number).collect(),
            _ => None,
        }
    }

    /// The three numbers of a point or a direction.
    #[must_use]
    pub fn vector(&self) -> Option<[f64; 3]> {
        self.numbers()?.try_into().ok()
    }

    /// The items of a list.
    #[must_use]
    pub fn items(&self) -> Option<&[Self]> {
        match self {
            Self::List(items) => Some(items),
            _ => None,
        }
    }

    /// What it is, in words.
    #[must_use]
    pub const fn kind(&self) -> &'static str {
        match self {
            Self::None => "nothing",
            Self::Truth(_) => "true or false",
            Self::Number(_) => "a number",
            Self::Text(_) => "a text",
            Self::List(_) => "a list",
            Self::Record(_) => "a record with fields",
            Self::Trace(_) => "a trace",
        }
    }

    /// A field of a record. Of a list of records with one item that has the field, nothing is guessed: it has none.
    #[must_use]
    pub fn field(&self, name: &str) -> Option<Self> {
        match self {
            Self::Record(Json::Object(fields)) => fields.get(name).cloned().map(Self::from),
            _ => None,
        }
    }

    /// The names of its fields.
    #[must_use]
    pub fn field_names(&self) -> Vec<&str> {
        match self {
            Self::Record(Json::Object(fields)) => fields.keys().map(String::as_str).collect(),
            _ => Vec::new(),
        }
    }

    /// The item of a list whose name or symbol this is.
    #[must_use]
    pub fn named(&self, name: &str) -> Option<Self> {
        let is_it = |item: &&Self| {
            NAMING.iter().any(|field| matches!(item.field(field), Some(Self::Text(text)) if text == name))
        };
        self.items()?.iter().find(is_it).cloned()
    }

    /// Whether the two are equal, numbers but for a relative error of `within`, at most.
    #[must_use]
    pub fn is_near(&self, other: &Self, within: f64) -> bool {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => a == b || (a - b).abs() <= within,
            (Self::List(a), Self::List(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.is_near(b, within)),
            _ => self == other,
        }
    }

    /// The largest of the numbers in it, without their signs.
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        match self {
            Self::Number(number) => number.abs(),
            Self::List(items) => items.iter().map(Self::magnitude).fold(0.0, f64::max),
            _ => 0.0,
        }
    }
}

/// The fields by which an item of a list is called, in this order.
const NAMING: [&str; 4] = ["name", "symbol", "plane", "part"];

impl From<Json> for Value {
    fn from(json: Json) -> Self {
        match json {
            Json::Null => Self::None,
            Json::Bool(truth) => Self::Truth(truth),
            Json::Number(number) => number.as_f64().map_or(Self::None, Self::Number),
            Json::String(text) => Self::Text(text),
            Json::Array(items) => Self::List(items.into_iter().map(Self::from).collect()),
            record @ Json::Object(_) => Self::Record(record),
        }
    }
}

/// As people read it: six significant digits, points in parentheses, lists with commas.
impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => f.write_str("none"),
            Self::Truth(true) => f.write_str("yes"),
            Self::Truth(false) => f.write_str("no"),
            Self::Number(number) => f.write_str(&format_number(*number)),
            Self::Text(text) => f.write_str(text),
            Self::List(items) => {
                let (open, close) = if self.numbers().is_some() { ("(", ")") } else { ("", "") };
                let items: Vec<_> = items.iter().map(ToString::to_string).collect();
                write!(f, "{open}{}{close}", items.join(", "))
            }
            Self::Record(record) => match record.get("name").and_then(Json::as_str) {
                Some(name) => f.write_str(name),
                None => f.write_str("a record"),
            },
            Self::Trace(name) => write!(f, "the trace {name}"),
        }
    }
}
