//! Somebody who goes through lessons, and answers their questions in every way that they expect.

use super::{is_said, open_lessons, press_button, ready, step_of, write_scene};
use crate::hands::*;
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Vec2};
use egui_kittest::kittest::Queryable;
use rayscope::lesson::model::{Change, Part, Step, Surface};
use rayscope::lesson::prose::{Block, Inline, Line, Prose, Told, plain};
use rayscope::lesson::question::{Form, Spot, Stretch};
use rayscope::lesson::{Lesson, Posed, Scenes, Stage};
use rayscope::lesson_folder::Lessons;
use rayscope::record::format_number;

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

pub fn changed(text: &str, changes: &[Change]) -> String {
    rayscope::lesson::changed(text, changes).expect("the check has made this change")
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
        let Some(because) = because else {
            // The questions before it are answered already.
            let answered = self.bench.query_all_by_label_contains("✓ answered").count();
            assert_eq!(answered, number, "{at}: the right answer is refused");
            return;
        };
        assert!(is_said(self.bench, "✗ Not right."), "{at}: a wrong answer is taken");
        if let Some(words) = words_of(because) {
            assert!(is_said(self.bench, &words), "{at}: `{words}` is not said");
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
        now: &mut [usize],
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

fn all_lessons() -> Lessons {
    match std::env::var("RAYSCOPE_LESSONS") {
        Ok(folder) => Lessons::named(&folder).expect("there are lessons"),
        Err(_) => Lessons::embedded(),
    }
}

/// The questions of a step, as the workbench poses them.
pub fn posed_in(lesson: &Lesson, step: &Step, lessons: &Lessons, scenes: &Scenes) -> (Stage, Vec<Posed>) {
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
pub fn walk(part: usize, of: usize) {
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
pub fn go_on(bench: &mut Bench, button: &str) {
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
