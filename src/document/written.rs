//! How values are written into a scene's text: on one line, with spaces inside braces, as the scenes that come with the
//! program are written.

use serde_json::Value;
use std::fmt::Write;

/// The value on one line: `{ "translate": [0, 0, 1.5] }`.
#[must_use]
pub fn written(value: &Value) -> String {
    let mut text = String::new();
    write_value(value, &mut text);
    text
}

fn write_value(value: &Value, text: &mut String) {
    match value {
        Value::Array(items) => {
            text.push('[');
            separated(items.iter(), text, write_value);
            text.push(']');
        }
        Value::Object(fields) if !fields.is_empty() => {
            text.push_str("{ ");
            separated(fields.iter(), text, |(name, value), text| {
                // Writing to a string cannot fail.
                let _ = write!(text, "{}: ", Value::from(name.as_str()));
                write_value(value, text);
            });
            text.push_str(" }");
        }
        Value::Number(number) => text.push_str(&number.as_f64().map_or_else(|| number.to_string(), number_text)),
        other => {
            let _ = write!(text, "{other}");
        }
    }
}

fn separated<T>(items: impl Iterator<Item = T>, text: &mut String, write: impl Fn(T, &mut String)) {
    for (i, item) in items.enumerate() {
        if i > 0 {
            text.push_str(", ");
        }
        write(item, text);
    }
}

/// The shortest text that is read back as the same number; whole numbers have no point.
#[must_use]
pub fn number_text(number: f64) -> String {
    // Negative zero would be read back as another number than it looks like.
    let number = if number == 0.0 { 0.0 } else { number };
    let magnitude = number.abs();
    if magnitude != 0.0 && !(1e-5..1e16).contains(&magnitude) { format!("{number:e}") } else { number.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn values_are_written_as_people_write_them() {
        let value = json!({ "shape": "cube", "transform": [{ "scale": [1.0, 0.5, 2] }], "details": [], "of": {} });
        let expected = r#"{ "shape": "cube", "transform": [{ "scale": [1, 0.5, 2] }], "details": [], "of": {} }"#;
        assert_eq!(written(&value), expected);
    }

    #[test]
    fn numbers_are_read_back_as_they_were() {
        for number in [0.1 + 0.2, 1e-300, -5e300, 12345.678, 1e16, 1e-5, 640.0, f64::MIN_POSITIVE] {
            assert_eq!(number_text(number).parse::<f64>(), Ok(number));
            assert!(serde_json::from_str::<f64>(&number_text(number)).is_ok());
        }
        assert_eq!(number_text(-0.0), "0");
        assert_eq!(number_text(640.0), "640");
    }
}
