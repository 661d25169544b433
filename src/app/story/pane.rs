//! The pane of the story: toolbar, one drawer if it is open, the timeline, and the outline.

use super::stepping::Drawer;
use super::{breakpoints, filter, jump, left_out, toolbar, tree};
use crate::app::frame::empty::empty;
use crate::app::frame::theme::Palette;
use crate::app::frame::words::say;
use crate::app::workbench::Workbench;
use egui::{Align, Context, Layout, RichText, ScrollArea, Stroke, Ui, UiBuilder};

/// Below this height of the pane there is no room for the timeline, in points.
const ENOUGH: f32 = 300.0;
/// Nor is there where it would leave less than this for the rows, in points.
const ROWS: f32 = 92.0;
/// The most of the pane's height that a drawer takes, and what it takes even of a low one, in points.
const DRAWER: f32 = 0.35;
const LEAST: f32 = 80.0;

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
        drawer(ui, workbench, (DRAWER * whole.height()).max(LEAST));
        note(ui, workbench);
    });
    let mut top = used.response.rect.bottom().min(whole.bottom()) + 4.0;
    line(ui, whole, top);
    top += 1.0;
    let Workbench { timeline, recording, .. } = workbench;
    let strip = recording.as_ref().map(|recording| timeline.height(recording));
    let strip = strip.map(|height| whole.with_min_y(top).with_max_y(top + height));
    let has_room = |strip: &egui::Rect| whole.height() >= ENOUGH && strip.bottom() + ROWS <= whole.bottom();
    if let (Some(recording), Some(strip)) = (recording.as_mut(), strip.filter(has_room)) {
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

/// The drawer that is open: it leaves room for the story, and scrolls where it needs more.
fn drawer(ui: &mut Ui, workbench: &mut Workbench, height: f32) {
    let Some(drawer) = workbench.stepping.drawer else { return };
    ui.add_space(4.0);
    let scroll = ScrollArea::vertical().id_salt("drawer").max_height(height).min_scrolled_height(height);
    scroll.auto_shrink([false, true]).show(ui, |ui| match drawer {
        Drawer::Filter => filter::ui(ui, workbench),
        Drawer::Breakpoints => breakpoints::ui(ui, workbench),
        Drawer::Jump => jump::ui(ui, workbench),
        Drawer::LeftOut => left_out::ui(ui, workbench, height),
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
