//! All rays so far, each kind with a colour and a dash of its own.

use super::Overview;
use crate::record::{EventId, RayKind, What};
use crate::view::drawing::{Anchor, Form, Frame, Stroke, length};
use crate::view::flights::{End, Flight};
use crate::view::fonts::{Face, text_width};
use crate::view::palette::Palette;
use crate::view::sheet::SMALL;
use crate::view::text::brief;
use glam::DVec3;

/// The length of a normal's arrow as a share of the scene's size.
const NORMAL: f64 = 0.07;

impl Overview<'_> {
    pub(super) fn rays(&mut self, probe_t: Option<f64>) {
        let flights = self.flights;
        let current = flights.owner(self.step);
        let step = self.step;
        for (index, flight) in flights.all.iter().enumerate().filter(|(_, flight)| flight.event <= step) {
            self.ray(flight, index == current);
        }
        for (index, flight) in flights.all.iter().enumerate() {
            self.hit(flight, index == current);
        }
        if let Some(t) = probe_t.filter(|t| t.is_finite()) {
            let flight = &flights.all[current];
            if let Some(spot) = self.sight.place(flight.origin + flight.direction * t) {
                self.dot(spot, 6.0, self.sheet.palette.highlight, Some(flight.event));
                self.sheet.event = flight.event;
                let ink = self.sheet.palette.ink;
                self.sheet.write_near(&format!("t = {}", brief(t)), spot, 8.0, ink);
                self.sheet.event = self.step;
            }
        }
    }

    /// How long a ray is drawn that meets nothing.
    fn far(&self) -> f64 {
        let [low, high] = self.wires.bounds;
        2.0 * (high - low).length().max(1.0)
    }

    fn ray(&mut self, flight: &Flight, is_current: bool) {
        let width = if is_current { 2.6 } else { 1.5 };
        let stroke = stroke(self.sheet.palette, flight.kind, width);
        let beyond = self.far() / flight.direction.length();
        let end = match flight.end {
            End::Hit { event, t } | End::Blocked { event, t, .. } if event <= self.step => t,
            End::Light(t) | End::Blocked { light: t, .. } if t.is_finite() => t,
            _ => beyond,
        };
        let at = |t: f64| flight.origin + flight.direction * t;
        if is_current {
            let light = Stroke::solid(self.sheet.palette.highlight.faded(0.5), 8.0);
            self.line([at(0.0), at(end)], light, Some(flight.event));
        }
        self.line([at(0.0), at(end)], stroke, Some(flight.event));
        if let Some([from, to]) = self.sight.line([at(0.45 * end), at(0.6 * end)]) {
            let head = 5.0 + 2.0 * width;
            let way = [to[0] - from[0], to[1] - from[1]];
            if length(way) > head && self.frame.contains(from) && self.frame.contains(to) {
                let stroke = Stroke { dash: None, ..stroke };
                self.sheet.drawing.put(Form::Arrow { from, to, head, stroke }, flight.event);
            }
        }
        if let Some([from, to]) = self.sight.line([at(0.0), at(end)]) {
            self.sheet.placer.avoid_line(from, to);
        }
        if let End::Blocked { event, t, .. } = flight.end {
            self.blocked(event, at(t));
        }
    }

    /// A cross where a shadow ray is stopped.
    fn blocked(&mut self, event: EventId, point: DVec3) {
        let Some([x, y]) = self.sight.place(point).filter(|_| event <= self.step) else { return };
        let stroke = Stroke::solid(self.sheet.palette.bad, 2.0);
        for slope in [1.0, -1.0] {
            self.flat_line(&[[x - 4.5, y - 4.5 * slope], [x + 4.5, y + 4.5 * slope]], stroke, Some(event));
        }
    }

    fn hit(&mut self, flight: &Flight, is_current: bool) {
        let End::Hit { event, t } = flight.end else { return };
        if event > self.step || flight.kind == RayKind::Shadow {
            return;
        }
        let What::Hit { n_geometric, .. } = &self.tree.event(event).what else { return };
        let point = flight.origin + flight.direction * t;
        let [low, high] = self.wires.bounds;
        let tip = point + DVec3::from_array(*n_geometric) * (NORMAL * (high - low).length());
        if let Some([from, to]) = self.sight.line([point, tip]) {
            self.sheet.event = event;
            self.sheet.arrow(from, to, self.sheet.palette.normal, if is_current { 1.8 } else { 1.2 });
            self.sheet.event = self.step;
        }
        let Some(spot) = self.sight.place(point) else { return };
        let colour = stroke(self.sheet.palette, flight.kind, 1.0).colour;
        self.dot(spot, if is_current { 5.0 } else { 3.6 }, colour, Some(event));
        if is_current && self.frame.contains(spot) {
            self.sheet.event = event;
            let ink = self.sheet.palette.ink;
            self.sheet.write_near(&format!("t = {}", brief(t)), spot, 7.0, ink);
            self.sheet.event = self.step;
        }
    }

    /// Which line is which kind of ray, for the kinds that there are.
    pub(super) fn key(&mut self) {
        let kinds = RayKind::ALL
            .into_iter()
            .filter(|kind| self.flights.all.iter().any(|flight| flight.kind == *kind && flight.event <= self.step));
        let (mut x, y) = (self.frame.low[0] + 8.0, self.frame.high[1] - 10.0);
        let mut places = Vec::new();
        for kind in kinds {
            let next = x + 26.0 + text_width(kind.name(), SMALL, Face::Sans) + 12.0;
            if next > self.frame.high[0] {
                break;
            }
            places.push((kind, x));
            x = next;
        }
        // Its own ground, so that it is read where rays run below it.
        let frame = Frame { low: [self.frame.low[0] + 2.0, y - 9.0], high: [x - 4.0, y + 9.0] };
        let fill = Some(self.sheet.palette.ground.faded(0.85));
        self.sheet.drawing.put(Form::Rect { frame, fill, stroke: None }, None);
        for (kind, x) in places {
            self.sheet.write_over(kind.name(), [x + 24.0, y], Anchor::Start, SMALL, self.sheet.palette.faint);
            self.flat_line(&[[x, y], [x + 20.0, y]], stroke(self.sheet.palette, kind, 2.0), None);
        }
    }
}

/// How a ray of a kind is drawn.
fn stroke(palette: &Palette, kind: RayKind, width: f64) -> Stroke {
    match kind {
        RayKind::Camera => Stroke::solid(palette.camera, width),
        RayKind::Reflected => Stroke::dashed(palette.reflected, width, [10.0, 3.0]),
        RayKind::Refracted => Stroke::solid(palette.refracted, width),
        RayKind::Shadow => Stroke::dashed(palette.shadow, width, [5.0, 4.0]),
        RayKind::Scattered => Stroke::dashed(palette.scattered, width, [1.5, 3.0]),
    }
}
