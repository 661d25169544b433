//! The course as a list: what there is, what was done of it, and what needs what.

use super::pane::{LessonPane, Wish};
use crate::app::frame::empty::empty;
use crate::app::frame::theme::{PADDING, Palette, bold};
use crate::app::frame::words::{say, say_with};
use crate::lesson::{Course, Lesson, Progress};
use egui::{
    Align, Frame, Label, Margin, Rect, Response, RichText, Role, ScrollArea, Sense, Stroke, StrokeKind, Ui, WidgetInfo,
};

/// Shows the list; returns the lesson that was chosen.
pub fn ui(ui: &mut Ui, pane: &mut LessonPane) -> Option<Wish> {
    let Some(lessons) = pane.lessons().cloned() else {
        empty(ui, &say(ui.ctx(), "lesson-reading"));
        return None;
    };
    let mut wish = None;
    ScrollArea::vertical().id_salt("course").auto_shrink(false).show(ui, |ui| {
        Frame::new().inner_margin(Margin::same(PADDING)).show(ui, |ui| {
            ui.set_width(ui.available_width());
            tools(ui, pane, &lessons.course);
            let next = pane.next_lesson().map(str::to_owned).filter(|_| std::mem::take(&mut pane.is_moving_on));
            for lesson in &lessons.course.lessons {
                let row = row(ui, &lessons.course, lesson, &pane.progress);
                if Some(&lesson.id) == next.as_ref() {
                    row.scroll_to_me(Some(Align::Center));
                }
                if row.clicked() {
                    wish = Some(Wish::Open(lesson.id.clone()));
                }
            }
            if lessons.course.lessons.is_empty() {
                ui.label(RichText::new(say(ui.ctx(), "lesson-none")).weak());
            }
        });
    });
    wish
}

/// What stands above the lessons in the list and in the map: how much was done, and the switch between the two.
pub fn tools(ui: &mut Ui, pane: &mut LessonPane, course: &Course) {
    let done = course.lessons.iter().filter(|lesson| stand(&pane.progress, &lesson.id) == Stand::Done).count();
    ui.horizontal_wrapped(|ui| {
        let text = say_with(ui.ctx(), "lesson-done-of", &[("done", done.into()), ("of", course.lessons.len().into())]);
        ui.label(RichText::new(text).family(bold()));
        for (is_map, word) in [(false, "lesson-as-list"), (true, "lesson-as-map")] {
            if ui.selectable_label(pane.is_map == is_map, say(ui.ctx(), word)).clicked() {
                pane.is_map = is_map;
            }
        }
    });
    if let Some(notice) = pane.notice.clone() {
        ui.horizontal_wrapped(|ui| {
            ui.add(Label::new(notice).wrap());
            if ui.small_button(say(ui.ctx(), "close")).clicked() {
                pane.notice = None;
            }
        });
    }
    if pane.is_resetting {
        let ctx = ui.ctx().clone();
        ui.horizontal_wrapped(|ui| {
            ui.label(RichText::new(say(&ctx, "lesson-reset-sure")).color(Palette::current(&ctx).problem));
            if ui.button(say(&ctx, "lesson-reset-yes")).clicked() {
                pane.reset(&ctx);
            }
            if ui.button(say(&ctx, "lesson-reset-no")).clicked() {
                pane.is_resetting = false;
            }
        });
    }
    ui.add_space(4.0);
}

/// What was done of a lesson.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stand {
    /// Nothing.
    Not,
    /// A part.
    Begun,
    /// All.
    Done,
}

impl Stand {
    /// A sign: not everybody sees colours.
    pub const fn sign(self) -> &'static str {
        match self {
            Self::Not => "○",
            Self::Begun => "…",
            Self::Done => "✓",
        }
    }

    /// Its name in the catalogue of words.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Not => "lesson-stand-not",
            Self::Begun => "lesson-stand-begun",
            Self::Done => "lesson-stand-done",
        }
    }
}

/// What was done of a lesson.
pub fn stand(progress: &Progress, lesson: &str) -> Stand {
    match progress.lessons.get(lesson) {
        None => Stand::Not,
        Some(kept) if kept.finished => Stand::Done,
        Some(_) => Stand::Begun,
    }
}

/// Shows a lesson, which a click chooses.
fn row(ui: &mut Ui, course: &Course, lesson: &Lesson, progress: &Progress) -> Response {
    let palette = Palette::current(ui.ctx());
    let stand = stand(progress, &lesson.id);
    let header = &lesson.header;
    let title = |id: &str| course.lesson(id).map_or(id.to_owned(), |lesson| lesson.header.title.clone());
    let needs: Vec<String> = header.needs.iter().map(|need| title(&need.value)).collect();
    let minutes = usize::try_from(header.minutes.value).unwrap_or_default();
    let mut about = say_with(
        ui.ctx(),
        "lesson-header",
        &[("section", (&header.section.value).into()), ("minutes", minutes.into())],
    );
    if !needs.is_empty() {
        about = format!("{about} · {}", say_with(ui.ctx(), "lesson-needs", &[("lessons", (&needs.join(", ")).into())]));
    }
    let name = format!("{}, {}, {about}", header.title, say(ui.ctx(), stand.word()));
    let before = ui.painter().add(egui::Shape::Noop);
    let frame = Frame::new().inner_margin(Margin { left: 26, right: 6, top: 4, bottom: 4 });
    let shown = frame.show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.spacing_mut().item_spacing.y = 1.0;
        ui.add(Label::new(RichText::new(&header.title).size(14.0).family(bold())).wrap().selectable(false));
        ui.add(Label::new(RichText::new(&header.idea).size(12.5)).wrap().selectable(false));
        ui.add(Label::new(RichText::new(&about).size(11.5).color(palette.weak)).wrap().selectable(false));
    });
    let rect: Rect = shown.response.rect;
    let response = ui.interact(rect, ui.scope_id().with(("lesson", &lesson.id)), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    if response.hovered() || response.has_focus() {
        ui.painter().set(before, egui::Shape::rect_filled(rect, 4.0, palette.hovered));
    }
    if response.has_focus() {
        ui.painter().rect_stroke(rect, 4.0, Stroke::new(1.5, palette.accent), StrokeKind::Inside);
    }
    let sign = egui::pos2(rect.left() + 12.0, rect.top() + 14.0);
    let colour = if stand == Stand::Done { palette.accent } else { palette.weak };
    ui.painter().text(sign, egui::Align2::CENTER_CENTER, stand.sign(), egui::FontId::proportional(14.0), colour);
    response
}
