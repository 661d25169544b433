//! Errors that shadows tell, and numbers of 77 digits, against hits that were computed with 40 digits.

use glam::{DAffine3, DVec3};
use rayscope::accuracy::oracle::{Case, Target, cases};
use rayscope::csg::{Leaf, Placement, Solid};
use rayscope::math::{Alone, DoubleDouble, Precise, Real};
use rayscope::record::{CandidateFate, NullRecorder, Recorder, Value, What};
use rayscope::shape::{Crossing, Crossings, GenericRay, Primitive, Shape};
use rayscope::trace::TreeRecorder;

const FILES: [&str; 7] = ["sphere", "square", "tapered", "cube", "polyhedron", "torus", "superellipsoid"];

fn shape(case: &Case) -> &Shape {
    match &case.target {
        Target::Shape(shape) => shape,
        Target::Solid(_) => panic!("{} is no primitive", case.id),
    }
}

fn ulp(x: f64) -> f64 {
    x.abs().next_up() - x.abs()
}

fn exact_hits(case: &Case) -> Crossings {
    let mut found = Crossings::new();
    let ray = GenericRay::<Precise>::new(case.origin, case.direction);
    shape(case).crossings(&ray, &mut NullRecorder, &mut found);
    found
}

/// The times of a case that are crossed for sure: each alone in a zone with different sides.
fn sure_hits(case: &Case) -> Vec<f64> {
    let zones = case.zones.iter().filter(|zone| zone.before != zone.after && zone.hits == 1);
    zones
        .filter_map(|zone| case.hits.iter().find(|hit| zone.low <= hit.t && hit.t <= zone.high))
        .map(|hit| hit.t)
        .collect()
}

#[test]
fn hits_of_77_digits_are_those_of_the_oracle_to_the_last_digit_of_f64() {
    let (mut compared, mut complaints) = (0, Vec::new());
    for file in FILES {
        for case in cases(file).unwrap().iter().filter(|case| !case.ambiguous) {
            let found = exact_hits(case);
            for expected in sure_hits(case) {
                compared += 1;
                let off = found.iter().map(|hit: &Crossing| (hit.t - expected).abs()).fold(f64::INFINITY, f64::min);
                // Superellipsoids' solver stops where a step is too short to show beside the size of the solid.
                let short = f64::EPSILON / 16.0 / case.direction.abs().max_element();
                if off > ulp(expected) + short {
                    complaints.push(format!("{}: {expected} is off by {:.1} ulp", case.id, off / ulp(expected)));
                }
            }
        }
    }
    assert!(complaints.is_empty(), "{} of {compared}:\n{}", complaints.len(), complaints.join("\n"));
    assert!(compared > 4_000, "{compared}");
}

/// Lines of working that are hit times, with the errors that their shadows tell; and the hit times that were kept.
fn told<A: Real>(case: &Case) -> (Vec<(f64, f64)>, Vec<f64>) {
    let placed = Leaf::new("", shape(case).clone(), Placement::new(DAffine3::IDENTITY).unwrap());
    let mut recorder = TreeRecorder::measuring();
    recorder.begin();
    let _ = Solid::leaf(placed).inside::<A>(case.origin, case.direction, &mut recorder);
    recorder.end(|| rayscope::record::Entry::new(What::Step { number: 1, title: String::new() }));
    let tree = recorder.finish();
    let is_time = |symbol: &str| matches!(symbol, "t" | "t₁" | "t₂");
    let lines = tree.events.iter().flat_map(|event| &event.working).filter(|line| is_time(&line.symbol));
    let measured = lines.filter_map(|line| match (line.result, line.accuracy) {
        (Value::Number(t), Some(accuracy)) => Some((t, accuracy.error)),
        _ => None,
    });
    let kept = tree.events.iter().filter_map(|event| match &event.what {
        What::Roots { candidates } => {
            Some(candidates.iter().filter(|c| c.fate == CandidateFate::Accepted).map(|c| c.t))
        }
        _ => None,
    });
    (measured.collect(), kept.flatten().collect())
}

/// Where faces meet, a method may take the time of the other face; exactly where that is met is another question.
const MEETINGS: [&str; 6] = ["corner", "edge", "rim", "vertex", "apex", "generator"];

/// The square root of ten.
const HALF_A_DIGIT: f64 = 3.162;

/// Each exact hit's time in the working: its error as told, and as the oracle knows it.
fn compare<A: Real>(file: &str) -> usize {
    let (mut compared, mut rough, mut complaints) = (0, 0, Vec::new());
    let is_plain = |case: &&Case| !case.ambiguous && !MEETINGS.iter().any(|meeting| case.id.contains(meeting));
    for case in cases(file).unwrap().iter().filter(is_plain) {
        let (measured, kept) = told::<A>(case);
        let sure = sure_hits(case);
        if sure.len() != kept.len() {
            continue;
        }
        for (expected, kept) in sure.into_iter().zip(kept) {
            let known = (kept - expected).abs();
            // Two times that rounding has made one have two shadows.
            let same = measured.iter().filter(|(t, _)| *t == kept).map(|(_, told)| told);
            let nearest = same.min_by(|a, b| (*a - known).abs().total_cmp(&(*b - known).abs()));
            let Some(told) = nearest else { continue };
            // The oracle's time and the one that is shown are rounded to f64.
            if *told < 1e-2 * expected.abs() {
                compared += 1;
                let rounding = ulp(expected);
                rough += usize::from((known - told).abs() > rounding + 1e-6 * told);
                if known > HALF_A_DIGIT * told + rounding || *told > HALF_A_DIGIT * known + rounding {
                    complaints.push(format!("{}: {kept} is off by {known:e}, told {told:e}", case.id));
                }
            }
        }
    }
    assert!(
        complaints.is_empty(),
        "{file}, {}: {} of {compared}:\n{}",
        A::NAME,
        complaints.len(),
        complaints.join("\n")
    );
    // The wall of a tapered cylinder is met by a guess and a step, and the step that is missing has no shadow.
    assert!(
        30 * rough <= compared,
        "{file}, {}: {rough} of {compared} are off by more than one part in a million",
        A::NAME
    );
    compared
}

#[test]
fn shadows_of_hit_times_tell_the_error_that_the_oracle_knows() {
    for file in ["sphere", "tapered", "cube", "polyhedron", "square"] {
        let compared = [compare::<Alone<f32>>(file), compare::<Alone<f64>>(file), compare::<DoubleDouble>(file)];
        assert!(compared.iter().all(|&count| count > 30), "{file}: {compared:?}");
    }
}

#[test]
fn measuring_changes_neither_the_lists_nor_a_bit_of_them() {
    for file in FILES {
        for case in cases(file).unwrap().iter().step_by(7) {
            let placed =
                Leaf::new("", shape(case).clone(), Placement::new(DAffine3::from_scale(DVec3::splat(0.7))).unwrap());
            let solid = Solid::leaf(placed);
            let mut recorder = TreeRecorder::measuring();
            recorder.begin();
            let measured = solid.inside::<f64>(case.origin, case.direction, &mut recorder);
            assert_eq!(
                measured,
                solid.inside::<f64>(case.origin, case.direction, &mut TreeRecorder::new()),
                "{}",
                case.id
            );
            assert_eq!(measured, solid.inside::<f64>(case.origin, case.direction, &mut NullRecorder), "{}", case.id);
        }
    }
}
