//! How a ray's light divides at a surface into what is mirrored and what goes through: by fixed weights or by Fresnel's
//! equations, for all wavelengths at once or, where light is taken apart, for each by itself.
//!
//! **Wavelengths.** White light that meets a dispersive medium for the first time is taken apart into wavelengths, each of
//! which stands for the band about it. What is mirrored is not bent and stays together: its share is the sum of what is
//! mirrored of every band, so that nothing is lost. A ray of one wavelength is never taken apart again.
//!
//! **Surfaces without an inside.** Varnish on an opaque object, and glass that has no thickness, mirror by the index of their
//! material against the medium outside; what goes through them is not bent.

use super::calls::Repertoire;
use super::media::MediaCrossing;
use super::ray::{Ray, Tracer};
use super::spawn::Meeting;
use crate::optics::{
    Band, Dispersion, Optics, bands, conductor_entry, incidence, index_lines, metal_reflectance, refract, snell_entry,
    wavelength_entry,
};
use crate::record::{Effect, Entry, Recorder, Value};
use crate::sample::Purpose;
use crate::scene::{Rgb, Split};
use glam::DVec3;
use smallvec::{SmallVec, smallvec};

/// What becomes of a ray's light.
pub(super) struct Division {
    /// The share that is mirrored, by colour.
    pub mirrored: Rgb,
    /// What the working of that share calls it; none where the material says it.
    pub name: Option<&'static str>,
    /// What goes through.
    pub through: SmallVec<[Through; 1]>,
}

/// Light that goes through a surface.
pub(super) struct Through {
    pub direction: DVec3,
    /// The indices of refraction on the two sides.
    pub indices: [f64; 2],
    /// Its share, by colour.
    pub share: Rgb,
    /// Its wavelength in nanometres, where it has one.
    pub wavelength: Option<f64>,
}

/// What decides how much is mirrored and how much goes through, with the effects that the scene calls for.
#[derive(Clone, Copy)]
struct Weights {
    reflectivity: f64,
    transparency: f64,
    fresnel: bool,
}

impl Weights {
    /// The shares that are mirrored, beyond the reflectivity, and that go through.
    fn shares(self, optics: &Optics) -> [f64; 2] {
        if self.fresnel {
            let reflectance = optics.reflectance();
            return [reflectance, (1.0 - reflectance) * self.transparency];
        }
        if optics.refracted.is_none() { [self.transparency, 0.0] } else { [0.0, self.transparency] }
    }

    /// Adds the working of these shares; `mirrored` is what other wavelengths have had mirrored before this one.
    fn lines(self, entry: Entry, optics: &Optics, one: Option<(&Band, Rgb)>) -> Entry {
        let [mirrored, through] = self.shares(optics);
        let known = [("R", Value::Number(optics.reflectance())), ("k_t", self.transparency.into())];
        let entry = if self.fresnel {
            entry.line("T", "(1 − R) k_t", &known, through)
        } else if one.is_some() {
            entry.line("T", if optics.refracted.is_some() { "k_t" } else { "0" }, &known, through)
        } else {
            entry
        };
        let Some((band, before)) = one else { return entry };
        let share = [("S", Value::Vector(band.share.to_array())), ("T", through.into())];
        let sum = [
            ("M_before", Value::Vector(before.to_array())),
            ("S", band.share.to_array().into()),
            ("R", mirrored.into()),
            ("k_t", mirrored.into()),
        ];
        let formula = match (self.fresnel, optics.refracted) {
            (true, _) => "M_before + S R",
            (false, None) => "M_before + S k_t",
            (false, Some(_)) => "M_before",
        };
        entry.line("share through", "S T", &share, (band.share * through).to_array()).line(
            "M, mirrored up to here",
            formula,
            &sum,
            (before + band.share * mirrored).to_array(),
        )
    }
}

impl<E: Repertoire> Tracer<'_, E> {
    /// What becomes of a ray's light where it meets a surface.
    pub(super) fn divide<R: Recorder>(
        &self,
        ray: &Ray,
        meeting: &Meeting,
        crossing: &MediaCrossing,
        recorder: &mut R,
    ) -> Division {
        let material = meeting.material;
        let weigh = |weight: f64, effect| if weight > 0.0 && self.calls_for(effect) { weight } else { 0.0 };
        let split = if self.calls_for(Effect::Fresnel) { material.split } else { Split::Weights };
        if let Split::Conductor { eta, k } = split {
            return self.divide_at_metal(ray, meeting, crossing, [eta, k], recorder);
        }
        let weights = Weights {
            reflectivity: weigh(material.reflectivity, Effect::Reflection),
            transparency: weigh(material.transparency, Effect::Refraction),
            fresnel: split == Split::Dielectric,
        };
        if weights.fresnel {
            Self::enter(Effect::Fresnel, recorder);
            if weights.transparency == 0.0 || crossing.before == crossing.after {
                return self.divide_at_varnish(ray, meeting, crossing, weights, recorder);
            }
        }
        if weights.transparency == 0.0 {
            return Division { mirrored: Rgb::splat(weights.reflectivity), name: None, through: SmallVec::new() };
        }
        if self.calls_for(Effect::Dispersion) && ray.wavelength.is_none() && self.is_dispersive(crossing) {
            Self::enter(Effect::Dispersion, recorder);
            return self.divide_by_wavelength(ray, meeting, crossing, weights, recorder);
        }
        self.divide_together(ray, meeting, crossing, weights, recorder)
    }

    /// Where all of the ray's light goes the same ways.
    fn divide_together<R: Recorder>(
        &self,
        ray: &Ray,
        meeting: &Meeting,
        crossing: &MediaCrossing,
        weights: Weights,
        recorder: &mut R,
    ) -> Division {
        let indices = self.indices(crossing, ray.wavelength);
        let optics = refract(ray.direction, meeting.surface.n_shading, indices[0], indices[1]);
        recorder.note(|| {
            let mut entry = snell_entry(ray.direction, meeting.surface.n_shading, indices[0], indices[1], &optics);
            if let Some(nanometres) = ray.wavelength {
                // The indices come before what is made of them.
                let lines = entry.working.len();
                entry = index_lines(entry, nanometres, self.dispersions(crossing));
                entry.working.rotate_left(lines);
            }
            weights.lines(entry, &optics, None)
        });
        let [mirrored, through] = weights.shares(&optics);
        let share = Rgb::splat(through);
        let passes = optics.refracted.filter(|_| through > 0.0);
        let through = passes.map(|direction| Through { direction, indices, share, wavelength: ray.wavelength });
        Division {
            mirrored: Rgb::splat(if weights.fresnel { mirrored } else { weights.reflectivity + mirrored }),
            name: weights.fresnel.then_some("R"),
            through: through.into_iter().collect(),
        }
    }

    /// Where light is taken apart.
    fn divide_by_wavelength<R: Recorder>(
        &self,
        ray: &Ray,
        meeting: &Meeting,
        crossing: &MediaCrossing,
        weights: Weights,
        recorder: &mut R,
    ) -> Division {
        let sampling = self.scene.sampling;
        let offset = if sampling.is_many() { ray.stream.number(Purpose::Wavelength) } else { 0.5 };
        let normal = meeting.surface.n_shading;
        let mut mirrored = Rgb::splat(if weights.fresnel { 0.0 } else { weights.reflectivity });
        let mut through = SmallVec::new();
        for band in bands(sampling.wavelengths, offset) {
            let wavelength = Some(band.nanometres);
            let indices = self.indices(crossing, wavelength);
            let optics = refract(ray.direction, normal, indices[0], indices[1]);
            recorder.note(|| {
                let sides = (indices, self.dispersions(crossing));
                let entry = wavelength_entry([ray.direction, normal], (&band, offset), sides, &optics);
                weights.lines(entry, &optics, Some((&band, mirrored)))
            });
            let [back, on] = weights.shares(&optics);
            mirrored += band.share * back;
            if let Some(direction) = optics.refracted.filter(|_| on > 0.0) {
                through.push(Through { direction, indices, share: band.share * on, wavelength });
            }
        }
        Division { mirrored, name: Some("M"), through }
    }

    /// Where nothing behind the surface has an index of its own.
    fn divide_at_varnish<R: Recorder>(
        &self,
        ray: &Ray,
        meeting: &Meeting,
        crossing: &MediaCrossing,
        weights: Weights,
        recorder: &mut R,
    ) -> Division {
        let n1 = self.index_of_refraction(crossing.before, ray.wavelength);
        let n2 = meeting.material.index_at(ray.wavelength);
        let optics = refract(ray.direction, meeting.surface.n_shading, n1, n2);
        recorder.note(|| {
            let entry = snell_entry(ray.direction, meeting.surface.n_shading, n1, n2, &optics);
            weights.lines(entry, &optics, None)
        });
        let [mirrored, through] = weights.shares(&optics);
        let share = Rgb::splat(through);
        let straight_on =
            Through { direction: ray.direction.normalize(), indices: [n1, n1], share, wavelength: ray.wavelength };
        Division {
            mirrored: Rgb::splat(mirrored),
            name: Some("R"),
            through: if through > 0.0 { smallvec![straight_on] } else { SmallVec::new() },
        }
    }

    /// Where a metal mirrors each colour by another share and lets nothing through.
    fn divide_at_metal<R: Recorder>(
        &self,
        ray: &Ray,
        meeting: &Meeting,
        crossing: &MediaCrossing,
        [eta, k]: [Rgb; 2],
        recorder: &mut R,
    ) -> Division {
        Self::enter(Effect::Fresnel, recorder);
        let n1 = self.index_of_refraction(crossing.before, ray.wavelength);
        let vectors = [ray.direction, meeting.surface.n_shading];
        let mirrored = metal_reflectance(incidence(vectors[0], vectors[1]), n1, eta, k);
        recorder.note(|| conductor_entry(vectors, n1, eta, k, mirrored));
        Division { mirrored, name: Some("R"), through: SmallVec::new() }
    }

    fn indices(&self, crossing: &MediaCrossing, wavelength: Option<f64>) -> [f64; 2] {
        [crossing.before, crossing.after].map(|medium| self.index_of_refraction(medium, wavelength))
    }

    fn is_dispersive(&self, crossing: &MediaCrossing) -> bool {
        crossing.before != crossing.after && self.dispersions(crossing).iter().any(Option::is_some)
    }

    /// How the indices of the two sides depend on the wavelength; none where they do not.
    fn dispersions(&self, crossing: &MediaCrossing) -> [Option<&Dispersion>; 2] {
        [crossing.before, crossing.after].map(|medium| {
            let object = &self.scene.objects[medium?];
            self.scene.materials[object.material].dispersion.as_ref()
        })
    }
}
