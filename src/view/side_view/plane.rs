//! The plane of the drawing, and how its points and those of the world belong together.

use super::super::drawing::Spot;
use super::super::flights::{End, Flights};
use crate::record::{EventId, What};
use crate::scene::{Camera, Scene};
use crate::trace::RayTree;
use glam::DVec3;

/// Which plane is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SectionPlane {
    /// The plane that holds the camera ray (or the ray that was given) and the view's up direction.
    #[default]
    RayAndUp,
    /// The plane that holds the selected ray and the normal where it hits. Where there is no hit, or the ray meets the
    /// surface head on, it is the plane of that ray and the view's up direction.
    Incidence,
}

/// A drawing's plane in the world, and its scale.
///
/// A place `[x, y]` of the drawing, in points from the top left corner with y down, is the world's point
/// `origin + across (x − centre.x) / scale − up (y − centre.y) / scale`. `across`, `up` and `normal` are unit vectors at
/// right angles; `normal` points towards the reader. Points beside the plane are drawn at the foot of their perpendicular.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneView {
    /// A point of the plane.
    pub origin: DVec3,
    /// To the right of the drawing.
    pub across: DVec3,
    /// To its top.
    pub up: DVec3,
    /// Towards the reader.
    pub normal: DVec3,
    /// Points of the drawing for a unit of the world.
    pub scale: f64,
    /// Where `origin` is in the drawing.
    pub centre: Spot,
}

impl PlaneView {
    /// Where a point of the world is drawn.
    #[must_use]
    pub fn spot(&self, world: DVec3) -> Spot {
        let [x, y] = self.shift(world - self.origin);
        [self.centre[0] + x, self.centre[1] + y]
    }

    /// A vector of the world in points of the drawing.
    #[must_use]
    pub fn shift(&self, vector: DVec3) -> Spot {
        [vector.dot(self.across) * self.scale, -vector.dot(self.up) * self.scale]
    }

    /// The point of the plane that is drawn at `spot`.
    #[must_use]
    pub fn world(&self, spot: Spot) -> DVec3 {
        let (x, y) = ((spot[0] - self.centre[0]) / self.scale, (spot[1] - self.centre[1]) / self.scale);
        self.origin + self.across * x - self.up * y
    }

    /// How far a point of the world lies off the plane, in points of the drawing.
    #[must_use]
    pub fn distance(&self, world: DVec3) -> f64 {
        ((world - self.origin).dot(self.normal) * self.scale).abs()
    }

    /// Whether a direction lies in the plane, to within what can be seen.
    #[must_use]
    pub fn holds_direction(&self, direction: DVec3) -> bool {
        direction.dot(self.normal).abs() <= 0.01 * direction.length()
    }
}

/// The plane that the options ask for, in unit scale and with its origin at the drawing's corner.
pub(super) fn choose(
    scene: &Scene,
    tree: &RayTree,
    flights: &Flights,
    step: EventId,
    which: SectionPlane,
) -> PlaneView {
    let flight = match which {
        SectionPlane::RayAndUp => &flights.all[0],
        SectionPlane::Incidence => flights.ray_of(step),
    };
    let direction = flight.direction.normalize_or(scene.camera.forward);
    let incidence = (which == SectionPlane::Incidence).then(|| match flight.end {
        End::Hit { event, .. } => match &tree.event(event).what {
            What::Hit { n_geometric, .. } => DVec3::from_array(*n_geometric).cross(direction).try_normalize(),
            _ => None,
        },
        _ => None,
    });
    let towards = incidence.flatten().filter(|normal| normal.is_finite());
    match towards {
        Some(normal) => frame_of_normal(flight.origin, direction, normal, scene),
        None => frame_of_up(flight.origin, direction, scene),
    }
}

/// The view's up direction: the axis of the world that stands upright in the picture, so that floors lie level in the
/// drawing; the image's own vertical for a camera that is rolled.
pub(in crate::view) fn view_up(camera: &Camera) -> DVec3 {
    let axes = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::NEG_X, DVec3::NEG_Y, DVec3::NEG_Z];
    let upright = axes.into_iter().filter(|axis| axis.dot(camera.right).abs() < 1e-9 && axis.dot(camera.up) > 0.3);
    upright.max_by(|a, b| a.dot(camera.up).total_cmp(&b.dot(camera.up))).unwrap_or(camera.up)
}

/// The plane of the ray and the view's up direction; the ray runs to the right.
fn frame_of_up(origin: DVec3, direction: DVec3, scene: &Scene) -> PlaneView {
    let camera = &scene.camera;
    let up = view_up(camera);
    let level = |v: DVec3| (v - up * v.dot(up)).try_normalize();
    // A ray that runs straight up or down leaves the choice open: the view's own forward direction is as good as any.
    let clear = direction.cross(up).length() > 1e-9;
    let across = clear.then(|| level(direction)).flatten().or_else(|| level(camera.forward)).unwrap_or(camera.right);
    PlaneView { origin, across, up, normal: across.cross(up), scale: 1.0, centre: [0.0, 0.0] }
}

/// The plane with this normal, turned so that the view's up is up and the ray runs to the right.
fn frame_of_normal(origin: DVec3, direction: DVec3, normal: DVec3, scene: &Scene) -> PlaneView {
    let in_plane = |v: DVec3| (v - normal * v.dot(normal)).try_normalize();
    let camera = &scene.camera;
    let upright = view_up(camera);
    let steep = upright.cross(normal).length() > 0.05;
    let up = steep.then(|| in_plane(upright)).flatten().or_else(|| in_plane(camera.forward)).unwrap_or(camera.up);
    let across = up.cross(normal);
    let across = if across.dot(direction) < 0.0 { -across } else { across };
    PlaneView { origin, across, up, normal: across.cross(up), scale: 1.0, centre: [0.0, 0.0] }
}
