//! A time that is dragged along the ray, and what the shape's own F says there.

use super::{MARGIN, Plot, SMALL, STRIP, TEXT};
use crate::record::{EventId, Sign, SignSpan, Triple, What, format_number};
use crate::scene::Scene;
use crate::trace::RayTree;
use crate::view::drawing::{Anchor, Drawing, Form, Frame, Stroke, Text};
use crate::view::fonts::Face;
use crate::view::labels::{Label, shortened};
use crate::view::primitive_at::PrimitiveAt;
use crate::view::text::{brief, brief_vector};
use std::fmt::Write as _;

/// A sign plot with the place of its t axis and what was found at the time that was asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct ProbedSigns {
    /// The drawing.
    pub drawing: Drawing,
    /// Where its axis lies.
    pub layout: SignPlotLayout,
    /// What was found; none where no time was asked for, or the scene is not the one that was recorded.
    pub probe: Option<SignProbe>,
}

/// How places of a sign plot and times belong together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SignPlotLayout {
    /// The times at the ends of the axis.
    pub t: [f64; 2],
    /// Their places, in points from the left.
    pub x: [f64; 2],
    /// The top and the bottom of what can be dragged, in points from the top.
    pub y: [f64; 2],
}

impl SignPlotLayout {
    /// The time at a place, between the ends of the axis.
    #[must_use]
    pub fn t_at(&self, x: f64) -> f64 {
        let share = ((x - self.x[0]) / (self.x[1] - self.x[0])).clamp(0.0, 1.0);
        (self.t[0] + (self.t[1] - self.t[0]) * share).max(self.t[0]).min(self.t[1])
    }

    /// The place of a time.
    #[must_use]
    pub fn x_at(&self, t: f64) -> f64 {
        self.x[0] + (self.x[1] - self.x[0]) * (t - self.t[0]) / (self.t[1] - self.t[0])
    }
}

/// d at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SignProbe {
    /// The time.
    pub t: f64,
    /// S + c t, in generic coordinates.
    pub point: Triple,
    /// F there: positive outside, zero on the surface, negative inside.
    pub d: f64,
}

impl SignProbe {
    pub(super) fn of(scene: &Scene, tree: &RayTree, event: EventId, t: f64) -> Option<Self> {
        let at = PrimitiveAt::of(scene, tree, event)?;
        Some(Self { t, point: at.point(t).to_array(), d: at.d(t) })
    }

    /// `outside`, `inside`, or `on the surface`.
    #[must_use]
    pub fn side(&self) -> &'static str {
        match self.d {
            d if d > 0.0 => "outside",
            d if d < 0.0 => "inside",
            _ => "on the surface",
        }
    }

    fn told(&self) -> String {
        format!("t = {}: S + c t = {}, d = {}, {}", brief(self.t), brief_vector(self.point), brief(self.d), self.side())
    }
}

/// The times between which the ray is in the extent of the primitive that the event belongs to.
pub(super) fn extent_of(tree: &RayTree, event: EventId) -> Option<[f64; 2]> {
    let is_primitive = |id: &EventId| matches!(tree.event(*id).what, What::Primitive { .. });
    let primitive = tree.path(event).into_iter().rev().find(is_primitive)?;
    (primitive..event).find_map(|id| match &tree.event(id).what {
        What::Extent { inside, .. } => *inside,
        _ => None,
    })
}

impl Plot {
    /// What is found at the probed time, always at the same place, so that it can be read while it changes.
    pub(super) fn read_out(&mut self) {
        let Some(probe) = self.probe else { return };
        let width = self.drawing.width - 2.0 * MARGIN;
        let full = probe.told();
        let short = format!("t = {}: d = {}, {}", brief(probe.t), brief(probe.d), probe.side());
        let text = shortened(&full, width, TEXT, Face::Bold);
        let text = if text == full { full } else { shortened(&short, width, TEXT, Face::Bold) };
        let label = Label::new(text, TEXT, self.palette.ink).face(Face::Bold);
        let at = [self.drawing.width - MARGIN, MARGIN + 20.0];
        self.placer.put_at(&mut self.drawing, label.at(at, Anchor::End, None), Some(self.event));
    }

    /// The handle: a line across the plot with a dot on the curve.
    pub(super) fn probe(&mut self) {
        let Some(probe) = self.probe else { return };
        let (x, [bottom, top]) = (self.t.at(probe.t), self.d.points);
        let stroke = Stroke::solid(self.palette.highlight, 2.2);
        let points = vec![[x, top], [x, bottom + 5.0 + STRIP]];
        self.drawing.put(Form::Line { points, stroke }, self.event);
        let y = self.at([probe.t, probe.d])[1].max(top).min(bottom);
        let rim = Some(Stroke::solid(self.palette.ink, 1.6));
        let fill = Some(self.palette.highlight);
        self.drawing.put(Form::Circle { centre: [x, y], radius: 6.0, fill, stroke: rim }, self.event);
        self.placer.avoid_spot([x, y], 8.0);
    }

    /// Brackets where the ray comes into the extent and out of it.
    pub(super) fn extent(&mut self, inside: Option<[f64; 2]>) {
        let Some([near, far]) = inside.filter(|[near, far]| self.t.shows(*near) || self.t.shows(*far)) else { return };
        let [left, right] = self.t.points;
        let [from, to] = [near, far].map(|t| self.t.at(t).max(left).min(right));
        let [bottom, top] = self.d.points;
        let frame = Frame { low: [from, top], high: [to, bottom] };
        let fill = Some(self.palette.extent.faded(0.1));
        self.drawing.put(Form::Rect { frame, fill, stroke: None }, None);
        let stroke = Stroke::dashed(self.palette.extent, 1.2, [5.0, 4.0]);
        for (t, x) in [(near, from), (far, to)] {
            if self.t.shows(t) {
                self.drawing.put(Form::Line { points: vec![[x, top], [x, bottom]], stroke }, None);
                self.placer.avoid_line([x, top], [x, bottom]);
            }
        }
    }

    /// The name of what is between the brackets, where nothing else is.
    pub(super) fn extent_name(&mut self, inside: Option<[f64; 2]>) {
        let Some([near, far]) = inside.filter(|[near, far]| self.t.shows(*near) || self.t.shows(*far)) else { return };
        let [left, right] = self.t.points;
        let [from, to] = [near, far].map(|t| self.t.at(t).max(left).min(right));
        let [bottom, top] = self.d.points;
        let label = Label::new("extent", SMALL, self.palette.faint);
        let heights = [bottom - 8.0, top + 8.0];
        let places = heights.map(|y| ([from + 4.0, y], Anchor::Start)).into_iter();
        let places = places.chain(heights.map(|y| ([to - 4.0, y], Anchor::End)));
        let texts = places.map(|(at, anchor)| label.at(at, anchor, Some(self.palette.ground)));
        let within = |text: &Text| text.frame().low[0] > from && text.frame().high[0] < to;
        let found = texts.filter(within).find(|text| self.placer.is_clear(&text.frame()));
        if let Some(text) = found {
            self.placer.put_at(&mut self.drawing, text, None);
        }
    }

    pub(super) fn description(&self, equation: &str, roots: &[f64], signs: &[SignSpan]) -> String {
        let mut text = format!("d(t) = F(S + c t) along the ray, with F = {equation}.");
        let zeros: Vec<String> = roots.iter().map(|root| format_number(*root)).collect();
        let zeros = if zeros.is_empty() {
            " It is nowhere zero.".to_owned()
        } else {
            format!(" It is zero at t = {}.", zeros.join(", "))
        };
        text.push_str(&zeros);
        for span in signs {
            let side = if span.sign == Sign::Positive { "positive, outside" } else { "negative, inside" };
            let from = span.from.map_or("−∞".to_owned(), format_number);
            let to = span.to.map_or("∞".to_owned(), format_number);
            let _ = write!(text, " From {from} to {to} it is {side}.");
        }
        if let Some(probe) = self.probe {
            let _ = write!(text, " Marked: {}.", probe.told());
        }
        text
    }
}
