//! Questions on screen: one control for each kind of answer, hints, and what is said about an answer.

mod asked;
mod form;
mod intervals;
mod number;
mod order;

pub use asked::{Asked, Draft};

use asked::News;

use super::text::{Reader, SIZE, barred};
use crate::app::frame::code::with_code;
use crate::app::frame::theme::{Palette, bold};
use crate::app::frame::words::{say, say_with};
use crate::app::pane::Pane;
use crate::lesson::Verdict;
use crate::lesson::model::Surface;
use crate::lesson::question::Form;
use crate::record::EventId;
use egui::{Button, Frame, Margin, Rect, Response, RichText, Role, Stroke, Ui, WidgetInfo};

/// What is to be seen elsewhere, as far as answers are about it.
#[derive(Clone, Copy, Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "they do not depend on each other")]
pub struct Seen {
    /// Where t stands on the sign plot.
    pub probe_t: Option<f64>,
    /// The pixel that was recorded in the scene of the step, in place of the step's own.
    pub pixel: Option<[u32; 2]>,
    /// The selected event of the step's own ray.
    pub event: Option<EventId>,
    /// Whether what is seen is what the step is about.
    pub is_staged: bool,
    /// Whether the step asks for a change, and its scene is open with one.
    pub is_tried: bool,
    /// Whether the pixel or the ray of the step was recorded, in whatever scene.
    pub is_aimed: bool,
    /// Whether the edited scene still has to be compiled or judged.
    pub is_busy: bool,
}

/// What a question asks of the rest of the workbench.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum QuestionWish {
    /// To judge the answer.
    Check,
    /// A hint.
    Hint,
    /// The answer.
    Reveal,
    /// To let the next click there answer, or not any more.
    Arm(bool),
    /// To take the recorded pixel, or the place of the selected event, for an answer.
    TakePlace(Surface),
    /// To put t there.
    Probe(f64),
    /// To bring a panel to the front.
    Show(Pane),
}

/// Shows the question of that number of so many, counted from 1.
pub fn ui(
    ui: &mut Ui,
    reader: &mut Reader,
    asked: &mut Asked,
    [number, of]: [usize; 2],
    seen: &Seen,
) -> Option<QuestionWish> {
    let palette = Palette::current(ui.ctx());
    let edge = if asked.is_done() { palette.edge } else { palette.accent };
    let frame = Frame::new().fill(palette.backdrop).stroke(Stroke::new(1.0, edge)).corner_radius(6);
    let shown = frame.inner_margin(Margin::symmetric(12, 10)).show(ui, |ui| {
        ui.set_width(ui.available_width());
        let title = say_with(ui.ctx(), "lesson-question", &[("number", number.into()), ("of", of.into())]);
        ui.horizontal(|ui| {
            ui.label(RichText::new(title).size(12.0).family(bold()).color(palette.accent));
            ui.label(RichText::new(state(ui, asked)).size(12.0).color(palette.weak));
        });
        reader.prose(ui, &asked.posed.ask);
        ui.add_space(2.0);
        let of_form = ui.push_id(("form", number), |ui| form::ui(ui, reader, asked, number, seen)).inner;
        ui.add_space(2.0);
        let of_row = buttons(ui, asked, number, seen);
        let last_hint = hints(ui, reader, asked);
        let outcome = ui.scope(|ui| outcome(ui, reader, asked)).response.rect;
        match asked.news.take() {
            Some(News::Hint) => last_hint.into_iter().for_each(|rect| ui.scroll_to_rect(rect, None)),
            Some(News::Outcome) => ui.scroll_to_rect(outcome, None),
            None => {}
        }
        of_form.or(of_row)
    });
    shown.inner
}

/// How it stands, with a sign: not everybody sees the colour.
fn state(ui: &Ui, asked: &Asked) -> String {
    match (asked.record.solved, asked.record.revealed) {
        (true, _) => format!("✓ {}", say(ui.ctx(), "lesson-solved")),
        (false, true) => say(ui.ctx(), "lesson-was-revealed"),
        (false, false) => String::new(),
    }
}

/// A button whose name tells which question it belongs to.
pub(super) fn numbered(ui: &mut Ui, word: &str, number: usize, is_enabled: bool) -> Response {
    let title = say(ui.ctx(), word);
    let name = say_with(ui.ctx(), "lesson-of-question", &[("what", (&title).into()), ("number", number.into())]);
    let about = say(ui.ctx(), &format!("{word}-about"));
    let response = ui.add_enabled(is_enabled, Button::new(title));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, is_enabled, &name));
    response.on_hover_text(about)
}

fn buttons(ui: &mut Ui, asked: &Asked, number: usize, seen: &Seen) -> Option<QuestionWish> {
    let mut wish = None;
    ui.horizontal_wrapped(|ui| {
        let is_click = matches!(asked.posed.form, Form::Place(..));
        if !is_click {
            let is_possible = asked.is_complete(seen) && !seen.is_busy;
            if numbered(ui, "lesson-check", number, is_possible).clicked() {
                wish = Some(QuestionWish::Check);
            }
        }
        let left = asked.posed.hints.len().saturating_sub(asked.record.hints);
        // After the last hint its button stays: else the one for the answer would slide under the pointer.
        let has_hints = !asked.posed.hints.is_empty() && !asked.is_done();
        if has_hints && numbered(ui, "lesson-hint", number, left > 0).clicked() {
            wish = Some(QuestionWish::Hint);
        }
        if !asked.is_done() && numbered(ui, "lesson-reveal", number, true).clicked() {
            wish = Some(QuestionWish::Reveal);
        }
    });
    wish
}

/// The hints so far; returns where the last one stands.
fn hints(ui: &mut Ui, reader: &mut Reader, asked: &Asked) -> Option<Rect> {
    let mut last = None;
    let weak = Palette::current(ui.ctx()).weak;
    for (place, hint) in asked.posed.hints.iter().take(asked.record.hints).enumerate() {
        let title = say_with(ui.ctx(), "lesson-hint-title", &[("number", (place + 1).into())]);
        let shown = ui.scope(|ui| {
            barred(ui, weak, |ui| {
                ui.label(RichText::new(title).size(12.0).color(weak));
                reader.prose(ui, hint);
            });
        });
        last = Some(shown.response.rect);
    }
    last
}

/// What came of the answer, in words and with a sign.
fn outcome(ui: &mut Ui, reader: &mut Reader, asked: &Asked) {
    let palette = Palette::current(ui.ctx());
    if let Some(problem) = &asked.problem {
        ui.label(with_code(problem, SIZE, palette.problem));
    }
    let explain = asked.posed.explain.as_ref();
    if let Some(verdict) = &asked.verdict {
        tell(ui, reader, verdict, asked.is_told());
        // Of most questions what is said of the right answer is the explanation; that of a choice is said before it.
        let is_said = verdict.is_right && verdict.feedback.as_ref() == explain;
        if let Some(explain) = explain.filter(|_| !is_said && asked.is_done()) {
            barred(ui, palette.accent, |ui| reader.prose(ui, explain));
        }
        return;
    }
    if asked.is_done() {
        let word = if asked.record.solved { "lesson-solved-before" } else { "lesson-revealed" };
        ui.label(RichText::new(say(ui.ctx(), word)).family(bold()));
        if let Some(explain) = explain {
            barred(ui, palette.accent, |ui| reader.prose(ui, explain));
        }
    }
}

/// What is said about an answer; one that was not found but shown is not praised.
fn tell(ui: &mut Ui, reader: &mut Reader, verdict: &Verdict, is_told: bool) {
    let palette = Palette::current(ui.ctx());
    let (sign, word, colour) = match (verdict.is_right, is_told) {
        (true, true) => ("", "lesson-revealed", palette.accent),
        (true, false) => ("✓ ", "lesson-right", palette.accent),
        (false, _) => ("✗ ", "lesson-wrong", palette.problem),
    };
    barred(ui, colour, |ui| {
        ui.label(RichText::new(format!("{sign}{}", say(ui.ctx(), word))).family(bold()).color(colour));
        if let Some(feedback) = &verdict.feedback {
            reader.prose(ui, feedback);
        }
    });
}
