//! The colours of the text: its words by kind, and over them what is wrong, found, matched and lit.

use crate::app::frame::theme::{Palette, colour, drawing_theme};
use crate::document::{Syntax, TokenKind};
use egui::text::{ByteIndex, LayoutJob, LayoutSection, TextFormat};
use egui::{Color32, Context, FontId, Stroke};
use std::ops::Range;

/// What is marked in the text besides its words.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Marks {
    /// What is wrong: underlined.
    pub wrong: Vec<Range<usize>>,
    /// What was searched for.
    pub found: Vec<Range<usize>>,
    /// A pair of brackets.
    pub brackets: Vec<Range<usize>>,
    /// The thing that is being edited.
    pub lit: Option<Range<usize>>,
}

/// A text with its colours, laid out as it is written.
#[must_use]
pub fn highlighted(ctx: &Context, text: &str, syntax: &Syntax, marks: &Marks, font: &FontId) -> LayoutJob {
    let colours = Colours::of(ctx);
    let mut borders: Vec<usize> = syntax.tokens.iter().flat_map(|token| [token.range.start, token.range.end]).collect();
    let all = marks.wrong.iter().chain(&marks.found).chain(&marks.brackets).chain(&marks.lit);
    borders.extend(all.flat_map(|range| [range.start, range.end]));
    borders.extend([0, text.len()]);
    borders.retain(|border| *border <= text.len() && text.is_char_boundary(*border));
    borders.sort_unstable();
    borders.dedup();
    let mut job = LayoutJob { text: text.to_owned(), break_on_newline: true, ..LayoutJob::default() };
    job.wrap.max_width = f32::INFINITY;
    let mut token = 0;
    for pair in borders.windows(2) {
        let (start, end) = (pair[0], pair[1]);
        while syntax.tokens.get(token).is_some_and(|token| token.range.end <= start) {
            token += 1;
        }
        let kind = syntax.tokens.get(token).filter(|token| token.range.start <= start).map(|token| token.kind);
        let format = colours.format(kind, marks, start, font);
        job.sections.push(LayoutSection { leading_space: 0.0, byte_range: ByteIndex(start)..ByteIndex(end), format });
    }
    if job.sections.is_empty() {
        let format = colours.format(None, marks, 0, font);
        job.sections.push(LayoutSection { leading_space: 0.0, byte_range: ByteIndex(0)..ByteIndex(0), format });
    }
    job
}

struct Colours {
    palette: Palette,
    key: Color32,
    string: Color32,
    number: Color32,
}

impl Colours {
    fn of(ctx: &Context) -> Self {
        let drawn = drawing_theme(ctx).palette();
        Self {
            palette: Palette::current(ctx),
            key: colour(drawn.camera),
            string: colour(drawn.refracted),
            number: colour(drawn.reflected),
        }
    }

    fn format(&self, kind: Option<TokenKind>, marks: &Marks, at: usize, font: &FontId) -> TextFormat {
        let palette = &self.palette;
        let color = match kind {
            Some(TokenKind::Key) => self.key,
            Some(TokenKind::String) => self.string,
            Some(TokenKind::Number | TokenKind::Keyword) => self.number,
            Some(TokenKind::Comment) => palette.weak,
            Some(TokenKind::Error) => palette.problem,
            Some(TokenKind::Punctuation) | None => palette.text,
        };
        let within = |ranges: &[Range<usize>]| ranges.iter().any(|range| range.contains(&at));
        let is_lit = marks.lit.as_ref().is_some_and(|range| range.contains(&at));
        let background = if within(&marks.found) || within(&marks.brackets) {
            palette.selected
        } else if is_lit {
            palette.hovered
        } else {
            Color32::TRANSPARENT
        };
        let is_wrong = within(&marks.wrong);
        let underline = if is_wrong { Stroke::new(2.0, palette.problem) } else { Stroke::NONE };
        TextFormat { font_id: font.clone(), color, background, underline, ..TextFormat::default() }
    }
}
