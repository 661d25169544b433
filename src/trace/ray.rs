//! A ray and the one function that finds the colour that it brings back.

use super::beam::Beam;
use super::calls::{Every, Opaque, Repertoire};
use super::closest::Surface;
use super::departure::{Ahead, Departure};
use super::path::Answer;
use super::spawn::Meeting;
use crate::csg::{Course, IntervalList, Solid};
use crate::optics::MediaStack;
use crate::record::{Counter, Effect, Entry, RayKind, Recorder, What};
use crate::sample::Stream;
use crate::scene::{Glance, Rgb, Scene, Shortcuts, Sights};
use glam::DVec3;
use std::marker::PhantomData;

/// A ray P(t) = origin + direction t in world space.
#[derive(Clone, Debug)]
pub struct Ray {
    /// Why it was sent.
    pub kind: RayKind,
    /// Where it starts.
    pub origin: DVec3,
    /// Where it goes; any length but zero.
    pub direction: DVec3,
    /// How many rays it is away from the camera ray.
    pub depth: u32,
    /// The share of its colour in the pixel.
    pub weight: f64,
    /// How many rays it may spawn in all, those of its descendants among them.
    pub budget: u32,
    /// The boundary that it started on.
    pub departure: Option<Departure>,
    /// The transparent objects that it is inside.
    pub media: MediaStack,
    /// Where it passes the image plane, if it comes from the eye.
    pub place: Option<Glance>,
    /// The rays through its pixel's corners, where the scene calls for them.
    pub beam: Option<Box<Beam>>,
    /// The one wavelength that it has, in nanometres, once it has met a dispersive surface; none for light of all of them.
    pub wavelength: Option<f64>,
    /// What its colour counts, by colour and up to a factor.
    pub tint: Rgb,
    /// How often its path was turned in a medium.
    pub turns: u32,
    /// Its random numbers.
    pub stream: Stream,
}

/// Rays that a pixel may spawn before chance chooses between them. Depth alone does not bound them: where each ray spawns two,
/// every level doubles them. Fewer would leave noise in what can be seen in glass within mirrors; more would let one pixel take
/// minutes.
pub(super) const MOST_RAYS: u32 = 1 << 16;

/// How often a path may be turned in media. Fewer would darken thick clouds that absorb nothing, from which half of the light
/// comes after dozens of turns; more would cost time for what can hardly be seen.
pub(super) const MOST_TURNS: u32 = 64;

/// Bytes of the stack that have to be left for a ray. With optimisation it takes between 6,000 and 8,000 before it spawns the
/// next one; all else is room for nested solids, for solvers with many digits, and for code without optimisation.
const LEAST_STACK: usize = 1 << 19;

/// Bytes that the stack grows by. Less would let deep trees ask for memory more often; more would be unused in shallow ones.
const MORE_STACK: usize = 1 << 21;

impl Ray {
    /// A ray from the eye, in air.
    #[must_use]
    pub fn camera(origin: DVec3, direction: DVec3) -> Self {
        let (departure, media, place) = (None, MediaStack::default(), None);
        Self {
            kind: RayKind::Camera,
            origin,
            direction,
            depth: 0,
            weight: 1.0,
            budget: MOST_RAYS,
            departure,
            media,
            place,
            beam: None,
            wavelength: None,
            tint: Rgb::ONE,
            turns: 0,
            stream: Stream::default(),
        }
    }

    /// Whether the ray has left a convex object for good, so that nothing of it can lie ahead.
    pub(super) fn leaves_for_good(&self, index: usize, solid: &Solid) -> bool {
        self.departure.is_some_and(|departure| departure.object == index && departure.is_for_good(solid))
    }
}

/// Traces rays through a scene, with code for the effects of a repertoire.
#[derive(Clone, Copy, Debug)]
pub struct Tracer<'a, E = Every> {
    /// The scene.
    pub scene: &'a Scene,
    /// What the eye and the lights see, if that was worked out.
    pub(super) sights: Option<&'a Sights>,
    repertoire: PhantomData<E>,
}

/// The five components of the light that a ray brings back: I = I_amb + I_diff + I_spec + I_refl + I_tran (§ 6.4).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Components {
    pub ambient: Rgb,
    pub diffuse: Rgb,
    pub specular: Rgb,
    pub reflected: Rgb,
    pub transmitted: Rgb,
}

impl Components {
    pub fn total(&self) -> Rgb {
        self.ambient + self.diffuse + self.specular + self.reflected + self.transmitted
    }

    pub fn describe(&self) -> Entry {
        Entry::new(What::Colour {
            ambient: self.ambient.to_array(),
            diffuse: self.diffuse.to_array(),
            specular: self.specular.to_array(),
            reflected: self.reflected.to_array(),
            transmitted: self.transmitted.to_array(),
            total: self.total().to_array(),
        })
        .line(
            "I",
            "I_amb + I_diff + I_spec + I_refl + I_tran",
            &[
                ("I_amb", self.ambient.to_array().into()),
                ("I_diff", self.diffuse.to_array().into()),
                ("I_spec", self.specular.to_array().into()),
                ("I_refl", self.reflected.to_array().into()),
                ("I_tran", self.transmitted.to_array().into()),
            ],
            self.total().to_array(),
        )
    }
}

impl<'a> Tracer<'a> {
    /// A tracer of this scene, for whatever it calls for.
    #[must_use]
    pub const fn new(scene: &'a Scene) -> Self {
        Self { scene, sights: None, repertoire: PhantomData }
    }

    /// The same tracer, for many rays: it looks up what the eye and the lights see.
    #[must_use]
    pub const fn with_sights(self, sights: &'a Sights) -> Self {
        Self { sights: Some(sights), ..self }
    }

    /// The same tracer without code for anything but opaque objects in plain colours; none where the scene has others.
    #[inline]
    pub(super) const fn opaque(&self) -> Option<Tracer<'a, Opaque>> {
        let Self { scene, sights, .. } = *self;
        if scene.effects.are_within(Opaque::EFFECTS) && scene.index.all_opaque {
            Some(Tracer { scene, sights, repertoire: PhantomData })
        } else {
            None
        }
    }
}

impl<'a, E: Repertoire> Tracer<'a, E> {
    /// The colour that comes back along the ray: steps 2 to 5 of § 6.1, for camera rays and for spawned ones alike.
    pub fn trace<R: Recorder>(&self, ray: &Ray, recorder: &mut R) -> Rgb {
        let mut surface = self.meet(ray, recorder);
        step(ray, 5, recorder, |recorder| {
            let answer = self.see_along(ray, surface.as_mut(), recorder);
            self.colour_of(answer, recorder)
        })
    }

    /// The same for a ray that another one has spawned and waits for: where the stack runs short, with a new piece of it.
    pub(super) fn trace_spawned<R: Recorder>(&self, ray: &Ray, recorder: &mut R) -> Rgb {
        stacker::maybe_grow(LEAST_STACK, MORE_STACK, || self.trace(ray, recorder))
    }

    /// What becomes of a ray that another one has handed over.
    pub(super) fn answer<R: Recorder>(&self, ray: &Ray, recorder: &mut R) -> Answer<'a> {
        let mut surface = self.meet(ray, recorder);
        self.see_along(ray, surface.as_mut(), recorder)
    }

    /// Steps 2 to 4: the surface that the ray meets first.
    #[inline(always)]
    fn meet<R: Recorder>(&self, ray: &Ray, recorder: &mut R) -> Option<Surface> {
        recorder.count(Counter::Ray(ray.kind));
        let closest = if R::RECORDING {
            let found = step(ray, 2, recorder, |recorder| self.find_all_intersections(ray, recorder));
            step(ray, 3, recorder, |recorder| self.find_closest_in_front(ray, &found, recorder))
        } else {
            self.nearest(ray, recorder)
        };
        step(ray, 4, recorder, |recorder| {
            closest.as_ref().map(|closest| self.compute_hit_point(ray, closest, recorder))
        })
    }

    /// Step 5: the light that comes back along the ray.
    #[inline(always)]
    fn see_along<R: Recorder>(&self, ray: &Ray, surface: Option<&mut Surface>, recorder: &mut R) -> Answer<'a> {
        match self.filling(ray) {
            None => self.see(ray, surface, recorder),
            Some(filling) => self.see_through(ray, filling, surface, recorder),
        }
    }

    /// The light that comes from where the ray ends.
    #[inline(always)]
    pub(super) fn see<R: Recorder>(&self, ray: &Ray, surface: Option<&mut Surface>, recorder: &mut R) -> Answer<'a> {
        match surface {
            Some(surface) => self.find_colour(ray, surface, recorder),
            None => Answer::Colour(self.see_background(ray, recorder)),
        }
    }

    /// Which of an object's boundaries along the ray count.
    pub(super) fn ahead(&self, ray: &Ray, index: usize, list: &IntervalList) -> Ahead {
        let solid = &self.scene.objects[index].solid;
        let line = [ray.origin, ray.direction];
        let list_from = |origin| solid.inside_by(self.scene.solving, origin, ray.direction);
        match ray.departure {
            Some(departure) if departure.object == index => departure.ahead(solid, line, list, list_from),
            Some(departure) if self.may_touch(departure.object, index) => {
                departure.ahead_in_neighbour(solid, line, list, ray.media.contains(index), list_from)
            }
            _ => Ahead::of(list),
        }
    }

    /// Whether the ray starts on the object, or on one that may share a boundary with it.
    #[inline]
    pub(super) fn starts_at(&self, ray: &Ray, object: usize) -> bool {
        let touches = |departed: usize| departed == object || self.may_touch(departed, object);
        ray.departure.is_some_and(|departure| touches(departure.object))
    }

    /// Whether two transparent objects may share a boundary.
    #[inline]
    fn may_touch(&self, one: usize, other: usize) -> bool {
        E::TRANSPARENCY && self.scene.index.touching[one].contains(&other)
    }

    /// A ray from the eye, in the media that the eye is inside.
    #[must_use]
    pub fn camera_ray(&self, origin: DVec3, direction: DVec3) -> Ray {
        Ray { media: self.media_around(origin, direction), ..Ray::camera(origin, direction) }
    }

    /// The ray, ready to be tested against the boxes of all objects.
    pub(super) fn course(&self, ray: &Ray) -> Course {
        let Shortcuts { boxes, balls, hierarchy, .. } = self.scene.shortcuts;
        Course::new(ray.origin, ray.direction, self.scene.index.skew)
            .testing_boxes(boxes)
            .testing_balls(balls)
            .using_hierarchies(hierarchy)
            .solving(self.scene.solving)
    }

    /// Step 5 where nothing is hit.
    fn see_background(&self, ray: &Ray, recorder: &mut impl Recorder) -> Rgb {
        let background = if self.calls_for(Effect::Environment) {
            self.see_environment(ray.direction, ray.beam.as_deref(), recorder)
        } else {
            self.scene.background
        };
        recorder.note(|| Entry::new(What::Nothing { background: background.to_array() }));
        background
    }

    /// The light from infinitely far away, against `direction`; the background where the scene has no environment.
    #[inline(never)]
    pub(super) fn see_environment<R: Recorder>(&self, direction: DVec3, beam: Option<&Beam>, recorder: &mut R) -> Rgb {
        let environment = self.scene.environment.as_ref().filter(|_| self.calls_for(Effect::Environment));
        let Some(environment) = environment else { return self.scene.background };
        Self::enter(Effect::Environment, recorder);
        let corners = beam.filter(|_| environment.averaged).map(Beam::directions);
        environment.map.towards(direction, corners, recorder)
    }

    /// Step 5: the colour of the light that returns along the ray from the hit point.
    #[inline(always)]
    fn find_colour<R: Recorder>(&self, ray: &Ray, surface: &mut Surface, recorder: &mut R) -> Answer<'a> {
        let crossing = self.cross_media(ray, surface, recorder);
        self.report_overlaps(ray, surface, &crossing, recorder);
        let mut components = Components::default();
        let onward = if crossing.hidden {
            self.pass_straight_through(ray, surface, &crossing, &mut components, recorder)
        } else {
            let corners = self.corners(ray, surface);
            let finish = self.finish(surface, corners.as_deref(), recorder);
            self.add_lights(ray, surface, &finish, &mut components, recorder);
            let meeting = Meeting { surface, material: finish.material, corners };
            self.add_spawned(ray, &meeting, &crossing, &mut components, recorder)
        };
        if let Some(onward) = onward {
            return Answer::Onward(onward);
        }
        recorder.note(|| components.describe());
        Answer::Colour(components.total())
    }

    /// Describes the ray itself.
    pub(super) fn describe_ray(&self, ray: &Ray) -> Entry {
        let left = ray.departure.map(|departure| self.scene.objects[departure.object].name.clone());
        Entry::new(What::Ray {
            ray: ray.kind,
            origin: ray.origin.to_array(),
            direction: ray.direction.to_array(),
            depth: ray.depth,
            medium: self.medium_name(self.current_medium(&ray.media)),
            weight: ray.weight,
            wavelength: ray.wavelength,
            left,
        })
    }
}

/// The six steps in words.
pub(super) const STEPS: [&str; 6] = [
    "Build the ray through the pixel",
    "Find all intersections of the ray with objects in the scene",
    "Identify the closest intersection in front of the eye",
    "Compute the hit point",
    "Find the colour of the light returning to the eye",
    "Place the colour in the pixel",
];

/// One of the six steps, by its number.
pub(super) fn describe_step(number: u8) -> What {
    What::Step { number, title: STEPS[usize::from(number) - 1].to_owned() }
}

/// Runs one of the six steps. For the camera ray the step is an event of its own, the first level of a pixel's tree.
#[inline(always)]
pub(super) fn step<R: Recorder, T>(ray: &Ray, number: u8, recorder: &mut R, work: impl FnOnce(&mut R) -> T) -> T {
    if R::RECORDING && ray.kind == RayKind::Camera {
        recorder.event(work, |_| Entry::new(describe_step(number)))
    } else {
        work(recorder)
    }
}
