//! The fonts of formulas. They are those whose measures the layout knows by heart, so that no others will do.

use crate::view::outline::{Pen, steps_of};
use ab_glyph::{Font as _, FontRef, GlyphId};
use ratex_font::{FontId, katex_ttf_glyph_char};
use std::sync::OnceLock;

macro_rules! fonts {
    ($($name:literal),+ $(,)?) => {
        [$(($name, include_bytes!(concat!("../../../assets/fonts/katex/KaTeX_", $name, ".ttf")).as_slice())),+]
    };
}

static FONTS: [(&str, &[u8]); 12] = fonts![
    "Main-Regular",
    "Main-Bold",
    "Main-Italic",
    "Math-Italic",
    "Math-BoldItalic",
    "AMS-Regular",
    "Caligraphic-Regular",
    "Typewriter-Regular",
    "Size1-Regular",
    "Size2-Regular",
    "Size3-Regular",
    "Size4-Regular",
];

fn parsed() -> &'static [FontRef<'static>] {
    static PARSED: OnceLock<Vec<FontRef<'static>>> = OnceLock::new();
    PARSED.get_or_init(|| FONTS.iter().filter_map(|(_, bytes)| FontRef::try_from_slice(bytes).ok()).collect())
}

/// A letter of one of the fonts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Letter {
    font: usize,
    glyph: u16,
}

impl Letter {
    /// The letter for a character in the font of that name.
    ///
    /// # Errors
    /// If there is no such font, or it lacks the character.
    pub fn find(font: &str, code: u32) -> Result<Self, String> {
        let character = FontId::parse(font).map(|id| katex_ttf_glyph_char(id, code));
        let index = FONTS.iter().position(|(name, _)| *name == font);
        let (Some(character), Some(index)) = (character, index) else {
            let shown = char::from_u32(code).unwrap_or('\u{fffd}');
            return Err(format!("the fonts of formulas have no “{shown}” of the kind {font}"));
        };
        match parsed().get(index).map(|font| font.glyph_id(character)) {
            Some(GlyphId(glyph)) if glyph != 0 => Ok(Self { font: index, glyph }),
            _ => Err(format!("the fonts of formulas have no “{character}”")),
        }
    }

    /// Its outline in font units, a thousandth of the size each, with y upwards; nothing for a space.
    pub fn outline(self) -> Vec<Pen> {
        let curves = parsed().get(self.font).and_then(|font| font.outline(GlyphId(self.glyph)));
        curves.map(|outline| steps_of(&outline.curves)).unwrap_or_default()
    }

    /// A name for it that no other letter has.
    pub fn name(self) -> String {
        format!("k{}-{}", self.font, self.glyph)
    }
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
    }
}
