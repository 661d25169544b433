//! The panels of drawings together: one place for what is drawn, clicked and dragged.

use super::linked::{Linked, LinkedPane};
use super::overview::OverviewPane;
use super::signs::SignsPane;
use crate::app::frame::empty::empty;
use crate::app::frame::words::say;
use crate::app::pane::Pane;
use crate::app::story::recording::Recording;
use crate::record::EventId;
use egui::Ui;

/// All of them.
pub struct Drawings {
    overview: OverviewPane,
    signs: SignsPane,
    generic: LinkedPane,
    intervals: LinkedPane,
    snell: LinkedPane,
    shading: LinkedPane,
    planes: LinkedPane,
}

impl Default for Drawings {
    fn default() -> Self {
        Self {
            overview: OverviewPane::default(),
            signs: SignsPane::default(),
            generic: LinkedPane::new(Linked::Generic),
            intervals: LinkedPane::new(Linked::Intervals),
            snell: LinkedPane::new(Linked::Snell),
            shading: LinkedPane::new(Linked::Shading),
            planes: LinkedPane::new(Linked::Planes),
        }
    }
}

impl Drawings {
    /// Shows a panel; returns the event whose mark was clicked.
    pub fn ui(&mut self, ui: &mut Ui, pane: Pane, recording: Option<&mut Recording>) -> Option<EventId> {
        let Some(recording) = recording else {
            empty(ui, &say(ui.ctx(), &format!("{}-about", pane.word())));
            return None;
        };
        match pane {
            Pane::Overview => self.overview.ui(ui, recording),
            Pane::Signs => {
                self.signs.ui(ui, recording);
                None
            }
            _ => self.linked(pane)?.ui(ui, recording),
        }
    }

    /// The tools of a panel, from right to left.
    pub fn tools(&mut self, ui: &mut Ui, pane: Pane, recording: Option<&mut Recording>) {
        match pane {
            Pane::Overview => self.overview.tools(ui),
            Pane::Signs => SignsPane::tools(ui, recording),
            _ => {
                if let Some(pane) = self.linked(pane) {
                    pane.tools(ui);
                }
            }
        }
    }

    /// How the overview is turned: yaw and pitch in degrees, and the zoom. None where one looks through the scene's own camera.
    #[must_use]
    pub fn orbit(&self) -> Option<[f64; 3]> {
        self.overview.orbit()
    }

    /// Turns the overview so.
    pub fn turn_to(&mut self, orbit: [f64; 3]) {
        self.overview.turn_to(orbit);
    }

    fn linked(&mut self, pane: Pane) -> Option<&mut LinkedPane> {
        match pane {
            Pane::Generic => Some(&mut self.generic),
            Pane::Intervals => Some(&mut self.intervals),
            Pane::Snell => Some(&mut self.snell),
            Pane::Shading => Some(&mut self.shading),
            Pane::Planes => Some(&mut self.planes),
            _ => None,
        }
    }
}
