//! How a value is written.

use super::Value;
use crate::math::portable;
use crate::record::format_number;

/// What stands after the colon of `{{value:format}}`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Format {
    /// Six significant digits.
    #[default]
    Plain,
    /// This many significant digits, at most.
    Significant(usize),
    /// This many decimals.
    Decimals(usize),
    /// With a degree sign, and six significant digits at most.
    Degrees,
    /// In per cent.
    Percent,
    /// A small whole number in words.
    Words,
    /// All digits that tell it from its neighbours.
    Full,
}

const WORDS: [&str; 21] = [
    "no",
    "one",
    "two",
    "three",
    "four",
    "five",
    "six",
    "seven",
    "eight",
    "nine",
    "ten",
    "eleven",
    "twelve",
    "thirteen",
    "fourteen",
    "fifteen",
    "sixteen",
    "seventeen",
    "eighteen",
    "nineteen",
    "twenty",
];

impl Format {
    /// Reads a format; none where the text is none.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let digits = |text: &str| text.parse::<usize>().ok().filter(|&digits| digits <= 17);
        match text.trim() {
            "" => Some(Self::Plain),
            "°" => Some(Self::Degrees),
            "%" => Some(Self::Percent),
            "words" => Some(Self::Words),
            "full" => Some(Self::Full),
            text => match text.strip_prefix('.') {
                Some(decimals) => digits(decimals).map(Self::Decimals),
                None => digits(text).filter(|&digits| digits > 0).map(Self::Significant),
            },
        }
    }

    /// The value as it is written.
    #[must_use]
    pub fn written(self, value: &Value) -> String {
        match value {
            Value::Number(number) => self.number(*number),
            Value::List(items) => {
                let items: Vec<_> = items.iter().map(|item| self.written(item)).collect();
                if value.numbers().is_some() { format!("({})", items.join(", ")) } else { items.join(", ") }
            }
            value => value.to_string(),
        }
    }

    fn number(self, x: f64) -> String {
        match self {
            _ if !x.is_finite() => format_number(x),
            Self::Plain => format_number(x),
            Self::Significant(digits) => significant(x, digits),
            Self::Decimals(decimals) => minus(format!("{x:.decimals$}")),
            Self::Degrees => format!("{}°", format_number(x)),
            Self::Percent => format!("{} %", significant(100.0 * x, 3)),
            Self::Words => in_words(x),
            Self::Full => minus(x.to_string()),
        }
    }
}

fn in_words(x: f64) -> String {
    let place = (0..WORDS.len()).find(|&n| n as f64 == x);
    place.map_or_else(|| format_number(x), |place| WORDS[place].to_owned())
}

/// Rounded to so many digits, and then written as any number of up to six; with more digits as they come.
fn significant(x: f64, digits: usize) -> String {
    let rounded: f64 = format!("{x:.*e}", digits - 1).parse().unwrap_or(x);
    let exponent = portable::log10(x.abs()).floor();
    if digits <= 6 || !(-5.0..15.0).contains(&exponent) {
        return format_number(rounded);
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 22")]
    let decimals = (digits as f64 - 1.0 - exponent).max(0.0) as usize;
    minus(format!("{rounded:.decimals$}"))
}

/// With the sign that people read; no number is minus nothing.
fn minus(text: String) -> String {
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| matches!(c, '0' | '.')) => rest.to_owned(),
        Some(rest) => format!("−{rest}"),
        None => text,
    }
}
