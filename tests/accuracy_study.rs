//! The study in `docs/accuracy`: what it says of errors is true of pictures that are rendered here and now. No time is
//! measured: work is counted instead.

use rayscope::laboratory::{Earlier, Knob, NoStore, Plan, Point, Study, Taken, Tools, study};
use rayscope::scene::{Scene, embedded_scene, load};
use rayscope::trace::Progress;
use std::fmt::Write;
use std::time::Duration;

/// The scenes of the study, with the columns that are enough to see what it says.
const SCENES: [(&str, u32); 10] = [
    ("hard/far_torus", 80),
    ("csg/rocket", 80),
    ("primitives/superellipsoid", 80),
    ("sampling/antialiasing", 32),
    ("lens/focus", 32),
    ("spectrum/prism", 40),
    ("hard/mirror_room", 40),
    ("textures/marble", 64),
    ("textures/filters", 64),
    ("textures/bumps", 64),
];

/// Errors below this come from the last digits of numbers.
const ROUNDING: f64 = 1e-9;

/// Errors that differ by less than this factor are the same for who looks at a plot.
const ALIKE: f64 = 1.1;

fn scene(name: &str) -> Scene {
    load(embedded_scene(name).unwrap().text, name).unwrap()
}

fn studied(name: &str, columns: u32) -> Study {
    let scene = scene(name);
    let rows = (scene.image.height * columns / scene.image.width).max(1);
    let mut by_work = |work: &mut (dyn FnMut() -> u64 + Send)| {
        let worked = Duration::from_nanos(1000 + 10 * work());
        Taken { worked, wall: worked }
    };
    let progress = Progress::new();
    let tools = Tools {
        stopwatch: &mut by_work,
        store: &mut NoStore,
        progress: &progress,
        watch: &mut |_: &dyn Fn() -> Study| {},
    };
    let plan = Plan { budget: 0.0, combines: false, ..Plan::default() };
    let size = Earlier { size: [columns, rows], ..Earlier::default() };
    study(&scene, &plan, Some(&size), tools).unwrap().study
}

fn of(study: &Study, knob: Knob) -> Vec<(&str, &Point)> {
    let setting = |point: &'_ Point| point.settings.iter().position(|setting| setting.knob == knob);
    let points = study.points.iter().filter(|point| setting(point).is_some());
    points.map(|point| (point.settings[setting(point).unwrap()].value.as_str(), point)).collect()
}

/// The values from the worst to the best: `>` where one errs more, `≈` where both err alike, `=` where they err the same.
fn ordered(points: &[(&str, &Point)]) -> String {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| b.1.errors.rmse.total_cmp(&a.1.errors.rmse));
    let mut text = String::new();
    for (k, (value, point)) in sorted.iter().enumerate() {
        if let Some(before) = k.checked_sub(1).map(|k| sorted[k].1.errors.rmse) {
            let rmse = point.errors.rmse;
            let sign = if before == rmse {
                "="
            } else if before < rmse * ALIKE || before < ROUNDING {
                "≈"
            } else {
                ">"
            };
            let _ = write!(text, " {sign} ");
        }
        text.push_str(value);
    }
    let best = sorted.last().map_or(0.0, |(_, point)| point.errors.rmse);
    let end = match best {
        0.0 => "the last exactly 0",
        rounding if rounding < ROUNDING => "the last by rounding alone",
        _ => "the last not 0 either",
    };
    format!("{text}; {end}")
}

/// What no other setting beats, from the least work to the most.
fn frontier(study: &Study) -> String {
    let points = study.points.iter().filter(|point| point.on_frontier && !point.is_control());
    let mut points: Vec<_> = points.map(|point| (point.timing.seconds, point.name())).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
    points.into_iter().map(|(_, name)| name).collect::<Vec<_>>().join(" · ")
}

#[test]
fn the_errors_of_all_settings_keep_their_order() {
    let mut text = String::new();
    for (name, columns) in SCENES {
        let study = studied(name, columns);
        let _ = writeln!(text, "{name}");
        for knob in Knob::ALL {
            let points = of(&study, knob);
            if !points.is_empty() {
                let _ = writeln!(text, "  {}: {}", knob.name(), ordered(&points));
            }
        }
        let _ = writeln!(text, "  beaten by none in work and error: {}", frontier(&study));
    }
    insta::with_settings!({ snapshot_path => "../snapshots", prepend_module_to_snapshot => false, omit_expression => true }, {
        insta::assert_snapshot!("study@accuracy", text);
    });
}

/// By what power of a number that is set the error changes, from the first to the last value.
fn slope(study: &Study, knob: Knob, [first, last]: [&str; 2]) -> f64 {
    let points = of(study, knob);
    let error = |value: &str| points.iter().find(|(name, _)| *name == value).unwrap().1.errors.rmse;
    let number = |value: &str| value.parse::<f64>().unwrap();
    (error(last) / error(first)).ln() / (number(last) / number(first)).ln()
}

#[test]
fn samples_pay_by_their_root_or_better() {
    for name in ["sampling/antialiasing", "lens/focus"] {
        let slope = slope(&studied(name, 32), Knob::Samples, ["1", "64"]);
        assert!((-0.8..-0.45).contains(&slope), "{name}: {slope}");
    }
}

#[test]
fn a_search_by_steps_pays_less_than_samples_do() {
    let slope = slope(&studied("primitives/superellipsoid", 80), Knob::Search, ["16", "128"]);
    assert!((-0.45..-0.1).contains(&slope), "{slope}");
}

#[test]
fn wavelengths_pay_by_about_their_number() {
    let slope = slope(&studied("spectrum/prism", 40), Knob::Wavelengths, ["4", "16"]);
    assert!((-1.2..-0.7).contains(&slope), "{slope}");
}

#[test]
fn between_mirrors_each_reflection_leaves_the_same_share() {
    let study = studied("hard/mirror_room", 40);
    let points = of(&study, Knob::Depth);
    let error = |value: &str| points.iter().find(|(name, _)| *name == value).unwrap().1.errors.rmse;
    let per_ray = |from: &str, to: &str, rays: i32| (error(to) / error(from)).powf(1.0 / f64::from(rays));
    let shares = [per_ray("1", "2", 1), per_ray("2", "4", 2), per_ray("4", "8", 4)];
    assert!(shares.iter().all(|share| (share - 0.86).abs() < 0.04), "{shares:?}");
}

#[test]
fn single_precision_is_seen_only_from_afar() {
    let wrong = |name: &str| {
        let study = studied(name, 80);
        let single = of(&study, Knob::Arithmetic).into_iter().find(|(value, _)| *value == "f32").unwrap().1;
        single.errors.wrong_pixels
    };
    assert_eq!([wrong("csg/rocket"), wrong("primitives/superellipsoid")], [0, 0]);
    assert!(wrong("hard/far_torus") > 40);
}
