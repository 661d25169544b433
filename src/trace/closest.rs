//! Steps 2 to 4 of § 6.1: all intersections, the closest one in front, and the hit point.

use super::calls::Repertoire;
use super::departure::Ahead;
use super::ray::{Ray, Tracer};
use crate::csg::{Boundary, Course, Extent, IntervalList, Leaf};
use crate::record::{Effect, Entry, Recorder, Sense, Value, What};
use crate::scene::{Detail, Glance, Material, Projection};
use crate::shape::Primitive;
use glam::{DVec2, DVec3};

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
    /// The material: an index into the scene's.
    pub material: usize,
    /// The point in world space.
    pub point: DVec3,
    /// The outward unit normal.
    pub n_geometric: DVec3,
    /// The unit normal on the side that the ray came from.
    pub n_shading: DVec3,
}

impl Surface {
    /// The geometric normal on the side that shading looks at.
    #[must_use]
    pub fn facing(&self) -> DVec3 {
        if self.n_geometric.dot(self.n_shading) < 0.0 { -self.n_geometric } else { self.n_geometric }
    }

    /// A direction away from the surface. A normal that was turned may mirror a ray into the surface; it is turned back.
    #[must_use]
    pub(super) fn kept_outside(&self, direction: DVec3) -> DVec3 {
        self.on_its_side(direction, self.facing())
    }

    /// A direction into the surface, likewise.
    #[must_use]
    pub(super) fn kept_inside(&self, direction: DVec3) -> DVec3 {
        self.on_its_side(direction, -self.facing())
    }

    /// The direction, mirrored at the surface where a turned normal has sent it to the side that `side` does not point to.
    fn on_its_side(&self, direction: DVec3, side: DVec3) -> DVec3 {
        let beyond = direction.dot(side);
        if beyond < 0.0 && self.n_shading != self.facing() { direction - side * (2.0 * beyond) } else { direction }
    }
}

impl<E: Repertoire> Tracer<'_, E> {
    /// The object's leaf that a boundary lies on.
    #[must_use]
    pub fn leaf(&self, object: usize, boundary: &Boundary) -> &Leaf {
        &self.scene.objects[object].solid.leaves[boundary.leaf]
    }

    /// The material of the surface.
    #[must_use]
    pub fn material(&self, surface: &Surface) -> &Material {
        &self.scene.materials[surface.material]
    }

    /// Step 2: the intersections of the ray with one object after the other. Objects that are missed are left out.
    pub(super) fn find_all_intersections(&self, ray: &Ray, recorder: &mut impl Recorder) -> Vec<Found> {
        let course = self.course(ray);
        let mut found = Vec::new();
        for index in self.reached(&course, recorder) {
            let list = self.intersect(index, ray, &course, recorder);
            let ahead = self.ahead(ray, index, &list);
            ahead.report(&self.scene.objects[index], recorder);
            if !list.is_empty() || !ahead.list.is_empty() {
                found.push(Found { object: index, list, ahead });
            }
        }
        found
    }

    /// The objects that the whole line can meet, in the order of the list.
    pub(super) fn reached(&self, course: &Course, recorder: &mut impl Recorder) -> Vec<usize> {
        let index = &self.scene.index;
        if !self.scene.shortcuts.hierarchy {
            return (0..self.scene.objects.len()).collect();
        }
        let items = index.hierarchy.reached(course, |extent, inside, count| {
            recorder.note(|| group(extent, inside, count));
        });
        let mut objects: Vec<_> =
            items.into_iter().map(|item| index.bounded[item]).chain(index.unbounded.clone()).collect();
        objects.sort_unstable();
        objects
    }

    /// The ray's inside intervals in one object.
    pub(super) fn intersect(
        &self,
        index: usize,
        ray: &Ray,
        course: &Course,
        recorder: &mut impl Recorder,
    ) -> IntervalList {
        let object = &self.scene.objects[index];
        recorder.begin();
        let list = if self.is_in_sight(index, ray, recorder) {
            object.solid.inside_as_asked(course, false, recorder)
        } else {
            IntervalList::default()
        };
        recorder
            .end(|| Entry::new(What::Object { index, name: object.name.clone(), intervals: list.intervals().len() }));
        list
    }

    /// Whether a ray from the eye may see the object, by its rectangle in the picture.
    fn is_in_sight(&self, index: usize, ray: &Ray, recorder: &mut impl Recorder) -> bool {
        let projection = &self.scene.index.projections[index];
        let Some(glance) =
            ray.place.filter(|_| self.scene.shortcuts.projections && *projection != Projection::EVERYWHERE)
        else {
            return true;
        };
        let holds = projection.holds_glance(glance);
        recorder.note(|| self.describe_projection(index, glance, holds));
        holds
    }

    fn describe_projection(&self, index: usize, glance: Glance, holds: bool) -> Entry {
        let (camera, image) = (&self.scene.camera, self.scene.image);
        let projection = self.scene.index.projections[index].slid(glance.on_lens.unwrap_or_default());
        let [left, bottom] = camera.pixel_at(image, projection.low.to_array());
        let [right, top] = camera.pixel_at(image, projection.high.to_array());
        Entry::new(What::Projection {
            of: self.scene.objects[index].name.clone(),
            low: [left, top],
            high: [right, bottom],
            at: camera.pixel_at(image, glance.place),
            holds,
        })
    }

    /// Step 3: the boundary that lies closest to and in front of the ray's start; the object list decides ties.
    pub(super) fn find_closest_in_front<R: Recorder>(
        &self,
        ray: &Ray,
        found: &[Found],
        recorder: &mut R,
    ) -> Option<Closest> {
        let mut closest: Option<Closest> = None;
        for candidate in found {
            if let Some((boundary, sense)) = candidate.ahead.list.first()
                && closest.is_none_or(|best| boundary.t < best.boundary.t)
            {
                closest = Some(Closest { object: candidate.object, boundary, sense });
            }
        }
        let closest = closest.map(|closest| self.first_of_interface(ray, closest));
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
        let (material, detail) = self.material_at(object, &boundary, point);
        let surface = Surface { object, boundary, sense, material, point, n_geometric, n_shading };
        recorder.note(|| self.describe_hit(ray, &surface));
        if self.calls_for(Effect::DepthOfField) {
            self.note_confusion(ray, &surface, recorder);
        }
        if let Some((detail, place)) = detail {
            Self::enter(Effect::Details, recorder);
            recorder.note(|| self.describe_detail(&surface, detail, place));
        }
        surface
    }

    fn describe_detail(&self, surface: &Surface, detail: &Detail, place: DVec2) -> Entry {
        let object = &self.scene.objects[surface.object];
        let below = object.leaf_materials[surface.boundary.leaf];
        Entry::new(What::Detail(crate::record::Detail {
            part: self.leaf(surface.object, &surface.boundary).part(&surface.boundary).to_owned(),
            uv: place.to_array(),
            polygon: detail.polygon.iter().map(DVec2::to_array).collect(),
            below: self.scene.materials[below].name.clone(),
            material: self.material(surface).name.clone(),
        }))
    }

    fn describe_hit(&self, ray: &Ray, surface: &Surface) -> Entry {
        let leaf = self.leaf(surface.object, &surface.boundary);
        let generic_point = leaf.placement.generic_from_world().transform_point3(surface.point);
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

/// The test against the box of several objects.
fn group(extent: &Extent, inside: Option<[f64; 2]>, count: usize) -> Entry {
    let (low, high) = (extent.low.to_array(), extent.high.to_array());
    Entry::new(What::Extent { of: format!("{count} objects"), low, high, inside })
}

/// Why a boundary is not the one that is seen.
fn why_rejected(boundary: &Boundary, candidate: &Found, closest: Option<Closest>) -> &'static str {
    if Some(*boundary) == candidate.ahead.departed {
        "this is the surface that the ray started on"
    } else if !candidate.ahead.list.crossed().contains(boundary) {
        "behind the start of the ray: t is not positive"
    } else if closest.is_some_and(|c| c.object != candidate.object && boundary.t < c.boundary.t) {
        "in the same place as the closest hit, within rounding: both are crossed as one"
    } else if closest.is_some_and(|c| c.object == candidate.object) {
        "later on the ray than the hit with the same object"
    } else {
        "later on the ray than the closest hit"
    }
}
