//! Expressions, with values that can be worked out by hand.

use super::*;
use crate::record::EventId;
use serde_json::json;

/// A made-up trace: a hit at t = 4 with a normal along z, and a plane table with two rows.
struct Small;

fn events() -> Vec<(&'static str, serde_json::Value)> {
    vec![
        (
            "planes",
            json!({"id": 0, "kind": "planes", "rows": [
            {"name": "top", "t": 2.0, "sense": "entering"},
            {"name": "front", "t": 4.0, "sense": "entering"},
            {"name": "back", "t": null, "sense": "parallel"},
        ], "stopped": null}),
        ),
        (
            "hit",
            json!({"id": 1, "kind": "hit", "t": 4.0, "n_geometric": [0.0, 0.0, 1.0], "working": [
                {"symbol": "t", "result": 4.0},
            ]}),
        ),
        ("shadow", json!({"id": 2, "kind": "ray", "ray": "shadow"})),
        ("shadow", json!({"id": 3, "kind": "ray", "ray": "shadow"})),
    ]
}

impl Known for Small {
    fn name(&self, name: &str) -> Option<Result<Value, String>> {
        match name {
            "event" => Some(self.event(None, 1)),
            "other" => Some(Ok(Value::Trace("other".to_owned()))),
            _ => None,
        }
    }

    fn names(&self) -> Vec<String> {
        vec!["event".to_owned(), "other".to_owned()]
    }

    fn events(&self, question: &Question) -> Result<Vec<EventId>, String> {
        let all = events();
        let found = all.iter().filter(|(kind, _)| *kind == question.text);
        Ok(found.map(|(_, event)| EventId::try_from(event["id"].as_u64().unwrap_or(0)).unwrap_or(0)).collect())
    }

    fn event(&self, _: Option<&str>, id: EventId) -> Result<Value, String> {
        Ok(Value::from(events()[id as usize].1.clone()))
    }
}

fn value(text: &str) -> Value {
    let expression = Expression::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    expression.evaluate(&Small).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn number(text: &str) -> f64 {
    value(text).number().unwrap_or_else(|| panic!("{text} is no number"))
}

fn problem(text: &str) -> String {
    match Expression::parse(text) {
        Err(error) => error.message,
        Ok(expression) => expression.evaluate(&Small).expect_err("it has no value").message,
    }
}

#[test]
fn products_bind_before_sums_powers_before_signs_and_to_the_right() {
    assert_eq!(number("2 + 3 * 4"), 14.0);
    assert_eq!(number("−2^2"), -4.0);
    assert_eq!(number("2^3^2"), 512.0);
    assert_eq!(number("(2 + 3) * -4 / 8"), -2.5);
    assert_eq!(value("1 < 2 and not 2 < 1 or false"), Value::Truth(true));
}

#[test]
fn values_come_from_events_by_name_place_and_field() {
    assert_eq!(number("hit.t"), 4.0);
    assert_eq!(number("event.n_geometric[2]"), 1.0);
    assert_eq!(number("planes.rows['front'].t - planes.rows[0].t"), 2.0);
    assert_eq!(number("event.working['t'].result"), 4.0);
    assert_eq!(number("count('shadow')"), 2.0);
    assert_eq!(number("last('shadow').id"), 3.0);
    assert_eq!(number("other.count('shadow')"), 2.0);
    assert_eq!(value("planes.stopped"), Value::None);
    assert_eq!(value("exists('snell')"), Value::Truth(false));
}

#[test]
fn lists_are_mapped_chosen_from_and_summed() {
    assert_eq!(number("max(map(where(planes.rows, \"item.sense == 'entering'\"), 'item.t'))"), 4.0);
    assert_eq!(number("len(planes.rows)"), 3.0);
    assert_eq!(number("sum([1, 2, 3])"), 6.0);
    assert_eq!(value("sum([[1, 2], [3, 4]])"), value("[4, 6]"));
}

#[test]
fn vectors_are_added_stretched_and_multiplied() {
    assert_eq!(value("cross([1, 0, 0], [0, 1, 0])"), value("[0, 0, 1]"));
    assert_eq!(number("dot([1, 2, 3], [4, 5, 6])"), 32.0);
    assert_eq!(number("length([2, 3, 6])"), 7.0);
    assert_eq!(value("2 * [1, 2, 3] - [1, 1, 1]"), value("[1, 3, 5]"));
    assert_eq!(value("normalise([0, 3, 4]) ~ [0, 0.6, 0.8]"), Value::Truth(true));
}

#[test]
fn interval_lists_are_united_cut_and_subtracted_as_sets_of_times() {
    assert_eq!(value("unite([[1, 3]], [[2, 5], [7, 8]])"), value("[[1, 5], [7, 8]]"));
    assert_eq!(value("intersect([[1, 3]], [[2, 5]])"), value("[[2, 3]]"));
    assert_eq!(value("subtract([[1, 5]], [[2, 3]])"), value("[[1, 2], [3, 5]]"));
    // What abuts is merged, what has no length is dropped, what is unbounded stays so.
    assert_eq!(value("unite([[1, 2]], [[2, 3]])"), value("[[1, 3]]"));
    assert_eq!(value("intersect([[1, 2]], [[2, 3]])"), value("[]"));
    assert_eq!(value("subtract([[none, none]], [[0, 1]])"), value("[[none, 0], [1, none]]"));
}

#[test]
fn equal_but_for_rounding_is_not_equal_but_for_more() {
    assert_eq!(value("0.1 + 0.2 ~ 0.3"), Value::Truth(true));
    assert_eq!(value("hit.t ~ 4.0001"), Value::Truth(false));
    assert_eq!(value("hit.t ~ 4.1 within 0.2"), Value::Truth(true));
}

#[test]
fn what_is_wrong_is_said_with_what_there_is_instead() {
    assert!(problem("hti.t").contains("did you mean `hit`"), "{}", problem("hti.t"));
    assert!(problem("hit.time").contains("there are id, kind, t"), "{}", problem("hit.time"));
    assert!(problem("sqr(4)").contains("the nearest is `sqrt`"), "{}", problem("sqr(4)"));
    assert!(problem("planes.rows[9].t").contains("the list has 3"), "{}", problem("planes.rows[9].t"));
    assert!(problem("2 +").contains("expected a value"));
    assert!(problem("(2").contains("expected `)`"));
    assert!(problem("'open").contains("no closing quote"));
    assert!(problem("snell.n1").contains("no event of the trace answers `snell`"));
}

#[test]
fn deep_nesting_is_refused_and_does_not_overflow() {
    let deep = "(".repeat(10_000) + "1" + &")".repeat(10_000);
    assert!(problem(&deep).contains("nested too deeply"));
}

#[test]
fn an_expression_of_typed_numbers_alone_refers_to_nothing() {
    let refers = |text: &str| Expression::parse(text).is_ok_and(|expression| expression.refers());
    assert!(!refers("3 + 4 * sqrt(2)"));
    assert!(refers("hit.t + 4") && refers("count('hit')") && refers("len(planes.rows)"));
}

#[test]
fn formats_round_as_they_say() {
    let written = |format: &str, x: f64| Format::parse(format).expect("it is a format").written(&Value::Number(x));
    assert_eq!(written("", 2.345_678_912), "2.34568");
    assert_eq!(written("3", 2.345_678_912), "2.35");
    assert_eq!(written(".1", -0.04), "0.0");
    assert_eq!(written(".2", -2.345_1), "−2.35");
    assert_eq!(written("words", 6.0), "six");
    assert_eq!(written("%", 0.042), "4.2 %");
    assert_eq!(written("°", 41.8), "41.8°");
    assert_eq!(Format::parse("many"), None);
}
