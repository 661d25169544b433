//! Which medium a ray travels in, and what a boundary changes about it (§ 6.4.1, design policies 1 and 2).

use super::closest::Surface;
use super::ray::{Ray, Tracer};
use crate::optics::{MediaStack, Policy};
use crate::record::{Entry, NullRecorder, Recorder, Sense, What};
use crate::scene::MediaPolicy;
use glam::DVec3;

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

impl Tracer<'_> {
    /// The transparent objects that the eye is inside, in the order in which a ray from far behind it entered them.
    pub(super) fn media_around(&self, eye: DVec3, direction: DVec3) -> MediaStack {
        let index = &self.scene.index;
        let is_eye = eye.distance(self.scene.camera.eye) <= index.eye_reach;
        let candidates = if is_eye { &index.around_the_eye } else { &index.transparent };
        if candidates.is_empty() {
            return MediaStack::default();
        }
        let holding_eye = |&object: &usize| {
            let list = self.scene.objects[object].solid.inside::<f64>(eye, direction, &mut NullRecorder);
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
        let before = self.current_medium(&ray.media);
        let bounds_a_medium = self.is_transparent(surface.object) && surface.sense != Sense::Touch;
        if !bounds_a_medium {
            return MediaCrossing { before, after: before, changed: None, hidden: false };
        }
        let mut media_after = ray.media.clone();
        match surface.sense {
            Sense::Enter => media_after.enter(surface.object),
            Sense::Leave | Sense::Touch => media_after.leave(surface.object),
        }
        let after = self.current_medium(&media_after);
        let crossing = MediaCrossing { before, after, changed: Some(media_after), hidden: before == after };
        recorder.note(|| self.describe_crossing(ray, surface, &crossing));
        crossing
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

    fn describe_crossing(&self, ray: &Ray, surface: &Surface, crossing: &MediaCrossing) -> Entry {
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
            object: self.scene.objects[surface.object].name.clone(),
            before: self.medium_name(crossing.before),
            after: self.medium_name(crossing.after),
            decided: decided.to_owned(),
            interpenetration,
            hidden: crossing.hidden,
        })
    }
}
