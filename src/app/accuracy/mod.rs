//! What accuracy costs in time, as a window: of the whole picture, and of one ray.

pub mod chart;
pub mod image;
pub mod point;
pub mod ray;
pub mod window;
