//! Boxes to tick, rounds to choose from and sliders, each with what shows it where nothing is ticked or chosen yet: the edges
//! of panels are too faint for that.

use super::theme::Palette;
use egui::{Response, Slider, Stroke, Ui, WidgetText};

/// A box to tick.
pub fn checkbox(ui: &mut Ui, is_on: &mut bool, text: impl Into<WidgetText>) -> Response {
    let text = text.into();
    standing_out(ui, |ui| ui.checkbox(is_on, text))
}

/// A round that stands for one of several choices.
pub fn radio(ui: &mut Ui, is_chosen: bool) -> Response {
    standing_out(ui, |ui| ui.radio(is_chosen, ""))
}

/// A slider on a track that is seen.
pub fn slider(ui: &mut Ui, slider: Slider) -> Response {
    let track = Palette::current(ui.ctx()).weak;
    let before = std::mem::replace(&mut ui.visuals_mut().widgets.inactive.bg_fill, track);
    let response = ui.add(slider);
    ui.visuals_mut().widgets.inactive.bg_fill = before;
    response
}

fn standing_out(ui: &mut Ui, add: impl FnOnce(&mut Ui) -> Response) -> Response {
    let rim = Stroke::new(1.0, Palette::current(ui.ctx()).weak);
    let before = std::mem::replace(&mut ui.visuals_mut().widgets.inactive.bg_stroke, rim);
    let response = add(ui);
    ui.visuals_mut().widgets.inactive.bg_stroke = before;
    response
}
