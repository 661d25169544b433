//! The drawings that go with the selected event.

pub mod all;
pub mod canvas;
mod linked;
mod overview;
pub mod plots;
mod seen;
pub mod side;
mod signs;
