//! The table of keys: every command that has one, by area, and the keys within panels.

use super::Outcome;
use crate::app::command::Command;
use crate::app::frame::key_names::key_name;
use crate::app::frame::theme::bold;
use crate::app::frame::words::say;
use egui::{Align, Id, Label, Layout, Modal, RichText, ScrollArea, Ui, vec2};

/// Width of the table, in points.
const WIDTH: f32 = 620.0;

/// Width of the column of keys, in points.
const KEYS: f32 = 186.0;

/// Keys that mean something within a panel: the panel, the keys as they are written, what they do.
const WITHIN: &[(&str, &str)] = &[
    ("keys-arrows", "keys-picture-arrows"),
    ("keys-shift-arrows", "keys-picture-shift-arrows"),
    ("keys-up-down", "keys-story-up-down"),
    ("keys-left-right", "keys-story-left-right"),
    ("keys-tab", "keys-everywhere-tab"),
    ("keys-escape", "keys-everywhere-escape"),
];

/// Shows the table.
pub fn ui(ui: &Ui) -> Outcome {
    let mut closed = false;
    let room = ui.ctx().content_rect();
    let width = WIDTH.min(room.width() - 60.0);
    let modal = Modal::new(Id::unique("keys")).show(ui.ctx(), |ui| {
        ui.set_width(width);
        ui.horizontal(|ui| {
            ui.label(RichText::new(say(ui.ctx(), "help-keys")).size(17.0).family(bold()));
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                closed = ui.button(say(ui.ctx(), "close")).clicked();
            });
        });
        let height = room.height() - 120.0;
        ScrollArea::vertical()
            .max_height(height)
            .min_scrolled_height(height)
            .auto_shrink([false, true])
            .show(ui, table);
    });
    if closed || modal.should_close() { Outcome::Close } else { Outcome::Stay }
}

fn table(ui: &mut Ui) {
    for (menu, commands) in Command::areas() {
        let keyed: Vec<_> = commands.into_iter().filter_map(|command| Some((command, command.key()?))).collect();
        if keyed.is_empty() {
            continue;
        }
        heading(ui, menu);
        for (command, key) in keyed {
            row(ui, &key_name(ui.ctx(), key), &format!("{}-about", command.word()));
        }
    }
    heading(ui, "keys-within");
    for (keys, about) in WITHIN {
        row(ui, &say(ui.ctx(), keys), about);
    }
}

/// The keys, and beside them in as many lines as they need what they do.
fn row(ui: &mut Ui, keys: &str, about: &str) {
    ui.horizontal_top(|ui| {
        let column = vec2(KEYS, ui.spacing().interact_size.y);
        ui.allocate_ui_with_layout(column, Layout::left_to_right(Align::Min), |ui| {
            ui.set_min_width(KEYS);
            ui.label(RichText::new(keys).monospace());
        });
        ui.add(Label::new(say(ui.ctx(), about)).wrap());
    });
}

fn heading(ui: &mut Ui, word: &str) {
    ui.add_space(8.0);
    ui.label(RichText::new(say(ui.ctx(), word)).family(bold()));
}
