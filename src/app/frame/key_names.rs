//! Names of keys as they stand on a keyboard of the language that is set.

use super::words::say;
use egui::{Context, KeyboardShortcut};

/// The parts of egui's names that are said otherwise, with the messages that say them.
const SAID: [(&str, &str); 22] = [
    ("Ctrl", "key-control"),
    ("Shift", "key-shift"),
    ("Space", "key-space"),
    ("Enter", "key-enter"),
    ("Escape", "key-escape"),
    ("Tab", "key-tab"),
    ("Backspace", "key-backspace"),
    ("Delete", "key-delete"),
    ("Home", "key-home"),
    ("End", "key-end"),
    ("PageUp", "key-page-up"),
    ("PageDown", "key-page-down"),
    ("Up", "key-up"),
    ("Down", "key-down"),
    ("Left", "key-left"),
    ("Right", "key-right"),
    ("Period", "key-period"),
    ("Comma", "key-comma"),
    ("Slash", "key-slash"),
    ("Plus", "key-plus"),
    ("Minus", "key-minus"),
    ("Equals", "key-equals"),
];

/// A shortcut as it is written in menus, such as "Ctrl+K".
#[must_use]
pub fn key_name(ctx: &Context, shortcut: KeyboardShortcut) -> String {
    let parts = ctx.format_shortcut(&shortcut);
    let said = parts.split('+').map(|part| {
        let message = SAID.iter().find(|(name, _)| *name == part).map(|(_, message)| *message);
        message.map_or_else(|| part.to_owned(), |message| say(ctx, message))
    });
    said.collect::<Vec<_>>().join("+")
}
