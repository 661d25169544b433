//! Text that flows from page to page.

use super::line::{Glued, Piece, glued_words, in_lines};
use crate::view::{Anchor, Colour, Drawing, Face, Form, Formula, Frame, Stroke, Text, Theme};

/// A page of A4, in points.
const PAGE: [f64; 2] = [595.0, 842.0];
const LEFT: f64 = 56.0;
const TOP: f64 = 56.0;
const BOTTOM: f64 = 786.0;
/// The width of the text.
pub const WIDTH: f64 = PAGE[0] - 2.0 * LEFT;
/// From one line to the next, in sizes.
const LEADING: f64 = 1.42;

/// How a text looks.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Its size in points.
    pub size: f64,
    /// Its face.
    pub face: Face,
    /// Whether it stands back.
    pub faint: bool,
    /// The room below it.
    pub after: f64,
}

impl Look {
    /// Running text.
    pub const TEXT: Self = Self { size: 10.0, face: Face::Sans, faint: false, after: 5.0 };
    /// The title of the lesson.
    pub const TITLE: Self = Self { size: 21.0, face: Face::Bold, faint: false, after: 5.0 };
    /// The idea below it.
    pub const IDEA: Self = Self { size: 12.0, face: Face::Sans, faint: false, after: 4.0 };
    /// The title of a step.
    pub const HEADING: Self = Self { size: 14.0, face: Face::Bold, faint: false, after: 3.0 };
    /// What stands above a question.
    pub const LABEL: Self = Self { size: 10.0, face: Face::Bold, faint: false, after: 2.0 };
    /// Captions and the like.
    pub const SMALL: Self = Self { size: 8.5, face: Face::Sans, faint: true, after: 5.0 };
    /// Code.
    pub const CODE: Self = Self { size: 8.5, face: Face::Mono, faint: false, after: 0.0 };
}

/// The pages of a lesson, as far as they are written.
pub struct Flow {
    pages: Vec<Drawing>,
    /// Where the next line begins.
    y: f64,
}

impl Flow {
    /// An empty first page.
    pub fn new() -> Self {
        Self { pages: vec![Drawing::new(PAGE, ground())], y: TOP }
    }

    /// Goes on at the head of a new page.
    pub fn next_page(&mut self) {
        self.pages.push(Drawing::new(PAGE, ground()));
        self.y = TOP;
    }

    /// Goes on at a new page if this one has less room than that.
    pub fn keep(&mut self, height: f64) {
        if self.y + height > BOTTOM && self.y > TOP {
            self.next_page();
        }
    }

    /// Leaves room.
    pub fn gap(&mut self, height: f64) {
        self.y += height;
    }

    /// A text without values and formulas.
    pub fn words(&mut self, text: &str, look: Look) {
        self.lines(glued_words(text, look), 0.0, look);
    }

    /// Words and formulas, broken into lines, with their left end so far from that of the text.
    pub fn lines(&mut self, glued: Vec<Glued>, indent: f64, look: Look) {
        self.hanging(None, glued, indent, look);
    }

    /// The same with a sign on the first line, so far before its left end.
    pub fn hanging(&mut self, sign: Option<(&str, f64)>, glued: Vec<Glued>, indent: f64, look: Look) {
        let mut sign = sign;
        for line in in_lines(glued, WIDTH - indent, look.size) {
            let above = line.iter().map(|piece| piece.height(look.size)).fold(look.size * 0.95, f64::max);
            let below = line.iter().map(|piece| piece.depth(look.size)).fold(look.size * 0.3, f64::max);
            let height = (above + below).max(look.size * LEADING);
            self.keep(height);
            let baseline = self.y + (height - above - below) / 2.0 + above;
            if let Some((sign, before)) = sign.take() {
                self.text(&format!("{sign} "), [LEFT + indent - before, baseline], look.face, look);
            }
            self.line(&line, [LEFT + indent, baseline], look);
            self.y += height;
        }
        self.gap(look.after);
    }

    /// A line at a place: runs of words that look alike are one text, so that they are copied as one.
    fn line(&mut self, line: &[Piece], at: [f64; 2], look: Look) {
        let mut x = at[0];
        let mut run = String::new();
        let mut began = x;
        let mut face = look.face;
        for piece in line {
            match piece {
                Piece::Word { text, face: own } => {
                    if *own != face && !run.is_empty() {
                        self.text(&std::mem::take(&mut run), [began, at[1]], face, look);
                    }
                    if run.is_empty() {
                        (began, face) = (x, *own);
                    }
                    run.push_str(text);
                }
                Piece::Formula(formula) => {
                    if !run.is_empty() {
                        self.text(&std::mem::take(&mut run), [began, at[1]], face, look);
                    }
                    self.formula_marks(formula, [x, at[1]], look.size);
                }
                Piece::End => {}
            }
            x += piece.width(look.size);
        }
        if !run.is_empty() {
            self.text(&run, [began, at[1]], face, look);
        }
        self.say("\n");
    }

    fn text(&mut self, text: &str, at: [f64; 2], face: Face, look: Look) {
        self.say(text);
        let colour = if look.faint { Theme::Light.palette().faint } else { ink() };
        let text = text.trim_end().to_owned();
        self.put(Form::Text(Text { at, text, anchor: Anchor::Start, size: look.size, colour, face, halo: None }));
    }

    /// A formula within a line or on its own.
    fn formula_marks(&mut self, formula: &Formula, at: [f64; 2], size: f64) {
        self.say(&format!(" {} ", formula.words));
        for mark in formula.marks(at, size * super::line::FORMULA, ink()) {
            self.put(mark);
        }
    }

    /// A formula in the middle of a line of its own, smaller where it would be too wide.
    pub fn display(&mut self, formula: &Formula, indent: f64) {
        let room = WIDTH - indent;
        let em = Look::TEXT.size * super::line::FORMULA;
        let size = Look::TEXT.size * (room / (formula.width * em)).min(1.0);
        let em = size * super::line::FORMULA;
        let height = (formula.height + formula.depth) * em + 10.0;
        self.keep(height);
        let left = LEFT + indent + (room - formula.width * em) / 2.0;
        self.formula_marks(formula, [left, self.y + 3.0 + formula.height * em], size);
        self.gap(height + 4.0);
    }

    /// A drawing of that width on paper, with a frame around it.
    pub fn drawing(&mut self, drawing: &Drawing, width: f64) {
        let scale = width / drawing.width;
        let height = drawing.height * scale;
        self.gap(4.0);
        self.keep(height + 20.0);
        let at = [LEFT, self.y];
        self.say(&format!("\n{}\n", drawing.in_words()));
        if let Some(page) = self.pages.last_mut() {
            page.include_scaled(drawing, at, scale);
            let frame = Frame { low: at, high: [at[0] + width, at[1] + height] };
            let stroke = Stroke::solid(Theme::Light.palette().grid, 0.7);
            page.put(Form::Rect { frame, fill: None, stroke: Some(stroke) }, None);
        }
        self.gap(height + 3.0);
    }

    /// A thin line across the text.
    pub fn rule(&mut self, from: f64, to: f64) {
        let stroke = Stroke::solid(Theme::Light.palette().faint, 0.5);
        let y = self.y;
        self.put(Form::Line { points: vec![[LEFT + from, y], [LEFT + to, y]], stroke });
    }

    /// A line of a table: cells at their places.
    pub fn cells(&mut self, cells: &[(f64, Vec<Piece>)], look: Look) {
        let pieces = || cells.iter().flat_map(|(_, pieces)| pieces);
        let above = pieces().map(|piece| piece.height(look.size)).fold(look.size * 0.95, f64::max);
        let below = pieces().map(|piece| piece.depth(look.size)).fold(look.size * 0.3, f64::max);
        let height = above + below + 3.0;
        self.keep(height);
        let baseline = self.y + 1.5 + above;
        for (x, pieces) in cells {
            self.line(pieces, [LEFT + x, baseline], look);
        }
        self.gap(height);
    }

    fn put(&mut self, form: Form) {
        if let Some(page) = self.pages.last_mut() {
            page.put(form, None);
        }
    }

    /// Adds to what the page says in words.
    fn say(&mut self, words: &str) {
        if let Some(page) = self.pages.last_mut() {
            page.description.push_str(words);
        }
    }

    /// The pages, with their title and number at the foot.
    pub fn finished(mut self, title: &str) -> Vec<Drawing> {
        let count = self.pages.len();
        for (place, page) in self.pages.iter_mut().enumerate() {
            let foot = |text: String, x: f64, anchor| {
                let colour = Theme::Light.palette().faint;
                Form::Text(Text {
                    at: [x, PAGE[1] - 30.0],
                    text,
                    anchor,
                    size: 8.0,
                    colour,
                    face: Face::Sans,
                    halo: None,
                })
            };
            page.put(foot(title.to_owned(), LEFT, Anchor::Start), None);
            page.put(foot(format!("{} / {count}", place + 1), PAGE[0] - LEFT, Anchor::End), None);
        }
        self.pages
    }
}

fn ground() -> Colour {
    Theme::Light.palette().ground
}

fn ink() -> Colour {
    Theme::Light.palette().ink
}
