//! Help that lies over everything: the palette of commands, the table of keys, the tour of the first visit.

mod keys;
mod matching;
mod palette;
mod tour;

use crate::app::command::Command;
use crate::app::workbench::Workbench;
use egui::Ui;
use palette::Palette;
use tour::Tour;

/// What lies over the workbench, if anything.
#[derive(Default)]
pub enum Help {
    /// Nothing.
    #[default]
    None,
    /// The palette of commands.
    Palette(Palette),
    /// The table of keys.
    Keys,
    /// The tour.
    Tour(Tour),
}

/// What was chosen in it.
pub enum Outcome {
    /// It stays open.
    Stay,
    /// It was closed.
    Close,
    /// A command was chosen.
    Run(Command),
    /// A scene was chosen, by name.
    Open(String),
    /// A lesson was chosen, by name.
    Lesson(String),
}

impl Help {
    /// The palette, ready to be typed into.
    #[must_use]
    pub fn palette() -> Self {
        Self::Palette(Palette::default())
    }

    /// The tour from its beginning.
    #[must_use]
    pub fn tour() -> Self {
        Self::Tour(Tour::default())
    }
}

impl Workbench {
    /// Shows what lies over the workbench, and does what was chosen in it.
    pub(in crate::app) fn show_help(&mut self, ui: &mut Ui) {
        // The tour lies over everything, so it would lie over what has to be answered first: it waits.
        if matches!(self.help, Help::Tour(_)) && (self.has_question() || self.asks_for_link()) {
            return;
        }
        let mut help = std::mem::take(&mut self.help);
        let outcome = match &mut help {
            Help::None => return,
            Help::Palette(palette) => palette.ui(ui, self),
            Help::Keys => keys::ui(ui),
            Help::Tour(tour) => tour.ui(ui, self),
        };
        let is_tour = matches!(help, Help::Tour(_));
        match outcome {
            Outcome::Stay => {
                self.help = help;
                return;
            }
            Outcome::Close => {}
            Outcome::Run(command) => command.run(self, ui.ctx()),
            Outcome::Open(name) => self.open_scene(ui.ctx(), &name),
            Outcome::Lesson(id) => self.open_lesson(&id),
        }
        self.settings.is_toured |= is_tour;
    }
}
