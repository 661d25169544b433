//! The bar that finds words in the text.

use crate::app::frame::words::{say, say_with};
use crate::document::{Document, Selection, find_all};
use egui::{Id, Key, Modifiers, TextEdit, Ui};
use std::ops::Range;

/// The bar, open or not.
#[derive(Debug, Default)]
pub struct Finder {
    /// Whether it is seen.
    pub is_open: bool,
    wanted: String,
    wants_focus: bool,
    found: Vec<Range<usize>>,
    of: Option<(u64, String)>,
}

fn field() -> Id {
    Id::unique("find in the scene file")
}

impl Finder {
    /// Opens the bar and lets it be typed into.
    pub fn open(&mut self) {
        (self.is_open, self.wants_focus) = (true, true);
    }

    /// Where the text was found.
    #[must_use]
    pub fn found(&self) -> &[Range<usize>] {
        if self.is_open { &self.found } else { &[] }
    }

    fn search(&mut self, document: &Document) {
        let wanted = (document.revision(), self.wanted.clone());
        if self.of.as_ref() != Some(&wanted) {
            self.found = find_all(document.text(), &self.wanted);
            self.of = Some(wanted);
        }
    }

    /// Shows the bar; returns what is to be selected.
    pub fn ui(&mut self, ui: &mut Ui, document: &Document) -> Option<Selection> {
        if !self.is_open {
            return None;
        }
        self.search(document);
        let mut step = None;
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            ui.add_space(2.0);
            let label = ui.label(say(ui.ctx(), "edit-find"));
            let edit = TextEdit::singleline(&mut self.wanted).id(field()).desired_width(130.0);
            let response = ui.add(edit).labelled_by(label.id);
            if std::mem::take(&mut self.wants_focus) {
                response.request_focus();
            }
            if response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter)) {
                step = Some(!ui.input(|input| input.modifiers.matches_exact(Modifiers::SHIFT)));
                response.request_focus();
            }
            if response.has_focus() && ui.input(|input| input.key_pressed(Key::Escape)) {
                self.is_open = false;
            }
            if ui.button(say(ui.ctx(), "edit-find-previous")).clicked() {
                step = Some(false);
            }
            if ui.button(say(ui.ctx(), "edit-find-next")).clicked() {
                step = Some(true);
            }
            if !self.wanted.is_empty() {
                ui.label(say_with(ui.ctx(), "edit-found", &[("count", self.found.len().into())]));
            }
            if ui.button(say(ui.ctx(), "edit-close-find")).clicked() {
                self.is_open = false;
            }
        });
        self.search(document);
        step.and_then(|forward| self.next(document.selection(), forward))
    }

    fn next(&self, from: Selection, forward: bool) -> Option<Selection> {
        let range = from.range();
        let found = if forward {
            self.found.iter().find(|found| found.start >= range.end).or_else(|| self.found.first())
        } else {
            self.found.iter().rev().find(|found| found.end <= range.start).or_else(|| self.found.last())
        };
        found.map(|found| Selection { anchor: found.start, head: found.end })
    }
}
