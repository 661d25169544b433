//! The drawings that go with the selected event.

pub mod canvas;
pub mod plots;
pub mod side;
