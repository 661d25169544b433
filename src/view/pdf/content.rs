//! The marks of a drawing as the operators of a page.
//!
//! Points of a drawing count downwards and those of a page upwards: the page is turned over once, and every line of text is
//! turned back.

use super::embedded::FontSet;
use crate::math::portable;
use crate::view::drawing::{Anchor, Drawing, Form, Frame, HALO, Spot, Stroke, Text};
use crate::view::fonts::placed;
use crate::view::outline::Pen;
use crate::view::paint::arrow_head;
use crate::view::palette::Colour;
use pdf_writer::types::{LineCapStyle, LineJoinStyle, TextRenderingMode};
use pdf_writer::{Content, Name, Str, TextStr};
use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_4, TAU};

/// The number of a page's only tagged content.
pub const FIGURE: i32 = 0;

/// The operators of a page and the opacities that they ask for.
pub struct PageContent {
    /// The operators.
    pub bytes: Vec<u8>,
    /// Opacities below 255.
    pub alphas: BTreeSet<u8>,
}

/// The name of an opacity among a page's resources.
pub fn alpha_name(alpha: u8) -> String {
    format!("A{alpha}")
}

/// PDF readers keep numbers in `f32`; a drawing of 16,384 points has 2⁻¹⁰ of a point left.
#[expect(clippy::cast_possible_truncation, reason = "see above")]
pub fn narrow(x: f64) -> f32 {
    // Thousandths of a point, so that numbers take few digits.
    ((x * 1000.0).round() / 1000.0) as f32
}

/// The page of a drawing.
pub fn content_of(drawing: &Drawing, fonts: &mut FontSet) -> PageContent {
    let mut page = Page { content: Content::new(), alphas: BTreeSet::new(), alpha: 255, fonts };
    page.content.begin_marked_content_with_properties(Name(b"Figure")).properties().identify(FIGURE);
    page.content.transform([1.0, 0.0, 0.0, -1.0, 0.0, narrow(drawing.height)]);
    page.content.set_line_join(LineJoinStyle::RoundJoin);
    page.rectangle(&drawing.frame());
    page.fill(drawing.background);
    for mark in &drawing.marks {
        page.form(&mark.form);
    }
    page.content.end_marked_content();
    let alphas = page.alphas;
    PageContent { bytes: page.content.finish().into_vec(), alphas }
}

struct Page<'a> {
    content: Content,
    alphas: BTreeSet<u8>,
    /// The opacity that is set.
    alpha: u8,
    fonts: &'a mut FontSet,
}

impl Page<'_> {
    fn form(&mut self, form: &Form) {
        match form {
            Form::Line { points, stroke } => {
                self.path(points, false);
                self.stroke(stroke);
            }
            Form::Area { rings, fill } => {
                for ring in rings {
                    self.path(ring, true);
                }
                self.fill(*fill);
            }
            Form::Circle { centre, radius, fill, stroke } => {
                self.painted(*fill, *stroke, |page| {
                    page.arc(*centre, *radius, [0.0, TAU]);
                    page.content.close_path();
                });
            }
            Form::Arc { centre, radius, angles, stroke } => {
                self.arc(*centre, *radius, *angles);
                self.stroke(stroke);
            }
            Form::Arrow { from, to, head, stroke } => {
                let (shaft_end, tip) = arrow_head(*from, *to, *head);
                self.path(&[*from, shaft_end], false);
                self.stroke(stroke);
                self.path(&tip, true);
                self.fill(stroke.colour);
            }
            Form::Rect { frame, fill, stroke } => self.painted(*fill, *stroke, |page| page.rectangle(frame)),
            Form::Text(text) => self.text(text),
            Form::Outline { steps, fill } => self.outline(steps, *fill),
        }
    }

    /// PDF has cubic curves alone: a parabola is one whose control points lie two thirds of the way to its own.
    fn outline(&mut self, steps: &[Pen], fill: Colour) {
        let mut pen = [0.0; 2];
        for step in steps {
            match *step {
                Pen::Move(end) => {
                    self.content.move_to(narrow(end[0]), narrow(end[1]));
                }
                Pen::Line(end) => {
                    self.content.line_to(narrow(end[0]), narrow(end[1]));
                }
                Pen::Quad(control, end) => {
                    let towards = |from: Spot| std::array::from_fn(|i| from[i] + (control[i] - from[i]) * 2.0 / 3.0);
                    self.curve(towards(pen), towards(end), end);
                }
                Pen::Cubic(one, other, end) => self.curve(one, other, end),
                Pen::Close => {
                    self.content.close_path();
                }
            }
            pen = step.spots().last().unwrap_or(pen);
        }
        self.set_alpha(fill.a);
        let [r, g, b] = channels(fill);
        self.content.set_fill_rgb(r, g, b).fill_nonzero();
    }

    fn curve(&mut self, one: Spot, other: Spot, end: Spot) {
        let [[x1, y1], [x2, y2], [x, y]] = [one, other, end].map(|spot| spot.map(narrow));
        self.content.cubic_to(x1, y1, x2, y2, x, y);
    }

    /// The same path filled and then stroked, as far as either is asked for.
    fn painted(&mut self, fill: Option<Colour>, stroke: Option<Stroke>, path: impl Fn(&mut Self)) {
        if let Some(fill) = fill {
            path(self);
            self.fill(fill);
        }
        if let Some(stroke) = stroke {
            path(self);
            self.stroke(&stroke);
        }
    }

    fn fill(&mut self, colour: Colour) {
        self.set_alpha(colour.a);
        let [r, g, b] = channels(colour);
        self.content.set_fill_rgb(r, g, b).fill_even_odd();
    }

    fn stroke(&mut self, stroke: &Stroke) {
        self.set_alpha(stroke.colour.a);
        let [r, g, b] = channels(stroke.colour);
        let cap = if stroke.dash.is_some() { LineCapStyle::ButtCap } else { LineCapStyle::RoundCap };
        let dash = stroke.dash.map(|dash| dash.map(narrow));
        self.content.set_stroke_rgb(r, g, b).set_line_width(narrow(stroke.width)).set_line_cap(cap);
        self.content.set_dash_pattern(dash.into_iter().flatten(), 0.0).stroke();
    }

    fn set_alpha(&mut self, alpha: u8) {
        if alpha != self.alpha {
            self.content.set_parameters(Name(alpha_name(alpha).as_bytes()));
            self.alphas.insert(alpha);
            self.alpha = alpha;
        }
    }

    fn path(&mut self, points: &[Spot], close: bool) {
        for (i, at) in points.iter().enumerate() {
            let [x, y] = at.map(narrow);
            if i == 0 {
                self.content.move_to(x, y)
            } else {
                self.content.line_to(x, y)
            };
        }
        if close && !points.is_empty() {
            self.content.close_path();
        }
    }

    fn rectangle(&mut self, frame: &Frame) {
        let ([x, y], [width, height]) = (frame.low, frame.size());
        self.content.rect(narrow(x), narrow(y), narrow(width), narrow(height));
    }

    /// An arc as cubic curves of an eighth of a turn at most, each within 4·10⁻⁶ radii of the circle (control points at
    /// 4/3 tan(angle/4)).
    fn arc(&mut self, centre: Spot, radius: f64, [from, to]: [f64; 2]) {
        let pieces = ((to - from).abs() / FRAC_PI_4).ceil().clamp(1.0, 64.0);
        let step = (to - from) / pieces;
        let reach = radius * 4.0 / 3.0 * portable::tan(step / 4.0);
        let at = |angle: f64| [centre[0] + radius * portable::cos(angle), centre[1] + radius * portable::sin(angle)];
        let [x, y] = at(from).map(narrow);
        self.content.move_to(x, y);
        let mut angle = from;
        let mut drawn = 0.0;
        while drawn < pieces {
            let (a, b) = (angle, angle + step);
            let (p, q) = (at(a), at(b));
            let c = [p[0] - reach * portable::sin(a), p[1] + reach * portable::cos(a)].map(narrow);
            let d = [q[0] + reach * portable::sin(b), q[1] - reach * portable::cos(b)].map(narrow);
            let [x, y] = q.map(narrow);
            self.content.cubic_to(c[0], c[1], d[0], d[1], x, y);
            angle = b;
            drawn += 1.0;
        }
    }

    /// A halo is the same text stroked below it; a reader that copies text is told that it says nothing.
    fn text(&mut self, text: &Text) {
        if let Some(halo) = text.halo {
            self.set_alpha(halo.a);
            let [r, g, b] = channels(halo);
            self.content.begin_marked_content_with_properties(Name(b"Span")).properties().actual_text(TextStr(""));
            self.content.set_stroke_rgb(r, g, b).set_line_width(narrow(HALO * text.size));
            self.content.set_line_cap(LineCapStyle::RoundCap).set_dash_pattern([], 0.0);
            self.letters(text, TextRenderingMode::Stroke);
            self.content.end_marked_content();
        }
        self.set_alpha(text.colour.a);
        let [r, g, b] = channels(text.colour);
        self.content.set_fill_rgb(r, g, b);
        self.letters(text, TextRenderingMode::Fill);
    }

    /// One run for each stretch of characters that come from the same font.
    fn letters(&mut self, text: &Text, mode: TextRenderingMode) {
        let left = match text.anchor {
            Anchor::Start => text.at[0],
            Anchor::Middle | Anchor::End => text.frame().low[0],
        };
        let letters = placed(&text.text, text.face);
        self.content.begin_text().set_text_rendering_mode(mode);
        for run in letters.chunk_by(|a, b| a.font == b.font) {
            let codes: Vec<u8> = run.iter().flat_map(|letter| self.fonts.code(letter).to_be_bytes()).collect();
            let name = FontSet::name(run[0].font);
            self.content.set_font(Name(name.as_bytes()), narrow(text.size));
            let x = narrow(left + run[0].x * text.size);
            self.content.set_text_matrix([1.0, 0.0, 0.0, -1.0, x, narrow(text.at[1])]).show(Str(&codes));
        }
        self.content.end_text();
    }
}

fn channels(colour: Colour) -> [f32; 3] {
    // Four digits tell all 256 levels apart.
    [colour.r, colour.g, colour.b].map(|level| (f32::from(level) / 255.0 * 1e4).round() / 1e4)
}
