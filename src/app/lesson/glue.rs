//! What lessons and the rest of the workbench do to each other.

use super::open::OpenLesson;
use super::pane::{LessonPane, Wish};
use super::question::{QuestionWish, Seen};
use super::staged::Staged;
use super::text::TextWish;
use crate::app::dock::Preset;
use crate::app::edit::dialog::Then;
use crate::app::frame::words::say;
use crate::app::pane::Pane;
use crate::app::story::recording::Recording;
use crate::app::workbench::{Look, OpenScene, Workbench};
use crate::lesson::model::At;
use crate::lesson_folder::Lessons;
use crate::scene::Profile;
use egui::{Context, Ui};
use std::sync::Arc;

impl Workbench {
    /// The panel of lessons.
    #[must_use]
    pub const fn lesson(&self) -> &LessonPane {
        &self.lesson
    }

    /// The same, for what a student has done.
    pub const fn lesson_mut(&mut self) -> &mut LessonPane {
        &mut self.lesson
    }

    /// Takes these lessons in place of those that come with the program, and opens the one that was asked for.
    pub fn use_lessons(&mut self, lessons: Lessons) {
        let chosen = lessons.chosen.clone();
        self.lesson.take_lessons(lessons);
        self.show_lessons();
        if let Some(id) = chosen {
            self.open_lesson(&id);
        }
    }

    /// Opens a lesson where it was left.
    pub fn open_lesson(&mut self, id: &str) {
        let ctx = self.ctx();
        self.lesson.open_lesson(&ctx, id, None);
        self.show_lessons();
    }

    /// Opens a lesson at a step, counted from 0.
    pub fn open_lesson_at(&mut self, id: &str, step: usize) {
        let ctx = self.ctx();
        self.lesson.open_lesson(&ctx, id, Some(step));
        self.show_lessons();
    }

    /// Goes to a step of the lesson, counted from 0.
    pub fn go_to_step(&mut self, step: usize) {
        let ctx = self.ctx();
        self.lesson.go_to(&ctx, step);
    }

    /// Brings the lesson to the front. In a room full of people the layout stays; elsewhere lessons have one of their own.
    pub(in crate::app) fn show_lessons(&mut self) {
        if self.dock.preset() != Preset::Present {
            self.dock.choose(Preset::Lesson);
        }
        self.dock.reveal(Pane::Lesson);
    }

    /// Shows the course, whatever lesson is open.
    pub(in crate::app) fn show_course(&mut self) {
        self.lesson.close();
        self.dock.reveal(Pane::Lesson);
    }

    /// Once a frame: takes in what was set up and judged.
    pub(in crate::app) fn follow_lesson(&mut self, ctx: &Context) {
        if self.lesson.follow(ctx) {
            self.give_up_trials();
            self.set_stage(ctx);
        }
        self.follow_answers(ctx);
        self.show_after();
    }

    /// Shows the panel and does what is asked for in it.
    pub(in crate::app) fn lesson_pane(&mut self, ui: &mut Ui) {
        let seen = self.seen_by_lesson();
        let wish = self.lesson.ui(ui, &seen);
        if let Some(wish) = wish {
            self.grant_lesson(ui.ctx(), wish);
        }
    }

    fn grant_lesson(&mut self, ctx: &Context, wish: Wish) {
        match wish {
            Wish::Open(id) | Wish::Text(TextWish::Lesson(id)) => self.open_lesson(&id),
            Wish::List => self.lesson.close(),
            Wish::Step(step) => self.go_to_step(step),
            Wish::Finish => {
                // Or it would be offered back when the program is killed later on, whatever is open then.
                self.give_up_trials();
                self.lesson.finish();
            }
            Wish::Restage => self.back_to_ray(ctx),
            Wish::StartAgain => self.start_again(ctx),
            Wish::Text(TextWish::Select(event)) => {
                if !self.seen_by_lesson().is_staged {
                    self.set_stage(ctx);
                }
                if self.seen_by_lesson().is_staged {
                    self.select(event);
                }
            }
            Wish::Text(TextWish::Source(file)) => ctx.copy_text(file),
            Wish::Text(TextWish::Term(_)) => {}
            Wish::Question(_, QuestionWish::Show(pane)) => self.dock.show_beside(&[pane], Pane::Lesson),
            Wish::Question(place, wish) => self.grant_question(ctx, place, wish),
        }
    }

    /// What is to be seen elsewhere, as far as a lesson asks about it.
    pub(super) fn seen_by_lesson(&self) -> Seen {
        let staged = self.lesson.open.as_ref().and_then(OpenLesson::staged);
        let recording = self.recording.as_ref();
        let is_staged = staged.zip(recording).is_some_and(|(staged, seen)| Arc::ptr_eq(&staged.stage.tree, &seen.tree));
        let is_judging = self.lesson.open.as_ref().is_some_and(|open| open.judging.is_some());
        let is_compiling = self.editing.is_stale() && self.editing.flaws.is_empty();
        // The pixel of the step's own ray was chosen by nobody.
        let chosen = recording.filter(|recording| !is_staged && self.is_of_the_step(recording));
        Seen {
            probe_t: recording.filter(|_| is_staged).and_then(|recording| recording.probe_t),
            pixel: chosen.map(|recording| recording.pixel),
            event: recording.filter(|_| is_staged).map(Recording::selected),
            is_staged,
            is_tried: self.is_tried(),
            is_aimed: self.is_aimed(),
            is_busy: is_judging || is_compiling,
        }
    }

    /// Whether something was recorded in the scene of the step, as it stands.
    pub(super) fn is_of_the_step(&self, recording: &Recording) -> bool {
        let staged = self.lesson.open.as_ref().and_then(OpenLesson::staged);
        staged.is_some_and(|staged| Arc::ptr_eq(&staged.stage.scene.scene, &recording.scene))
    }

    /// Sets the stage: the step's scene, its ray, its event, what is told, and the drawings. If there are unsaved changes, it is
    /// asked first.
    pub(in crate::app) fn set_stage(&mut self, ctx: &Context) {
        let mut lesson = std::mem::take(&mut self.lesson);
        if let Some(staged) = lesson.open.as_ref().and_then(OpenLesson::staged)
            && self.set_scene(ctx, staged)
        {
            let asks = lesson.open.as_ref().is_some_and(OpenLesson::asks_of_the_story);
            self.set_ray(staged, asks);
            // The text tells of the story, whatever was looked at before.
            self.dock.uncover(Pane::Story, Pane::Lesson);
            self.dock.show_beside(&staged.views, Pane::Lesson);
            if let Some(open) = &mut lesson.open {
                open.judged = None;
            }
        }
        self.lesson = lesson;
        if let Some(link) = self.sharing.after_stage.take() {
            self.restore(ctx, &link);
        }
    }

    /// Opens the step's scene unless it is open; returns whether it is.
    fn set_scene(&mut self, ctx: &Context, staged: &Staged) -> bool {
        let compiled = &staged.stage.scene;
        let is_text = self.editing.document.text() == compiled.text && self.editing.name == staged.scene_name;
        let is_whole = self.open.as_ref().is_some_and(|open| Arc::ptr_eq(&open.whole, &staged.whole));
        let is_open = is_text && is_whole;
        if !is_open && !self.may_give_up(|| Then::Lesson) {
            return false;
        }
        self.give_up_opening();
        let look = staged.stage.aim.accuracy.map(|profile| Look { name: name_of(ctx, &profile), profile });
        let is_seen = self.open.as_ref().is_some_and(|open| Arc::ptr_eq(&open.scene, &compiled.scene));
        if is_open && is_seen {
            return true;
        }
        if !is_open {
            self.problem = None;
            self.image.reset();
            self.side.fit();
            self.editing.open(&staged.scene_name, &compiled.text);
            self.editing.is_staged = true;
        }
        self.effects.reset();
        self.accuracy.reset();
        self.renderer.start(ctx, &compiled.scene);
        let (scene, whole) = (Arc::clone(&compiled.scene), Arc::clone(&staged.whole));
        self.open = Some(OpenScene { name: staged.scene_name.clone(), scene, whole, look });
        true
    }

    /// Shows the step's ray; `asks` says whether the story's rows would tell an answer.
    fn set_ray(&mut self, staged: &Staged, asks: bool) {
        let stage = &staged.stage;
        let image = stage.scene.scene.image;
        let pixel = match stage.aim.at {
            Some(At::Pixel(pixel)) => pixel,
            _ => [image.width / 2, image.height / 2],
        };
        let mut recording = Recording::of_tree(Arc::clone(&stage.scene.scene), pixel, Arc::clone(&stage.tree), None);
        recording.probe_t = staged.t;
        recording.marked.clone_from(&staged.marked);
        // A step without an event of its own is about the whole story.
        recording.veil = (asks && stage.event > 0).then_some(stage.event);
        self.set_level(staged.level);
        self.show_elsewhere(recording);
        self.select(stage.event);
    }

    /// Opens the drawings that would have given the answers away, once there is nothing more to answer.
    fn show_after(&mut self) {
        let Some(open) = self.lesson.open.as_mut().filter(|open| !open.is_after && open.is_done()) else { return };
        let Some(after) = open.staged().map(|staged| staged.after.clone()) else { return };
        open.is_after = true;
        if let Some(recording) = self.recording.as_mut() {
            recording.veil = None;
        }
        self.dock.show_beside(&after, Pane::Lesson);
    }
}

/// An accuracy in words: its name, where it has one.
fn name_of(ctx: &Context, profile: &Profile) -> String {
    let named = Profile::NAMED.iter().find(|(_, known)| known == profile);
    named.map_or_else(|| say(ctx, "lesson-accuracy"), |(name, _)| (*name).to_owned())
}
