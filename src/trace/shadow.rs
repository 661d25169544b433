//! Shadow rays: what arrives from a light at a point, be it on a surface or in a medium.

use super::calls::Repertoire;
use super::closest::Surface;
use super::departure::{Ahead, Departure};
use super::ray::{Ray, Tracer};
use crate::record::{Counter, Effect, Entry, RayKind, Recorder, What};
use crate::scene::{Light, LightKind, Rgb};
use glam::DVec3;
use smallvec::SmallVec;

/// Where a shadow ray starts.
pub(super) struct Start<'a> {
    /// The ray that came to this point.
    pub ray: &'a Ray,
    /// The point.
    pub origin: DVec3,
    /// The surface that the point lies on, if it lies on one.
    pub surface: Option<&'a Surface>,
}

/// The way to a point of a light.
pub(super) struct Way {
    /// From the point to the light; t = 1 at a point of a light, without end towards a directional one.
    pub direction: DVec3,
    /// Unit.
    pub towards: DVec3,
    /// The hit time beyond which nothing is in the way.
    pub limit: f64,
    /// The light, by its place in the list.
    pub light: usize,
    /// What calls for the ray.
    pub effect: Effect,
}

impl Way {
    /// The way from `point` to a light: of one that has a size, to its point for `place` in the unit square.
    pub fn new(lights: &[Light], light: usize, point: DVec3, place: [f64; 2]) -> Self {
        match lights[light].kind {
            LightKind::Point(position) => Self::to_point(light, position - point, Effect::Shadows),
            LightKind::Area(area) => Self::to_point(light, area.point_at(place, point) - point, Effect::SoftShadows),
            LightKind::Directional(towards) => {
                Self { direction: towards, towards, limit: f64::INFINITY, light, effect: Effect::Shadows }
            }
        }
    }

    /// The way to a point of a light, from the point that is lit.
    pub fn to_point(light: usize, direction: DVec3, effect: Effect) -> Self {
        Self { direction, towards: direction.normalize_or_zero(), limit: 1.0, light, effect }
    }
}

/// What transparent objects leave of a light, gathered in any order.
#[derive(Default)]
pub(super) struct Shade {
    /// An opaque object is in the way.
    pub is_dark: bool,
    shares: SmallVec<[(usize, f64); 4]>,
}

impl Shade {
    /// An object lets this share pass.
    pub fn add(&mut self, object: usize, share: f64) {
        if share != 1.0 {
            self.shares.push((object, share));
        }
    }

    /// The product, in the order of the object list: rounding must not depend on the order of the tests.
    pub fn share(mut self) -> f64 {
        if self.is_dark {
            return 0.0;
        }
        self.shares.sort_by_key(|&(object, _)| object);
        self.shares.iter().map(|(_, share)| share).product()
    }
}

impl<E: Repertoire> Tracer<'_, E> {
    /// The share of a light that arrives, by colour: a shadow ray, stopped by the first opaque object. Each surface
    /// of a transparent object passes its transparency, as it does for a ray from the eye; shadow rays are not bent.
    #[inline(always)]
    pub(super) fn arriving<R: Recorder>(&self, start: &Start, way: &Way, recorder: &mut R) -> Rgb {
        if !self.calls_for(way.effect) {
            return Rgb::ONE;
        }
        let Start { ray, origin, surface } = *start;
        let shadow = Ray {
            kind: RayKind::Shadow,
            origin,
            direction: way.direction,
            depth: ray.depth + 1,
            weight: ray.weight,
            budget: 0,
            departure: surface.map(|surface| Departure::new(surface, ray.direction, way.direction)),
            media: ray.media.clone(),
            place: None,
            beam: None,
            wavelength: ray.wavelength,
            tint: ray.tint,
            turns: ray.turns,
            stream: ray.stream,
        };
        Self::enter(way.effect, recorder);
        recorder.count(Counter::Sent(way.effect));
        recorder.count(Counter::Ray(RayKind::Shadow));
        if !R::RECORDING {
            let share = self.let_through(&shadow, way.light, way.limit, recorder);
            return self.clearness(&shadow, way.limit, recorder) * share;
        }
        recorder.begin();
        let share = self.told_let_through(&shadow, way.limit, recorder);
        let share = self.clearness(&shadow, way.limit, recorder) * share;
        recorder.end(|| self.describe_ray(&shadow));
        share
    }

    /// The share of a light at `limit` that arrives along a shadow ray, told object by object.
    fn told_let_through(&self, shadow: &Ray, limit: f64, recorder: &mut impl Recorder) -> f64 {
        let course = self.course(shadow);
        let mut share = 1.0;
        for index in self.reached(&course, recorder) {
            let object = &self.scene.objects[index];
            let list = self.intersect(index, shadow, &course, recorder);
            let ahead = self.ahead(shadow, index, &list);
            ahead.report(object, recorder);
            share *= self.passed(shadow, index, &ahead, limit, recorder);
            if share == 0.0 {
                break;
            }
        }
        share
    }

    /// The share of light that an object lets pass before the light at `limit`.
    pub(super) fn passed<R: Recorder>(
        &self,
        shadow: &Ray,
        index: usize,
        ahead: &Ahead,
        limit: f64,
        recorder: &mut R,
    ) -> f64 {
        let object = &self.scene.objects[index];
        let mut share = 1.0;
        for boundary in ahead.surfaces(limit) {
            let t = boundary.map_or(0.0, |boundary| boundary.t);
            let material = boundary.map_or(object.leaf_materials[0], |boundary| {
                self.material_at(index, boundary, shadow.origin + shadow.direction * t).0
            });
            let passes = self.scene.materials[material].transparency;
            share *= passes;
            recorder.note(|| {
                let reason = if passes > 0.0 {
                    "transparent: each surface passes its transparency, without bending"
                } else {
                    "opaque: no light arrives"
                };
                Entry::new(What::Shadow { object: object.name.clone(), t, passes, reason: reason.to_owned() })
            });
        }
        share
    }
}
