//! What a scene file may hold at each place, from its JSON Schema.
//!
//! The schema has alternatives: a solid is one of many shapes. Those alternatives count that what is written so far
//! leaves open.

use super::place::{Place, Step};
use crate::scene::scene_schema;
use serde_json::{Map, Value};
use std::sync::LazyLock;

/// A schema that is an object of keywords.
pub(super) type Rule = Map<String, Value>;

/// The schema, ready to be asked.
#[derive(Debug)]
pub struct Guide {
    schema: Value,
}

/// What may stand at a place.
#[derive(Clone, Debug, Default)]
pub struct Allowed<'g> {
    /// The rules as they are used there: with the description and the default of the field.
    pub(super) uses: Vec<&'g Rule>,
    /// What those rules stand for, references followed and alternatives listed.
    pub(super) rules: Vec<&'g Rule>,
}

/// Alternatives within alternatives go no deeper; it keeps a schema that refers to itself from being followed for ever.
const MOST_ALTERNATIVES: usize = 8;

impl Guide {
    /// The guide to scene files.
    #[must_use]
    pub fn scene() -> &'static Self {
        static SCENE: LazyLock<Guide> = LazyLock::new(|| Guide { schema: scene_schema().as_value().clone() });
        &SCENE
    }

    /// What may stand at a place of a file that holds `whole`.
    #[must_use]
    pub fn at(&self, whole: &Value, place: &Place) -> Allowed<'_> {
        let mut allowed = self.allowed(self.schema.as_object().into_iter().collect());
        let mut here = Some(whole);
        for step in &place.0 {
            allowed = self.inside(&allowed, here, step);
            here = here.and_then(|value| match step {
                Step::Field(name) => value.get(name),
                Step::Item(index) => value.get(index),
            });
        }
        allowed
    }

    /// A solid of a shape, with the parameters that it needs.
    #[must_use]
    pub fn solid(&self, shape: &str) -> Value {
        self.rule_of(shape).map_or_else(|| serde_json::json!({ "shape": shape }), |rule| self.example_object(rule))
    }

    /// Whether a solid of a shape may have a field of this name.
    #[must_use]
    pub fn takes(&self, shape: &str, field: &str) -> bool {
        let properties = self.rule_of(shape).and_then(|rule| rule.get("properties"));
        properties.is_some_and(|properties| properties.get(field).is_some())
    }

    fn rule_of(&self, shape: &str) -> Option<&Rule> {
        let rules = self.allowed(vec![self.definition("#/$defs/SolidFile")?]).rules;
        rules.into_iter().find(|rule| {
            let tag = rule.get("properties").and_then(|properties| properties.get("shape")?.get("const"));
            tag.is_some_and(|tag| tag == shape)
        })
    }

    fn allowed<'g>(&'g self, uses: Vec<&'g Rule>) -> Allowed<'g> {
        let mut rules: Vec<&Rule> = Vec::new();
        for rule in &uses {
            self.expand(rule, MOST_ALTERNATIVES, &mut rules);
        }
        Allowed { uses, rules }
    }

    /// What may stand one step inside a value of which `here` is written.
    fn inside<'g>(&'g self, allowed: &Allowed<'g>, here: Option<&Value>, step: &Step) -> Allowed<'g> {
        let except = match step {
            Step::Field(name) => Some(name.as_str()),
            Step::Item(_) => None,
        };
        let fitting = self.fitting(&allowed.rules, here, except);
        let next = fitting.into_iter().filter_map(|rule| match step {
            Step::Field(name) => {
                let own = rule.get("properties").and_then(|properties| properties.get(name));
                own.or_else(|| rule.get("additionalProperties")).and_then(Value::as_object)
            }
            Step::Item(_) => rule.get("items").and_then(Value::as_object),
        });
        let mut uses: Vec<&Rule> = Vec::new();
        for rule in next {
            if !uses.contains(&rule) {
                uses.push(rule);
            }
        }
        self.allowed(uses)
    }

    /// The rules that what is written leaves open, whatever the field `except` holds.
    pub(super) fn fitting<'g>(
        &'g self,
        rules: &[&'g Rule],
        here: Option<&Value>,
        except: Option<&str>,
    ) -> Vec<&'g Rule> {
        let Some(here) = here else { return rules.to_vec() };
        rules.iter().copied().filter(|rule| self.fits(rule, here, except)).collect()
    }

    /// Whether the value does not contradict the rule; what is missing may still be written.
    fn fits(&self, rule: &Rule, value: &Value, except: Option<&str>) -> bool {
        if value.is_null() {
            return true;
        }
        let fits_type = rule.get("type").and_then(Value::as_str).is_none_or(|name| is_of_type(value, name));
        if !fits_type || rule.get("const").is_some_and(|only| only != value) {
            return false;
        }
        if let (Some(items), Value::Array(_)) = (rule.get("items").and_then(Value::as_object), value)
            && let Some(first) = value.get(0)
        {
            return self.allowed(vec![items]).rules.iter().any(|rule| fits_shallow(rule, first));
        }
        let Value::Object(fields) = value else { return true };
        let Some(properties) = rule.get("properties").and_then(Value::as_object) else { return true };
        let is_open = rule.get("additionalProperties") != Some(&Value::Bool(false));
        fields.iter().filter(|(name, _)| Some(name.as_str()) != except).all(|(name, value)| {
            let Some(property) = properties.get(name).and_then(Value::as_object) else { return is_open };
            let rules = self.allowed(vec![property]).rules;
            value.is_null() || rules.is_empty() || rules.iter().any(|rule| fits_shallow(rule, value))
        })
    }

    /// Lists what a rule stands for: the definition that it refers to, or each of its alternatives.
    fn expand<'g>(&'g self, rule: &'g Rule, depth: usize, rules: &mut Vec<&'g Rule>) {
        let Some(depth) = depth.checked_sub(1) else { return };
        if let Some(target) = rule.get("$ref").and_then(Value::as_str).and_then(|name| self.definition(name)) {
            self.expand(target, depth, rules);
            return;
        }
        let alternatives = ["oneOf", "anyOf"].into_iter().find_map(|word| rule.get(word)).and_then(Value::as_array);
        match alternatives {
            Some(list) => list.iter().filter_map(Value::as_object).for_each(|each| self.expand(each, depth, rules)),
            None if !rules.contains(&rule) => rules.push(rule),
            None => {}
        }
    }

    fn definition(&self, reference: &str) -> Option<&Rule> {
        self.schema.pointer(reference.strip_prefix('#')?)?.as_object()
    }

    /// What the rule says about itself, or else what it refers to.
    fn description<'g>(&'g self, rule: &'g Rule) -> Option<&'g str> {
        let own = rule.get("description").and_then(Value::as_str);
        own.or_else(|| self.definition(rule.get("$ref")?.as_str()?)?.get("description")?.as_str())
    }

    /// A small value that the rule allows: its default where it has one.
    pub(super) fn example(&self, rule: &Rule) -> Value {
        if let Some(value) = rule.get("default").or_else(|| rule.get("const")) {
            return value.clone();
        }
        let Some(rule) = self.allowed_first(rule) else { return Value::Null };
        if let Some(only) = rule.get("const") {
            return only.clone();
        }
        match rule.get("type").and_then(Value::as_str) {
            Some("object") => self.example_object(rule),
            Some("array") => self.example_array(rule),
            Some("string") => Value::from(""),
            Some("boolean") => Value::Bool(false),
            Some("integer" | "number") => example_number(rule),
            _ => Value::Null,
        }
    }

    fn allowed_first<'g>(&'g self, rule: &'g Rule) -> Option<&'g Rule> {
        self.allowed(vec![rule]).rules.first().copied()
    }

    /// The fields that have to be there.
    pub(super) fn example_object(&self, rule: &Rule) -> Value {
        let properties = rule.get("properties").and_then(Value::as_object);
        let required = rule.get("required").and_then(Value::as_array).into_iter().flatten().filter_map(Value::as_str);
        // In the order of the properties, in which they are explained: the tag first.
        let mut names: Vec<&str> = required.collect();
        names.sort_by_key(|name| {
            let property = properties.and_then(|all| all.get(*name));
            (
                property.is_none_or(|property| property.get("const").is_none()),
                properties.and_then(|all| all.keys().position(|key| key == name)),
            )
        });
        let field = |name: &str| {
            let property = properties?.get(name)?.as_object()?;
            Some((name.to_owned(), self.example(property)))
        };
        Value::Object(names.into_iter().filter_map(field).collect())
    }

    /// As many items as there have to be. Three numbers are a direction, pairs are corners, and longer rows a matrix.
    fn example_array(&self, rule: &Rule) -> Value {
        let least = rule.get("minItems").and_then(Value::as_u64).unwrap_or(0);
        let Some(items) = rule.get("items").and_then(Value::as_object) else { return Value::Array(Vec::new()) };
        let item = self.example(items);
        if item.get("normal").is_some() && item.get("offset").is_some() {
            return corner();
        }
        let row = item.as_array().filter(|row| !row.is_empty() && row.iter().all(Value::is_number)).map(Vec::len);
        let place = |i: u64| match row {
            Some(2) => Value::from(vec![u8::from(i == 1), u8::from(i == 2)]),
            Some(length) => (0..length).map(|j| Value::from(u8::from(j as u64 == i))).collect(),
            None if item.is_number() && least == 3 => Value::from(u8::from(i == 2)),
            None => item.clone(),
        };
        (0..least).map(place).collect()
    }
}

/// The kind of the value alone.
fn fits_shallow(rule: &Rule, value: &Value) -> bool {
    let fits_type = rule.get("type").and_then(Value::as_str).is_none_or(|name| is_of_type(value, name));
    fits_type && rule.get("const").is_none_or(|only| only == value || !value.is_string())
}

impl<'g> Allowed<'g> {
    /// What is said about the place; empty where nothing is.
    #[must_use]
    pub fn description(&self, guide: &'g Guide) -> &'g str {
        self.uses.iter().find_map(|rule| guide.description(rule)).unwrap_or_default()
    }

    /// The value that counts where none is written.
    #[must_use]
    pub fn default(&self) -> Option<&'g Value> {
        self.uses.iter().find_map(|rule| rule.get("default"))
    }

    /// The number keywords of what may stand there: the first that names one.
    pub(super) fn limit(&self, word: &str) -> Option<f64> {
        self.rules.iter().chain(&self.uses).find_map(|rule| rule.get(word)).and_then(Value::as_f64)
    }

    /// Whether a value of this type may stand there.
    pub(super) fn takes(&self, name: &str) -> bool {
        self.rules.iter().any(|rule| rule.get("type").and_then(Value::as_str) == Some(name))
    }
}

/// Four planes, fewer bound nothing: the corner of a cube, cut off.
fn corner() -> Value {
    let plane = |normal: [i8; 3], offset: i8| serde_json::json!({ "normal": normal, "offset": offset });
    Value::Array(vec![plane([-1, 0, 0], 0), plane([0, -1, 0], 0), plane([0, 0, -1], 0), plane([1, 1, 1], 1)])
}

fn is_of_type(value: &Value, name: &str) -> bool {
    match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "integer" | "number" => value.is_number(),
        _ => true,
    }
}

fn example_number(rule: &Rule) -> Value {
    let number = |word: &str| rule.get(word).and_then(Value::as_f64);
    let low = number("minimum").or(number("exclusiveMinimum"));
    let high = number("maximum").or(number("exclusiveMaximum"));
    let one_fits = low.is_none_or(|low| low <= 1.0) && high.is_none_or(|high| high >= 1.0);
    let number = if one_fits { 1.0 } else { low.unwrap_or(1.0) };
    #[expect(clippy::cast_possible_truncation, reason = "limits of whole numbers in the schema are small")]
    if number.fract() == 0.0 { Value::from(number as i64) } else { Value::from(number) }
}
