//! Colours of the scene in a drawing.

use super::palette::Colour;
use crate::record::Triple;
use crate::trace::srgb;
use glam::DVec3;

/// A linear colour of the scene as it looks on a screen.
pub(super) fn shown(colour: Triple) -> Colour {
    let [r, g, b] = srgb(DVec3::from_array(colour));
    Colour { r, g, b, a: 255 }
}

/// Black or white, whichever is read more easily on `ground`.
pub(super) fn ink_on(ground: Colour) -> Colour {
    let [r, g, b] = [ground.r, ground.g, ground.b].map(f64::from);
    // Rec. 709 luma, good enough to choose between two.
    let luma = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    Colour::hex(if luma > 128.0 { 0x1c_1f_24 } else { 0xff_ff_ff })
}
