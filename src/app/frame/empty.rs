//! What a panel says when it has nothing to show.

use crate::app::frame::theme::PADDING;
use egui::{Layout, RichText, Ui, UiBuilder};

/// A plain sentence in the middle of an otherwise empty panel.
pub fn empty(ui: &mut Ui, sentence: &str) {
    let rect = ui.available_rect_before_wrap().shrink(f32::from(PADDING) * 2.0);
    let builder = UiBuilder::new().max_rect(rect).layout(Layout::centered_and_justified(egui::Direction::TopDown));
    ui.scope_builder(builder, |ui| ui.label(RichText::new(sentence).weak()));
}
