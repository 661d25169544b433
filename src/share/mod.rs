//! What leaves the workbench for other people: links, worked examples, slides, moving pictures.
//!
//! Everything here makes bytes or text and writes nothing; the command line and the workbench put it into files. All of them
//! tell the same [`Account`]: a recorded ray, step by step.

pub mod link;

mod account;
mod animation;
mod data;
mod figures;
mod lines;
mod markdown;
mod sheet;
mod slides;
#[cfg(test)]
mod tests;

pub use account::{Account, Steps};
pub use animation::{AnimationError, FRAME, MOST_FRAMES, Moving, animation};
pub use data::trace_json;
pub use markdown::{Paper, markdown};
pub use slides::{MOST_SLIDES, slides, slides_pdf};

/// Whether whoever waits for a result still wants it: called between two steps with how many of how many are done.
pub type Watch<'a> = &'a dyn Fn(usize, usize) -> bool;

/// The work was given up because nobody wants its result any more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cancelled;
