//! One ray at a time, for those who watch how rays leave surfaces: the tracer's own steps, without colours.

use super::calls::Repertoire;
use super::closest::Surface;
use super::departure::Departure;
use super::ray::{Ray, Tracer};
use crate::csg::Boundary;
use crate::record::{NullRecorder, RayKind, Sense};
use glam::DVec3;

impl<E: Repertoire> Tracer<'_, E> {
    /// The surface that a ray meets first, as steps 2 to 4 find it.
    #[must_use]
    pub fn first_surface(&self, ray: &Ray) -> Option<Surface> {
        let found = self.find_all_intersections(ray, &mut NullRecorder);
        let closest = self.find_closest_in_front(ray, &found, &mut NullRecorder)?;
        Some(self.compute_hit_point(ray, &closest, &mut NullRecorder))
    }

    /// The ray that leaves `surface`, which `ray` met, in another direction.
    #[must_use]
    pub fn leaving(&self, ray: &Ray, surface: &Surface, direction: DVec3) -> Ray {
        Ray {
            kind: RayKind::Reflected,
            origin: surface.point,
            direction,
            depth: ray.depth + 1,
            departure: Some(Departure::new(surface, ray.direction, direction)),
            place: None,
            ..ray.clone()
        }
    }

    /// Every boundary of an object that counts for a ray, ascending: in front, and not the one that it started on.
    #[must_use]
    pub fn boundaries_ahead(&self, ray: &Ray, object: usize) -> Vec<(Boundary, Sense)> {
        let found = self.find_all_intersections(ray, &mut NullRecorder);
        found.iter().filter(|found| found.object == object).flat_map(|found| found.ahead.list.boundaries()).collect()
    }
}
