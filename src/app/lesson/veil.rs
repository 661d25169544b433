//! While a step's questions are open, drawings that it does not show itself wait with its story: left in front by an earlier step,
//! they would tell the answers.

use super::open::OpenLesson;
use super::question::Asked;
use crate::app::frame::theme::PADDING;
use crate::app::frame::words::say;
use crate::app::pane::Pane;
use crate::app::workbench::Workbench;
use crate::lesson::model::Surface;
use crate::lesson::question::Form;
use egui::{Ui, UiBuilder};

/// The panels that tell what happened to the ray.
const DRAWINGS: [Pane; 10] = [
    Pane::Detail,
    Pane::Side,
    Pane::Overview,
    Pane::Generic,
    Pane::Along,
    Pane::Intervals,
    Pane::Signs,
    Pane::Snell,
    Pane::Shading,
    Pane::Planes,
];

impl Workbench {
    /// Whether a panel waits for the answers to a step's questions.
    #[must_use]
    pub fn is_veiled(&self, pane: Pane) -> bool {
        let has_veil = self.recording.as_ref().is_some_and(|recording| recording.veil.is_some());
        has_veil && self.lesson.open.as_ref().is_some_and(|open| open.keeps_back(pane))
    }

    /// What is shown instead of a panel that waits, with the way to have it at once.
    pub(in crate::app) fn veil_pane(&mut self, ui: &mut Ui) {
        let rect = ui.available_rect_before_wrap().shrink(f32::from(PADDING));
        let text = say(ui.ctx(), "lesson-veil");
        let lifts = ui.scope_builder(UiBuilder::new().max_rect(rect), |ui| ui.link(text).clicked()).inner;
        if let Some(recording) = self.recording.as_mut().filter(|_| lifts) {
            recording.veil = None;
        }
    }
}

impl OpenLesson {
    /// Whether a panel would tell more than the step does: all drawings but those that it shows, or that it is answered in; and
    /// whatever it opens only with the answers.
    fn keeps_back(&self, pane: Pane) -> bool {
        let Some(staged) = self.staged() else { return false };
        let waits = DRAWINGS.contains(&pane) || staged.after.contains(&pane);
        waits && !staged.views.contains(&pane) && !self.asked.iter().any(|asked| is_answered_in(asked, pane))
    }
}

fn is_answered_in(asked: &Asked, pane: Pane) -> bool {
    match asked.posed.form {
        Form::Place(Surface::Side, _) => pane == Pane::Side,
        Form::Time(_) => pane == Pane::Signs,
        _ => false,
    }
}
