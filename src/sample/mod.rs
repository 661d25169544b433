//! Samples: points that fill a square evenly, and where they fall on pixels, lenses and lights.

mod aperture;
mod disc;
mod pixel_filter;
mod stream;

pub use aperture::Aperture;
pub use disc::concentric_disc;
pub use pixel_filter::PixelFilter;
pub use stream::{Purpose, Stream};
