//! Words, values and formulas on lines that share a baseline, broken where the room ends.

use egui::text::{LayoutJob, TextFormat};
use egui::{Color32, Context, Galley, Pos2, Rect, TextureId, Ui, Vec2, pos2, vec2};
use std::sync::Arc;

/// Room between two lines, in points.
const LEADING: f32 = 4.0;

/// A formula that is too wide is made smaller down to this share of its size: less could not be read beside the text.
pub const LEAST_SHARE: f32 = 0.75;

/// What is seen of a piece.
#[derive(Clone)]
pub enum Ink {
    /// Letters.
    Letters(Arc<Galley>),
    /// Pixels, so large in points.
    Pixels(TextureId, Vec2),
}

/// A piece that is not broken.
#[derive(Clone)]
pub struct Piece {
    ink: Ink,
    width: f32,
    ascent: f32,
    descent: f32,
    /// The number of what a click on it does.
    pub deed: Option<usize>,
}

impl Piece {
    /// Letters.
    pub fn letters(ctx: &Context, text: &str, format: TextFormat, deed: Option<usize>) -> Self {
        let job = LayoutJob::single_section(text.to_owned(), format);
        let galley = ctx.fonts_mut(|fonts| fonts.layout_job(job));
        let ascent = galley.rows.first().and_then(|row| row.row.glyphs.first().map(|glyph| row.pos.y + glyph.pos.y));
        let size = galley.size();
        let ascent = ascent.unwrap_or(size.y);
        Self { width: size.x, ascent, descent: size.y - ascent, ink: Ink::Letters(galley), deed }
    }

    /// Pixels whose baseline is so far below their top, made smaller to be no wider than there is room.
    pub fn pixels(texture: TextureId, size: Vec2, ascent: f32, most_width: f32) -> Self {
        let share = (most_width / size.x.max(1.0)).clamp(LEAST_SHARE, 1.0);
        let (size, ascent) = (size * share, ascent * share);
        Self { width: size.x, ascent, descent: size.y - ascent, ink: Ink::Pixels(texture, size), deed: None }
    }
}

/// Pieces with no space between them.
#[derive(Clone, Default)]
struct Chunk {
    pieces: Vec<Piece>,
    /// Whether a new line begins before it.
    begins_line: bool,
    /// Whether it goes on with what was too wide for one line: then there is no space before it.
    goes_on: bool,
}

impl Chunk {
    fn width(&self) -> f32 {
        self.pieces.iter().map(|piece| piece.width).sum()
    }

    /// What was put together without a space, taken apart again where a line cannot hold it.
    fn fitting(self, width: f32) -> Vec<Self> {
        if self.pieces.len() < 2 || self.width() <= width {
            return vec![self];
        }
        let Self { pieces, begins_line, goes_on } = self;
        let part = |(place, piece)| match place {
            0 => Self { pieces: vec![piece], begins_line, goes_on },
            _ => Self { pieces: vec![piece], begins_line: false, goes_on: true },
        };
        pieces.into_iter().enumerate().map(part).collect()
    }
}

/// A paragraph that is being put together.
pub struct Flow {
    chunks: Vec<Chunk>,
    is_open: bool,
    begins_line: bool,
    /// How wide its lines may be.
    width: f32,
    space: f32,
    /// How far a line rises above its baseline and goes below it at least.
    least: [f32; 2],
}

/// A piece where it belongs, from the upper left corner of the paragraph.
struct Placed {
    piece: Piece,
    left: f32,
    baseline: f32,
}

/// A paragraph with its lines.
pub struct Lines {
    placed: Vec<Placed>,
    /// How large it is.
    pub size: Vec2,
}

impl Flow {
    /// An empty paragraph for text of this kind, with lines so wide at most.
    pub fn new(ctx: &Context, format: &TextFormat, width: f32) -> Self {
        let space = Piece::letters(ctx, " ", format.clone(), None);
        Self {
            chunks: Vec::new(),
            is_open: false,
            begins_line: false,
            width,
            space: space.width,
            least: [space.ascent, space.descent],
        }
    }

    /// How wide it is where no line is broken, and how wide the widest of what has no space in it is.
    pub fn widths(&self) -> [f32; 2] {
        let (mut whole, mut line, mut least) = (0.0_f32, 0.0, 0.0_f32);
        for chunk in &self.chunks {
            let wide = chunk.width();
            line = if chunk.begins_line || line == 0.0 { wide } else { line + self.space + wide };
            whole = whole.max(line);
            least = least.max(wide);
        }
        [whole, least]
    }

    /// Adds words; where there is white space they can be broken, and those that are wider than a line anywhere.
    pub fn words(&mut self, ctx: &Context, text: &str, format: &TextFormat, deed: Option<usize>) {
        for (place, word) in text.split(is_break).enumerate() {
            if place > 0 {
                self.is_open = false;
            }
            if !word.is_empty() {
                self.word(ctx, word, format, deed);
            }
        }
    }

    fn word(&mut self, ctx: &Context, word: &str, format: &TextFormat, deed: Option<usize>) {
        let whole = Piece::letters(ctx, word, format.clone(), deed);
        if whole.width <= self.width {
            return self.piece(whole);
        }
        for part in parts(word, &whole, self.width) {
            self.piece(Piece::letters(ctx, part, format.clone(), deed));
        }
    }

    /// Adds a piece to what stands there without a space.
    pub fn piece(&mut self, piece: Piece) {
        if self.is_open
            && let Some(last) = self.chunks.last_mut()
        {
            last.pieces.push(piece);
            return;
        }
        let begins_line = std::mem::take(&mut self.begins_line);
        self.chunks.push(Chunk { pieces: vec![piece], begins_line, goes_on: false });
        self.is_open = true;
    }

    /// Begins a new line.
    pub const fn end_line(&mut self) {
        self.is_open = false;
        self.begins_line = true;
    }

    /// Breaks the lines.
    pub fn broken(self) -> Lines {
        let width = self.width;
        let mut lines: Vec<Vec<(f32, Chunk)>> = vec![Vec::new()];
        let mut x = 0.0;
        for chunk in self.chunks.into_iter().flat_map(|chunk| chunk.fitting(width)) {
            let wide = chunk.width();
            let is_first = lines.last().is_none_or(Vec::is_empty);
            let space = if chunk.goes_on { 0.0 } else { self.space };
            let left = if is_first { 0.0 } else { x + space };
            if (left + wide > width && !is_first) || chunk.begins_line {
                x = wide;
                lines.push(vec![(0.0, chunk)]);
            } else {
                x = left + wide;
                if let Some(line) = lines.last_mut() {
                    line.push((left, chunk));
                }
            }
        }
        let mut all = Lines { placed: Vec::new(), size: Vec2::ZERO };
        for line in lines {
            all.add(line, self.least);
        }
        all
    }
}

impl Lines {
    fn add(&mut self, line: Vec<(f32, Chunk)>, least: [f32; 2]) {
        let pieces = || line.iter().flat_map(|(_, chunk)| &chunk.pieces);
        let ascent = pieces().map(|piece| piece.ascent).fold(least[0], f32::max);
        let descent = pieces().map(|piece| piece.descent).fold(least[1], f32::max);
        let top = if self.size.y > 0.0 { self.size.y + LEADING } else { 0.0 };
        let baseline = top + ascent;
        for (mut left, chunk) in line {
            for piece in chunk.pieces {
                let width = piece.width;
                self.placed.push(Placed { piece, left, baseline });
                left += width;
            }
            self.size.x = self.size.x.max(left);
        }
        self.size.y = baseline + descent;
    }

    /// The rectangles of what a click on does something, one for each line that it stands on, with its number.
    pub fn deeds(&self, at: Pos2) -> Vec<(usize, Rect)> {
        let mut deeds: Vec<(usize, Rect, f32)> = Vec::new();
        for placed in &self.placed {
            let Some(deed) = placed.piece.deed else { continue };
            let rect = placed.rect(at);
            match deeds.last_mut() {
                Some((known, whole, baseline)) if *known == deed && *baseline == placed.baseline => {
                    *whole = whole.union(rect);
                }
                _ => deeds.push((deed, rect, placed.baseline)),
            }
        }
        deeds.into_iter().map(|(deed, rect, _)| (deed, rect)).collect()
    }

    /// Draws all of it with its upper left corner at a place.
    pub fn paint(&self, ui: &Ui, at: Pos2) {
        for placed in &self.placed {
            let rect = placed.rect(at);
            match &placed.piece.ink {
                Ink::Letters(galley) => {
                    ui.painter().galley(rect.min, Arc::clone(galley), Color32::PLACEHOLDER);
                }
                Ink::Pixels(texture, size) => {
                    // On whole pixels, so that thin lines stay sharp.
                    let scale = ui.pixels_per_point();
                    let corner = (rect.min.to_vec2() * scale).round() / scale;
                    let unit = Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0));
                    ui.painter().image(*texture, Rect::from_min_size(corner.to_pos2(), *size), unit, Color32::WHITE);
                }
            }
        }
    }
}

impl Placed {
    fn rect(&self, at: Pos2) -> Rect {
        let corner = at + vec2(self.left, self.baseline - self.piece.ascent);
        Rect::from_min_size(corner, vec2(self.piece.width, self.piece.ascent + self.piece.descent))
    }
}

/// A word in parts that are no wider than a line, each as long as it can be.
fn parts<'a>(word: &'a str, whole: &Piece, width: f32) -> Vec<&'a str> {
    let Ink::Letters(galley) = &whole.ink else { return vec![word] };
    let glyphs = galley.rows.first().map_or(&[][..], |row| row.row.glyphs.as_slice());
    let (mut parts, mut begin, mut left) = (Vec::new(), 0, 0.0);
    for ((place, _), glyph) in word.char_indices().zip(glyphs) {
        if glyph.max_x() - left > width && place > begin {
            parts.push(&word[begin..place]);
            (begin, left) = (place, glyph.pos.x);
        }
    }
    parts.push(&word[begin..]);
    parts
}

/// White space at which a line can be broken: not what holds a number and its unit together.
fn is_break(letter: char) -> bool {
    letter.is_whitespace() && !matches!(letter, '\u{a0}' | '\u{202f}')
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::FontId;

    fn broken(text: &str, width: f32) -> (usize, f32) {
        let ctx = Context::default();
        crate::app::frame::theme::install(&ctx);
        let mut found = (0, 0.0);
        let mut output = ctx.run_ui(egui::RawInput::default(), |ui| {
            let format = TextFormat::simple(FontId::monospace(13.0), Color32::BLACK);
            let mut flow = Flow::new(ui.ctx(), &format, width);
            flow.words(ui.ctx(), text, &format, None);
            let lines = flow.broken();
            let mut baselines: Vec<f32> = lines.placed.iter().map(|placed| placed.baseline).collect();
            baselines.dedup();
            found = (baselines.len(), lines.size.x);
        });
        // Nobody shows the letters.
        output.textures_delta.clear();
        found
    }

    #[test]
    fn a_word_that_is_wider_than_a_line_is_broken_and_no_line_is_wider_than_the_room() {
        let word = "scene.materials['bucket'].texture.transform[0].translate";
        let (lines, width) = broken(word, 150.0);
        assert!(lines > 2, "{lines} lines");
        assert!(width <= 150.5, "{width}");
        assert_eq!(broken(word, f32::INFINITY).0, 1);
    }

    #[test]
    fn what_stands_together_stays_together_where_it_fits() {
        assert_eq!(broken("a word or two", 1000.0).0, 1);
        let (lines, width) = broken("one two three four five six seven", 100.0);
        assert!(lines > 1 && width <= 100.0, "{lines} lines, {width}");
    }
}
