//! Several knobs at once: what they should do together, and which of that is worth measuring.
//!
//! Each setting changes the time by a factor, and factors multiply: twice the samples at two thirds of a ray's price take four
//! thirds of the time. Errors of different kinds are independent, so that their squares add; but samples divide what
//! noise there is, whatever it comes from. Both are guesses, and what is guessed best is measured.

use super::{Knob, Setting, Standing, frontier};
use crate::math::portable;
use crate::scene::Profile;

/// What one setting does, measured against the scene as it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The setting.
    pub setting: Setting,
    /// Its time as a multiple of the scene's.
    pub factor: f64,
    /// Its error.
    pub error: f64,
}

/// Several settings together, as predicted.
#[derive(Clone, Debug, PartialEq)]
pub struct Prediction {
    /// The settings, at most one of each knob, in the order of the knobs.
    pub settings: Vec<Setting>,
    /// The time, in seconds.
    pub seconds: f64,
    /// The error.
    pub error: f64,
}

/// What predictions start from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Base {
    /// What the scene takes as it stands, in seconds.
    pub seconds: f64,
    /// Its error.
    pub error: f64,
    /// The reference's own error: nothing is known to be closer.
    pub least: f64,
}

/// How many predictions are kept from knob to knob. More would take seconds where many knobs matter; fewer would lose steps of
/// the frontier.
const KEPT: usize = 200;

#[derive(Clone, Debug)]
struct Partial {
    steps: Vec<usize>,
    profile: Profile,
    factor: f64,
    /// The squared errors that are added.
    added: f64,
    /// The share of the scene's squared error that samples leave.
    left: f64,
}

impl Partial {
    fn squared_error(&self, base: &Base) -> f64 {
        (self.left * base.error * base.error + self.added).max(base.least * base.least)
    }

    /// With one more setting; none if that asks for something else of the same thing, or for nothing more.
    fn with(&self, index: usize, step: &Step, base: &Base) -> Option<Self> {
        let profile = self.profile.or(step.setting.profile);
        if profile != step.setting.profile.or(self.profile) || profile == self.profile {
            return None;
        }
        let mut with = self.clone();
        with.steps.push(index);
        with.profile = profile;
        with.factor *= step.factor;
        let squares = [step.error * step.error, base.error * base.error];
        if step.setting.knob.is_sampled() && squares[1] > 0.0 {
            with.left *= squares[0] / squares[1];
        } else {
            with.added += squares[0] - squares[1];
        }
        Some(with)
    }
}

/// The frontier of what the settings should do together, from the closest to the fastest. Time factors are positive, and both
/// laws keep their order whatever is added, so that what is beaten knob by knob stays beaten.
#[must_use]
pub fn predictions(steps: &[Step], base: &Base) -> Vec<Prediction> {
    let nothing = Partial { steps: Vec::new(), profile: Profile::STANDARD, factor: 1.0, added: 0.0, left: 1.0 };
    let mut partials = vec![nothing];
    for knob in Knob::ALL {
        let own = steps.iter().enumerate().filter(|(_, step)| step.setting.knob == knob);
        let with: Vec<Partial> =
            own.flat_map(|(k, step)| partials.iter().filter_map(move |partial| partial.with(k, step, base))).collect();
        partials.extend(with);
        partials = thinned(partials, base);
    }
    let prediction = |partial: Partial| Prediction {
        settings: partial.steps.iter().map(|&k| steps[k].setting.clone()).collect(),
        seconds: base.seconds * partial.factor,
        error: partial.squared_error(base).sqrt(),
    };
    partials.into_iter().map(prediction).collect()
}

/// The frontier of the partial predictions, by error.
fn thinned(partials: Vec<Partial>, base: &Base) -> Vec<Partial> {
    let standing = |partial: &Partial| Standing {
        seconds: partial.factor,
        uncertainty: 0.0,
        error: partial.squared_error(base).sqrt(),
    };
    let on = frontier(&partials.iter().map(standing).collect::<Vec<_>>());
    let mut kept: Vec<Partial> =
        partials.into_iter().zip(on).filter(|(_, on)| *on).map(|(partial, _)| partial).collect();
    kept.sort_by(|a, b| a.squared_error(base).total_cmp(&b.squared_error(base)));
    spread_out(kept, KEPT)
}

/// At most so many of a list, evenly, with both ends.
#[must_use]
pub fn spread_out<T>(list: Vec<T>, most: usize) -> Vec<T> {
    let (count, most) = (list.len(), most.max(2));
    if count <= most {
        return list;
    }
    let wanted: Vec<usize> = (0..most).map(|k| k * (count - 1) / (most - 1)).collect();
    list.into_iter().enumerate().filter(|(k, _)| wanted.contains(k)).map(|(_, item)| item).collect()
}

/// Settings between and beyond those of a knob that counts samples: time and error follow powers of the count from one
/// measured setting to the next. These let an answer use the time that it may take.
#[must_use]
pub fn between(steps: &[Step]) -> Vec<Step> {
    let mut known: Vec<(f64, &Step)> =
        steps.iter().filter_map(|step| Some((f64::from(step.setting.value.parse::<u32>().ok()?), step))).collect();
    known.sort_by(|a, b| a.0.total_cmp(&b.0));
    let Some(knob) = known.first().map(|(_, step)| step.setting.knob).filter(|knob| knob.is_sampled()) else {
        return Vec::new();
    };
    let is_new = |count: &&u32| known.iter().all(|(value, _)| *value != f64::from(**count));
    let step = |&count: &u32| {
        let setting = super::subject::counted(knob, count)?;
        let at = f64::from(count);
        // The pair that the count lies between, or the last one.
        let pair = known.windows(2).find(|pair| at <= pair[1].0).or_else(|| known.windows(2).last())?;
        let [(low, a), (high, b)] = [pair[0], pair[1]];
        let share = portable::ln(at / low) / portable::ln(high / low);
        let power = |from: f64, to: f64| from * portable::powf(to / from, share);
        let (factor, error) = (power(a.factor, b.factor), power(a.error, b.error));
        (at >= low && factor.is_finite() && error.is_finite()).then_some(Step { setting, factor, error })
    };
    BETWEEN.iter().filter(is_new).filter_map(step).collect()
}

/// Numbers of samples that answers may ask for: each about half as much again as the one before.
const BETWEEN: [u32; 15] = [2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laboratory::subject::setting_named;

    fn step(knob: &str, value: &str, factor: f64, error: f64) -> Step {
        Step { setting: setting_named(knob, value).unwrap(), factor, error }
    }

    const BASE: Base = Base { seconds: 2.0, error: 0.04, least: 0.001 };

    fn names(prediction: &Prediction) -> String {
        let names = prediction.settings.iter().map(|setting| format!("{} {}", setting.knob.name(), setting.value));
        names.collect::<Vec<_>>().join(", ")
    }

    #[test]
    fn factors_multiply_and_squared_errors_add() {
        let steps = [step("depth", "1", 0.5, 0.05), step("octaves", "2", 0.25, 0.041)];
        let all = predictions(&steps, &BASE);
        let both = all.iter().find(|prediction| prediction.settings.len() == 2).unwrap();
        assert!((both.seconds - 0.25).abs() < 1e-12, "{both:?}");
        let error = (0.05_f64.powi(2) + 0.041_f64.powi(2) - 0.04_f64.powi(2)).sqrt();
        assert!((both.error - error).abs() < 1e-12, "{both:?}");
    }

    #[test]
    fn samples_divide_the_error_that_is_there() {
        let steps = [step("samples", "64", 4.0, 0.02), step("lens_samples", "4", 4.0, 0.02)];
        let both = predictions(&steps, &BASE).into_iter().find(|p| p.settings.len() == 2).unwrap();
        assert!((both.seconds - 32.0).abs() < 1e-9 && (both.error - 0.01).abs() < 1e-12, "{both:?}");
    }

    #[test]
    fn nothing_is_predicted_to_be_closer_than_the_reference_is_sure() {
        let steps = [step("samples", "64", 4.0, 0.0001)];
        assert!(predictions(&steps, &BASE).iter().all(|prediction| prediction.error >= BASE.least));
    }

    #[test]
    fn two_settings_of_one_thing_are_never_asked_for_together() {
        let steps = [step("arithmetic", "f32", 0.7, 0.05), step("roots", "textbook", 0.7, 0.05)];
        assert!(predictions(&steps, &BASE).iter().all(|prediction| prediction.settings.len() < 2));
    }

    #[test]
    fn what_is_slower_and_no_closer_is_in_no_prediction() {
        let steps = [step("arithmetic", "double-double", 8.0, 0.04), step("depth", "2", 0.5, 0.06)];
        let all: Vec<_> = predictions(&steps, &BASE).iter().map(names).collect();
        assert_eq!(all, ["", "depth 2"]);
    }

    #[test]
    fn counts_between_measured_ones_follow_their_power_laws() {
        let measured =
            [step("samples", "4", 1.0, 0.08), step("samples", "16", 4.0, 0.04), step("samples", "64", 16.0, 0.02)];
        let all = between(&measured);
        let of = |count: &str| all.iter().find(|step| step.setting.value == count).unwrap();
        assert!((of("8").factor - 2.0).abs() < 1e-12 && (of("8").error - 0.08 / 2.0_f64.sqrt()).abs() < 1e-12);
        assert!((of("256").factor - 64.0).abs() < 1e-9 && (of("256").error - 0.01).abs() < 1e-12);
        assert!(all.iter().all(|step| !["4", "16", "64", "2"].contains(&step.setting.value.as_str())), "{all:?}");
    }

    #[test]
    fn a_list_is_thinned_evenly_with_both_ends() {
        assert_eq!(spread_out((0..10).collect(), 4), [0, 3, 6, 9]);
        assert_eq!(spread_out(vec![1, 2, 3], 4), [1, 2, 3]);
    }
}
