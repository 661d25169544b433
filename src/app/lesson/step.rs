//! The step of a lesson: where one stands, what is told and asked, and the way on.

use super::open::OpenLesson;
use super::pane::{LessonPane, Wish};
use super::question::{self, Seen};
use super::staged::Staged;
use super::text::{Formulas, Reader, TextWish};
use super::told::ToldPart;
use crate::app::frame::theme::{PADDING, Palette, bold};
use crate::app::frame::words::{say, say_with};
use crate::lesson::prose::{Prose, Told};
use crate::lesson::{Finding, Lesson};
use egui::{
    Align, Button, Frame, Label, Layout, Margin, Rect, RichText, Role, ScrollArea, Stroke, Ui, UiBuilder, WidgetInfo,
};

/// Height of the line with the way on, in points.
const FOOT: f32 = 40.0;

/// Height of the meaning of a term, in points.
const MEANING: f32 = 150.0;

/// Shows the lesson that is open.
pub fn ui(ui: &mut Ui, pane: &mut LessonPane, seen: &Seen) -> Option<Wish> {
    let whole = ui.available_rect_before_wrap();
    let lessons = pane.lessons().cloned()?;
    let findings: Vec<Finding> = pane.findings().into_iter().cloned().collect();
    let LessonPane { open, formulas, term, unread, .. } = pane;
    let open = open.as_mut()?;
    let lesson = lessons.course.lesson(&open.id);
    let inner = whole.shrink2(egui::vec2(f32::from(PADDING), 6.0));
    let builder = UiBuilder::new().id_salt("head").max_rect(inner).layout(Layout::top_down(Align::Min));
    let head = ui.scope_builder(builder, |ui| head(ui, open, lesson));
    let top = head.response.rect.bottom() + 4.0;
    let foot_top = (whole.bottom() - FOOT).max(top);
    let text_bottom = if term.is_some() { (foot_top - MEANING).max(top) } else { foot_top };
    for y in [top, text_bottom, foot_top] {
        ui.painter().hline(whole.x_range(), y, Stroke::new(1.0, Palette::current(ui.ctx()).edge));
    }
    let strip = |from: f32, to: f32| Rect::from_x_y_ranges(whole.x_range(), from + 1.0..=to.max(from + 1.0));
    let salt = format!("text {} {}", open.id, open.step);
    let text = scrolled(ui, &salt, strip(top, text_bottom), |ui| {
        problems(ui, &findings, unread.as_deref());
        body(ui, open, lesson, formulas, term, seen)
    });
    if text_bottom < foot_top {
        scrolled(ui, "meaning", strip(text_bottom, foot_top), |ui| meaning(ui, open, formulas, term));
    }
    let foot_rect = Rect::from_x_y_ranges(inner.x_range(), foot_top + 1.0..=whole.bottom());
    let builder = UiBuilder::new().id_salt("foot").max_rect(foot_rect).layout(Layout::left_to_right(Align::Center));
    let foot = ui.scope_builder(builder, |ui| foot(ui, open, seen));
    head.inner.or(text).or(foot.inner)
}

/// A part of the panel that is scrolled where it is higher than its room.
fn scrolled<T>(ui: &mut Ui, salt: &str, rect: Rect, contents: impl FnOnce(&mut Ui) -> T) -> T {
    let builder = UiBuilder::new().id_salt(("part", salt)).max_rect(rect);
    let shown = ui.scope_builder(builder, |ui| {
        ScrollArea::vertical().id_salt(salt).auto_shrink(false).show(ui, |ui| {
            Frame::new().inner_margin(Margin::symmetric(PADDING + 2, 8)).show(ui, |ui| {
                ui.set_width(ui.available_width());
                ui.spacing_mut().item_spacing.y = 7.0;
                contents(ui)
            })
        })
    });
    shown.inner.inner.inner
}

/// The way back to the course, the title, and where one stands.
fn head(ui: &mut Ui, open: &OpenLesson, lesson: Option<&Lesson>) -> Option<Wish> {
    let palette = Palette::current(ui.ctx());
    let mut wish = None;
    ui.horizontal(|ui| {
        let back = ui.button(say(ui.ctx(), "lesson-list")).on_hover_text(say(ui.ctx(), "lesson-list-about"));
        if back.clicked() {
            wish = Some(Wish::List);
        }
        let place = say_with(ui.ctx(), "lesson-step", &[("step", (open.step + 1).into()), ("of", open.steps.into())]);
        ui.menu_button(format!("{place} ⏷"), |ui| {
            for (number, step) in lesson.iter().flat_map(|lesson| lesson.steps.iter().enumerate()) {
                let title = format!("{}. {}", number + 1, step.title);
                if ui.selectable_label(number == open.step, title).clicked() {
                    wish = Some(Wish::Step(number));
                    ui.close();
                }
            }
        });
        if open.is_busy() {
            ui.spinner();
        }
    });
    if let Some(lesson) = lesson {
        let header = &lesson.header;
        let minutes = usize::try_from(header.minutes.value).unwrap_or_default();
        let about = say_with(
            ui.ctx(),
            "lesson-header",
            &[("section", (&header.section.value).into()), ("minutes", minutes.into())],
        );
        ui.add(Label::new(RichText::new(&header.title).size(15.0).family(bold())).wrap());
        ui.add(Label::new(RichText::new(about).size(12.0).color(palette.weak)).truncate());
    }
    marks(ui, open);
    wish
}

/// A short stroke for each step: those that were gone through are full.
fn marks(ui: &mut Ui, open: &OpenLesson) {
    let palette = Palette::current(ui.ctx());
    let (rect, _) = ui.allocate_exact_size(egui::vec2(ui.available_width(), 5.0), egui::Sense::hover());
    let width = rect.width() / open.steps.max(1) as f32;
    for step in 0..open.steps {
        let left = rect.left() + width * step as f32;
        let mark = Rect::from_min_max(egui::pos2(left, rect.top()), egui::pos2(left + width - 3.0, rect.bottom()));
        let colour = if step <= open.step { palette.accent } else { palette.edge };
        ui.painter().rect_filled(mark, 2.0, colour);
    }
}

/// What is wrong with the lesson, for whoever writes it.
fn problems(ui: &mut Ui, findings: &[Finding], unread: Option<&str>) {
    if findings.is_empty() && unread.is_none() {
        return;
    }
    let palette = Palette::current(ui.ctx());
    let frame = Frame::new().stroke(Stroke::new(1.5, palette.problem)).corner_radius(6).inner_margin(Margin::same(8));
    frame.show(ui, |ui| {
        ui.set_width(ui.available_width());
        let title = say_with(
            ui.ctx(),
            "lesson-findings",
            &[("count", (findings.len() + usize::from(unread.is_some())).into())],
        );
        ui.label(RichText::new(title).family(bold()).color(palette.problem));
        for text in unread.map(str::to_owned).into_iter().chain(findings.iter().map(ToString::to_string)) {
            ui.add(Label::new(RichText::new(text).monospace()).wrap().selectable(true));
        }
    });
}

fn body(
    ui: &mut Ui,
    open: &mut OpenLesson,
    lesson: Option<&Lesson>,
    formulas: &mut Formulas,
    term: &mut Option<String>,
    seen: &Seen,
) -> Option<Wish> {
    let OpenLesson { outcome, asked, .. } = open;
    let Some(Ok(staged)) = outcome.as_ref() else {
        if outcome.is_none() {
            ui.label(RichText::new(say(ui.ctx(), "lesson-setting-up")).weak());
        }
        return None;
    };
    let staged: &Staged = staged;
    let mut reader = Reader::new(formulas, &staged.terms, seen.event);
    let mut wish = None;
    if staged.step == 0 && !staged.opening.is_empty() {
        reader.prose(ui, &staged.opening);
        ui.add_space(4.0);
    }
    heading(ui, lesson.and_then(|lesson| lesson.steps.get(staged.step)).map_or("", |step| &step.title));
    let of = asked.len();
    for part in &staged.parts {
        match part {
            ToldPart::Prose(prose) => reader.prose(ui, prose),
            ToldPart::Slip { printed, right } => slip(ui, &mut reader, printed, right),
            ToldPart::Table(table) => reader.table(ui, &table.head, &table.rows),
            ToldPart::Question(place) => {
                let Some(asked) = asked.get_mut(*place) else { continue };
                let asks = question::ui(ui, &mut reader, asked, [place + 1, of], seen);
                wish = wish.or(asks.map(|asks| Wish::Question(*place, asks)));
            }
        }
    }
    if let Some(TextWish::Term(name)) = &reader.wish {
        *term = (term.as_deref() != Some(name)).then(|| name.clone());
        reader.wish = None;
    }
    wish.or(reader.wish.map(Wish::Text))
}

fn heading(ui: &mut Ui, title: &str) {
    let heading = ui.add(Label::new(RichText::new(title).size(17.0).family(bold())).wrap());
    heading.widget_info(|| WidgetInfo::labeled(Role::Heading, true, title));
}

/// Where the source chapter slips: what it prints and what is right.
fn slip(ui: &mut Ui, reader: &mut Reader, printed: &Prose<Told>, right: &Prose<Told>) {
    let palette = Palette::current(ui.ctx());
    let frame = Frame::new().stroke(Stroke::new(1.0, palette.problem)).corner_radius(6);
    frame.inner_margin(Margin::symmetric(12, 8)).show(ui, |ui| {
        ui.set_width(ui.available_width());
        let title = format!("⚠ {}", say(ui.ctx(), "lesson-slip"));
        ui.label(RichText::new(title).size(12.0).family(bold()).color(palette.problem));
        for (word, prose) in [("lesson-slip-printed", printed), ("lesson-slip-right", right)] {
            ui.label(RichText::new(say(ui.ctx(), word)).size(12.0).color(palette.weak));
            reader.prose(ui, prose);
        }
    });
}

/// What the term means that was clicked.
fn meaning(ui: &mut Ui, open: &OpenLesson, formulas: &mut Formulas, term: &mut Option<String>) {
    let Some(staged) = open.staged() else { return };
    let Some((name, meaning)) = term.as_ref().and_then(|name| staged.terms.get_key_value(name)) else {
        *term = None;
        return;
    };
    let mut is_closed = false;
    ui.horizontal(|ui| {
        ui.label(RichText::new(name).family(bold()));
        is_closed = ui.small_button(say(ui.ctx(), "close")).clicked();
    });
    let mut reader = Reader::new(formulas, &staged.terms, None);
    reader.prose(ui, meaning);
    match reader.wish {
        Some(TextWish::Term(name)) => *term = Some(name),
        _ if is_closed => *term = None,
        _ => {}
    }
}

/// Back and on. What was not answered can be skipped.
fn foot(ui: &mut Ui, open: &OpenLesson, seen: &Seen) -> Option<Wish> {
    let mut wish = None;
    let back = ui.add_enabled(open.step > 0, Button::new(say(ui.ctx(), "lesson-previous")));
    if back.on_hover_text(say(ui.ctx(), "lesson-previous-about")).clicked() {
        wish = Some(Wish::Step(open.step.saturating_sub(1)));
    }
    if open.staged().is_some() && !seen.is_staged {
        let (word, about, asks) = match (seen.is_tried, seen.is_aimed) {
            (true, true) => ("lesson-again", "lesson-again-about", Wish::StartAgain),
            (true, false) => ("lesson-restage", "lesson-retry-about", Wish::Restage),
            (false, _) => ("lesson-restage", "lesson-restage-about", Wish::Restage),
        };
        if ui.button(say(ui.ctx(), word)).on_hover_text(say(ui.ctx(), about)).clicked() {
            wish = Some(asks);
        }
    }
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        let is_last = open.step + 1 >= open.steps;
        let word = match (is_last, open.is_done()) {
            (true, _) => "lesson-finish",
            (false, true) => "lesson-next",
            (false, false) => "lesson-skip",
        };
        let button = Button::new(say(ui.ctx(), word)).selected(open.is_done());
        if ui.add(button).on_hover_text(say(ui.ctx(), &format!("{word}-about"))).clicked() {
            wish = Some(if is_last { Wish::Finish } else { Wish::Step(open.step + 1) });
        }
    });
    wish
}
