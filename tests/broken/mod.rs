//! The tables of broken scene files, with what each must be told.

mod files;
mod glass;
mod objects;

pub use files::FILES;
pub use glass::GLASS;
pub use objects::OBJECTS;

/// A text with one mistake, where it is (line, column, path in the JSON), and what has to be said about it.
pub struct Case {
    pub text: &'static str,
    pub place: &'static str,
    pub message: &'static str,
    pub help: &'static str,
}
