//! The working behind a number: the formula, the formula with this ray's numbers put in, and the result.

use super::{Numbers, Triple};
use schemars::JsonSchema;
use serde::Serialize;
use std::borrow::Cow;

/// A result: a number, a vector or a truth value.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Value {
    /// A plain number; non-finite ones are written as `null`.
    Number(f64),
    /// A point, direction or colour.
    Vector(Triple),
    /// The outcome of a test.
    Truth(bool),
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<Triple> for Value {
    fn from(vector: Triple) -> Self {
        Self::Vector(vector)
    }
}

impl From<bool> for Value {
    fn from(truth: bool) -> Self {
        Self::Truth(truth)
    }
}

impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Number(x) => f.write_str(&format_number(*x)),
            Self::Vector([x, y, z]) => {
                write!(f, "({}, {}, {})", format_number(*x), format_number(*y), format_number(*z))
            }
            Self::Truth(true) => f.write_str("yes"),
            Self::Truth(false) => f.write_str("no"),
        }
    }
}

/// How far a result is off by rounding, or may be, and how many of its digits that took.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Accuracy {
    /// The distance from what exact arithmetic gives for the same inputs, or a bound on it.
    pub error: f64,
    /// Decimal digits lost since the inputs: none after a single rounding, all of them where the error is as large as the
    /// result.
    pub digits_lost: f64,
}

/// A number with its accuracy, where the arithmetic keeps one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured<T> {
    /// The number.
    pub value: T,
    /// How far it may be off.
    pub accuracy: Option<Accuracy>,
}

/// What came out of a line of working.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    pub(super) value: Value,
    pub(super) accuracy: Option<Accuracy>,
}

impl<T: Into<Value>> From<T> for Outcome {
    fn from(value: T) -> Self {
        Self { value: value.into(), accuracy: None }
    }
}

impl From<Measured<f64>> for Outcome {
    fn from(number: Measured<f64>) -> Self {
        Self { value: number.value.into(), accuracy: number.accuracy }
    }
}

impl From<Measured<Triple>> for Outcome {
    fn from(vector: Measured<Triple>) -> Self {
        Self { value: vector.value.into(), accuracy: vector.accuracy }
    }
}

/// One line of working, as a student would write it: `symbol = formula = numbers = result`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Working {
    /// What is worked out, such as `B`.
    pub symbol: Cow<'static, str>,
    /// The general formula, such as `S·c`.
    pub formula: &'static str,
    /// The formula with this ray's numbers in place of its symbols.
    #[schemars(with = "String")]
    pub numbers: Numbers,
    /// What came out: the very number that the tracer went on with.
    pub result: Value,
    /// How far the result may be off, where the solver kept account.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub accuracy: Option<Accuracy>,
}

/// A number as people read it: six significant digits, no trailing zeros, powers of ten for the very large and small.
#[must_use]
pub fn format_number(x: f64) -> String {
    if x.is_nan() {
        return "undefined".to_owned();
    }
    if x.is_infinite() {
        return if x > 0.0 { "∞".to_owned() } else { "−∞".to_owned() };
    }
    if x == 0.0 {
        return "0".to_owned();
    }
    let magnitude = x.abs();
    let text = if (1e-4..1e7).contains(&magnitude) { plain_decimal(magnitude) } else { power_of_ten(magnitude) };
    if x < 0.0 { format!("−{text}") } else { text }
}

/// Six significant digits without an exponent, trailing zeros removed.
fn plain_decimal(magnitude: f64) -> String {
    // Nine decimals from 1e-4 on, and with each of these powers of ten one fewer.
    const POWERS: [f64; 9] = [1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3, 1e4, 1e5];
    let decimals = POWERS.iter().filter(|power| magnitude < **power).count();
    let text = format!("{magnitude:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// Four significant digits and a power of ten in superscript, such as `1.234·10⁻⁹`.
fn power_of_ten(magnitude: f64) -> String {
    let scientific = format!("{magnitude:.3e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let mantissa = mantissa.trim_end_matches('0').trim_end_matches('.');
    let exponent: String = exponent.chars().map(superscript).collect();
    if mantissa == "1" { format!("10{exponent}") } else { format!("{mantissa}·10{exponent}") }
}

fn superscript(digit: char) -> char {
    match digit {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_as_people_write_them() {
        for (number, text) in [
            (0.0, "0"),
            (1.0, "1"),
            (-2.5, "−2.5"),
            (1234.5678, "1234.57"),
            (0.000_123_456_7, "0.000123457"),
            (1e-9, "10⁻⁹"),
            (-1.5e12, "−1.5·10¹²"),
            (f64::INFINITY, "∞"),
            (9_999_999.0, "9999999"),
        ] {
            assert_eq!(format_number(number), text);
        }
    }
}
