//! What a panel says when it has nothing to show.

use crate::app::frame::theme::PADDING;
use egui::text::LayoutJob;
use egui::{Align, Align2, Label, Layout, RichText, TextStyle, Ui, UiBuilder};

/// A plain sentence in the middle of an otherwise empty panel.
pub fn empty(ui: &mut Ui, sentence: &str) {
    let rect = ui.available_rect_before_wrap().shrink(f32::from(PADDING) * 2.0);
    let font = TextStyle::Body.resolve(ui.style());
    let job = LayoutJob::simple(sentence.to_owned(), font, ui.visuals().weak_text_color(), rect.width());
    let size = ui.ctx().fonts_mut(|fonts| fonts.layout_job(job)).size();
    let top = Align2::CENTER_CENTER.align_size_within_rect(size, rect).top().max(rect.top());
    // Centred line by line: a layout that fills the panel would pull the words of a line apart.
    let builder = UiBuilder::new().max_rect(rect.with_min_y(top)).layout(Layout::top_down(Align::Center));
    ui.scope_builder(builder, |ui| ui.add(Label::new(RichText::new(sentence).weak()).wrap()));
}
