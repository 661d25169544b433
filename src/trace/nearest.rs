//! Steps 2 to 4 for a picture: what a ray meets first, without asking for what it would meet later.
//!
//! A recorded ray asks every object that it can meet for all of its intervals, because they are what is shown. A
//! picture needs only the first boundary; so objects are asked in the order in which the ray comes to their boxes, and not
//! at all once a nearer hit is known. Both give the same answer, bit for bit: boxes never lose a hit, and of hits with
//! the same time the object list decides.

use super::calls::Repertoire;
use super::closest::Closest;
use super::departure::Ahead;
use super::ray::{Ray, Tracer};
use super::shadow::Shade;
use crate::csg::{Boundary, Course};
use crate::record::{Recorder, Sense};
use crate::scene::{Candidate, Glance};

impl<E: Repertoire> Tracer<'_, E> {
    /// The closest boundary in front of the ray's start.
    pub(super) fn nearest<R: Recorder>(&self, ray: &Ray, recorder: &mut R) -> Option<Closest> {
        let course = self.course(ray);
        let mut closest: Option<Closest> = None;
        self.for_each_in_the_way(ray, &course, f64::INFINITY, |object, is_met| {
            if let Some((boundary, sense)) = self.first_ahead(object, ray, &course, is_met, recorder)
                && closest.is_none_or(|best| (boundary.t, object) < (best.boundary.t, best.object))
            {
                closest = Some(Closest { object, boundary, sense });
            }
            closest.map_or(f64::INFINITY, |best| best.boundary.t)
        });
        closest.map(|closest| self.first_of_interface(ray, closest))
    }

    /// The share of a light at `limit` that arrives along a shadow ray: nothing behind the first opaque object.
    pub(super) fn let_through<R: Recorder>(&self, ray: &Ray, light: usize, limit: f64, recorder: &mut R) -> f64 {
        let course = self.course(ray);
        let mut shade = Shade::default();
        let mut ask = |object: usize, is_met: bool| {
            if !E::TRANSPARENCY || self.scene.index.opaque[object] {
                shade.is_dark |= self.blocks(object, ray, &course, is_met, limit, recorder);
            } else {
                let ahead = self.ahead_in(object, ray, &course, is_met, recorder);
                shade.add(object, self.passed(ray, object, &ahead, limit, recorder));
            }
            if shade.is_dark { f64::NEG_INFINITY } else { limit }
        };
        match self.sights.and_then(|sights| sights.lights[light].as_ref()?.before(ray.origin, &course)) {
            Some(candidates) => self.for_each_before_the_light(ray, candidates, ask),
            None => self.for_each_in_the_way(ray, &course, limit, &mut ask),
        }
        if E::TRANSPARENCY { shade.share() } else { f64::from(!shade.is_dark) }
    }

    /// Shows the objects that may stand before a light to `ask`, until it returns a time before everything.
    fn for_each_before_the_light<'b>(
        &self,
        ray: &Ray,
        candidates: impl Iterator<Item = &'b Candidate>,
        mut ask: impl FnMut(usize, bool) -> f64,
    ) {
        let departed = ray.departure.map(|departure| departure.object);
        let unbounded = self.scene.index.unbounded.iter().copied();
        let seen = candidates.map(|candidate| (candidate.object, true));
        let others = unbounded.map(|object| (object, false)).chain(seen);
        let others = others.filter(|&(object, _)| departed != Some(object));
        for (object, is_met) in self.returned_to(ray).map(|object| (object, false)).into_iter().chain(others) {
            if ask(object, is_met) == f64::NEG_INFINITY {
                return;
            }
        }
    }

    /// Shows the objects that may be in the way of a ray to `ask`, with whether it is known that the ray meets the object's
    /// box. `ask` returns the time behind which nothing matters any more.
    fn for_each_in_the_way(&self, ray: &Ray, course: &Course, limit: f64, mut ask: impl FnMut(usize, bool) -> f64) {
        let index = &self.scene.index;
        let departed = ray.departure.map(|departure| departure.object);
        let mut limit = limit;
        // The object that the ray starts on comes first: its boundaries may lie at t = 0, before its box begins.
        let others = index.unbounded.iter().copied().filter(|&object| departed != Some(object));
        for object in self.returned_to(ray).into_iter().chain(others) {
            limit = limit.min(ask(object, false));
        }
        let seen_from_the_eye = |candidate: &Candidate, glance: Glance| {
            let is_before = candidate.depth <= limit;
            if is_before && candidate.may_be_met(course, |projection| projection.holds_glance(glance)) {
                limit = limit.min(ask(candidate.object, true));
            }
            is_before
        };
        if self.ask_what_is_seen(ray, seen_from_the_eye) {
        } else if self.scene.shortcuts.hierarchy {
            index.hierarchy.walk(course, limit, |item, limit| {
                let object = index.bounded[item];
                if departed == Some(object) { limit } else { limit.min(ask(object, true)) }
            });
        } else {
            let is_asked = |object: &usize| departed != Some(*object) && self.is_projected(ray, *object);
            index.bounded.iter().copied().filter(is_asked).for_each(|object| {
                ask(object, false);
            });
        }
    }

    /// The object that the ray starts on, unless it leaves it for good.
    #[inline(always)]
    fn returned_to(&self, ray: &Ray) -> Option<usize> {
        let object = ray.departure?.object;
        (!ray.leaves_for_good(object, &self.scene.objects[object].solid)).then_some(object)
    }

    /// Shows the objects that a ray from the eye may meet to `ask`, the nearest first, for as long as it wants to see more.
    /// Along such a ray t is the depth. Returns whether it is known what the ray may meet.
    #[inline(always)]
    fn ask_what_is_seen(&self, ray: &Ray, mut ask: impl FnMut(&Candidate, Glance) -> bool) -> bool {
        let (Some(sights), Some(glance)) = (self.sights, ray.place) else { return false };
        let Some(mut candidates) = sights.eye.around(glance.place) else { return false };
        // It ends with the first one that `ask` has seen enough with.
        candidates.all(|candidate| ask(candidate, glance));
        true
    }

    /// Whether the object may be seen in the direction of a ray from the eye.
    fn is_projected(&self, ray: &Ray, object: usize) -> bool {
        !self.scene.shortcuts.projections
            || ray.place.is_none_or(|glance| self.scene.index.projections[object].holds_glance(glance))
    }

    /// The object's first boundary that counts.
    fn first_ahead<R: Recorder>(
        &self,
        object: usize,
        ray: &Ray,
        course: &Course,
        is_met: bool,
        recorder: &mut R,
    ) -> Option<(Boundary, Sense)> {
        if self.starts_at(ray, object) {
            self.ahead_in(object, ray, course, is_met, recorder).list.first()
        } else {
            self.scene.objects[object].solid.first_in_front(course, is_met, recorder)
        }
    }

    /// Whether an opaque object is in the way of a shadow ray.
    fn blocks<R: Recorder>(
        &self,
        object: usize,
        ray: &Ray,
        course: &Course,
        is_met: bool,
        limit: f64,
        recorder: &mut R,
    ) -> bool {
        let departed = ray.departure.is_some_and(|departure| departure.object == object);
        let solid = &self.scene.objects[object].solid;
        if departed || !solid.extent().is_finite() {
            return self.ahead_in(object, ray, course, is_met, recorder).surfaces(limit).next().is_some();
        }
        // A ray that comes out of an object which it did not enter started inside it.
        let first = solid.first_in_front(course, is_met, recorder);
        first.is_some_and(|(boundary, sense)| sense == Sense::Leave || boundary.t < limit)
    }

    /// All boundaries of an object that count for a ray.
    fn ahead_in<R: Recorder>(
        &self,
        object: usize,
        ray: &Ray,
        course: &Course,
        is_met: bool,
        recorder: &mut R,
    ) -> Ahead {
        let list = self.scene.objects[object].solid.inside_as_asked(course, is_met, recorder);
        self.ahead(ray, object, &list)
    }
}
