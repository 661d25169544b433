//! What media take away from light on its way: Bouguer's, Lambert's and Beer's law along rays from the eye and towards lights.

use super::calls::Repertoire;
use super::closest::Surface;
use super::path::Answer;
use super::ray::{Ray, Tracer};
use super::scatter::Turned;
use crate::csg::Boundary;
use crate::optics::{MediaStack, Medium};
use crate::record::{self, Effect, Entry, NullRecorder, Recorder, Sense, What};
use crate::scene::Rgb;
use glam::DVec3;

/// What fills the space that a ray travels through.
#[derive(Clone, Copy, Debug)]
pub(super) struct Filling<'a> {
    /// The object that it fills, by its place in the list.
    pub object: usize,
    pub medium: &'a Medium,
}

/// A stretch of a ray inside a medium.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretch<'a> {
    pub filling: Filling<'a>,
    /// Between these hit times; the second may be infinite.
    pub times: [f64; 2],
    /// In the world's units.
    pub length: f64,
}

/// What a ray through a medium sees, but for the light from its end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passage<'a> {
    filling: Filling<'a>,
    /// What the light from its end counts.
    passes: Rgb,
    /// The light that is turned towards its start on the way.
    scattered: Rgb,
}

impl<'a> Stretch<'a> {
    fn new(filling: Filling<'a>, ray: &Ray, times: [f64; 2]) -> Self {
        Self { filling, times, length: (times[1] - times[0]) * ray.direction.length() }
    }

    /// exp(−σ_t length).
    fn transmittance(&self) -> Rgb {
        self.filling.medium.transmittance(self.length)
    }
}

impl<'a, E: Repertoire> Tracer<'a, E> {
    /// The medium that the ray travels in, where it takes light away.
    pub(super) fn filling(&self, ray: &Ray) -> Option<Filling<'a>> {
        if !self.calls_for(Effect::Attenuation) {
            return None;
        }
        self.filling_of(self.current_medium(&ray.media)?)
    }

    fn filling_of(&self, object: usize) -> Option<Filling<'a>> {
        let material = &self.scene.materials[self.scene.objects[object].material];
        material.medium.as_ref().map(|medium| Filling { object, medium })
    }

    /// The light that comes back along a ray in a medium: what is left of the light from its end, and what is turned
    /// towards its start on the way.
    #[inline(never)]
    pub(super) fn see_through<R: Recorder>(
        &self,
        ray: &Ray,
        filling: Filling<'a>,
        surface: Option<&mut Surface>,
        recorder: &mut R,
    ) -> Answer<'a> {
        Self::enter(Effect::Attenuation, recorder);
        let end = surface.as_ref().map_or(f64::INFINITY, |surface| surface.boundary.t);
        let stretch = Stretch::new(filling, ray, [0.0, end]);
        recorder.note(|| self.describe_segment(ray, &stretch));
        let Turned { passes, scattered, budget } = self.turned_on(ray, &stretch, stretch.transmittance(), recorder);
        let passage = Passage { filling, passes, scattered };
        // Where nothing is left, nothing behind can be seen.
        if passes == Rgb::ZERO {
            return Answer::Colour(self.colour_through(&passage, Rgb::ZERO, recorder));
        }
        let (weight, tint) = (ray.weight * passes.max_element(), ray.tint * passes);
        match self.see(&Ray { weight, budget, tint, ..ray.clone() }, surface, recorder) {
            Answer::Colour(behind) => Answer::Colour(self.colour_through(&passage, behind, recorder)),
            Answer::Onward(mut onward) => {
                onward.relay.passage = Some(passage);
                Answer::Onward(onward)
            }
        }
    }

    /// What comes back along a ray through a medium from whose end comes the light `behind`.
    pub(super) fn colour_through(&self, passage: &Passage, behind: Rgb, recorder: &mut impl Recorder) -> Rgb {
        let Passage { filling, passes, scattered } = *passage;
        let colour = passes * behind + scattered;
        recorder.note(|| self.describe_passage(&filling, [passes, behind, scattered, colour]));
        colour
    }

    /// The share of a light at `limit` that the media along a shadow ray let through, by colour.
    #[inline(always)]
    pub(super) fn clearness<R: Recorder>(&self, shadow: &Ray, limit: f64, recorder: &mut R) -> Rgb {
        if self.calls_for(Effect::Attenuation) { self.clearness_of_media(shadow, limit, recorder) } else { Rgb::ONE }
    }

    #[inline(never)]
    fn clearness_of_media<R: Recorder>(&self, shadow: &Ray, limit: f64, recorder: &mut R) -> Rgb {
        let mut media = shadow.media.clone();
        let mut clearness = Rgb::ONE;
        let mut from = 0.0;
        let mut pass = |media: &MediaStack, from: f64, to: f64, recorder: &mut R| {
            let filling = self.current_medium(media).and_then(|object| self.filling_of(object));
            if let Some(filling) = filling.filter(|_| to > from) {
                Self::enter(Effect::Attenuation, recorder);
                let stretch = Stretch::new(filling, shadow, [from, to]);
                clearness *= stretch.transmittance();
                recorder.note(|| self.describe_segment(shadow, &stretch));
            }
        };
        for (object, boundary, sense) in self.boundaries_of_media(shadow, limit) {
            pass(&media, from, boundary.t, recorder);
            from = boundary.t;
            match sense {
                Sense::Enter => media.enter(object),
                Sense::Leave | Sense::Touch => media.leave(object),
            }
        }
        pass(&media, from, limit, recorder);
        clearness
    }

    /// Every boundary of a transparent object that a ray crosses before `limit`, in order.
    fn boundaries_of_media(&self, ray: &Ray, limit: f64) -> Vec<(usize, Boundary, Sense)> {
        let course = self.course(ray);
        let mut crossed = Vec::new();
        for &object in &self.scene.index.transparent {
            let solid = &self.scene.objects[object].solid;
            if ray.leaves_for_good(object, solid) {
                continue;
            }
            let list = solid.inside_as_asked(&course, false, &mut NullRecorder);
            let ahead = self.ahead(ray, object, &list).list;
            let bounds = ahead.boundaries().into_iter().filter(|(boundary, _)| boundary.t < limit);
            crossed
                .extend(bounds.map(|(boundary, sense)| (object, boundary, sense)).filter(|end| end.2 != Sense::Touch));
        }
        // What is left is left before anything is entered in the same place.
        let key = |(object, boundary, sense): &(usize, Boundary, Sense)| (boundary.t, *sense == Sense::Enter, *object);
        crossed.sort_by(|a, b| key(a).partial_cmp(&key(b)).unwrap_or(std::cmp::Ordering::Equal));
        crossed
    }

    fn describe_segment(&self, ray: &Ray, stretch: &Stretch) -> Entry {
        let Stretch { filling: Filling { object, medium }, times: [from, to], length } = *stretch;
        let at = |t: f64| (ray.origin + ray.direction * t).to_array();
        let transmittance = stretch.transmittance().to_array();
        let entry = Entry::new(What::Segment(record::Segment {
            medium: self.scene.objects[object].name.clone(),
            from: at(from),
            to: to.is_finite().then(|| at(to)),
            length,
            absorption: medium.absorption.to_array(),
            scattering: medium.scattering.to_array(),
            transmittance,
        }));
        if !length.is_finite() {
            return entry;
        }
        let bindings = [
            ("t", to.into()),
            ("t₀", from.into()),
            ("dir", ray.direction.to_array().into()),
            ("d", length.into()),
            ("σ_a", medium.absorption.to_array().into()),
            ("σ_s", medium.scattering.to_array().into()),
        ];
        entry.line("d", "(t − t₀) |dir|", &bindings, length).line("T", "exp(−(σ_a + σ_s) d)", &bindings, transmittance)
    }

    fn describe_passage(&self, filling: &Filling, [passes, behind, scattered, colour]: [DVec3; 4]) -> Entry {
        let [passes, behind, scattered, colour] = [passes, behind, scattered, colour].map(|rgb| rgb.to_array());
        let medium = self.scene.objects[filling.object].name.clone();
        let bindings = [("T", passes.into()), ("I_end", behind.into()), ("I_way", scattered.into())];
        Entry::new(What::Passage(record::Passage { medium, behind, passes, scattered, colour })).line(
            "I",
            "T I_end + I_way",
            &bindings,
            colour,
        )
    }
}
