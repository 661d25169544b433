//! The panel of lessons: the course, or the lesson that is open.

use super::open::OpenLesson;
use super::progress_file::{self, Exchange};
use super::question::{QuestionWish, Seen};
use super::staged::School;
use super::text::{Formulas, TextWish};
use super::watch::{Changed, Watch};
use super::{course_list, course_map, onward, step};
use crate::app::frame::background::Background;
use crate::app::frame::file_dialog::FileDialog;
use crate::app::frame::words::{say, say_with};
use crate::app::system::Picked;
use crate::lesson::{Finding, Progress};
use crate::lesson_folder::Lessons;
use egui::{Context, Ui};
use std::path::Path;
use std::sync::Arc;

/// The state of the panel.
#[derive(Default)]
pub struct LessonPane {
    pub(super) school: Option<School>,
    pub(in crate::app) open: Option<OpenLesson>,
    /// What a student has done.
    pub progress: Progress,
    pub(super) formulas: Formulas,
    /// The term whose meaning is shown.
    pub(super) term: Option<String>,
    /// Whether the course is shown as a map.
    pub(super) is_map: bool,
    /// Whether it is being asked if everything that was done is to be forgotten.
    pub(super) is_resetting: bool,
    /// The lesson that was ended just now.
    pub(super) ended: Option<String>,
    /// Whether the list has yet to be scrolled to the lesson that comes next.
    pub(super) is_moving_on: bool,
    /// What is told about a file that was written or read.
    pub(super) notice: Option<String>,
    /// What is wrong with a lesson that was saved.
    pub(super) unread: Option<String>,
    loading: Option<Background<School>>,
    /// The lesson that is opened as soon as the course is read.
    wanted: Option<(String, Option<usize>)>,
    watch: Option<Watch>,
    exchange: Option<Background<Exchange>>,
    dialog: FileDialog,
}

/// What is asked of the rest of the workbench.
#[derive(Clone, Debug, PartialEq)]
pub enum Wish {
    /// A lesson.
    Open(String),
    /// The course.
    List,
    /// A step of the lesson.
    Step(usize),
    /// To end the lesson.
    Finish,
    /// The ray of the step, and its scene where no change was asked for.
    Restage,
    /// The scene of the step as the step found it.
    StartAgain,
    /// What was clicked in a text.
    Text(TextWish),
    /// What is to be done about a question, by its place in the step.
    Question(usize, QuestionWish),
}

impl LessonPane {
    /// Shows the panel.
    pub fn ui(&mut self, ui: &mut Ui, seen: &Seen) -> Option<Wish> {
        if self.open.is_some() {
            return step::ui(ui, self, seen);
        }
        let onward = onward::ui(ui, self);
        let chosen = if self.is_map { course_map::ui(ui, self) } else { course_list::ui(ui, self) };
        onward.or(chosen)
    }

    /// Takes these lessons in place of the ones before.
    pub(super) fn take_lessons(&mut self, lessons: Lessons) {
        (self.open, self.watch, self.loading, self.unread) = (None, None, None, None);
        self.school = Some(School::new(lessons));
    }

    /// Opens a lesson at a step, or where it was left; waits for the course if that is not read yet.
    pub(super) fn open_lesson(&mut self, ctx: &Context, id: &str, step: Option<usize>) {
        let Some(school) = &self.school else {
            self.wanted = Some((id.to_owned(), step));
            return;
        };
        let kept = self.progress.lessons.get(id);
        // What was finished begins anew.
        let left = kept.filter(|kept| !kept.finished).map_or(0, |kept| kept.step);
        let step = step.unwrap_or(left);
        self.open = OpenLesson::new(ctx, school, id, step).or(self.open.take());
        self.ended = None;
        self.term = None;
        self.unread = None;
        self.watch = school.lessons.shelf.file(id).map(|file| Watch::start(ctx, &file));
    }

    /// Goes to a step of the lesson.
    pub(super) fn go_to(&mut self, ctx: &Context, step: usize) {
        if let (Some(open), Some(school)) = (&mut self.open, &self.school) {
            open.go_to(ctx, school, step);
            self.term = None;
        }
    }

    /// Shows the course again.
    pub(super) fn close(&mut self) {
        (self.open, self.watch, self.unread) = (None, None, None);
    }

    /// Ends the lesson.
    pub(super) fn finish(&mut self) {
        if let Some(open) = &self.open {
            self.progress.of(&open.id).finished = true;
            self.ended = Some(open.id.clone());
            self.is_moving_on = true;
        }
        self.close();
    }

    /// Forgets everything that was done.
    pub(super) fn reset(&mut self, ctx: &Context) {
        self.progress = Progress::default();
        self.is_resetting = false;
        if let Some(step) = self.open.as_ref().map(|open| open.step) {
            self.go_to(ctx, step);
        }
    }

    /// Once a frame: takes in what was done in the background; returns whether a step was set up.
    pub(super) fn follow(&mut self, ctx: &Context) -> bool {
        self.load(ctx);
        if let Some(changed) = self.watch.as_ref().and_then(Watch::take) {
            self.reload(ctx, changed);
        }
        if let Some(exchange) = self.exchange.as_ref().and_then(Background::take) {
            self.exchange = None;
            self.take_exchange(ctx, exchange);
        }
        if let Some(picked) = self.dialog.chosen() {
            self.take_exchange(ctx, progress_file::read(&picked));
        }
        self.open.as_mut().is_some_and(|open| open.receive(&mut self.progress))
    }

    fn load(&mut self, ctx: &Context) {
        if self.school.is_some() {
            return;
        }
        let begin = || Background::start(ctx, "lessons", |_, publish| publish(School::embedded()));
        if self.loading.is_none() {
            self.loading = begin();
        }
        self.school = self.loading.as_ref().and_then(Background::take);
        if self.school.is_some() {
            self.loading = None;
            if let Some((id, step)) = self.wanted.take() {
                self.open_lesson(ctx, &id, step);
            }
        }
    }

    fn reload(&mut self, ctx: &Context, changed: Changed) {
        let lessons = match changed.lessons {
            Ok(lessons) => lessons,
            Err(why) => {
                self.unread = Some(why);
                return;
            }
        };
        self.unread = None;
        let scenes = self.school.as_ref().filter(|_| changed.is_text_alone).map(|school| Arc::clone(&school.scenes));
        self.school = Some(School { lessons: Arc::new(lessons), scenes: scenes.unwrap_or_default() });
        if let Some(step) = self.open.as_ref().map(|open| open.step) {
            self.go_to(ctx, step);
        }
    }

    /// What is wrong with the lesson that is open: what was found when it was read, and when its step was set up.
    pub(super) fn findings(&self) -> Vec<&Finding> {
        let (Some(open), Some(school)) = (&self.open, &self.school) else { return Vec::new() };
        let course = &school.lessons.course;
        let file = course.lesson(&open.id).map(|lesson| lesson.file.as_str());
        let mut findings: Vec<&Finding> =
            course.findings.iter().filter(|finding| Some(finding.file.as_str()) == file || file.is_none()).collect();
        match &open.outcome {
            Some(Ok(staged)) => findings.extend(&staged.findings),
            Some(Err(finding)) => findings.push(finding),
            None => {}
        }
        findings
    }

    /// Asks for a file to write what was done to.
    pub fn export(&mut self, ctx: &Context) {
        self.exchange = progress_file::export(ctx, &self.progress);
    }

    /// Asks for a file to read what was done from.
    pub fn import(&mut self, ctx: &Context) {
        self.dialog.open_for(ctx, say(ctx, "lesson-import"), "JSON".to_owned(), &["json"]);
    }

    /// Writes what was done to a file.
    pub fn write_progress(&mut self, ctx: &Context, path: &Path) {
        self.take_exchange(ctx, progress_file::write(path, &self.progress.to_json()));
    }

    /// Reads what was done from a file.
    pub fn read_progress(&mut self, ctx: &Context, path: &Path) {
        let picked = Picked { name: path.display().to_string(), text: None };
        self.take_exchange(ctx, progress_file::read(&picked));
    }

    fn take_exchange(&mut self, ctx: &Context, exchange: Exchange) {
        self.notice = match exchange {
            Exchange::Written(path) => {
                let path = path.display().to_string();
                Some(say_with(ctx, "lesson-exported", &[("path", (&path).into())]))
            }
            Exchange::Read(progress) => {
                self.progress = progress;
                if let Some(step) = self.open.as_ref().map(|open| open.step) {
                    self.go_to(ctx, step);
                }
                Some(say(ctx, "lesson-imported"))
            }
            Exchange::Given => None,
            Exchange::Failed(why) => Some(why),
        };
    }

    /// The lesson that is open and its step, counted from 0.
    #[must_use]
    pub fn place(&self) -> Option<(&str, usize)> {
        self.open.as_ref().map(|open| (open.id.as_str(), open.step))
    }

    /// How many questions its step asks.
    #[must_use]
    pub fn questions(&self) -> usize {
        self.open.as_ref().map_or(0, |open| open.asked.len())
    }

    /// How many steps the lesson has that is open.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.open.as_ref().map_or(0, |open| open.steps)
    }

    /// Asks whether everything that was done is to be forgotten.
    pub const fn ask_to_reset(&mut self) {
        self.is_resetting = true;
    }

    /// Whether the course is being read, a step set up, or an answer judged.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.loading.is_some() || self.open.as_ref().is_some_and(OpenLesson::is_busy)
    }

    /// The lessons, once they are read.
    #[must_use]
    pub fn lessons(&self) -> Option<&Arc<Lessons>> {
        self.school.as_ref().map(|school| &school.lessons)
    }
}
