//! The accuracy panel as a person uses it, found through the names that a screen reader reads out.
#![cfg(feature = "workbench")]

mod hands;

use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use hands::{Bench, reveal, settle, wait_until, workbench};
use rayscope::app::{Pane, Preset, ViewCommand};
use rayscope::laboratory::{Target, this_ray};
use rayscope::scene::embedded_scene;
use rayscope::shape::Method;

/// The workbench with a scene open, and what its accuracy costs.
fn open<'a>(scene: &str) -> Bench<'a> {
    let mut bench = hands::open(scene);
    hands::run(&mut bench, ViewCommand::Layout(Preset::Measure));
    bench
}

fn press(bench: &mut Bench, name: &str) {
    bench.get_by_role_and_label(Role::Button, name).click();
    settle(bench);
}

fn offers(bench: &Bench, name: &str) -> bool {
    bench.query_by_role_and_label(Role::Button, name).is_some()
}

#[test]
fn the_settings_of_the_scene_are_measured_and_one_of_them_can_be_looked_at() {
    let mut bench = open("hello/sphere");
    wait_until(&mut bench, "the settings", |bench| offers(bench, "arithmetic f32"));
    assert!(bench.query_by_role_and_label(Role::Image, "Error against seconds").is_some());
    press(&mut bench, "arithmetic f32");
    press(&mut bench, "Look at the scene so");
    let scene = workbench(&bench).scene().expect("a scene is open");
    assert_eq!(scene.scene.solving.method, Method::Single);
    assert_eq!(scene.look.as_ref().map(|look| look.name.as_str()), Some("arithmetic f32"));
    press(&mut bench, "Back to the scene as it stands");
    let scene = workbench(&bench).scene().expect("a scene is open");
    assert_eq!((scene.scene.solving.method, &scene.look), (Method::default(), &None));
    assert!(!offers(&bench, "Back to the scene as it stands"));
}

#[test]
fn every_map_of_a_setting_can_be_seen() {
    let mut bench = open("hello/sphere");
    wait_until(&mut bench, "the settings", |bench| offers(bench, "arithmetic f64"));
    press(&mut bench, "arithmetic f64");
    for (name, title) in [
        ("Error", "Map: Error: arithmetic f64"),
        ("Digits lost", "Map: Digits lost, f64: arithmetic f64"),
        ("Certainty", "Map: What it took to be sure: arithmetic f64"),
        ("ns per pixel", "Map: Time: arithmetic f64"),
    ] {
        press(&mut bench, name);
        wait_until(&mut bench, title, |bench| bench.query_by_role_and_label(Role::Image, title).is_some());
    }
}

#[test]
fn a_method_tells_its_story_from_the_first_event_that_is_not_as_it_should_be() {
    let mut bench = open("hard/far_torus");
    press(&mut bench, "This ray");
    // The table takes its last shape when everything is measured.
    let is_measured = |bench: &Bench| bench.query_by_label_contains("against hits of 77 digits").is_some();
    wait_until(&mut bench, "the methods", |bench| offers(bench, "textbook") && is_measured(bench));
    let (pixel, expected) = {
        let workbench = workbench(&bench);
        let pixel = workbench.recording().expect("a pixel is recorded").pixel;
        let ray = this_ray(&workbench.scene().expect("a scene is open").scene, Target::Pixel(pixel));
        let textbook = ray.stories.into_iter().find(|story| story.method == Method::Textbook);
        (
            pixel,
            textbook.and_then(|story| story.parting).expect("the textbook's quartic goes wrong a million units away"),
        )
    };
    assert!(bench.query_by_label(&expected.reason).is_some(), "{}", expected.reason);
    press(&mut bench, "textbook");
    let recording = workbench(&bench).recording().expect("a pixel is recorded");
    assert_eq!((recording.pixel, recording.by), (pixel, Some(Method::Textbook)));
    assert_eq!(recording.selected(), expected.event);
    reveal(&mut bench, Pane::Story);
    assert!(bench.query_by_label_contains("by textbook · ").is_some());
}

#[test]
fn another_scene_closes_what_was_measured_and_begins_anew() {
    let mut bench = open("hello/sphere");
    wait_until(&mut bench, "the settings", |bench| offers(bench, "arithmetic f32"));
    let (text, context) = (embedded_scene("csg/bowl").expect("the scene is embedded").text, bench.ctx.clone());
    bench.state_mut().as_mut().expect("shown").open_text(&context, "csg/bowl", text);
    settle(&mut bench);
    assert!(!offers(&bench, "arithmetic f32"));
    wait_until(&mut bench, "the other settings", |bench| offers(bench, "arithmetic f32"));
}
