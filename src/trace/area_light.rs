//! Lights that have a size: shadow rays to several of their points, so that a surface may see a light in part.

use super::calls::Repertoire;
use super::light::Shaded;
use super::ray::Tracer;
use super::shadow::Way;
use crate::record::{Entry, LightSample, Recorder, What};
use crate::sample::Purpose;
use crate::scene::{Area, Rgb};

/// The sums over the points of a light.
#[derive(Default)]
struct Sums {
    arriving: Rgb,
    diffuse: Rgb,
    specular: Rgb,
}

impl<E: Repertoire> Tracer<'_, E> {
    /// Diffuse and specular term of a light that has a size: the means over its points.
    #[inline(never)]
    pub(super) fn area_light<R: Recorder>(
        &self,
        place: &Shaded,
        index: usize,
        area: Area,
        recorder: &mut R,
    ) -> [Rgb; 2] {
        recorder.begin();
        let light = &self.scene.lights[index];
        let mut sums = Sums::default();
        for number in 0..light.samples {
            self.light_sample(place, index, number, &mut sums, recorder);
        }
        let count = f64::from(light.samples);
        let [arriving, diffuse, specular] = [sums.arriving, sums.diffuse, sums.specular].map(|sum| sum / count);
        recorder.end(|| {
            let to_middle = area.middle() - place.surface.point;
            let bindings = [
                ("S_diff", sums.diffuse.to_array().into()),
                ("S_spec", sums.specular.to_array().into()),
                ("n", count.into()),
            ];
            Entry::new(What::Light {
                name: light.name.clone(),
                towards: to_middle.normalize_or_zero().to_array(),
                distance: Some(to_middle.length()),
                arriving: arriving.to_array(),
                diffuse: diffuse.to_array(),
                specular: specular.to_array(),
            })
            .line("I_diff", "S_diff / n", &bindings, diffuse.to_array())
            .line("I_spec", "S_spec / n", &bindings, specular.to_array())
        });
        [diffuse, specular]
    }

    /// Adds what one point of a light gives.
    fn light_sample<R: Recorder>(&self, place: &Shaded, index: usize, number: u32, sums: &mut Sums, recorder: &mut R) {
        recorder.begin();
        let light = &self.scene.lights[index];
        let purpose = Purpose::Light(u32::try_from(index).unwrap_or(u32::MAX));
        let at = place.ray.stream.part(number, light.samples).square(purpose);
        let way = Way::new(&self.scene.lights, index, place.surface.point, at);
        let terms = self.terms(place, &way, recorder);
        sums.arriving += light.colour * terms.share;
        sums.diffuse += terms.diffuse;
        sums.specular += terms.specular;
        recorder.end(|| {
            let entry = Entry::new(What::LightSample(LightSample {
                shape: light.kind.name().to_owned(),
                number,
                of: light.samples,
                at,
                point: (place.surface.point + way.direction).to_array(),
                towards: way.towards.to_array(),
                distance: way.direction.length(),
                arriving: terms.share.to_array(),
                diffuse: terms.diffuse.to_array(),
                specular: terms.specular.to_array(),
            }));
            terms.lines(entry, place, &way)
        });
    }
}
