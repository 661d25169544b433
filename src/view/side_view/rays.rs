//! The rays themselves, as far as they have come by the current step.

use super::super::drawing::{Form, Spot, Stroke, length};
use super::super::flights::{End, Flight};
use super::super::labels::{Label, clip};
use super::super::text::brief;
use super::{SMALL, SideView, TEXT};
use crate::math::portable;
use crate::record::{EventId, RayKind, Sign, Span, What};
use glam::DVec3;

/// Beyond the longest diagonal of any canvas, in points.
const FAR: f64 = 40_000.0;

impl SideView<'_> {
    pub(super) fn rays(&mut self) {
        self.highlight();
        let current = self.flights.owner(self.step);
        for (index, flight) in self.flights.all.iter().enumerate() {
            if self.has_happened(flight.event) {
                let width = match (index == current, self.is_near(flight)) {
                    (true, _) => 2.4,
                    (false, true) => 1.6,
                    (false, false) => 0.9,
                };
                self.ray(flight, width);
            }
        }
    }

    /// Whether the current ray sent this one, or was sent by it, directly or through others.
    pub(super) fn is_near(&self, flight: &Flight) -> bool {
        let owner = |event: EventId| self.flights.owner(event);
        let parent = self.tree.event(flight.event).parent;
        let sent_by_current = parent.is_some_and(|parent| owner(parent) == owner(self.step));
        sent_by_current || self.tree.path(self.step).into_iter().any(|id| owner(id) == owner(flight.event))
    }

    fn ray(&mut self, flight: &Flight, width: f64) {
        let colour = self.ray_colour(flight.kind).faded(if self.is_in_plane(flight) { 1.0 } else { 0.5 });
        let stroke = match flight.kind {
            RayKind::Shadow => Stroke::dashed(colour, width, [6.0, 4.0]),
            _ => Stroke::solid(colour, width),
        };
        let rest = Stroke::dashed(colour.faded(0.6), 1.2, [1.5, 4.0]);
        match flight.end {
            End::Hit { event, t } if self.has_happened(event) => self.stretch(flight, 0.0, t, stroke),
            End::Blocked { event, t, light } if self.has_happened(event) => {
                self.stretch(flight, 0.0, t, stroke);
                self.stretch(flight, t, light, rest);
                self.cross(self.spot_at(flight, t), 5.0, Stroke::solid(self.palette.bad, 2.2), event);
            }
            End::Light(light) | End::Blocked { light, .. } => self.stretch(flight, 0.0, light, stroke),
            End::Hit { .. } | End::Nothing => self.stretch(flight, 0.0, f64::INFINITY, stroke),
        }
    }

    /// A part of a ray with an arrow head on the way.
    fn stretch(&mut self, flight: &Flight, from: f64, to: f64, stroke: Stroke) {
        let Some([start, end]) = self.visible(flight, from, to) else { return };
        let event = flight.event;
        self.drawing.put(Form::Line { points: vec![start, end], stroke }, event);
        self.placer.avoid_line(start, end);
        let along = [end[0] - start[0], end[1] - start[1]];
        let total = length(along);
        let head = 5.0 + 2.0 * stroke.width;
        if total > 3.5 * head && from == 0.0 {
            let at = |points: f64| [start[0] + along[0] * points / total, start[1] + along[1] * points / total];
            let tip = (0.58 * total).max(head * 2.0);
            let (from, to) = (at(tip - head), at(tip));
            self.drawing.put(Form::Arrow { from, to, head, stroke: Stroke { dash: None, ..stroke } }, event);
        }
    }

    /// The part of a ray between two times that lies on the canvas.
    pub(super) fn visible(&self, flight: &Flight, from: f64, to: f64) -> Option<[Spot; 2]> {
        let canvas = self.drawing.frame().grown(4.0);
        let direction = self.plane.shift(flight.direction);
        let speed = length(direction);
        let origin = self.plane.spot(flight.origin);
        if speed == 0.0 || !speed.is_finite() {
            return clip(&canvas, [origin, origin]);
        }
        // Times beyond the canvas are cut first, so that no infinity comes near the clipping.
        let offset = length([origin[0] - canvas.low[0], origin[1] - canvas.low[1]]);
        let limit = (FAR + offset) / speed;
        let at = |t: f64| {
            let t = t.clamp(-limit, limit);
            [origin[0] + direction[0] * t, origin[1] + direction[1] * t]
        };
        clip(&canvas, [at(from), at(to)])
    }

    /// Where a ray is at a time.
    pub(super) fn spot_at(&self, flight: &Flight, t: f64) -> Spot {
        self.plane.spot(point_at(flight, t))
    }

    /// What the current event is about, under the rays.
    fn highlight(&mut self) {
        let colour = self.palette.highlight;
        let flight = self.current().clone();
        let bands: Vec<[f64; 2]> = match &self.tree.event(self.step).what {
            What::Extent { inside: Some([near, far]), .. } => vec![[*near, *far]],
            What::Combine { combined, .. } => combined.iter().map(ends).collect(),
            What::Object { .. } | What::Primitive { .. } => self.spans_below(),
            What::Ray { .. } | What::Colour { .. } | What::LooseRay { .. } | What::Segment(_) | What::Passage(_) => {
                vec![[0.0, self.known_end(&flight)]]
            }
            _ => Vec::new(),
        };
        for [from, to] in bands {
            if let Some(points) = self.visible(&flight, from, to) {
                let stroke = Stroke::solid(colour.faded(0.55), 9.0);
                self.drawing.put(Form::Line { points: points.to_vec(), stroke }, self.step);
            }
        }
    }

    /// The inside intervals of the current object or primitive, from the events below it.
    fn spans_below(&self) -> Vec<[f64; 2]> {
        let below = self.step..self.tree.subtree_end(self.step);
        for id in below {
            match &self.tree.event(id).what {
                What::Combine { combined, .. } => return combined.iter().map(ends).collect(),
                What::Implicit { signs, .. } => {
                    let inside = signs.iter().filter(|span| span.sign == Sign::Negative);
                    let end = |t: Option<f64>, open: f64| t.unwrap_or(open);
                    return inside.map(|s| [end(s.from, f64::NEG_INFINITY), end(s.to, f64::INFINITY)]).collect();
                }
                _ => {}
            }
        }
        Vec::new()
    }

    /// Where the ray ends as far as is known by now.
    fn known_end(&self, flight: &Flight) -> f64 {
        match flight.end {
            End::Hit { event, t } if self.has_happened(event) => t,
            End::Light(light) | End::Blocked { light, .. } => light,
            _ => f64::INFINITY,
        }
    }

    pub(super) fn cross(&mut self, at: Spot, size: f64, stroke: Stroke, event: EventId) {
        for slope in [1.0, -1.0] {
            let points = vec![[at[0] - size, at[1] - slope * size], [at[0] + size, at[1] + slope * size]];
            self.drawing.put(Form::Line { points, stroke }, event);
        }
        self.placer.avoid_spot(at, size);
    }

    /// Lights that lie on the canvas, and the way to those that do not. The current ray's lights are named.
    pub(super) fn lights(&mut self) {
        let flights = self.flights;
        for flight in flights.all.iter().filter(|flight| flight.kind == RayKind::Shadow) {
            let parent = self.tree.event(flight.event).parent;
            let Some(What::Light { name, .. }) = parent.map(|parent| &self.tree.event(parent).what) else { continue };
            let (End::Light(t) | End::Blocked { light: t, .. }) = flight.end else { continue };
            if !self.has_happened(flight.event) || !self.is_near(flight) {
                continue;
            }
            let lamp = self.spot_at(flight, t);
            let label = |text: String| Label { event: parent, ..Label::new(text, SMALL, self.palette.shadow) };
            if t.is_finite() && self.drawing.frame().grown(-26.0).contains(lamp) {
                let opacity = if self.plane.distance(point_at(flight, t)) < 2.0 { 1.0 } else { 0.55 };
                let label = label(name.clone());
                self.lamp(lamp, opacity, parent);
                self.label_later(lamp, 9.0, label);
            } else if let Some([start, exit]) = self.visible(flight, 0.0, t) {
                let mut frame = self.drawing.frame().grown(-14.0);
                let nearest = std::array::from_fn(|i| exit[i].max(frame.low[i]).min(frame.high[i]));
                // Below the caption.
                frame.low[1] += 20.0;
                let inside = clip(&frame, [start, exit]).map_or(nearest, |[_, end]| end);
                let label = label(format!("to {name}"));
                self.label_later(inside, 4.0, label);
            }
        }
    }

    fn lamp(&mut self, at: Spot, opacity: f64, event: Option<EventId>) {
        let stroke = Stroke::solid(self.palette.shadow.faded(opacity), 1.5);
        for i in 0..8 {
            let (sin, cos) = portable::sin_cos(f64::from(i) * std::f64::consts::FRAC_PI_4);
            let points = vec![[at[0] + 6.0 * cos, at[1] + 6.0 * sin], [at[0] + 9.0 * cos, at[1] + 9.0 * sin]];
            self.drawing.put(Form::Line { points, stroke }, event);
        }
        let fill = Some(self.palette.shadow.faded(0.35 * opacity));
        self.drawing.put(Form::Circle { centre: at, radius: 4.0, fill, stroke: Some(stroke) }, event);
        self.placer.avoid_spot(at, 9.0);
    }

    /// The eye and the image plane, or the way to an eye that is far off.
    pub(super) fn eye(&mut self) {
        let flight = self.flights.all[0].clone();
        let at = self.plane.spot(flight.origin);
        let is_camera = flight.origin == self.scene.camera.eye;
        let event = Some(flight.event).filter(|event| self.has_happened(*event));
        let name = if is_camera { "eye" } else { "start" };
        if self.drawing.frame().contains(at) {
            let rim = Some(Stroke::solid(self.palette.ink, 1.6));
            let fill = Some(self.palette.ground);
            self.drawing.put(Form::Circle { centre: at, radius: 5.0, fill, stroke: rim }, event);
            let fill = Some(self.palette.ink);
            self.drawing.put(Form::Circle { centre: at, radius: 2.0, fill, stroke: None }, event);
            self.placer.avoid_spot(at, 6.0);
            self.label_later(at, 8.0, Label { event, ..Label::new(name, TEXT, self.palette.ink) });
            if is_camera {
                self.image_plane();
            }
        } else if let Some([entry, _]) = self.visible(&flight, 0.0, f64::INFINITY) {
            let distance = length([entry[0] - at[0], entry[1] - at[1]]) / self.plane.scale;
            let frame = self.drawing.frame().grown(-14.0);
            let inside = std::array::from_fn(|i| entry[i].max(frame.low[i]).min(frame.high[i]));
            let label = Label::new(format!("{name}: {} farther back", brief(distance)), SMALL, self.palette.ink);
            self.label_later(inside, 4.0, label);
        }
    }

    /// The image plane at distance 1, where P(1) lies on it.
    fn image_plane(&mut self) {
        let camera = &self.scene.camera;
        let middle = camera.eye + camera.forward;
        let [low, high] = [-camera.half_height, camera.half_height].map(|h| self.plane.spot(middle + camera.up * h));
        if length([high[0] - low[0], high[1] - low[1]]) < 4.0 {
            return;
        }
        let stroke = Stroke::solid(self.palette.faint, 1.4);
        self.drawing.put(Form::Line { points: vec![low, high], stroke }, None);
        self.placer.avoid_line(low, high);
        let lower = if low[1] > high[1] { low } else { high };
        // Clear of the line's own end.
        self.label_later(lower, 9.0, Label::new("image plane", SMALL, self.palette.faint));
    }
}

pub(super) fn point_at(flight: &Flight, t: f64) -> DVec3 {
    flight.origin + flight.direction * t
}

fn ends(span: &Span) -> [f64; 2] {
    let enter = span.enter.as_ref().map_or(f64::NEG_INFINITY, |edge| edge.t);
    [enter, span.leave.as_ref().map_or(f64::INFINITY, |edge| edge.t)]
}
