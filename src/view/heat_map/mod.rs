//! A value for each pixel of a picture, as colours with their legend.
//!
//! Each pixel is a square of whole points, so that no seams are seen between them. Where a picture has more pixels than the
//! drawing has room for, a square stands for the worst of several; of kinds and directions, which are not better or worse, for the
//! middle one.

mod colours;
mod legend;
mod signs;
#[cfg(test)]
mod tests;

use super::drawing::{Anchor, Drawing, Form, Frame, Spot, Stroke};
use super::fonts::Face;
use super::labels::{Label, shortened, wrapped};
use super::palette::{Colour, Palette, Theme};
use super::text::significant;
use crate::math::portable;
use colours::{Paint, SHADES};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A value for each pixel.
///
/// A value that is not a number means that there is nothing to tell; an infinite one that it is off the scale.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct HeatMap {
    /// One line.
    pub title: String,
    /// A line or two of explanation.
    pub notes: Vec<String>,
    /// Columns and rows.
    pub size: [usize; 2],
    /// How values become colours.
    pub scale: HeatScale,
    /// The unit, as it stands over the legend.
    pub unit: String,
    /// What a value of 0 means, where the scale is logarithmic and has no place for it.
    pub zero: Option<String>,
    /// What it means if there is no value.
    pub nothing: Option<String>,
    /// What it means if a value is infinite.
    pub beyond: Option<String>,
    /// Row by row from the top.
    pub values: Vec<f64>,
}

/// How values become colours.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum HeatScale {
    /// From one value to another. What lies outside has the colour of the nearer end.
    Linear([f64; 2]),
    /// Likewise, by logarithms.
    Log([f64; 2]),
    /// Each value is the place of its name in the list, from the best to the worst; three at most are told apart.
    Classes(Vec<String>),
    /// Each value is the place of its name in the list, which has no order; each kind has a colour and a number.
    Kinds(Vec<String>),
    /// The direction of each pixel, as a unit vector to the right, up and towards the eye; values say only whether there is one.
    Directions(Vec<[f64; 3]>),
}

impl Default for HeatScale {
    fn default() -> Self {
        Self::Linear([0.0, 1.0])
    }
}

/// Sizes in points.
const TITLE: f64 = 14.0;
const TEXT: f64 = 11.5;
const SMALL: f64 = 10.5;
const MARGIN: f64 = 14.0;
const LINE: f64 = 15.0;
/// The least side of a square: smaller ones would make files large and show no more.
const SMALLEST: f64 = 2.0;

/// Draws the map with its legend.
#[must_use]
pub fn heat_map(map: &HeatMap, size: [f64; 2], theme: Theme) -> Drawing {
    let palette = theme.palette();
    let mut drawing = Drawing::new(size, palette.ground);
    let room = heading(&mut drawing, map, palette);
    let (frame, pixels) = squares(map, room);
    let which = match map.scale {
        HeatScale::Kinds(_) | HeatScale::Directions(_) => "the middle one",
        _ => "the worst",
    };
    let note = || format!("each square is {which} of {pixels} × {pixels} pixels");
    let notes: Vec<String> = (pixels > 1).then(note).into_iter().collect();
    let squares = Squares::new(map, frame, pixels);
    squares.paint(&mut drawing, palette);
    signs::draw(&mut drawing, map, &squares);
    let stroke = Some(Stroke::solid(palette.faint, 1.0));
    drawing.put(Form::Rect { frame: frame.grown(0.5), fill: None, stroke }, None);
    let at =
        if is_upright(&drawing) { [frame.low[0], frame.high[1] + 14.0] } else { [frame.high[0] + 18.0, frame.low[1]] };
    let key = Frame { low: at, high: [drawing.width - 4.0, drawing.height - 8.0] };
    legend::draw(&mut drawing, map, palette, key, &notes);
    drawing.description = map.told();
    drawing
}

/// The title and the notes; returns what is left for the map.
fn heading(drawing: &mut Drawing, map: &HeatMap, palette: &Palette) -> Frame {
    let width = drawing.width - 2.0 * MARGIN;
    let mut y = MARGIN + 4.0;
    let title = shortened(&map.title, width, TITLE, Face::Bold);
    let title = Label::new(title, TITLE, palette.ink).face(Face::Bold);
    drawing.put(Form::Text(title.at([MARGIN, y], Anchor::Start, None)), None);
    y += LINE + 4.0;
    for note in &map.notes {
        for line in wrapped(note, width, TEXT, Face::Sans) {
            let line = Label::new(line, TEXT, palette.faint);
            drawing.put(Form::Text(line.at([MARGIN, y], Anchor::Start, None)), None);
            y += LINE;
        }
    }
    let bottom = drawing.height - MARGIN;
    let [right, bottom] = if is_upright(drawing) {
        [drawing.width - MARGIN, bottom - legend::HEIGHT]
    } else {
        [drawing.width - MARGIN - legend::WIDTH, bottom]
    };
    Frame { low: [MARGIN, (y + 2.0).round()], high: [right.max(MARGIN + 16.0), bottom.max(y + 18.0)] }
}

/// Whether there is so much more room below the map than beside it that the legend stands there.
fn is_upright(drawing: &Drawing) -> bool {
    drawing.height > 1.15 * drawing.width
}

/// Where the map lies, and how many pixels of the picture go along the side of a square.
fn squares(map: &HeatMap, room: Frame) -> (Frame, usize) {
    let [columns, rows] = map.size.map(|count| count.max(1));
    let [width, height] = room.size();
    let mut pixels = 1;
    loop {
        let counts = [columns.div_ceil(pixels), rows.div_ceil(pixels)].map(|count| count as f64);
        let side = (width / counts[0]).min(height / counts[1]).floor();
        // Beyond so many pixels a square no room is too small.
        if side >= SMALLEST || pixels > columns.max(rows) {
            let size = counts.map(|count| count * side.max(1.0));
            return (Frame { low: room.low, high: [room.low[0] + size[0], room.low[1] + size[1]] }, pixels);
        }
        pixels += 1;
    }
}

/// The squares of a map, each with what it is painted with.
struct Squares {
    frame: Frame,
    /// Columns and rows of squares.
    counts: [usize; 2],
    /// Pixels along the side of a square.
    pixels: usize,
    /// Row by row from the top.
    paints: Vec<Paint>,
}

impl Squares {
    fn new(map: &HeatMap, frame: Frame, pixels: usize) -> Self {
        let counts = map.size.map(|count| count.div_ceil(pixels));
        let all = (0..counts[1]).flat_map(|row| (0..counts[0]).map(move |column| [column, row]));
        let paint = |square: [usize; 2]| match &map.scale {
            HeatScale::Kinds(_) | HeatScale::Directions(_) => Paint::at(map, middle(map, square, pixels)),
            _ => Paint::of(map, worst(map, square, pixels)),
        };
        Self { frame, counts, pixels, paints: all.map(paint).collect() }
    }

    /// The side of a square, in points.
    fn side(&self) -> f64 {
        self.frame.size()[0] / self.counts[0].max(1) as f64
    }

    /// All squares: those of one colour are one mark, and neighbours in a row are one ring.
    fn paint(&self, drawing: &mut Drawing, palette: &Palette) {
        let (side, low) = (self.side(), self.frame.low);
        let mut rings: BTreeMap<Paint, Vec<Vec<[f64; 2]>>> = BTreeMap::new();
        for (row, paints) in self.paints.chunks(self.counts[0].max(1)).enumerate() {
            let mut column = 0;
            for run in paints.chunk_by(|a, b| a == b) {
                let [left, right] = [column, column + run.len()].map(|column| low[0] + side * column as f64);
                let [top, bottom] = [row, row + 1].map(|row| low[1] + side * row as f64);
                rings.entry(run[0]).or_default().push(vec![[left, top], [right, top], [right, bottom], [left, bottom]]);
                column += run.len();
            }
        }
        for (paint, rings) in rings {
            drawing.put(Form::Area { rings, fill: paint.colour(palette) }, None);
        }
    }
}

/// The place of the pixel in the middle of a square.
fn middle(map: &HeatMap, square: [usize; 2], pixels: usize) -> usize {
    let [x, y] = std::array::from_fn(|i| (square[i] * pixels + pixels / 2).min(map.size[i].saturating_sub(1)));
    y * map.size[0] + x
}

/// The largest value of a square of pixels: what is off the scale is worse than any, and nothing better than any.
fn worst(map: &HeatMap, [column, row]: [usize; 2], pixels: usize) -> f64 {
    let range = |from: usize, end: usize| from * pixels..((from + 1) * pixels).min(end);
    let places = range(row, map.size[1]).flat_map(|y| range(column, map.size[0]).map(move |x| y * map.size[0] + x));
    places.filter_map(|place| map.values.get(place)).copied().fold(f64::NAN, f64::max)
}

impl HeatMap {
    /// The colour of each pixel, row by row from the top.
    #[must_use]
    pub fn colours(&self, theme: Theme) -> Vec<Colour> {
        (0..self.values.len()).map(|place| Paint::at(self, place).colour(theme.palette())).collect()
    }

    /// The pixel that a drawing of the map in this size has at a place; of several in one square the upper left one.
    #[must_use]
    pub fn pixel_at(&self, size: [f64; 2], at: Spot) -> Option<[u32; 2]> {
        let palette = Theme::default().palette();
        let room = heading(&mut Drawing::new(size, palette.ground), self, palette);
        let (frame, pixels) = squares(self, room);
        let columns = self.size[0].max(1).div_ceil(pixels);
        let side = frame.size()[0] / columns as f64;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within the frame of the map")]
        let pixel: [usize; 2] = std::array::from_fn(|i| ((at[i] - frame.low[i]) / side).max(0.0) as usize * pixels);
        let is_within = frame.contains(at) && (0..2).all(|i| pixel[i] < self.size[i]);
        is_within.then(|| pixel.map(|place| u32::try_from(place).unwrap_or(u32::MAX)))
    }

    /// The map in words.
    fn told(&self) -> String {
        let known = || self.values.iter().copied().filter(|value| value.is_finite());
        let [least, most] = [known().fold(f64::INFINITY, f64::min), known().fold(f64::NEG_INFINITY, f64::max)];
        let what = match &self.scale {
            _ if known().next().is_none() => "Nothing is known of any pixel.".to_owned(),
            HeatScale::Classes(names) | HeatScale::Kinds(names) => legend::shares(self, names),
            HeatScale::Directions(_) => "Each pixel has the colour of its direction.".to_owned(),
            _ => format!("From {} to {} {}.", significant(least, 3), significant(most, 3), self.unit),
        };
        let [width, height] = self.size;
        format!("{}, a map of {width} × {height} pixels. {} {what}", self.title, self.notes.join(" "))
    }
}

impl HeatScale {
    /// Where a value lies, from 0 to 1.
    fn share(&self, value: f64) -> f64 {
        let between = |value: f64, [low, high]: [f64; 2]| {
            if high > low { ((value - low) / (high - low)).clamp(0.0, 1.0) } else { 0.5 }
        };
        match self {
            Self::Linear(range) => between(value, *range),
            Self::Directions(_) => 0.0,
            Self::Log(range) => between(
                portable::log10(value.max(f64::MIN_POSITIVE)),
                range.map(|end| portable::log10(end.max(f64::MIN_POSITIVE))),
            ),
            Self::Classes(names) | Self::Kinds(names) => between(value, [0.0, names.len().saturating_sub(1) as f64]),
        }
    }

    /// The place in the colours that a value has.
    fn shade(&self, value: f64) -> usize {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and the number of shades"
        )]
        let shade = (self.share(value) * (SHADES - 1) as f64).round() as usize;
        shade
    }
}
