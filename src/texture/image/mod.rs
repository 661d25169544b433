//! Image textures (§ 6.3.1) and environments (§ 6.3.0): from a hit to a place in an image, and from there to a colour.
//!
//! Images come in as numbers; reading files is the business of [`scene`](crate::scene). Colours are linear RGB.

mod environment;
mod filter;
mod footprint;
mod height;
mod homography;
mod mapping;
mod polygon;
mod scanning;
mod sum;
mod texels;
mod texture;
mod wrap;

pub use environment::{Environment, Layout};
pub use filter::Filter;
pub use footprint::Footprint;
pub use homography::Homography;
pub use mapping::{Affine, Mapping};
pub use scanning::Scan;
pub use texels::{Encoding, MOST_TEXELS, Texels};
pub use texture::{ImageTexture, Place};
pub use wrap::{Wrap, Wraps};
