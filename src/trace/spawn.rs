//! The rays that a hit spawns: the mirrored one and the one through the surface (§ 6.4).

use super::closest::Surface;
use super::departure::Departure;
use super::media::MediaCrossing;
use super::ray::{Components, Ray, Tracer};
use crate::optics::{MediaStack, Optics, reflect, refract, snell_entry};
use crate::record::{Entry, RayKind, Recorder, What};
use crate::scene::Rgb;
use glam::DVec3;

impl Tracer<'_> {
    /// Adds what comes back along the reflected and the transmitted ray.
    pub(super) fn add_spawned<R: Recorder>(
        &self,
        ray: &Ray,
        surface: &Surface,
        crossing: &MediaCrossing,
        components: &mut Components,
        recorder: &mut R,
    ) {
        let material = self.material(surface);
        let transmission = (material.transparency > 0.0).then(|| self.bend(ray, surface, crossing, recorder));
        let all_is_reflected = transmission.as_ref().is_some_and(|optics| optics.refracted.is_none());
        let extra = if all_is_reflected { material.transparency } else { 0.0 };
        let share = material.reflectivity + extra;
        if share > 0.0 {
            let mirrored = reflect(ray.direction, surface.n_shading);
            recorder.note(|| describe_reflection(ray, surface, mirrored, share));
            let media = ray.media.clone();
            components.reflected = self.spawn(ray, surface, RayKind::Reflected, mirrored, share, media, recorder);
        }
        if let Some(direction) = transmission.and_then(|optics| optics.refracted) {
            let media = crossing.media_after.clone();
            let share = material.transparency;
            components.transmitted = self.spawn(ray, surface, RayKind::Refracted, direction, share, media, recorder);
        }
    }

    /// Goes on behind a boundary that lies inside a medium which wins over it.
    pub(super) fn pass_straight_through<R: Recorder>(
        &self,
        ray: &Ray,
        surface: &Surface,
        crossing: &MediaCrossing,
        recorder: &mut R,
    ) -> Rgb {
        let media = crossing.media_after.clone();
        self.spawn(ray, surface, RayKind::Refracted, ray.direction, 1.0, media, recorder)
    }

    fn bend(&self, ray: &Ray, surface: &Surface, crossing: &MediaCrossing, recorder: &mut impl Recorder) -> Optics {
        let n1 = self.index_of_refraction(crossing.before);
        let n2 = self.index_of_refraction(crossing.after);
        let optics = refract(ray.direction, surface.n_shading, n1, n2);
        recorder.note(|| snell_entry(ray.direction, surface.n_shading, n1, n2, &optics));
        optics
    }

    /// Sends a ray from the surface and returns its colour times `share`, or black where a limit stops it.
    #[expect(clippy::too_many_arguments, reason = "each is a different fact about the new ray")]
    fn spawn<R: Recorder>(
        &self,
        parent: &Ray,
        surface: &Surface,
        kind: RayKind,
        direction: DVec3,
        share: f64,
        media: MediaStack,
        recorder: &mut R,
    ) -> Rgb {
        let ray = Ray {
            kind,
            origin: surface.point,
            direction,
            depth: parent.depth + 1,
            weight: parent.weight * share,
            departure: Some(Departure::new(surface, parent.direction, direction)),
            media,
        };
        if self.stopped_by_a_limit(&ray, recorder) {
            return Rgb::ZERO;
        }
        recorder.begin();
        let colour = self.trace(ray.clone(), recorder) * share;
        recorder.end(|| self.describe_ray(&ray));
        colour
    }

    fn stopped_by_a_limit(&self, ray: &Ray, recorder: &mut impl Recorder) -> bool {
        let limits = self.scene.limits;
        let (limit, at, value) = if ray.depth > limits.depth {
            ("depth", f64::from(limits.depth), f64::from(ray.depth))
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

fn describe_reflection(ray: &Ray, surface: &Surface, mirrored: DVec3, share: f64) -> Entry {
    let bindings = [("dir", ray.direction.to_array().into()), ("m", surface.n_shading.to_array().into())];
    Entry::new(What::Reflection { direction: mirrored.to_array(), share }).line(
        "r",
        "dir − 2 (dir · m) m",
        &bindings,
        mirrored.to_array(),
    )
}
