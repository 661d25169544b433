//! The rays through a pixel's four corners, which go where the pixel's own ray goes: what lies between them is the pixel's
//! footprint on a surface, or on the environment.
//!
//! A corner ray is not traced through the scene. It is taken to the same part of the same primitive that the pixel's ray
//! hit, mirrored or bent there by the surface's own normal, and so on. Where it misses that part, it is taken to the plane
//! that touches the surface at the pixel's hit.
//!
//! Source: the four corners of Catmull's pixel (E. Catmull, A Subdivision Algorithm for Computer Display of Curved Surfaces,
//! 1974, § 5), carried along as in H. Igehy, Tracing Ray Differentials (SIGGRAPH 1999), but by whole rays and not by their
//! derivatives, so that footprints on flat surfaces and in flat mirrors are exact.

use super::calls::Repertoire;
use super::closest::Surface;
use super::ray::{Ray, Tracer};
use crate::optics::{reflect, refract};
use crate::record::NullRecorder;
use crate::scene::{Camera, Image};
use crate::shape::{Crossings, Primitive};
use glam::DVec3;

/// The rays through a pixel's corners: origin and direction of each, in their order about the pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Beam {
    pub(super) corners: [[DVec3; 2]; 4],
}

/// Where a corner ray meets the surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    /// The point in world space.
    pub point: DVec3,
    /// The ray's direction.
    pub direction: DVec3,
    /// The unit normal on the side that the ray comes from.
    pub normal: DVec3,
    /// Whether the point lies on the part of the surface that was hit, and not only on the plane that touches it.
    pub on_surface: bool,
}

/// What became of the four.
pub(super) type Corners = Box<[Corner; 4]>;

impl Beam {
    /// The beam from the eye through pixel (x, y).
    #[must_use]
    pub fn through_pixel(camera: &Camera, image: Image, x: u32, y: u32) -> Self {
        let [left, top] = [x, y].map(f64::from);
        Self::through_square(camera, image, [left, top], 1.0)
    }

    /// The beam from the eye through a square of the picture, by its top left corner and its side in pixels.
    #[must_use]
    pub fn through_square(camera: &Camera, image: Image, [left, top]: [f64; 2], side: f64) -> Self {
        let [right, bottom] = [left + side, top + side];
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        Self { corners: corners.map(|[x, y]| [camera.eye, camera.ray_direction(image, x, y)]) }
    }

    /// The beam with all of its rays changed.
    #[must_use]
    pub(super) fn map(self, change: impl Fn([DVec3; 2]) -> [DVec3; 2]) -> Self {
        Self { corners: self.corners.map(change) }
    }

    /// The directions alone.
    #[must_use]
    pub fn directions(&self) -> [DVec3; 4] {
        self.corners.map(|[_, direction]| direction)
    }

    /// The beam mirrored where its corners meet a surface.
    pub(super) fn mirrored(corners: &[Corner; 4], surface: &Surface) -> Box<Self> {
        Box::new(Self { corners: corners.map(|c| [c.point, reflect(c.direction, c.shading_normal(surface))]) })
    }

    /// The beam bent where its corners meet a surface between media of indices n1 and n2. A corner that would be reflected
    /// as a whole goes beside the pixel's own ray, as it came.
    pub(super) fn bent(
        corners: &[Corner; 4],
        surface: &Surface,
        [incoming, outgoing]: [DVec3; 2],
        [n1, n2]: [f64; 2],
    ) -> Box<Self> {
        let beside = |c: &Corner| outgoing + c.direction.normalize() - incoming.normalize();
        let bend = |c: Corner| refract(c.direction, c.shading_normal(surface), n1, n2).refracted.unwrap_or(beside(&c));
        Box::new(Self { corners: corners.map(|c| [c.point, bend(c)]) })
    }

    /// The beam that goes on as it came.
    pub(super) fn straight_on(corners: &[Corner; 4]) -> Box<Self> {
        Box::new(Self { corners: corners.map(|c| [c.point, c.direction]) })
    }
}

impl Corner {
    /// The normal here, turned as the pixel's own ray finds it turned.
    fn shading_normal(&self, surface: &Surface) -> DVec3 {
        (self.normal + surface.n_shading - surface.facing()).normalize_or(surface.n_shading)
    }
}

impl<E: Repertoire> Tracer<'_, E> {
    /// Where the corners of a ray's pixel meet the surface that the ray met; none for rays without a beam.
    pub(super) fn corners(&self, ray: &Ray, surface: &Surface) -> Option<Corners> {
        let beam = ray.beam.as_ref()?;
        let corner = |line: [DVec3; 2]| self.on_surface(line, surface).unwrap_or_else(|| touching(line, ray, surface));
        Some(Box::new(beam.corners.map(corner)))
    }

    /// Where a corner ray meets the part of the primitive that was hit, on the side from which it was hit.
    fn on_surface(&self, [origin, direction]: [DVec3; 2], surface: &Surface) -> Option<Corner> {
        let leaf = self.leaf(surface.object, &surface.boundary);
        let (line, part, facing) = ([origin, direction], surface.boundary.part, surface.facing());
        let mut crossings = Crossings::new();
        leaf.shape.crossings(&leaf.placement.generic_ray::<f64>(&line), &mut NullRecorder, &mut crossings);
        let corner = |t: f64| {
            let point = origin + direction * t;
            let normal = leaf.placement.world_normal(leaf.shape.normal(leaf.placement.generic_point(point), part));
            let normal = if normal.dot(facing) < 0.0 { -normal } else { normal };
            Corner { point, direction, normal, on_surface: true }
        };
        let ahead = crossings.into_iter().filter(|crossing| crossing.t > 0.0 && crossing.part == part);
        let corners = ahead.map(|crossing| corner(crossing.t)).filter(|corner| corner.normal.dot(direction) < 0.0);
        corners
            .min_by(|a, b| a.point.distance_squared(surface.point).total_cmp(&b.point.distance_squared(surface.point)))
    }
}

/// Where a corner ray meets the plane that touches the surface. One that runs beside the plane or away from it is drawn in
/// towards the pixel's own ray until it does not.
fn touching([origin, direction]: [DVec3; 2], ray: &Ray, surface: &Surface) -> Corner {
    let normal = surface.facing();
    let from_middle = [origin - ray.origin, direction - ray.direction];
    let meeting = |share: f64| {
        let (origin, direction) = (ray.origin + from_middle[0] * share, ray.direction + from_middle[1] * share);
        let t = normal.dot(surface.point - origin) / normal.dot(direction);
        (t > 0.0 && t.is_finite()).then(|| origin + direction * t)
    };
    let mut shares = std::iter::successors(Some(1.0), |share| Some(0.5 * share)).take(16);
    let point = shares.find_map(meeting).unwrap_or(surface.point);
    Corner { point, direction, normal, on_surface: false }
}
