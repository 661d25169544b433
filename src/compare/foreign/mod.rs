//! What another ray tracer says of a pixel, beside our own story of it: where it departs for the first time, and why.
//!
//! The other program prints lines of JSON ([`Line`]), as many as it likes. Our story of the same pixel is recorded without any
//! shortcut, so that every object has been asked; the lines are gone through beside it (`walk`), each number is compared
//! (`check`) within what is allowed (`allowance`), and the first departure in the order of our story is explained by known
//! mistakes, each of them worked out (`causes`).

mod allowance;
mod causes;
mod check;
mod line;
mod ours;
mod read;
mod report;
mod search;
mod shade;
mod text;
mod walk;

pub use allowance::SHARE;
pub use causes::{CAUSES, Cause, Explanation};
pub use check::{Check, Subject, Term};
pub use line::{Line, RayWord, line_schema};
pub use read::{ForeignTrace, LineError};
pub use report::{Comparison, ForeignDeparture, Place, StoryComparison, compare_foreign};
pub use text::comparison_text;
