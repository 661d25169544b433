//! Numbers, intervals and tables as text.

use crate::math::portable;
use crate::record::{Accuracy, Certificate, Edge, Span, Triple, format_number};

/// A number with four significant digits, for rows and labels where room is short.
#[must_use]
pub fn brief(x: f64) -> String {
    significant(x, 4)
}

/// A number rounded to `digits` significant digits, written as people write it.
#[must_use]
pub fn significant(x: f64, digits: i32) -> String {
    if x == 0.0 || !x.is_finite() {
        return format_number(x);
    }
    #[expect(clippy::cast_possible_truncation, reason = "a finite number's decimal exponent lies between −324 and 308")]
    let exponent = portable::log10(x.abs()).floor() as i32;
    let shift = digits - 1 - exponent;
    // Beyond these the power of ten itself would overflow; the number is written with an exponent anyway.
    if !(-290..=290).contains(&shift) {
        return format_number(x);
    }
    // Powers of ten up to 10²² are exact; dividing by one keeps 0.1 the nearest double to 0.1.
    let rounded = if shift >= 0 {
        (x * portable::powi(10.0, shift)).round() / portable::powi(10.0, shift)
    } else {
        (x / portable::powi(10.0, -shift)).round() * portable::powi(10.0, -shift)
    };
    format_number(rounded)
}

/// How far a result may be off, behind it: `   ± 4.1·10⁻¹⁶, 0.6 digits lost`.
pub(super) fn accuracy(accuracy: &Accuracy) -> String {
    if accuracy.error == 0.0 {
        return String::new();
    }
    let digits = format_number((accuracy.digits_lost * 10.0).round() / 10.0);
    let lost = if digits == "0" { String::new() } else { format!(", {digits} digits lost") };
    format!("   ± {}{lost}", significant(accuracy.error, 2))
}

/// A point, direction or colour with four significant digits each.
#[must_use]
pub fn brief_vector(v: Triple) -> String {
    format!("({}, {}, {})", brief(v[0]), brief(v[1]), brief(v[2]))
}

/// A point, direction or colour with six significant digits each.
pub(super) fn vector(v: Triple) -> String {
    format!("({}, {}, {})", format_number(v[0]), format_number(v[1]), format_number(v[2]))
}

/// An end of an interval: `3.2 wall of shell`, with a note where the leaf is subtracted.
pub(super) fn edge(edge: &Edge) -> String {
    let turned = if edge.flipped { " (turned round)" } else { "" };
    let turned = if edge.certificate == Certificate::Undecidable { " (undecidable)" } else { turned };
    format!("{} {} of {}{turned}", format_number(edge.t), edge.part, edge.name)
}

/// Inside intervals, such as `[1.2 wall of shell, 3.4 surface of globe]`.
#[must_use]
pub fn span_list(spans: &[Span]) -> String {
    if spans.is_empty() {
        return "empty".to_owned();
    }
    let one = |span: &Span| {
        let enter = span.enter.as_ref().map_or("(−∞".to_owned(), |e| format!("[{}", edge(e)));
        let leave = span.leave.as_ref().map_or("∞)".to_owned(), |e| format!("{}]", edge(e)));
        format!("{enter}, {leave}")
    };
    spans.iter().map(one).collect::<Vec<_>>().join(", ")
}

/// Inside intervals as times alone, such as `[1.2, 3.4] [5, ∞)`.
pub(in crate::view) fn times(spans: &[Span]) -> String {
    if spans.is_empty() {
        return "nothing".to_owned();
    }
    let one = |span: &Span| {
        let enter = span.enter.as_ref().map_or("(−∞".to_owned(), |e| format!("[{}", brief(e.t)));
        let leave = span.leave.as_ref().map_or("∞)".to_owned(), |e| format!("{}]", brief(e.t)));
        format!("{enter}, {leave}")
    };
    match spans {
        [first, second, _, ..] => format!("{} {} and {} more", one(first), one(second), spans.len() - 2),
        few => few.iter().map(one).collect::<Vec<_>>().join(" "),
    }
}

/// `1 hit`, `2 hits`.
pub(in crate::view) fn count(n: usize, noun: &str) -> String {
    match n {
        0 => format!("no {noun}s"),
        1 => format!("1 {noun}"),
        _ => format!("{n} {noun}s"),
    }
}

/// Numbers in order, or `none`.
pub(super) fn number_list(numbers: &[f64]) -> String {
    if numbers.is_empty() {
        return "none".to_owned();
    }
    numbers.iter().map(|&x| format_number(x)).collect::<Vec<_>>().join(", ")
}

/// An angle in degrees.
pub fn degrees(angle: f64) -> String {
    format!("{}°", brief(angle))
}

/// A share as a percentage.
pub(super) fn percent(share: f64) -> String {
    format!("{} %", significant(share * 100.0, 3))
}

/// A recorded sentence with its names in quotation marks: in the record they stand between backticks.
pub fn quoted(sentence: &str) -> String {
    let mut pieces = sentence.split('`');
    let mut text = pieces.next().unwrap_or_default().to_owned();
    for (index, piece) in pieces.enumerate() {
        text.push(if index % 2 == 0 { '“' } else { '”' });
        text.push_str(piece);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_digits_are_enough_for_a_row() {
        for (number, text) in [
            (std::f64::consts::PI, "3.142"),
            (-0.000_123_456, "−0.0001235"),
            (123_456.0, "123500"),
            (0.1, "0.1"),
            (0.0, "0"),
            (1e-300, "10⁻³⁰⁰"),
            (f64::NEG_INFINITY, "−∞"),
        ] {
            assert_eq!(brief(number), text);
        }
    }

    #[test]
    fn an_unbounded_interval_has_round_brackets() {
        let top = Edge {
            t: 2.5,
            leaf: 0,
            name: "ground".into(),
            part: "surface".into(),
            flipped: false,
            certificate: Certificate::Certain,
        };
        assert_eq!(span_list(&[Span { enter: Some(top.clone()), leave: None }]), "[2.5 surface of ground, ∞)");
        assert_eq!(span_list(&[Span { enter: None, leave: Some(top) }]), "(−∞, 2.5 surface of ground]");
        assert_eq!(span_list(&[]), "empty");
    }

    #[test]
    fn names_of_recorded_sentences_stand_in_quotation_marks() {
        assert_eq!(quoted("inside `C`, which is taken away"), "inside “C”, which is taken away");
        assert_eq!(quoted("`a` and `b`"), "“a” and “b”");
        assert_eq!(quoted("nothing is named"), "nothing is named");
    }
}
