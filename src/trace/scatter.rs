//! Light that a medium turns towards the start of a ray.
//!
//! A ray that was not turned yet sees all that lies behind the medium, dimmed, and one point on its way at which light is
//! turned. A ray that was turned, or may spawn no more rays, makes one choice by the same random number: it goes through, or it
//! is turned. At each such point every light is asked, as at a surface. Where the medium turns light more than once, the path goes on from there in a
//! direction by the phase function; else only lights are seen by it, and neither surfaces nor surroundings.

use super::calls::Repertoire;
use super::ray::{Ray, Tracer};
use super::segment::Stretch;
use super::shadow::{Start, Way};
use crate::optics::{Flight, HenyeyGreenstein, Walk, one_less_exp};
use crate::record::{self, Counter, Effect, Entry, RayKind, Recorder, What};
use crate::sample::Purpose;
use crate::scene::Rgb;
use glam::DVec3;
use std::f64::consts::PI;

/// What became of a ray in a medium.
pub(super) struct Turned {
    /// What the light from its end counts.
    pub passes: Rgb,
    /// The light that was turned towards its start.
    pub scattered: Rgb,
    /// How many rays may still be spawned at its end.
    pub budget: u32,
}

/// A point at which light is turned.
struct Turn<'a> {
    ray: &'a Ray,
    stretch: &'a Stretch<'a>,
    flight: Flight,
    /// In world space.
    point: DVec3,
    /// The unit direction of the ray.
    onward: DVec3,
    phase: HenyeyGreenstein,
    /// Whether it is known to lie on the stretch; else it may come as far as it likes.
    is_on_stretch: bool,
    /// How many rays the path that goes on from here may spawn.
    budget: u32,
}

impl<E: Repertoire> Tracer<'_, E> {
    /// Lets chance choose where on the stretch light is turned, and asks there for light.
    pub(super) fn turned_on<R: Recorder>(
        &self,
        ray: &Ray,
        stretch: &Stretch,
        transmittance: Rgb,
        recorder: &mut R,
    ) -> Turned {
        let unturned = Turned { passes: transmittance, scattered: Rgb::ZERO, budget: ray.budget };
        if !self.calls_for(Effect::Scattering) {
            return unturned;
        }
        let medium = stretch.filling.medium;
        let may_turn = medium.scattering != Rgb::ZERO && (ray.turns == 0 || medium.multiple);
        if !may_turn || stretch.length == 0.0 {
            return unturned;
        }
        Self::enter(Effect::Scattering, recorder);
        let chance = ray.stream.number(Purpose::Distance);
        let turn_at = |flight: Flight, is_on_stretch, budget| {
            let onward = ray.direction.normalize();
            let phase = HenyeyGreenstein { anisotropy: medium.anisotropy };
            let point = ray.origin + onward * flight.distance;
            Turn { ray, stretch, flight, point, onward, phase, is_on_stretch, budget }
        };
        let left = ray.budget.saturating_sub(1);
        if ray.turns == 0 && (ray.budget > 0 || !medium.multiple) {
            let flight = medium.turned_within(stretch.length, ray.tint, chance);
            // What lies behind and the path that is turned share what may be spawned.
            let budget = if medium.multiple { left / 2 } else { ray.budget };
            let scattered = self.light_from(&turn_at(flight, true, left / 2), chance, recorder);
            return Turned { scattered, budget, ..unturned };
        }
        match medium.walk(stretch.length, ray.tint, chance) {
            Walk::Through(passes) => Turned { passes, ..unturned },
            Walk::Turned(flight) => {
                let scattered = self.light_from(&turn_at(flight, false, left), chance, recorder);
                Turned { passes: Rgb::ZERO, scattered, ..unturned }
            }
        }
    }

    /// The light that is turned towards the ray's start at one point, times what it counts.
    fn light_from<R: Recorder>(&self, turn: &Turn, chance: f64, recorder: &mut R) -> Rgb {
        recorder.begin();
        let mut light: Rgb = (0..self.scene.lights.len()).map(|index| self.turned_light(turn, index, recorder)).sum();
        if turn.stretch.filling.medium.multiple {
            light += self.path_onward(turn, recorder);
        }
        let colour = turn.flight.weight * light;
        recorder.end(|| self.describe_scatter(turn, chance, light, colour));
        colour
    }

    /// The light of one lamp that is turned here: p(cosθ) times what arrives.
    fn turned_light<R: Recorder>(&self, turn: &Turn, index: usize, recorder: &mut R) -> Rgb {
        recorder.begin();
        let light = &self.scene.lights[index];
        let place = turn
            .ray
            .stream
            .branch(RayKind::Scattered as u32)
            .square(Purpose::Light(u32::try_from(index).unwrap_or(u32::MAX)));
        let way = Way::new(&self.scene.lights, index, turn.point, place);
        let start = Start { ray: turn.ray, origin: turn.point, surface: None };
        let arriving = light.colour * self.arriving(&start, &way, recorder);
        let cosine = turn.onward.dot(way.towards);
        let value = turn.phase.value(cosine);
        let turned = arriving * value;
        recorder.end(|| {
            let entry = describe_phase(turn, &light.name, way.towards, cosine);
            let bindings = [("p", value.into()), ("I_l", arriving.to_array().into())];
            entry.line("J_l", "p I_l", &bindings, turned.to_array())
        });
        turned
    }

    /// The light that comes from another direction, chosen as often as light is turned from there.
    fn path_onward<R: Recorder>(&self, turn: &Turn, recorder: &mut R) -> Rgb {
        let Turn { ray, flight, point, onward, phase, .. } = turn;
        let (direction, cosine) = phase.turned(*onward, ray.stream.square(Purpose::Phase));
        recorder.note(|| describe_phase(turn, "on", direction, cosine));
        let kind = RayKind::Scattered;
        let path = Ray {
            kind,
            origin: *point,
            direction,
            depth: ray.depth,
            weight: ray.weight * flight.weight.max_element(),
            budget: turn.budget,
            departure: None,
            media: ray.media.clone(),
            place: None,
            beam: None,
            wavelength: ray.wavelength,
            tint: ray.tint * flight.weight,
            turns: ray.turns + 1,
            stream: ray.stream.branch(kind as u32),
        };
        if self.stopped_by_a_limit(&path, recorder) {
            return Rgb::ZERO;
        }
        recorder.count(Counter::Sent(Effect::Scattering));
        recorder.begin();
        let colour = self.trace_spawned(&path, recorder);
        recorder.end(|| self.describe_ray(&path));
        colour
    }

    fn describe_scatter(&self, turn: &Turn, chance: f64, light: Rgb, colour: Rgb) -> Entry {
        let Turn { ray, stretch, flight, point, .. } = turn;
        let medium = stretch.filling.medium;
        let entry = Entry::new(What::Scatter(record::Scatter {
            medium: self.scene.objects[stretch.filling.object].name.clone(),
            number: ray.turns + 1,
            distance: flight.distance,
            point: point.to_array(),
            chance,
            density: flight.density,
            weight: flight.weight.to_array(),
            colour: colour.to_array(),
        }));
        let rate = medium.extinction()[flight.colour];
        let share_of_all = if turn.is_on_stretch { one_less_exp(rate * stretch.length) } else { 1.0 };
        let bindings = [
            ("ξ", flight.share.into()),
            ("q", share_of_all.into()),
            ("σ", rate.into()),
            ("s", flight.distance.into()),
            ("p_rgb", flight.densities.to_array().into()),
            ("c", flight.odds.to_array().into()),
            ("p_s", flight.density.into()),
            ("σ_a", medium.absorption.to_array().into()),
            ("σ_s", medium.scattering.to_array().into()),
            ("w", flight.weight.to_array().into()),
            ("J", light.to_array().into()),
        ];
        let entry = if rate > 0.0 {
            let entry = entry.line("s", "−ln(1 − ξ q) / σ", &bindings, flight.distance);
            entry.line("p", "σ exp(−σ s) / q", &bindings, flight.densities[flight.colour])
        } else {
            entry
        };
        entry
            .line("p_s", "c · p_rgb", &bindings, flight.density)
            .line("w", "σ_s exp(−(σ_a + σ_s) s) / p_s", &bindings, flight.weight.to_array())
            .line("I_way", "w J", &bindings, colour.to_array())
    }
}

fn describe_phase(turn: &Turn, towards: &str, direction: DVec3, cosine: f64) -> Entry {
    let anisotropy = turn.phase.anisotropy;
    let value = turn.phase.value(cosine);
    let bindings = [
        ("d", turn.onward.to_array().into()),
        ("l", direction.to_array().into()),
        ("g", anisotropy.into()),
        ("π", PI.into()),
        ("cosθ", cosine.into()),
    ];
    Entry::new(What::Phase(record::Phase {
        towards: towards.to_owned(),
        anisotropy,
        cosine,
        value,
        direction: direction.to_array(),
    }))
    .line("cosθ", "d · l", &bindings, cosine)
    .line("p", "(1 − g²) / (4 π (1 + g² − 2 g cosθ)^1.5)", &bindings, value)
}
