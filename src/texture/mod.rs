//! What a surface carries (§ 6.3): images, environments, solid textures, bumps, frames, facets.
//!
//! Everything here is asked for one hit, and says to a [`Recorder`](crate::record::Recorder) how it came to its answer.

pub mod image;
pub mod relief;
pub mod solid;
