//! Which medium a ray travels in, and what a boundary changes about it (§ 6.4.1, design policies 1 and 2).

use super::calls::Repertoire;
use super::closest::{Closest, Surface};
use super::departure::{blur, widest_blur};
use super::ray::{Ray, Tracer};
use crate::optics::{MediaStack, Policy};
use crate::record::{Entry, Recorder, Sense, What};
use crate::scene::MediaPolicy;
use glam::DVec3;
use smallvec::SmallVec;

/// Transparent objects that have a boundary in the same place, with their boundaries.
type Shared = SmallVec<[Closest; 2]>;

/// The media on the two sides of a boundary.
#[derive(Clone, Debug)]
pub(super) struct MediaCrossing {
    /// The object that the ray travels in before the boundary; none in air.
    pub before: Option<usize>,
    /// The object that it would travel in behind the boundary.
    pub after: Option<usize>,
    /// What it would be inside of behind the boundary, where that is not what it was inside of before.
    changed: Option<MediaStack>,
    /// The boundary lies inside a medium that wins over it: the ray passes as if it were not there.
    pub hidden: bool,
}

impl MediaCrossing {
    /// What the ray would be inside of behind the boundary.
    pub fn media_after(&self, ray: &Ray) -> MediaStack {
        self.changed.as_ref().unwrap_or(&ray.media).clone()
    }
}

impl<E: Repertoire> Tracer<'_, E> {
    /// The transparent objects that the eye is inside, in the order in which a ray from far behind it entered them.
    pub(super) fn media_around(&self, eye: DVec3, direction: DVec3) -> MediaStack {
        if !E::TRANSPARENCY {
            return MediaStack::default();
        }
        let index = &self.scene.index;
        let is_eye = eye.distance(self.scene.camera.eye) <= index.eye_reach;
        let candidates = if is_eye { &index.around_the_eye } else { &index.transparent };
        if candidates.is_empty() {
            return MediaStack::default();
        }
        let holding_eye = |&object: &usize| {
            let list = self.scene.objects[object].solid.inside_by(self.scene.solving, eye, direction);
            let interval = list.intervals().find(|interval| {
                interval.enter.is_none_or(|enter| enter.t <= 0.0) && interval.leave.is_none_or(|leave| leave.t > 0.0)
            })?;
            Some((interval.enter.map_or(f64::NEG_INFINITY, |enter| enter.t), object))
        };
        let mut around: Vec<(f64, usize)> = candidates.iter().filter_map(holding_eye).collect();
        around.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut media = MediaStack::default();
        for (_, object) in around {
            media.enter(object);
        }
        media
    }

    /// The media before and behind the surface, by the scene's policy.
    pub(super) fn cross_media(&self, ray: &Ray, surface: &Surface, recorder: &mut impl Recorder) -> MediaCrossing {
        if !E::TRANSPARENCY {
            return MediaCrossing { before: None, after: None, changed: None, hidden: false };
        }
        let before = self.current_medium(&ray.media);
        let bounds_a_medium = self.is_transparent(surface.object) && surface.sense != Sense::Touch;
        if !bounds_a_medium {
            return MediaCrossing { before, after: before, changed: None, hidden: false };
        }
        let mut media_after = ray.media.clone();
        // What is left is left before anything is entered: the water that fills a glass begins where the glass ends.
        let own = Closest { object: surface.object, boundary: surface.boundary, sense: surface.sense };
        let mut crossed = self.sharing(ray, &own);
        crossed.push(own);
        crossed.sort_by_key(|closest| (closest.sense == Sense::Enter, closest.object));
        for closest in &crossed {
            match closest.sense {
                Sense::Enter => media_after.enter(closest.object),
                Sense::Leave | Sense::Touch => media_after.leave(closest.object),
            }
        }
        let after = self.current_medium(&media_after);
        let crossing = MediaCrossing { before, after, changed: Some(media_after), hidden: before == after };
        recorder.note(|| self.describe_crossing(ray, &crossed, &crossing));
        crossing
    }

    /// Of transparent objects that have a boundary in the place of the closest hit, the boundary of the first in the object
    /// list: rounding must not decide which of them is seen.
    pub(super) fn first_of_interface(&self, ray: &Ray, closest: Closest) -> Closest {
        if !E::TRANSPARENCY {
            return closest;
        }
        let shared = self.sharing(ray, &closest);
        shared.into_iter().next().filter(|first| first.object < closest.object).unwrap_or(closest)
    }

    /// The other transparent objects that have a boundary where the ray meets this one, in the order of the list. What is closer
    /// together than the bounds on the errors of both is one interface, between the medium before all of them and the one
    /// behind: the water in a full glass has no air around it.
    fn sharing(&self, ray: &Ray, own: &Closest) -> Shared {
        let others = &self.scene.index.touching[own.object];
        if others.is_empty() || own.sense == Sense::Touch {
            return Shared::new();
        }
        let point = ray.origin + ray.direction * own.boundary.t;
        let slack = widest_blur(&own.boundary, ray.direction, point);
        let is_near = |other: &&usize| self.scene.objects[**other].solid.extent().holds_nearly(point, slack);
        let mut near = others.iter().filter(is_near).peekable();
        if near.peek().is_none() {
            return Shared::new();
        }
        let normal = self.scene.objects[own.object].solid.normal(&own.boundary, point);
        let own_blur = blur(&own.boundary, ray.direction, normal, point);
        let shares = |&other: &usize| {
            let solid = &self.scene.objects[other].solid;
            let list = solid.inside_by(self.scene.solving, ray.origin, ray.direction);
            let (boundary, sense) = self.ahead(ray, other, &list).list.first()?;
            let normal_there = solid.normal(&boundary, point);
            let slope = normal.dot(ray.direction).abs().max(normal_there.dot(ray.direction).abs());
            let bound = own_blur + blur(&boundary, ray.direction, normal_there, point);
            let is_shared = sense != Sense::Touch && (boundary.t - own.boundary.t).abs() * slope <= bound;
            is_shared.then_some(Closest { object: other, boundary, sense })
        };
        near.filter_map(shares).collect()
    }

    /// The object whose medium the ray travels in; none in air.
    pub(super) fn current_medium(&self, media: &MediaStack) -> Option<usize> {
        let policy = match self.scene.media {
            MediaPolicy::Priority => Policy::Priority,
            MediaPolicy::Forbid | MediaPolicy::MostRecent => Policy::MostRecent,
        };
        media.current(policy, |object| self.scene.objects[object].priority)
    }

    /// The index of refraction of the medium in an object, or of air, for one wavelength or for all.
    pub(super) fn index_of_refraction(&self, medium: Option<usize>, wavelength: Option<f64>) -> f64 {
        medium.map_or(1.0, |object| self.scene.materials[self.scene.objects[object].material].index_at(wavelength))
    }

    /// The name of the object whose medium it is, or air.
    pub(super) fn medium_name(&self, medium: Option<usize>) -> String {
        medium.map_or_else(|| "air".to_owned(), |object| self.scene.objects[object].name.clone())
    }

    fn is_transparent(&self, object: usize) -> bool {
        self.scene.materials[self.scene.objects[object].material].transparency > 0.0
    }

    fn describe_crossing(&self, ray: &Ray, crossed: &[Closest], crossing: &MediaCrossing) -> Entry {
        let names: Vec<&str> = crossed.iter().map(|closest| self.scene.objects[closest.object].name.as_str()).collect();
        let overlap = ray.media.overlap() || crossing.changed.as_ref().is_some_and(MediaStack::overlap);
        let interpenetration = overlap && self.scene.media == MediaPolicy::Forbid;
        let decided = match self.scene.media {
            MediaPolicy::Forbid if overlap => {
                "policy 1 is broken: transparent objects overlap here, and the most recently entered one is taken"
            }
            MediaPolicy::Forbid => "policy 1: transparent objects do not overlap",
            MediaPolicy::MostRecent => "policy 2: the most recently entered object wins",
            MediaPolicy::Priority => "policy 2: the object with the highest priority wins",
        };
        Entry::new(What::Medium {
            object: names.join(" and "),
            before: self.medium_name(crossing.before),
            after: self.medium_name(crossing.after),
            decided: decided.to_owned(),
            interpenetration,
            hidden: crossing.hidden,
        })
    }
}
