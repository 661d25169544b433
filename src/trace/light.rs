//! The ambient, diffuse and specular terms.

use super::calls::Repertoire;
use super::closest::Surface;
use super::finish::Finish;
use super::highlight::Highlight;
use super::ray::{Components, Ray, Tracer};
use super::shadow::{Start, Way};
use crate::record::{Binding, Effect, Entry, Recorder, What};
use crate::scene::{LightKind, Rgb};

/// A place on a surface that is to be shaded.
pub(super) struct Shaded<'a> {
    pub ray: &'a Ray,
    pub surface: &'a Surface,
    pub finish: &'a Finish<'a>,
}

/// What one light, or one point of it, adds.
pub(super) struct Terms {
    /// The cosine between the normal and the direction to the light.
    n_dot_l: f64,
    /// The share of the light that arrives.
    pub share: Rgb,
    /// The light that arrives.
    arriving: Rgb,
    pub diffuse: Rgb,
    pub specular: Rgb,
    highlight: Option<Highlight>,
}

impl<E: Repertoire> Tracer<'_, E> {
    /// Adds the terms that come straight from the lights.
    pub(super) fn add_lights<R: Recorder>(
        &self,
        ray: &Ray,
        surface: &Surface,
        finish: &Finish,
        components: &mut Components,
        recorder: &mut R,
    ) {
        components.ambient = finish.ambient * self.scene.ambient;
        recorder.note(|| {
            let bindings = [("k_a", finish.ambient.to_array().into()), ("I_a", self.scene.ambient.to_array().into())];
            Entry::new(What::Ambient { colour: components.ambient.to_array() }).line(
                "I_amb",
                "k_a I_a",
                &bindings,
                components.ambient.to_array(),
            )
        });
        let place = Shaded { ray, surface, finish };
        for (index, light) in self.scene.lights.iter().enumerate() {
            let [diffuse, specular] = match light.kind {
                LightKind::Area(area) if self.calls_for(Effect::SoftShadows) => {
                    self.area_light(&place, index, area, recorder)
                }
                _ => self.light(&place, index, recorder),
            };
            components.diffuse += diffuse;
            components.specular += specular;
        }
    }

    /// Diffuse and specular term of one light that is a point or a direction.
    #[inline(always)]
    fn light<R: Recorder>(&self, place: &Shaded, index: usize, recorder: &mut R) -> [Rgb; 2] {
        recorder.begin();
        let light = &self.scene.lights[index];
        let way = match light.kind {
            LightKind::Area(area) => Way::to_point(index, area.middle() - place.surface.point, Effect::Shadows),
            _ => Way::new(&self.scene.lights, index, place.surface.point, MIDDLE),
        };
        let terms = self.terms(place, &way, recorder);
        recorder.end(|| {
            let distance = matches!(light.kind, LightKind::Point(_)).then(|| way.direction.length());
            let entry = Entry::new(What::Light {
                name: light.name.clone(),
                towards: way.towards.to_array(),
                distance,
                arriving: terms.arriving.to_array(),
                diffuse: terms.diffuse.to_array(),
                specular: terms.specular.to_array(),
            });
            terms.lines(entry, place, &way)
        });
        [terms.diffuse, terms.specular]
    }

    /// What arrives on one way: I k_d max(0, n·l) and I k_s max(0, r·v)^f, r being l mirrored at n.
    #[inline(always)]
    pub(super) fn terms<R: Recorder>(&self, place: &Shaded, way: &Way, recorder: &mut R) -> Terms {
        let Shaded { ray, surface, finish } = *place;
        let n_dot_l = surface.n_shading.dot(way.towards);
        let share = if n_dot_l > 0.0 {
            self.arriving(&Start { ray, origin: surface.point, surface: Some(surface) }, way, recorder)
        } else {
            Rgb::ZERO
        };
        let arriving = self.scene.lights[way.light].colour * share;
        let material = finish.material;
        let diffuse = arriving * finish.diffuse * n_dot_l.max(0.0);
        let eye = || -ray.direction.normalize();
        // A root, a quotient and a power are dear, and 0 times them is 0.
        let is_lit = share != Rgb::ZERO && material.specular != Rgb::ZERO;
        let highlight = (is_lit || R::RECORDING).then(|| Highlight::new(finish, surface.n_shading, way.towards, eye()));
        let specular = highlight.as_ref().map_or(Rgb::ZERO, |h| arriving * material.specular * h.value());
        Terms { n_dot_l, share, arriving, diffuse, specular, highlight }
    }
}

/// Where a light that has no size is asked.
const MIDDLE: [f64; 2] = [0.5; 2];

impl Terms {
    /// Adds their working to their description.
    pub fn lines(&self, entry: Entry, place: &Shaded, way: &Way) -> Entry {
        let Shaded { surface, finish, .. } = *place;
        let bindings: [Binding; 6] = [
            ("I_l", self.arriving.to_array().into()),
            ("k_d", finish.diffuse.to_array().into()),
            ("k_s", finish.material.specular.to_array().into()),
            ("n", surface.n_shading.to_array().into()),
            ("l", way.towards.to_array().into()),
            ("n_l", self.n_dot_l.max(0.0).into()),
        ];
        let entry = entry.line("n·l", "n · l", &bindings, self.n_dot_l);
        match &self.highlight {
            Some(highlight) => highlight.lines(entry, &bindings, [self.diffuse, self.specular]),
            None => entry,
        }
    }
}
