//! Numbers as students type them.

use crate::lesson::expression::{Expression, Known, Question, Value};
use crate::record::EventId;

/// A number: with a point or a comma, as a fraction, with a root, with or without its unit.
///
/// # Errors
/// Why it is none.
pub fn number(typed: &str, unit: &str) -> Result<f64, String> {
    let typed = typed.trim();
    let plain = typed.strip_suffix(unit).unwrap_or(typed).trim().replace('−', "-").replace(['·', '×'], "*");
    let is_decimal_comma = plain.matches(',').count() == 1 && !plain.contains(['.', '(']);
    let plain = if is_decimal_comma { plain.replace(',', ".") } else { plain };
    let number = Expression::parse(&plain).and_then(|expression| expression.number(&Nothing));
    number.map_err(|error| error.message)
}

/// What is typed knows nothing of the recorded ray.
struct Nothing;

impl Known for Nothing {
    fn name(&self, _: &str) -> Option<Result<Value, String>> {
        None
    }

    fn names(&self) -> Vec<String> {
        Vec::new()
    }

    fn events(&self, question: &Question) -> Result<Vec<EventId>, String> {
        Err(format!("`{}` is no number", question.text))
    }

    fn event(&self, _: Option<&str>, _: EventId) -> Result<Value, String> {
        Err(String::new())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_may_be_written_as_people_write_it() {
        for (typed, unit, value) in [
            ("3.5", "", 3.5),
            (" 3,5 ", "", 3.5),
            ("−2", "", -2.0),
            ("14/4", "", 3.5),
            ("sqrt(16)", "", 4.0),
            ("41.8°", "°", 41.8),
            ("2 · 3", "", 6.0),
        ] {
            assert_eq!(number(typed, unit), Ok(value), "{typed}");
        }
    }

    #[test]
    fn what_is_no_number_is_refused_and_the_ray_is_not_asked() {
        for typed in ["", "three", "hit.t", "[1, 2]", "1 +", "true"] {
            assert!(number(typed, "").is_err(), "{typed}");
        }
    }
}
