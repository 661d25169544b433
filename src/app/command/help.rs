//! Finding one's way about the workbench.

use super::Commands;
use crate::app::help::Help;
use crate::app::workbench::Workbench;
use egui::{Context, Key, KeyboardShortcut, Modifiers};

/// A command that helps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HelpCommand {
    /// Finds any command by a few letters.
    Palette,
    /// Shows all keys.
    Keys,
    /// Takes the tour.
    Tour,
}

impl Commands for HelpCommand {
    const ALL: &'static [Self] = &[Self::Palette, Self::Keys, Self::Tour];

    fn word(self) -> &'static str {
        match self {
            Self::Palette => "help-palette",
            Self::Keys => "help-keys",
            Self::Tour => "help-tour",
        }
    }

    fn key(self) -> Option<KeyboardShortcut> {
        match self {
            Self::Palette => Some(KeyboardShortcut::new(Modifiers::COMMAND, Key::K)),
            Self::Keys => Some(KeyboardShortcut::new(Modifiers::NONE, Key::F1)),
            Self::Tour => None,
        }
    }

    fn is_possible(self, _workbench: &Workbench) -> bool {
        true
    }

    fn run(self, workbench: &mut Workbench, _ctx: &Context) {
        workbench.help = match self {
            Self::Palette => Help::palette(),
            Self::Keys => Help::Keys,
            Self::Tour => Help::tour(),
        };
    }
}
