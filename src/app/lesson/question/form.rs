//! The control of each kind of answer.

use super::asked::{Asked, Draft};
use super::{QuestionWish, Seen, intervals, numbered, order};
use crate::app::frame::theme::Palette;
use crate::app::frame::ticks;
use crate::app::frame::words::{say, say_with};
use crate::app::lesson::text::Reader;
use crate::app::pane::Pane;
use crate::lesson::model::Surface;
use crate::lesson::prose::plain;
use crate::lesson::question::{Form, PosedChoice};
use egui::{DragValue, Key, RichText, Role, TextEdit, Ui, WidgetInfo};

/// Shows the control of a question.
pub fn ui(ui: &mut Ui, reader: &mut Reader, asked: &mut Asked, number: usize, seen: &Seen) -> Option<QuestionWish> {
    let Asked { posed, draft, record, .. } = asked;
    let is_done = record.solved || record.revealed;
    match (&posed.form, draft) {
        (Form::Number(reckoned), Draft::Number(typed)) => number_field(ui, typed, &reckoned.unit, number),
        (Form::Choice(choices), Draft::Choice(chosen)) => {
            choice(ui, reader, choices, chosen, is_done);
            None
        }
        (Form::Order { items, .. }, Draft::Order(chosen)) => {
            order::ui(ui, reader, items, chosen);
            None
        }
        (Form::Place(surface, _), Draft::Place { is_armed, .. }) => place(ui, *surface, *is_armed, number, seen),
        (Form::Time(_), _) => time(ui, number, seen),
        (Form::Intervals(reckoned), Draft::Intervals(chosen)) => {
            intervals::ui(ui, reckoned, chosen, is_done);
            None
        }
        (Form::Edit(_), _) => edit(ui, number, seen),
        _ => None,
    }
}

fn number_field(ui: &mut Ui, typed: &mut String, unit: &str, number: usize) -> Option<QuestionWish> {
    let title = say_with(ui.ctx(), "lesson-number", &[("number", number.into())]);
    let mut is_given = false;
    ui.horizontal(|ui| {
        let field = ui.add(TextEdit::singleline(typed).desired_width(140.0).font(egui::TextStyle::Monospace));
        field.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, &title));
        is_given = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if !unit.is_empty() {
            ui.label(unit);
        }
    });
    (is_given && !typed.trim().is_empty()).then_some(QuestionWish::Check)
}

/// The choices; once all is known the right one has a tick.
fn choice(ui: &mut Ui, reader: &mut Reader, choices: &[PosedChoice], chosen: &mut Option<usize>, is_done: bool) {
    for (place, choice) in choices.iter().enumerate() {
        let name = plain(&choice.text);
        ui.horizontal_top(|ui| {
            let button = ticks::radio(ui, *chosen == Some(place));
            button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, *chosen == Some(place), &name));
            if button.clicked() {
                *chosen = Some(place);
            }
            let row = ui.vertical(|ui| {
                ui.add_space(3.0);
                reader.option(ui, &choice.text);
            });
            // The words belong to the button: a click on them is one on it.
            let row = ui.interact(row.response.rect, button.id.with("words"), egui::Sense::CLICK);
            if row.clicked() {
                *chosen = Some(place);
            }
            if is_done && choice.is_right {
                ui.label(RichText::new("✓").color(Palette::current(ui.ctx()).accent));
            }
        });
    }
}

fn place(ui: &mut Ui, surface: Surface, is_armed: bool, number: usize, seen: &Seen) -> Option<QuestionWish> {
    let (pane, invitation, take) = match surface {
        Surface::Image => (Pane::Picture, "lesson-click-picture", "lesson-take-pixel"),
        Surface::Side => (Pane::Side, "lesson-click-side", "lesson-take-event"),
    };
    let mut wish = None;
    let word = if is_armed { "lesson-disarm" } else { "lesson-arm" };
    ui.horizontal_wrapped(|ui| {
        if numbered(ui, word, number, true).clicked() {
            wish = Some(QuestionWish::Arm(!is_armed));
        }
        let is_there = match surface {
            Surface::Image => seen.pixel.is_some(),
            Surface::Side => seen.event.is_some(),
        };
        // For whoever uses no pointer.
        if numbered(ui, take, number, is_there).clicked() {
            wish = Some(QuestionWish::TakePlace(surface));
        }
        if ui.button(say(ui.ctx(), pane.word())).on_hover_text(say(ui.ctx(), "lesson-show-about")).clicked() {
            wish = Some(QuestionWish::Show(pane));
        }
    });
    if is_armed {
        ui.label(RichText::new(say(ui.ctx(), invitation)).color(Palette::current(ui.ctx()).accent));
    }
    wish
}

/// t, which is dragged on the sign plot; here it can be put more finely, and without a pointer.
fn time(ui: &mut Ui, number: usize, seen: &Seen) -> Option<QuestionWish> {
    let mut wish = None;
    ui.horizontal_wrapped(|ui| {
        if numbered(ui, "lesson-show-signs", number, true).clicked() {
            wish = Some(QuestionWish::Show(Pane::Signs));
        }
        let word = if seen.probe_t.is_some() { "lesson-t" } else { "lesson-no-t" };
        let label = ui.label(say(ui.ctx(), word));
        let mut t = seen.probe_t.unwrap_or_default();
        let field = DragValue::new(&mut t).speed(0.002).max_decimals(6).prefix("t = ");
        if ui.add_enabled(seen.is_staged, field).labelled_by(label.id).changed() {
            wish = Some(QuestionWish::Probe(t));
        }
    });
    wish
}

fn edit(ui: &mut Ui, number: usize, seen: &Seen) -> Option<QuestionWish> {
    let mut wish = None;
    ui.horizontal_wrapped(|ui| {
        for (word, pane) in [("lesson-show-editor", Pane::Editor), ("lesson-show-properties", Pane::Properties)] {
            if numbered(ui, word, number, true).clicked() {
                wish = Some(QuestionWish::Show(pane));
            }
        }
        if seen.is_busy {
            ui.label(RichText::new(say(ui.ctx(), "lesson-judging")).weak());
        }
    });
    wish
}
