//! Opening scenes.

use super::Commands;
use crate::app::workbench::Workbench;
use egui::{Context, Key, KeyboardShortcut, Modifiers};

/// A command about the scene as a whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SceneCommand {
    /// Opens a file.
    Open,
}

impl Commands for SceneCommand {
    const ALL: &'static [Self] = &[Self::Open];

    fn word(self) -> &'static str {
        match self {
            Self::Open => "scene-open",
        }
    }

    fn key(self) -> Option<KeyboardShortcut> {
        match self {
            Self::Open => Some(KeyboardShortcut::new(Modifiers::COMMAND, Key::O)),
        }
    }

    fn is_possible(self, _workbench: &Workbench) -> bool {
        true
    }

    fn run(self, workbench: &mut Workbench, ctx: &Context) {
        match self {
            Self::Open => workbench.dialog.open(ctx),
        }
    }
}
