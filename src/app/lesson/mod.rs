//! Lessons in the workbench: the course, the steps of a lesson with what they tell and ask, and what they do to the other panels.

mod answering;
mod course_list;
mod course_map;
mod glue;
mod judging;
pub mod marks;
mod onward;
mod open;
pub mod pane;
mod progress_file;
mod question;
mod staged;
mod step;
mod text;
mod told;
mod trial;
mod veil;
mod watch;

pub use pane::LessonPane;
