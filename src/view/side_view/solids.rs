//! The objects' sections and extents.

use super::super::drawing::{Form, Spot, Stroke};
use super::super::labels::Label;
use super::super::palette::Colour;
use super::section::section;
use super::{SMALL, SideView, TEXT};
use crate::csg::{Leaf, Solid};
use crate::math::portable;
use crate::record::{Event, EventId, What};
use crate::scene::{Material, Object};
use crate::shape::{Primitive, Shape};
use crate::trace::srgb;
use glam::DVec3;
use std::f64::consts::TAU;

impl SideView<'_> {
    /// Every object's section, filled in the colour of its material.
    pub(super) fn solids(&mut self) {
        let selected = self.selected_object();
        for (index, object) in self.scene.objects.iter().enumerate() {
            let section = section(&object.solid, &self.plane, self.drawing.frame());
            let material = &self.scene.materials[object.material];
            let colour = self.tint(index, material);
            let see_through = material.transparency > 0.0;
            let event = self.object_event(index);
            if !section.rings.is_empty() {
                let opacity = if see_through { 0.16 } else { 0.34 };
                self.drawing.put(Form::Area { rings: section.rings, fill: colour.faded(opacity) }, event);
            }
            let is_selected = selected == Some(index);
            let stroke = Stroke::solid(colour, if is_selected { 2.4 } else { 1.4 });
            for points in section.outline.into_iter().filter(|points| points.len() > 1) {
                self.placer.avoid_outline(&points);
                self.drawing.put(Form::Line { points, stroke }, event);
            }
            for points in self.sheets(&object.solid) {
                self.drawing.put(Form::Line { points, stroke: Stroke::solid(colour, 2.6) }, event);
            }
            if let Some((middle, length)) = section.middle {
                self.name_object(object, middle, length, colour, event);
            }
        }
    }

    fn name_object(&mut self, object: &Object, middle: Spot, length: f64, colour: Colour, event: Option<EventId>) {
        let colour = colour.mixed(self.palette.ink, 0.45);
        let label = Label { event, ..Label::new(object.name.clone(), TEXT, colour) };
        let gap = if length > 60.0 { 0.0 } else { 8.0 };
        self.label_later(middle, gap, label);
    }

    /// Where the surfaces that bound nothing (squares) cross the plane.
    fn sheets(&self, solid: &Solid) -> Vec<Vec<Spot>> {
        let is_sheet = |leaf: &&Leaf| matches!(leaf.shape, Shape::Square(_));
        solid.leaves.iter().filter(is_sheet).filter_map(|leaf| self.crossing(leaf)).collect()
    }

    /// The line from the first to the last place where a sheet's edges cross the plane.
    fn crossing(&self, leaf: &Leaf) -> Option<Vec<Spot>> {
        let height = |p: DVec3| (p - self.plane.origin).dot(self.plane.normal);
        let mut found = Vec::new();
        for line in leaf.shape.outline() {
            let world: Vec<DVec3> =
                line.iter().map(|&p| leaf.placement.world_from_generic().transform_point3(p)).collect();
            for ends in world.windows(2) {
                let (a, b) = (height(ends[0]), height(ends[1]));
                if (a < 0.0) != (b < 0.0) {
                    found.push(self.plane.spot(ends[0].lerp(ends[1], a / (a - b))));
                }
            }
        }
        (found.len() > 1).then(|| vec![found[0], found[found.len() - 1]])
    }

    /// The material's own colour where it has one, else one of the palette; always clear of the ground.
    fn tint(&self, index: usize, material: &Material) -> Colour {
        let [r, g, b] = srgb(material.diffuse);
        let (low, high) = (r.min(g).min(b), r.max(g).max(b));
        let own = Colour { r, g, b, a: 255 };
        if high - low > 48 { own.mixed(self.palette.ink, 0.28) } else { self.palette.categories[index % 7] }
    }

    /// The object that the current step is about.
    fn selected_object(&self) -> Option<usize> {
        self.tree.path(self.step).into_iter().rev().find_map(|id| match &self.tree.event(id).what {
            What::Object { index, .. } => Some(*index),
            What::Hit { object, .. } => self.scene.objects.iter().position(|other| other.name == *object),
            _ => None,
        })
    }

    /// The latest event that tells of an object, so that a click on it leads there.
    fn object_event(&self, wanted: usize) -> Option<EventId> {
        let is_it = |event: &&Event| matches!(event.what, What::Object { index, .. } if index == wanted);
        self.tree.events.iter().take(self.step as usize + 1).rev().find(is_it).map(|event| event.id)
    }

    /// The extents that the current object's search has come to.
    pub(super) fn extents(&mut self) {
        let is_object = |id: &EventId| matches!(self.tree.event(*id).what, What::Object { .. });
        let Some(object) = self.tree.path(self.step).into_iter().rev().find(is_object) else { return };
        for id in object..=self.step {
            let (name, mut points) = match &self.tree.event(id).what {
                What::Extent { of, low, high, .. } => {
                    let section = self.box_section(DVec3::from_array(*low), DVec3::from_array(*high));
                    (format!("extent of {of}"), section)
                }
                What::Ball { of, centre, radius, .. } => {
                    (format!("ball around {of}"), self.ball_section(DVec3::from_array(*centre), *radius))
                }
                _ => continue,
            };
            if points.len() < 3 {
                continue;
            }
            points.push(points[0]);
            let is_current = id == self.step;
            let corner = points.iter().copied().reduce(|a, b| if b[1] - b[0] < a[1] - a[0] { b } else { a });
            let (colour, width) = if is_current { (self.palette.ink, 2.0) } else { (self.palette.extent, 1.2) };
            self.drawing.put(Form::Line { points, stroke: Stroke::dashed(colour, width, [5.0, 4.0]) }, id);
            if let (true, Some(corner)) = (is_current, corner) {
                let label = Label::new(name, SMALL, colour).of(id);
                self.label_later(corner, 4.0, label);
            }
        }
    }

    /// The circle in which a ball crosses the plane.
    fn ball_section(&self, centre: DVec3, radius: f64) -> Vec<Spot> {
        const SIDES: u32 = 96;
        let height = (centre - self.plane.origin).dot(self.plane.normal);
        let square = radius * radius - height * height;
        if !(square > 0.0 && square.is_finite()) {
            return Vec::new();
        }
        let (middle, across) = (centre - self.plane.normal * height, self.plane.normal.any_orthonormal_vector());
        let upwards = self.plane.normal.cross(across);
        let at = |k: u32| {
            let (sin, cos) = portable::sin_cos(TAU * f64::from(k) / f64::from(SIDES));
            self.plane.spot(middle + (across * cos + upwards * sin) * square.sqrt())
        };
        (0..SIDES).map(at).collect()
    }

    /// The polygon in which a box crosses the plane, in order round it.
    fn box_section(&self, low: DVec3, high: DVec3) -> Vec<Spot> {
        if !(low.is_finite() && high.is_finite()) {
            return Vec::new();
        }
        let corners: Vec<DVec3> = super::fit::corners(low, high).collect();
        let height = |p: DVec3| (p - self.plane.origin).dot(self.plane.normal);
        let mut found: Vec<Spot> = Vec::new();
        for a in 0..8_usize {
            // An edge of the box joins corners whose numbers differ in one bit.
            for b in [1, 2, 4].map(|bit| a | bit).into_iter().filter(|&b| b != a) {
                let (from, to) = (height(corners[a]), height(corners[b]));
                if (from < 0.0) != (to < 0.0) {
                    found.push(self.plane.spot(corners[a].lerp(corners[b], from / (from - to))));
                }
            }
        }
        // The section is convex, so that a weighted mean of its corners lies within.
        let mean = |a: Spot, b: Spot| std::array::from_fn(|i| f64::midpoint(a[i], b[i]));
        let middle: Spot = found.iter().copied().reduce(mean).unwrap_or_default();
        let angle = |spot: &Spot| portable::atan2(spot[1] - middle[1], spot[0] - middle[0]);
        found.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
        found
    }
}
