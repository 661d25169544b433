//! The fonts of formulas: those whose measures the layout knows by heart, and for what they lack, as names in a formula may hold
//! it, the fonts of drawings.

use crate::view::fonts::{Face, font, has_glyph, placed};
use crate::view::outline::{Pen, frame_of, steps_of};
use ab_glyph::{Font as _, FontRef, GlyphId};
use ratex_font::{FontId, katex_ttf_glyph_char};
use ratex_layout::FallbackGlyphMetrics;
use std::sync::OnceLock;

macro_rules! fonts {
    ($($(#[$when:meta])? $name:literal),+ $(,)?) => {
        [$($(#[$when])? ($name, include_bytes!(concat!("../../../assets/fonts/katex/KaTeX_", $name, ".ttf")).as_slice())),+]
    };
}

static FONTS: &[(&str, &[u8])] = &fonts![
    "Main-Regular",
    "Main-Bold",
    "Math-Italic",
    "Size1-Regular",
    "Size2-Regular",
    "Size3-Regular",
    "Size4-Regular",
    // Browsers show the course alone, which has no formula in those that follow.
    #[cfg(not(target_arch = "wasm32"))]
    "Main-Italic",
    #[cfg(not(target_arch = "wasm32"))]
    "Math-BoldItalic",
    #[cfg(not(target_arch = "wasm32"))]
    "AMS-Regular",
    #[cfg(not(target_arch = "wasm32"))]
    "Caligraphic-Regular",
    #[cfg(not(target_arch = "wasm32"))]
    "Typewriter-Regular",
];

/// How many of the fonts of formulas there are in browsers, too: they come first, so the names of their letters begin with `k0` and
/// so on.
pub const FONTS_IN_BROWSERS: usize = 7;

fn parsed() -> &'static [FontRef<'static>] {
    static PARSED: OnceLock<Vec<FontRef<'static>>> = OnceLock::new();
    PARSED.get_or_init(|| FONTS.iter().filter_map(|(_, bytes)| FontRef::try_from_slice(bytes).ok()).collect())
}

/// A letter of one of the fonts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Letter {
    /// The place of the font among those of formulas; after them come those of drawings.
    font: usize,
    glyph: u16,
}

impl Letter {
    /// The letter for a character in the font of that name; one that none of the formulas' fonts has, in those of drawings.
    ///
    /// # Errors
    /// If no font has the character.
    pub fn find(font: &str, code: u32) -> Result<Self, String> {
        let character = FontId::parse(font).map(|id| katex_ttf_glyph_char(id, code));
        let index = FONTS.iter().position(|(name, _)| *name == font);
        let own = index.zip(character).and_then(|(index, character)| Self::own(index, character));
        let shown = char::from_u32(code).unwrap_or('\u{fffd}');
        // A letter of a face that is not there would be taken for another symbol.
        let is_plain = font.starts_with("Main") || font.starts_with("CJK");
        own.or_else(|| Self::of_drawings(shown).filter(|_| is_plain))
            .ok_or_else(|| format!("the fonts of formulas have no “{shown}” of the kind {font}"))
    }

    fn own(index: usize, character: char) -> Option<Self> {
        let GlyphId(glyph) = parsed().get(index)?.glyph_id(character);
        (glyph != 0).then_some(Self { font: index, glyph })
    }

    fn of_drawings(character: char) -> Option<Self> {
        has_glyph(Face::Sans, character).then_some(())?;
        let placed = placed(&character.to_string(), Face::Sans).into_iter().next()?;
        Some(Self { font: FONTS.len() + placed.font, glyph: placed.glyph })
    }

    fn file(self) -> Option<(&'static FontRef<'static>, f64)> {
        let file = match self.font.checked_sub(FONTS.len()) {
            None => parsed().get(self.font),
            Some(of_drawings) => font(of_drawings),
        }?;
        Some((file, 1000.0 / f64::from(file.units_per_em()?)))
    }

    /// Its outline in thousandths of the size, with y upwards; nothing for a space.
    pub fn outline(self) -> Vec<Pen> {
        let Some((file, scale)) = self.file() else { return Vec::new() };
        let Some(outline) = file.outline(GlyphId(self.glyph)) else { return Vec::new() };
        steps_of(&outline.curves).into_iter().map(|step| step.moved(|spot| spot.map(|x| x * scale))).collect()
    }

    /// Its width, and how far it rises above the line and goes below it, in sizes.
    fn measures(self) -> Option<[f64; 3]> {
        let (file, scale) = self.file()?;
        let width = f64::from(file.h_advance_unscaled(GlyphId(self.glyph))) * scale;
        let frame = frame_of(&self.outline());
        let [height, depth] = frame.map_or([0.0; 2], |frame| [frame.high[1].max(0.0), (-frame.low[1]).max(0.0)]);
        Some([width, height, depth].map(|x| x / 1000.0))
    }

    /// A name for it that no other letter has.
    pub fn name(self) -> String {
        format!("k{}-{}", self.font, self.glyph)
    }
}

/// The measures of the characters in a text that the layout may not know by heart: those beyond ASCII.
pub fn measures_of(text: &str) -> impl Iterator<Item = (char, FallbackGlyphMetrics)> {
    text.chars().filter(|c| !c.is_ascii()).filter_map(|character| {
        let [width, height, depth] = Letter::of_drawings(character)?.measures()?;
        Some((character, FallbackGlyphMetrics { width, height, depth }))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_font_can_be_read_and_has_a_thousand_units() {
        assert_eq!(parsed().len(), FONTS.len());
        assert!(parsed().iter().all(|font| font.units_per_em() == Some(1000.0)));
    }

    #[test]
    fn a_letter_that_is_not_there_is_named() {
        let error = Letter::find("CJK-Regular", u32::from('界')).unwrap_err();
        assert!(error.contains('界'), "{error}");
        assert!(Letter::find("Main-Regular", u32::from('界')).is_err());
        assert!(Letter::find("Fraktur-Regular", u32::from('g')).is_err());
    }

    #[test]
    fn what_formulas_lack_is_taken_from_the_fonts_of_drawings() {
        let index = Letter::find("Main-Regular", u32::from('₁')).unwrap();
        let [width, height, depth] = index.measures().unwrap();
        assert!((0.2..0.6).contains(&width) && height > 0.1 && (0.1..0.4).contains(&depth), "{width} {height} {depth}");
    }
}
