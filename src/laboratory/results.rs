//! From what was measured to points: the scene as it stands, each setting, each combination.

use super::bench::Bench;
use super::errors::errors;
use super::frontier::frontier;
use super::subject::Subject;
use super::timing::Repeat;
use super::{Knob, Point, Reference, Setting, Standing, Study};
use crate::scene::Profile;
use crate::trace::Picture;
use std::cmp::Ordering;

/// Compares the pictures that were not compared yet. The first subject is the scene as it stands.
pub(super) fn judge(subjects: &mut [Subject], reference: &Reference) {
    let Some(standard) = subjects.first().and_then(|subject| subject.picture.clone()) else { return };
    for subject in subjects.iter_mut().filter(|subject| subject.errors.is_none()) {
        let compared = |picture: &Picture| [&reference.picture, &standard].map(|truth| errors(picture, truth));
        subject.errors = subject.picture.as_ref().map(compared);
    }
}

/// What is known of subjects by now, and the repeats behind each time: of the scene as it stands, then of the points in
/// their order. Subjects that were not timed yet are left out.
pub(super) fn results(subjects: &[Subject], reference: &Reference, bench: &Bench) -> (Study, Vec<Vec<Repeat>>) {
    let on = on_frontier(subjects, bench.resolution);
    let point = |k: usize, settings: &[Setting]| point(&subjects[k], settings, on[k], bench.resolution, reference);
    let places = in_order(subjects);
    let repeats = std::iter::once(0).chain(places.iter().map(|(k, _)| *k)).map(|k| subjects[k].repeats.clone());
    let study = Study {
        reference: reference.clone(),
        standard: point(0, &[]),
        points: places.iter().map(|(k, settings)| point(*k, settings)).collect(),
        resolution: bench.resolution,
        waiting: bench.waiting(),
    };
    (study, repeats.collect())
}

/// Every name with its subject: single settings in the order of the knobs and of their values, then all others.
fn in_order(subjects: &[Subject]) -> Vec<(usize, Vec<Setting>)> {
    let timed = subjects.iter().enumerate().filter(|(_, subject)| !subject.repeats.is_empty());
    let names = timed.flat_map(|(k, subject)| subject.names.iter().map(move |name| (k, name.clone())));
    let mut names: Vec<_> = names.filter(|(_, name)| !name.is_empty()).collect();
    names.sort_by(|(_, a), (_, b)| rank(a).partial_cmp(&rank(b)).unwrap_or(Ordering::Equal));
    names
}

/// The knob's place, then the value as a number or its place among those that are tried.
fn rank(settings: &[Setting]) -> (usize, f64) {
    let [single] = settings else { return (Knob::ALL.len(), 0.0) };
    let knob = Knob::ALL.iter().position(|knob| *knob == single.knob).unwrap_or(Knob::ALL.len());
    let tried = single.knob.settings();
    let place = tried.iter().position(|setting| setting.value == single.value).unwrap_or(tried.len());
    // Words come after numbers, as `certified` does after so many stretches.
    (knob, single.value.parse().unwrap_or(WORDS + place as f64))
}

/// More than any number that is a value.
const WORDS: f64 = 1e9;

fn point(subject: &Subject, settings: &[Setting], on_frontier: bool, resolution: f64, reference: &Reference) -> Point {
    let [error, change] = subject.errors.unwrap_or_default();
    let mut point = Point {
        settings: settings.to_vec(),
        profile: settings.iter().fold(Profile::STANDARD, |profile, setting| profile.or(setting.profile)),
        timing: subject.timing(resolution),
        errors: error,
        change,
        on_frontier,
        picture: subject.picture.clone().unwrap_or_else(|| reference.picture.clone()),
    };
    if point.is_control() {
        // It must equal the scene as it stands, whatever that is off by, and is no choice.
        point.errors = change;
        point.on_frontier = false;
    }
    point
}

/// Which subjects are on the frontier. Those that are nothing but controls have no place there.
fn on_frontier(subjects: &[Subject], resolution: f64) -> Vec<bool> {
    let is_choice = |subject: &Subject| subject.names.iter().any(|name| !name.iter().any(|s| s.knob.is_control()));
    let standing = |subject: &Subject| {
        let timing = subject.timing(resolution);
        timing.standing(subject.errors.as_ref()?[0].rmse).filter(|_| is_choice(subject))
    };
    let standings: Vec<_> = subjects.iter().enumerate().filter_map(|(k, s)| Some((k, standing(s)?))).collect();
    let on = frontier(&standings.iter().map(|(_, standing)| *standing).collect::<Vec<_>>());
    let mut flags = vec![false; subjects.len()];
    standings.iter().zip(on).for_each(|((k, _), on)| flags[*k] = on);
    if let Some((0, standard)) = standings.first() {
        prefer(standard, &standings, &mut flags);
    }
    flags
}

/// The scene as it stands takes the place of what is neither clearly faster nor clearly closer: nobody turns a knob for that.
fn prefer(standard: &Standing, standings: &[(usize, Standing)], flags: &mut [bool]) {
    let is_like_it = |other: &Standing| {
        let apart = |a: &Standing, b: &Standing| a.is_clearly_faster(b) || a.is_clearly_closer(b);
        !apart(standard, other) && !apart(other, standard)
    };
    for (k, _) in standings.iter().filter(|(_, other)| is_like_it(other)) {
        if std::mem::take(&mut flags[*k]) {
            flags[0] = true;
        }
    }
}
