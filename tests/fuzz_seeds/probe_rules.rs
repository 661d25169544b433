//! What holds for the answers to any bytes at all, taken as requests. The fuzz target and the tests share these rules.

use rayscope::cli::answers;
use serde_json::Value;

/// Answers the bytes as requests; the error says which rule is broken.
pub fn check_probe(requests: &[u8]) -> Result<(), String> {
    for line in answers(requests).split(|&byte| byte == b'\n').filter(|line| !line.is_empty()) {
        let text = String::from_utf8_lossy(line);
        let answer: Value = serde_json::from_slice(line).map_err(|error| format!("{error}: {text}"))?;
        check_answer(&answer).map_err(|problem| format!("{problem}: {text}"))?;
    }
    Ok(())
}

fn check_answer(answer: &Value) -> Result<(), String> {
    match (answer.get("error"), answer.get("hits")) {
        (Some(error), _) => match error.as_str() {
            Some(text) if !text.is_empty() => Ok(()),
            _ => Err("a refusal without a reason".to_owned()),
        },
        (None, Some(hits)) => check_hits(hits, answer.get("inside")),
        (None, None) => check_interface(answer),
    }
}

/// Hits are numbers, ascending, with unit normals; the spans inside ascend and are apart, and only the outermost ends may
/// be missing.
fn check_hits(hits: &Value, inside: Option<&Value>) -> Result<(), String> {
    let hits = hits.as_array().ok_or("the hits are no list")?;
    let mut times = Vec::new();
    for hit in hits {
        times.push(hit["t"].as_f64().ok_or("a hit without a time")?);
        let normal = numbers(&hit["normal"]).filter(|n| n.len() == 3).ok_or("a normal without numbers")?;
        let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        if (length - 1.0).abs() > 1e-9 {
            return Err(format!("a normal of length {length}"));
        }
    }
    if !times.is_sorted() {
        return Err("hits out of order".to_owned());
    }
    let spans = inside.and_then(Value::as_array).ok_or("no spans inside")?;
    let mut before = f64::NEG_INFINITY;
    for (i, span) in spans.iter().enumerate() {
        let missing = |end: usize, first_or_last: bool| match &span[end] {
            Value::Null if first_or_last => Ok(None),
            Value::Number(number) => Ok(number.as_f64()),
            _ => Err("a span without an end"),
        };
        let low = missing(0, i == 0)?.unwrap_or(f64::NEG_INFINITY);
        let high = missing(1, i + 1 == spans.len())?.unwrap_or(f64::INFINITY);
        // A stretch inside that is thinner than the last digit of t has two ends at the same t.
        if low > high || (i > 0 && low <= before) {
            return Err(format!("the span {low} to {high} ends before it begins, or overlaps the one before"));
        }
        before = high;
    }
    Ok(())
}

fn check_interface(answer: &Value) -> Result<(), String> {
    numbers(&answer["reflected"]).ok_or("a reflected direction without numbers")?;
    if !answer["refracted"].is_null() {
        numbers(&answer["refracted"]).ok_or("a refracted direction without numbers")?;
        answer["cos_t"].as_f64().ok_or("no cosine of refraction")?;
    }
    answer["cos_i"].as_f64().ok_or("no cosine of incidence")?;
    let share = answer["reflectance"].as_f64().ok_or("no reflectance")?;
    if (0.0..=1.0).contains(&share) { Ok(()) } else { Err(format!("a reflectance of {share}")) }
}

fn numbers(value: &Value) -> Option<Vec<f64>> {
    value.as_array()?.iter().map(Value::as_f64).collect()
}
