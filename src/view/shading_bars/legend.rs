//! The names of the components that have a bar, with the looks of their bars: what is left of the table where it is too low for one.

use super::hatch::hatched;
use super::{Part, Shading};
use crate::view::drawing::{Anchor, Frame};
use crate::view::fonts::{Face, text_width};
use crate::view::sheet::{SMALL, Sheet};

/// Height of a line, and of the sample of a look.
const LINE: f64 = 15.0;
const SAMPLE: f64 = 11.0;
/// Between a sample and its name, and between names.
const GAPS: [f64; 2] = [4.0, 12.0];

/// How high the legend is at this width.
pub(super) fn height(shading: &Shading, width: f64) -> f64 {
    LINE * lines(shading, width).len() as f64
}

/// Draws the legend from the upper left corner of `room` down.
pub(super) fn draw(sheet: &mut Sheet, room: Frame, shading: &Shading) {
    let ink = sheet.palette.ink;
    let mut y = room.low[1] + 0.5 * LINE;
    for line in lines(shading, room.size()[0]) {
        let mut x = room.low[0];
        for part in line {
            if y + 0.5 * LINE > room.high[1] + 0.5 || x + width_of(part) > room.high[0] + GAPS[1] {
                return;
            }
            let half = 0.5 * SAMPLE;
            hatched(sheet, Frame { low: [x, y - half], high: [x + SAMPLE, y + half] }, part.look);
            sheet.write(part.name, [x + SAMPLE + GAPS[0], y], Anchor::Start, SMALL, ink);
            x += width_of(part);
        }
        y += LINE;
    }
}

/// As many names in each line as there is room for.
fn lines(shading: &Shading, width: f64) -> Vec<Vec<&Part>> {
    let mut lines: Vec<Vec<&Part>> = Vec::new();
    let mut used = f64::INFINITY;
    for part in shading.parts.iter().filter(|part| part.colour != [0.0; 3]) {
        if used + width_of(part) > width + GAPS[1] {
            lines.push(Vec::new());
            used = 0.0;
        }
        used += width_of(part);
        if let Some(line) = lines.last_mut() {
            line.push(part);
        }
    }
    lines
}

fn width_of(part: &Part) -> f64 {
    SAMPLE + GAPS[0] + text_width(part.name, SMALL, Face::Sans) + GAPS[1]
}
