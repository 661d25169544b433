//! The components as numbers, with the looks of their bars.

use super::hatch::hatched;
use super::{CHANNELS, Shading, amount};
use crate::view::drawing::{Anchor, Form, Frame, Stroke};
use crate::view::sheet::{SMALL, Sheet, TEXT};

/// The width that the table needs, and its height with a heading and a line for the total.
pub(super) const WIDTH: f64 = 270.0;
pub(super) const HEIGHT: f64 = 7.0 * 17.0;
/// Its least height: a table without its total would mislead.
pub(super) const LEAST: f64 = 7.0 * 12.0 - 1.0;

/// Room for the names.
const NAMES: f64 = 96.0;
const SAMPLE: f64 = 14.0;

/// Draws the table from the upper left corner of `room` down.
pub(super) fn draw(sheet: &mut Sheet, room: Frame, shading: &Shading) {
    let pitch = (room.size()[1] / 7.0).clamp(12.0, 26.0);
    let width = room.size()[0].min(WIDTH);
    let (left, right) = (room.low[0], room.low[0] + width);
    let column = (width - NAMES) / 3.0;
    let at = |channel: usize| right - column * (2 - channel) as f64;
    let palette = sheet.palette;
    if room.size()[1] < LEAST || width < 90.0 {
        return;
    }
    let mut y = room.low[1] + 0.5 * pitch;
    for (channel, name) in CHANNELS.into_iter().enumerate() {
        sheet.write(name, [at(channel), y], Anchor::End, SMALL, palette.faint);
    }
    for part in &shading.parts {
        y += pitch;
        let half = 0.5 * (pitch - 3.0).min(SAMPLE);
        let frame = Frame { low: [left, y - half], high: [left + SAMPLE, y + half] };
        hatched(sheet, frame, part.look);
        sheet.write(part.name, [left + SAMPLE + 6.0, y], Anchor::Start, TEXT, palette.ink);
        for (channel, x) in part.colour.into_iter().enumerate() {
            let colour = if x == 0.0 { palette.faint } else { palette.ink };
            sheet.write(&amount(x), [at(channel), y], Anchor::End, TEXT, colour);
        }
    }
    let line = y + 0.5 * pitch;
    let stroke = Stroke::solid(palette.faint, 1.0);
    sheet.drawing.put(Form::Line { points: vec![[left, line], [right, line]], stroke }, None);
    y += pitch;
    sheet.write("total", [left + SAMPLE + 6.0, y], Anchor::Start, TEXT, palette.ink);
    for (channel, x) in shading.total.into_iter().enumerate() {
        sheet.write(&amount(x), [at(channel), y], Anchor::End, TEXT, palette.ink);
    }
}
