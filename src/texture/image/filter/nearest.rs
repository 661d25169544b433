//! The texel that a point lies in.

use super::Ground;
use crate::record::Recorder;
use crate::texture::image::sum::Sum;
use crate::texture::image::wrap::cell;
use glam::{DVec2, DVec3};

/// The colour of the texel at `point`.
pub(super) fn colour<R: Recorder>(ground: Ground, point: DVec2, recorder: &mut R) -> DVec3 {
    let mut sum = Sum::new::<R>(ground.texels, ground.wraps);
    sum.add([cell(point.x), cell(point.y)], 1.0);
    sum.finish("nearest", 0, recorder)
}
