//! The grid with its numbers, the lane of exact zeros and the band in which the reference is not sure.

use super::Layout;
use super::marker::RADIUS;
use super::paper::{Paper, SMALL, TEXT};
use super::scale::{error, seconds};
use crate::view::drawing::{Anchor, Form, Frame, Stroke, Text};
use crate::view::fonts::{Face, text_width};
use crate::view::labels::{Label, shortened};
use crate::view::text::brief;

/// Numbers on an axis keep at least this distance, in points.
const APART: f64 = 8.0;

/// Draws everything that lies behind the points.
pub fn draw(paper: &mut Paper, layout: &Layout) {
    doubt(paper, layout);
    lane(paper, layout);
    time_lines(paper, layout);
    error_lines(paper, layout);
    let stroke = Some(Stroke::solid(paper.palette.faint, 1.0));
    for frame in [Some(layout.field), layout.lane].into_iter().flatten() {
        paper.put(Form::Rect { frame, fill: None, stroke }, None);
    }
    let whole = whole(layout);
    let name = shortened(&paper.plot.x_name, whole.size()[0], TEXT, Face::Sans);
    let name = Label::new(name, TEXT, paper.palette.ink);
    paper.put(Form::Text(name.at([whole.middle()[0], whole.high[1] + 30.0], Anchor::Middle, None)), None);
}

/// The field and the lane together.
pub fn whole(layout: &Layout) -> Frame {
    Frame { low: layout.field.low, high: layout.lane.unwrap_or(layout.field).high }
}

/// Below the reference's own error nothing is known.
fn doubt(paper: &mut Paper, layout: &Layout) {
    let Some(top) = doubt_top(paper.plot.reference_error, layout) else { return };
    let palette = paper.palette;
    let Frame { low: [left, _], high: [right, bottom] } = layout.field;
    let frame = Frame { low: [left, top], high: [right, bottom] };
    paper.put(Form::Rect { frame, fill: Some(palette.shadow.faded(0.13)), stroke: None }, None);
    let stroke = Stroke::dashed(palette.shadow, 1.2, [5.0, 3.0]);
    paper.put(Form::Line { points: vec![[left, top], [right, top]], stroke }, None);
}

/// Where the band begins, if there is one.
pub fn doubt_top(reference_error: f64, layout: &Layout) -> Option<f64> {
    (reference_error > 0.0 && reference_error.is_finite())
        .then(|| layout.y.at(reference_error).max(layout.field.low[1]).min(layout.field.high[1]))
}

/// What the band says, inside it where it is high enough and above it where it is not, clear of all markers if it can be.
pub fn doubt_label(paper: &Paper, layout: &Layout) -> Option<Text> {
    let top = doubt_top(paper.plot.reference_error, layout)?;
    let words = format!("below {} the reference itself is not sure", brief(paper.plot.reference_error));
    let Frame { low: [left, _], high: [right, bottom] } = layout.field;
    let y = if bottom - top > 16.0 { top + 9.0 } else { top - 9.0 };
    let label = Label::new(shortened(&words, right - left - 12.0, SMALL, Face::Sans), SMALL, paper.palette.shadow);
    let halo = Some(paper.palette.ground);
    let candidates = [(left + 6.0, Anchor::Start), (right - 6.0, Anchor::End), (0.5 * (left + right), Anchor::Middle)];
    let texts = candidates.map(|(x, anchor)| label.at([x, y], anchor, halo));
    let is_clear = |text: &&Text| {
        let frame = text.frame().grown(RADIUS + 1.0);
        !layout.spots.iter().flatten().any(|&at| frame.contains(at))
    };
    texts.iter().find(is_clear).or(texts.first()).cloned()
}

fn lane(paper: &mut Paper, layout: &Layout) {
    let Some(lane) = layout.lane else { return };
    let fill = Some(paper.palette.good.faded(0.1));
    paper.put(Form::Rect { frame: lane, fill, stroke: None }, None);
    let middle = lane.middle()[1];
    for (text, y) in [("0,", middle - 6.5), ("exactly", middle + 6.5)] {
        paper.text(text, [lane.low[0] - 6.0, y], Anchor::End, paper.palette.good);
    }
}

fn time_lines(paper: &mut Paper, layout: &Layout) {
    let whole = whole(layout);
    let [left, right] = [whole.low[0], whole.high[0]];
    let mut free_from = f64::NEG_INFINITY;
    for tick in layout.x.ticks([left, right]) {
        let x = layout.x.at(tick.value);
        let stroke = line(paper, tick.major);
        paper.put(Form::Line { points: vec![[x, whole.low[1]], [x, whole.high[1]]], stroke }, None);
        let text = seconds(tick.value);
        let half = 0.5 * text_width(&text, SMALL, Face::Sans);
        if tick.named && x - half > free_from && x - half > 2.0 && x + half < paper.drawing.width - 2.0 {
            paper.text(&text, [x, whole.high[1] + 13.0], Anchor::Middle, paper.palette.faint);
            free_from = x + half + APART;
        }
    }
}

fn error_lines(paper: &mut Paper, layout: &Layout) {
    let Frame { low: [left, top], high: [right, bottom] } = layout.field;
    let mut free_below = f64::INFINITY;
    for tick in layout.y.ticks([top, bottom]) {
        let y = layout.y.at(tick.value);
        let stroke = line(paper, tick.major);
        paper.put(Form::Line { points: vec![[left, y], [right, y]], stroke }, None);
        // Below the lowest number stands what the lane is called.
        if tick.named && y < free_below && y < bottom - 9.0 {
            paper.text(&error(tick.value), [left - 6.0, y], Anchor::End, paper.palette.faint);
            free_below = y - 14.0;
        }
    }
}

/// Powers of ten are stronger than what lies between.
fn line(paper: &Paper, major: bool) -> Stroke {
    if major { Stroke::solid(paper.palette.grid, 1.0) } else { Stroke::solid(paper.palette.grid.faded(0.45), 0.6) }
}
