//! The ray's story: what was recorded, the outline of its events, moving through them, and one of them in full.

pub mod detail;
pub mod outline;
pub mod panel;
pub mod recording;
pub mod stepper;
pub mod toolbar;
