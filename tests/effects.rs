//! A scene pays for what it calls for, and for nothing else.

use rayscope::record::{Counter, Effect, Entry, Recorder};
use rayscope::scene::{Effects, Image, Scene, embedded_scenes, load, reasons};
use rayscope::trace::{Progress, render, trace_pixel};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Aborts where the code of an effect is entered that was not declared.
struct Guard {
    declared: Effects,
}

impl Recorder for Guard {
    const RECORDING: bool = false;

    fn begin(&mut self) {}

    fn end(&mut self, _describe: impl FnOnce() -> Entry) {}

    fn count(&mut self, counter: Counter) {
        if let Counter::Call(effect) | Counter::Sent(effect) = counter {
            assert!(self.declared.has(effect), "{} was entered, and was not declared", effect.name());
        }
    }
}

/// Every embedded scene, small, and with few samples.
fn small_scenes() -> Vec<(String, Scene)> {
    let small = |text: &str, name: &str| {
        let mut scene = load(text, name).unwrap_or_else(|errors| panic!("{errors}"));
        scene.image = Image { width: 24, height: 18 };
        scene.sampling.samples = scene.sampling.samples.min(4);
        scene.sampling.adaptive = None;
        scene
    };
    embedded_scenes().into_iter().map(|scene| (scene.name.clone(), small(scene.text, &scene.name))).collect()
}

/// The bits of all pixels, with every effect switched on and those that were not declared aborting.
fn guarded(scene: &Scene, declared: Effects) -> Vec<[u64; 3]> {
    let all = scene.with_effects(Effects::ALL);
    let Image { width, height } = scene.image;
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
    let colour = |[x, y]: [u32; 2]| trace_pixel(&all, x, y, &mut Guard { declared }).to_array().map(f64::to_bits);
    pixels.map(colour).collect()
}

fn rendered(scene: &Scene) -> Vec<[u64; 3]> {
    let (picture, _) = render(scene, &Progress::new());
    let pixels = (0..picture.height).flat_map(|y| (0..picture.width).map(move |x| [x, y]));
    pixels.map(|[x, y]| picture.pixel(x, y).to_array().map(f64::to_bits)).collect()
}

#[test]
fn what_a_scene_does_not_call_for_is_never_entered_even_where_it_is_switched_on() {
    for (name, scene) in small_scenes() {
        assert!(guarded(&scene, scene.effects) == rendered(&scene), "{name}: the pictures differ");
    }
}

#[test]
fn the_counters_of_what_a_scene_does_not_call_for_are_zero() {
    let mut entered = [0; Effect::ALL.len()];
    for (name, scene) in small_scenes() {
        let (_, tally) = render(&scene, &Progress::new());
        for (effect, entered) in Effect::ALL.into_iter().zip(&mut entered) {
            *entered += tally.calls(effect);
            if !scene.effects.has(effect) {
                assert_eq!((tally.calls(effect), tally.sent(effect)), (0, 0), "{name}: {}", effect.name());
            }
        }
    }
    for (effect, entered) in Effect::ALL.into_iter().zip(entered) {
        assert!(entered > 0, "no scene shows {}", effect.name());
    }
}

#[test]
fn a_scene_that_is_declared_wrongly_is_found_out() {
    let mut found_out = 0;
    for (name, scene) in small_scenes() {
        let (_, tally) = render(&scene, &Progress::new());
        for effect in Effect::ALL.into_iter().filter(|&effect| tally.calls(effect) > 0) {
            let wrongly = scene.effects.without(effect);
            let outcome = catch_unwind(AssertUnwindSafe(|| guarded(&scene, wrongly)));
            assert!(outcome.is_err(), "{name} was declared without {} and nobody noticed", effect.name());
            found_out += 1;
        }
    }
    assert!(found_out > 50, "{found_out}");
}

#[test]
fn an_effect_that_is_switched_off_is_never_entered() {
    for (name, scene) in small_scenes() {
        for effect in Effect::ALL.into_iter().filter(|&effect| scene.effects.has(effect)) {
            let (_, tally) = render(&scene.with_effects(scene.effects.without(effect)), &Progress::new());
            assert_eq!((tally.calls(effect), tally.sent(effect)), (0, 0), "{name}: {}", effect.name());
        }
    }
}

fn scene(objects: &str) -> Scene {
    let text = format!(
        r#"{{"image": {{"width": 40, "height": 30}}, "lights": [{{"point": [4, -5, 8]}}],
            "materials": {{"matt": {{}}, "glass": {{"transparency": 0.9, "index_of_refraction": 1.5,
                "ambient": [0, 0, 0], "diffuse": [0, 0, 0]}}}},
            "objects": [{{"shape": "plane", "material": "matt", "transform": [{{"translate": [0, 0, -1]}}]}},
                {{"name": "stone", "shape": "sphere", "material": "matt"}}{objects}]}}"#
    );
    load(&text, "made up").unwrap_or_else(|errors| panic!("{errors}"))
}

#[test]
fn one_glass_object_changes_its_own_rows_and_no_other_reason() {
    let glass = r#", {"name": "bead", "shape": "sphere", "material": "glass", "transform": [{"scale": 0.4}, {"translate": [1, -2, 0.5]}]}"#;
    let (before, after) = (scene(""), scene(glass));
    let changed: Vec<_> = reasons(&before).into_iter().zip(reasons(&after)).filter(|(a, b)| a != b).collect();
    let names: Vec<_> = changed.iter().map(|(_, after)| (after.effect, after.why.as_str())).collect();
    assert_eq!(names, [(Effect::Refraction, "transparent materials: `glass` on `bead`")]);
    let tallies = [&before, &after].map(|scene| render(scene, &Progress::new()).1);
    for effect in Effect::ALL.into_iter().filter(|effect| !matches!(effect, Effect::Refraction | Effect::Shadows)) {
        assert_eq!(tallies[0].calls(effect), tallies[1].calls(effect), "{}", effect.name());
        assert_eq!(tallies[1].calls(effect), 0, "{}", effect.name());
    }
    assert_eq!(tallies[0].calls(Effect::Refraction), 0);
    assert!(tallies[1].calls(Effect::Refraction) > 0 && tallies[1].sent(Effect::Refraction) > 0);
}

#[test]
fn a_material_that_no_object_uses_calls_for_nothing() {
    let fog = r#"{"transparency": 1, "medium": {"scattering": [1, 1, 1]}}"#;
    let scene = |material| {
        let text = format!(
            r#"{{"materials": {{"fog": {fog}, "matt": {{}}}}, "objects": [{{"shape": "sphere", "material": "{material}"}}]}}"#
        );
        load(&text, "made up").unwrap_or_else(|errors| panic!("{errors}"))
    };
    let (used, unused) = (scene("fog"), scene("matt"));
    assert_eq!((used.sampling.samples, unused.sampling.samples), (16, 1));
    assert!(used.effects.has(Effect::Scattering) && used.effects.has(Effect::Antialiasing));
    assert_eq!(unused.effects, Effects::default());
}
