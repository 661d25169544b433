//! What a map says without colour: numbers on kinds, needles on directions.

use super::colours::Paint;
use super::{HeatMap, HeatScale, SMALL, Squares, middle};
use crate::view::drawing::{Anchor, Drawing, Form, Spot, Stroke};
use crate::view::fonts::Face;
use crate::view::labels::Label;
use crate::view::palette::{Colour, Palette};
use std::collections::BTreeMap;

/// The side of the smallest stretch of one kind that a number is put on, in points.
const ROOM: f64 = 16.0;
/// The distance between needles, in points.
const BETWEEN: f64 = 26.0;
/// The length of a needle that lies in the picture's plane, in points.
const LENGTH: f64 = 11.0;
/// Numbers and needles are dark on light, whatever lies below them.
const INK: Colour = Colour::hex(0x10_10_18);
const HALO: Colour = Colour::hex(0xff_ff_ff);

/// Puts numbers on kinds and needles on directions.
pub fn draw(drawing: &mut Drawing, map: &HeatMap, squares: &Squares) {
    match &map.scale {
        HeatScale::Kinds(_) => numbers(drawing, squares),
        HeatScale::Directions(directions) => needles(drawing, map, directions, squares),
        _ => {}
    }
}

/// A number in the middle of a place.
pub fn number(drawing: &mut Drawing, number: &str, at: Spot) {
    let label = Label::new(number, SMALL, INK).face(Face::Bold);
    drawing.put(Form::Text(label.at(at, Anchor::Middle, Some(HALO))), None);
}

/// The number of its kind on the widest place of each stretch of one kind that is wide enough.
fn numbers(drawing: &mut Drawing, squares: &Squares) {
    let regions = regions(squares);
    let widths = widths(squares);
    let mut widest: BTreeMap<usize, (usize, usize)> = BTreeMap::new();
    for (place, (&region, &width)) in regions.iter().zip(&widths).enumerate() {
        let best = widest.entry(region).or_insert((width, place));
        if width > best.0 {
            *best = (width, place);
        }
    }
    let (side, columns) = (squares.side(), squares.counts[0]);
    for (width, place) in widest.into_values() {
        let Paint::Kind(kind) = squares.paints[place] else { continue };
        if width as f64 * side >= ROOM {
            // The square ends at this place, to the right and below.
            let corner = [place % columns + 1, place / columns + 1];
            let at = std::array::from_fn(|i| squares.frame.low[i] + side * (corner[i] as f64 - 0.5 * width as f64));
            number(drawing, &(kind + 1).to_string(), at);
        }
    }
}

/// The side of the largest square of one paint that ends at each place.
fn widths(squares: &Squares) -> Vec<usize> {
    let columns = squares.counts[0];
    let mut widths: Vec<usize> = Vec::with_capacity(squares.paints.len());
    for (place, paint) in squares.paints.iter().enumerate() {
        let before = |back: usize| {
            let is_same = squares.paints[place - back] == *paint;
            if is_same { widths[place - back] } else { 0 }
        };
        let is_inner = place % columns > 0 && place >= columns;
        widths.push(if is_inner { 1 + before(1).min(before(columns)).min(before(columns + 1)) } else { 1 });
    }
    widths
}

/// For each square the first place of the stretch of one paint that it belongs to.
fn regions(squares: &Squares) -> Vec<usize> {
    const UNKNOWN: usize = usize::MAX;
    let (columns, count) = (squares.counts[0], squares.paints.len());
    let mut regions = vec![UNKNOWN; count];
    let mut open = Vec::new();
    for first in 0..count {
        if regions[first] != UNKNOWN {
            continue;
        }
        regions[first] = first;
        open.push(first);
        while let Some(place) = open.pop() {
            let (column, row) = (place % columns, place / columns);
            let beside = [
                (column > 0).then(|| place - 1),
                (column + 1 < columns).then_some(place + 1),
                (row > 0).then(|| place - columns),
                (place + columns < count).then_some(place + columns),
            ];
            for other in beside.into_iter().flatten() {
                if regions[other] == UNKNOWN && squares.paints[other] == squares.paints[first] {
                    regions[other] = first;
                    open.push(other);
                }
            }
        }
    }
    regions
}

fn needles(drawing: &mut Drawing, map: &HeatMap, directions: &[[f64; 3]], squares: &Squares) {
    let side = squares.side();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few squares")]
    let step = (BETWEEN / side).ceil().max(1.0) as usize;
    let rows = (step / 2..squares.counts[1]).step_by(step);
    for [column, row] in
        rows.flat_map(|row| (step / 2..squares.counts[0]).step_by(step).map(move |column| [column, row]))
    {
        let place = middle(map, [column, row], squares.pixels);
        let is_known = map.values.get(place).is_some_and(|value| !value.is_nan());
        if let (true, Some(&direction)) = (is_known, directions.get(place)) {
            let at = [column, row].map(|k| k as f64 + 0.5);
            needle(drawing, std::array::from_fn(|i| squares.frame.low[i] + side * at[i]), direction);
        }
    }
}

/// A line that leans as the direction does, with a dot where it stands.
fn needle(drawing: &mut Drawing, at: Spot, [right, up, _]: [f64; 3]) {
    let end = [at[0] + LENGTH * right, at[1] - LENGTH * up];
    for (colour, width) in [(HALO.faded(0.75), 2.6), (INK, 1.1)] {
        drawing.put(Form::Line { points: vec![at, end], stroke: Stroke::solid(colour, width) }, None);
    }
    drawing.put(Form::Circle { centre: at, radius: 1.6, fill: Some(INK), stroke: None }, None);
}

/// A ball as it is seen: each direction in its colour.
pub fn ball(drawing: &mut Drawing, centre: Spot, radius: f64, palette: &Palette) {
    const SQUARE: f64 = 2.0;
    let mut rings: BTreeMap<Paint, Vec<Vec<Spot>>> = BTreeMap::new();
    #[expect(clippy::cast_possible_truncation, reason = "a ball of a few points")]
    let count = (radius / SQUARE).ceil() as i32;
    for (i, j) in (-count..count).flat_map(|j| (-count..count).map(move |i| (i, j))) {
        let [x, y] = [i, j].map(|k| (f64::from(k) + 0.5) * SQUARE / radius);
        let height = 1.0 - x * x - y * y;
        if height >= 0.0 {
            let [left, top] = [centre[0] + f64::from(i) * SQUARE, centre[1] + f64::from(j) * SQUARE];
            let (right, bottom) = (left + SQUARE, top + SQUARE);
            let paint = Paint::of_direction([x, -y, height.sqrt()]);
            rings.entry(paint).or_default().push(vec![[left, top], [right, top], [right, bottom], [left, bottom]]);
        }
    }
    for (paint, rings) in rings {
        drawing.put(Form::Area { rings, fill: paint.colour(palette) }, None);
    }
    for (right, up) in [(0.0, 0.0), (0.6, 0.0), (-0.6, 0.0), (0.0, 0.6), (0.0, -0.6)] {
        let at = [centre[0] + radius * right, centre[1] - radius * up];
        needle(drawing, at, [right, up, 0.0]);
    }
}
