//! The text of a file: parsing with places kept, and from a place in the JSON to line and column.

use super::problem::{Path, Problems, Step};
use jsonc_parser::ast::{Object, ObjectProp, Value as Ast};
use jsonc_parser::common::{Range, Ranged};
use jsonc_parser::errors::{ParseError, ParseErrorKind};
use jsonc_parser::{CollectOptions, ParseOptions, parse_to_ast};
use serde_json::{Map, Number, Value};

/// How deep brackets may nest. Deeper could exhaust the stack of the parser; no scene that a person wrote comes near.
pub(super) const MOST_NESTING: usize = 200;

/// Strict JSON, nothing more.
const STRICT: ParseOptions = ParseOptions {
    allow_comments: false,
    allow_loose_object_property_names: false,
    allow_trailing_commas: false,
    allow_missing_commas: false,
    allow_single_quoted_strings: false,
    allow_hexadecimal_numbers: false,
    allow_unary_plus_numbers: false,
    allow_bare_decimal_point_numbers: false,
    allow_non_finite_numbers: false,
    allow_extended_string_escapes: false,
};

/// Parses strict JSON.
///
/// # Errors
/// Says what is wrong, and where in the text.
pub(super) fn parse(text: &str) -> Result<Ast<'_>, (Range, String)> {
    check_nesting(text)?;
    let parsed = parse_to_ast(text, &CollectOptions::default(), &STRICT)
        .map_err(|error| (error.range(), syntax_message(text, &error)))?;
    parsed.value.ok_or_else(|| (Range::new(0, 0), "the file is empty: expected a JSON object, `{ … }`".to_owned()))
}

fn syntax_message(text: &str, error: &ParseError) -> String {
    match error.kind() {
        ParseErrorKind::UnexpectedToken | ParseErrorKind::UnexpectedWord => {
            let found: String = error.range().text(text).chars().take(20).collect();
            format!("this is not JSON: `{found}` cannot stand here")
        }
        ParseErrorKind::ExpectedStringObjectProperty => {
            "this is not JSON: the name of a field needs double quotes".to_owned()
        }
        kind => {
            let message = kind.to_string();
            let mut letters = message.chars();
            let first = letters.next().map(|first| first.to_lowercase().to_string()).unwrap_or_default();
            format!("this is not JSON: {first}{}", letters.as_str())
        }
    }
}

fn check_nesting(text: &str) -> Result<(), (Range, String)> {
    let (mut depth, mut in_string, mut escaped) = (0_usize, false, false);
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            _ if escaped => escaped = false,
            b'\\' if in_string => escaped = true,
            b'"' => in_string = !in_string,
            b'{' | b'[' if !in_string => depth += 1,
            b'}' | b']' if !in_string => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth > MOST_NESTING {
            let message = format!("brackets are nested more than {MOST_NESTING} deep");
            return Err((Range::new(at, at + 1), message));
        }
    }
    Ok(())
}

/// The value without its places. Numbers that no `f64` can hold and names that stand twice are noted.
pub(super) fn to_value(ast: &Ast, path: Path, problems: &mut Problems) -> Value {
    match ast {
        Ast::StringLit(string) => Value::String(string.value.clone().into_owned()),
        Ast::NumberLit(number) => to_number(number.value, path, problems),
        Ast::BooleanLit(boolean) => Value::Bool(boolean.value),
        Ast::NullKeyword(_) => Value::Null,
        Ast::Array(array) => {
            let items = array.elements.iter().enumerate();
            Value::Array(items.map(|(i, item)| to_value(item, path.item(i), problems)).collect())
        }
        Ast::Object(object) => Value::Object(to_map(object, path, problems)),
    }
}

fn to_map(object: &Object, path: Path, problems: &mut Problems) -> Map<String, Value> {
    let mut map = Map::new();
    for property in &object.properties {
        let name = property.name.as_str();
        let value = to_value(&property.value, path.field(name), problems);
        if map.insert(name.to_owned(), value).is_some() {
            problems
                .add_at_name(path.field(name), format!("`{name}` stands here more than once"))
                .help("keep one of them");
        }
    }
    map
}

/// A number that cannot be held becomes null. Whole numbers written with a point or an exponent (`640.0`, `1e3`) are whole numbers too, as in JSON Schema.
fn to_number(text: &str, path: Path, problems: &mut Problems) -> Value {
    let finite = text.parse::<f64>().ok().filter(|number| number.is_finite());
    if finite.is_none() {
        problems
            .add(path, format!("the number `{text}` is too large"))
            .help("the largest number that can be held is about 1.8e308");
    }
    let Some(number) = finite else { return Value::Null };
    // Negative zero has no whole number.
    let whole = number.fract() == 0.0 && number.abs() < 9e15 && !(number == 0.0 && number.is_sign_negative());
    #[expect(clippy::cast_possible_truncation, reason = "whole and below 2⁵³")]
    if whole { Value::from(number as i64) } else { Number::from_f64(number).map_or(Value::Null, Value::Number) }
}

/// The range of the text that a problem is about: as far along its steps as the text goes.
pub(super) fn locate(root: &Ast, steps: &[Step], at_name: bool) -> Range {
    let (mut here, mut name) = (root, None);
    for step in steps {
        let next = match (step, here) {
            (Step::Field(field), Ast::Object(object)) => last_property(object, field).map(|property| {
                name = Some(property.name.range());
                &property.value
            }),
            (Step::Item(index), Ast::Array(array)) => array.elements.get(*index),
            _ => None,
        };
        let Some(next) = next else { break };
        here = next;
    }
    match name {
        Some(name) if at_name => name,
        _ => here.range(),
    }
}

/// The property that counts: a later one of the same name replaces an earlier one.
fn last_property<'a, 't>(object: &'a Object<'t>, name: &str) -> Option<&'a ObjectProp<'t>> {
    object.properties.iter().rev().find(|property| property.name.as_str() == name)
}
