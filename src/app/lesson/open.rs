//! The lesson that is open: where one stands, what is asked there, and what was said about it.

use super::question::Asked;
use super::staged::{Outcome, School, Staged};
use crate::app::frame::background::Background;
use crate::lesson::question::Form;
use crate::lesson::{Progress, Record, Verdict};
use crate::scene::Scene;
use egui::Context;
use std::sync::Arc;

/// A lesson that is open.
pub struct OpenLesson {
    /// Its name.
    pub id: String,
    /// The step, counted from 0.
    pub step: usize,
    /// How many there are.
    pub steps: usize,
    /// The step as it is shown; none until it is set up for the first time.
    pub outcome: Option<Outcome>,
    /// Its questions.
    pub asked: Vec<Asked>,
    /// Whether the drawings are open that would have given the answers away.
    pub is_after: bool,
    /// An edited scene that is being judged.
    pub judging: Option<Judging>,
    /// The edited scene that was judged last.
    pub judged: Option<Arc<Scene>>,
    job: Option<Background<Outcome>>,
}

/// A question about an edited scene, in the background.
pub struct Judging {
    /// The question, by its place in the step.
    pub question: usize,
    /// Whether somebody asked for it; otherwise only what is right, or an expected mistake, is told.
    pub is_asked_for: bool,
    /// What comes of it.
    pub job: Background<Result<Verdict, String>>,
}

impl OpenLesson {
    /// A lesson at one of its steps.
    pub fn new(ctx: &Context, school: &School, id: &str, step: usize) -> Option<Self> {
        let steps = school.lessons.course.lesson(id)?.steps.len();
        let mut open = Self {
            id: id.to_owned(),
            step: 0,
            steps,
            outcome: None,
            asked: Vec::new(),
            is_after: false,
            judging: None,
            judged: None,
            job: None,
        };
        open.go_to(ctx, school, step);
        Some(open)
    }

    /// Goes to a step; it is shown as soon as it is set up.
    pub fn go_to(&mut self, ctx: &Context, school: &School, step: usize) {
        // While its file is broken, the lesson is shown as it was.
        let Some(lesson) = school.lessons.course.lesson(&self.id) else { return };
        self.steps = lesson.steps.len();
        self.step = step.min(self.steps.saturating_sub(1));
        self.judging = None;
        self.judged = None;
        self.job = school.begin(ctx, &self.id, self.step);
    }

    /// Whether a step is being set up or an answer being judged.
    pub const fn is_busy(&self) -> bool {
        self.job.is_some() || self.judging.is_some()
    }

    /// Takes in a step that was set up; returns whether there was one.
    pub fn receive(&mut self, progress: &mut Progress) -> bool {
        let Some(job) = &self.job else { return false };
        let Some(mut outcome) = job.take() else {
            if job.is_finished() {
                self.job = None;
            }
            return false;
        };
        self.job = None;
        self.asked.clear();
        self.is_after = false;
        if let Ok(staged) = &mut outcome {
            let kept = progress.of(&self.id);
            kept.step = self.step;
            kept.furthest = kept.furthest.max(self.step);
            let record = |number| kept.answers.get(&number).cloned().unwrap_or_default();
            self.asked = std::mem::take(&mut staged.posed)
                .into_iter()
                .map(|(number, posed)| Asked::new(number, posed, record(number)))
                .collect();
        }
        self.outcome = Some(outcome);
        true
    }

    /// The step as it is shown.
    pub fn staged(&self) -> Option<&Staged> {
        self.outcome.as_ref()?.as_ref().ok().map(|staged| &**staged)
    }

    /// Whether nothing more is asked in this step.
    pub fn is_done(&self) -> bool {
        self.asked.iter().all(Asked::is_done)
    }

    /// Whether something is still asked that the story's rows would tell; of a change to the scene they tell nothing yet.
    pub fn asks_of_the_story(&self) -> bool {
        self.asked.iter().any(|asked| !asked.is_done() && !matches!(asked.posed.form, Form::Edit(_)))
    }

    /// The first question that is not answered yet, by its place in the step.
    pub fn current(&self) -> Option<usize> {
        self.asked.iter().position(|asked| !asked.is_done())
    }

    /// Notes what was done about a question.
    pub fn note(&self, progress: &mut Progress, question: usize) {
        if let Some(Asked { number, record, .. }) = self.asked.get(question) {
            let record: Record = record.clone();
            progress.of(&self.id).answers.insert(*number, record);
        }
    }
}
