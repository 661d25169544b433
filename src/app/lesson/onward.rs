//! After a lesson: the next one of the course, offered above the list.

use super::course_list::{Stand, stand};
use super::pane::{LessonPane, Wish};
use crate::app::frame::theme::{PADDING, bold};
use crate::app::frame::words::{say, say_with};
use crate::lesson::Lesson;
use egui::{Button, Frame, Label, Margin, RichText, Ui};

impl LessonPane {
    /// The lesson that was ended last, and the first one after it in the course that is not done.
    fn onward(&self) -> Option<[&Lesson; 2]> {
        let lessons = &self.lessons()?.course.lessons;
        let place = lessons.iter().position(|lesson| Some(&lesson.id) == self.ended.as_ref())?;
        let next = lessons[place + 1..].iter().find(|lesson| stand(&self.progress, &lesson.id) != Stand::Done)?;
        Some([&lessons[place], next])
    }

    /// The lesson at which the list is to stand.
    pub(super) fn next_lesson(&self) -> Option<&str> {
        self.onward().map(|[_, next]| next.id.as_str())
    }
}

/// Shows what comes next; returns it where it was chosen.
pub fn ui(ui: &mut Ui, pane: &LessonPane) -> Option<Wish> {
    let [ended, next] = pane.onward()?;
    let mut wish = None;
    Frame::new().inner_margin(Margin::same(PADDING)).show(ui, |ui| {
        ui.set_width(ui.available_width());
        let title = say_with(ui.ctx(), "lesson-ended", &[("lesson", (&ended.header.title).into())]);
        ui.add(Label::new(RichText::new(title).family(bold())).wrap());
        ui.horizontal_wrapped(|ui| {
            ui.label(say(ui.ctx(), "lesson-onward"));
            if ui.add(Button::new(&next.header.title).selected(true)).clicked() {
                wish = Some(Wish::Open(next.id.clone()));
            }
        });
        ui.separator();
    });
    wish
}
