//! Moving through the story.

use super::Commands;
use crate::app::story::stepper::Step;
use crate::app::workbench::Workbench;
use egui::{Context, KeyboardShortcut, Modifiers};

/// A command that moves the selection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepCommand(pub Step);

impl Commands for StepCommand {
    const ALL: &'static [Self] = &[
        Self(Step::First),
        Self(Step::Back),
        Self(Step::Next),
        Self(Step::Into),
        Self(Step::Over),
        Self(Step::Out),
        Self(Step::Last),
    ];

    fn word(self) -> &'static str {
        match self.0 {
            Step::First => "step-first",
            Step::Back => "step-back",
            Step::Next => "step-next",
            Step::Into => "step-into",
            Step::Over => "step-over",
            Step::Out => "step-out",
            Step::Last => "step-last",
        }
    }

    fn key(self) -> Option<KeyboardShortcut> {
        Some(KeyboardShortcut::new(Modifiers::NONE, self.0.key()))
    }

    fn is_possible(self, workbench: &Workbench) -> bool {
        let recording = workbench.recording();
        recording.is_some_and(|recording| self.0.target(&recording.tree, recording.selected()).is_some())
    }

    fn run(self, workbench: &mut Workbench, _ctx: &Context) {
        if let Some(recording) = &mut workbench.recording {
            recording.step(self.0);
        }
    }
}
