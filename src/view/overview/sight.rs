//! From where the overview looks, and how points of the world come onto it.

use super::OverviewOptions;
use crate::csg::Extent;
use crate::math::portable;
use crate::scene::Scene;
use crate::view::drawing::{Frame, Spot};
use crate::view::side_view::view_up;
use crate::view::wireframe::Wireframe;
use glam::DVec3;

/// Where one stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stand {
    /// On an orbit about the scene's middle.
    Orbit {
        /// Radians about the world's upright axis, from behind the camera to its right.
        yaw: f64,
        /// Radians above the level.
        pitch: f64,
    },
    /// At the scene's own eye, with its own view.
    Camera,
}

impl Default for Stand {
    fn default() -> Self {
        Self::Orbit { yaw: 0.7, pitch: 0.4 }
    }
}

/// A view of space: an eye with a frame of unit vectors, and its scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight {
    /// Where the eye is. In a view along parallel lines it lies in the plane of the middle.
    pub eye: DVec3,
    /// To the right.
    pub right: DVec3,
    /// To the top.
    pub up: DVec3,
    /// Into the drawing.
    pub forward: DVec3,
    /// Points for a unit at distance 1, or at every distance in a view along parallel lines.
    pub scale: f64,
    /// The place of what lies straight ahead.
    pub centre: Spot,
    /// Whether what is farther away is smaller.
    pub is_perspective: bool,
}

/// Nearer things are cut off: in units of the world.
const NEAR: f64 = 1e-6;

impl Sight {
    /// The view of a scene from a stand, such that all of it is seen at zoom 1.
    pub(super) fn of(scene: &Scene, wires: &Wireframe, options: &OverviewOptions, frame: &Frame) -> Self {
        let zoom = if options.zoom.is_finite() { options.zoom.clamp(1e-3, 1e4) } else { 1.0 };
        let pan = options.pan.map(|x| if x.is_finite() { x } else { 0.0 });
        let middle = frame.middle();
        let centre = std::array::from_fn(|i| middle[i] + pan[i]);
        let room = frame.size().map(|points| points.max(8.0));
        match options.stand {
            Stand::Camera => Self::through(scene, room, zoom, centre),
            Stand::Orbit { yaw, pitch } => {
                let (target, radius) = content(scene, wires);
                let [right, up, forward] = orbit_frame(scene, yaw, pitch);
                let distance = DISTANCE * radius;
                let is_perspective = options.is_perspective;
                let eye = if is_perspective { target - forward * distance } else { target };
                let unit = Self { eye, right, up, forward, scale: 1.0, centre: [0.0; 2], is_perspective };
                let usual = 0.5 * room[0].min(room[1]) / radius * if is_perspective { distance } else { 1.0 };
                // An eye far off is no part of what is seen.
                let own_eye = Some(scene.camera.eye).filter(|eye| eye.distance(target) < 1.01 * radius);
                let points = wires.lines.iter().flat_map(|line| &line.points).copied().chain(own_eye);
                // Without numbers, as of a scene whose size overflows, there is nothing to see, but nothing to stop for either.
                let scale = unit.fitting(points, room).max(LEAST * usual).min(MOST * usual) * zoom;
                Self { eye, right, up, forward, scale, centre, is_perspective }
            }
        }
    }

    /// What the scene's own camera sees: the whole picture at zoom 1.
    fn through(scene: &Scene, room: Spot, zoom: f64, centre: Spot) -> Self {
        let camera = &scene.camera;
        let (half_width, half_height) = camera.half_size(scene.image);
        let scale = (0.5 * room[0] / half_width).min(0.5 * room[1] / half_height) * zoom;
        let (eye, right, up, forward) = (camera.eye, camera.right, camera.up, camera.forward);
        Self { eye, right, up, forward, scale, centre, is_perspective: true }
    }

    /// The largest scale at which all points lie within the room, of a view whose own scale is 1 and whose centre is 0.
    fn fitting(&self, points: impl Iterator<Item = DVec3>, room: Spot) -> f64 {
        let spots = points.filter_map(|point| self.place(point));
        let reach = spots.fold([1e-12_f64; 2], |reach, spot| std::array::from_fn(|i| reach[i].max(spot[i].abs())));
        (0.5 * room[0] / reach[0]).min(0.5 * room[1] / reach[1])
    }

    /// How far a point lies into the drawing.
    fn depth(&self, point: DVec3) -> f64 {
        (point - self.eye).dot(self.forward)
    }

    /// The place of a point; none for what lies behind the eye.
    #[must_use]
    pub fn place(&self, point: DVec3) -> Option<Spot> {
        let from_eye = point - self.eye;
        let depth = self.depth(point);
        if self.is_perspective && depth < NEAR {
            return None;
        }
        let scale = if self.is_perspective { self.scale / depth } else { self.scale };
        let spot = [self.centre[0] + scale * from_eye.dot(self.right), self.centre[1] - scale * from_eye.dot(self.up)];
        spot.iter().all(|x| x.is_finite()).then_some(spot)
    }

    /// The places of both ends of the part of a line that lies before the eye.
    #[must_use]
    pub fn line(&self, [from, to]: [DVec3; 2]) -> Option<[Spot; 2]> {
        if !self.is_perspective {
            return Some([self.place(from)?, self.place(to)?]);
        }
        let (near, far) = (self.depth(from), self.depth(to));
        let least = 2.0 * NEAR;
        let cut = |a: DVec3, b: DVec3, depth_a: f64, depth_b: f64| {
            if depth_a >= least { a } else { a.lerp(b, (least - depth_a) / (depth_b - depth_a)) }
        };
        if near < least && far < least {
            return None;
        }
        Some([self.place(cut(from, to, near, far))?, self.place(cut(to, from, far, near))?])
    }

    /// Whether a surface with this normal turns its outer side to the reader.
    #[must_use]
    pub fn faces(&self, point: DVec3, normal: DVec3) -> bool {
        let towards = if self.is_perspective { self.eye - point } else { -self.forward };
        normal.dot(towards) >= 0.0
    }
}

/// The scene's eye is left out when it is farther from the objects than this many times their size: they would be a speck.
const FAR_EYE: f64 = 4.0;

/// How much smaller or larger the scene is drawn than the ball around what has bounds would allow. Smaller, a wide floor would
/// leave little of what stands on it; larger, what lies near the eye would look drawn out.
const LEAST: f64 = 0.5;
const MOST: f64 = 1.9;

/// How far the eye of an orbit is away, in radii of what is seen. Nearer, things at the rim look drawn out.
const DISTANCE: f64 = 3.2;

/// Right, up and forward of an orbit.
fn orbit_frame(scene: &Scene, yaw: f64, pitch: f64) -> [DVec3; 3] {
    let camera = &scene.camera;
    let axis = view_up(camera);
    let level = (camera.forward - axis * camera.forward.dot(axis)).try_normalize();
    let ahead = level.unwrap_or_else(|| axis.any_orthonormal_vector());
    let aside = ahead.cross(axis);
    let (sin, cos) = if yaw.is_finite() { portable::sin_cos(yaw) } else { (0.0, 1.0) };
    // From straight above or below, what is up in the drawing would be left open.
    let pitch = if pitch.is_finite() { pitch.clamp(-1.55, 1.55) } else { 0.0 };
    let (rise, flat) = portable::sin_cos(pitch);
    let heading = ahead * cos - aside * sin;
    let forward = heading * flat - axis * rise;
    let right = forward.cross(axis).normalize();
    [right, right.cross(forward), forward]
}

/// The middle and the radius of what is seen: the objects that have bounds, and the eye where it is not far off.
fn content(scene: &Scene, wires: &Wireframe) -> (DVec3, f64) {
    let extents = scene.objects.iter().map(|object| object.solid.extent()).filter(Extent::is_finite);
    let bounded = extents.map(|extent| [extent.low, extent.high]);
    let all = bounded.reduce(|[low, high], other| [low.min(other[0]), high.max(other[1])]);
    let [mut low, mut high] = all.unwrap_or(wires.bounds);
    let size = (high - low).length().max(1e-9);
    let (middle, eye) = ((low + high) * 0.5, scene.camera.eye);
    if eye.distance(middle) < FAR_EYE * size {
        (low, high) = (low.min(eye), high.max(eye));
    }
    ((low + high) * 0.5, (0.5 * (high - low).length()).max(1e-9))
}
