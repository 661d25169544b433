//! What there is room for: the bars, what they stand for as a table of numbers or at least by name, and each light's part.

use super::{Shading, legend, table};
use crate::view::drawing::Frame;

/// A channel's bar is at least so high, and a light's three thin ones, in points: lower, and their names would cover each other.
const CHANNEL: f64 = 14.0;
const LAMP: f64 = 18.0;
/// A light's share of a channel's height.
pub(super) const SHARE: f64 = 0.67;
/// From this width on the table stands beside the bars.
const WIDE: f64 = 560.0;
/// Room for the axis, and the height of all bars from which there is one.
const AXIS: f64 = 24.0;
const ROOMY: f64 = 84.0;

/// What the bars stand for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Key {
    /// Names and numbers.
    Table(Frame),
    /// Names alone.
    Legend(Frame),
}

/// Where everything goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Plan {
    pub bars: Frame,
    pub key: Key,
    /// How many lights have bars of their own.
    pub lamps: usize,
}

impl Plan {
    pub fn of(room: Frame, shading: &Shading) -> Self {
        let (bars, key) = split(room, shading);
        let height = bars.size()[1] - if has_axis(bars) { AXIS } else { 0.0 };
        let fits = |lamps: &usize| pitch(height, *lamps) * SHARE >= LAMP;
        let lamps = (1..=shading.lamps.len()).rev().find(fits).unwrap_or(0);
        Self { bars, key, lamps }
    }

    /// The height of a channel's bar.
    pub fn pitch(&self) -> f64 {
        pitch(self.base() - self.bars.low[1], self.lamps).clamp(12.0, 96.0)
    }

    /// Where the bars end at the latest: below is the axis.
    pub fn base(&self) -> f64 {
        self.bars.high[1] - if self.has_axis() { AXIS } else { 0.0 }
    }

    pub fn has_axis(&self) -> bool {
        has_axis(self.bars)
    }
}

fn pitch(height: f64, lamps: usize) -> f64 {
    height / (3.0 + SHARE * lamps as f64)
}

fn has_axis(bars: Frame) -> bool {
    bars.size()[1] >= ROOMY
}

/// The bars at the left and the table at the right, or the table below; where it is too low for a table, a legend below.
fn split(room: Frame, shading: &Shading) -> (Frame, Key) {
    let ([left, top], [right, bottom]) = (room.low, room.high);
    let [width, height] = room.size();
    if width >= WIDE && height >= table::LEAST {
        let middle = right - table::WIDTH;
        let bars = Frame { low: [left, top], high: [middle - 16.0, bottom] };
        return (bars, Key::Table(Frame { low: [middle, top], high: [right, bottom] }));
    }
    let wanted = 3.0 * 26.0 + 26.0 + shading.lamps.len() as f64 * 24.0;
    if height >= table::LEAST + 4.0 + 3.0 * CHANNEL {
        let middle = bottom - table::HEIGHT.min(0.66 * height).max(table::LEAST);
        let bars = Frame { low: [left, top], high: [right, (top + wanted).min(middle - 4.0)] };
        return (bars, Key::Table(Frame { low: [left, bars.high[1] + 4.0], high: [right, bottom] }));
    }
    let middle = bottom - legend::height(shading, width);
    let bars = Frame { low: [left, top], high: [right, (top + wanted).min(middle - 4.0)] };
    (bars, Key::Legend(Frame { low: [left, bars.high[1] + 4.0], high: [right, bottom] }))
}
