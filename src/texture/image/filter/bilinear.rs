//! The four texels around a point.

use super::Ground;
use crate::record::Recorder;
use crate::texture::image::sum::Sum;
use crate::texture::image::wrap::cell;
use glam::{DVec2, DVec3};

/// The colour at `point`, in texels of the image, from a level of its pyramid: linear between the centres of texels.
pub(super) fn colour<R: Recorder>(ground: Ground, level: usize, point: DVec2, recorder: &mut R) -> DVec3 {
    let texels = ground.texels.level(level);
    let corner = point * ground.scale(level) - 0.5;
    let [x, y] = [cell(corner.x), cell(corner.y)];
    // What is no number lies in the middle of its cell.
    let part = (corner - corner.floor()).to_array().map(|part| if part.is_finite() { part } else { 0.5 });
    let mut sum = Sum::new::<R>(texels, ground.wraps);
    for (dy, share_y) in [(0, 1.0 - part[1]), (1, part[1])] {
        for (dx, share_x) in [(0, 1.0 - part[0]), (1, part[0])] {
            sum.add([x + dx, y + dy], share_x * share_y);
        }
    }
    sum.finish("bilinear", level, recorder)
}
