//! `--format csv`: a line for each point, all digits.

use super::Findings;
use super::data::knob_and_value;
use std::fmt::Write;

const HEAD: &str = "knob,value,seconds,spread,repeats,noise,times_standard,rmse,p999,wrong_pixels,dissimilarity,\
                    change,frontier,control,instructions\n";

/// The points as comma-separated values (RFC 4180), the scene as it stands first.
pub fn csv(findings: &Findings) -> String {
    let study = &findings.run.study;
    let standard = study.standard.timing.told();
    let mut text = HEAD.to_owned();
    for (k, point) in std::iter::once(&study.standard).chain(&study.points).enumerate() {
        let (knob, value) = knob_and_value(point);
        let times = point.timing.told().zip(standard).map(|(time, standard)| time / standard);
        let number = |x: Option<f64>| x.map_or_else(String::new, |x| x.to_string());
        let noise = point.timing.noise.map_or_else(String::new, |noise| noise.describe());
        let counted = findings.instructions.get(k).copied().flatten();
        let fields = [
            knob,
            value,
            number(point.timing.told()),
            number(Some(point.timing.spread)),
            point.timing.repeats.to_string(),
            noise,
            number(times),
            number(Some(point.errors.rmse)),
            number(Some(point.errors.p999)),
            point.errors.wrong_pixels.to_string(),
            number(Some(point.errors.dissimilarity)),
            number(Some(point.change.rmse)),
            point.on_frontier.to_string(),
            point.is_control().to_string(),
            counted.map_or_else(String::new, |count| count.to_string()),
        ];
        let _ = writeln!(text, "{}", fields.map(|field| quoted(&field)).join(","));
    }
    text
}

fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n']) { format!("\"{}\"", field.replace('"', "\"\"")) } else { field.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_with_commas_or_quotes_are_quoted() {
        assert_eq!(["a b", "a, b", "a \"b\""].map(quoted), ["a b", "\"a, b\"", "\"a \"\"b\"\"\""]);
    }
}
