//! The frame that every panel of the workbench stands in: a card with a header line and room for its tools.

use crate::app::frame::theme::{PADDING, Palette, bold};
use egui::{Align, CornerRadius, Layout, Rect, RichText, Stroke, StrokeKind, Ui, UiBuilder, vec2};

/// Height of a panel's header, in points.
const HEADER: f32 = 32.0;

/// Shows a panel in `rect`: its title, the tools at the right end of the header, then the contents.
pub fn panel(ui: &mut Ui, rect: Rect, title: &str, tools: impl FnOnce(&mut Ui), contents: impl FnOnce(&mut Ui)) {
    let palette = Palette::current(ui.ctx());
    let radius = CornerRadius::same(7);
    let (header, body) = rect.split_top_bottom_at_y(rect.top() + HEADER);
    ui.painter().rect_filled(rect, radius, palette.panel);
    ui.painter().rect_filled(header, CornerRadius { sw: 0, se: 0, ..radius }, palette.header);
    ui.painter().hline(header.x_range(), header.bottom(), Stroke::new(1.0, palette.edge));

    let inside = header.shrink2(vec2(f32::from(PADDING), 3.0));
    child(ui, title, "header", inside, Layout::left_to_right(Align::Center), |ui| {
        ui.label(RichText::new(title).family(bold()));
        ui.with_layout(Layout::right_to_left(Align::Center), tools);
    });
    child(ui, title, "body", body.shrink(1.0), Layout::top_down(Align::Min), contents);
    ui.painter().rect_stroke(rect, radius, Stroke::new(1.0, palette.edge), StrokeKind::Inside);
}

/// Contents in a rectangle, clipped to it.
fn child(ui: &mut Ui, title: &str, part: &str, rect: Rect, layout: Layout, contents: impl FnOnce(&mut Ui)) {
    let builder = UiBuilder::new().id_salt((title, part)).max_rect(rect).layout(layout);
    let mut child = ui.new_child(builder);
    child.shrink_clip_rect(rect);
    contents(&mut child);
}

/// A plain sentence in the middle of an otherwise empty panel.
pub fn empty(ui: &mut Ui, sentence: &str) {
    let rect = ui.available_rect_before_wrap().shrink(f32::from(PADDING) * 2.0);
    let builder = UiBuilder::new().max_rect(rect).layout(Layout::centered_and_justified(egui::Direction::TopDown));
    ui.scope_builder(builder, |ui| ui.label(RichText::new(sentence).weak()));
}
