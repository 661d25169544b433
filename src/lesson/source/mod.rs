//! Reading a lesson's file: Markdown, with a header and fenced blocks in TOML.

mod aims;
pub(in crate::lesson) mod blocks;
mod lesson;
mod markdown;
mod questions;
mod references;
mod schema;
mod typed_numbers;

pub use lesson::read;
pub(in crate::lesson) use markdown::read_prose;
pub use schema::lesson_schema;
