//! What the colours of a map mean.

use super::colours::{Paint, SHADES};
use super::{HeatMap, HeatScale, SMALL, TEXT, signs};
use crate::math::portable;
use crate::view::axis::Axis;
use crate::view::drawing::{Anchor, Drawing, Form, Frame, Spot, Stroke};
use crate::view::fonts::Face;
use crate::view::labels::{Label, wrapped};
use crate::view::palette::Palette;
use crate::view::text::significant;

/// The width that legends need beside the map.
pub const WIDTH: f64 = 172.0;
/// The height that they need below it.
pub const HEIGHT: f64 = 230.0;
const BAR: f64 = 16.0;
const LONGEST_BAR: f64 = 260.0;
const SWATCH: f64 = 11.0;
const LINE: f64 = 14.0;
/// The width of a swatch with a number in it.
const NUMBER: f64 = 22.0;
/// The radius of the ball that shows directions.
const BALL: f64 = 44.0;

/// Draws the legend from the upper left corner of `room` down.
pub fn draw(drawing: &mut Drawing, map: &HeatMap, palette: &Palette, room: Frame, notes: &[String]) {
    let mut legend = Legend { drawing, map, palette, room, y: room.low[1] };
    match &map.scale {
        HeatScale::Linear(range) => legend.bar(*range, false),
        HeatScale::Log(range) => legend.bar(*range, true),
        HeatScale::Classes(names) => {
            for (k, name) in names.iter().enumerate() {
                legend.swatch(Paint::Class(k), name);
            }
        }
        HeatScale::Kinds(names) => legend.kinds(names),
        HeatScale::Directions(_) => legend.ball(),
    }
    let others = [(Paint::Zero, &map.zero), (Paint::Nothing, &map.nothing), (Paint::Beyond, &map.beyond)];
    for (paint, name) in others {
        if let Some(name) = name {
            legend.swatch(paint, name);
        }
    }
    for note in notes {
        legend.words(note, room.low[0]);
    }
}

struct Legend<'a> {
    drawing: &'a mut Drawing,
    map: &'a HeatMap,
    palette: &'a Palette,
    room: Frame,
    y: f64,
}

impl Legend<'_> {
    fn text(&mut self, text: &str, at: Spot) {
        let label = Label::new(text, SMALL, self.palette.ink);
        self.drawing.put(Form::Text(label.at(at, Anchor::Start, None)), None);
    }

    /// The colours of a scale from bottom to top, with numbers beside them.
    fn bar(&mut self, range: [f64; 2], by_logarithm: bool) {
        let x = self.room.low[0];
        let unit = Label::new(&self.map.unit, TEXT, self.palette.ink);
        self.drawing.put(Form::Text(unit.at([x, self.y + 6.0], Anchor::Start, None)), None);
        // Below the bar there is room for three swatches of two lines.
        let top = self.y + 20.0;
        let length = (self.room.high[1] - top - 6.0 * LINE - 12.0).clamp(24.0, LONGEST_BAR).round();
        let step = length / SHADES as f64;
        for k in 0..SHADES {
            let low = top + length - (k as f64 + 1.0) * step;
            // Each goes under the next one, so that no seam is seen between them.
            let frame = Frame { low: [x, low], high: [x + BAR, (low + step + 0.6).min(top + length)] };
            let fill = Some(Paint::Shade(k).colour(self.palette));
            self.drawing.put(Form::Rect { frame, fill, stroke: None }, None);
        }
        let rim = Stroke::solid(self.palette.faint, 1.0);
        let frame = Frame { low: [x, top], high: [x + BAR, top + length] };
        self.drawing.put(Form::Rect { frame, fill: None, stroke: Some(rim) }, None);
        let mut free_below = f64::INFINITY;
        for value in ticks(range, by_logarithm, length / 26.0) {
            let y = top + length * (1.0 - self.map.scale.share(value));
            if y > free_below {
                continue;
            }
            free_below = y - LINE;
            let points = vec![[x + BAR, y], [x + BAR + 4.0, y]];
            self.drawing.put(Form::Line { points, stroke: rim }, None);
            self.text(&number(value, by_logarithm), [x + BAR + 8.0, y]);
        }
        self.y = top + length + 18.0;
    }

    /// A number in its colour for each kind, as far as there is room.
    fn kinds(&mut self, names: &[String]) {
        for (k, name) in names.iter().enumerate() {
            let left = names.len() - k;
            if self.y + 4.0 * LINE > self.room.high[1] && left > 1 {
                self.words(&format!("and {left} more, with numbers of their own"), self.room.low[0]);
                return;
            }
            let number = (k + 1).to_string();
            // As high as a line, about the middle of the words.
            let [top, bottom] = [-0.5, 0.5].map(|half| self.y + 0.5 * SWATCH + half * LINE);
            let frame = Frame { low: [self.room.low[0], top], high: [self.room.low[0] + NUMBER, bottom] };
            let (fill, rim) = (Paint::Kind(k).colour(self.palette), Stroke::solid(self.palette.faint, 1.0));
            self.drawing.put(Form::Rect { frame, fill: Some(fill), stroke: Some(rim) }, None);
            signs::number(self.drawing, &number, frame.middle());
            let count = self.count(Paint::Kind(k));
            self.words(&format!("{name}: {}", share(count, self.map.values.len())), self.room.low[0] + NUMBER + 6.0);
        }
    }

    /// A ball as it would be seen: each direction in its colour, with needles as they stand in the map.
    fn ball(&mut self) {
        let centre = [self.room.low[0] + BALL + 4.0, self.y + BALL + LINE];
        self.text("up: green", [self.room.low[0], self.y + 0.5 * SWATCH]);
        signs::ball(self.drawing, centre, BALL, self.palette);
        self.text("right:", [centre[0] + BALL + 8.0, centre[1] - 0.5 * LINE]);
        self.text("red", [centre[0] + BALL + 8.0, centre[1] + 0.5 * LINE]);
        self.y = centre[1] + BALL + 8.0;
        self.words("towards the eye: blue", self.room.low[0]);
        self.words("A needle shows where the normal leans.", self.room.low[0]);
    }

    fn count(&self, paint: Paint) -> usize {
        (0..self.map.values.len()).filter(|&place| Paint::at(self.map, place) == paint).count()
    }

    /// A colour, what it means, and how much of the picture has it.
    fn swatch(&mut self, paint: Paint, name: &str) {
        let count = self.count(paint);
        let frame = Frame { low: [self.room.low[0], self.y], high: [self.room.low[0] + SWATCH, self.y + SWATCH] };
        let (fill, rim) = (Some(paint.colour(self.palette)), Stroke::solid(self.palette.faint, 1.0));
        self.drawing.put(Form::Rect { frame, fill, stroke: Some(rim) }, None);
        self.words(&format!("{name}: {}", share(count, self.map.values.len())), self.room.low[0] + SWATCH + 6.0);
    }

    /// A text in two lines at most.
    fn words(&mut self, text: &str, x: f64) {
        for line in wrapped(text, self.room.high[0] - x, SMALL, Face::Sans) {
            self.text(&line, [x, self.y + 0.5 * SWATCH]);
            self.y += LINE;
        }
        self.y += 4.0;
    }
}

/// Round values of a scale, about so many.
fn ticks([low, high]: [f64; 2], by_logarithm: bool, count: f64) -> Vec<f64> {
    if !by_logarithm {
        return Axis { values: [low, high], points: [0.0, 1.0] }.ticks(count);
    }
    let ends = [low, high].map(|end| portable::log10(end.max(f64::MIN_POSITIVE)));
    let decades = ends[1] - ends[0];
    let within = |value: &f64| (ends[0] - 1e-9..=ends[1] + 1e-9).contains(&portable::log10(*value));
    let steps: &[f64] = if decades <= 0.5 * count { &[1.0, 2.0, 5.0] } else { &[1.0] };
    #[expect(clippy::cast_possible_truncation, reason = "logarithms of f64 are a few hundred")]
    let powers = ends[0].floor() as i32..=ends[1].ceil() as i32;
    powers.flat_map(|power| steps.iter().map(move |step| step * portable::powi(10.0, power))).filter(within).collect()
}

fn number(value: f64, by_logarithm: bool) -> String {
    if by_logarithm && !(1e-3..1e6).contains(&value) {
        return crate::view::frontier_plot::error(value);
    }
    significant(value, 3)
}

/// Which kinds have which share, in words.
pub fn shares(map: &HeatMap, names: &[String]) -> String {
    let count = |k: usize| map.values.iter().filter(|&&value| value == k as f64).count();
    let one = |(k, name): (usize, &String)| format!("{name}: {}", share(count(k), map.values.len()));
    names.iter().enumerate().map(one).collect::<Vec<_>>().join("; ") + "."
}

/// A share of all pixels, or the number of them where that says more.
fn share(count: usize, all: usize) -> String {
    let percent = 100.0 * count as f64 / all.max(1) as f64;
    match count {
        0 => "none".to_owned(),
        1 => "1 pixel".to_owned(),
        _ if percent < 0.1 => format!("{count} pixels"),
        _ if percent > 99.95 && count < all => format!("all but {}", all - count),
        _ => format!("{} %", significant(percent, 3)),
    }
}
