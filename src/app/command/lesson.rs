//! Lessons: opening one, going through its steps, answering.

use super::Commands;
use crate::app::pane::Pane;
use crate::app::workbench::Workbench;
use egui::{Context, Key, KeyboardShortcut, Modifiers};

/// A command about lessons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LessonCommand {
    /// Shows the course.
    Open,
    /// Goes on to the next step.
    Next,
    /// Goes back to the step before.
    Previous,
    /// Sets the scene and the ray of the step again.
    Restage,
    /// Judges the answer to the first question that is open.
    Check,
    /// Shows a hint for it.
    Hint,
    /// Shows the answer to it.
    Reveal,
    /// Writes what was done to a file.
    Export,
    /// Reads what was done from a file.
    Import,
    /// Forgets what was done, after asking.
    Reset,
}

impl Commands for LessonCommand {
    const ALL: &'static [Self] = &[
        Self::Open,
        Self::Next,
        Self::Previous,
        Self::Restage,
        Self::Check,
        Self::Hint,
        Self::Reveal,
        Self::Export,
        Self::Import,
        Self::Reset,
    ];

    fn word(self) -> &'static str {
        match self {
            Self::Open => "lesson-open",
            Self::Next => "lesson-next",
            Self::Previous => "lesson-previous",
            Self::Restage => "lesson-restage",
            Self::Check => "lesson-check",
            Self::Hint => "lesson-hint",
            Self::Reveal => "lesson-reveal",
            Self::Export => "lesson-export",
            Self::Import => "lesson-import",
            Self::Reset => "lesson-reset",
        }
    }

    fn key(self) -> Option<KeyboardShortcut> {
        let command = |key| Some(KeyboardShortcut::new(Modifiers::COMMAND, key));
        let shifted = |key| Some(KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), key));
        match self {
            Self::Open => Some(KeyboardShortcut::new(Modifiers::NONE, Key::F2)),
            Self::Next => command(Key::PageDown),
            Self::Previous => command(Key::PageUp),
            Self::Check => command(Key::Enter),
            Self::Hint => shifted(Key::H),
            Self::Reveal => shifted(Key::Enter),
            Self::Restage => shifted(Key::Backspace),
            Self::Export | Self::Import | Self::Reset => None,
        }
    }

    fn is_possible(self, workbench: &Workbench) -> bool {
        let place = workbench.lesson().place();
        match self {
            Self::Open | Self::Export | Self::Import | Self::Reset => true,
            Self::Next => place.is_some_and(|(_, step)| step + 1 < workbench.lesson().steps()),
            Self::Previous => place.is_some_and(|(_, step)| step > 0),
            Self::Restage => place.is_some(),
            Self::Check | Self::Hint | Self::Reveal => workbench.current_question().is_some(),
        }
    }

    fn run(self, workbench: &mut Workbench, ctx: &Context) {
        let step = workbench.lesson().place().map_or(0, |(_, step)| step);
        let question = workbench.current_question().unwrap_or_default();
        match self {
            Self::Open => {
                workbench.show_course();
                return;
            }
            Self::Next => workbench.go_to_step(step + 1),
            Self::Previous => workbench.go_to_step(step.saturating_sub(1)),
            Self::Restage => workbench.back_to_ray(ctx),
            Self::Check => workbench.check(ctx, question),
            Self::Hint => workbench.hint(question),
            Self::Reveal => workbench.reveal_answer(ctx, question),
            Self::Export => workbench.lesson.export(ctx),
            Self::Import => workbench.lesson.import(ctx),
            Self::Reset => {
                workbench.show_course();
                workbench.lesson.ask_to_reset();
                return;
            }
        }
        workbench.reveal(Pane::Lesson);
    }
}
