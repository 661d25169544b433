//! The workbench: the picture, the ray's story, the side view and the plots, all looking at one selected event.
//!
//! Everything but `window` and `system` is built on `egui` alone, so that tests use it without a window. Nothing
//! here computes anything about rays: it shows what [`trace`](crate::trace) recorded and what [`view`](crate::view)
//! made of it.

mod accuracy;
mod command;
mod compare;
mod dock;
mod drawings;
mod edit;
mod effects;
mod frame;
mod help;
mod kept;
mod layout;
mod lesson;
mod opening;
mod pane;
mod panes;
mod picture;
mod search;
mod settings;
mod share;
mod story;
mod system;
mod window;
mod workbench;

pub use command::{
    Command, Commands, CompareCommand, EditCommand, HelpCommand, LessonCommand, SceneCommand, SearchCommand,
    ShareCommand, StepCommand, ViewCommand,
};
pub use dock::{Dock, Preset};
pub use lesson::LessonPane;
pub use pane::Pane;
pub use settings::Settings;
pub use share::{Aim, Ending, Product};
pub use story::recording::{HitMark, Recording};
pub use story::stepping::Stepping;
#[cfg(target_arch = "wasm32")]
pub use system::run_in_browser;
#[cfg(not(target_arch = "wasm32"))]
pub use system::{run, run_lesson};
pub use workbench::{Look, OpenScene, Problem, Workbench};
