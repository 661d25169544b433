//! The rendered picture: rendering it in the background, reading a pixel, choosing one.

mod hits;
pub mod overlay;
pub mod panel;
pub mod placement;
pub mod reading;
pub mod renderer;
pub mod thumbnail;
