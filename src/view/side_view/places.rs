//! Points on the rays: candidates, rejected hits, hits, and their normals.

use super::super::drawing::{Form, Spot, Stroke, length};
use super::super::flights::{End, Flight};
use super::super::labels::Label;
use super::super::palette::Colour;
use super::super::text::brief;
use super::{SMALL, SideView, TEXT, Waiting};
use crate::record::{CandidateFate, Certificate, EventId, RayKind, What};
use glam::DVec3;

/// Length of a normal's arrow, in points, where it lies in the plane.
const NORMAL: f64 = 34.0;

/// More rejected hits than these get no label: they would hide the drawing.
const MOST_LABELS: usize = 8;

impl SideView<'_> {
    pub(super) fn places(&mut self) {
        self.hits();
        self.undecidable();
        self.candidates();
        self.rejected();
    }

    /// The time on the current ray that is looked at.
    pub(super) fn probe(&mut self, probe_t: Option<f64>) {
        let Some(t) = probe_t.filter(|t| t.is_finite()) else { return };
        let flight = self.current().clone();
        let at = self.spot_at(&flight, t);
        if !self.drawing.frame().contains(at) {
            return;
        }
        let (fill, rim) = (Some(self.palette.highlight), Some(Stroke::solid(self.palette.ink, 1.6)));
        self.drawing.put(Form::Circle { centre: at, radius: 6.0, fill, stroke: rim }, flight.event);
        self.placer.avoid_spot(at, 7.0);
        let label = Label::new(format!("t = {}", brief(t)), TEXT, self.palette.ink).of(flight.event);
        self.labels.insert(0, Waiting { around: at, gap: 8.0, label });
    }

    /// The hits of all rays so far, each with its normal.
    fn hits(&mut self) {
        let current = self.flights.owner(self.step);
        for (index, flight) in self.flights.all.iter().enumerate() {
            let End::Hit { event, t } = flight.end else { continue };
            if !self.has_happened(event) || flight.kind == RayKind::Shadow {
                continue;
            }
            let at = self.spot_at(flight, t);
            self.normal(event, at, index == current);
            self.dot(at, 4.5, self.ray_colour(flight.kind), event);
            let text = format!("t = {}", brief(t));
            if index == current {
                let label = Label::new(self.hit_text(event, text), TEXT, self.palette.ink).of(event);
                self.labels.insert(0, Waiting { around: at, gap: 7.0, label });
            } else if self.is_near(flight) && self.is_long(flight, t) {
                self.label_later(at, 7.0, Label::new(text, SMALL, self.palette.faint).of(event));
            }
        }
        let frame = self.drawing.frame();
        self.labels.retain(|waiting| frame.contains(waiting.around));
    }

    /// Where the current ray's own numbers do not say whether it meets a primitive: a broken ring and a question mark.
    fn undecidable(&mut self) {
        let flight = self.current().clone();
        let places: Vec<(EventId, f64)> = self
            .current_events()
            .filter_map(|event| match &event.what {
                What::Decision { near: Some(t), certificate: Certificate::Undecidable, .. } => Some((event.id, *t)),
                _ => None,
            })
            .collect();
        let mut labelled: Vec<Spot> = Vec::new();
        for (event, t) in places {
            let at = self.spot_at(&flight, t);
            if !self.drawing.frame().contains(at) {
                continue;
            }
            if event == self.step {
                self.ring(at, event);
            }
            let stroke = Some(Stroke::dashed(self.palette.bad, 1.8, [3.5, 2.5]));
            self.drawing.put(Form::Circle { centre: at, radius: 8.0, fill: None, stroke }, event);
            self.placer.avoid_spot(at, 8.0);
            if labelled.iter().all(|other| is_clear(*other, at)) {
                labelled.push(at);
                self.label_later(at, 9.0, Label::new("hit or miss? undecidable", SMALL, self.palette.bad).of(event));
            }
        }
    }

    fn hit_text(&self, event: EventId, time: String) -> String {
        match &self.tree.event(event).what {
            What::Hit { part, leaf, .. } => format!("{time}, {part} of {leaf}"),
            _ => time,
        }
    }

    /// Whether a ray is long enough in the drawing for its hit time to say something there.
    fn is_long(&self, flight: &Flight, t: f64) -> bool {
        let [x, y] = self.plane.shift(flight.direction * t);
        length([x, y]) > 40.0
    }

    fn normal(&mut self, event: EventId, at: Spot, is_current: bool) {
        let What::Hit { n_geometric, .. } = &self.tree.event(event).what else { return };
        let normal = DVec3::from_array(*n_geometric);
        let [x, y] = self.plane.shift(normal).map(|shift| shift / self.plane.scale * NORMAL);
        // A normal that points at the reader has no arrow to speak of.
        if length([x, y]) < 8.0 {
            return;
        }
        let colour = self.palette.normal.faded(if is_current { 1.0 } else { 0.6 });
        let tip = [at[0] + x, at[1] + y];
        let stroke = Stroke::solid(colour, if is_current { 2.0 } else { 1.3 });
        self.drawing.put(Form::Arrow { from: at, to: tip, head: 8.0, stroke }, event);
        self.placer.avoid_line(at, tip);
        if is_current {
            self.label_later(tip, 3.0, Label::new("n", TEXT, self.palette.normal).of(event));
        }
    }

    pub(super) fn dot(&mut self, at: Spot, radius: f64, colour: Colour, event: EventId) {
        if event == self.step || self.is_about(event) {
            self.ring(at, event);
        }
        let rim = Some(Stroke::solid(self.palette.ground, 1.5));
        self.drawing.put(Form::Circle { centre: at, radius, fill: Some(colour), stroke: rim }, event);
        self.placer.avoid_spot(at, radius);
    }

    /// Whether the current step tells of what light does at this hit.
    fn is_about(&self, hit: EventId) -> bool {
        let at_a_hit = matches!(
            self.tree.event(self.step).what,
            What::Ambient { .. }
                | What::Light { .. }
                | What::Reflection { .. }
                | What::Snell { .. }
                | What::Medium { .. }
                | What::Limit { .. }
                | What::Colour { .. }
        );
        at_a_hit && matches!(self.current().end, End::Hit { event, .. } if event == hit)
    }

    /// Says: this is what the current step is about.
    fn ring(&mut self, at: Spot, event: EventId) {
        let fill = Some(self.palette.highlight.faded(0.5));
        self.drawing.put(Form::Circle { centre: at, radius: 11.0, fill, stroke: None }, event);
        let stroke = Some(Stroke::solid(self.palette.highlight, 2.0));
        self.drawing.put(Form::Circle { centre: at, radius: 11.0, fill: None, stroke }, event);
        self.placer.avoid_spot(at, 11.0);
    }

    /// While the current ray is still searching: the hit times that each primitive keeps.
    fn candidates(&mut self) {
        let flight = self.current().clone();
        let found = matches!(flight.end, End::Hit { event, .. } if self.has_happened(event));
        let mut kept: Vec<(f64, EventId)> = Vec::new();
        for event in self.current_events() {
            if let What::Roots { candidates } = &event.what {
                let accepted = candidates.iter().filter(|candidate| candidate.fate == CandidateFate::Accepted);
                kept.extend(accepted.map(|candidate| (candidate.t, event.id)));
            }
        }
        for (t, event) in kept {
            let at = self.spot_at(&flight, t);
            if !self.drawing.frame().contains(at) || (found && event != self.step) {
                continue;
            }
            if event == self.step || self.tree.event(event).parent == Some(self.step) {
                self.ring(at, event);
                let label = Label::new(format!("t = {}", brief(t)), SMALL, self.palette.ink).of(event);
                self.label_later(at, 7.0, label);
            }
            let stroke = Some(Stroke::solid(paler_behind(t, self.palette.ink), 1.4));
            let fill = Some(self.palette.ground);
            self.drawing.put(Form::Circle { centre: at, radius: 3.2, fill, stroke }, event);
            self.placer.avoid_spot(at, 3.2);
        }
    }

    /// Hits of the current ray that do not count, with the reason for the one that is selected.
    fn rejected(&mut self) {
        let flight: Flight = self.current().clone();
        let rejected: Vec<(EventId, f64, String)> = self
            .current_events()
            .filter_map(|event| match &event.what {
                What::Rejected { t, reason, .. } => Some((event.id, *t, reason.clone())),
                _ => None,
            })
            .collect();
        // The place that the ray left is on its own surface again; its t of nearly 0 says nothing.
        let mut labelled: Vec<Spot> = vec![self.plane.spot(flight.origin)];
        for (event, t, reason) in rejected {
            let at = self.spot_at(&flight, t);
            if !self.drawing.frame().contains(at) {
                continue;
            }
            let colour = paler_behind(t, self.palette.bad);
            if event == self.step {
                self.ring(at, event);
                let label = Label::new(format!("t = {}: {reason}", brief(t)), TEXT, self.palette.ink).of(event);
                self.labels.insert(0, Waiting { around: at, gap: 8.0, label });
            } else if labelled.len() < MOST_LABELS && labelled.iter().all(|other| is_clear(*other, at)) {
                labelled.push(at);
                self.label_later(at, 6.0, Label::new(brief(t), SMALL, self.palette.bad).of(event));
            }
            self.cross(at, 3.6, Stroke::solid(colour, 1.6), event);
        }
    }
}

/// What lies behind the ray's start is paler.
fn paler_behind(t: f64, colour: Colour) -> Colour {
    if t < 0.0 { colour.faded(0.45) } else { colour }
}

/// Whether two spots are far enough apart for a label each.
fn is_clear(a: Spot, b: Spot) -> bool {
    length([a[0] - b[0], a[1] - b[1]]) > 14.0
}
