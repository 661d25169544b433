//! A logarithmic axis: its range, its ticks and their names.

use crate::math::portable;
use crate::view::axis::Axis;

/// Maps positive values to points by their logarithms.
#[derive(Clone, Copy, Debug)]
pub struct LogScale {
    axis: Axis,
}

/// A line across the field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tick {
    /// Its value.
    pub value: f64,
    /// Whether it is a power of ten.
    pub major: bool,
    /// Whether its number is written beside it.
    pub named: bool,
}

/// Less than this many decades would make differences look larger than they are.
const LEAST_DECADES: f64 = 0.7;
/// With fewer powers of ten than this, 2 and 5 times them are named as well.
const FEW: usize = 3;

impl LogScale {
    /// An axis over all positive ones of the values, between two places in points.
    pub fn over(values: impl Iterator<Item = f64>, points: [f64; 2]) -> Self {
        let logs: Vec<f64> = values.filter(|value| value.is_finite() && *value > 0.0).map(portable::log10).collect();
        let low = logs.iter().copied().fold(f64::INFINITY, f64::min);
        let high = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let [low, high] = if low <= high { [low, high] } else { [-1.0, 0.0] };
        let missing = (0.5 * (LEAST_DECADES - (high - low))).max(0.0);
        Self { axis: Axis { values: [low - missing, high + missing], points } }
    }

    /// The point of a value; what has no logarithm lies at the low end.
    pub fn at(&self, value: f64) -> f64 {
        if value > 0.0 { self.axis.at(portable::log10(value)) } else { self.axis.points[0] }
    }

    /// The lines between two places in points, from low to high.
    pub fn ticks(&self, between: [f64; 2]) -> Vec<Tick> {
        let [low, high] = [between[0].min(between[1]), between[0].max(between[1])];
        let [first, last] = self.axis.values;
        let slack = 1.0 + 0.2 * (last - first);
        #[expect(clippy::cast_possible_truncation, reason = "logarithms of f64 are a few hundred")]
        let powers = (first - slack).floor() as i32..=(last + slack).ceil() as i32;
        let all = powers.flat_map(|power| (1..10).map(move |k| (f64::from(k), portable::powi(10.0, power))));
        let shown: Vec<_> = all.filter(|(k, power)| (low..=high).contains(&self.at(k * power))).collect();
        let majors = shown.iter().filter(|(k, _)| *k == 1.0).count();
        let named = |k: f64| k == 1.0 || (majors < FEW && (k == 2.0 || k == 5.0));
        shown.into_iter().map(|(k, power)| Tick { value: k * power, major: k == 1.0, named: named(k) }).collect()
    }
}

/// A time with two digits and a unit that suits it: `50 ms`.
#[must_use]
pub fn seconds(value: f64) -> String {
    let (scaled, unit) = match value {
        v if v < 0.999e-6 => (v * 1e9, "ns"),
        v if v < 0.999e-3 => (v * 1e6, "µs"),
        v if v < 0.999 => (v * 1e3, "ms"),
        v => (v, "s"),
    };
    format!("{} {unit}", significant(scaled))
}

/// An error on an axis: plain from a thousandth on, else as a power of ten.
pub fn error(value: f64) -> String {
    if value >= 0.999e-3 {
        return significant(value);
    }
    let power = (portable::log10(value) + 1e-9).floor();
    let digit = (value / portable::power_of_ten(power)).round();
    #[expect(clippy::cast_possible_truncation, reason = "logarithms of f64 are a few hundred")]
    let power = crate::view::log_plot::power_of_ten(power as i32);
    if digit > 1.5 { format!("{digit} · {power}") } else { power }
}

/// Two digits, without zeros behind the point.
fn significant(value: f64) -> String {
    let power = portable::log10(value.abs().max(1e-300)).floor();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at least 0")]
    let decimals = (1.0 - power).clamp(0.0, 12.0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tenfold_is_as_long_everywhere() {
        let scale = LogScale::over([0.01, 100.0].into_iter(), [0.0, 400.0]);
        for (value, point) in [(0.01, 0.0), (0.1, 100.0), (1.0, 200.0), (100.0, 400.0)] {
            assert!((scale.at(value) - point).abs() < 1e-9, "{value}");
        }
    }

    #[test]
    fn a_narrow_range_names_twos_and_fives_and_a_wide_one_only_powers_of_ten() {
        let named = |low: f64, high: f64| {
            let scale = LogScale::over([low, high].into_iter(), [0.0, 400.0]);
            let ticks = scale.ticks([-1e-6, 400.000_001]);
            ticks.into_iter().filter(|tick| tick.named).map(|tick| seconds(tick.value)).collect::<Vec<_>>()
        };
        assert_eq!(named(0.04, 0.3), ["50 ms", "100 ms", "200 ms"]);
        assert_eq!(named(1e-3, 1.0), ["1 ms", "10 ms", "100 ms", "1 s"]);
    }

    #[test]
    fn one_value_and_none_still_make_an_axis() {
        for values in [vec![3.0], vec![], vec![0.0, f64::NAN]] {
            let scale = LogScale::over(values.into_iter(), [0.0, 100.0]);
            assert!(scale.at(3.0).is_finite() && scale.at(0.0) == 0.0);
            assert!(!scale.ticks([0.0, 100.0]).is_empty());
        }
    }

    #[test]
    fn errors_read_as_people_write_them() {
        assert_eq!([0.5, 0.02, 1e-3, 1e-4, 2e-5].map(error), ["0.5", "0.02", "0.001", "10⁻⁴", "2 · 10⁻⁵"]);
    }
}
