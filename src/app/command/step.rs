//! Moving through the story, playing it, and how much of it is told.

use super::Commands;
use crate::app::story::stepping::Drawer;
use crate::app::workbench::Workbench;
use crate::story::{Level, Step, Story};
use egui::{Context, Key, KeyboardShortcut, Modifiers};

/// A command about the story.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepCommand {
    /// Moves the selection.
    Move(Step),
    /// Plays, or pauses.
    Play,
    /// Plays faster.
    Faster,
    /// Plays slower.
    Slower,
    /// Asks for the number of a step to go to.
    Jump,
    /// Tells so much.
    Level(Level),
    /// Shows the filter, or hides it.
    Filter,
    /// Looks for nothing any more.
    ClearFilter,
    /// Shows the breakpoints, or hides them.
    Breakpoints,
    /// Goes through the pixels to the first at which a breakpoint stops.
    Until,
    /// Shows what was left out, or hides it.
    LeftOut,
    /// Opens all rows.
    OpenAll,
    /// Closes all rows.
    CloseAll,
}

impl Commands for StepCommand {
    const ALL: &'static [Self] = &[
        Self::Move(Step::First),
        Self::Move(Step::Back),
        Self::Move(Step::Next),
        Self::Move(Step::Into),
        Self::Move(Step::Over),
        Self::Move(Step::Out),
        Self::Move(Step::Last),
        Self::Move(Step::PreviousSame),
        Self::Move(Step::NextSame),
        Self::Move(Step::PreviousStop),
        Self::Move(Step::NextStop),
        Self::Jump,
        Self::Play,
        Self::Faster,
        Self::Slower,
        Self::Level(Level::Story),
        Self::Level(Level::Working),
        Self::Level(Level::Everything),
        Self::Filter,
        Self::ClearFilter,
        Self::Breakpoints,
        Self::Until,
        Self::LeftOut,
        Self::OpenAll,
        Self::CloseAll,
    ];

    fn word(self) -> &'static str {
        match self {
            Self::Move(step) => word_of(step),
            Self::Play => "step-play",
            Self::Faster => "step-faster",
            Self::Slower => "step-slower",
            Self::Jump => "step-jump",
            Self::Level(Level::Story) => "step-level-story",
            Self::Level(Level::Working) => "step-level-working",
            Self::Level(Level::Everything) => "step-level-everything",
            Self::Filter => "step-filter",
            Self::ClearFilter => "step-filter-clear",
            Self::Breakpoints => "step-breakpoints",
            Self::Until => "step-until",
            Self::LeftOut => "step-left-out",
            Self::OpenAll => "step-open-all",
            Self::CloseAll => "step-close-all",
        }
    }

    fn key(self) -> Option<KeyboardShortcut> {
        let (modifiers, key) = match self {
            Self::Move(step) => key_of(step),
            Self::Play => (Modifiers::NONE, Key::P),
            Self::Faster => (Modifiers::NONE, Key::Period),
            Self::Slower => (Modifiers::NONE, Key::Comma),
            Self::Jump => (Modifiers::COMMAND, Key::G),
            Self::Level(Level::Story) => (Modifiers::NONE, Key::Num1),
            Self::Level(Level::Working) => (Modifiers::NONE, Key::Num2),
            Self::Level(Level::Everything) => (Modifiers::NONE, Key::Num3),
            Self::Filter => (Modifiers::NONE, Key::Slash),
            Self::Breakpoints => (Modifiers::COMMAND, Key::B),
            Self::Until => (Modifiers::NONE, Key::U),
            Self::LeftOut => (Modifiers::NONE, Key::L),
            Self::OpenAll => (Modifiers::NONE, Key::E),
            Self::CloseAll => (Modifiers::SHIFT, Key::E),
            Self::ClearFilter => return None,
        };
        Some(KeyboardShortcut::new(modifiers, key))
    }

    fn is_possible(self, workbench: &Workbench) -> bool {
        let story = || workbench.recording().map(super::super::story::recording::Recording::story);
        match self {
            Self::Move(step) => story().is_some_and(|story| story.target(step).is_some()),
            Self::ClearFilter => !workbench.stepping.filter.is_empty(),
            Self::Level(_) | Self::Faster | Self::Slower => true,
            _ => story().is_some(),
        }
    }

    fn is_on(self, workbench: &Workbench) -> Option<bool> {
        let stepping = &workbench.stepping;
        let open = |drawer| Some(stepping.drawer == Some(drawer));
        match self {
            Self::Play => Some(stepping.is_playing()),
            Self::Level(level) => Some(stepping.level == level),
            Self::Filter => open(Drawer::Filter),
            Self::Breakpoints => open(Drawer::Breakpoints),
            Self::LeftOut => open(Drawer::LeftOut),
            _ => None,
        }
    }

    fn run(self, workbench: &mut Workbench, _ctx: &Context) {
        match self {
            Self::Move(step) => workbench.change_story(|story| {
                story.step(step);
            }),
            Self::Play => workbench.toggle_play(),
            Self::Faster => workbench.stepping.player.change_speed(true),
            Self::Slower => workbench.stepping.player.change_speed(false),
            Self::Jump => workbench.toggle_drawer(Drawer::Jump),
            Self::Level(level) => workbench.set_level(level),
            Self::Filter => workbench.toggle_drawer(Drawer::Filter),
            Self::ClearFilter => workbench.set_filter(crate::story::Filter::default()),
            Self::Breakpoints => workbench.toggle_drawer(Drawer::Breakpoints),
            Self::Until => workbench.record_until(),
            Self::LeftOut => workbench.toggle_drawer(Drawer::LeftOut),
            Self::OpenAll => workbench.change_story(|story| story.set_all_open(true)),
            Self::CloseAll => workbench.change_story(|story| story.set_all_open(false)),
        }
    }
}

impl Workbench {
    fn change_story(&mut self, change: impl FnOnce(&mut Story)) {
        if let Some(recording) = &mut self.recording {
            recording.change(change);
        }
    }
}

const fn word_of(step: Step) -> &'static str {
    match step {
        Step::First => "step-first",
        Step::Back => "step-back",
        Step::Next => "step-next",
        Step::Into => "step-into",
        Step::Over => "step-over",
        Step::Out => "step-out",
        Step::Last => "step-last",
        Step::PreviousSame => "step-previous-same",
        Step::NextSame => "step-next-same",
        Step::PreviousStop => "step-previous-stop",
        Step::NextStop => "step-next-stop",
    }
}

const fn key_of(step: Step) -> (Modifiers, Key) {
    match step {
        Step::First => (Modifiers::NONE, Key::Home),
        Step::Back => (Modifiers::NONE, Key::B),
        Step::Next => (Modifiers::NONE, Key::N),
        Step::Into => (Modifiers::NONE, Key::I),
        Step::Over => (Modifiers::NONE, Key::V),
        Step::Out => (Modifiers::NONE, Key::O),
        Step::Last => (Modifiers::NONE, Key::End),
        Step::PreviousSame => (Modifiers::SHIFT, Key::K),
        Step::NextSame => (Modifiers::NONE, Key::K),
        Step::PreviousStop => (Modifiers::SHIFT, Key::C),
        Step::NextStop => (Modifiers::NONE, Key::C),
    }
}
