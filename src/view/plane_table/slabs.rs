//! For each plane the part of the ray on its inner side, and below them what is left of the ray.

use crate::record::{PlaneRow, PlaneSense};
use crate::view::axis::Axis;
use crate::view::drawing::{Anchor, Form, Frame, Stroke};
use crate::view::palette::Colour;
use crate::view::sheet::{SMALL, Sheet};
use crate::view::text::brief;
use std::ops::Range;

/// Draws a bar for each row at the height of that row of the table, and one more below for t_in to t_out.
pub(super) fn draw(sheet: &mut Sheet, area: Frame, pitch: f64, rows: &[PlaneRow], shown: Range<usize>, last: usize) {
    let axis = Axis { values: range(rows), points: [area.low[0], area.high[0] - 4.0] };
    let slabs = Slabs { axis, pitch, top: area.low[1] };
    let palette = sheet.palette;
    for index in shown.clone() {
        let row = &rows[index];
        let y = slabs.row(index - shown.start);
        slabs.track(sheet, y);
        if index > last {
            continue;
        }
        let (colour, opacity) = (colour_of(sheet, row.sense), if index == last { 1.0 } else { 0.55 });
        slabs.inner(sheet, row, y, colour.faded(opacity));
    }
    let y = slabs.row(shown.len());
    let row = &rows[last];
    slabs.track(sheet, y);
    slabs.left_over(sheet, row, y, palette.combined);
    slabs.narrowing(sheet, row, [slabs.top + 0.7 * pitch, y]);
    slabs.start(sheet, [slabs.top + 0.7 * pitch, y + 0.5 * pitch]);
    slabs.numbers(sheet, y + 0.5 * pitch);
}

/// All times with some room about them, and the start of the ray where it is not far off.
fn range(rows: &[PlaneRow]) -> [f64; 2] {
    let times = rows.iter().filter_map(|row| row.t).filter(|t| t.is_finite());
    let (low, high) = times.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), t| (low.min(t), high.max(t)));
    if low > high {
        return [-1.0, 1.0];
    }
    let length = (high - low).max(1e-9 * low.abs()).max(1e-12);
    let low = if low > 0.0 && low < 1.5 * length { 0.0 } else { low };
    [low - 0.12 * length, high + 0.12 * length]
}

struct Slabs {
    axis: Axis,
    pitch: f64,
    top: f64,
}

impl Slabs {
    /// The middle of a row, the heading's being before the first.
    fn row(&self, index: usize) -> f64 {
        self.top + self.pitch * (index as f64 + 1.5)
    }

    fn track(&self, sheet: &mut Sheet, y: f64) {
        let [left, right] = self.axis.points;
        let stroke = Stroke::solid(sheet.palette.grid, 1.0);
        sheet.drawing.put(Form::Line { points: vec![[left, y], [right, y]], stroke }, None);
    }

    /// The inner side of one plane: from its t on where it is entered, up to it where it is left. An arrow head shows
    /// the way in or out.
    fn inner(&self, sheet: &mut Sheet, row: &PlaneRow, y: f64, colour: Colour) {
        let [left, right] = self.axis.points;
        let thick = 0.36 * self.pitch;
        match (row.sense, row.t) {
            (PlaneSense::Entering, Some(t)) => bar(sheet, [self.axis.at(t).max(left), right], y, thick, colour),
            (PlaneSense::Leaving, Some(t)) => bar(sheet, [left, self.axis.at(t).min(right)], y, thick, colour),
            (PlaneSense::ParallelInside, _) => bar(sheet, [left, right], y, thick, colour),
            _ => {}
        }
        let Some(x) = row.t.map(|t| self.axis.at(t)).filter(|x| (left..=right).contains(x)) else { return };
        let stroke = Stroke::solid(colour, 2.0);
        let half = 0.5 * self.pitch - 1.0;
        sheet.drawing.put(Form::Line { points: vec![[x, y - half], [x, y + half]], stroke }, sheet.event);
    }

    /// From t_in to t_out, or the gap where the one is later than the other.
    fn left_over(&self, sheet: &mut Sheet, row: &PlaneRow, y: f64, colour: Colour) {
        let [left, right] = self.axis.points;
        let from = row.t_in.map_or(left, |t| self.axis.at(t).max(left).min(right));
        let to = row.t_out.map_or(right, |t| self.axis.at(t).max(left).min(right));
        let is_empty = from > to || row.sense == PlaneSense::ParallelOutside;
        if is_empty {
            let bad = sheet.palette.bad;
            sheet.write_over("nothing is left", [f64::midpoint(left, right), y], Anchor::Middle, SMALL, bad);
        } else {
            bar(sheet, [from, to], y, 0.5 * self.pitch, colour);
        }
    }

    /// Lines down from t_in and t_out.
    fn narrowing(&self, sheet: &mut Sheet, row: &PlaneRow, [top, bottom]: [f64; 2]) {
        for t in [row.t_in, row.t_out].into_iter().flatten().filter(|t| self.axis.shows(*t)) {
            let x = self.axis.at(t);
            let stroke = Stroke::dashed(sheet.palette.combined, 1.1, [2.0, 3.0]);
            sheet.drawing.put(Form::Line { points: vec![[x, top], [x, bottom]], stroke }, None);
        }
    }

    fn start(&self, sheet: &mut Sheet, [top, bottom]: [f64; 2]) {
        if self.axis.shows(0.0) {
            let x = self.axis.at(0.0);
            let stroke = Stroke::solid(sheet.palette.faint, 1.2);
            sheet.drawing.put(Form::Line { points: vec![[x, top], [x, bottom]], stroke }, None);
        }
    }

    fn numbers(&self, sheet: &mut Sheet, base: f64) {
        let [left, right] = self.axis.points;
        let faint = sheet.palette.faint;
        let stroke = Stroke::solid(faint, 1.0);
        sheet.drawing.put(Form::Line { points: vec![[left, base], [right, base]], stroke }, None);
        for tick in self.axis.ticks((right - left) / 50.0) {
            let x = self.axis.at(tick);
            sheet.drawing.put(Form::Line { points: vec![[x, base], [x, base + 3.0]], stroke }, None);
            sheet.write(&brief(tick), [x, base + 9.0], Anchor::Middle, SMALL, faint);
        }
        sheet.write("t", [right, self.top + 0.5 * self.pitch], Anchor::End, SMALL, faint);
    }
}

fn colour_of(sheet: &Sheet, sense: PlaneSense) -> Colour {
    match sense {
        PlaneSense::Entering => sheet.palette.left,
        PlaneSense::Leaving => sheet.palette.right,
        PlaneSense::ParallelInside => sheet.palette.extent,
        PlaneSense::ParallelOutside => sheet.palette.bad,
    }
}

fn bar(sheet: &mut Sheet, [from, to]: [f64; 2], y: f64, thick: f64, colour: Colour) {
    let frame = Frame { low: [from, y - 0.5 * thick], high: [to, y + 0.5 * thick] };
    if to > from {
        sheet.drawing.put(Form::Rect { frame, fill: Some(colour), stroke: None }, sheet.event);
    }
}
