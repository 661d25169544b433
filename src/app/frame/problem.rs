//! What is wrong with a scene that could not be opened.

use crate::app::frame::theme::Palette;
use crate::app::frame::words::{say, say_with};
use crate::app::workbench::{OpenScene, Problem};
use egui::{Align, CornerRadius, Label, Layout, Rect, RichText, ScrollArea, Stroke, StrokeKind, Ui, UiBuilder};

/// Height of a line of the message, in points.
const LINE: f32 = 17.0;
/// Height of everything but the message, in points.
const AROUND: f32 = 62.0;

/// The height that the message needs, up to half of what there is.
#[must_use]
pub fn height(problem: &Problem, available: f32) -> f32 {
    (AROUND + LINE * problem.text.lines().count() as f32).min(available / 2.0)
}

/// Shows the message; returns whether it was closed.
pub fn ui(ui: &mut Ui, rect: Rect, problem: &Problem, open: Option<&OpenScene>) -> bool {
    let palette = Palette::current(ui.ctx());
    ui.painter().rect(
        rect,
        CornerRadius::same(7),
        palette.panel,
        Stroke::new(1.5, palette.problem),
        StrokeKind::Inside,
    );
    let builder = UiBuilder::new().id_salt("problem").max_rect(rect.shrink2(egui::vec2(12.0, 8.0)));
    let mut closed = false;
    ui.scope_builder(builder, |ui| {
        ui.horizontal(|ui| {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                closed = ui.button(say(ui.ctx(), "close")).clicked();
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    let title = say_with(ui.ctx(), "problem-title", &[("name", (&problem.name).into())]);
                    let stays =
                        |open: &OpenScene| say_with(ui.ctx(), "problem-stays", &[("name", (&open.name).into())]);
                    let title = open.map_or_else(|| title.clone(), |open| format!("{title} {}", stays(open)));
                    ui.add(Label::new(RichText::new(title).strong().color(palette.problem)).truncate());
                });
            });
        });
        ScrollArea::both().auto_shrink(false).show(ui, |ui| {
            ui.add(Label::new(RichText::new(&problem.text).monospace()).extend().selectable(true));
        });
    });
    closed
}
