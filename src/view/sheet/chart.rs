//! Two axes, and the projection of directions in space.

use super::{SMALL, Sheet};
use crate::math::portable;
use crate::record::Triple;
use crate::view::axis::Axis;
use crate::view::fonts::text_width;
use crate::view::text::brief;
use crate::view::{Anchor, Face, Form, Frame, Spot, Stroke};

/// Maps pairs of numbers into a frame.
pub(in crate::view) struct Chart {
    pub frame: Frame,
    pub x: Axis,
    pub y: Axis,
}

impl Chart {
    /// x and y on scales of their own, y upwards.
    pub fn free(frame: Frame, x: [f64; 2], y: [f64; 2]) -> Self {
        let across = Axis { values: x, points: [frame.low[0], frame.high[0]] };
        Self { frame, x: across, y: Axis { values: y, points: [frame.high[1], frame.low[1]] } }
    }

    /// One scale for both; the whole frame is filled, so that more may be seen than from `low` to `high`.
    pub fn even(frame: Frame, low: Spot, high: Spot, is_y_down: bool) -> Option<Self> {
        let room = frame.size();
        let wanted: [f64; 2] = std::array::from_fn(|i| high[i] - low[i]);
        let scale = (0..2).map(|i| room[i] / wanted[i].max(1e-12)).fold(f64::INFINITY, f64::min);
        let half = room.map(|points| 0.5 * points / scale);
        let middle: Spot = std::array::from_fn(|i| f64::midpoint(low[i], high[i]));
        if !(scale.is_finite() && scale > 0.0 && middle.iter().all(|x| x.is_finite())) {
            return None;
        }
        let values = |i: usize| [middle[i] - half[i], middle[i] + half[i]];
        let [left, top] = frame.low;
        let [right, bottom] = frame.high;
        let y = if is_y_down { [top, bottom] } else { [bottom, top] };
        Some(Self {
            frame,
            x: Axis { values: values(0), points: [left, right] },
            y: Axis { values: values(1), points: y },
        })
    }

    pub fn at(&self, [x, y]: Spot) -> Spot {
        [self.x.at(x), self.y.at(y)]
    }

    pub fn all_at(&self, points: &[Spot]) -> Vec<Spot> {
        points.iter().map(|&point| self.at(point)).collect()
    }

    /// Points for a unit of x.
    pub fn scale(&self) -> f64 {
        (self.x.points[1] - self.x.points[0]) / (self.x.values[1] - self.x.values[0])
    }
}

/// The part of `room` that has numbers and names around it.
pub(in crate::view) fn within_axes(room: Frame) -> Frame {
    Frame { low: [room.low[0] + 34.0, room.low[1] + 16.0], high: [room.high[0] - 4.0, room.high[1] - 22.0] }
}

impl Sheet {
    /// The rim of a chart with numbers below and at the left; `whole` leaves out all but whole numbers.
    pub fn axes(&mut self, chart: &Chart, names: [&str; 2], whole: bool) {
        let ([left, top], [right, bottom]) = (chart.frame.low, chart.frame.high);
        let faint = self.palette.faint;
        let rim = Stroke::solid(faint, 1.0);
        self.drawing.put(Form::Rect { frame: chart.frame, fill: None, stroke: Some(rim) }, None);
        self.placer.avoid_ring(&super::rim(&chart.frame));
        let ink = self.palette.ink;
        let below = bottom + 13.0;
        if !self.write(names[0], [right + 6.0, below], Anchor::Start, SMALL, ink)
            && self.write(names[0], [right, below], Anchor::End, SMALL, ink)
        {
            // So far from the last number that the two do not read as one, unless that would leave hardly any numbers.
            let apart = if right - left > 240.0 { 22.0 } else { 8.0 };
            let room = text_width(names[0], SMALL, Face::Sans) + apart;
            self.placer.reserve(Frame { low: [right - room, below - 2.0], high: [right, below + 2.0] });
        }
        self.write(names[1], [left, top - 9.0], Anchor::Start, SMALL, self.palette.ink);
        let kept = |tick: &f64| !whole || tick.fract() == 0.0;
        for tick in chart.x.ticks((right - left) / 55.0).into_iter().filter(kept) {
            let x = chart.x.at(tick);
            if self.write(&brief(tick), [x, below], Anchor::Middle, SMALL, faint) {
                self.drawing.put(Form::Line { points: vec![[x, bottom], [x, bottom + 4.0]], stroke: rim }, None);
            }
        }
        for tick in chart.y.ticks((bottom - top) / 34.0).into_iter().filter(kept) {
            let y = chart.y.at(tick);
            if self.write(&brief(tick), [left - 7.0, y], Anchor::End, SMALL, faint) {
                self.drawing.put(Form::Line { points: vec![[left - 4.0, y], [left, y]], stroke: rim }, None);
            }
        }
    }
}

impl Sheet {
    /// Lines at whole numbers, unless they would lie closer than can be seen.
    pub fn whole_lines(&mut self, chart: &Chart) {
        /// Closer lines would grey the drawing.
        const CLOSEST: f64 = 5.0;
        if chart.scale() < CLOSEST {
            return;
        }
        // A dark and a pale line beside each other: one of them is seen on any picture.
        let (ground, ink) = (self.palette.ground.faded(0.4), self.palette.ink.faded(0.4));
        let strokes = [Stroke::solid(ground, 1.8), Stroke::solid(ink, 0.8)];
        let whole = |[low, high]: [f64; 2]| {
            let first = low.ceil();
            // No canvas has room for more at that distance.
            (0..4_000).map(move |i| first + f64::from(i)).take_while(move |at| *at <= high)
        };
        let ([left, top], [right, bottom]) = (chart.frame.low, chart.frame.high);
        for stroke in strokes {
            for x in whole(chart.x.values).map(|x| chart.x.at(x)) {
                self.line(&chart.frame, &[[x, top], [x, bottom]], stroke);
            }
            for y in whole(chart.y.values).map(|y| chart.y.at(y)) {
                self.line(&chart.frame, &[[left, y], [right, y]], stroke);
            }
        }
    }
}

/// Looks at space along parallel lines, from the front, a little from the left and from above, z upwards.
pub(in crate::view) struct Oblique {
    /// The place of the origin.
    pub centre: Spot,
    /// Points for a unit.
    pub scale: f64,
}

impl Oblique {
    /// Radians. At 45° the edges of a cube would fall on each other; at 0 one of the axes would vanish.
    const AROUND: f64 = 0.48;
    const ABOVE: f64 = 0.46;

    pub fn at(&self, [x, y, z]: Triple) -> Spot {
        let (sin, cos) = portable::sin_cos(Self::AROUND);
        let (rise, level) = portable::sin_cos(Self::ABOVE);
        let away = y * cos - x * sin;
        [self.centre[0] + self.scale * (x * cos + y * sin), self.centre[1] - self.scale * (z * level + away * rise)]
    }
}

/// The corners of the smallest box around all places that are numbers.
pub(in crate::view) fn bounds(points: impl IntoIterator<Item = Spot>) -> Option<[Spot; 2]> {
    let finite = points.into_iter().filter(|point| point.iter().all(|x| x.is_finite()));
    finite.fold(None, |known, point| {
        let [low, high] = known.unwrap_or([point, point]);
        Some(std::array::from_fn(|end| {
            std::array::from_fn(|i| if end == 0 { low[i].min(point[i]) } else { high[i].max(point[i]) })
        }))
    })
}
