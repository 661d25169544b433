//! Everything that can be asked of the workbench by a menu, a key or the palette, in one list.
//!
//! Each area has a file with an enum of its own, which implements [`Commands`]. Menus, keys, the palette, the help and the tests are made
//! from [`Command::all`], so that none of them can lack one.

mod compare;
mod edit;
mod help;
mod lesson;
mod scene;
mod search;
mod share;
mod step;
mod view;

pub use compare::CompareCommand;
pub use edit::EditCommand;
pub use help::HelpCommand;
pub use lesson::LessonCommand;
pub use scene::SceneCommand;
pub use search::SearchCommand;
pub use share::ShareCommand;
pub use step::StepCommand;
pub use view::ViewCommand;

use crate::app::pane::Pane;
use crate::app::workbench::Workbench;
use egui::{Context, Event, KeyboardShortcut};

/// The commands of one area.
pub trait Commands: Copy + 'static {
    /// All of them, in the order of menus.
    const ALL: &'static [Self];

    /// Its name in the catalogue of words; with `-about` behind it, that of what it does.
    fn word(self) -> &'static str;

    /// The name, in the catalogue of words, of the group within its menu that it belongs to, if it has one. What has the same name
    /// in two groups is told apart by it.
    fn group(self) -> Option<&'static str> {
        None
    }

    /// The key that gives it.
    fn key(self) -> Option<KeyboardShortcut>;

    /// Whether there is anything for it to do.
    fn is_possible(self, workbench: &Workbench) -> bool;

    /// Whether it is switched on, if it is something that is switched.
    fn is_on(self, _workbench: &Workbench) -> Option<bool> {
        None
    }

    /// Does it.
    fn run(self, workbench: &mut Workbench, ctx: &Context);
}

/// One line for each area, in the order of menus: the variant, its commands, and the name of the menu in the catalogue of words.
macro_rules! areas {
    ($($area:ident($commands:ty) = $word:literal),+ $(,)?) => {
        $(impl From<$commands> for Command {
            fn from(command: $commands) -> Self {
                Self::$area(command)
            }
        })+

        /// A command of any area.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Command {
            $(#[doc = concat!("One of `", stringify!($commands), "`.")] $area($commands)),+
        }

        impl Command {
            /// The areas with their commands: the name of the menu in the catalogue of words, and what is in it.
            #[must_use]
            pub fn areas() -> Vec<(&'static str, Vec<Self>)> {
                vec![$(($word, <$commands>::ALL.iter().map(|&command| Self::$area(command)).collect())),+]
            }

            /// Its name in the catalogue of words; with `-about` behind it, that of what it does.
            #[must_use]
            pub fn word(self) -> &'static str {
                match self { $(Self::$area(command) => command.word()),+ }
            }

            /// The name of its group within its menu in the catalogue of words, if it has one.
            #[must_use]
            pub fn group(self) -> Option<&'static str> {
                match self { $(Self::$area(command) => command.group()),+ }
            }

            /// The key that gives it.
            #[must_use]
            pub fn key(self) -> Option<KeyboardShortcut> {
                match self { $(Self::$area(command) => command.key()),+ }
            }

            /// Whether there is anything for it to do.
            #[must_use]
            pub fn is_possible(self, workbench: &Workbench) -> bool {
                if workbench.is_read_only() && self.leaves_what_is_shown() {
                    return false;
                }
                match self { $(Self::$area(command) => command.is_possible(workbench)),+ }
            }

            /// Whether it is switched on, if it is something that is switched.
            #[must_use]
            pub fn is_on(self, workbench: &Workbench) -> Option<bool> {
                match self { $(Self::$area(command) => command.is_on(workbench)),+ }
            }

            /// Does it.
            pub fn run(self, workbench: &mut Workbench, ctx: &Context) {
                match self { $(Self::$area(command) => command.run(workbench, ctx)),+ }
            }
        }
    };
}

areas! {
    Scene(SceneCommand) = "menu-scene",
    Edit(EditCommand) = "menu-edit",
    Step(StepCommand) = "menu-step",
    Lesson(LessonCommand) = "menu-lesson",
    Search(SearchCommand) = "menu-search",
    Compare(CompareCommand) = "menu-compare",
    View(ViewCommand) = "menu-view",
    Share(ShareCommand) = "menu-share",
    Help(HelpCommand) = "menu-help",
}

impl Command {
    /// All commands, in the order of menus.
    #[must_use]
    pub fn all() -> Vec<Self> {
        Self::areas().into_iter().flat_map(|(_, commands)| commands).collect()
    }

    /// Whether it changes the scene or goes to another one, which a step within somebody's page does not.
    fn leaves_what_is_shown(self) -> bool {
        match self {
            Self::Scene(_) | Self::Edit(_) | Self::Lesson(_) | Self::Share(ShareCommand::OpenLink) => true,
            Self::View(ViewCommand::Pane(pane)) => [Pane::Editor, Pane::Properties, Pane::Lesson].contains(&pane),
            _ => false,
        }
    }
}

/// The command whose key was pressed. While a text is typed, keys without Ctrl or Alt belong to it.
pub fn pressed(ctx: &Context, workbench: &Workbench) -> Option<Command> {
    let is_pressed = |event: &Event| matches!(event, Event::Key { pressed: true, .. });
    if !ctx.input(|input| input.events.iter().any(is_pressed)) {
        return None;
    }
    let is_typing = ctx.text_edit_focused();
    let mut keyed: Vec<(Command, KeyboardShortcut)> =
        Command::all().into_iter().filter_map(|command| command.key().map(|key| (command, key))).collect();
    // With more modifiers first: what is asked for with Shift is not also asked for without.
    keyed.sort_by_key(|(_, key)| std::cmp::Reverse(modifiers(key)));
    let is_meant = |command: Command, key: &KeyboardShortcut| {
        let is_free = !is_typing || key.modifiers.command || key.modifiers.alt || is_function_key(key);
        is_free && command.is_possible(workbench)
    };
    let found = keyed
        .into_iter()
        .find(|(command, key)| is_meant(*command, key) && ctx.input_mut(|input| input.consume_shortcut(key)));
    found.map(|(command, _)| command)
}

fn modifiers(key: &KeyboardShortcut) -> u32 {
    let modifiers = key.modifiers;
    u32::from(modifiers.shift) + u32::from(modifiers.alt) + u32::from(modifiers.command)
}

fn is_function_key(key: &KeyboardShortcut) -> bool {
    key.logical_key.name().strip_prefix('F').is_some_and(|number| number.parse::<u8>().is_ok())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{Language, has};

    #[test]
    fn no_key_gives_two_commands() {
        let all = Command::all();
        for (i, command) in all.iter().enumerate() {
            let Some(key) = command.key() else { continue };
            let same = all[i + 1..].iter().find(|other| other.key() == Some(key));
            assert_eq!(same, None, "{command:?} has the same key");
        }
    }

    #[test]
    fn every_command_has_a_name_and_says_what_it_does() {
        for command in Command::all() {
            for id in [command.word().to_owned(), format!("{}-about", command.word())] {
                assert!(has(Language::English, &id), "{id}");
            }
        }
        for (menu, _) in Command::areas() {
            assert!(has(Language::English, menu), "{menu}");
        }
    }
}
