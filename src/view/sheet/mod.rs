//! What drawings of single events share: a caption, a column of facts, marks that stay within a frame, and the words that
//! tell all of it to whoever does not see it.

mod chart;
mod clip;

pub(super) use chart::{Chart, Oblique, bounds, within_axes};
use clip::{clipped_line, clipped_ring};

use crate::math::portable;
use crate::record::EventId;
use crate::view::fonts::text_width;
use crate::view::labels::{Label, Placer, shortened, wrapped};
use crate::view::palette::{Colour, Palette};
use crate::view::scene_colour::legible;
pub(super) use crate::view::scene_colour::{ink_on, seen_on, shown};
use crate::view::{Anchor, Drawing, Face, Form, Frame, Spot, Stroke, Theme};

/// Sizes in points.
pub(super) const TEXT: f64 = 11.5;
pub(super) const SMALL: f64 = 10.5;
const MARGIN: f64 = 12.0;
const TITLE: f64 = 13.0;
const LINE: f64 = 18.0;
const SAMPLE: f64 = 16.0;

/// A line of the column at the right: what was found, or what a mark stands for.
pub(super) enum Fact {
    /// Words alone.
    Words(String),
    /// A colour of the scene.
    Swatch(Colour, String),
    /// A line of the drawing.
    Line(Stroke, String),
    /// A dot of the drawing.
    Dot(Colour, String),
}

impl Fact {
    pub fn words(text: impl Into<String>) -> Self {
        Self::Words(text.into())
    }

    fn text(&self) -> &str {
        match self {
            Self::Words(text) | Self::Swatch(_, text) | Self::Line(_, text) | Self::Dot(_, text) => text,
        }
    }

    fn indent(&self) -> f64 {
        if matches!(self, Self::Words(_)) { 0.0 } else { SAMPLE + 6.0 }
    }
}

/// A name that gets its place once all lines are known.
struct Name {
    /// What is written, longer ones first: the first that finds room.
    labels: Vec<Label>,
    around: Spot,
    gap: f64,
}

/// A drawing in the making.
pub(super) struct Sheet {
    pub drawing: Drawing,
    pub placer: Placer,
    pub palette: &'static Palette,
    /// The event that new marks stand for.
    pub event: EventId,
    names: Vec<Name>,
}

impl Sheet {
    pub fn new(size: [f64; 2], theme: Theme, event: EventId) -> Self {
        let palette = theme.palette();
        let drawing = Drawing::new(size, palette.ground);
        Self { placer: Placer::new(drawing.frame().grown(-2.0)), drawing, palette, event, names: Vec::new() }
    }

    /// The drawing, with its names in their places and all texts above all lines.
    pub fn finish(mut self) -> Drawing {
        self.place_names();
        let (texts, marks) = self.drawing.marks.into_iter().partition(|mark| matches!(mark.form, Form::Text(_)));
        self.drawing.marks = marks;
        self.drawing.marks.extend::<Vec<_>>(texts);
        self.drawing
    }

    /// Puts the names so far where they cover least of what was drawn so far.
    pub fn place_names(&mut self) {
        for Name { labels, around, gap } in std::mem::take(&mut self.names) {
            let mut put = |label| self.placer.put_near(&mut self.drawing, around, gap, label, self.palette);
            let _ = labels.iter().any(&mut put);
        }
    }

    /// The heading and a note of three lines at most; returns the room that is left below them.
    pub fn caption(&mut self, title: &str, note: &str) -> Frame {
        let width = self.drawing.width - 2.0 * MARGIN;
        let mut y = MARGIN + 0.5 * TITLE;
        self.tell(title);
        self.tell(note);
        let title = Label::new(shortened(title, width, TITLE, Face::Bold), TITLE, self.palette.ink).face(Face::Bold);
        self.placer.put_at(&mut self.drawing, title.at([MARGIN, y], Anchor::Start, None), Some(self.event));
        for line in wrapped(note, width, TEXT, Face::Sans) {
            y += LINE;
            self.write(&line, [MARGIN, y], Anchor::Start, TEXT, self.palette.faint);
        }
        Frame { low: [MARGIN, y + LINE], high: [self.drawing.width - MARGIN, self.drawing.height - MARGIN] }
    }

    /// Adds a sentence to what is told to whoever does not see the drawing.
    pub fn tell(&mut self, sentence: &str) {
        let (told, sentence) = (&mut self.drawing.description, sentence.trim());
        if sentence.is_empty() {
            return;
        }
        if !told.is_empty() {
            told.push(' ');
        }
        told.push_str(sentence);
        if !sentence.ends_with(['.', '!', '?', ':', '…']) {
            told.push('.');
        }
    }

    /// Puts facts in a column at the right of `room` where there is room for one; returns what is left beside the
    /// column, and what is left of the column below the facts.
    pub fn facts(&mut self, room: Frame, facts: &[Fact]) -> (Frame, Option<Frame>) {
        /// A narrower column would cut most facts off; beside a narrower drawing nothing could be told.
        const NARROWEST: [f64; 2] = [110.0, 150.0];
        for fact in facts {
            self.tell(fact.text());
        }
        let wanted =
            facts.iter().map(|fact| fact.indent() + text_width(fact.text(), TEXT, Face::Sans)).fold(0.0, f64::max);
        // As wide as is wanted, if that leaves enough beside it.
        let most = (0.4 * room.size()[0]).max((room.size()[0] - NARROWEST[1] - 16.0).min(0.55 * room.size()[0]));
        let width = wanted.min(most);
        if width < NARROWEST[0].min(wanted) || room.size()[0] - width < NARROWEST[1] {
            return (room, None);
        }
        let left = room.high[0] - width - 1.0;
        let mut y = room.low[1] + 0.5 * LINE;
        for fact in facts {
            self.fact(fact, [left, y], width);
            y += LINE;
        }
        // Names of marks stay out of the column.
        self.placer.reserve(Frame { low: [left - 8.0, room.low[1]], high: [room.high[0], y - 0.5 * LINE] });
        let beside = Frame { low: room.low, high: [left - 16.0, room.high[1]] };
        (beside, Some(Frame { low: [left, y], high: room.high }))
    }

    fn fact(&mut self, fact: &Fact, [left, y]: Spot, width: f64) {
        if y + LINE > self.drawing.height {
            return;
        }
        let middle = [left + 0.5 * SAMPLE, y];
        match fact {
            Fact::Words(_) => {}
            Fact::Swatch(colour, _) => {
                let frame = Frame { low: middle, high: middle }.grown(0.44 * SAMPLE);
                self.swatch(frame, *colour);
            }
            Fact::Line(stroke, _) => {
                let points = vec![[left, y], [left + SAMPLE, y]];
                self.drawing.put(Form::Line { points, stroke: *stroke }, None);
            }
            Fact::Dot(colour, _) => self.dot(middle, 4.5, *colour),
        }
        let text = shortened(fact.text(), width - fact.indent(), TEXT, Face::Sans);
        self.write(&text, [left + fact.indent(), y], Anchor::Start, TEXT, self.palette.ink);
    }

    /// A colour of the scene with a rim, so that it is seen on a ground of the same colour too.
    pub fn swatch(&mut self, frame: Frame, colour: Colour) {
        let stroke = Some(Stroke::solid(self.palette.faint, 0.8));
        self.drawing.put(Form::Rect { frame, fill: Some(colour), stroke }, self.event);
    }

    /// Writes a text with its middle at the height of `at`, if it covers no other and is not cut off.
    pub fn write(&mut self, text: &str, at: Spot, anchor: Anchor, size: f64, colour: Colour) -> bool {
        if text.is_empty() {
            return false;
        }
        let text = Label::new(text, size, colour).at(at, anchor, None);
        self.placer.put_at(&mut self.drawing, text, Some(self.event))
    }

    /// The same where lines may run below it.
    pub fn write_over(&mut self, text: &str, at: Spot, anchor: Anchor, size: f64, colour: Colour) -> bool {
        let text = Label::new(text, size, colour).at(at, anchor, Some(self.palette.ground));
        self.placer.put_at(&mut self.drawing, text, Some(self.event))
    }

    /// Writes a text near a place, where it covers least of the whole drawing.
    pub fn write_near(&mut self, text: &str, around: Spot, gap: f64, colour: Colour) {
        self.write_one_near(&[text], around, gap, colour);
    }

    /// The same with the first of several texts that finds room.
    pub fn write_one_near(&mut self, texts: &[&str], around: Spot, gap: f64, colour: Colour) {
        let colour = legible(self.palette, colour);
        let labels = texts.iter().map(|text| Label::new(*text, TEXT, colour).of(self.event)).collect();
        self.names.push(Name { labels, around, gap });
    }

    /// A line from point to point, as far as it lies within the frame. Names keep off it if it is no grid's.
    pub fn line(&mut self, within: &Frame, points: &[Spot], stroke: Stroke) {
        for points in clipped_line(within, points) {
            if stands_out(stroke) {
                self.placer.avoid_outline(&points);
            }
            self.drawing.put(Form::Line { points, stroke }, self.event);
        }
    }

    /// The same back to where it began.
    pub fn outline(&mut self, within: &Frame, ring: &[Spot], stroke: Stroke) {
        let closed: Vec<Spot> = ring.iter().chain(ring.first()).copied().collect();
        self.line(within, &closed, stroke);
    }

    /// A part of a circle between two angles in radians, from the x axis towards the y axis.
    pub fn arc(&mut self, centre: Spot, radius: f64, angles: [f64; 2], stroke: Stroke) {
        const PARTS: u32 = 12;
        let along = |part: u32| angles[0] + (angles[1] - angles[0]) * f64::from(part) / f64::from(PARTS);
        let (sin, cos) = (|part| portable::sin(along(part)), |part| portable::cos(along(part)));
        let points: Vec<Spot> =
            (0..=PARTS).map(|part| [centre[0] + radius * cos(part), centre[1] + radius * sin(part)]).collect();
        self.placer.avoid_outline(&points);
        self.drawing.put(Form::Arc { centre, radius, angles, stroke }, self.event);
    }

    /// The area that an odd number of rings go round, as far as it lies within the frame.
    pub fn area(&mut self, within: &Frame, rings: &[Vec<Spot>], fill: Colour) {
        let rings: Vec<_> = rings.iter().map(|ring| clipped_ring(within, ring)).filter(|ring| ring.len() > 2).collect();
        if !rings.is_empty() {
            self.drawing.put(Form::Area { rings, fill }, self.event);
        }
    }

    /// A disc that stands off from what lies below, unless it would be cut off.
    pub fn dot(&mut self, centre: Spot, radius: f64, fill: Colour) {
        let frame = Frame { low: centre, high: centre }.grown(radius + 1.0);
        if self.drawing.frame().holds(&frame) {
            let stroke = Some(Stroke::solid(self.palette.ground, 1.5));
            self.drawing.put(Form::Circle { centre, radius, fill: Some(fill), stroke }, self.event);
            self.placer.reserve(frame.grown(-1.0));
        }
    }

    /// A point that may lie on top of anything, if it lies within the frame.
    pub fn mark(&mut self, within: &Frame, centre: Spot, radius: f64, fill: Colour) {
        if within.grown(0.5).contains(centre) {
            let stroke = Some(Stroke::solid(self.palette.ground, 1.5));
            self.drawing.put(Form::Circle { centre, radius, fill: Some(fill), stroke }, self.event);
            self.placer.avoid_spot(centre, radius);
        }
    }

    /// An arrow, unless it would be cut off or is too short for a head.
    pub fn arrow(&mut self, from: Spot, to: Spot, colour: Colour, width: f64) -> bool {
        let canvas = self.drawing.frame();
        let seen = crate::view::drawing::length([to[0] - from[0], to[1] - from[1]]) > 3.0
            && canvas.contains(from)
            && canvas.contains(to);
        if seen {
            let stroke = Stroke::solid(colour, width);
            self.drawing.put(Form::Arrow { from, to, head: 5.0 + 2.0 * width, stroke }, self.event);
            self.placer.avoid_line(from, to);
        }
        seen
    }
}

/// Whether a text across such a line would be hard to read.
fn stands_out(stroke: Stroke) -> bool {
    stroke.width >= 0.9 && stroke.colour.a > 100
}

/// Whether there is room for a drawing at all.
pub(super) fn is_roomy(frame: &Frame) -> bool {
    let [width, height] = frame.size();
    width >= 60.0 && height >= 40.0
}

/// The corners of a frame, in their order about it.
pub(super) fn rim(frame: &Frame) -> Vec<Spot> {
    let ([left, top], [right, bottom]) = (frame.low, frame.high);
    vec![[left, top], [right, top], [right, bottom], [left, bottom]]
}
