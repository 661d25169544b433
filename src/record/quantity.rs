//! The numbers of an event by name, so that those of two trees can be laid side by side.

use super::What;
use serde_json::{Map, Value};

/// A number of an event, or a few that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Its name in the event, with its place in lists counted from 1, such as `t`, `candidates 2 t` or `combined 1 enter t`.
    pub name: String,
    /// One number, or the coordinates of a point, direction, colour or place.
    pub parts: Vec<f64>,
}

/// What is there to be drawn, and follows from the rest.
const DRAWN: [&str; 4] = ["samples", "curve", "outline", "footprint"];

impl What {
    /// The numbers of the event that are results of arithmetic, in their order: whole numbers count things, and are left out.
    ///
    /// Undefined and infinite ones are NaN.
    #[must_use]
    pub fn quantities(&self) -> Vec<Quantity> {
        let mut quantities = Vec::new();
        if let Ok(Value::Object(fields)) = serde_json::to_value(self) {
            collect_fields("", &fields, &mut quantities);
        }
        quantities
    }
}

fn collect_fields(prefix: &str, fields: &Map<String, Value>, quantities: &mut Vec<Quantity>) {
    for (name, value) in fields.iter().filter(|(name, _)| !DRAWN.contains(&name.as_str())) {
        collect(&joined(prefix, name), value, quantities);
    }
}

fn collect(name: &str, value: &Value, quantities: &mut Vec<Quantity>) {
    let number = |value: &Value| value.as_f64().filter(|_| value.is_f64());
    match value {
        Value::Number(_) => {
            quantities.extend(number(value).map(|x| Quantity { name: name.to_owned(), parts: vec![x] }));
        }
        Value::Array(items) if is_vector(items) => {
            let parts = items.iter().map(|item| number(item).unwrap_or(f64::NAN)).collect();
            quantities.push(Quantity { name: name.to_owned(), parts });
        }
        Value::Array(items) => {
            for (k, item) in items.iter().enumerate() {
                collect(&joined(name, &(k + 1).to_string()), item, quantities);
            }
        }
        Value::Object(fields) => collect_fields(name, fields, quantities),
        Value::Null | Value::Bool(_) | Value::String(_) => {}
    }
}

/// Two or three numbers; what is not finite is written as nothing.
fn is_vector(items: &[Value]) -> bool {
    (2..=3).contains(&items.len())
        && items.iter().any(Value::is_f64)
        && items.iter().all(|item| item.is_f64() || item.is_null())
}

fn joined(prefix: &str, name: &str) -> String {
    if prefix.is_empty() { name.to_owned() } else { format!("{prefix} {name}") }
}

#[cfg(test)]
mod tests {
    use super::super::{Candidate, CandidateFate, Sense};
    use super::*;

    #[test]
    fn numbers_have_names_and_what_counts_things_is_left_out() {
        let candidate = |t: f64| Candidate {
            t,
            part: "wall".to_owned(),
            sense: Sense::Enter,
            point: [t, 0.5, f64::INFINITY],
            fate: CandidateFate::Accepted,
            reason: String::new(),
        };
        let quantities = What::Roots { candidates: vec![candidate(1.0), candidate(2.5)] }.quantities();
        let names: Vec<_> = quantities.iter().map(|quantity| quantity.name.as_str()).collect();
        assert_eq!(names, ["candidates 1 t", "candidates 1 point", "candidates 2 t", "candidates 2 point"]);
        assert_eq!(quantities[2].parts, [2.5]);
        assert!(quantities[3].parts[..2] == [2.5, 0.5] && quantities[3].parts[2].is_nan());
        let counts = What::Pixel { x: 1, y: 2, width: 3, height: 4 };
        assert_eq!(counts.quantities(), []);
    }
}
