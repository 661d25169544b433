//! The letters of a document: which of each font are used, and those alone embedded.
//!
//! A code stands for one character in one font, so that copied text is what was written even where a font draws two
//! characters alike. A stream takes codes to glyphs (CIDToGIDMap, § 9.7.4.2), another takes them back to characters (ToUnicode,
//! § 9.10.3).

use super::Document;
use crate::view::fonts::{Placed, font, fonts};
use ab_glyph::{Font as _, FontRef, GlyphId};
use pdf_writer::types::{CidFontType, FontFlags, SystemInfo, UnicodeCmap};
use pdf_writer::{Filter, Finish, Name, Rect, Ref, Str};
use std::collections::BTreeMap;
use subsetter::{GlyphRemapper, subset};

const SYSTEM: SystemInfo = SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"Identity"), supplement: 0 };

/// Stem widths are of use where a reader replaces a font; an embedded one is not replaced.
const STEM: f32 = 80.0;

/// All letters that a document uses.
#[derive(Default)]
pub struct FontSet {
    used: BTreeMap<usize, UsedFont>,
}

/// The letters of one font that a document uses.
#[derive(Default)]
pub struct UsedFont {
    index: usize,
    codes: BTreeMap<char, u16>,
    /// The character and its glyph for each code from 1 on.
    letters: Vec<(char, u16)>,
}

impl FontSet {
    /// The name of a font among a page's resources.
    pub fn name(font: usize) -> String {
        format!("F{font}")
    }

    /// The code of a letter. 0 is that of none, for documents with more than 65,535 different ones.
    pub fn code(&mut self, letter: &Placed) -> u16 {
        let used = self.used.entry(letter.font).or_default();
        used.index = letter.font;
        if let Some(&code) = used.codes.get(&letter.character) {
            return code;
        }
        let Ok(code) = u16::try_from(used.letters.len() + 1) else { return 0 };
        used.letters.push((letter.character, letter.glyph));
        used.codes.insert(letter.character, code);
        code
    }

    /// The fonts that are used.
    pub fn fonts(&mut self) -> impl Iterator<Item = &UsedFont> {
        self.used.values()
    }
}

impl UsedFont {
    /// Its name among a page's resources.
    pub fn name(&self) -> String {
        FontSet::name(self.index)
    }

    /// Its name as a subset (§ 9.6.4): six letters that stand for the characters in it.
    fn base_name(&self) -> String {
        let fold = |hash: u32, (character, _): &(char, u16)| (hash ^ u32::from(*character)).wrapping_mul(16_777_619);
        let mut hash = self.letters.iter().fold(2_166_136_261, fold);
        let mut tag = String::new();
        for letter in std::iter::repeat_with(|| {
            let letter = char::from(b'A' + u8::try_from(hash % 26).unwrap_or(0));
            hash /= 26;
            letter
        })
        .take(6)
        {
            tag.push(letter);
        }
        format!("{tag}+{}", fonts()[self.index].name)
    }
}

/// Measures of a font, in thousandths of its size.
struct Measures {
    font: &'static FontRef<'static>,
    scale: f32,
}

impl Measures {
    fn of(used: &UsedFont) -> Option<Self> {
        let font = font(used.index)?;
        Some(Self { font, scale: 1000.0 / font.units_per_em()? })
    }

    fn width(&self, glyph: u16) -> f32 {
        self.font.h_advance_unscaled(GlyphId(glyph)) * self.scale
    }

    fn ascent(&self) -> f32 {
        self.font.ascent_unscaled() * self.scale
    }

    fn descent(&self) -> f32 {
        self.font.descent_unscaled() * self.scale
    }

    fn cap_height(&self) -> f32 {
        let outline = self.font.outline(self.font.glyph_id('H'));
        outline.map_or(self.ascent(), |outline| outline.bounds.max.y.max(outline.bounds.min.y) * self.scale)
    }

    /// The box that holds all of the letters.
    fn frame(&self, letters: &[(char, u16)]) -> Rect {
        let mut frame = [0.0, self.descent(), 1000.0, self.ascent()];
        for outline in letters.iter().filter_map(|&(_, glyph)| self.font.outline(GlyphId(glyph))) {
            for corner in [outline.bounds.min, outline.bounds.max] {
                let (x, y) = (corner.x * self.scale, corner.y * self.scale);
                frame = [frame[0].min(x), frame[1].min(y), frame[2].max(x), frame[3].max(y)];
            }
        }
        let [left, bottom, right, top] = frame.map(f32::round);
        Rect::new(left, bottom, right, top)
    }
}

impl Document {
    /// Embeds a font; its reference.
    pub fn font(&mut self, used: &UsedFont) -> Ref {
        let [id, descendant, descriptor] = std::array::from_fn(|_| self.new_ref());
        let base = used.base_name();
        let unicode = self.unicode_map(used);
        let mut font = self.pdf.type0_font(id);
        font.base_font(Name(base.as_bytes())).encoding_predefined(Name(b"Identity-H"));
        font.descendant_font(descendant).to_unicode(unicode);
        font.finish();
        let (file, glyphs) = self.subset(used);
        self.descendant(used, [descendant, descriptor, glyphs], &base);
        self.descriptor(used, [descriptor, file], &base);
        id
    }

    /// From codes to characters.
    fn unicode_map(&mut self, used: &UsedFont) -> Ref {
        let mut map = UnicodeCmap::new(Name(b"Custom"), SYSTEM);
        for (code, (character, _)) in (1..=u16::MAX).zip(&used.letters) {
            map.pair(code, *character);
        }
        let text = map.finish();
        self.stream(&text)
    }

    /// The font file with the glyphs that are used, and the map from codes to them.
    fn subset(&mut self, used: &UsedFont) -> (Ref, Ref) {
        let mut remapper = GlyphRemapper::new();
        let glyphs: Vec<u16> = used.letters.iter().map(|&(_, glyph)| remapper.remap(glyph)).collect();
        let whole = fonts()[used.index].bytes;
        // Our own fonts can be taken apart; a font that could not be would be embedded whole, under its own numbers.
        let (file, glyphs) = match subset(whole, 0, &remapper) {
            Ok(file) => (file, glyphs),
            Err(_) => (whole.to_vec(), used.letters.iter().map(|&(_, glyph)| glyph).collect()),
        };
        let map: Vec<u8> = std::iter::once(0).chain(glyphs).flat_map(u16::to_be_bytes).collect();
        let id = self.new_ref();
        let packed = miniz_oxide::deflate::compress_to_vec_zlib(&file, super::COMPRESSION);
        let mut stream = self.pdf.stream(id, &packed);
        stream.filter(Filter::FlateDecode).pair(Name(b"Length1"), super::number(file.len()));
        stream.finish();
        (id, self.stream(&map))
    }

    fn descendant(&mut self, used: &UsedFont, [id, descriptor, glyphs]: [Ref; 3], base: &str) {
        let mut font = self.pdf.cid_font(id);
        font.subtype(CidFontType::Type2).base_font(Name(base.as_bytes())).system_info(SYSTEM);
        font.font_descriptor(descriptor).default_width(0.0).cid_to_gid_map_stream(glyphs);
        if let Some(measures) = Measures::of(used) {
            font.widths().consecutive(1, used.letters.iter().map(|&(_, glyph)| measures.width(glyph)));
        }
    }

    fn descriptor(&mut self, used: &UsedFont, [id, file]: [Ref; 2], base: &str) {
        let mut descriptor = self.pdf.font_descriptor(id);
        descriptor.name(Name(base.as_bytes())).flags(FontFlags::SYMBOLIC).italic_angle(0.0).stem_v(STEM);
        descriptor.font_file2(file);
        if let Some(measures) = Measures::of(used) {
            descriptor.bbox(measures.frame(&used.letters)).ascent(measures.ascent()).descent(measures.descent());
            descriptor.cap_height(measures.cap_height());
        }
    }
}
