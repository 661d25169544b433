//! Lessons: Markdown whose numbers come from recorded rays, with questions that are judged by them.
//!
//! `lessons/GUIDE.md` says how one is written. A file is read into a [`Lesson`] ([`read`]); a step is set up as a [`Stage`], with its
//! rays recorded; its text is told with its values put in, and its questions are posed and judged ([`Posed`]). The workbench, the book and the
//! check go the same way.

pub mod expression;
pub mod model;
pub mod prose;
pub mod question;

mod check;
mod course;
mod exam;
mod glossary;
mod place;
mod progress;
mod scenes;
mod source;
mod stage;
mod table;

pub use check::{Checked, check_course, check_in_course, check_lesson};
pub use course::{Course, EMBEDDED, LessonText};
pub use exam::{Before, Exam, ExamQuestion};
pub use glossary::{Glossary, Term};
pub use model::{Lesson, Part, Step};
pub use place::{Finding, Findings, Place};
pub use progress::{LessonProgress, Progress, Record};
pub use prose::Told;
pub use question::{Answer, Posed, Verdict};
pub use scenes::{Compiled, NoShelf, Scenes, Shelf, changed};
pub use source::{lesson_schema, read};
pub use stage::Stage;
pub use table::ToldTable;
