//! A number line: from values to points, with ticks at round numbers.

use crate::math::portable;

/// Maps values to points linearly.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// The values at its ends.
    pub values: [f64; 2],
    /// The points at its ends.
    pub points: [f64; 2],
}

impl Axis {
    /// The point of a value, not beyond a canvas that any screen could have.
    pub fn at(&self, value: f64) -> f64 {
        let share = (value - self.values[0]) / (self.values[1] - self.values[0]);
        let point = self.points[0] + share * (self.points[1] - self.points[0]);
        if point.is_nan() { self.points[0] } else { point.clamp(-1e5, 1e5) }
    }

    /// Whether the value lies between the ends.
    pub fn shows(&self, value: f64) -> bool {
        self.values[0] <= value && value <= self.values[1]
    }

    /// About `count` round values between the ends.
    pub fn ticks(&self, count: f64) -> Vec<f64> {
        let [low, high] = self.values;
        let step = round_step((high - low) / count.max(1.0));
        if !(step.is_finite() && step > 0.0) || (high - low) / step > 1_000.0 {
            return Vec::new();
        }
        let first = (low / step).ceil();
        let ticks = (0..).map(|i| (first + f64::from(i)) * step).take_while(|&tick| tick <= high + step * 1e-9);
        // A tick that is zero but for rounding is zero.
        ticks.map(|tick| if tick.abs() < step * 1e-6 { 0.0 } else { tick }).collect()
    }
}

/// The smallest of 1, 2 or 5 times a power of ten that is not less than `step`.
pub fn round_step(step: f64) -> f64 {
    let power = portable::power_of_ten(portable::log10(step).floor());
    let factor = [1.0, 2.0, 5.0, 10.0].into_iter().find(|factor| factor * power >= step * (1.0 - 1e-9)).unwrap_or(10.0);
    factor * power
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_stand_at_round_numbers() {
        let axis = Axis { values: [-0.7, 4.1], points: [0.0, 480.0] };
        assert_eq!(axis.ticks(5.0), [0.0, 1.0, 2.0, 3.0, 4.0]);
        assert_eq!(axis.ticks(3.0), [0.0, 2.0, 4.0]);
        assert!((axis.at(4.1) - 480.0).abs() < 1e-9);
    }

    #[test]
    fn an_axis_without_length_has_no_ticks_and_no_nan() {
        let axis = Axis { values: [2.0, 2.0], points: [10.0, 20.0] };
        assert!(axis.ticks(5.0).is_empty());
        assert!((axis.at(2.0) - 10.0).abs() < 1e-9);
    }

    #[test]
    fn steps_are_1_2_or_5() {
        for (step, round) in [(0.9, 1.0), (1.1, 2.0), (0.03, 0.05), (7.0, 10.0), (200.0, 200.0)] {
            assert!((round_step(step) - round).abs() < 1e-9 * round);
        }
    }
}
