//! Finding pixels, and maps.

use super::Commands;
use crate::app::pane::Pane;
use crate::app::search::pane::word_of_map;
use crate::app::workbench::Workbench;
use crate::query::Quantity;
use egui::{Context, Key, KeyboardShortcut, Modifiers};

/// A command about searching the picture and about maps of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SearchCommand {
    /// Goes to the field for a question.
    Find,
    /// Goes to the next pixel that was found.
    Next,
    /// Goes to the pixel that was found before.
    Previous,
    /// Forgets what was found.
    Clear,
    /// Shows a map.
    Map(Quantity),
    /// Shows the picture without a map.
    NoMap,
}

impl Commands for SearchCommand {
    const ALL: &'static [Self] = &[
        Self::Find,
        Self::Next,
        Self::Previous,
        Self::Clear,
        Self::Map(Quantity::Rays),
        Self::Map(Quantity::Tests),
        Self::Map(Quantity::Depth),
        Self::Map(Quantity::Time),
        Self::Map(Quantity::Error),
        Self::Map(Quantity::Object),
        Self::Map(Quantity::Normal),
        Self::Map(Quantity::Digits),
        Self::NoMap,
    ];

    fn word(self) -> &'static str {
        match self {
            Self::Find => "search-find",
            Self::Next => "search-next",
            Self::Previous => "search-previous",
            Self::Clear => "search-clear",
            Self::Map(quantity) => word_of_map(quantity),
            Self::NoMap => "map-none",
        }
    }

    fn group(self) -> Option<&'static str> {
        matches!(self, Self::Map(_) | Self::NoMap).then_some("search-maps")
    }

    fn key(self) -> Option<KeyboardShortcut> {
        match self {
            Self::Find => Some(KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::F)),
            Self::Next => Some(KeyboardShortcut::new(Modifiers::NONE, Key::F3)),
            Self::Previous => Some(KeyboardShortcut::new(Modifiers::SHIFT, Key::F3)),
            Self::Clear | Self::Map(_) | Self::NoMap => None,
        }
    }

    fn is_possible(self, workbench: &Workbench) -> bool {
        match self {
            Self::Next | Self::Previous => workbench.search.count().is_some_and(|count| count > 0),
            Self::Clear => workbench.search.has_question(),
            Self::NoMap => workbench.search.map().is_some(),
            Self::Find | Self::Map(_) => workbench.scene().is_some(),
        }
    }

    fn is_on(self, workbench: &Workbench) -> Option<bool> {
        match self {
            Self::Map(quantity) => Some(workbench.search.map() == Some(quantity)),
            _ => None,
        }
    }

    fn run(self, workbench: &mut Workbench, _ctx: &Context) {
        match self {
            Self::Find => {
                workbench.reveal(Pane::Search);
                workbench.search.focus();
            }
            Self::Next | Self::Previous => {
                if let Some(place) = workbench.search.go(self == Self::Next) {
                    workbench.go_to(place);
                }
            }
            Self::Clear => workbench.search.clear(),
            Self::Map(quantity) => {
                workbench.reveal(Pane::Search);
                workbench.search.choose_map(Some(quantity));
            }
            Self::NoMap => workbench.search.choose_map(None),
        }
    }
}
