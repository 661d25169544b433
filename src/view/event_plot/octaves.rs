//! The terms of a turbulence, each on top of the sum of those before it.

use crate::record::{Octave, Octaves};
use crate::view::labels::Label;
use crate::view::sheet::{Chart, SMALL, Sheet, is_roomy, within_axes};
use crate::view::text::brief;
use crate::view::{Anchor, Colour, Form, Frame, Spot, Stroke};

/// More columns than this would be too thin to tell apart.
const MOST: usize = 24;

/// Rows of numbers below the chart.
const ROWS: [&str; 4] = ["k", "frequency", "weight", "noise"];
const ROW: f64 = 15.0;

pub(super) fn draw(sheet: &mut Sheet, octaves: &Octaves) {
    let note = "Each term = weight · noise starts where the sum of those before it ends; \
                the pale bar shows how far it could have gone.";
    let room = sheet.caption(&format!("Turbulence: the sum is {}", brief(octaves.sum)), note);
    let mut frame = within_axes(room);
    let heads = 64.0;
    frame.low[0] = room.low[0] + heads;
    frame.high[1] = room.high[1] - ROW * ROWS.len() as f64;
    if frame.size()[1] < 60.0 {
        frame.high[1] = room.high[1];
    }
    let rows = &octaves.rows[..octaves.rows.len().min(MOST)];
    let Some(range) = range(rows, octaves.sum).filter(|_| is_roomy(&frame)) else { return };
    let chart = Chart::free(frame, [0.0, rows.len() as f64 + 1.0], range);
    let zero = chart.y.at(0.0);
    values(sheet, &chart);
    // Below the bars and their numbers.
    let rim = Stroke::solid(sheet.palette.ink, 1.2);
    sheet.line(&frame, &[[frame.low[0], zero], [frame.high[0], zero]], rim);
    let mut sum = 0.0;
    for (number, octave) in rows.iter().enumerate() {
        bar(sheet, &chart, number, sum, octave);
        sum += octave.term;
    }
    total(sheet, &chart, rows.len(), octaves.sum);
    if frame.high[1] < room.high[1] {
        numbers(sheet, &chart, rows);
    }
}

/// From the lowest to the highest that any bar reaches, with room for a number above and below.
fn range(rows: &[Octave], sum: f64) -> Option<[f64; 2]> {
    let mut before = 0.0;
    let mut ends = vec![0.0, sum];
    for octave in rows {
        ends.extend([before - octave.weight.abs(), before + octave.weight.abs(), before + octave.term]);
        before += octave.term;
    }
    ends.retain(|end| end.is_finite());
    let low = ends.iter().copied().fold(0.0, f64::min);
    let high = ends.iter().copied().fold(0.0, f64::max);
    let air = 0.14 * (high - low);
    (high > low).then_some([low - air, high + air])
}

/// The middle of a column and half the width of its bar.
fn column(chart: &Chart, number: usize) -> (f64, f64) {
    let pitch = chart.x.at(1.0) - chart.x.at(0.0);
    (chart.x.at(number as f64 + 0.5), 0.3 * pitch)
}

fn block(sheet: &mut Sheet, chart: &Chart, [middle, half]: Spot, ends: [f64; 2], fill: Colour) {
    let [a, b] = ends.map(|end| chart.y.at(end).max(chart.frame.low[1]).min(chart.frame.high[1]));
    // A term that is almost nothing is still there.
    let (top, bottom) = if (a - b).abs() < 1.5 { (a.min(b) - 0.75, a.min(b) + 0.75) } else { (a.min(b), a.max(b)) };
    let frame = Frame { low: [middle - half, top], high: [middle + half, bottom] };
    sheet.drawing.put(Form::Rect { frame, fill: Some(fill), stroke: None }, sheet.event);
}

fn bar(sheet: &mut Sheet, chart: &Chart, number: usize, before: f64, octave: &Octave) {
    let (middle, half) = column(chart, number);
    let after = before + octave.term;
    let reach = [before - octave.weight, before + octave.weight];
    block(sheet, chart, [middle, 0.55 * half], reach, sheet.palette.faint.faded(0.22));
    let fill = if octave.term < 0.0 { sheet.palette.inside } else { sheet.palette.outside };
    block(sheet, chart, [middle, half], [before, after], fill);
    let next = column(chart, number + 1).0 - half;
    let level = chart.y.at(after);
    let dashes = Stroke::dashed(sheet.palette.faint, 1.0, [3.0, 3.0]);
    sheet.line(&chart.frame, &[[middle + half, level], [next, level]], dashes);
    let sign = if octave.term < 0.0 { "" } else { "+" };
    label(sheet, chart, middle, [before, after], &format!("{sign}{}", brief(octave.term)));
}

/// A number above a bar that rises, below one that falls.
fn label(sheet: &mut Sheet, chart: &Chart, middle: f64, [from, to]: [f64; 2], text: &str) {
    let above = chart.y.at(from.max(to)) - 9.0;
    let below = chart.y.at(from.min(to)) + 9.0;
    let places = if to < from { [below, above] } else { [above, below] };
    let label = Label::new(text, SMALL, sheet.palette.ink);
    for y in places {
        let text = label.at([middle, y], Anchor::Middle, Some(sheet.palette.ground));
        if sheet.placer.put_at(&mut sheet.drawing, text, Some(sheet.event)) {
            return;
        }
    }
}

fn total(sheet: &mut Sheet, chart: &Chart, number: usize, sum: f64) {
    let (middle, half) = column(chart, number);
    block(sheet, chart, [middle, half], [0.0, sum], sheet.palette.combined);
    label(sheet, chart, middle, [0.0, sum], &format!("sum {}", brief(sum)));
}

/// Values at the left, with lines across.
fn values(sheet: &mut Sheet, chart: &Chart) {
    let [left, right] = [chart.frame.low[0], chart.frame.high[0]];
    for tick in chart.y.ticks(chart.frame.size()[1] / 34.0) {
        let y = chart.y.at(tick);
        sheet.line(&chart.frame, &[[left, y], [right, y]], Stroke::solid(sheet.palette.grid, 0.8));
        sheet.write(&brief(tick), [left - 6.0, y], Anchor::End, SMALL, sheet.palette.faint);
    }
}

/// What each term is made of, below its bar.
fn numbers(sheet: &mut Sheet, chart: &Chart, rows: &[Octave]) {
    let left = chart.frame.low[0] - 6.0;
    for (line, name) in ROWS.iter().enumerate() {
        let y = chart.frame.high[1] + ROW * (line as f64 + 0.6);
        sheet.write(name, [left, y], Anchor::End, SMALL, sheet.palette.faint);
        for (number, octave) in rows.iter().enumerate() {
            let value = match line {
                0 => octave.k.to_string(),
                1 => brief(octave.frequency),
                2 => brief(octave.weight),
                _ => brief(octave.noise),
            };
            sheet.write(&value, [column(chart, number).0, y], Anchor::Middle, SMALL, sheet.palette.ink);
        }
    }
}
