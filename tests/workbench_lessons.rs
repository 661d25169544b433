//! Lessons in the workbench: all of them walked through, their questions answered in every way that they expect.
//!
//! `RAYSCOPE_LESSONS=FOLDER` walks through those of a folder instead of those that come with the program.
#![cfg(feature = "workbench")]

mod hands;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Vec2};
use egui_kittest::kittest::Queryable;
use hands::*;
use rayscope::app::{Command, EditCommand, LessonCommand, Pane, Preset, ViewCommand};
use rayscope::document::{Structure, Syntax};
use rayscope::lesson::model::{Change, Part, Step, Surface};
use rayscope::lesson::prose::{Block, Inline, Line, Prose, Told, plain};
use rayscope::lesson::question::{Form, Spot, Stretch};
use rayscope::lesson::{Lesson, Posed, Scenes, Stage};
use rayscope::lesson_folder::Lessons;
use rayscope::record::{What, format_number};
use std::fs;
use std::path::{Path, PathBuf};

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

/// A few words of a text that stand together on screen.
fn words_of(prose: &Prose<Told>) -> Option<String> {
    let Block::Paragraph(line) = prose.first()? else { return None };
    let texts = line.iter().filter_map(|inline| match inline {
        Inline::Text(text) => Some(text.trim().to_owned()),
        _ => None,
    });
    // The words between terms of the glossary and values.
    texts.max_by_key(String::len).filter(|text| text.len() > 3)
}

fn list_text(list: &[Stretch]) -> String {
    let end = |t: Option<f64>, unbounded: &str| t.map_or(unbounded.to_owned(), format_number);
    let stretches: Vec<_> =
        list.iter().map(|[from, to]| format!("[{}, {}]", end(*from, "−∞"), end(*to, "∞"))).collect();
    if stretches.is_empty() { "∅".to_owned() } else { stretches.join(" ∪ ") }
}

fn changed(text: &str, changes: &[Change]) -> String {
    let mut text = text.to_owned();
    for change in changes {
        let syntax = Syntax::of(&text);
        let structure = Structure { text: &text, syntax: &syntax };
        let mut replacements = structure.set(&change.at, &change.to).expect("the check has made this change");
        replacements.sort_by_key(|replacement| std::cmp::Reverse(replacement.range.start));
        for replacement in replacements {
            text.replace_range(replacement.range, &replacement.text);
        }
    }
    text
}

/// Somebody who goes through a lesson.
struct Walker<'a, 'b> {
    bench: &'b mut Bench<'a>,
    lesson: Lesson,
    at: String,
    answers: usize,
}

impl Walker<'_, '_> {
    /// Answers a question that stands at a place in its step, wrongly in all expected ways and then rightly.
    fn answer(&mut self, stage: &Stage, posed: &Posed, number: usize, before: &[&Posed]) {
        match &posed.form {
            Form::Number(reckoned) => {
                for (value, because) in &reckoned.wrong {
                    self.number(*value, number, Some(because));
                }
                self.number(reckoned.answer, number, None);
            }
            Form::Time(reckoned) => {
                for (value, because) in &reckoned.wrong {
                    self.time(*value, number, Some(because));
                }
                self.time(reckoned.answer, number, None);
            }
            Form::Choice(choices) => {
                for choice in choices.iter().filter(|choice| !choice.is_right) {
                    self.choose(&plain(&choice.text), number, before, Some(&choice.because));
                }
                for choice in choices.iter().filter(|choice| choice.is_right) {
                    self.choose(&plain(&choice.text), number, before, None);
                }
            }
            Form::Intervals(reckoned) => {
                for (list, because) in &reckoned.wrong {
                    self.choose(&list_text(list), number, before, Some(because));
                }
                self.choose(&list_text(&reckoned.answer), number, before, None);
            }
            Form::Order { items, offered, right, wrong } => {
                let mut now = offered.clone();
                for (order, because) in wrong {
                    self.order(items, &mut now, order, number, Some(because));
                }
                self.order(items, &mut now, right, number, None);
            }
            Form::Place(surface, reckoned) => {
                for (spot, because) in &reckoned.wrong {
                    self.click(*surface, spot, number, Some(because));
                }
                self.click(*surface, &reckoned.answer, number, None);
            }
            Form::Edit(posed) => {
                for (wrong, because) in posed.edit.wrong.iter().zip(&posed.because) {
                    self.edit(&changed(&stage.scene.text, &wrong.change), number, Some(because));
                }
                self.edit(&changed(&stage.scene.text, &posed.edit.solution), number, None);
            }
        }
    }

    fn check(&mut self, number: usize, because: Option<&Prose<Told>>) {
        press_button(self.bench, &format!("Check, question {number}"));
        wait_until(self.bench, "the verdict", |bench| !workbench(bench).lesson().is_busy());
        self.bench.step();
        self.expect(number, because);
    }

    fn expect(&mut self, number: usize, because: Option<&Prose<Told>>) {
        self.answers += 1;
        let at = format!("{}, question {number}", self.at);
        match because {
            Some(because) => {
                assert!(is_said(self.bench, "✗ Not right."), "{at}: a wrong answer is taken");
                if let Some(words) = words_of(because) {
                    assert!(is_said(self.bench, &words), "{at}: `{words}` is not said");
                }
            }
            None => {
                // The questions before it are answered already.
                let answered = self.bench.query_all_by_label_contains("✓ answered").count();
                assert_eq!(answered, number, "{at}: the right answer is refused");
            }
        }
    }

    fn number(&mut self, value: f64, number: usize, because: Option<&Prose<Told>>) {
        let name = format!("Answer to question {number}");
        self.bench.get_by_role_and_label(Role::TextInput, &name).focus();
        self.bench.step();
        self.bench.key_press_modifiers(Modifiers::COMMAND, Key::A);
        self.bench.event(Event::Text(format!("{value}").replace('-', "−")));
        self.bench.step();
        self.check(number, because);
    }

    fn time(&mut self, t: f64, number: usize, because: Option<&Prose<Told>>) {
        self.bench.get_by_role(Role::SpinButton).set_value_accesskit(t);
        self.bench.step();
        self.bench.step();
        self.check(number, because);
    }

    fn choose(&mut self, name: &str, number: usize, before: &[&Posed], because: Option<&Prose<Told>>) {
        let has = |posed: &&&Posed| match &posed.form {
            Form::Choice(choices) => choices.iter().any(|choice| plain(&choice.text) == name),
            _ => false,
        };
        let earlier = before.iter().filter(has).count();
        let at = format!("{}: {name}", self.at);
        let mut buttons: Vec<_> = self.bench.query_all_by_role_and_label(Role::RadioButton, name).collect();
        assert!(buttons.len() > earlier, "{at} is not offered");
        buttons.swap_remove(earlier).click_accesskit();
        self.bench.step();
        self.bench.step();
        self.check(number, because);
    }

    /// Moves the things by their buttons, one place at a time.
    fn order(
        &mut self,
        items: &[Line<Told>],
        now: &mut Vec<usize>,
        wanted: &[usize],
        number: usize,
        because: Option<&Prose<Told>>,
    ) {
        for (place, item) in wanted.iter().enumerate() {
            let mut at = now.iter().position(|other| other == item).expect("it is one of them");
            while at > place {
                press_button(self.bench, &format!("Move up: {}", plain(&items[*item])));
                now.swap(at, at - 1);
                at -= 1;
            }
        }
        self.check(number, because);
    }

    fn click(&mut self, surface: Surface, spot: &Spot, number: usize, because: Option<&Prose<Told>>) {
        press_button(self.bench, &format!("Answer with a click, question {number}"));
        ready(self.bench);
        // Drawings come in the background.
        for _ in 0..3 {
            self.bench.step();
        }
        let bench = workbench(self.bench);
        let at = match (surface, spot) {
            (Surface::Side, Spot::World(point)) => bench.side_place(*point).expect("the side view is shown"),
            (Surface::Image, spot) => {
                let scene = &bench.scene().expect("a scene is open").scene;
                let [x, y] = match spot {
                    Spot::World(point) => scene.camera.project(scene.image, (*point).into()).expect("it is in sight"),
                    Spot::Pixel(pixel) => pixel.map(|place| place + 0.5),
                };
                let rect = self.bench.get_by_label("Rendered image").rect();
                let share = [x / f64::from(scene.image.width), y / f64::from(scene.image.height)];
                #[allow(clippy::cast_possible_truncation, reason = "screen coordinates are f32")]
                let share = Vec2::new(share[0] as f32, share[1] as f32);
                rect.min + share * rect.size()
            }
            (Surface::Side, Spot::Pixel(_)) => panic!("{}: there are no pixels in the side view", self.at),
        };
        click(self.bench, at);
        self.expect(number, because);
    }

    /// Writes the changed scene over the one in the editor.
    fn edit(&mut self, text: &str, number: usize, because: Option<&Prose<Told>>) {
        write_scene(self.bench, text);
        self.check(number, because);
    }
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

fn all_lessons() -> Lessons {
    match std::env::var("RAYSCOPE_LESSONS") {
        Ok(folder) => Lessons::named(&folder).expect("there are lessons"),
        Err(_) => Lessons::embedded(),
    }
}

/// The questions of a step, as the workbench poses them.
fn posed_in(lesson: &Lesson, step: &Step, lessons: &Lessons, scenes: &Scenes) -> (Stage, Vec<Posed>) {
    let stage = Stage::new(lesson, step, scenes, &lessons.shelf).unwrap_or_else(|finding| panic!("{finding}"));
    let questions = step.parts.iter().filter_map(|part| match part {
        Part::Question(question) => {
            Some(Posed::new(question, &stage).unwrap_or_else(|findings| panic!("{findings:?}")))
        }
        _ => None,
    });
    let questions = questions.collect();
    (stage, questions)
}

/// Every so many-th lesson, from its first step to its last.
fn walk(part: usize, of: usize) {
    let (lessons, scenes) = (all_lessons(), Scenes::default());
    let mut bench = open_lessons(all_lessons());
    for lesson in lessons.course.lessons.iter().skip(part).step_by(of) {
        workbench_mut(&mut bench).open_lesson(&lesson.id);
        ready(&mut bench);
        discard(&mut bench);
        let mut walker = Walker { bench: &mut bench, lesson: lesson.clone(), at: String::new(), answers: 0 };
        for (number, step) in lesson.steps.iter().enumerate() {
            walker.at = format!("{}, step {}", lesson.id, number + 1);
            assert_eq!(step_of(walker.bench), number, "{}", walker.at);
            assert!(is_said(walker.bench, &step.title), "{}", walker.at);
            assert!(!is_said(walker.bench, "wrong with this lesson"), "{}", walker.at);
            let (stage, posed) = posed_in(lesson, step, &lessons, &scenes);
            for (place, question) in posed.iter().enumerate() {
                let before: Vec<&Posed> = posed[..place].iter().collect();
                walker.answer(&stage, question, place + 1, &before);
            }
            let is_last = number + 1 == walker.lesson.steps.len();
            go_on(walker.bench, if is_last { "Finish lesson" } else { "Next step" });
        }
        assert_eq!(workbench(&bench).lesson().place(), None, "{} is finished", lesson.id);
        let kept = &workbench(&bench).lesson().progress.lessons[&lesson.id];
        assert!(kept.finished && kept.answers.values().all(|record| record.solved), "{}", lesson.id);
    }
}

/// Goes on; what was changed in the scene is thrown away.
fn go_on(bench: &mut Bench, button: &str) {
    press_button(bench, button);
    ready(bench);
    discard(bench);
}

fn discard(bench: &mut Bench) {
    let is_asked = bench.query_by_role_and_label(Role::Button, "Don’t save").is_some();
    if is_asked {
        press_button(bench, "Don’t save");
        ready(bench);
    }
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
    assert!(is_said(&bench, "There the boundary of a part is none of the whole."));
    assert!(bench.query_by_role_and_label(Role::Button, "Next step").is_some(), "there is nothing left to skip");
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
fn unsaved_changes_are_asked_about_before_a_step_opens_its_scene() {
    let mut bench = open_bowl();
    let mine = editing::text(&bench).replacen("\"field_of_view\": 31", "\"field_of_view\": 36", 1);
    write_scene(&mut bench, &mine);
    press_button(&mut bench, "Next step");
    ready(&mut bench);
    press_button(&mut bench, "Cancel");
    ready(&mut bench);
    assert_eq!((step_of(&bench), editing::text(&bench)), (1, mine));
    press_button(&mut bench, "Back to this step’s ray");
    press_button(&mut bench, "Don’t save");
    ready(&mut bench);
    assert!(editing::text(&bench).contains("\"field_of_view\": 31"));
    assert_eq!(pixel(&bench), [333, 150]);
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
