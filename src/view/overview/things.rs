//! What stands in the scene: objects, camera, lights.

use super::Overview;
use crate::math::portable;
use crate::record::{EventId, What};
use crate::scene::{Area, LightKind};
use crate::view::Colour;
use crate::view::drawing::{Frame, Spot, Stroke, length};
use crate::view::scene_colour::shown;
use crate::view::sheet::bounds;
use crate::view::wireframe::WireLine;
use glam::DVec3;
use std::f64::consts::TAU;

/// The image plane is drawn as far from the eye as this share of the way to the scene's middle: at its true distance of 1 it
/// would often be a speck, or larger than the scene.
const IMAGE_PLANE: f64 = 0.22;

/// Objects that look smaller than this have no name: in a crowd, names would hide what they name. In points.
const SMALLEST_NAMED: f64 = 30.0;

/// A name that is to be written.
struct Named<'a> {
    /// What it names; none behind the eye.
    spot: Option<Spot>,
    name: &'a str,
    colour: Colour,
    event: Option<EventId>,
    /// How far from the spot it stands at least.
    gap: f64,
}

impl Overview<'_> {
    /// All lines of all objects, those on sides that face away fainter.
    pub(super) fn objects(&mut self) {
        let selected = self.selected_object();
        let events: Vec<Option<EventId>> = (0..self.scene.objects.len()).map(|i| self.object_event(i)).collect();
        let wires = self.wires;
        for is_near in [false, true] {
            for line in &wires.lines {
                let stroke = self.stroke(line, selected == Some(line.object), is_near);
                for run in self.runs(line, is_near) {
                    self.flat_line(&run, stroke, events.get(line.object).copied().flatten());
                    if is_near {
                        self.seen.push((line.object, run));
                    }
                }
            }
        }
    }

    fn stroke(&self, line: &WireLine, is_selected: bool, is_near: bool) -> Stroke {
        let colour = self.colour(line.object);
        let width = match (line.is_crease, is_selected) {
            (true, true) => 2.6,
            (true, false) | (false, true) => 1.7,
            (false, false) => 0.9,
        };
        if is_near {
            Stroke::solid(colour, width)
        } else {
            Stroke::dashed(colour.faded(0.34), 0.6 * width + 0.2, [3.0, 3.0])
        }
    }

    /// A colour of its own where an object has one that is clear of the ground; greys take one of the palette.
    fn colour(&self, object: usize) -> Colour {
        let palette = self.sheet.palette;
        let own = shown(self.scene.materials[self.scene.objects[object].material].diffuse.to_array());
        let (low, high) = (own.r.min(own.g).min(own.b), own.r.max(own.g).max(own.b));
        if high - low > 48 { own.mixed(palette.ink, 0.28) } else { palette.categories[object % 7] }
    }

    /// The parts of a line on sides that face the reader, or those on sides that do not.
    fn runs(&self, line: &WireLine, is_near: bool) -> Vec<Vec<Spot>> {
        let faces: Vec<bool> = line
            .points
            .iter()
            .zip(&line.normals)
            .map(|(point, normals)| normals.iter().any(|normal| self.sight.faces(*point, *normal)))
            .collect();
        let mut runs: Vec<Vec<Spot>> = Vec::new();
        let mut is_open = false;
        for i in 1..line.points.len() {
            let wanted = (faces[i - 1] || faces[i]) == is_near;
            let ends = wanted.then(|| self.sight.line([line.points[i - 1], line.points[i]])).flatten();
            match (ends, is_open, runs.last_mut()) {
                (Some([_, to]), true, Some(run)) => run.push(to),
                (Some([from, to]), ..) => {
                    runs.push(vec![from, to]);
                    is_open = true;
                }
                (None, ..) => is_open = false,
            }
        }
        runs
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
        let happened = &self.tree.events[..=self.step as usize];
        let is_it = |what: &What| matches!(what, What::Object { index, .. } if *index == wanted);
        happened.iter().rev().find(|event| is_it(&event.what)).map(|event| event.id)
    }

    /// The eye, the image plane, and the chosen pixel in it.
    pub(super) fn camera(&mut self) {
        let camera = &self.scene.camera;
        let palette = self.sheet.palette;
        let [low, high] = self.wires.bounds;
        let distance = IMAGE_PLANE * ((low + high) * 0.5).distance(camera.eye).max(1e-6);
        let (half_width, half_height) = camera.half_size(self.scene.image);
        let at = |x: f64, y: f64| camera.eye + camera.direction_through([x, y]) * distance;
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let corners = corners.map(|[x, y]| at(x * half_width, y * half_height));
        let stroke = Stroke::solid(palette.faint, 1.2);
        for (i, corner) in corners.into_iter().enumerate() {
            self.line([corner, corners[(i + 1) % 4]], stroke, None);
            self.line([camera.eye, corner], Stroke::dashed(palette.faint, 0.9, [4.0, 3.0]), None);
        }
        if let What::Pixel { x, y, .. } = self.tree.events[0].what {
            let place = camera.place(self.scene.image, f64::from(x) + 0.5, f64::from(y) + 0.5);
            let event = self.flights.all[0].event;
            if let Some(spot) = self.sight.place(at(place[0], place[1])) {
                self.dot(spot, 3.4, palette.camera, Some(event).filter(|event| *event <= self.step));
            }
        }
        if let Some(spot) = self.sight.place(camera.eye) {
            self.dot(spot, 4.6, palette.ink, None);
        }
    }

    /// Lights as suns with the outline of their shape; of those at infinity the way towards them.
    pub(super) fn lights(&mut self) {
        let scene = self.scene;
        let [low, high] = self.wires.bounds;
        let (middle, radius) = ((low + high) * 0.5, 0.5 * (high - low).length());
        for light in &scene.lights {
            let event = self.light_event(&light.name);
            match light.kind {
                LightKind::Point(point) => self.sun(point, event),
                LightKind::Directional(towards) => {
                    let [from, to] = [middle + towards * (1.15 * radius), middle + towards * (0.85 * radius)];
                    let stroke = Stroke::solid(self.sheet.palette.shadow, 1.6);
                    if let Some([from, to]) = self.sight.line([from, to]) {
                        self.flat_line(&[from, to], stroke, event);
                        self.sheet.arrow(from, to, stroke.colour, 1.6);
                    }
                }
                LightKind::Area(area) => {
                    self.sun(area.middle(), event);
                    self.shape_of(&area, event);
                }
            }
        }
    }

    fn light_event(&self, wanted: &str) -> Option<EventId> {
        let happened = &self.tree.events[..=self.step as usize];
        let is_it = |what: &What| matches!(what, What::Light { name, .. } if name == wanted);
        happened.iter().rev().find(|event| is_it(&event.what)).map(|event| event.id)
    }

    fn sun(&mut self, point: DVec3, event: Option<EventId>) {
        let Some(at) = self.sight.place(point).filter(|at| self.frame.grown(-10.0).contains(*at)) else { return };
        let colour = self.sheet.palette.shadow;
        for i in 0..8 {
            let (sin, cos) = portable::sin_cos(f64::from(i) * TAU / 8.0);
            let ends = [[at[0] + 6.0 * cos, at[1] + 6.0 * sin], [at[0] + 9.0 * cos, at[1] + 9.0 * sin]];
            self.flat_line(&ends, Stroke::solid(colour, 1.5), event);
        }
        self.dot(at, 4.2, colour, event);
    }

    fn shape_of(&mut self, area: &Area, event: Option<EventId>) {
        let circle = |centre: DVec3, radii: [DVec3; 2]| -> Vec<DVec3> {
            let at = |i: u32| f64::from(i % 48) * TAU / 48.0;
            (0..=48).map(|i| centre + radii[0] * portable::cos(at(i)) + radii[1] * portable::sin(at(i))).collect()
        };
        let points = match *area {
            Area::Disc { centre, radii } => circle(centre, radii),
            Area::Sphere { centre, radius } => circle(centre, [self.sight.right * radius, self.sight.up * radius]),
            Area::Rectangle { corner, edges: [a, b] } => vec![corner, corner + a, corner + a + b, corner + b, corner],
        };
        let stroke = Stroke::solid(self.sheet.palette.shadow, 1.2);
        for ends in points.windows(2) {
            self.line([ends[0], ends[1]], stroke, event);
        }
    }

    /// Where each object that is large enough to be named has its name: in its middle, or, where it lies before, behind or inside
    /// another one, at the rightmost of its lines.
    fn named_places(&self) -> Vec<(usize, Spot)> {
        let frames = self.seen_frames();
        let mut places = Vec::new();
        for (object, frame) in frames.iter().enumerate() {
            let extent = self.scene.objects[object].solid.extent();
            let Some(frame) = frame.filter(|frame| extent.is_finite() && length(frame.size()) > SMALLEST_NAMED) else {
                continue;
            };
            let middle = self.sight.place((extent.low + extent.high) * 0.5).unwrap_or_else(|| frame.middle());
            let others = frames.iter().enumerate().filter(|(other, _)| *other != object);
            let is_alone = !others.filter_map(|(_, other)| *other).any(|other| other.contains(middle));
            places.extend(if is_alone { Some(middle) } else { self.rightmost(object) }.map(|spot| (object, spot)));
        }
        places
    }

    /// The box around the lines of each object that has bounds.
    fn seen_frames(&self) -> Vec<Option<Frame>> {
        let mut frames: Vec<Option<[Spot; 2]>> = vec![None; self.scene.objects.len()];
        for (object, run) in &self.seen {
            frames[*object] = bounds(frames[*object].into_iter().flatten().chain(run.iter().copied()));
        }
        let is_bounded = |object: usize| self.scene.objects[object].solid.extent().is_finite();
        let frame = |(object, ends): (usize, Option<[Spot; 2]>)| {
            ends.filter(|_| is_bounded(object)).map(|[low, high]| Frame { low, high })
        };
        frames.into_iter().enumerate().map(frame).collect()
    }

    fn rightmost(&self, object: usize) -> Option<Spot> {
        let room = self.frame.grown(-24.0);
        let lines = self.seen.iter().filter(|(other, _)| *other == object).flat_map(|(_, run)| run).copied();
        lines.filter(|spot| room.contains(*spot)).max_by(|a, b| a[0].total_cmp(&b[0]))
    }

    /// The names of objects, of the eye and of lights, where there is room.
    pub(super) fn names(&mut self) {
        let scene = self.scene;
        let palette = self.sheet.palette;
        let at_eye = self.sight.place(scene.camera.eye);
        let mut names = vec![Named { spot: at_eye, name: "eye", colour: palette.ink, event: None, gap: 8.0 }];
        for light in &scene.lights {
            let point = match light.kind {
                LightKind::Point(point) => point,
                LightKind::Area(area) => area.middle(),
                LightKind::Directional(towards) => {
                    let [low, high] = self.wires.bounds;
                    (low + high) * 0.5 + towards * (0.575 * (high - low).length())
                }
            };
            let (spot, name, event) = (self.sight.place(point), &light.name, self.light_event(&light.name));
            names.push(Named { spot, name, colour: palette.shadow, event, gap: 10.0 });
        }
        for (index, spot) in self.named_places() {
            let colour = self.colour(index).mixed(palette.ink, 0.5);
            let (name, event) = (&scene.objects[index].name, self.object_event(index));
            names.push(Named { spot: Some(spot), name, colour, event, gap: 4.0 });
        }
        for Named { spot, name, colour, event, gap } in names {
            if let Some(spot) = spot.filter(|spot| self.frame.grown(-6.0).contains(*spot)) {
                self.sheet.event = event.unwrap_or(self.step);
                self.sheet.write_near(name, spot, gap, colour);
            }
        }
        self.sheet.event = self.step;
    }
}
