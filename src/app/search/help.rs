//! The words of the language as a table; a click puts one into the field.

use crate::app::frame::words::say;
use crate::query::{PRESETS, TermKind, terms};
use egui::{Button, Label, RichText, ScrollArea, Ui};

/// Shows the words; returns the question that was clicked.
pub fn ui(ui: &mut Ui) -> Option<String> {
    let mut chosen = None;
    ScrollArea::vertical().id_salt("search words").auto_shrink([false, false]).show(ui, |ui| {
        ui.add(Label::new(RichText::new(say(ui.ctx(), "search-language")).weak()).wrap());
        ui.add_space(6.0);
        heading(ui, "search-presets");
        for preset in PRESETS {
            if line(ui, preset.query, &say(ui.ctx(), &preset.word())) {
                chosen = Some(preset.query.to_owned());
            }
        }
        for (kind, title) in [
            (TermKind::Word, "search-words-plain"),
            (TermKind::Names, "search-words-names"),
            (TermKind::Numbers, "search-words-numbers"),
            (TermKind::Group, "search-words-group"),
        ] {
            heading(ui, title);
            for term in terms().filter(|term| term.kind() == kind) {
                if line(ui, term.example, term.meaning) {
                    chosen = Some(term.example.to_owned());
                }
            }
        }
    });
    chosen
}

fn heading(ui: &mut Ui, word: &str) {
    ui.add_space(8.0);
    ui.label(RichText::new(say(ui.ctx(), word)).strong());
}

/// A question and what it means; returns whether it was clicked.
fn line(ui: &mut Ui, question: &str, meaning: &str) -> bool {
    ui.horizontal_wrapped(|ui| {
        let clicked = ui.add(Button::new(RichText::new(question).monospace()).small()).clicked();
        ui.add(Label::new(RichText::new(meaning).small().weak()).wrap());
        clicked
    })
    .inner
}
