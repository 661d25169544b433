//! Two stories, two pictures, or another ray tracer's story, beside each other.

mod foreign;
pub mod pane;
pub mod pictures;
mod pin;
mod rows;
mod stories;
