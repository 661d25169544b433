//! Answers: what was typed and chosen, where it was clicked, what was changed in the scene.

use super::marks::within;
use super::open::OpenLesson;
use super::question::{Asked, Draft, QuestionWish};
use crate::app::frame::words::{say, say_with};
use crate::app::pane::Pane;
use crate::app::workbench::Workbench;
use crate::document::Cause;
use crate::lesson::Answer;
use crate::lesson::model::Surface;
use crate::lesson::question::{Form, Spot, offered_lists};
use crate::record::What;
use egui::{Context, Pos2};
use glam::DVec3;

/// A place that is shown where a question asks for one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// Where, in the coordinates of a click there.
    pub at: [f64; 2],
    /// Whether it is the right one.
    pub is_right: bool,
}

impl Workbench {
    pub(super) fn grant_question(&mut self, ctx: &Context, place: usize, wish: QuestionWish) {
        match wish {
            QuestionWish::Check => self.check(ctx, place),
            QuestionWish::Hint => self.change_question(place, Asked::hint),
            QuestionWish::Reveal => self.reveal_answer(ctx, place),
            QuestionWish::Arm(is_armed) => self.arm(place, is_armed),
            QuestionWish::TakePlace(surface) => self.take_place(place, surface),
            QuestionWish::Probe(t) => self.recording.iter_mut().for_each(|recording| recording.probe_t = Some(t)),
            QuestionWish::Show(pane) => self.dock.show_beside(&[pane], Pane::Lesson),
        }
    }

    /// The question that is to be answered next, by its place in the step.
    pub(in crate::app) fn current_question(&self) -> Option<usize> {
        self.lesson.open.as_ref()?.current()
    }

    /// Changes what is known of a question, and keeps it.
    pub(super) fn change_question(&mut self, place: usize, change: impl FnOnce(&mut Asked)) {
        let Some(open) = &mut self.lesson.open else { return };
        if let Some(asked) = open.asked.get_mut(place) {
            change(asked);
        }
        open.note(&mut self.lesson.progress, place);
    }

    fn asked(&self, place: usize) -> Option<&Asked> {
        self.lesson.open.as_ref()?.asked.get(place)
    }

    /// Judges the answer to a question.
    pub(in crate::app) fn check(&mut self, ctx: &Context, place: usize) {
        let seen = self.seen_by_lesson();
        let Some(asked) = self.asked(place) else { return };
        if matches!(asked.posed.form, Form::Edit(_)) {
            self.begin_judging(ctx, place, true);
            return;
        }
        match asked.answer(&seen) {
            Ok(Some(answer)) => {
                let verdict = asked.posed.judge(&answer);
                self.change_question(place, |asked| asked.take(verdict, Some(answer)));
            }
            Ok(None) => {}
            Err(why) => {
                let problem = say_with(ctx, "lesson-no-number", &[("why", (&why).into())]);
                self.change_question(place, |asked| asked.refuse(problem));
            }
        }
    }

    /// Answers a question of the step by a number: of what is asked for, or of a choice or interval list, counted from 0. What makes
    /// no sense as an answer is passed over.
    pub fn answer_by_number(&mut self, question: usize, value: f64) {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a place among a few choices")]
        let place = value as usize;
        let answer = self.asked(question).and_then(|asked| match &asked.posed.form {
            Form::Number(_) | Form::Time(_) => Some(Answer::Number(value)),
            Form::Choice(choices) => (place < choices.len()).then_some(Answer::Choice(place)),
            Form::Intervals(reckoned) => {
                offered_lists(reckoned).get(place).map(|list| Answer::Intervals((*list).clone()))
            }
            _ => None,
        });
        self.answer_with(question, answer);
    }

    /// Answers a question of the step by an order: the numbers of its items, counted from 0.
    pub fn answer_by_order(&mut self, question: usize, order: &[usize]) {
        let fits = |asked: &Asked| {
            matches!(&asked.posed.form, Form::Order { right, .. } if {
                let (mut given, mut items) = (order.to_vec(), right.clone());
                given.sort_unstable();
                items.sort_unstable();
                given == items
            })
        };
        let answer = self.asked(question).filter(|asked| fits(asked)).map(|_| Answer::Order(order.to_vec()));
        self.answer_with(question, answer);
    }

    fn answer_with(&mut self, question: usize, answer: Option<Answer>) {
        let Some(answer) = answer else { return };
        self.change_question(question, |asked| {
            let verdict = asked.posed.judge(&answer);
            asked.fill_in(&answer);
            asked.take(verdict, Some(answer));
        });
    }

    /// Shows a hint more.
    pub(in crate::app) fn hint(&mut self, place: usize) {
        self.change_question(place, Asked::hint);
    }

    /// Shows the answer: puts it in, or makes the change in the scene.
    pub(in crate::app) fn reveal_answer(&mut self, ctx: &Context, place: usize) {
        self.change_question(place, Asked::reveal);
        let Some(asked) = self.asked(place) else { return };
        match &asked.posed.form {
            Form::Time(reckoned) => {
                let t = reckoned.answer;
                if let Some(recording) = &mut self.recording {
                    recording.probe_t = Some(t);
                }
                self.dock.show_beside(&[Pane::Signs], Pane::Lesson);
            }
            Form::Edit(edit) => {
                let changes: Vec<_> =
                    edit.edit.solution.iter().map(|change| (change.at.clone(), change.to.clone())).collect();
                self.editing.set(&changes, &Cause::new(say(ctx, "lesson-reveal")));
                self.dock.show_beside(&[Pane::Editor], Pane::Lesson);
            }
            Form::Place(surface, _) => {
                let pane = pane_of(*surface);
                self.dock.show_beside(&[pane], Pane::Lesson);
            }
            _ => {}
        }
    }

    fn arm(&mut self, place: usize, is_armed: bool) {
        if is_armed && !self.seen_by_lesson().is_staged {
            let ctx = self.ctx();
            self.set_stage(&ctx);
        }
        let Some(open) = &mut self.lesson.open else { return };
        let mut surface = None;
        for (other, asked) in open.asked.iter_mut().enumerate() {
            if let (Form::Place(of, _), Draft::Place { is_armed: state, .. }) = (&asked.posed.form, &mut asked.draft) {
                *state = is_armed && other == place;
                surface = surface.or((other == place).then_some(*of));
            }
        }
        if let Some(surface) = surface.filter(|_| is_armed) {
            self.dock.show_beside(&[pane_of(surface)], Pane::Lesson);
        }
    }

    /// The question that the next click there answers, by its place in the step.
    pub(in crate::app) fn awaits_click(&self, surface: Surface) -> Option<usize> {
        let open = self.lesson.open.as_ref()?;
        let is_meant = |asked: &Asked| {
            matches!(asked.draft, Draft::Place { is_armed: true, .. })
                && matches!(asked.posed.form, Form::Place(of, _) if of == surface)
        };
        open.asked.iter().position(is_meant)
    }

    /// Answers a question by a place: in the picture in its pixels, in the side view in points of the drawing.
    pub(in crate::app) fn answer_click(&mut self, question: usize, surface: Surface, click: [f64; 2]) {
        let Some(asked) = self.asked(question) else { return };
        let verdict = asked.posed.judge_click(click, |spot| self.spot(surface, spot));
        self.change_question(question, |asked| {
            asked.draft = Draft::Place { is_armed: false, at: Some(click) };
            asked.take(verdict, None);
        });
    }

    /// Where a point of the world is on screen in the side view.
    #[must_use]
    pub fn side_place(&self, point: [f64; 3]) -> Option<Pos2> {
        let (rect, plane) = self.side.plane()?;
        Some(within(rect, plane.spot(DVec3::from_array(point))))
    }

    /// Where a place lies, in the coordinates of a click there.
    fn spot(&self, surface: Surface, spot: &Spot) -> Option<[f64; 2]> {
        let staged = self.lesson.open.as_ref().and_then(OpenLesson::staged)?;
        match (surface, spot) {
            // The middle of the pixel.
            (Surface::Image, Spot::Pixel(pixel)) => Some(pixel.map(|place| place + 0.5)),
            (Surface::Image, Spot::World(point)) => {
                let scene = &staged.stage.scene.scene;
                scene.camera.project(scene.image, DVec3::from_array(*point))
            }
            (Surface::Side, Spot::World(point)) => {
                self.side.plane().map(|(_, plane)| plane.spot(DVec3::from_array(*point)))
            }
            (Surface::Side, Spot::Pixel(_)) => None,
        }
    }

    /// Answers by what is recorded and selected, without a pointer.
    fn take_place(&mut self, question: usize, surface: Surface) {
        let Some(recording) = &self.recording else { return };
        let click = match surface {
            Surface::Image => Some(recording.pixel.map(|place| f64::from(place) + 0.5)),
            Surface::Side => match &recording.tree.event(recording.selected()).what {
                What::Hit { point, .. } => self.spot(surface, &Spot::World(*point)),
                _ => None,
            },
        };
        if let Some(click) = click {
            self.answer_click(question, surface, click);
        } else {
            let problem = say(&self.ctx(), "lesson-no-place");
            self.change_question(question, |asked| asked.refuse(problem));
        }
    }

    /// What is marked where questions ask for places: the last click, and the right place once it is known.
    pub(in crate::app) fn lesson_marks(&self, surface: Surface) -> Vec<Mark> {
        let mut marks = Vec::new();
        let is_seen = match surface {
            // A place in the picture stays where it is, whatever pixel is recorded.
            Surface::Image => self.recording.as_ref().is_some_and(|recording| self.is_of_the_step(recording)),
            Surface::Side => self.seen_by_lesson().is_staged,
        };
        let Some(open) = self.lesson.open.as_ref().filter(|_| is_seen) else { return marks };
        for asked in &open.asked {
            let (Form::Place(of, reckoned), Draft::Place { at, .. }) = (&asked.posed.form, &asked.draft) else {
                continue;
            };
            if *of != surface {
                continue;
            }
            marks.extend(at.map(|at| Mark { at, is_right: false }));
            if asked.is_done() {
                marks.extend(self.spot(surface, &reckoned.answer).map(|at| Mark { at, is_right: true }));
            }
        }
        marks
    }
}

const fn pane_of(surface: Surface) -> Pane {
    match surface {
        Surface::Image => Pane::Picture,
        Surface::Side => Pane::Side,
    }
}
