//! Which event a place of a drawing belongs to.

use super::drawing::{Drawing, Form, Spot, length};
use super::outline::frame_of;
use crate::record::EventId;

impl Drawing {
    /// The event whose mark lies at `at`, or within `reach` points of it. Lines and points win over areas, nearer ones
    /// over farther ones, and upper ones over lower ones.
    #[must_use]
    pub fn event_at(&self, at: Spot, reach: f64) -> Option<EventId> {
        let mut best: Option<(f64, EventId)> = None;
        for mark in self.marks.iter().rev() {
            let Some(event) = mark.event else { continue };
            let distance = mark.form.distance(at);
            if distance <= reach && best.is_none_or(|(nearest, _)| distance < nearest) {
                best = Some((distance, event));
            }
        }
        best.map(|(_, event)| event)
    }
}

/// An area counts as this far away, so that what is drawn on it is found first.
const AREA_DISTANCE: f64 = 1e-3;

impl Form {
    /// How far away `at` is.
    fn distance(&self, at: Spot) -> f64 {
        match self {
            Self::Line { points, .. } => {
                points.windows(2).map(|ends| distance_to_line(at, ends[0], ends[1])).fold(f64::INFINITY, f64::min)
            }
            Self::Area { rings, .. } => {
                if is_within(rings, at) {
                    AREA_DISTANCE
                } else {
                    f64::INFINITY
                }
            }
            Self::Circle { centre, radius, fill, .. } => {
                let distance = length([at[0] - centre[0], at[1] - centre[1]]) - radius;
                if fill.is_some() { distance.max(0.0) } else { distance.abs() }
            }
            Self::Arc { centre, radius, .. } => (length([at[0] - centre[0], at[1] - centre[1]]) - radius).abs(),
            Self::Arrow { from, to, .. } => distance_to_line(at, *from, *to),
            Self::Rect { frame, .. } => {
                if frame.contains(at) {
                    AREA_DISTANCE
                } else {
                    f64::INFINITY
                }
            }
            Self::Text(text) => {
                if text.frame().contains(at) {
                    0.0
                } else {
                    f64::INFINITY
                }
            }
            Self::Outline { steps, .. } => {
                if frame_of(steps).is_some_and(|frame| frame.contains(at)) {
                    AREA_DISTANCE
                } else {
                    f64::INFINITY
                }
            }
        }
    }
}

fn distance_to_line(at: Spot, from: Spot, to: Spot) -> f64 {
    let along = [to[0] - from[0], to[1] - from[1]];
    let squared = along[0] * along[0] + along[1] * along[1];
    let offset = [at[0] - from[0], at[1] - from[1]];
    let share =
        if squared > 0.0 { ((offset[0] * along[0] + offset[1] * along[1]) / squared).clamp(0.0, 1.0) } else { 0.0 };
    length([offset[0] - share * along[0], offset[1] - share * along[1]])
}

fn is_within(rings: &[Vec<Spot>], at: Spot) -> bool {
    let mut inside = false;
    for ring in rings {
        for (i, &a) in ring.iter().enumerate() {
            let b = ring[(i + 1) % ring.len()];
            let crosses = (a[1] > at[1]) != (b[1] > at[1]);
            if crosses && at[0] < a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) {
                inside = !inside;
            }
        }
    }
    inside
}

#[cfg(test)]
mod tests {
    use crate::view::sample::two_marks;

    #[test]
    fn a_line_on_an_area_is_found_first_and_a_hole_is_not_the_area() {
        let drawing = two_marks();
        assert_eq!(drawing.event_at([15.0, 50.0], 3.0), Some(1));
        assert_eq!(drawing.event_at([15.0, 20.0], 3.0), Some(2));
        assert_eq!(drawing.event_at([80.0, 22.0], 3.0), Some(2));
        assert_eq!(drawing.event_at([35.0, 35.0], 3.0), None);
        assert_eq!(drawing.event_at([80.0, 70.0], 3.0), None);
    }
}
