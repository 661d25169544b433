//! What each effect of the scene costs, as a panel with switches.

pub mod job;
pub mod pane;
