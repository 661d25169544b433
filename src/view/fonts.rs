//! The fonts of drawings and of the workbench, and how wide a text is in them.

use ab_glyph::{Font as _, FontRef, OutlineCurve};
use std::sync::OnceLock;

/// What a font is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FontRole {
    /// Running text.
    Sans,
    /// Headings.
    Bold,
    /// Columns of numbers and the source of things.
    Mono,
    /// Characters that the others lack, in this order.
    Fallback,
}

/// A font that is part of the program.
#[derive(Clone, Copy, Debug)]
pub struct Font {
    /// Its name.
    pub name: &'static str,
    /// What it is for.
    pub role: FontRole,
    /// The font file.
    pub bytes: &'static [u8],
}

macro_rules! font {
    ($role:ident, $name:literal) => {
        Font {
            name: $name,
            role: FontRole::$role,
            bytes: include_bytes!(concat!("../../assets/fonts/", $name, ".ttf")),
        }
    };
}

static FONTS: [Font; 6] = [
    font!(Sans, "NotoSans-Regular"),
    font!(Bold, "NotoSans-Bold"),
    font!(Mono, "NotoSansMono-Regular"),
    font!(Fallback, "NotoSansMath-Regular"),
    font!(Fallback, "NotoSansSymbols2-Regular"),
    font!(Fallback, "NotoSansSymbols-Regular"),
];

/// All fonts: one for each role, then the fallbacks in order.
#[must_use]
pub fn fonts() -> &'static [Font] {
    &FONTS
}

/// The look of a text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Face {
    /// Running text.
    #[default]
    Sans,
    /// Emphasis.
    Bold,
    /// Every character as wide as the next.
    Mono,
}

/// Sans stands behind every face, before the fallbacks: Bold lacks what Sans has. Mono alone draws boxes of lines.
const fn stack(face: Face) -> [usize; 6] {
    match face {
        Face::Sans => [0, 3, 4, 5, 2, 1],
        Face::Bold => [1, 0, 3, 4, 5, 2],
        Face::Mono => [2, 0, 3, 4, 5, 1],
    }
}

fn parsed() -> &'static [FontRef<'static>] {
    static PARSED: OnceLock<Vec<FontRef<'static>>> = OnceLock::new();
    PARSED.get_or_init(|| FONTS.iter().filter_map(|font| FontRef::try_from_slice(font.bytes).ok()).collect())
}

/// A glyph of a text set in size 1, with its left end at the origin and y upwards.
pub(super) struct Glyph {
    /// The outline; empty for a space.
    pub curves: Vec<OutlineCurve>,
    /// What the outline's coordinates must be multiplied with.
    pub scale: f32,
    /// How far the pen has come before it.
    pub x: f32,
}

fn find(face: Face, c: char) -> Option<(&'static FontRef<'static>, ab_glyph::GlyphId, f32)> {
    stack(face).into_iter().find_map(|index| glyph_of(index, c))
}

/// The first font of the stack that has the character.
fn font_of(face: Face, c: char) -> Option<usize> {
    stack(face).into_iter().find(|&index| glyph_of(index, c).is_some())
}

fn glyph_of(index: usize, c: char) -> Option<(&'static FontRef<'static>, ab_glyph::GlyphId, f32)> {
    let font = parsed().get(index)?;
    let id = font.glyph_id(c);
    (id.0 != 0).then(|| (font, id, font.units_per_em().map_or(1e-3, f32::recip)))
}

/// Whether some font of the stack has the character.
#[must_use]
pub fn has_glyph(face: Face, c: char) -> bool {
    find(face, c).is_some()
}

/// The glyphs of a text set in size 1. Characters that no font has show as an empty box.
pub(super) fn glyphs(text: &str, face: Face) -> Vec<Glyph> {
    let mut x = 0.0;
    let one = |c: char| {
        let (font, id, scale) = find(face, c).or_else(|| find(face, '□'))?;
        let curves = font.outline(id).map(|outline| outline.curves).unwrap_or_default();
        let glyph = Glyph { curves, scale, x };
        x += font.h_advance_unscaled(id) * scale;
        Some(glyph)
    };
    text.chars().filter_map(one).collect()
}

/// A character of a text set in size 1, with its place.
pub(super) struct Placed {
    /// The font that has it: an index into [`fonts`].
    pub font: usize,
    /// The font's own number for the character's shape.
    pub glyph: u16,
    /// The character.
    pub character: char,
    /// How far the pen has come before it.
    pub x: f64,
}

/// The characters of a text set in size 1, each in the font that has it.
pub(super) fn placed(text: &str, face: Face) -> Vec<Placed> {
    let mut x = 0.0;
    let one = |character: char| {
        let shown = if has_glyph(face, character) { character } else { '□' };
        let font = font_of(face, shown)?;
        let (face_of, id, scale) = glyph_of(font, shown)?;
        let placed = Placed { font, glyph: id.0, character, x };
        x += f64::from(face_of.h_advance_unscaled(id) * scale);
        Some(placed)
    };
    text.chars().filter_map(one).collect()
}

/// The font of that index, for its measures.
pub(super) fn font(index: usize) -> Option<&'static FontRef<'static>> {
    parsed().get(index)
}

/// How wide a text is, in points, when set in `size` points.
#[must_use]
pub fn text_width(text: &str, size: f64, face: Face) -> f64 {
    let advance = |c: char| {
        find(face, c).or_else(|| find(face, '□')).map_or(0.0, |(font, id, scale)| font.h_advance_unscaled(id) * scale)
    };
    text.chars().map(|c| f64::from(advance(c))).sum::<f64>() * size
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_font_can_be_read() {
        assert_eq!(parsed().len(), FONTS.len());
    }

    #[test]
    fn the_fonts_stay_small() {
        let total: usize = FONTS.iter().map(|font| font.bytes.len()).sum();
        assert!(total < 350_000, "{total} bytes");
    }

    #[test]
    fn every_sign_that_texts_use_has_a_glyph() {
        let signs = "∪∩−⇒√∈∇‖≤≥≠≈·×∞∫∂Σ▸▾●○◆◇■□▲✓✗θ₁θ₂μηλ⁰¹²³⁴⁵⁶⁷⁸⁹⁻°±′→←↑↓…“”‘’§⊥∅½ⁿᵐ₀₁₂₃ₓ①②③④⑤⑥½∥ℝ⟨⟩├─│└é";
        for face in [Face::Sans, Face::Bold, Face::Mono] {
            let missing: String = signs.chars().filter(|&c| !has_glyph(face, c)).collect();
            assert_eq!(missing, "", "in {face:?}");
        }
    }

    #[test]
    fn a_mono_text_is_as_wide_as_its_number_of_characters() {
        let one = text_width("0", 10.0, Face::Mono);
        assert!((text_width("−1.5·10", 10.0, Face::Mono) - 7.0 * one).abs() < 1e-9);
    }
}
