//! What is wrong with a file that could not be opened, or not be saved.

use crate::app::frame::theme::Palette;
use crate::app::frame::words::{say, say_with};
use crate::app::workbench::{OpenScene, Problem};
use egui::{
    Align, Color32, CornerRadius, Label, Layout, Rect, RichText, ScrollArea, Stroke, StrokeKind, TextStyle, Ui,
    UiBuilder, Vec2,
};

/// Height of everything but the message, in points.
const AROUND: f32 = 62.0;
/// Width of everything but the message: the margins, and the bar where it scrolls, in points.
const BESIDE: f32 = 40.0;

/// The height that the message needs, up to half of what there is.
#[must_use]
pub fn height(ui: &Ui, problem: &Problem, available: Vec2) -> f32 {
    let font = TextStyle::Monospace.resolve(ui.style());
    let text = ui.painter().layout(problem.text.clone(), font, Color32::WHITE, available.x - BESIDE);
    (AROUND + text.size().y).min(available.y / 2.0)
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
                    let title = say_with(ui.ctx(), problem.title, &[("name", (&problem.name).into())]);
                    let stays =
                        |open: &OpenScene| say_with(ui.ctx(), "problem-stays", &[("name", (&open.name).into())]);
                    let title = open.map_or_else(|| title.clone(), |open| format!("{title} {}", stays(open)));
                    ui.add(Label::new(RichText::new(title).strong().color(palette.problem)).truncate());
                });
            });
        });
        ScrollArea::vertical().auto_shrink(false).min_scrolled_height(0.0).show(ui, |ui| {
            ui.add(Label::new(RichText::new(&problem.text).monospace()).wrap().selectable(true));
        });
    });
    closed
}
