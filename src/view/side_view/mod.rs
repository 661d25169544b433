//! The side view: a section of the scene with everything that the rays did in it so far.

mod angles;
mod fit;
mod places;
mod plane;
mod rays;
mod section;
mod solids;
mod telling;
#[cfg(test)]
mod tests;

pub(super) use plane::view_up;
pub use plane::{PlaneView, SectionPlane};
pub(super) use section::section;
pub(super) use telling::told_rays;

use super::axis::round_step;
use super::drawing::{Anchor, Drawing, Form, Spot, Stroke};
use super::flights::{Flight, Flights};
use super::fonts::Face;
use super::labels::{Label, Placer, shortened};
use super::palette::{Palette, Theme};
use super::text::brief;
use crate::record::{Event, EventId, RayKind, What};
use crate::scene::Scene;
use crate::trace::RayTree;

/// What of the side view is seen, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SideViewOptions {
    /// Width and height in points.
    pub size: [f64; 2],
    /// Light or dark.
    pub theme: Theme,
    /// Which plane is drawn.
    pub plane: SectionPlane,
    /// 1 shows the eye and what was hit; 2 makes it twice as large.
    pub zoom: f64,
    /// How far the drawing is shifted, in points to the right and down.
    pub pan: [f64; 2],
    /// A time on the current ray that is marked.
    pub probe_t: Option<f64>,
}

impl Default for SideViewOptions {
    fn default() -> Self {
        Self {
            size: [640.0, 420.0],
            theme: Theme::Light,
            plane: SectionPlane::RayAndUp,
            zoom: 1.0,
            pan: [0.0, 0.0],
            probe_t: None,
        }
    }
}

/// Sizes in points.
const TEXT: f64 = 11.5;
const SMALL: f64 = 10.5;
const MARGIN: f64 = 10.0;

/// The section of the scene with the rays up to and including `step`, which is highlighted.
#[must_use]
pub fn side_view(scene: &Scene, tree: &RayTree, step: EventId, options: &SideViewOptions) -> Drawing {
    let palette = options.theme.palette();
    let drawing = Drawing::new(options.size, palette.ground);
    if tree.events.is_empty() {
        return drawing;
    }
    let step = step.min(tree.end() - 1);
    let flights = Flights::of(tree);
    let view = SideView {
        plane: section_plane_of(scene, tree, &flights, step, options),
        placer: Placer::new(drawing.frame().grown(-3.0)),
        drawing,
        palette,
        scene,
        tree,
        step,
        flights: &flights,
        labels: Vec::new(),
    };
    view.draw(options)
}

/// The plane of the drawing that [`side_view`] makes with the same arguments: takes places of the drawing to points of
/// the world and back.
#[must_use]
pub fn side_view_plane(scene: &Scene, tree: &RayTree, step: EventId, options: &SideViewOptions) -> PlaneView {
    let flights = Flights::of(tree);
    section_plane_of(scene, tree, &flights, step.min(tree.end().saturating_sub(1)), options)
}

fn section_plane_of(
    scene: &Scene,
    tree: &RayTree,
    flights: &Flights,
    step: EventId,
    options: &SideViewOptions,
) -> PlaneView {
    let plane = plane::choose(scene, tree, flights, step, options.plane);
    fit::fit(plane, scene, tree, flights, options)
}

/// A label that waits for its place until everything else is drawn.
struct Waiting {
    around: Spot,
    gap: f64,
    label: Label,
}

struct SideView<'a> {
    drawing: Drawing,
    placer: Placer,
    palette: &'static Palette,
    plane: PlaneView,
    scene: &'a Scene,
    tree: &'a RayTree,
    step: EventId,
    flights: &'a Flights,
    /// In the order of their importance.
    labels: Vec<Waiting>,
}

impl SideView<'_> {
    /// From the bottom up. Labels come last, the most important first.
    fn draw(mut self, options: &SideViewOptions) -> Drawing {
        self.solids();
        self.extents();
        self.rays();
        self.places();
        self.eye();
        self.lights();
        self.angles();
        self.probe(options.probe_t);
        self.caption(options.plane);
        self.scale_bar();
        self.place_labels();
        let rays = told_rays(self.tree, self.flights, self.step);
        self.drawing.description = format!("{}. {rays}", self.title(options.plane));
        self.drawing
    }

    /// The ray that the current step belongs to.
    fn current(&self) -> &Flight {
        self.flights.ray_of(self.step)
    }

    /// Whether the event has happened by the current step.
    fn has_happened(&self, event: EventId) -> bool {
        event <= self.step
    }

    /// The events up to the current step that belong to the current ray.
    fn current_events(&self) -> impl Iterator<Item = &Event> {
        let owner = self.flights.owner(self.step);
        let happened = &self.tree.events[..=self.step as usize];
        happened.iter().filter(move |event| self.flights.owner(event.id) == owner)
    }

    fn label_later(&mut self, around: Spot, gap: f64, label: Label) {
        if self.drawing.frame().contains(around) {
            self.labels.push(Waiting { around, gap, label });
        }
    }

    fn place_labels(&mut self) {
        for Waiting { around, gap, label } in std::mem::take(&mut self.labels) {
            self.placer.put_near(&mut self.drawing, around, gap, &label, self.palette);
        }
    }

    fn caption(&mut self, plane: SectionPlane) {
        let text = self.title(plane);
        let text = shortened(&text, self.drawing.width - 2.0 * MARGIN, TEXT, Face::Sans);
        let label = Label::new(text, TEXT, self.palette.faint);
        let text = label.at([MARGIN, MARGIN + 4.0], Anchor::Start, Some(self.palette.ground));
        let frame = text.frame();
        if text.text.is_empty() || !self.placer.is_free(&frame) {
            return;
        }
        // Rays to lights run through this corner often: they end at the words, and no name stands beside them.
        let fill = Some(self.palette.ground.faded(0.88));
        self.drawing.put(Form::Rect { frame: frame.grown(3.0), fill, stroke: None }, None);
        self.placer.put_at(&mut self.drawing, text, None);
        self.placer.reserve(frame.grown(9.0));
    }

    /// Which plane it is.
    fn title(&self, plane: SectionPlane) -> String {
        match plane {
            SectionPlane::RayAndUp if matches!(self.tree.events[0].what, What::LooseRay { .. }) => {
                "Section through the ray and the view's up".to_owned()
            }
            SectionPlane::RayAndUp => "Section through the camera ray and the view's up".to_owned(),
            SectionPlane::Incidence => format!("Plane of incidence of the {} ray", self.current().kind.name()),
        }
    }

    fn scale_bar(&mut self) {
        let length = round_step(70.0 / self.plane.scale / 2.0);
        let points = length * self.plane.scale;
        let (y, left) = (self.drawing.height - 12.0, MARGIN);
        let stroke = Stroke::solid(self.palette.faint, 1.2);
        let ends = [left, left + points];
        let bar = vec![[ends[0], y - 3.0], [ends[0], y], [ends[1], y], [ends[1], y - 3.0]];
        self.drawing.put(Form::Line { points: bar, stroke }, None);
        let label = Label::new(brief(length), SMALL, self.palette.ink);
        let text = label.at([ends[1] + 6.0, y - 2.0], Anchor::Start, Some(self.palette.ground));
        self.placer.put_at(&mut self.drawing, text, None);
        self.aside_note(y - 2.0);
    }

    /// Says so when rays that leave the plane are drawn in it.
    fn aside_note(&mut self, y: f64) {
        let aside = self.flights.all.iter().any(|flight| self.has_happened(flight.event) && !self.is_in_plane(flight));
        if aside {
            let label = Label::new("faded: projected into this plane", SMALL, self.palette.faint);
            let at = [self.drawing.width - MARGIN, y];
            let text = label.at(at, Anchor::End, Some(self.palette.ground));
            self.placer.put_at(&mut self.drawing, text, None);
        }
    }

    /// Whether the ray lies in the plane, to within what can be seen.
    fn is_in_plane(&self, flight: &Flight) -> bool {
        self.plane.distance(flight.origin) < 1.5 && self.plane.holds_direction(flight.direction)
    }

    const fn ray_colour(&self, kind: RayKind) -> super::Colour {
        match kind {
            RayKind::Camera => self.palette.camera,
            RayKind::Reflected => self.palette.reflected,
            RayKind::Refracted => self.palette.refracted,
            RayKind::Shadow => self.palette.shadow,
            RayKind::Scattered => self.palette.scattered,
        }
    }
}
