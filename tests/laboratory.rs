//! The accuracy laboratory: what it measures, by clocks that do what the test says.

use rayscope::laboratory::{
    Earlier, Goal, Knob, NoStore, Noise, Plan, Point, Run, Store, Study, Taken, Tools, errors, is_random, study,
};
use rayscope::scene::{Profile, Scene, Shortcuts, embedded_scene, embedded_scenes, load};
use rayscope::trace::{Picture, Progress, render};
use std::collections::BTreeMap;
use std::time::Duration;

type Work<'a> = &'a mut (dyn FnMut() -> u64 + Send);

fn scene(name: &str) -> Scene {
    load(embedded_scene(name).unwrap().text, name).unwrap()
}

/// With so many columns, in its own shape.
fn narrow(mut scene: Scene, columns: u32) -> Scene {
    scene.image.height = (scene.image.height * columns / scene.image.width).max(1);
    scene.image.width = columns;
    scene
}

fn picture(scene: &Scene) -> Picture {
    render(scene, &Progress::new()).0
}

/// A clock that goes by the work that is done: ten nanoseconds for each ray and test.
fn by_work(work: Work) -> Taken {
    let worked = Duration::from_nanos(1000 + 10 * work());
    Taken { worked, wall: worked }
}

fn plan(columns: u32, budget: f64, knobs: &[Knob]) -> Plan {
    Plan { width: columns, budget, knobs: knobs.to_vec(), combines: false, ..Plan::default() }
}

fn measured(scene: &Scene, plan: &Plan, stopwatch: impl FnMut(Work) -> Taken + Send) -> Run {
    resumed(scene, plan, None, stopwatch)
}

fn resumed(
    scene: &Scene,
    plan: &Plan,
    earlier: Option<&Earlier>,
    mut stopwatch: impl FnMut(Work) -> Taken + Send,
) -> Run {
    let progress = Progress::new();
    let tools = Tools {
        stopwatch: &mut stopwatch,
        store: &mut NoStore,
        progress: &progress,
        watch: &mut |_: &dyn Fn() -> Study| {},
    };
    study(scene, plan, earlier, tools).unwrap()
}

/// Nothing was measured earlier, but in this size.
fn in_size(size: [u32; 2]) -> Earlier {
    Earlier { size, ..Earlier::default() }
}

fn point<'a>(run: &'a Run, name: &str) -> &'a Point {
    run.study.points.iter().find(|point| point.name() == name).unwrap_or_else(|| panic!("no {name}"))
}

#[test]
fn controls_change_nothing_on_any_scene() {
    for embedded in embedded_scenes() {
        let scene = narrow(load(embedded.text, &embedded.name).unwrap(), 12);
        let few = scene.with_profile(&Profile { samples: Some(2), ..Profile::STANDARD });
        let bare = few.with_profile(&Profile { shortcuts: Some(Shortcuts::NONE), ..Profile::STANDARD });
        assert_eq!(
            errors(&picture(&bare), &picture(&few)),
            rayscope::laboratory::Errors::default(),
            "{}",
            embedded.name
        );
    }
}

#[test]
fn the_study_tells_controls_from_choices_and_gives_them_no_error() {
    let run = measured(&scene("csg/bowl"), &plan(24, 1.0, &[Knob::Shortcuts, Knob::Arithmetic]), by_work);
    for value in ["none", "all"] {
        let control = point(&run, &format!("shortcuts {value}"));
        assert!(control.is_control() && !control.on_frontier);
        assert_eq!(control.errors, rayscope::laboratory::Errors::default());
    }
    let [without, with] = ["none", "all"].map(|value| point(&run, &format!("shortcuts {value}")).timing.told());
    assert!(without.is_some() && without != with, "{without:?} {with:?}");
}

#[test]
fn the_scene_as_it_stands_differs_from_itself_in_nothing() {
    let run = measured(&scene("hello/sphere"), &plan(16, 1.0, &[Knob::Arithmetic, Knob::Roots]), by_work);
    for name in ["arithmetic adaptive", "roots certified"] {
        let same = point(&run, name);
        assert_eq!(same.change, rayscope::laboratory::Errors::default(), "{name}");
        assert_eq!(same.timing, run.study.standard.timing, "one measurement, two names");
    }
    assert_eq!(run.study.reference.error, 0.0);
}

/// The error of independent samples falls as 1/√n; even samples err by less.
#[test]
fn the_error_of_a_soft_shadow_falls_at_least_as_the_root_of_the_samples() {
    let run = measured(&scene("lights/soft_shadows"), &plan(32, 40.0, &[Knob::Samples]), by_work);
    let error = |samples: u32| point(&run, &format!("samples {samples}")).errors.rmse;
    // From 1 to 4 the samples begin to be spread over the pixel, which is another thing.
    for [few, many] in [[4, 16], [16, 64]] {
        let [low, high] = [error(many), error(few)];
        // The reference's own error is within both.
        let own = run.study.reference.error;
        let net = |x: f64| (x * x - own * own).max(0.0).sqrt();
        assert!(net(low) <= 0.55 * net(high), "{few} → {high}, {many} → {low}, reference {own}");
    }
}

#[test]
fn a_reference_of_a_scene_with_chance_states_an_error_and_more_pictures_make_it_smaller() {
    let scene = scene("lens/focus");
    assert!(is_random(&scene));
    let plan = |budget| plan(8, budget, &[Knob::Shortcuts]);
    let error = |budget| resumed(&scene, &plan(budget), Some(&in_size([8, 5])), by_work).study.reference;
    let [few, many] = [error(1e-6), error(100.0)];
    assert!(many.pictures > few.pictures && few.pictures >= 2, "{} {}", few.pictures, many.pictures);
    assert!(many.error < few.error && many.error > 0.0, "{} {}", few.error, many.error);
}

#[test]
fn a_clock_that_jitters_or_stalls_or_is_too_coarse_makes_noise() {
    let scene = scene("hello/sphere");
    let plan = plan(8, 0.001, &[Knob::Depth]);
    let mut turn = 0_u64;
    let jitters = move |work: Work| {
        turn = turn.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let factor = 1 + 7 * (turn >> 61);
        let worked = Duration::from_nanos(100 + 10 * factor * work());
        Taken { worked, wall: worked }
    };
    let stalls = |work: Work| {
        let Taken { worked, .. } = by_work(work);
        Taken { worked, wall: 2 * worked }
    };
    let coarse = |work: Work| {
        let Taken { worked, wall } = by_work(work);
        Taken { worked: Duration::from_secs_f64((10.0 * worked.as_secs_f64()).floor() / 10.0), wall }
    };
    let noise = |run: Run| run.study.standard.timing.noise.unwrap_or_else(|| panic!("{:?}", run.study.standard.timing));
    assert!(matches!(noise(measured(&scene, &plan, jitters)), Noise::Spread(_)));
    assert_eq!(noise(measured(&scene, &plan, stalls)), Noise::Waiting(0.5));
    assert!(matches!(noise(measured(&scene, &plan, coarse)), Noise::Clock(_)));
}

#[test]
fn noise_is_on_no_frontier_and_in_no_answer() {
    let stalls = |work: Work| Taken { wall: Duration::from_secs(1), ..by_work(work) };
    let goals = vec![Goal::Error(1.0)];
    let run = measured(&scene("csg/bowl"), &Plan { goals, ..plan(16, 1.0, &[Knob::Depth]) }, stalls);
    assert!(run.answers.is_empty() && run.study.points.iter().all(|point| !point.on_frontier));
}

#[test]
fn the_same_study_gives_the_same_results_bit_for_bit() {
    let scene = scene("optics/glass_ball");
    let plan = Plan { combines: true, ..plan(16, 2.0, &[Knob::Depth, Knob::Arithmetic]) };
    assert_eq!(measured(&scene, &plan, by_work), measured(&scene, &plan, by_work));
}

#[test]
fn a_resumed_run_has_the_repeats_of_both_and_measures_in_the_same_size() {
    let scene = scene("csg/bowl");
    let first = measured(&scene, &plan(24, 0.5, &[Knob::Depth]), by_work);
    let all = std::iter::once(&first.study.standard).chain(&first.study.points);
    let earlier = Earlier {
        size: [first.study.standard.picture.width, first.study.standard.picture.height],
        seed: None,
        repeats: all.map(|point| point.settings.clone()).zip(first.repeats.clone()).collect(),
        pinned: first.pinned.clone(),
    };
    let jitter = |work: Work| {
        let Taken { worked, wall } = by_work(work);
        Taken { worked: worked + worked / 50, wall }
    };
    let second = resumed(&scene, &plan(999, 0.5, &[Knob::Depth]), Some(&earlier), jitter);
    assert_eq!(second.study.standard.picture, first.study.standard.picture);
    for (k, (before, after)) in first.repeats.iter().zip(&second.repeats).enumerate() {
        assert_eq!(after[..before.len()], before[..], "{k}");
    }
    assert!(second.pinned.starts_with(&first.pinned));
}

#[test]
fn what_is_cancelled_keeps_what_is_finished() {
    let scene = scene("csg/bowl");
    let plan = plan(24, 1e9, &Knob::ALL);
    let progress = Progress::new();
    let mut readings = 0;
    let mut stopwatch = |work: Work| {
        readings += 1;
        if readings == 60 {
            progress.cancel();
        }
        by_work(work)
    };
    let tools = Tools {
        stopwatch: &mut stopwatch,
        store: &mut NoStore,
        progress: &progress,
        watch: &mut |_: &dyn Fn() -> Study| {},
    };
    let run = study(&scene, &plan, None, tools).unwrap();
    assert!(run.is_cut_short && !run.study.points.is_empty());
    assert!(run.repeats.iter().all(|repeats| !repeats.is_empty()));
}

#[test]
fn a_study_that_is_cancelled_at_once_has_nothing_to_say() {
    let progress = Progress::new();
    progress.cancel();
    let tools = Tools {
        stopwatch: &mut by_work,
        store: &mut NoStore,
        progress: &progress,
        watch: &mut |_: &dyn Fn() -> Study| {},
    };
    assert!(study(&scene("csg/bowl"), &Plan::default(), None, tools).is_none());
}

/// Keeps references in memory.
#[derive(Default)]
struct Memory(BTreeMap<String, Vec<u8>>);

impl Store for Memory {
    fn load(&mut self, name: &str) -> Option<Vec<u8>> {
        self.0.get(name).cloned()
    }

    fn save(&mut self, name: &str, bytes: &[u8]) {
        self.0.insert(name.to_owned(), bytes.to_owned());
    }
}

fn stored(scene: &Scene, budget: f64, store: &mut Memory) -> Run {
    let progress = Progress::new();
    let watch = &mut |_: &dyn Fn() -> Study| {};
    let tools = Tools { stopwatch: &mut by_work, store, progress: &progress, watch };
    study(scene, &plan(8, budget, &[Knob::Shortcuts]), Some(&in_size([8, 5])), tools).unwrap()
}

#[test]
fn a_later_run_goes_on_with_the_reference_of_the_one_before() {
    let (scene, mut store) = (scene("lens/focus"), Memory::default());
    let first = stored(&scene, 1e-6, &mut store).study.reference;
    let second = stored(&scene, 100.0, &mut store).study.reference;
    assert!(!first.cached && second.cached && second.pictures > first.pictures);
    let alone = stored(&scene, 100.0, &mut Memory::default()).study.reference;
    assert_eq!(second.picture, alone.picture, "as if it had been made at once");
}

#[test]
fn a_broken_reference_is_made_anew_and_that_is_said() {
    let (scene, mut store) = (scene("hello/sphere"), Memory::default());
    let whole = stored(&scene, 1.0, &mut store);
    assert!(whole.warnings.is_empty());
    store.0.values_mut().for_each(|bytes| bytes.truncate(40));
    let again = stored(&scene, 1.0, &mut store);
    assert_eq!(again.study.reference, whole.study.reference);
    assert!(again.warnings[0].contains("checksum"), "{:?}", again.warnings);
}

/// What is predicted of the whole picture against the whole picture itself, by a clock that goes by work.
#[test]
fn answers_hold_for_the_whole_picture_within_a_quarter_of_the_time_and_a_factor_of_two_of_the_error() {
    for (name, knobs) in [
        ("lights/soft_shadows", vec![Knob::Samples, Knob::Arithmetic]),
        ("optics/fresnel", vec![Knob::Depth, Knob::Contribution, Knob::Arithmetic]),
    ] {
        let scene = narrow(scene(name), 96);
        let standard = measured(&scene, &plan(32, 20.0, &knobs), by_work).study.standard;
        let goals = vec![Goal::Error(1.5 * standard.errors.rmse.max(0.002))];
        let run = measured(&scene, &Plan { goals, combines: true, ..plan(32, 20.0, &knobs) }, by_work);
        let answer = &run.answers[0];
        let fresh = measured(&scene.with_profile(&answer.profile), &plan(96, 400.0, &[]), by_work);
        let truth = measured(&scene, &plan(96, 400.0, &[]), by_work).study.reference;
        let seconds = fresh.study.standard.timing.seconds;
        let error = errors(&fresh.study.standard.picture, &truth.picture).rmse;
        assert!((answer.seconds / seconds - 1.0).abs() < 0.25, "{name}: {} predicted, {seconds} taken", answer.seconds);
        assert!((0.5..2.0).contains(&(answer.error / error)), "{name}: {} predicted, {error} found", answer.error);
    }
}
