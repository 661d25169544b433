//! Lessons in the workbench: all of them walked through, their questions answered in every way that they expect.
//!
//! `RAYSCOPE_LESSONS=FOLDER` walks through those of a folder instead of those that come with the program.
#![cfg(feature = "workbench")]

mod hands;
#[path = "hands/walker.rs"]
mod walker;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use hands::*;
use rayscope::app::{Command, EditCommand, LessonCommand, Pane, Preset, ViewCommand};
use rayscope::lesson::Scenes;
use rayscope::lesson::question::Form;
use rayscope::lesson_folder::Lessons;
use rayscope::record::What;
use std::fs;
use std::path::{Path, PathBuf};
use walker::{changed, go_on, posed_in, walk};

const SIZE: Vec2 = Vec2::new(1280.0, 800.0);

/// Until the step is set up and every answer judged.
fn ready(bench: &mut Bench) {
    bench.step();
    bench.step();
    wait_until(bench, "the lesson", |bench| !workbench(bench).lesson().is_busy() && !workbench(bench).is_busy());
    bench.step();
    bench.step();
}

fn open_lessons<'a>(lessons: Lessons) -> Bench<'a> {
    let mut bench = open_at("hello/sphere", SIZE);
    workbench_mut(&mut bench).use_lessons(lessons);
    ready(&mut bench);
    bench
}

/// A short lesson on the bowl, for these tests alone.
fn bowl() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/workbench_lesson/01_bowl")
}

/// A copy of it that can be written in.
fn copy_of_bowl() -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("there is room for a file");
    let lesson = folder.path().join("01_bowl");
    fs::create_dir(&lesson).expect("the folder is new");
    let file = lesson.join("lesson.md");
    fs::copy(bowl().join("lesson.md"), &file).expect("it can be read");
    (folder, file)
}

fn open_bowl<'a>() -> Bench<'a> {
    open_lessons(Lessons::named(&bowl().display().to_string()).expect("it is a lesson"))
}

fn press_button(bench: &mut Bench, name: &str) {
    bench.get_by_role_and_label(Role::Button, name).click_accesskit();
    bench.step();
    bench.step();
}

/// To the step that asks for a change.
fn go_to_the_end(bench: &mut Bench) {
    let last = workbench(bench).lesson().steps() - 1;
    workbench_mut(bench).go_to_step(last);
    ready(bench);
}

fn step_of(bench: &Bench) -> usize {
    workbench(bench).lesson().place().expect("a lesson is open").1
}

fn is_said(bench: &Bench, text: &str) -> bool {
    bench.query_all_by_label_contains(text).next().is_some()
}

fn command(bench: &mut Bench, command: LessonCommand) {
    workbench_mut(bench).run(Command::Lesson(command));
    ready(bench);
}

fn write_scene(bench: &mut Bench, text: &str) {
    workbench_mut(bench).put_cursor(0);
    bench.step();
    bench.step();
    bench.key_press_modifiers(Modifiers::COMMAND, Key::A);
    bench.event(Event::Paste(text.to_owned()));
    bench.step();
    wait_until(bench, "the scene to follow its text", |bench| !workbench(bench).is_stale());
    ready(bench);
    workbench_mut(bench).reveal(Pane::Lesson);
    bench.step();
}

#[test]
fn every_lesson_is_walked_through_first_part() {
    walk(0, 4);
}

#[test]
fn every_lesson_is_walked_through_second_part() {
    walk(1, 4);
}

#[test]
fn every_lesson_is_walked_through_third_part() {
    walk(2, 4);
}

#[test]
fn every_lesson_is_walked_through_fourth_part() {
    walk(3, 4);
}

#[test]
fn a_step_shows_its_ray_its_event_and_its_drawings() {
    let mut bench = open_bowl();
    assert_eq!(workbench(&bench).dock().preset(), Preset::Lesson);
    assert_eq!(workbench(&bench).scene().expect("open").name, "csg/bowl");
    assert_eq!(pixel(&bench), [333, 150]);
    let recording = workbench(&bench).recording().expect("recorded");
    assert!(matches!(recording.tree.event(recording.selected()).what, What::Hit { .. }));
    for pane in [Pane::Lesson, Pane::Side, Pane::Along, Pane::Picture] {
        assert!(workbench(&bench).dock().shows(pane), "{pane:?}");
    }
    command(&mut bench, LessonCommand::Next);
    let recording = workbench(&bench).recording().expect("recorded");
    assert!(matches!(recording.tree.event(recording.selected()).what, What::Rejected { .. }));
}

#[test]
fn a_click_on_a_value_selects_its_event() {
    let mut bench = open_bowl();
    let hit = selected(&bench);
    workbench_mut(&mut bench).select(0);
    settle(&mut bench);
    bench.get_by_role_and_label(Role::Link, "bowl (hit.object)").click_accesskit();
    settle(&mut bench);
    assert_eq!(selected(&bench), hit);
    // From another pixel it leads back to the step's.
    workbench_mut(&mut bench).record([10, 10]);
    settle(&mut bench);
    bench.get_by_role_and_label(Role::Link, "bowl (hit.object)").click_accesskit();
    settle(&mut bench);
    assert_eq!((pixel(&bench), selected(&bench)), ([333, 150], hit));
}

#[test]
fn nothing_blocks_the_way_on_or_back() {
    let mut bench = open_bowl();
    go_on(&mut bench, "Next step");
    assert_eq!(step_of(&bench), 1);
    go_on(&mut bench, "Skip step");
    assert_eq!(step_of(&bench), 2);
    press_button(&mut bench, "Previous step");
    ready(&mut bench);
    assert_eq!(step_of(&bench), 1);
    while step_of(&bench) + 1 < workbench(&bench).lesson().steps() {
        go_on(&mut bench, "Skip step");
    }
    go_on(&mut bench, "Finish lesson");
    assert_eq!(workbench(&bench).lesson().place(), None);
}

#[test]
fn hints_come_one_by_one_and_the_answer_is_shown_on_request() {
    let mut bench = open_bowl();
    command(&mut bench, LessonCommand::Next);
    assert!(!is_said(&bench, "Look at the interval lists"));
    command(&mut bench, LessonCommand::Hint);
    assert!(is_said(&bench, "Look at the interval lists"));
    command(&mut bench, LessonCommand::Reveal);
    assert!(is_said(&bench, "answer shown"));
    assert!(is_said(&bench, "This is the answer.") && !is_said(&bench, "✓ Right."), "it was not found");
    assert!(is_said(&bench, "There the boundary of a part is none of the whole."));
    assert!(bench.query_by_role_and_label(Role::Button, "Next step").is_some(), "there is nothing left to skip");
}

#[test]
fn rows_that_would_tell_the_answer_wait_for_it() {
    let mut bench = open_bowl();
    let untold = |bench: &Bench| {
        let recording = workbench(bench).recording().expect("recorded");
        recording.story().outline().len() - recording.rows_told()
    };
    assert_eq!(untold(&bench), 0, "the first step asks nothing");
    command(&mut bench, LessonCommand::Next);
    assert!(untold(&bench) > 0 && is_said(&bench, "The rest is told with the answers"));
    command(&mut bench, LessonCommand::Reveal);
    assert!(untold(&bench) == 0 && !is_said(&bench, "The rest is told with the answers"));
}

#[test]
fn the_answer_to_a_change_is_made_in_the_scene_and_can_be_taken_back() {
    let mut bench = open_bowl();
    go_to_the_end(&mut bench);
    let before = editing::text(&bench);
    command(&mut bench, LessonCommand::Reveal);
    wait_until(&mut bench, "the scene to follow its text", |bench| !workbench(bench).is_stale());
    assert_ne!(editing::text(&bench), before);
    run(&mut bench, EditCommand::Undo);
    assert_eq!(editing::text(&bench), before);
}

#[test]
fn a_change_is_judged_as_soon_as_the_scene_follows_it() {
    let mut bench = open_bowl();
    go_to_the_end(&mut bench);
    let before = editing::text(&bench);
    write_scene(&mut bench, &before.replacen("\"field_of_view\": 31", "\"field_of_view\": 36", 1));
    wait_until(&mut bench, "the verdict", |bench| is_said(bench, "The ray still hits the bowl."));
    let lesson = Lessons::named(&bowl().display().to_string()).expect("it is a lesson");
    let step = lesson.course.lessons[0].steps.last().expect("it has steps");
    let (stage, posed) = posed_in(&lesson.course.lessons[0], step, &lesson, &Scenes::default());
    let Form::Edit(edit) = &posed[0].form else { panic!("the last question asks for a change") };
    write_scene(&mut bench, &changed(&stage.scene.text, &edit.edit.solution));
    wait_until(&mut bench, "the verdict", |bench| is_said(bench, "✓ Right."));
}

#[test]
fn what_was_tried_out_in_the_scene_of_a_step_is_given_up_for_the_next_one_without_a_question() {
    let mut bench = open_bowl();
    let mine = editing::text(&bench).replacen("\"field_of_view\": 31", "\"field_of_view\": 36", 1);
    write_scene(&mut bench, &mine);
    // Back to the ray of the same step it is asked: the change may be what the step is about.
    press_button(&mut bench, "Back to this step’s ray");
    press_button(&mut bench, "Cancel");
    assert_eq!(editing::text(&bench), mine);
    press_button(&mut bench, "Next step");
    ready(&mut bench);
    assert!(bench.query_by_role_and_label(Role::Button, "Don’t save").is_none());
    assert!(editing::text(&bench).contains("\"field_of_view\": 31"));
    assert_eq!((step_of(&bench), pixel(&bench)), (1, [333, 150]));
}

#[test]
fn unsaved_changes_of_an_own_scene_are_asked_about_before_a_lesson_opens_its_scene() {
    let mut bench = open_at("hello/sphere", SIZE);
    let mine = format!("{}\n", editing::text(&bench));
    write_scene(&mut bench, &mine);
    workbench_mut(&mut bench).use_lessons(Lessons::named(&bowl().display().to_string()).expect("it is a lesson"));
    ready(&mut bench);
    press_button(&mut bench, "Cancel");
    ready(&mut bench);
    assert_eq!(editing::text(&bench), mine);
    press_button(&mut bench, "Back to this step’s ray");
    press_button(&mut bench, "Don’t save");
    ready(&mut bench);
    assert!(editing::text(&bench).contains("\"field_of_view\": 31"));
    assert_eq!(pixel(&bench), [333, 150]);
}

#[test]
fn drawings_that_a_step_does_not_show_wait_for_its_answers() {
    let mut bench = open_bowl();
    let drawings = |bench: &Bench| bench.query_all_by_role(Role::Image).count();
    let seen = [Pane::Picture, Pane::Side, Pane::Along];
    assert!(seen.iter().all(|pane| !workbench(&bench).is_veiled(*pane)), "the first step shows them and asks nothing");
    assert!(drawings(&bench) >= seen.len());
    command(&mut bench, LessonCommand::Next);
    assert!(workbench(&bench).dock().shows(Pane::Side), "the step before left it in front");
    assert_eq!(drawings(&bench), 1, "the picture alone");
    let lift = "The rest is told with the answers. Show it now";
    let links: Vec<_> = bench.query_all_by_role_and_label(Role::Link, lift).collect();
    assert!(links.len() > 1, "in the story, and in place of a drawing");
    links[links.len() - 1].click_accesskit();
    settle(&mut bench);
    assert!(seen.iter().all(|pane| !workbench(&bench).is_veiled(*pane)) && drawings(&bench) > 1);
    command(&mut bench, LessonCommand::Restage);
    assert!(workbench(&bench).is_veiled(Pane::Side));
    command(&mut bench, LessonCommand::Reveal);
    assert!(!workbench(&bench).is_veiled(Pane::Side));
}

#[test]
fn what_is_said_about_an_answer_comes_into_sight() {
    let size = Vec2::new(1280.0, 460.0);
    let mut bench = open_at("hello/sphere", size);
    workbench_mut(&mut bench).use_lessons(Lessons::named(&bowl().display().to_string()).expect("it is a lesson"));
    ready(&mut bench);
    command(&mut bench, LessonCommand::Next);
    bench.get_by_role_and_label(Role::RadioButton, "The point lies behind the eye.").click_accesskit();
    settle(&mut bench);
    for said in [(LessonCommand::Check, "✗ Not right."), (LessonCommand::Hint, "Look at the interval lists")] {
        command(&mut bench, said.0);
        // It is scrolled in a few frames.
        for _ in 0..60 {
            bench.step();
        }
        let rect = bench.query_all_by_label_contains(said.1).next().expect("it is said").rect();
        let panel = workbench(&bench).dock().rect_of(Pane::Lesson).expect("it is seen");
        assert!(panel.contains_rect(rect), "{}: {rect:?} in {panel:?}", said.1);
    }
}

#[test]
fn after_the_last_hint_its_button_stays_where_it_was() {
    let mut bench = open_bowl();
    command(&mut bench, LessonCommand::Next);
    let place = |bench: &Bench| bench.get_by_role_and_label(Role::Button, "Show the answer, question 1").rect().left();
    let before = place(&bench);
    press_button(&mut bench, "Hint, question 1");
    assert!(bench.get_by_role_and_label(Role::Button, "Hint, question 1").accesskit_node().is_disabled());
    assert!((place(&bench) - before).abs() < 0.5);
}

#[test]
fn values_within_choices_lead_nowhere() {
    let (_folder, file) = copy_of_bowl();
    let text = fs::read_to_string(&file).expect("it was just copied");
    let text = text.replace("The point lies behind the eye.", "The time {{rejected.t}} lies behind the eye.");
    fs::write(&file, text).expect("it can be written");
    let mut bench = open_lessons(Lessons::named(&file.display().to_string()).expect("a lesson"));
    command(&mut bench, LessonCommand::Next);
    assert!(is_said(&bench, "lies behind the eye."));
    let links = bench.query_all_by_role(Role::Link).filter_map(|link| link.accesskit_node().label());
    assert_eq!(links.filter(|label| label.contains("rejected.t")).count(), 0);
}

#[test]
fn the_recorded_pixel_can_be_taken_once_one_was_recorded() {
    let (_folder, file) = copy_of_bowl();
    let text = fs::read_to_string(&file).expect("it was just copied");
    let at = text.find("kind = \"choice\"").expect("it asks for a choice");
    let end = at + text[at..].find("```").expect("the question ends");
    let question =
        "kind = \"place\"\nask = \"Where is the point?\"\nanswer = \"hit.point\"\nin = \"image\"\ntolerance = \"20\"\n";
    fs::write(&file, format!("{}{question}{}", &text[..at], &text[end..])).expect("it can be written");
    let mut bench = open_lessons(Lessons::named(&file.display().to_string()).expect("a lesson"));
    command(&mut bench, LessonCommand::Next);
    let name = "Take the recorded pixel, question 1";
    let is_disabled = |bench: &Bench| bench.get_by_role_and_label(Role::Button, name).accesskit_node().is_disabled();
    assert!(is_disabled(&bench), "nobody has recorded one");
    workbench_mut(&mut bench).record([10, 10]);
    settle(&mut bench);
    assert!(!is_disabled(&bench));
    press_button(&mut bench, name);
    assert!(is_said(&bench, "✗ Not right."));
}

#[test]
fn after_a_lesson_the_next_one_is_offered() {
    let (folder, file) = copy_of_bowl();
    let other = folder.path().join("02_other");
    fs::create_dir(&other).expect("the folder is new");
    let text = fs::read_to_string(&file).expect("it was just copied");
    let text = text.replace("A ray through the bowl", "The bowl once more");
    fs::write(other.join("lesson.md"), text).expect("it can be written");
    let mut bench = open_lessons(Lessons::named(&file.display().to_string()).expect("a lesson"));
    go_to_the_end(&mut bench);
    press_button(&mut bench, "Finish lesson");
    ready(&mut bench);
    assert!(is_said(&bench, "“A ray through the bowl” is done."));
    press_button(&mut bench, "The bowl once more");
    ready(&mut bench);
    assert_eq!(workbench(&bench).lesson().place(), Some(("02_other", 0)));
}

#[test]
fn a_step_brings_the_story_to_the_front_and_its_event_into_sight() {
    let mut bench = open_at("hello/sphere", Vec2::new(1280.0, 560.0));
    reveal(&mut bench, Pane::Story);
    workbench_mut(&mut bench).use_lessons(Lessons::named(&bowl().display().to_string()).expect("it is a lesson"));
    ready(&mut bench);
    reveal(&mut bench, Pane::Editor);
    command(&mut bench, LessonCommand::Next);
    settle(&mut bench);
    let panel = workbench(&bench).dock().rect_of(Pane::Story).expect("it is in front");
    let row = bench.query_all_by_role(Role::TreeItem).find(|row| row.accesskit_node().is_selected() == Some(true));
    let rect = row.expect("it is laid out").rect();
    assert!(panel.contains_rect(rect), "{rect:?} in {panel:?}");
}

#[test]
fn a_long_name_of_a_scene_pushes_no_menu_under_the_layouts() {
    let mut bench = open_at("hello/sphere", SIZE);
    ready(&mut bench);
    workbench_mut(&mut bench).use_lessons(Lessons::embedded());
    workbench_mut(&mut bench).open_lesson("05_every_case_of_the_tapered_cylinder");
    ready(&mut bench);
    assert!(workbench(&bench).scene().expect("open").name.len() > 50);
    let rect = |name: &str| bench.get_by_role_and_label(Role::Button, name).rect();
    assert!(rect("Help").right() <= rect("Learn").left(), "{:?} {:?}", rect("Help"), rect("Learn"));
}

#[test]
fn progress_is_kept_written_read_and_forgotten() {
    let mut bench = open_bowl();
    command(&mut bench, LessonCommand::Next);
    command(&mut bench, LessonCommand::Reveal);
    let kept = workbench(&bench).keep();
    let mut next = open_at("hello/sphere", SIZE);
    workbench_mut(&mut next).take_up(&kept);
    workbench_mut(&mut next).use_lessons(Lessons::named(&bowl().display().to_string()).expect("a lesson"));
    ready(&mut next);
    assert_eq!(step_of(&next), 1);
    assert!(is_said(&next, "answer shown"));
    let folder = tempfile::tempdir().expect("there is room for a file");
    let file = folder.path().join("progress.json");
    let ctx = workbench(&next).ctx();
    workbench_mut(&mut next).lesson_mut().write_progress(&ctx, &file);
    command(&mut next, LessonCommand::Reset);
    press_button(&mut next, "Forget it");
    assert!(workbench(&next).lesson().progress.lessons.is_empty());
    workbench_mut(&mut next).lesson_mut().read_progress(&ctx, &file);
    assert_eq!(workbench(&next).lesson().progress, workbench(&bench).lesson().progress);
}

#[test]
fn a_lesson_on_disk_is_read_anew_when_it_is_saved() {
    let (_folder, file) = copy_of_bowl();
    let mut bench = open_lessons(Lessons::named(&file.display().to_string()).expect("a lesson"));
    command(&mut bench, LessonCommand::Next);
    let text = fs::read_to_string(&file).expect("it was just copied");
    let better = text.replace("One hit lies in front of the one that is seen.", "Something else is said now.");
    fs::write(&file, &better).expect("it can be written");
    wait_until(&mut bench, "the new text", |bench| is_said(bench, "Something else is said now."));
    assert_eq!(step_of(&bench), 1, "one stays where one was");
    let wrong = better.replace("Something else is said now.", "It is at {{rejected.tee}}.");
    let line = 1 + wrong.lines().position(|line| line.contains("rejected.tee")).expect("it is there");
    fs::write(&file, &wrong).expect("it can be written");
    wait_until(&mut bench, "what is wrong", |bench| is_said(bench, "Something is wrong with this lesson"));
    assert!(is_said(&bench, &format!("lesson.md:{line}:")));
    fs::write(&file, &better).expect("it can be written");
    wait_until(&mut bench, "the mended text", |bench| !is_said(bench, "wrong with this lesson"));
}

#[test]
fn terms_tell_what_they_mean_and_links_lead_to_other_lessons() {
    let (folder, file) = copy_of_bowl();
    let other = folder.path().join("02_other");
    fs::create_dir(&other).expect("the folder is new");
    fs::copy(&file, other.join("lesson.md")).expect("it can be copied");
    fs::write(folder.path().join("glossary.md"), "## bowl\n\nSomething that soup is eaten from.\n")
        .expect("it can be written");
    let text = fs::read_to_string(&file).expect("it was just copied");
    let text = text.replace(
        "Say in two or three sentences",
        "A bowl, and [another](lesson:02_other): say in two or three sentences",
    );
    fs::write(&file, text).expect("it can be written");
    let mut bench = open_lessons(Lessons::named(&file.display().to_string()).expect("a lesson"));
    bench.get_by_role_and_label(Role::Link, "bowl").click_accesskit();
    settle(&mut bench);
    assert!(is_said(&bench, "Something that soup is eaten from."));
    press_button(&mut bench, "Close");
    assert!(!is_said(&bench, "Something that soup is eaten from."));
    bench.get_by_role_and_label(Role::Link, "another").click_accesskit();
    ready(&mut bench);
    assert_eq!(workbench(&bench).lesson().place(), Some(("02_other", 0)));
}

#[test]
fn the_keyboard_alone_goes_through_a_lesson() {
    let mut bench = open_bowl();
    bench.key_press_modifiers(Modifiers::COMMAND, Key::PageDown);
    ready(&mut bench);
    assert_eq!(step_of(&bench), 1);
    let name = "The point lies behind the eye.";
    for _ in 0..200 {
        if bench.get_by_role_and_label(Role::RadioButton, name).is_focused() {
            break;
        }
        bench.key_press(Key::Tab);
        bench.step();
    }
    press(&mut bench, Key::Space);
    bench.key_press_modifiers(Modifiers::COMMAND, Key::Enter);
    settle(&mut bench);
    assert!(is_said(&bench, "Its time is positive, so it lies in front."));
    bench.key_press_modifiers(Modifiers::COMMAND, Key::PageUp);
    ready(&mut bench);
    assert_eq!(step_of(&bench), 0);
}

#[test]
fn the_course_is_offered_in_the_layout_for_learning() {
    let mut bench = open("hello/sphere");
    assert!(workbench(&bench).dock().holds(Pane::Lesson));
    reveal(&mut bench, Pane::Lesson);
    wait_until(&mut bench, "the course", |bench| is_said(bench, "lessons done"));
    for name in ["Map", "List"] {
        press_button(&mut bench, name);
        let lessons = workbench(&bench).lesson().lessons().expect("they are read").course.lessons.clone();
        for lesson in &lessons {
            assert!(is_said(&bench, &lesson.header.title), "{name}: {}", lesson.id);
        }
    }
    run(&mut bench, ViewCommand::Layout(Preset::Lesson));
    assert!(is_said(&bench, "lessons done"));
}
