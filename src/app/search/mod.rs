//! Finding pixels by what happened to their rays, and maps of what every pixel is and costs.

mod field;
mod found;
mod help;
mod layer;
mod maps;
pub mod pane;
