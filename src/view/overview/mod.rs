//! The scene in space, from anywhere: the objects as lines, the camera with its chosen pixel, the lights, and all rays so far.

mod rays;
mod sight;
#[cfg(test)]
mod tests;
mod things;

pub use sight::{Sight, Stand};

use super::drawing::{Drawing, Form, Frame, Spot, Stroke};
use super::flights::Flights;
use super::palette::Theme;
use super::sheet::Sheet;
use super::side_view::told_rays;
use super::wireframe::Wireframe;
use crate::record::{EventId, What};
use crate::scene::Scene;
use crate::trace::RayTree;

/// From where the scene is seen, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverviewOptions {
    /// Width and height in points.
    pub size: [f64; 2],
    /// Light or dark.
    pub theme: Theme,
    /// Where one stands.
    pub stand: Stand,
    /// Whether what is farther away is smaller.
    pub is_perspective: bool,
    /// 1 shows the whole scene.
    pub zoom: f64,
    /// How far the drawing is shifted, in points to the right and down.
    pub pan: [f64; 2],
    /// A time on the current ray that is marked.
    pub probe_t: Option<f64>,
}

impl Default for OverviewOptions {
    fn default() -> Self {
        Self {
            size: [640.0, 420.0],
            theme: Theme::Light,
            stand: Stand::default(),
            is_perspective: true,
            zoom: 1.0,
            pan: [0.0; 2],
            probe_t: None,
        }
    }
}

/// Room round the scene, in points.
const MARGIN: f64 = 22.0;

/// The scene with the rays up to and with `step`. `wires` are those of the same scene.
#[must_use]
pub fn overview(
    scene: &Scene,
    wires: &Wireframe,
    tree: &RayTree,
    step: EventId,
    options: &OverviewOptions,
) -> Option<Drawing> {
    let step = step.min(tree.end().checked_sub(1)?);
    let flights = Flights::of(tree);
    let sheet = Sheet::new(options.size, options.theme, step);
    let frame = sheet.drawing.frame();
    let sight = Sight::of(scene, wires, options, &frame.grown(-MARGIN));
    let mut view = Overview { sheet, frame, sight, scene, wires, tree, step, flights: &flights, seen: Vec::new() };
    view.objects();
    view.camera();
    view.lights();
    view.rays(options.probe_t);
    view.names();
    view.key();
    view.sheet.drawing.description = view.description();
    Some(view.sheet.finish())
}

/// The view of the drawing that [`overview`] makes with the same arguments: takes points of the world to places.
#[must_use]
pub fn overview_sight(scene: &Scene, wires: &Wireframe, options: &OverviewOptions) -> Sight {
    let frame = Drawing::new(options.size, options.theme.palette().ground).frame();
    Sight::of(scene, wires, options, &frame.grown(-MARGIN))
}

struct Overview<'a> {
    sheet: Sheet,
    frame: Frame,
    sight: Sight,
    scene: &'a Scene,
    wires: &'a Wireframe,
    tree: &'a RayTree,
    step: EventId,
    flights: &'a Flights,
    /// The lines of each object that face the reader, as they lie on the drawing.
    seen: Vec<(usize, Vec<Spot>)>,
}

impl Overview<'_> {
    /// A line in space, as far as it is seen.
    fn line(&mut self, ends: [glam::DVec3; 2], stroke: Stroke, event: Option<EventId>) {
        if let Some(spots) = self.sight.line(ends) {
            self.flat_line(&spots, stroke, event);
        }
    }

    /// A line on the drawing that stands for this event, or for none.
    fn flat_line(&mut self, spots: &[Spot], stroke: Stroke, event: Option<EventId>) {
        let first = self.sheet.drawing.marks.len();
        self.sheet.line(&self.frame, spots, stroke);
        for mark in &mut self.sheet.drawing.marks[first..] {
            mark.event = event;
        }
    }

    fn dot(&mut self, centre: Spot, radius: f64, fill: super::Colour, event: Option<EventId>) {
        if self.frame.grown(-radius).contains(centre) {
            let stroke = Some(Stroke::solid(self.sheet.palette.ground, 1.4));
            let fill = Some(fill);
            self.sheet.drawing.put(Form::Circle { centre, radius, fill, stroke }, event);
            self.sheet.placer.avoid_spot(centre, radius);
        }
    }

    fn description(&self) -> String {
        let names: Vec<&str> = self.scene.objects.iter().map(|object| object.name.as_str()).take(24).collect();
        let more = self.scene.objects.len().saturating_sub(names.len());
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        let lights: Vec<&str> = self.scene.lights.iter().map(|light| light.name.as_str()).collect();
        let lights = if lights.is_empty() { "none".to_owned() } else { lights.join(", ") };
        let eye = super::text::brief_vector(self.scene.camera.eye.to_array());
        let pixel = match self.tree.events[0].what {
            What::Pixel { x, y, .. } => format!(" The chosen pixel is {x}, {y}."),
            _ => String::new(),
        };
        format!(
            "The scene in space. Objects: {}{more}. Lights: {lights}. The eye is at {eye}.{pixel} {}",
            names.join(", "),
            told_rays(self.tree, self.flights, self.step)
        )
    }
}
