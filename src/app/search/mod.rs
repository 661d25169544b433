//! Finding pixels by what happened to their rays, and maps of what every pixel is and costs.

mod field;
pub mod found;
mod help;
mod layer;
pub mod maps;
pub mod pane;
