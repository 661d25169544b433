//! Samples: points that fill a square evenly, and where they fall on pixels, lenses and lights.

mod aperture;
mod disc;
mod mask;
mod pixel_filter;
mod polygon;
mod sobol;
mod stream;

pub use aperture::Aperture;
pub use disc::concentric_disc;
pub use mask::Mask;
pub use pixel_filter::PixelFilter;
pub use polygon::{polygon_corner, regular_polygon};
pub use sobol::{scrambled, sobol_point};
pub use stream::{Purpose, Stream};
