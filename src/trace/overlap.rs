//! Design policy 1: transparent objects may not fill the same space (§ 6.4.1). Where two do, that is reported: which, between
//! which hit times, and at which pixel.

use super::calls::Repertoire;
use super::closest::Surface;
use super::media::MediaCrossing;
use super::ray::{Ray, Tracer};
use crate::record::{self, Counter, Entry, Recorder, Sense, What};
use crate::scene::{MediaPolicy, Scene};
use std::collections::BTreeMap;

/// Where two transparent objects fill the same space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// How many rays found it.
    pub rays: u64,
    /// The first pixel whose rays found it, row by row.
    pub pixel: [u32; 2],
    /// The hit times between which the ray of that pixel that found it first is in both.
    pub interval: [f64; 2],
}

/// The overlaps that a picture's rays found, by the two objects' places in the list, the lower one first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overlaps {
    found: BTreeMap<[usize; 2], Overlap>,
    pixel: [u32; 2],
}

impl Overlaps {
    /// What is found from now on belongs to this pixel.
    pub(super) fn begin_pixel(&mut self, pixel: [u32; 2]) {
        self.pixel = pixel;
    }

    /// A ray found an overlap.
    pub(super) fn add(&mut self, mut objects: [usize; 2], interval: [f64; 2]) {
        objects.sort_unstable();
        let here = Overlap { rays: 0, pixel: self.pixel, interval };
        self.found.entry(objects).or_insert(here).rays += 1;
    }

    /// Those of another part of the picture, too. The first pixel of all is kept, in whatever order parts are put together.
    #[must_use]
    pub(super) fn plus(mut self, other: &Self) -> Self {
        let row_by_row = |overlap: &Overlap| [overlap.pixel[1], overlap.pixel[0]];
        for (objects, theirs) in &other.found {
            let ours = self.found.entry(*objects).or_insert(Overlap { rays: 0, ..*theirs });
            let rays = ours.rays + theirs.rays;
            let first = if row_by_row(theirs) < row_by_row(ours) { *theirs } else { *ours };
            *ours = Overlap { rays, ..first };
        }
        self
    }

    /// All of them, with the objects' names, in the order of the object list.
    pub fn named<'a>(&'a self, scene: &'a Scene) -> impl Iterator<Item = ([&'a str; 2], &'a Overlap)> {
        let name = |object: &usize| scene.objects[*object].name.as_str();
        self.found.iter().map(move |([a, b], overlap)| ([name(a), name(b)], overlap))
    }

    /// Each as a sentence.
    #[must_use]
    pub fn in_words(&self, scene: &Scene) -> Vec<String> {
        let sentence = |([a, b], overlap): ([&str; 2], &Overlap)| {
            let ([x, y], [from, to]) = (overlap.pixel, overlap.interval);
            let rays = if overlap.rays == 1 { "1 ray".to_owned() } else { format!("{} rays", overlap.rays) };
            format!("`{a}` and `{b}` fill the same space: {rays}, first at pixel ({x}, {y}) from t = {from} to {to}")
        };
        self.named(scene).map(sentence).collect()
    }
}

impl<E: Repertoire> Tracer<'_, E> {
    /// Reports the transparent objects that the ray is inside already where it comes into another one.
    pub(super) fn report_overlaps<R: Recorder>(
        &self,
        ray: &Ray,
        surface: &Surface,
        crossing: &MediaCrossing,
        recorder: &mut R,
    ) {
        if !E::TRANSPARENCY
            || self.scene.media != MediaPolicy::Forbid
            || ray.media.is_empty()
            || surface.sense != Sense::Enter
        {
            return;
        }
        self.report_overlaps_of(ray, surface, crossing, recorder);
    }

    #[inline(never)]
    fn report_overlaps_of<R: Recorder>(
        &self,
        ray: &Ray,
        surface: &Surface,
        crossing: &MediaCrossing,
        recorder: &mut R,
    ) {
        let media = crossing.media_after(ray);
        if !media.contains(surface.object) {
            return;
        }
        let others = self.scene.index.transparent.iter().filter(|&&other| other != surface.object);
        for &other in others.filter(|&&other| media.contains(other) && ray.media.contains(other)) {
            let from = surface.boundary.t;
            let left = [surface.object, other].map(|object| self.left_after(object, ray, from));
            let interval = [from, left[0].min(left[1])];
            recorder.count(Counter::Overlap { objects: [other, surface.object], interval });
            recorder.note(|| {
                let [first, second] = [other, surface.object].map(|object| self.scene.objects[object].name.clone());
                Entry::new(What::Overlap(record::Overlap { first, second, interval }))
            });
        }
    }

    /// When a ray comes out of an object that it is inside of at `t` or directly after.
    fn left_after(&self, object: usize, ray: &Ray, t: f64) -> f64 {
        let list = self.scene.objects[object].solid.inside_by(self.scene.solving, ray.origin, ray.direction);
        let ends = list.intervals().filter_map(|interval| interval.leave.map(|leave| leave.t));
        ends.filter(|&end| end > t).fold(f64::INFINITY, f64::min)
    }
}
