//! What accuracy costs in time, as a panel: of the whole picture, and of one ray.

pub mod chart;
pub mod image;
pub mod pane;
pub mod point;
pub mod ray;
