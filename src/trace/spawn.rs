//! The rays that a hit spawns: the mirrored one and the one through the surface (§ 6.4).

use super::allotment::{Allotment, Lot};
use super::beam::{Beam, Corners};
use super::calls::Repertoire;
use super::closest::Surface;
use super::departure::Departure;
use super::division::{Division, Through};
use super::media::MediaCrossing;
use super::path::{Onward, Relay};
use super::ray::{Components, MOST_TURNS, Ray, Tracer};
use crate::optics::{MediaStack, reflect};
use crate::record::{Counter, Effect, Entry, RayKind, Recorder, Value, What};
use crate::scene::{Effects, Material, Rgb, Split};
use glam::DVec3;

/// The place where a ray meets a surface, with all that decides what it spawns there.
pub(super) struct Meeting<'a> {
    pub surface: &'a Surface,
    pub material: &'a Material,
    pub corners: Option<Corners>,
}

/// A ray that is to be sent from a surface.
struct Offspring {
    /// What calls for it.
    effect: Effect,
    kind: RayKind,
    direction: DVec3,
    beam: Option<Box<Beam>>,
    /// The share of what it brings back, by colour.
    share: Rgb,
    media: MediaStack,
    /// Whether it is sent, and how many rays it may spawn in turn.
    lot: Lot,
    /// Its wavelength in nanometres, where it has one.
    wavelength: Option<f64>,
    /// Tells its random numbers from those of the other rays that its parent spawns.
    branch: u32,
    /// Whether no other ray follows it.
    is_last: bool,
}

/// What comes from a direction.
#[expect(clippy::large_enum_variant, reason = "rays are handed over where they are, without a call of the allocator")]
enum View {
    /// This colour.
    Colour(Rgb),
    /// What this ray will bring back, times this share.
    Along(Ray, Rgb),
}

/// From here on a path hands its rays over. Up to here they are traced one within the other, which spares moving them.
const LONG: u32 = 32;

/// At least as many as there are kinds of rays.
const MOST_KINDS: u32 = 256;

impl<'a, E: Repertoire> Tracer<'a, E> {
    /// Adds what comes back along the reflected and the transmitted ray. On long paths the last of them is handed over: what it
    /// brings back is to be added yet.
    #[inline(always)]
    pub(super) fn add_spawned<R: Recorder>(
        &self,
        ray: &Ray,
        meeting: &Meeting,
        crossing: &MediaCrossing,
        components: &mut Components,
        recorder: &mut R,
    ) -> Option<Onward<'a>> {
        if self.calls_for_any(Effects::SENDING) && meeting.material.sends_rays() {
            return self.add_mirrored_and_transmitted(ray, meeting, crossing, components, recorder);
        }
        None
    }

    /// What [`add_spawned`](Self::add_spawned) does at surfaces that send rays. It is kept out of line: other surfaces should
    /// not make room for it.
    #[inline(never)]
    fn add_mirrored_and_transmitted<R: Recorder>(
        &self,
        ray: &Ray,
        meeting: &Meeting,
        crossing: &MediaCrossing,
        components: &mut Components,
        recorder: &mut R,
    ) -> Option<Onward<'a>> {
        let Meeting { surface, material, corners } = meeting;
        let Division { mirrored: share, name, through } = self.divide(ray, meeting, crossing, recorder);
        let mirroring = self.mirrored_for(material, through.is_empty()).filter(|_| share != Rgb::ZERO);
        let mirrored_share = mirroring.map_or(Rgb::ZERO, |_| share);
        let shares = through.iter().map(|way| way.share);
        let allotment = Allotment::new(ray, self.scene.limits.depth, [mirrored_share].into_iter().chain(shares));
        if let Some(effect) = mirroring {
            let direction = surface.kept_outside(reflect(ray.direction, surface.n_shading));
            recorder.note(|| describe_reflection(ray, surface, direction, share, name));
            Self::enter(effect, recorder);
            let (kind, media, wavelength) = (RayKind::Reflected, ray.media.clone(), ray.wavelength);
            let beam = corners.as_deref().map(|corners| Beam::mirrored(corners, surface));
            let (branch, lot) = (kind as u32, allotment.lot(0, share));
            let is_last = through.is_empty();
            let offspring = Offspring { effect, kind, direction, beam, share, media, lot, wavelength, branch, is_last };
            match self.look(ray, meeting, offspring, recorder) {
                View::Colour(colour) => components.reflected = colour,
                View::Along(ray, share) => return Some(onward(ray, share, components)),
            }
        }
        let ways = through.len();
        for (number, Through { direction, indices, share, wavelength }) in (0..).zip(through) {
            if number == 0 {
                Self::enter(Effect::Refraction, recorder);
            }
            // Without dispersion there would be one ray.
            let effect = if number == 0 { Effect::Refraction } else { Effect::Dispersion };
            let (kind, media) = (RayKind::Refracted, crossing.media_after(ray));
            let direction = surface.kept_inside(direction);
            let way = [ray.direction, direction];
            let beam = corners.as_deref().map(|corners| Beam::bent(corners, surface, way, indices));
            let (branch, lot) = (kind as u32 + number * MOST_KINDS, allotment.lot(1 + number as usize, share));
            let is_last = number as usize + 1 == ways;
            let offspring = Offspring { effect, kind, direction, beam, share, media, lot, wavelength, branch, is_last };
            match self.look(ray, meeting, offspring, recorder) {
                View::Colour(colour) => components.transmitted += colour,
                View::Along(ray, share) => return Some(onward(ray, share, components)),
            }
        }
        None
    }

    /// What calls for a mirrored ray, if anything does. Where light is reflected inside glass because it cannot get out, that is
    /// the glass.
    fn mirrored_for(&self, material: &Material, nothing_passes: bool) -> Option<Effect> {
        let has_weights = material.split == Split::Weights;
        if self.calls_for(Effect::Reflection) && (material.reflectivity > 0.0 || !has_weights) {
            return Some(Effect::Reflection);
        }
        let is_total = material.transparency > 0.0 && (has_weights || nothing_passes);
        (is_total && self.calls_for(Effect::Refraction)).then_some(Effect::Refraction)
    }

    /// What comes from a direction: what a ray brings back, or the environment alone where the material asks for that.
    fn look<R: Recorder>(&self, parent: &Ray, meeting: &Meeting, offspring: Offspring, recorder: &mut R) -> View {
        if meeting.material.mirrors_environment() {
            let beam = offspring.beam.as_deref();
            return View::Colour(self.see_environment(offspring.direction, beam, recorder) * offspring.share);
        }
        self.spawn(parent, meeting.surface, offspring, recorder)
    }

    /// Goes on behind a boundary that lies inside a medium which wins over it.
    #[inline(never)]
    pub(super) fn pass_straight_through<R: Recorder>(
        &self,
        ray: &Ray,
        surface: &Surface,
        crossing: &MediaCrossing,
        components: &mut Components,
        recorder: &mut R,
    ) -> Option<Onward<'a>> {
        let (kind, media) = (RayKind::Refracted, crossing.media_after(ray));
        let lot = Lot::Sent(ray.budget.saturating_sub(1));
        let beam = self.corners(ray, surface).map(|corners| Beam::straight_on(&corners));
        let share = Rgb::ONE;
        let (effect, branch) = (Effect::Refraction, kind as u32);
        let (direction, wavelength) = (ray.direction, ray.wavelength);
        let is_last = true;
        let offspring = Offspring { effect, kind, direction, beam, share, media, lot, wavelength, branch, is_last };
        match self.spawn(ray, surface, offspring, recorder) {
            View::Colour(colour) => components.transmitted = colour,
            View::Along(ray, share) => return Some(onward(ray, share, components)),
        }
        None
    }

    /// Sends a ray from the surface: its colour times `share`, black where chance or a limit stops it, or the ray itself where
    /// it is to be handed over.
    fn spawn<R: Recorder>(&self, parent: &Ray, surface: &Surface, offspring: Offspring, recorder: &mut R) -> View {
        let Offspring { effect, kind, direction, beam, share, media, lot, wavelength, branch, is_last } = offspring;
        lot.tell(kind, share, recorder);
        let Some(factor) = lot.factor() else { return View::Colour(Rgb::ZERO) };
        let share = share * factor;
        let ray = Ray {
            kind,
            origin: surface.point,
            direction,
            depth: parent.depth + 1,
            weight: parent.weight * share.abs().max_element(),
            budget: lot.budget(),
            departure: Some(Departure::new(surface, parent.direction, direction)),
            media,
            place: None,
            beam,
            wavelength,
            tint: parent.tint * share.abs(),
            turns: parent.turns,
            stream: parent.stream.branch(branch),
        };
        if self.stopped_by_a_limit(&ray, recorder) {
            return View::Colour(Rgb::ZERO);
        }
        recorder.count(Counter::Sent(effect));
        if is_last && ray.depth >= LONG {
            return View::Along(ray, share);
        }
        recorder.begin();
        let colour = self.trace_spawned(&ray, recorder) * share;
        recorder.end(|| self.describe_ray(&ray));
        View::Colour(colour)
    }

    pub(super) fn stopped_by_a_limit(&self, ray: &Ray, recorder: &mut impl Recorder) -> bool {
        let limits = self.scene.limits;
        let (limit, at, value) = if ray.depth > limits.depth {
            ("depth", f64::from(limits.depth), f64::from(ray.depth))
        } else if ray.turns > MOST_TURNS {
            ("turns", f64::from(MOST_TURNS), f64::from(ray.turns))
        } else if ray.weight < limits.contribution {
            ("contribution", limits.contribution, ray.weight)
        } else {
            return false;
        };
        recorder.note(|| {
            Entry::new(What::Limit {
                limit: limit.to_owned(),
                at,
                value,
                consequence: format!("the {} ray is not sent; its share counts as black", ray.kind.name()),
            })
        });
        true
    }
}

/// Hands over the last ray of a hit that has gathered these components.
const fn onward<'a>(ray: Ray, share: Rgb, components: &Components) -> Onward<'a> {
    Onward { ray, relay: Relay { components: *components, share, passage: None } }
}

/// `name` is what the working before this calls the share.
fn describe_reflection(ray: &Ray, surface: &Surface, mirrored: DVec3, share: Rgb, name: Option<&'static str>) -> Entry {
    let bindings = [("dir", ray.direction.to_array().into()), ("m", surface.n_shading.to_array().into())];
    let is_grey = share == Rgb::splat(share.x);
    let shares = (!is_grey).then(|| share.to_array());
    let what = What::Reflection { direction: mirrored.to_array(), share: share.max_element(), shares };
    let entry = Entry::new(what).line("r", "dir − 2 (dir · m) m", &bindings, mirrored.to_array());
    let Some(name) = name else { return entry };
    let value = shares.map_or(Value::Number(share.x), Value::Vector);
    entry.line("share", name, &[(name, value)], value)
}
