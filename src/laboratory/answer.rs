//! The two questions that people ask: how close can it be in this time, and how fast with this error.

use super::{Point, Study};
use crate::scene::Profile;
use std::cmp::Ordering;

/// What is asked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Goal {
    /// The closest picture within so many seconds of one thread, for the whole of the scene's picture.
    Time(f64),
    /// The fastest picture with an error of at most this: a root mean square in linear RGB.
    Error(f64),
}

/// What is answered.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// What was asked.
    pub goal: Goal,
    /// Whether there is a setting that does it; otherwise this is the one that comes nearest.
    pub is_met: bool,
    /// The settings in words.
    pub name: String,
    /// All of them together.
    pub profile: Profile,
    /// What the whole picture should take, in seconds of one thread.
    pub seconds: f64,
    /// Half the distance between the quartiles of that.
    pub spread: f64,
    /// What its error should be.
    pub error: f64,
}

impl Goal {
    /// Whether something that takes so long and errs by so much will do.
    #[must_use]
    pub fn is_met(self, seconds: f64, error: f64) -> bool {
        match self {
            Self::Time(most) => seconds <= most,
            Self::Error(most) => error <= most,
        }
    }

    /// Which of two is the better answer; the smaller one is. Those that meet the goal come first, the best of them by what
    /// was left open; the others by how near they come.
    #[must_use]
    pub fn rank(self, seconds: f64, error: f64) -> (bool, [f64; 2]) {
        let is_met = self.is_met(seconds, error);
        let order = match (self, is_met) {
            (Self::Time(_), true) | (Self::Error(_), false) => [error, seconds],
            (Self::Time(_), false) | (Self::Error(_), true) => [seconds, error],
        };
        (!is_met, order)
    }

    /// What was measured, the best first. `scale` is how many times as many pixels the whole picture has as those that were
    /// measured.
    #[must_use]
    pub fn ranked(self, study: &Study, scale: f64) -> Vec<Answer> {
        let all = std::iter::once(&study.standard).chain(&study.points).filter(|point| !point.is_control());
        let mut answers: Vec<Answer> = all.filter_map(|point| self.answer(point, scale)).collect();
        answers.sort_by(Answer::compare);
        answers.dedup_by(|a, b| a.profile == b.profile);
        answers
    }

    fn answer(self, point: &Point, scale: f64) -> Option<Answer> {
        let seconds = scale * point.timing.told()?;
        Some(Answer {
            goal: self,
            is_met: self.is_met(seconds, point.errors.rmse),
            name: if point.settings.is_empty() { "the scene as it stands".to_owned() } else { point.name() },
            profile: point.profile,
            seconds,
            spread: scale * point.timing.spread,
            error: point.errors.rmse,
        })
    }
}

impl Answer {
    /// The better one is the smaller one.
    #[must_use]
    pub fn compare(&self, other: &Self) -> Ordering {
        let [(missed, a), (other_missed, b)] =
            [self, other].map(|answer| answer.goal.rank(answer.seconds, answer.error));
        missed.cmp(&other_missed).then(a[0].total_cmp(&b[0])).then(a[1].total_cmp(&b[1]))
    }

    /// The same with other figures.
    #[must_use]
    pub fn with_figures(self, seconds: f64, spread: f64, error: f64) -> Self {
        Self { seconds, spread, error, is_met: self.goal.is_met(seconds, error), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laboratory::subject::setting_named;
    use crate::laboratory::{Errors, Reference, Timing};
    use crate::scene::Rgb;
    use crate::trace::Picture;

    fn point(count: u32, seconds: f64, error: f64) -> Point {
        let settings = setting_named("samples", &count.to_string()).into_iter().collect();
        let errors = Errors { rmse: error, ..Errors::default() };
        let timing = Timing { seconds, spread: 0.01 * seconds, repeats: 9, noise: None };
        Point {
            settings,
            profile: Profile { samples: Some(count), ..Profile::STANDARD },
            timing,
            errors,
            change: errors,
            on_frontier: true,
            picture: picture(),
        }
    }

    fn picture() -> Picture {
        Picture::from_pixels(1, 1, vec![Rgb::ZERO]).unwrap()
    }

    fn study() -> Study {
        let profile = Profile::STANDARD;
        Study {
            reference: Reference { profile, picture: picture(), pictures: 2, error: 0.0, cached: false },
            standard: point(4, 1.0, 0.04),
            points: vec![point(1, 0.25, 0.08), point(16, 4.0, 0.02), point(64, 16.0, 0.01)],
            resolution: 1e-6,
            waiting: 0.0,
        }
    }

    fn samples(goal: Goal, scale: f64) -> (Option<u32>, bool) {
        let answer = goal.ranked(&study(), scale).remove(0);
        (answer.profile.samples, answer.is_met)
    }

    #[test]
    fn for_a_time_it_is_the_closest_that_takes_no_longer() {
        assert_eq!(samples(Goal::Time(5.0), 1.0), (Some(16), true));
        assert_eq!(samples(Goal::Time(5.0), 4.0), (Some(4), true));
        assert_eq!(samples(Goal::Time(1e9), 1.0), (Some(64), true));
    }

    #[test]
    fn for_an_error_it_is_the_fastest_that_errs_no_more() {
        assert_eq!(samples(Goal::Error(0.03), 1.0), (Some(16), true));
        assert_eq!(samples(Goal::Error(1.0), 1.0), (Some(1), true));
    }

    #[test]
    fn where_nothing_will_do_it_is_what_comes_nearest() {
        assert_eq!(samples(Goal::Time(0.1), 1.0), (Some(1), false));
        assert_eq!(samples(Goal::Error(0.001), 1.0), (Some(64), false));
    }

    #[test]
    fn noise_is_no_answer() {
        let mut study = study();
        study.points[1].timing.noise = Some(super::super::Noise::Spread(0.5));
        assert_eq!(Goal::Time(5.0).ranked(&study, 1.0)[0].profile.samples, Some(4));
    }
}
