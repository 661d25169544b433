//! Steps 2 to 4 of § 6.1: all intersections, the closest one in front, and the hit point.

use super::departure::Ahead;
use super::ray::{Ray, Tracer};
use crate::csg::{Boundary, IntervalList, Leaf};
use crate::record::{Entry, Recorder, Sense, Value, What};
use crate::scene::{Material, Object};
use crate::shape::Primitive;
use glam::DVec3;

/// The inside intervals of one object that the ray meets.
pub struct Found {
    /// The object, by its place in the list.
    pub object: usize,
    /// Its intervals for all real t.
    pub list: IntervalList,
    /// Its boundaries that count.
    pub ahead: Ahead,
}

/// The closest boundary in front.
#[derive(Clone, Copy, Debug)]
pub struct Closest {
    /// The object, by its place in the list.
    pub object: usize,
    /// The boundary.
    pub boundary: Boundary,
    /// What it does to the ray.
    pub sense: Sense,
}

/// The place that is seen.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// The object, by its place in the list.
    pub object: usize,
    /// The boundary.
    pub boundary: Boundary,
    /// What it does to the ray.
    pub sense: Sense,
    /// The point in world space.
    pub point: DVec3,
    /// The outward unit normal.
    pub n_geometric: DVec3,
    /// The unit normal on the side that the ray came from.
    pub n_shading: DVec3,
}

impl Tracer<'_> {
    /// The object's leaf that a boundary lies on.
    #[must_use]
    pub fn leaf(&self, object: usize, boundary: &Boundary) -> &Leaf {
        &self.scene.objects[object].solid.leaves[boundary.leaf]
    }

    /// The material of the surface that a boundary lies on.
    #[must_use]
    pub fn material(&self, surface: &Surface) -> &Material {
        let object = &self.scene.objects[surface.object];
        &self.scene.materials[object.leaf_materials[surface.boundary.leaf]]
    }

    /// Step 2: the intersections of the ray with one object after the other. Objects that are missed are left out.
    pub(super) fn find_all_intersections(&self, ray: &Ray, recorder: &mut impl Recorder) -> Vec<Found> {
        let mut found = Vec::new();
        for (index, object) in self.scene.objects.iter().enumerate() {
            let list = intersect(index, object, ray, recorder);
            let ahead = ray.ahead(index, object, &list);
            ahead.report(object, recorder);
            if !list.is_empty() || !ahead.boundaries.is_empty() {
                found.push(Found { object: index, list, ahead });
            }
        }
        found
    }

    /// Step 3: the boundary that lies closest to and in front of the ray's start; the object list decides ties.
    pub(super) fn find_closest_in_front<R: Recorder>(&self, found: &[Found], recorder: &mut R) -> Option<Closest> {
        let mut closest: Option<Closest> = None;
        for candidate in found {
            if let Some(&(boundary, sense)) = candidate.ahead.boundaries.first()
                && closest.is_none_or(|best| boundary.t < best.boundary.t)
            {
                closest = Some(Closest { object: candidate.object, boundary, sense });
            }
        }
        if R::RECORDING {
            self.report_rejected(found, closest, recorder);
        }
        closest
    }

    fn report_rejected(&self, found: &[Found], closest: Option<Closest>, recorder: &mut impl Recorder) {
        for candidate in found {
            for (boundary, _) in candidate.list.boundaries() {
                let is_closest = closest.is_some_and(|c| c.object == candidate.object && c.boundary == boundary);
                if !is_closest {
                    let reason = why_rejected(&boundary, candidate, closest);
                    recorder.note(|| self.rejection(candidate.object, &boundary, reason));
                }
            }
        }
    }

    fn rejection(&self, object: usize, boundary: &Boundary, reason: &str) -> Entry {
        let leaf = self.leaf(object, boundary);
        Entry::new(What::Rejected {
            object: self.scene.objects[object].name.clone(),
            leaf: leaf.name.clone(),
            part: leaf.part(boundary).to_owned(),
            t: boundary.t,
            reason: reason.to_owned(),
        })
    }

    /// Step 4: the hit point and its normals.
    pub(super) fn compute_hit_point(&self, ray: &Ray, closest: &Closest, recorder: &mut impl Recorder) -> Surface {
        let Closest { object, boundary, sense } = *closest;
        let point = ray.origin + ray.direction * boundary.t;
        let n_geometric = self.scene.objects[object].solid.normal(&boundary, point);
        let n_shading = if n_geometric.dot(ray.direction) > 0.0 { -n_geometric } else { n_geometric };
        let surface = Surface { object, boundary, sense, point, n_geometric, n_shading };
        recorder.note(|| self.describe_hit(ray, &surface));
        surface
    }

    fn describe_hit(&self, ray: &Ray, surface: &Surface) -> Entry {
        let leaf = self.leaf(surface.object, &surface.boundary);
        let generic_point = leaf.placement.generic_from_world.transform_point3(surface.point);
        let uv = leaf.shape.uv(generic_point, surface.boundary.part);
        Entry::new(What::Hit {
            object: self.scene.objects[surface.object].name.clone(),
            leaf: leaf.name.clone(),
            shape: leaf.shape.name().to_owned(),
            part: leaf.part(&surface.boundary).to_owned(),
            material: self.material(surface).name.clone(),
            t: surface.boundary.t,
            t_error: surface.boundary.error,
            certificate: surface.boundary.certificate,
            sense: surface.sense,
            point: surface.point.to_array(),
            generic_point: generic_point.to_array(),
            n_geometric: surface.n_geometric.to_array(),
            n_shading: surface.n_shading.to_array(),
            uv: uv.to_array(),
        })
        .line(
            "P",
            "origin + direction t",
            &[
                ("origin", Value::from(ray.origin.to_array())),
                ("direction", ray.direction.to_array().into()),
                ("t", surface.boundary.t.into()),
            ],
            surface.point.to_array(),
        )
    }
}

/// The ray's inside intervals in one object.
pub(super) fn intersect(index: usize, object: &Object, ray: &Ray, recorder: &mut impl Recorder) -> IntervalList {
    recorder.begin();
    let list = object.solid.inside::<f64>(ray.origin, ray.direction, recorder);
    recorder.end(|| Entry::new(What::Object { index, name: object.name.clone(), intervals: list.intervals.len() }));
    list
}

/// Why a boundary is not the one that is seen.
fn why_rejected(boundary: &Boundary, candidate: &Found, closest: Option<Closest>) -> &'static str {
    if Some(*boundary) == candidate.ahead.departed {
        "this is the surface that the ray started on"
    } else if !candidate.ahead.holds(boundary) {
        "behind the start of the ray: t is not positive"
    } else if closest.is_some_and(|c| c.object == candidate.object) {
        "later on the ray than the hit with the same object"
    } else {
        "later on the ray than the closest hit"
    }
}
