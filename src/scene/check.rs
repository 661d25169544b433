//! Checks a JSON value against the schema and notes *everything* that is wrong, in words about what was meant.

use super::problem::{Path, Problems, nearest};
use super::rules::{Range, Record, Rule, Rules};
use crate::record::format_number;
use serde_json::{Map, Number, Value};

/// Notes all that is wrong with `value` by `rule`.
pub(super) fn check(rules: &Rules, rule: &Rule, value: &Value, path: Path, problems: &mut Problems) {
    match (rules.resolve(rule), value) {
        // Stands in for a number that could not be read.
        (_, Value::Null) if problems.mention(path) => {}
        (Rule::Unknown(_), _) | (Rule::Text, Value::String(_)) | (Rule::Boolean, Value::Bool(_)) => {}
        (Rule::Number(range), Value::Number(number)) => check_number(range, number, path, problems),
        (Rule::Word(words), Value::String(word)) => check_word(words, word, path, problems),
        (Rule::List { item, least, most }, Value::Array(items)) => {
            if !(*least..=*most).contains(&items.len()) {
                let message = format!("expected {}, found {}", describe(rules, rule), items.len());
                problems.add(path, message);
            }
            for (i, value) in items.iter().enumerate() {
                check(rules, item, value, path.item(i), problems);
            }
        }
        (Rule::Map(item), Value::Object(fields)) => {
            for (name, value) in fields {
                check(rules, item, value, path.field(name), problems);
            }
        }
        (Rule::Record(record), Value::Object(fields)) => check_record(rules, record, fields, path, problems),
        (Rule::Tagged { tag, variants }, Value::Object(fields)) => {
            check_tagged(rules, (tag, variants), fields, path, problems);
        }
        (Rule::Keyed(variants), Value::Object(fields)) => check_keyed(rules, variants, fields, path, problems),
        (Rule::Either(choices), _) => match choices.iter().find(|choice| takes(rules.resolve(choice), value)) {
            Some(choice) => check(rules, choice, value, path, problems),
            None => wrong_type(rules, rule, value, path, problems),
        },
        _ => wrong_type(rules, rule, value, path, problems),
    }
}

fn wrong_type(rules: &Rules, rule: &Rule, value: &Value, path: Path, problems: &mut Problems) {
    problems.add(path, format!("expected {}, found {}", describe(rules, rule), found(value)));
}

fn check_number(range: &Range, number: &Number, path: Path, problems: &mut Problems) {
    let x = number.as_f64().unwrap_or(f64::NAN);
    let inside = range.least.is_none_or(|least| x >= least)
        && range.most.is_none_or(|most| x <= most)
        && range.above.is_none_or(|above| x > above)
        && range.below.is_none_or(|below| x < below);
    if range.whole && x.fract() != 0.0 || !inside {
        // The limits of the integer types are only of interest to who meets them.
        let too_large = range.most.filter(|most| x > *most && *most >= f64::from(i32::MAX));
        let most = too_large.map_or_else(String::new, |most| format!(" and {most} at most"));
        problems.add(path, format!("expected {}{most}, found {number}", describe_number(range)));
    }
}

fn check_word(words: &[String], word: &str, path: Path, problems: &mut Problems) {
    if words.iter().any(|known| known == word) {
        return;
    }
    let problem = problems.add(path, format!("expected {}, found \"{word}\"", describe_words(words)));
    if let Some(near) = nearest(word, words.iter().map(String::as_str)) {
        problem.help(format!("did you mean \"{near}\"?"));
    }
}

fn check_record(rules: &Rules, record: &Record, fields: &Map<String, Value>, path: Path, problems: &mut Problems) {
    let mistyped: Vec<_> = fields.keys().filter(|name| record.field(name).is_none()).collect();
    for (name, value) in fields {
        if let Some(rule) = record.field(name) {
            check(rules, rule, value, path.field(name), problems);
        } else {
            let known = record.fields.iter().map(|(field, _)| field.as_str());
            problems.add_at_name(path.field(name), format!("unknown field `{name}`")).suggest("fields", name, known);
        }
    }
    for name in record.required.iter().filter(|name| !fields.contains_key(*name)) {
        // A mistyped name was noted above, with this name as the one that was meant.
        let meant = |typed: &&&String| nearest(typed, record.fields.iter().map(|(n, _)| n.as_str())) == Some(name);
        if mistyped.iter().find(meant).is_none() {
            let expected = record.field(name).map_or_else(String::new, |rule| describe(rules, rule));
            problems.add(path, format!("the field `{name}` is missing")).help(format!("expected {expected}"));
        }
    }
}

fn check_tagged(
    rules: &Rules,
    (tag, variants): (&str, &[(String, Record)]),
    fields: &Map<String, Value>,
    path: Path,
    problems: &mut Problems,
) {
    let known = variants.iter().map(|(name, _)| name.as_str());
    match fields.get(tag) {
        Some(Value::String(name)) => match variants.iter().find(|(variant, _)| variant == name) {
            Some((_, record)) => check_record(rules, record, fields, path, problems),
            None => {
                problems.add(path.field(tag), format!("unknown {tag} `{name}`")).suggest(
                    &format!("{tag}s"),
                    name,
                    known,
                );
            }
        },
        Some(other) => {
            let message = format!("expected the name of a {tag}, found {}", found(other));
            problems.add(path.field(tag), message);
        }
        None => {
            let near = fields.keys().find(|name| nearest(name, std::iter::once(tag)).is_some());
            match near {
                Some(name) => problems
                    .add_at_name(path.field(name), format!("unknown field `{name}`"))
                    .help(format!("did you mean `{tag}`?")),
                None => {
                    problems.add(path, format!("the field `{tag}` is missing")).suggest(&format!("{tag}s"), "", known)
                }
            };
        }
    }
}

fn check_keyed(
    rules: &Rules,
    variants: &[(String, Record)],
    fields: &Map<String, Value>,
    path: Path,
    problems: &mut Problems,
) {
    let keys = || variants.iter().map(|(key, _)| key.as_str());
    let list = || keys().map(|key| format!("`{key}`")).collect::<Vec<_>>().join(", ");
    let present: Vec<_> = variants.iter().filter(|(key, _)| fields.contains_key(key)).collect();
    match present[..] {
        [(_, record)] => check_record(rules, record, fields, path, problems),
        [(first, _), (second, _), ..] => {
            problems
                .add(path, format!("`{first}` and `{second}` cannot stand together"))
                .help(format!("keep one of {}", list()));
        }
        [] => match fields.keys().find_map(|name| nearest(name, keys()).map(|near| (name, near))) {
            Some((name, near)) => {
                problems
                    .add_at_name(path.field(name), format!("unknown field `{name}`"))
                    .help(format!("did you mean `{near}`?"));
            }
            None => {
                problems.add(path, format!("expected one of the fields {}", list()));
            }
        },
    }
}

/// Whether the rule is about values of this JSON type.
fn takes(rule: &Rule, value: &Value) -> bool {
    match rule {
        Rule::Text | Rule::Word(_) => value.is_string(),
        Rule::Boolean => value.is_boolean(),
        Rule::Number(_) => value.is_number(),
        Rule::List { .. } => value.is_array(),
        Rule::Record(_) | Rule::Map(_) | Rule::Tagged { .. } | Rule::Keyed(_) => value.is_object(),
        Rule::Either(_) | Rule::Named(_) | Rule::Unknown(_) => true,
    }
}

fn describe(rules: &Rules, rule: &Rule) -> String {
    match rules.resolve(rule) {
        Rule::Text => "a string".to_owned(),
        Rule::Boolean => "true or false".to_owned(),
        Rule::Number(range) => describe_number(range),
        Rule::Word(words) => describe_words(words),
        Rule::List { item, least, most } => describe_list(rules, item, *least, *most),
        Rule::Record(_) | Rule::Map(_) | Rule::Keyed(_) => "an object, `{ … }`".to_owned(),
        Rule::Tagged { tag, .. } => format!("an object with a `{tag}`"),
        Rule::Either(rules_) => rules_.iter().map(|rule| describe(rules, rule)).collect::<Vec<_>>().join(" or "),
        Rule::Named(_) | Rule::Unknown(_) => "something else".to_owned(),
    }
}

fn describe_list(rules: &Rules, item: &Rule, least: usize, most: usize) -> String {
    let what = match rules.resolve(item) {
        Rule::Number(range) if range.least == Some(0.0) && !range.whole => "numbers of 0 or more",
        Rule::Number(range) if range.whole => "whole numbers",
        Rule::Number(_) => "numbers",
        Rule::Text => "strings",
        Rule::List { .. } => "lists",
        _ => "objects",
    };
    match (least, most) {
        (least, most) if least == most => format!("a list of {least} {what}"),
        (0, _) => format!("a list of {what}"),
        (least, _) => format!("a list of {least} or more {what}"),
    }
}

fn describe_words(words: &[String]) -> String {
    let quoted: Vec<_> = words.iter().map(|word| format!("\"{word}\"")).collect();
    format!("one of {}", quoted.join(", "))
}

fn describe_number(range: &Range) -> String {
    let kind = if range.whole { "a whole number" } else { "a number" };
    match (range.least, range.most, range.above, range.below) {
        (Some(least), Some(most), ..) if most < f64::from(i32::MAX) => {
            format!("{kind} from {} to {}", format_number(least), format_number(most))
        }
        (Some(least), ..) if least > f64::from(i32::MIN) => format!("{kind}, {} or more", format_number(least)),
        (_, _, Some(above), Some(below)) => {
            format!("{kind}, more than {} and less than {}", format_number(above), format_number(below))
        }
        (_, _, Some(above), None) => format!("{kind}, more than {}", format_number(above)),
        _ => kind.to_owned(),
    }
}

fn found(value: &Value) -> String {
    match value {
        Value::Null => "null".to_owned(),
        Value::Bool(boolean) => boolean.to_string(),
        Value::Number(number) => format!("the number {number}"),
        Value::String(text) if text.chars().count() > 30 => "a string".to_owned(),
        Value::String(text) => format!("the string {text:?}"),
        Value::Array(items) => match items.len() {
            0 => "an empty list".to_owned(),
            1 => "a list of 1 item".to_owned(),
            count => format!("a list of {count} items"),
        },
        Value::Object(_) => "an object".to_owned(),
    }
}
