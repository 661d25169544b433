//! What a student tries out within a lesson: nothing gives an answer away before it is given, and no change of the scene is in the way.
#![cfg(feature = "workbench")]

mod hands;

use egui::Vec2;
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use hands::editing::{follow, open_editor, put_cursor, text, type_text};
use hands::*;
use rayscope::app::{Command, LessonCommand, Pane};
use rayscope::lesson_folder::Lessons;
use std::path::Path;

/// High enough for all rows of the stories that are looked at here.
const SIZE: Vec2 = Vec2::new(1600.0, 1600.0);

/// Until the step is set up and every answer judged.
fn ready(bench: &mut Bench) {
    settle(bench);
    wait_until(bench, "the lesson", |bench| !workbench(bench).lesson().is_busy() && !workbench(bench).is_busy());
    settle(bench);
}

fn open_lesson<'a>(lessons: Lessons, id: &str, step: usize) -> Bench<'a> {
    let mut bench = open_at("hello/sphere", SIZE);
    workbench_mut(&mut bench).use_lessons(lessons);
    workbench_mut(&mut bench).open_lesson_at(id, step);
    ready(&mut bench);
    bench
}

/// The last step of a short lesson on the bowl, which asks for a change; its scene is changed, but not as it asks.
fn tried<'a>() -> Bench<'a> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/workbench_lesson/01_bowl");
    let lessons = Lessons::named(&folder.display().to_string()).expect("it is a lesson");
    let mut bench = open_lesson(lessons, "01_bowl", 2);
    put_cursor(&mut bench, "\"field_of_view\": 31", true);
    type_text(&mut bench, ".5");
    follow(&mut bench);
    assert!(text(&bench).contains("\"field_of_view\": 31.5"));
    reveal(&mut bench, Pane::Lesson);
    ready(&mut bench);
    bench
}

fn has_button(bench: &Bench, name: &str) -> bool {
    bench.query_by_role_and_label(Role::Button, name).is_some()
}

fn press_button(bench: &mut Bench, name: &str) {
    bench.get_by_role_and_label(Role::Button, name).click_accesskit();
    ready(bench);
}

#[test]
fn the_rows_that_a_question_stands_in_tell_no_results_before_it_is_answered() {
    for (lesson, step, told) in
        [("26_compound_objects", 2, "early out"), ("26_compound_objects", 6, "rocket: 2 inside intervals")]
    {
        let mut bench = open_lesson(Lessons::embedded(), lesson, step);
        let recording = workbench(&bench).recording().expect("recorded");
        let path = recording.tree.path(recording.selected());
        assert!(path.iter().all(|&id| recording.keeps_outcome(id)), "{lesson}: what is under way has no outcome yet");
        let says = |bench: &Bench| rows(bench).iter().any(|row| row.contains(told));
        assert!(!says(&bench), "{lesson}: {:?}", rows(&bench));
        assert!(workbench(&bench).is_veiled(Pane::Detail), "the panel of the selected event would tell it");
        workbench_mut(&mut bench).run(Command::Lesson(LessonCommand::Reveal));
        ready(&mut bench);
        assert!(says(&bench), "{lesson}: {:?}", rows(&bench));
        assert!(!workbench(&bench).is_veiled(Pane::Detail));
    }
}

#[test]
fn the_ray_of_a_step_that_asks_for_a_change_is_found_again_in_the_changed_scene() {
    let mut bench = tried();
    assert!(has_button(&bench, "Start again") && !has_button(&bench, "Back to this step’s ray"));
    workbench_mut(&mut bench).record([10, 10]);
    ready(&mut bench);
    press_button(&mut bench, "Back to this step’s ray");
    assert!(!has_button(&bench, "Don’t save"), "nothing is given up, so nothing is asked");
    assert_eq!(pixel(&bench), [333, 150]);
    assert!(text(&bench).contains("\"field_of_view\": 31.5"));
    press_button(&mut bench, "Start again");
    assert!(!has_button(&bench, "Don’t save"));
    assert!(!text(&bench).contains("31.5"));
    assert_eq!(pixel(&bench), [333, 150]);
}

#[test]
fn what_was_tried_out_is_nobodys_edit_once_the_lesson_is_finished() {
    let mut bench = tried();
    assert!(workbench(&bench).document().is_dirty());
    press_button(&mut bench, "Finish lesson");
    assert!(!workbench(&bench).document().is_dirty(), "there is nothing to offer back after a crash");
}

#[test]
fn a_number_that_is_typed_into_the_properties_arrives_whole() {
    let mut bench = open_editor("hello/sphere");
    put_cursor(&mut bench, "\"key light\"", false);
    reveal(&mut bench, Pane::Properties);
    let place = |bench: &Bench| bench.get_by_label("point z").rect();
    let field = place(&bench).center();
    click(&mut bench, field);
    let top = place(&bench).top();
    for digit in ["1", "2"] {
        type_text(&mut bench, digit);
        follow(&mut bench);
        assert_eq!(place(&bench).top(), top, "it stays where it is");
    }
    let scene: serde_json::Value = serde_json::from_str(&text(&bench)).expect("JSON");
    assert_eq!(scene["lights"][0]["point"][2].as_f64(), Some(12.0), "{}", scene["lights"][0]);
}
