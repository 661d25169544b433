//! What can be written at the cursor: names of fields that are allowed and not there yet, words, names of materials and
//! solids, and values with all that they need.

use super::context::{AtCursor, Context, context_at};
use super::guide::{Allowed, Guide, Rule};
use super::place::{Place, Step};
use super::syntax::Syntax;
use super::written::written;
use serde_json::Value;
use std::ops::Range;

/// Something that can be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Item {
    /// What it is called in the list.
    pub label: String,
    /// What takes the place of the word at the cursor.
    pub text: String,
    /// What it means, from the schema; may be empty.
    pub about: String,
    /// Whether something of its kind has to be written here.
    pub required: bool,
}

/// What can be written at the cursor.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Completion {
    /// The word that is replaced.
    pub word: Range<usize>,
    /// What it can be replaced by: what begins like the word first, then in the order of the schema.
    pub items: Vec<Item>,
}

/// What can be written at an offset of a scene's text.
#[must_use]
pub fn complete(text: &str, syntax: &Syntax, offset: usize) -> Completion {
    let Some(AtCursor { context, word }) = context_at(text, syntax, offset) else { return Completion::default() };
    let whole = syntax.root().map(|root| syntax.value(text, root)).unwrap_or_default();
    let guide = Guide::scene();
    let items = match &context {
        Context::Key { object, own, has_value } => keys(guide, &whole, object, own.as_deref(), *has_value),
        Context::Value { place } => values(guide, &whole, place),
    };
    let begun = text[word.start..offset.clamp(word.start, word.end)].trim_matches('"').to_lowercase();
    Completion { items: matching(items, &begun), word }
}

/// Those that hold what was typed; those that begin with it first.
fn matching(items: Vec<Item>, begun: &str) -> Vec<Item> {
    let holds = |item: &Item| item.label.to_lowercase().contains(begun);
    let mut items: Vec<_> = items.into_iter().filter(holds).collect();
    items.sort_by_key(|item| !item.label.to_lowercase().starts_with(begun));
    items
}

fn keys(guide: &Guide, whole: &Value, object: &Place, own: Option<&str>, has_value: bool) -> Vec<Item> {
    let here = value_at(whole, object);
    let allowed = guide.at(whole, object);
    let rules = guide.fitting(&allowed.rules, here, own);
    let is_written = |name: &str| Some(name) != own && here.is_some_and(|here| here.get(name).is_some());
    let tag = tag_of(&rules).filter(|tag| !is_written(tag));
    let mut items: Vec<Item> = Vec::new();
    for rule in &rules {
        let properties = rule.get("properties").and_then(Value::as_object);
        for (name, property) in properties.into_iter().flatten() {
            let Some(property) = property.as_object() else { continue };
            let is_wanted = !is_written(name) && tag.is_none_or(|tag| tag == name) && is_meant(object, name);
            if is_wanted && tag.is_some() {
                items.push(tag_item(guide, rule, name, has_value));
            } else if is_wanted && !items.iter().any(|item| item.label == *name) {
                items.push(key_item(guide, whole, &object.field(name), property, is_required(rule, name), has_value));
            }
        }
    }
    items.sort_by_key(|item| !item.required);
    items
}

/// The schema has one kind of solid; only objects, which are not parts of others, have a priority.
pub(super) fn is_meant(solid: &Place, name: &str) -> bool {
    let is_object = matches!(&solid.0[..], [Step::Field(list), Step::Item(_)] if list == "objects");
    name != "priority" || is_object
}

/// The field by which alternatives are told apart: each needs it, and each gives it another value.
fn tag_of<'r>(rules: &[&'r Rule]) -> Option<&'r str> {
    if rules.len() < 2 {
        return None;
    }
    let is_tag = |rule: &Rule, name: &str| {
        let property = rule.get("properties").and_then(|properties| properties.get(name));
        is_required(rule, name) && property.is_some_and(|property| property.get("const").is_some())
    };
    let names = rules.first()?.get("properties")?.as_object()?.keys();
    names.map(String::as_str).find(|name| rules.iter().all(|rule| is_tag(rule, name)))
}

fn is_required(rule: &Rule, name: &str) -> bool {
    let required = rule.get("required").and_then(Value::as_array);
    required.is_some_and(|required| required.iter().any(|required| required == name))
}

/// A tag with its value, and with the other fields that this alternative needs.
fn tag_item(guide: &Guide, rule: &Rule, tag: &str, has_value: bool) -> Item {
    let example = guide.example_object(rule);
    let value = example.get(tag).cloned().unwrap_or_default();
    let label = format!("{tag}: {}", value.as_str().unwrap_or_default());
    let text = if has_value { Value::from(tag).to_string() } else { unbraced(&example) };
    Item { label, text, about: about(rule), required: true }
}

fn key_item(guide: &Guide, whole: &Value, place: &Place, property: &Rule, required: bool, has_value: bool) -> Item {
    let name = place.last_field().unwrap_or_default();
    let quoted = Value::from(name).to_string();
    let value = match names_for(whole, place).map(|names| names.first().cloned().unwrap_or_default()) {
        Some(first) => Value::from(first),
        None => guide.example(property),
    };
    let text = if has_value { quoted } else { format!("{quoted}: {}", written(&value)) };
    let allowed = Allowed { uses: vec![property], rules: Vec::new() };
    Item { label: name.to_owned(), text, about: allowed.description(guide).to_owned(), required }
}

/// Fields without the braces around them.
fn unbraced(value: &Value) -> String {
    let text = written(value);
    text.trim_start_matches("{ ").trim_end_matches(" }").to_owned()
}

fn about(rule: &Rule) -> String {
    rule.get("description").and_then(Value::as_str).unwrap_or_default().to_owned()
}

fn values(guide: &Guide, whole: &Value, place: &Place) -> Vec<Item> {
    let allowed = guide.at(whole, place);
    if let Some(names) = names_for(whole, place) {
        let item = |name: String| Item {
            text: Value::from(name.as_str()).to_string(),
            label: name,
            about: String::new(),
            required: false,
        };
        return names.into_iter().map(item).collect();
    }
    let mut items: Vec<Item> = Vec::new();
    for rule in &allowed.rules {
        let value = guide.example(rule);
        let label = rule_label(rule, &value);
        let item = Item { label, text: written(&value), about: about(rule), required: false };
        let is_empty = value.is_null() || value == "";
        if !is_empty && !items.contains(&item) {
            items.push(item);
        }
    }
    if allowed.takes("boolean") {
        items = [true, false].map(|value| plain_item(&Value::from(value))).into();
    }
    if let Some(default) = allowed.default().filter(|default| !default.is_null() && **default != "") {
        let default = plain_item(default);
        items.retain(|item| item.label != default.label);
        let at = items.iter().position(|item| item.text == default.text);
        match at {
            Some(at) => items[..=at].rotate_right(1),
            None => items.insert(0, default),
        }
    }
    items
}

fn plain_item(value: &Value) -> Item {
    let text = written(value);
    Item { label: text.clone(), text, about: String::new(), required: false }
}

/// A word alone for itself, an object by its tag or by what it needs first.
fn rule_label(rule: &Rule, value: &Value) -> String {
    if let Some(word) = value.as_str() {
        return word.to_owned();
    }
    let Some(fields) = value.as_object().filter(|fields| !fields.is_empty()) else { return written(value) };
    let properties = rule.get("properties");
    let is_tag =
        |name: &String| properties.is_some_and(|all| all.get(name).is_some_and(|one| one.get("const").is_some()));
    let tag = fields.iter().find(|(name, _)| is_tag(name)).and_then(|(_, value)| value.as_str());
    tag.map_or_else(|| fields.keys().next().cloned().unwrap_or_default(), str::to_owned)
}

/// The names that a field refers to: materials of the file, or its solids. None where it refers to nothing.
#[must_use]
pub fn names_for(whole: &Value, place: &Place) -> Option<Vec<String>> {
    let (above, Step::Field(name)) = place.parent()? else { return None };
    let is_solid = matches!(above.0.first(), Some(Step::Field(first)) if first == "objects" || first == "solids");
    let list = match name.as_str() {
        "material" if is_solid => "materials",
        "solid" if is_solid => "solids",
        _ => return None,
    };
    let names = whole.get(list).and_then(Value::as_object);
    Some(names.into_iter().flat_map(|names| names.keys().cloned()).collect())
}

/// The value at a place, if it is written.
#[must_use]
pub fn value_at<'v>(whole: &'v Value, place: &Place) -> Option<&'v Value> {
    place.0.iter().try_fold(whole, |here, step| match step {
        Step::Field(name) => here.get(name),
        Step::Item(index) => here.get(index),
    })
}
