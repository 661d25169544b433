//! What each effect of the scene costs, as a window with switches.

pub mod job;
pub mod window;
