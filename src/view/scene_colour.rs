//! Colours of the scene in a drawing.

use super::palette::{Colour, Palette};
use crate::math::portable;
use crate::record::Triple;
use crate::trace::srgb;
use glam::DVec3;

/// A linear colour of the scene as it looks on a screen.
pub(super) fn shown(colour: Triple) -> Colour {
    let [r, g, b] = srgb(DVec3::from_array(colour));
    Colour { r, g, b, a: 255 }
}

/// How many times lighter the lighter of two colours is than the darker one, as WCAG 2 defines contrast.
fn contrast(a: Colour, b: Colour) -> f64 {
    let linear = |x: u8| portable::powf(f64::from(x) / 255.0, 2.2);
    let luminance = |c: Colour| 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
    let (a, b) = (luminance(a) + 0.05, luminance(b) + 0.05);
    a.max(b) / a.min(b)
}

/// A colour on a ground: on a dark one as much paler as it needs to be seen, else as it is.
pub(super) fn seen_on(ground: Colour, colour: Colour) -> Colour {
    /// What lines and dots have everywhere else, too.
    const CLEAR: f64 = 3.0;
    if !is_dark(ground) {
        return colour;
    }
    let paler = (0..=20).map(|step| colour.mixed(Colour::hex(0xff_ff_ff), f64::from(step) / 20.0));
    paler.clone().find(|paler| contrast(*paler, ground) >= CLEAR).unwrap_or(colour)
}

/// A colour for letters: as much nearer to the ink as it needs to be read on the ground.
pub(super) fn legible(palette: &Palette, colour: Colour) -> Colour {
    /// What WCAG 2 asks of text (success criterion 1.4.3).
    const CLEAR: f64 = 4.5;
    let nearer = (0..=20).map(|step| colour.mixed(palette.ink, f64::from(step) / 20.0));
    nearer.clone().find(|nearer| contrast(*nearer, palette.ground) >= CLEAR).unwrap_or(palette.ink)
}

/// Whether what is read on it has to be light.
pub(super) fn is_dark(ground: Colour) -> bool {
    let [r, g, b] = [ground.r, ground.g, ground.b].map(f64::from);
    // Rec. 709 luma, good enough to choose between two.
    0.2126 * r + 0.7152 * g + 0.0722 * b <= 128.0
}

/// Black or white, whichever is read more easily on `ground`.
pub(super) fn ink_on(ground: Colour) -> Colour {
    Colour::hex(if is_dark(ground) { 0xff_ff_ff } else { 0x1c_1f_24 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::Theme;

    #[test]
    fn violet_is_paler_on_a_dark_ground_and_itself_on_a_light_one() {
        let violet = Colour::hex(0x4a_00_ff);
        for theme in [Theme::Dark, Theme::DarkContrast] {
            let ground = theme.palette().ground;
            assert!(contrast(seen_on(ground, violet), ground) >= 3.0);
        }
        assert_eq!(seen_on(Theme::Light.palette().ground, violet), violet);
    }
}
