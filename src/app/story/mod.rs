//! The ray's story: what was recorded, the outline of its events, moving through them, and one of them in full.

mod breakpoints;
pub mod detail;
mod filter;
mod icon;
mod jump;
mod left_out;
pub mod pane;
mod recorder;
pub mod recording;
pub mod stepping;
pub mod timeline;
mod toolbar;
mod tree;
pub mod until;
