//! Two stories side by side: two recorded pixels, and a pixel beside what another ray tracer says of it.
//!
//! Nothing here traces a picture, reads a file or prints: it is handed trees, pictures and the lines of another program.

mod align;
mod departure;
mod difference;
mod fields;
pub mod foreign;
mod name;
mod picture;
#[cfg(test)]
mod tests;
mod text;
mod tolerance;

pub use departure::Departure;
pub use difference::{Pair, Standing, TreeDifference, difference};
pub use fields::{Change, Said};
pub use picture::{PictureDifference, picture_difference};
pub use text::difference_text;
pub use tolerance::Tolerance;
