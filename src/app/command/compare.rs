//! Comparing stories.

use super::Commands;
use crate::app::pane::Pane;
use crate::app::workbench::Workbench;
use egui::{Context, Key, KeyboardShortcut, Modifiers};

/// A command about comparing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CompareCommand {
    /// Keeps the story that is shown.
    Pin,
    /// Takes the pinned story away.
    Unpin,
    /// Goes on to the next difference.
    Next,
    /// Goes back to the difference before.
    Previous,
    /// Opens what another ray tracer printed.
    Open,
}

impl Commands for CompareCommand {
    const ALL: &'static [Self] = &[Self::Pin, Self::Unpin, Self::Next, Self::Previous, Self::Open];

    fn word(self) -> &'static str {
        match self {
            Self::Pin => "compare-pin",
            Self::Unpin => "compare-unpin",
            Self::Next => "compare-next",
            Self::Previous => "compare-previous",
            Self::Open => "compare-open",
        }
    }

    fn key(self) -> Option<KeyboardShortcut> {
        match self {
            Self::Pin => Some(KeyboardShortcut::new(Modifiers::COMMAND, Key::D)),
            Self::Next => Some(KeyboardShortcut::new(Modifiers::NONE, Key::F7)),
            Self::Previous => Some(KeyboardShortcut::new(Modifiers::SHIFT, Key::F7)),
            Self::Unpin | Self::Open => None,
        }
    }

    fn is_possible(self, workbench: &Workbench) -> bool {
        match self {
            Self::Pin => workbench.recording.is_some(),
            Self::Unpin => workbench.compare.pins() > 0,
            Self::Next | Self::Previous => workbench.compare.has_stories(),
            Self::Open => workbench.open.is_some(),
        }
    }

    fn run(self, workbench: &mut Workbench, ctx: &Context) {
        workbench.dock.reveal(Pane::Compare);
        match self {
            Self::Pin => workbench.pin_story(),
            Self::Unpin => workbench.compare.unpin(),
            Self::Next | Self::Previous => {
                if let Some(wish) = workbench.compare.go(self == Self::Next) {
                    workbench.grant_comparison(wish);
                }
            }
            Self::Open => workbench.compare.ask_for_foreign(ctx),
        }
    }
}
