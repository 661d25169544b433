//! From repeated times to one that may be told, or to the reason why not.
//!
//! The median of n times whose half interquartile range is s is uncertain by about 1.253 · 1.483 s / √n: 1.483 s estimates
//! the standard deviation of times that err normally, and the median errs √(π/2) = 1.253 times as much as the mean would.

use super::{Noise, Timing};
use crate::ledger::quantile;
use std::f64::consts::FRAC_PI_2;

/// One repeat of a measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repeat {
    /// What a picture took, in seconds of one thread.
    pub seconds: f64,
    /// The share of the time on the wall in which the thread waited.
    pub waiting: f64,
}

/// Half an interquartile range in standard deviations, for times that err normally: 1 / Φ⁻¹(3/4).
const DEVIATIONS: f64 = 1.482_602;

/// A median that is uncertain by more than this share of itself is noise. More would let pass what a look at the table calls
/// a contradiction; less would call noise what still orders the settings rightly.
const MOST_UNCERTAIN: f64 = 0.10;

/// A thread that waits for more than this share of its time shares its core: its caches are not its own. With less, no machine
/// that does anything else would be quiet enough.
const MOST_WAITING: f64 = 0.25;

/// A time of fewer steps of the clock is read with an error above one percent.
const FEWEST_STEPS: f64 = 100.0;

/// Fewer repeats say nothing about how far they scatter.
pub const FEWEST_REPEATS: u32 = 3;

/// A row is sure when its median is uncertain by no more than this.
pub const SURE: f64 = 0.03;

/// With fewer repeats quartiles that lie close together may be luck.
pub const SURE_REPEATS: u32 = 5;

impl Timing {
    /// The time that repeats tell. Those in which the thread waited too long do not count, as long as enough others are left.
    /// `steps` says of how many of the clock's steps one reading is.
    #[must_use]
    pub fn of(repeats: &[Repeat], steps: impl Fn(f64) -> f64) -> Self {
        let calm: Vec<Repeat> = repeats.iter().filter(|repeat| repeat.waiting <= MOST_WAITING).copied().collect();
        let counted = if calm.len() >= FEWEST_REPEATS as usize { &calm } else { repeats };
        let all = |value: fn(&Repeat) -> f64| counted.iter().map(value).collect::<Vec<_>>();
        let seconds = quantile(all(|repeat| repeat.seconds), 0.5);
        let quartile = |share| quantile(all(|repeat| repeat.seconds), share);
        let spread = 0.5 * (quartile(0.75) - quartile(0.25));
        let count = u32::try_from(counted.len()).unwrap_or(u32::MAX);
        let mut timing = Self { seconds, spread, repeats: count, noise: None };
        timing.noise = timing.noise(quantile(all(|repeat| repeat.waiting), 0.5), steps(seconds));
        timing
    }

    fn noise(&self, waiting: f64, steps: f64) -> Option<Noise> {
        if steps < FEWEST_STEPS {
            Some(Noise::Clock(steps))
        } else if waiting > MOST_WAITING {
            Some(Noise::Waiting(waiting))
        } else if self.uncertainty() > MOST_UNCERTAIN {
            Some(Noise::Spread(self.uncertainty()))
        } else {
            None
        }
    }

    /// By what share of itself the median may be off: one standard deviation. Infinite for too few repeats.
    #[must_use]
    pub fn uncertainty(&self) -> f64 {
        if self.repeats < FEWEST_REPEATS || self.seconds <= 0.0 {
            return f64::INFINITY;
        }
        FRAC_PI_2.sqrt() * DEVIATIONS * self.spread / f64::from(self.repeats).sqrt() / self.seconds
    }

    /// Whether measuring on would tell little more: it is sure enough, and did not have to wait for others.
    #[must_use]
    pub fn is_sure(&self) -> bool {
        let may_get_better = matches!(self.noise, Some(Noise::Waiting(_) | Noise::Spread(_)));
        self.repeats >= SURE_REPEATS && self.uncertainty() <= SURE && !may_get_better
    }
}

impl Noise {
    /// The reason in words.
    #[must_use]
    pub fn describe(&self) -> String {
        match self {
            Self::Spread(share) if share.is_finite() => format!("too noisy to tell (±{:.0} %)", 100.0 * share),
            Self::Spread(_) => format!("too noisy to tell (fewer than {FEWEST_REPEATS} repeats)"),
            Self::Waiting(share) => format!("too noisy to tell (waited {:.0} % of the time)", 100.0 * share),
            Self::Clock(steps) => format!("too short to tell ({steps:.1} steps of the clock)"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn timing(seconds: &[f64], waiting: f64, step: f64) -> Timing {
        let repeats: Vec<_> = seconds.iter().map(|&seconds| Repeat { seconds, waiting }).collect();
        Timing::of(&repeats, |seconds| seconds / step)
    }

    #[test]
    fn steady_times_are_told_with_their_median_and_half_interquartile_range() {
        let timing = timing(&[1.02, 0.98, 1.0, 1.01, 0.99], 0.0, 1e-6);
        assert_eq!(timing.told(), Some(1.0));
        assert!((timing.spread - 0.01).abs() < 1e-12 && timing.is_sure(), "{timing:?}");
    }

    #[test]
    fn one_stall_among_many_repeats_changes_nothing() {
        let timing = timing(&[1.0, 1.0, 1.0, 60.0, 1.0], 0.0, 1e-6);
        assert_eq!((timing.told(), timing.spread), (Some(1.0), 0.0));
    }

    #[test]
    fn times_that_jitter_by_their_own_size_are_noise() {
        let timing = timing(&[1.0, 2.0, 0.5, 3.0, 1.5], 0.0, 1e-6);
        assert!(matches!(timing.noise, Some(Noise::Spread(share)) if share > 0.1), "{timing:?}");
        assert_eq!(timing.told(), None);
    }

    #[test]
    fn more_repeats_make_a_median_surer_by_the_root_of_their_number() {
        let few = timing(&[0.9, 1.0, 1.1, 0.9, 1.1], 0.0, 1e-6);
        let many = timing(&[[0.9, 1.0, 1.1, 0.9, 1.1]; 16].concat(), 0.0, 1e-6);
        assert!((few.uncertainty() / many.uncertainty() - 4.0).abs() < 1e-9, "{few:?} {many:?}");
    }

    #[test]
    fn a_thread_that_waits_and_a_clock_that_is_too_coarse_are_noise() {
        assert_eq!(timing(&[1.0; 9], 0.3, 1e-6).noise, Some(Noise::Waiting(0.3)));
        assert_eq!(timing(&[1.0; 9], 0.0, 0.02).noise, Some(Noise::Clock(50.0)));
        assert_eq!(timing(&[1.0; 9], 0.2, 0.01).noise, None);
    }

    #[test]
    fn repeats_in_which_the_thread_waited_do_not_count_where_others_are_left() {
        let repeat = |seconds, waiting| Repeat { seconds, waiting };
        let calm = [repeat(1.0, 0.0), repeat(1.01, 0.1), repeat(0.99, 0.2)];
        let busy = [repeat(1.5, 0.5); 4];
        let timing = Timing::of(&[&busy[..], &calm].concat(), |_| f64::INFINITY);
        assert_eq!((timing.told(), timing.repeats), (Some(1.0), 3));
        let timing = Timing::of(&[&busy[..], &calm[..2]].concat(), |_| f64::INFINITY);
        assert_eq!((timing.noise, timing.repeats), (Some(Noise::Waiting(0.5)), 6));
    }

    #[test]
    fn what_was_measured_once_or_never_is_not_told() {
        for times in [&[][..], &[1.0], &[1.0, 1.0]] {
            assert_eq!(timing(times, 0.0, 1e-9).told(), None);
        }
    }

    #[test]
    fn every_reason_is_given_in_words() {
        let told = [Noise::Spread(0.231), Noise::Spread(f64::INFINITY), Noise::Waiting(0.4), Noise::Clock(3.25)];
        assert_eq!(
            told.map(|noise| noise.describe()),
            [
                "too noisy to tell (±23 %)",
                "too noisy to tell (fewer than 3 repeats)",
                "too noisy to tell (waited 40 % of the time)",
                "too short to tell (3.2 steps of the clock)",
            ]
        );
    }
}
