//! Changes of the scene that a lesson asks for: the edited scene is judged in the background, whenever it follows its text.

use super::open::Judging;
use super::question::Asked;
use crate::app::frame::background::Background;
use crate::app::frame::words::{say, say_with};
use crate::app::workbench::Workbench;
use crate::lesson::question::Form;
use crate::lesson::{Stage, Verdict};
use crate::scene::Scene;
use egui::Context;
use std::sync::Arc;

impl Workbench {
    /// Once a frame: takes in what came of an edited scene, and judges the next one.
    pub(super) fn follow_answers(&mut self, ctx: &Context) {
        self.receive_verdict(ctx);
        let Some(open) = &self.lesson.open else { return };
        let Some(scene) = self.open.as_ref().map(|open| Arc::clone(&open.scene)) else { return };
        let Some(staged) = open.staged().filter(|_| open.judging.is_none()) else { return };
        let is_edited = !Arc::ptr_eq(&staged.stage.scene.scene, &scene) && self.editing.name == staged.scene_name;
        let is_judged = open.judged.as_ref().is_some_and(|judged| Arc::ptr_eq(judged, &scene));
        let is_open = |asked: &Asked| matches!(asked.posed.form, Form::Edit(_)) && !asked.is_done();
        let question = open.asked.iter().position(is_open);
        if let Some(question) = question.filter(|_| is_edited && !is_judged && !self.editing.is_stale()) {
            self.begin_judging(ctx, question, false);
        }
    }

    pub(super) fn begin_judging(&mut self, ctx: &Context, question: usize, is_asked_for: bool) {
        if !self.editing.flaws.is_empty() {
            let problem = say(ctx, "lesson-scene-flawed");
            self.change_question(question, |asked| asked.refuse(problem));
            return;
        }
        let text = self.editing.document.text().to_owned();
        let Some(scene) = self.open.as_ref().map(|open| Arc::clone(&open.scene)) else { return };
        let Some(open) = &mut self.lesson.open else { return };
        let (Some(staged), Some(asked)) = (open.staged(), open.asked.get(question)) else { return };
        let (stage, posed, edited): (Stage, _, Scene) =
            (staged.stage.clone(), asked.posed.clone(), Scene::clone(&scene));
        let job = Background::start(ctx, "judge", move |_, publish| {
            let stage = stage.edited(text, edited);
            publish(stage.and_then(|stage| posed.judge_edit(&stage).map_err(|error| error.message)));
        });
        open.judged = Some(scene);
        open.judging = job.map(|job| Judging { question, is_asked_for, job });
    }

    fn receive_verdict(&mut self, ctx: &Context) {
        let Some(open) = &mut self.lesson.open else { return };
        let Some(judging) = open.judging.take_if(|judging| judging.job.is_finished()) else { return };
        match judging.job.take() {
            Some(Ok(verdict)) => self.take_verdict(judging.question, verdict, judging.is_asked_for),
            Some(Err(why)) if judging.is_asked_for => {
                let problem = say_with(ctx, "lesson-not-judged", &[("why", (&why).into())]);
                self.change_question(judging.question, |asked| asked.refuse(problem));
            }
            _ => {}
        }
    }

    /// While the scene is being changed, only what is right and what was expected is told: the rest is on its way.
    fn take_verdict(&mut self, question: usize, verdict: Verdict, is_asked_for: bool) {
        if is_asked_for || verdict.is_right {
            self.change_question(question, |asked| asked.take(verdict, None));
        } else if verdict.misconception.is_some() {
            self.change_question(question, |asked| asked.say(verdict));
        }
    }
}
