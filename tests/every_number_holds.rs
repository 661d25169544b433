//! Every line of working is true: an independent calculator reads the formula with the numbers put in and must come to
//! the result that stands beside it.

mod formula;

use formula::evaluate;
use rayscope::record::{Value, Working};
use rayscope::scene::{embedded_scenes, load};
use rayscope::trace::record_pixel;

fn components(value: &Value) -> Vec<f64> {
    match value {
        Value::Number(x) => vec![*x],
        Value::Vector(v) => v.to_vec(),
        Value::Truth(_) => Vec::new(),
    }
}

/// What is wrong with a line, if anything.
fn complaint(line: &Working) -> Option<String> {
    let worked_out = match evaluate(&line.numbers.to_string()) {
        Ok(value) => value,
        Err(reason) => return Some(reason),
    };
    let result = components(&line.result);
    let agrees = worked_out.0.len() == result.len()
        && worked_out.0.iter().zip(&result).all(|((x, error), y)| (x - y).abs() <= 2.0 * error + 1e-12 * y.abs());
    (!agrees).then(|| format!("comes to {:?}", worked_out.0))
}

#[test]
fn the_calculator_can_calculate() {
    for (text, value) in [
        ("2 + 3·4", 14.0),
        ("−3² + 1", -8.0),
        ("(−3)²", 9.0),
        ("√16 / 2", 2.0),
        ("(1, 2, 2) · (2, 0, 1)", 4.0),
        ("|(1, 2, 2)| |−2|", 6.0),
        ("2 5 / 4 − 1", 1.5),
        ("(1.5·10⁻³)", 0.0015),
        ("arccos 0.5", 60.0),
        ("max(0, −1) + 2^3", 8.0),
        ("2 ⌊−1.5⌋ + 1", -3.0),
        ("3 exp(−2 0.5) − ln 2", 3.0 / std::f64::consts::E - std::f64::consts::LN_2),
    ] {
        let (x, _) = evaluate(text).unwrap_or_else(|e| panic!("{text}: {e}")).0[0];
        assert!((x - value).abs() < 1e-9, "{text} gave {x}");
    }
    assert!(evaluate("2 +").is_err() && evaluate("(1").is_err() && evaluate("a + 1").is_err());
}

#[test]
fn every_line_of_every_worked_example_holds() {
    let mut complaints = Vec::new();
    let mut checked = 0;
    for embedded in embedded_scenes() {
        let scene = load(embedded.text, &embedded.name).unwrap_or_else(|errors| panic!("{errors}"));
        for [x, y] in &scene.pixels {
            for event in record_pixel(&scene, *x, *y).events {
                for line in &event.working {
                    // The matrix is shown beside the line and not within it; truth values are claims, not sums.
                    if line.formula.starts_with("M⁻¹") || matches!(line.result, Value::Truth(_)) {
                        continue;
                    }
                    checked += 1;
                    if let Some(reason) = complaint(line) {
                        complaints.push(format!(
                            "{} {x},{y}: {} = {} = {} = {} but {reason}",
                            embedded.name, line.symbol, line.formula, line.numbers, line.result
                        ));
                    }
                }
            }
        }
    }
    assert!(complaints.is_empty(), "{} of {checked} lines:\n{}", complaints.len(), complaints.join("\n"));
    assert!(checked > 500, "only {checked} lines of working were found");
}
