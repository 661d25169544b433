//! Figures as people read them: three digits, no more zeros than help.

use crate::laboratory::{Answer, Goal};
use crate::math::portable;

/// A number with three digits that count.
pub fn short(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    if !x.is_finite() {
        return format!("{x}");
    }
    #[expect(clippy::cast_possible_truncation, reason = "the exponents of doubles are small")]
    let power = portable::log10(x.abs()).floor() as i32;
    match power {
        -4..=2 => format!("{x:.*}", usize::try_from(2 - power).unwrap_or(0)),
        3..=5 => format!("{x:.0}"),
        _ => format!("{x:.1e}"),
    }
}

/// A time and how far it scatters, with as many decimals as the time has.
pub fn time(seconds: f64, spread: f64) -> String {
    let (unit, factor) = unit(seconds);
    let value = factor * seconds;
    let decimals = if value >= 100.0 {
        0
    } else if value >= 10.0 {
        1
    } else {
        2
    };
    format!("{value:.decimals$} ± {:.decimals$} {unit}", factor * spread)
}

/// A time alone.
pub fn duration(seconds: f64) -> String {
    let (unit, factor) = unit(seconds);
    format!("{} {unit}", short(factor * seconds))
}

fn unit(seconds: f64) -> (&'static str, f64) {
    if seconds >= 1.0 {
        ("s", 1.0)
    } else if seconds >= 1e-3 {
        ("ms", 1e3)
    } else {
        ("µs", 1e6)
    }
}

/// An answer in words.
pub fn answer(answer: &Answer) -> String {
    let Answer { name, seconds, spread, error, .. } = answer;
    format!("{name}: {} of one thread, error {}", time(*seconds, *spread), short(*error))
}

/// Why there is no answer, and what comes nearest.
pub fn unmet(answer: &Answer) -> String {
    let wanted = match answer.goal {
        Goal::Time(seconds) => format!("nothing that was measured takes at most {}", duration(seconds)),
        Goal::Error(error) => format!("nothing that was measured errs by at most {}", short(error)),
    };
    format!("{wanted}; nearest comes {}", self::answer(answer))
}

/// The question in words.
pub fn goal(goal: Goal) -> String {
    match goal {
        Goal::Time(seconds) => format!("Closest within {}", duration(seconds)),
        Goal::Error(error) => format!("Fastest with an error of at most {}", short(error)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_three_digits_that_count() {
        let numbers = [0.0, 0.012_345, 0.000_123_45, 0.000_012_345, 1.0, 12.345, 123.45, 1234.5, 1.5e9];
        assert_eq!(numbers.map(short), ["0", "0.0123", "0.000123", "1.2e-5", "1.00", "12.3", "123", "1234", "1.5e9"]);
    }

    #[test]
    fn times_and_their_spreads_have_the_same_unit_and_decimals() {
        assert_eq!(time(1.234, 0.05), "1.23 ± 0.05 s");
        assert_eq!(time(0.012_34, 0.000_2), "12.3 ± 0.2 ms");
        assert_eq!(time(0.000_5, 0.000_001), "500 ± 1 µs");
    }
}
