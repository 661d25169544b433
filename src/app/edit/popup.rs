//! The list of what can be written at the cursor, below it.

use crate::app::frame::theme::Palette;
use crate::app::frame::words::say;
use crate::document::{Completion, Item, Syntax, complete};
use egui::{Area, Button, EventFilter, Frame, Key, Modifiers, Order, Pos2, RichText, Role, ScrollArea, Ui, WidgetInfo};

/// Width of the list, in points.
const WIDTH: f32 = 260.0;
/// Height above which the list scrolls, in points.
const HEIGHT: f32 = 180.0;

/// The list, open or not.
#[derive(Debug, Default)]
pub struct Popup {
    completion: Option<Completion>,
    selected: usize,
    moved: bool,
}

impl Popup {
    /// Opens the list for the cursor; it stays closed where nothing may be written.
    pub fn open(&mut self, text: &str, syntax: &Syntax, offset: usize) {
        let completion = complete(text, syntax, offset);
        let word = text.get(completion.word.clone()).unwrap_or_default();
        let is_written = matches!(&completion.items[..], [only] if only.text == word);
        self.completion = (!completion.items.is_empty() && !is_written).then_some(completion);
        self.selected = 0;
    }

    /// Closes it.
    pub fn close(&mut self) {
        self.completion = None;
    }

    /// Whether it is seen.
    #[must_use]
    pub const fn is_open(&self) -> bool {
        self.completion.is_some()
    }

    /// What the text does with Tab and Escape: while the list is open, they are its own.
    #[must_use]
    pub const fn filter(&self) -> EventFilter {
        let open = self.is_open();
        EventFilter { tab: open, escape: open, horizontal_arrows: true, vertical_arrows: true }
    }

    /// Takes the keys that are meant for the list before the text sees them; returns what was accepted.
    pub fn keys(&mut self, ui: &Ui) -> Option<(Completion, Item)> {
        let count = self.completion.as_ref()?.items.len();
        let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
        let before = self.selected;
        if pressed(Key::ArrowDown) {
            self.selected = (self.selected + 1) % count;
        }
        if pressed(Key::ArrowUp) {
            self.selected = (self.selected + count - 1) % count;
        }
        self.moved = before != self.selected;
        if pressed(Key::Escape) {
            self.close();
            return None;
        }
        if pressed(Key::Enter) || pressed(Key::Tab) { self.accept(self.selected) } else { None }
    }

    fn accept(&mut self, index: usize) -> Option<(Completion, Item)> {
        let completion = self.completion.take()?;
        let item = completion.items.get(index).cloned()?;
        Some((completion, item))
    }

    /// Shows the list at a place; returns what was clicked.
    pub fn ui(&mut self, ui: &Ui, at: Pos2) -> Option<(Completion, Item)> {
        let completion = self.completion.as_ref()?;
        let (selected, moved) = (self.selected, self.moved);
        let area = Area::new(ui.scope_id().with("completion")).order(Order::Foreground).fixed_pos(at);
        let title = say(ui.ctx(), "edit-completion");
        let shown = area.constrain(true).show(ui.ctx(), |ui| {
            let list = Frame::popup(ui.style()).show(ui, |ui| {
                ui.set_width(WIDTH);
                let clicked =
                    ScrollArea::vertical().max_height(HEIGHT).show(ui, |ui| list(ui, completion, selected, moved));
                about(ui, completion.items.get(selected));
                clicked.inner
            });
            list.response.widget_info(|| WidgetInfo::labeled(Role::ListBox, true, &title));
            list.inner
        });
        let clicked = shown.inner?;
        self.accept(clicked)
    }
}

fn list(ui: &mut Ui, completion: &Completion, selected: usize, moved: bool) -> Option<usize> {
    let mut clicked = None;
    ui.spacing_mut().item_spacing.y = 1.0;
    let required = say(ui.ctx(), "edit-required");
    for (i, item) in completion.items.iter().enumerate() {
        let text = RichText::new(&item.label).monospace();
        let mut button = Button::selectable(i == selected, text).min_size(egui::vec2(ui.available_width(), 0.0));
        if item.required {
            button = button.right_text(RichText::new(&required).small().weak());
        }
        let response = ui.add(button);
        if i == selected && moved {
            response.scroll_to_me(None);
        }
        if response.clicked() {
            clicked = Some(i);
        }
    }
    clicked
}

fn about(ui: &mut Ui, item: Option<&Item>) {
    let Some(item) = item.filter(|item| !item.about.is_empty()) else { return };
    ui.separator();
    ui.label(RichText::new(&item.about).small().color(Palette::current(ui.ctx()).weak));
}
