//! Snell's angles at the hit of the current ray, where the plane of incidence is the plane of the drawing.

use super::super::drawing::{Form, Spot, Stroke};
use super::super::flights::End;
use super::super::labels::Label;
use super::super::text::brief;
use super::{SMALL, SideView, TEXT, Waiting};
use crate::math::portable;
use crate::record::{Event, What};
use glam::DVec3;

/// Radii of the arcs and length of the normal's line on the far side, in points.
const FIRST: f64 = 26.0;
const SECOND: f64 = 30.0;
const CRITICAL: f64 = 44.0;
const FAR_SIDE: f64 = 40.0;

impl SideView<'_> {
    pub(super) fn angles(&mut self) {
        let flight = self.current().clone();
        let End::Hit { event, t } = flight.end else { return };
        let What::Hit { n_shading, .. } = &self.tree.event(event).what else { return };
        let normal = DVec3::from_array(*n_shading);
        let snell = self.current_events().find(|event| matches!(event.what, What::Snell { .. })).cloned();
        let (Some(snell), true) = (snell, self.plane.holds_direction(normal)) else { return };
        if self.plane.holds_direction(flight.direction) {
            self.snell(&snell, self.spot_at(&flight, t), normal, flight.direction);
        }
    }

    fn snell(&mut self, event: &Event, at: Spot, normal: DVec3, direction: DVec3) {
        let What::Snell { theta1, theta2, critical, refracted, .. } = &event.what else { return };
        let far = self.towards(-normal);
        let foot = [at[0] + far[0] * FAR_SIDE, at[1] + far[1] * FAR_SIDE];
        let dashed = Stroke::dashed(self.palette.normal, 1.2, [4.0, 3.0]);
        self.drawing.put(Form::Line { points: vec![at, foot], stroke: dashed }, event.id);
        let theta1 = format!("θ₁ = {}°", brief(*theta1));
        self.arc(event, at, FIRST, [normal, -direction], Some(&theta1));
        if let (Some(refracted), Some(theta2)) = (refracted, theta2) {
            let theta2 = format!("θ₂ = {}°", brief(*theta2));
            self.arc(event, at, SECOND, [-normal, DVec3::from_array(*refracted)], Some(&theta2));
        }
        if let Some(critical) = critical {
            self.critical(event, at, normal, direction, *critical);
        }
    }

    /// A line at the critical angle, on the side that the ray comes from.
    fn critical(&mut self, event: &Event, at: Spot, normal: DVec3, direction: DVec3, critical: f64) {
        let Some(along) = (-direction - normal * -direction.dot(normal)).try_normalize() else { return };
        let (sin, cos) = portable::sin_cos(critical.to_radians());
        let way = self.towards(normal * cos + along * sin);
        let end = [at[0] + way[0] * CRITICAL, at[1] + way[1] * CRITICAL];
        let stroke = Stroke::dashed(self.palette.bad, 1.2, [3.0, 3.0]);
        self.drawing.put(Form::Line { points: vec![at, end], stroke }, event.id);
        let label = Label::new(format!("critical {}°", brief(critical)), SMALL, self.palette.bad).of(event.id);
        self.label_later(end, 3.0, label);
    }

    /// An arc between two directions, the short way round.
    fn arc(&mut self, event: &Event, at: Spot, radius: f64, directions: [DVec3; 2], text: Option<&str>) {
        let [from, to] = directions.map(|direction| {
            let [x, y] = self.towards(direction);
            portable::atan2(y, x)
        });
        let turn = (to - from + 3.0 * std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI;
        let stroke = Stroke::solid(self.palette.normal, 1.6);
        let angles = [from, from + turn];
        self.drawing.put(Form::Arc { centre: at, radius, angles, stroke }, event.id);
        let (sin, cos) = portable::sin_cos(from + turn / 2.0);
        let middle = [at[0] + radius * cos, at[1] + radius * sin];
        if let Some(text) = text {
            let label = Label::new(text, TEXT, self.palette.normal).of(event.id);
            let important = Waiting { around: middle, gap: 6.0, label };
            self.labels.insert(0, important);
        }
    }

    /// A direction of the world as a unit vector of the drawing.
    fn towards(&self, direction: DVec3) -> Spot {
        let [x, y] = self.plane.shift(direction);
        let length = portable::hypot(x, y).max(f64::MIN_POSITIVE);
        [x / length, y / length]
    }
}
