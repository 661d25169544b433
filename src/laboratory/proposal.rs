//! Which combinations are worth measuring, by what is known so far.

use super::combination::{Base, Prediction, Step, between, predictions, spread_out};
use super::{Goal, Knob, Point, Study};
use crate::ledger::quantile;

/// The most combinations that are proposed at a time, besides those for goals.
const MOST: usize = 8;

/// So many are proposed for each goal: the second one in case that the first one misses.
const FOR_A_GOAL: usize = 2;

/// Combinations that were not measured yet: those on the predicted frontier, spread out, and before them those that the goals
/// ask for. `scale` is how many times as many pixels the whole picture has.
pub(super) fn proposals(study: &Study, goals: &[Goal], scale: f64) -> Vec<Prediction> {
    let Some(seconds) = study.standard.timing.told() else { return Vec::new() };
    let base = Base { seconds, error: study.standard.errors.rmse, least: study.reference.error };
    let steps = steps(study, seconds);
    let is_new = |prediction: &Prediction| {
        let known = study.points.iter().any(|point| point.settings == prediction.settings);
        !known && !prediction.settings.is_empty()
    };
    let correction = correction(study, &steps, &base);
    let all = predictions(&steps, &base).into_iter().filter(is_new);
    let new: Vec<_> = all.map(|prediction| corrected(prediction, correction)).collect();
    let mut proposals: Vec<Prediction> = Vec::new();
    for goal in goals {
        let rank = |prediction: &Prediction| goal.rank(scale * prediction.seconds, prediction.error);
        let mut ranked: Vec<_> = new.iter().collect();
        ranked.sort_by(|a, b| {
            let ((missed_a, a), (missed_b, b)) = (rank(a), rank(b));
            missed_a.cmp(&missed_b).then(a[0].total_cmp(&b[0])).then(a[1].total_cmp(&b[1]))
        });
        proposals.extend(ranked.into_iter().take(FOR_A_GOAL).cloned());
    }
    let combined = new.into_iter().filter(|prediction| prediction.settings.len() > 1).collect();
    proposals.extend(spread_out(combined, MOST));
    proposals
}

/// What each setting does, measured, and between these what others should do.
fn steps(study: &Study, seconds: f64) -> Vec<Step> {
    let single = |point: &&Point| point.settings.len() == 1 && !point.is_control();
    let step = |point: &Point| {
        let factor = point.timing.told()? / seconds;
        Some(Step { setting: point.settings[0].clone(), factor, error: point.errors.rmse })
    };
    let mut steps: Vec<Step> = study.points.iter().filter(single).filter_map(step).collect();
    for knob in Knob::ALL {
        let own: Vec<Step> = steps.iter().filter(|step| step.setting.knob == knob).cloned().collect();
        steps.extend(between(&own));
    }
    steps
}

/// By what factors the predictions of time and error were off where they could be checked: the medians.
fn correction(study: &Study, steps: &[Step], base: &Base) -> [f64; 2] {
    let off = |point: &Point| {
        let own: Vec<Step> = steps.iter().filter(|step| point.settings.contains(&step.setting)).cloned().collect();
        let predicted = predictions(&own, base).into_iter().find(|prediction| prediction.settings == point.settings)?;
        Some([point.timing.told()? / predicted.seconds, point.errors.rmse / predicted.error])
    };
    let combined = study.points.iter().filter(|point| point.settings.len() > 1);
    let off: Vec<[f64; 2]> =
        combined.filter_map(off).filter(|off| off.iter().all(|x| x.is_finite() && *x > 0.0)).collect();
    let median = |k: usize| if off.is_empty() { 1.0 } else { quantile(off.iter().map(|off| off[k]).collect(), 0.5) };
    [median(0), median(1)]
}

fn corrected(prediction: Prediction, [time, error]: [f64; 2]) -> Prediction {
    Prediction { seconds: time * prediction.seconds, error: error * prediction.error, ..prediction }
}
