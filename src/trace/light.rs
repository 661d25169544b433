//! The ambient, diffuse and specular terms, and the shadow rays that they ask for.

use super::closest::Surface;
use super::departure::{Ahead, Departure};
use super::finish::Finish;
use super::highlight::Highlight;
use super::ray::{Components, Ray, Tracer};
use crate::record::{Counter, Effect, Entry, RayKind, Recorder, What};
use crate::scene::{Light, LightKind, Object, Rgb};
use glam::DVec3;
use smallvec::SmallVec;

/// Where a shadow ray starts.
pub(super) struct Start<'a> {
    /// The ray that came to this point.
    pub ray: &'a Ray,
    /// The point.
    pub origin: DVec3,
    /// The boundary that the point lies on, if it lies on one.
    pub departure: Option<Departure>,
}

/// The way to a light.
pub(super) struct Way {
    /// From the point to the light; t = 1 at a point light, without end for a directional one.
    pub direction: DVec3,
    /// Unit.
    pub towards: DVec3,
    /// The hit time beyond which nothing is in the way.
    pub limit: f64,
    /// The light, by its place in the list.
    pub light: usize,
}

impl Way {
    pub fn new(lights: &[Light], light: usize, point: DVec3, _place: [f64; 2]) -> Self {
        match lights[light].kind {
            LightKind::Point(position) => {
                let direction = position - point;
                Self { direction, towards: direction.normalize_or_zero(), limit: 1.0, light }
            }
            LightKind::Area(_) => Self { direction: DVec3::Z, towards: DVec3::Z, limit: 1.0, light },
            LightKind::Directional(towards) => Self { direction: towards, towards, limit: f64::INFINITY, light },
        }
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

impl Tracer<'_> {
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
        for index in 0..self.scene.lights.len() {
            let [diffuse, specular] = self.light(ray, surface, finish, index, recorder);
            components.diffuse += diffuse;
            components.specular += specular;
        }
    }

    /// Diffuse and specular term of one light: I k_d max(0, n·l) and I k_s max(0, r·v)^f, r being l mirrored at n.
    fn light<R: Recorder>(
        &self,
        ray: &Ray,
        surface: &Surface,
        finish: &Finish,
        index: usize,
        recorder: &mut R,
    ) -> [Rgb; 2] {
        recorder.begin();
        let light = &self.scene.lights[index];
        let way = Way::new(&self.scene.lights, index, surface.point, [0.5; 2]);
        let n_dot_l = surface.n_shading.dot(way.towards);
        let share = if n_dot_l > 0.0 { {
            let departure = Some(Departure::new(surface, ray.direction, way.direction));
            self.arriving(&Start { ray, origin: surface.point, departure }, &way, recorder)
        } } else { Rgb::ZERO };
        let arriving = light.colour * share;
        let material = finish.material;
        let diffuse = arriving * finish.diffuse * n_dot_l.max(0.0);
        let eye = || -ray.direction.normalize();
        // A root, a quotient and a power are dear, and 0 times them is 0.
        let is_lit = share != Rgb::ZERO && material.specular != Rgb::ZERO;
        let highlight = (is_lit || R::RECORDING).then(|| Highlight::new(finish, surface.n_shading, way.towards, eye()));
        let specular = highlight.as_ref().map_or(Rgb::ZERO, |h| arriving * material.specular * h.value());
        recorder.end(|| {
            let distance = matches!(light.kind, LightKind::Point(_)).then(|| way.direction.length());
            let bindings = [
                ("I_l", arriving.to_array().into()),
                ("k_d", finish.diffuse.to_array().into()),
                ("k_s", material.specular.to_array().into()),
                ("n", surface.n_shading.to_array().into()),
                ("l", way.towards.to_array().into()),
                ("n_l", n_dot_l.max(0.0).into()),
            ];
            let entry = Entry::new(What::Light {
                name: light.name.clone(),
                towards: way.towards.to_array(),
                distance,
                arriving: arriving.to_array(),
                diffuse: diffuse.to_array(),
                specular: specular.to_array(),
            });
            let entry = entry.line("n·l", "n · l", &bindings, n_dot_l);
            let terms = [diffuse, specular];
            match &highlight {
                Some(highlight) => highlight.lines(entry, &bindings, terms),
                None => entry,
            }
        });
        [diffuse, specular]
    }

    /// The share of a light that arrives, by colour: a shadow ray, stopped by the first opaque object. Each surface
    /// of a transparent object passes its transparency, as it does for a ray from the eye; shadow rays are not bent.
    pub(super) fn arriving<R: Recorder>(&self, start: &Start, way: &Way, recorder: &mut R) -> Rgb {
        let Start { ray, origin, departure } = *start;
        let shadow = Ray {
            kind: RayKind::Shadow,
            origin,
            direction: way.direction,
            depth: ray.depth + 1,
            weight: ray.weight,
            budget: 0,
            departure,
            media: ray.media.clone(),
            place: None,
            beam: None,
            wavelength: ray.wavelength,
            turns: ray.turns,
            stream: ray.stream,
        };
        recorder.count(Counter::Call(Effect::Shadows));
        recorder.count(Counter::Sent(Effect::Shadows));
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
            let ahead = shadow.ahead(index, self.scene, &list);
            ahead.report(object, recorder);
            share *= self.passed(shadow, object, &ahead, limit, recorder);
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
        object: &Object,
        ahead: &Ahead,
        limit: f64,
        recorder: &mut R,
    ) -> f64 {
        let mut share = 1.0;
        for boundary in ahead.surfaces(limit) {
            let t = boundary.map_or(0.0, |boundary| boundary.t);
            let material = boundary.map_or(object.leaf_materials[0], |boundary| {
                object.material_at(boundary, shadow.origin + shadow.direction * t).0
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
