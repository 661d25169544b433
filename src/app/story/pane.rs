//! The pane of the story: toolbar, one drawer if it is open, the timeline, and the outline.

use super::stepping::Drawer;
use super::{breakpoints, filter, jump, left_out, toolbar, tree};
use crate::app::frame::empty::empty;
use crate::app::frame::theme::Palette;
use crate::app::frame::words::say;
use crate::app::workbench::Workbench;
use egui::{Align, Context, Layout, RichText, Stroke, Ui, UiBuilder};

/// Below this height of the pane there is no room for the timeline, in points.
const ENOUGH: f32 = 300.0;

/// Shows the pane.
pub fn ui(ui: &mut Ui, workbench: &mut Workbench) {
    if workbench.recording.is_none() {
        return empty(ui, &say(ui.ctx(), "step-story-empty"));
    }
    let whole = ui.available_rect_before_wrap();
    let tools = whole.shrink2(egui::vec2(8.0, 4.0));
    let builder = UiBuilder::new().id_salt("tools").max_rect(tools).layout(Layout::top_down(Align::Min));
    let used = ui.scope_builder(builder, |ui| {
        toolbar::ui(ui, workbench);
        drawer(ui, workbench);
        note(ui, workbench);
    });
    let mut top = used.response.rect.bottom().min(whole.bottom()) + 4.0;
    line(ui, whole, top);
    top += 1.0;
    let Workbench { timeline, recording, .. } = workbench;
    if let Some(recording) = recording.as_mut().filter(|_| whole.height() >= ENOUGH) {
        let strip = whole.with_min_y(top).with_max_y(top + timeline.height(recording));
        let builder = UiBuilder::new().id_salt("timeline").max_rect(strip);
        let target = ui.scope_builder(builder, |ui| timeline.ui(ui, recording)).inner;
        if let Some(event) = target {
            recording.select(event);
        }
        top = strip.bottom();
        line(ui, whole, top);
        top += 1.0;
    }
    let builder = UiBuilder::new().id_salt("rows").max_rect(whole.with_min_y(top.min(whole.bottom())));
    ui.scope_builder(builder, |ui| tree::ui(ui, workbench.recording.as_mut()));
}

/// Where one stands, for the pane's header.
#[must_use]
pub fn position(ctx: &Context, workbench: &Workbench) -> String {
    toolbar::position(ctx, workbench.recording.as_ref(), workbench.stepping.is_recording())
}

fn drawer(ui: &mut Ui, workbench: &mut Workbench) {
    let Some(drawer) = workbench.stepping.drawer else { return };
    ui.add_space(4.0);
    ui.push_id("drawer", |ui| match drawer {
        Drawer::Filter => filter::ui(ui, workbench),
        Drawer::Breakpoints => breakpoints::ui(ui, workbench),
        Drawer::Jump => jump::ui(ui, workbench),
        Drawer::LeftOut => left_out::ui(ui, workbench),
    });
}

fn note(ui: &mut Ui, workbench: &mut Workbench) {
    let Some(note) = workbench.stepping.note else { return };
    let close = say(ui.ctx(), "step-note-close");
    ui.horizontal(|ui| {
        ui.label(RichText::new(say(ui.ctx(), note)).color(Palette::current(ui.ctx()).problem));
        let button = ui.small_button("×");
        button.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &close));
        if button.clicked() {
            workbench.stepping.note = None;
        }
    });
}

fn line(ui: &Ui, whole: egui::Rect, y: f32) {
    ui.painter().hline(whole.x_range(), y, Stroke::new(1.0, Palette::current(ui.ctx()).edge));
}
