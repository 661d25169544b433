//! A JSON Schema, as schemars writes it, made ready for checking with good messages.

use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// What a JSON value has to be.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Rule {
    /// A string.
    Text,
    /// `true` or `false`.
    Boolean,
    /// A number in a range.
    Number(Range),
    /// One of some words.
    Word(Vec<String>),
    /// A list with a number of items.
    List { item: Box<Rule>, least: usize, most: usize },
    /// An object with known fields.
    Record(Record),
    /// An object with names of the author's choice.
    Map(Box<Rule>),
    /// A record of one of several kinds; the kind is the value of the field `tag`.
    Tagged { tag: String, variants: Vec<(String, Record)> },
    /// A record of one of several kinds; the kind shows in a field that only it has.
    Keyed(Vec<(String, Record)>),
    /// Any of some rules that take different JSON types.
    Either(Vec<Rule>),
    /// A rule by its name.
    Named(String),
    /// A part of JSON Schema that this reader does not know.
    Unknown(String),
}

/// The range of a number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Range {
    pub whole: bool,
    pub least: Option<f64>,
    pub most: Option<f64>,
    pub above: Option<f64>,
    pub below: Option<f64>,
}

/// The fields of an object.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Record {
    pub fields: Vec<(String, Rule)>,
    pub required: Vec<String>,
}

impl Record {
    pub fn field(&self, name: &str) -> Option<&Rule> {
        self.fields.iter().find(|(field, _)| field == name).map(|(_, rule)| rule)
    }
}

/// A whole schema.
#[derive(Clone, Debug)]
pub(super) struct Rules {
    pub root: Rule,
    pub named: BTreeMap<String, Rule>,
}

impl Rules {
    /// Reads a schema.
    pub fn new(schema: &Value) -> Self {
        let named = entries(schema, "$defs").map(|(name, schema)| (name.clone(), rule(schema))).collect();
        Self { root: rule(schema), named }
    }

    /// Follows names to what they stand for.
    pub fn resolve<'a>(&'a self, rule: &'a Rule) -> &'a Rule {
        match rule {
            // A schema whose root lies within itself, as that of solids does.
            Rule::Named(name) if name == "#" => &self.root,
            Rule::Named(name) => self.named.get(name).map_or(rule, |rule| self.resolve(rule)),
            _ => rule,
        }
    }
}

fn entries<'a>(schema: &'a Value, key: &str) -> impl Iterator<Item = (&'a String, &'a Value)> + use<'a> {
    schema.get(key).and_then(Value::as_object).into_iter().flat_map(Map::iter)
}

fn items<'a>(schema: &'a Value, key: &str) -> impl Iterator<Item = &'a Value> + use<'a> {
    schema.get(key).and_then(Value::as_array).into_iter().flatten()
}

fn words<'a>(schema: &'a Value, key: &str) -> impl Iterator<Item = String> + use<'a> {
    items(schema, key).filter_map(Value::as_str).map(str::to_owned)
}

fn rule(schema: &Value) -> Rule {
    if let Some(reference) = schema.get("$ref").and_then(Value::as_str) {
        return Rule::Named(reference.rsplit('/').next().unwrap_or(reference).to_owned());
    }
    for key in ["oneOf", "anyOf"] {
        if schema.get(key).is_some() {
            return choice(items(schema, key).collect());
        }
    }
    if schema.get("enum").is_some() {
        return Rule::Word(words(schema, "enum").collect());
    }
    if let Some(word) = schema.get("const").and_then(Value::as_str) {
        return Rule::Word(vec![word.to_owned()]);
    }
    match schema.get("type").and_then(Value::as_str) {
        Some("string") => Rule::Text,
        Some("boolean") => Rule::Boolean,
        Some("number") => Rule::Number(range(schema, false)),
        Some("integer") => Rule::Number(range(schema, true)),
        Some("array") => list(schema),
        Some("object") => object(schema),
        _ => Rule::Unknown(schema.to_string()),
    }
}

fn range(schema: &Value, whole: bool) -> Range {
    let limit = |key: &str| schema.get(key).and_then(Value::as_f64);
    let (least, most) = match schema.get("format").and_then(Value::as_str) {
        Some("uint32") => (Some(0.0), Some(f64::from(u32::MAX))),
        Some("int32") => (Some(f64::from(i32::MIN)), Some(f64::from(i32::MAX))),
        _ => (None, None),
    };
    Range {
        whole,
        least: limit("minimum").or(least),
        most: limit("maximum").or(most),
        above: limit("exclusiveMinimum"),
        below: limit("exclusiveMaximum"),
    }
}

fn list(schema: &Value) -> Rule {
    let count = |key: &str| schema.get(key).and_then(Value::as_u64).and_then(|count| usize::try_from(count).ok());
    let item = schema.get("items").map_or(Rule::Unknown("items".to_owned()), rule);
    Rule::List {
        item: Box::new(item),
        least: count("minItems").unwrap_or(0),
        most: count("maxItems").unwrap_or(usize::MAX),
    }
}

fn object(schema: &Value) -> Rule {
    match schema.get("additionalProperties") {
        Some(Value::Object(others)) => Rule::Map(Box::new(rule(&Value::Object(others.clone())))),
        _ => Rule::Record(record(schema)),
    }
}

fn record(schema: &Value) -> Record {
    Record {
        fields: entries(schema, "properties").map(|(name, schema)| (name.clone(), rule(schema))).collect(),
        required: words(schema, "required").collect(),
    }
}

/// Which of several rules is meant has to show in the value itself: in words, in a tag, in a field, or in its type.
fn choice(schemas: Vec<&Value>) -> Rule {
    let rules: Vec<_> = schemas.into_iter().map(rule).collect();
    if rules.iter().all(|rule| matches!(rule, Rule::Word(_))) {
        let words = rules.into_iter().filter_map(|rule| if let Rule::Word(words) = rule { Some(words) } else { None });
        return Rule::Word(words.flatten().collect());
    }
    if !rules.iter().all(|rule| matches!(rule, Rule::Record(_))) {
        return Rule::Either(rules);
    }
    let records =
        rules.into_iter().filter_map(|rule| if let Rule::Record(record) = rule { Some(record) } else { None });
    tagged_or_keyed(records.collect())
}

fn tagged_or_keyed(records: Vec<Record>) -> Rule {
    let tag_of = |record: &Record| {
        record.fields.iter().find_map(|(name, rule)| match rule {
            Rule::Word(words) if words.len() == 1 => Some((name.clone(), words[0].clone())),
            _ => None,
        })
    };
    if let Some(tags) = records.iter().map(tag_of).collect::<Option<Vec<_>>>()
        && let Some((tag, _)) = tags.first().cloned()
    {
        return Rule::Tagged { tag, variants: tags.into_iter().map(|(_, value)| value).zip(records).collect() };
    }
    let key_of = |record: &Record| {
        let alone = |name: &&String| records.iter().filter(|other| other.field(name).is_some()).count() == 1;
        record.required.iter().find(alone).cloned()
    };
    match records.iter().map(key_of).collect::<Option<Vec<_>>>() {
        Some(keys) => Rule::Keyed(keys.into_iter().zip(records).collect()),
        None => Rule::Unknown("a choice without tag or key".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unknown(rule: &Rule) -> Vec<String> {
        let in_record = |record: &Record| record.fields.iter().flat_map(|(_, rule)| unknown(rule)).collect::<Vec<_>>();
        match rule {
            Rule::Unknown(what) => vec![what.clone()],
            Rule::List { item, .. } | Rule::Map(item) => unknown(item),
            Rule::Record(record) => in_record(record),
            Rule::Tagged { variants, .. } | Rule::Keyed(variants) => {
                variants.iter().flat_map(|(_, record)| in_record(record)).collect()
            }
            Rule::Either(rules) => rules.iter().flat_map(unknown).collect(),
            _ => Vec::new(),
        }
    }

    #[test]
    fn every_part_of_the_scene_schema_is_understood() {
        let rules = Rules::new(super::super::scene_schema().as_value());
        let all: Vec<_> = std::iter::once(&rules.root).chain(rules.named.values()).flat_map(unknown).collect();
        assert_eq!(all, Vec::<String>::new());
    }
}
