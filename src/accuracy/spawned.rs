//! Do spawned rays leave the surface that they start on? Random rays hit random surfaces, and rays in other directions leave
//! from there, as the tracer sends them. What each meets is compared with what arithmetic with 32 digits finds on its line.
//!
//! **The truth.** On the line of a spawned ray the exact boundaries lie where they lie; the one that it left is among them,
//! within a window about t = 0 that follows from the rounding of the hit point: w = 4 (e |n·d| + 16 ε |P|) / |n·d′|, for e the
//! bound on the error of the hit time, d and d′ the unit directions before and after. Every boundary behind the window has to count,
//! and nothing within it. Where another boundary comes closer than 4 w, or the window holds more than one, the line
//! says nothing about the departure: such rays are counted as not judged, unless they lose account of whether they are inside.

use super::random::Random;
use crate::csg::{Boundary, Solid};
use crate::math::{DoubleDouble, portable};
use crate::optics::{reflect, refract};
use crate::record::{NullRecorder, Sense};
use crate::scene::{Scene, load};
use crate::trace::{Ray, Surface, Tracer};
use glam::DVec3;
use rayon::prelude::*;
use std::ops::Range;

/// The solids, as scene files describe them; each fills a few units about the origin.
pub const SOLIDS: [(&str, &str); 16] = [
    ("plane", r#""shape": "plane""#),
    ("square", r#""shape": "square""#),
    ("sphere", r#""shape": "sphere""#),
    ("tapered_cylinder", r#""shape": "tapered_cylinder", "s": 1.7"#),
    ("cylinder", r#""shape": "cylinder""#),
    ("cone", r#""shape": "cone""#),
    ("cube", r#""shape": "cube""#),
    (
        "convex_polyhedron",
        r#""shape": "convex_polyhedron", "planes": [{"normal": [1,1,1], "offset": 1}, {"normal": [-1,1,0.3], "offset": 1},
            {"normal": [0.2,-1,1], "offset": 1}, {"normal": [0.1,-0.2,-1], "offset": 0.5}, {"normal": [1,-1,-0.5], "offset": 1}]"#,
    ),
    ("torus", r#""shape": "torus", "d": 2.5"#),
    ("torus, thin", r#""shape": "torus", "d": 60"#),
    ("superellipsoid 4, 4", r#""shape": "superellipsoid", "n": 4, "m": 4"#),
    ("superellipsoid 0.7, 2", r#""shape": "superellipsoid", "n": 0.7, "m": 2"#),
    (
        "difference",
        r#""shape": "difference", "of": [{"shape": "cube"}, {"shape": "sphere", "transform": [{"scale": 1.2}]}]"#,
    ),
    (
        "shell 1e-5 thick",
        r#""shape": "difference", "of": [{"shape": "sphere"}, {"shape": "sphere", "transform": [{"scale": 0.99999}]}]"#,
    ),
    (
        "bowl",
        r#""shape": "difference", "of": [{"shape": "sphere"}, {"shape": "sphere", "transform": [{"scale": 0.9}]},
            {"shape": "cylinder", "transform": [{"scale": [0.7, 0.7, 2]}]}]"#,
    ),
    (
        "union",
        r#""shape": "union", "of": [{"shape": "torus", "d": 2}, {"shape": "cone", "transform": [{"scale": [1.5, 1.5, 3]}]}]"#,
    ),
];

/// Powers of ten by which the solids are scaled.
pub const SCALES: [i32; 7] = [-9, -6, -3, 0, 3, 6, 9];

/// What happened to the rays of one solid at one scale.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Departures {
    /// Spawned rays that were judged.
    pub judged: u64,
    /// Spawned rays whose line says nothing about the departure.
    pub not_judged: u64,
    /// The boundary that the ray left was counted again.
    pub self_hits: u64,
    /// Behind the window something else was counted than is there.
    pub leaks: u64,
}

impl Departures {
    fn plus(self, other: Self) -> Self {
        Self {
            judged: self.judged + other.judged,
            not_judged: self.not_judged + other.not_judged,
            self_hits: self.self_hits + other.self_hits,
            leaks: self.leaks + other.leaks,
        }
    }
}

/// A spawned ray that went wrong, with all that is needed to send it again.
#[derive(Clone, Debug, PartialEq)]
pub struct Mishap {
    /// The number of the ray: with the seed it gives the same ray again.
    pub number: u64,
    /// The solid, by its place in [`SOLIDS`].
    pub solid: usize,
    /// The scale, by its place in [`SCALES`].
    pub scale: usize,
    /// Whether the boundary that was left was counted again; else something else was.
    pub self_hit: bool,
    /// Where the first ray started.
    pub origin: DVec3,
    /// Where it went.
    pub direction: DVec3,
    /// Where the spawned ray started.
    pub point: DVec3,
    /// Where that went.
    pub leaving: DVec3,
    /// The boundary that was left counts up to here.
    pub window: f64,
    /// The boundaries that the tracer counts.
    pub counted: Vec<f64>,
    /// The exact boundaries on the whole line.
    pub exact: Vec<f64>,
}

/// What came of a number of rays: counts by solid and scale, and the first that went wrong.
#[derive(Clone, Debug)]
pub struct Soak {
    /// `departures[solid][scale]`.
    pub departures: [[Departures; SCALES.len()]; SOLIDS.len()],
    /// The mishaps with the lowest numbers, at most [`KEPT`].
    pub mishaps: Vec<Mishap>,
}

/// Mishaps that are kept: enough to see a pattern, few enough to read.
pub const KEPT: usize = 20;

/// Rays that a core takes at a time.
const CHUNK: u64 = 2_000;

/// Sends the rays with these numbers. `stopped` is asked now and then; `done` is told how many rays are finished.
///
/// # Errors
/// Says so where one of [`SOLIDS`] cannot be read.
pub fn soak(
    seed: u64,
    rays: Range<u64>,
    stopped: impl Fn() -> bool + Sync,
    done: impl Fn(u64) + Sync,
) -> Result<Soak, String> {
    let places: Vec<(usize, usize)> =
        (0..SOLIDS.len()).flat_map(|solid| (0..SCALES.len()).map(move |scale| (solid, scale))).collect();
    let scenes = places.iter().map(|&(solid, scale)| scene(solid, scale)).collect::<Result<Vec<_>, _>>()?;
    let chunks: Vec<u64> = (rays.start..rays.end).step_by(usize::try_from(CHUNK).unwrap_or(1)).collect();
    let empty = || Soak { departures: [[Departures::default(); SCALES.len()]; SOLIDS.len()], mishaps: Vec::new() };
    let run = |&first: &u64| {
        let mut soak = empty();
        let numbers = first..(first + CHUNK).min(rays.end);
        let count = numbers.end - numbers.start;
        for number in numbers.take_while(|_| !stopped()) {
            let mut random = Random::new(seed, number);
            let k = random.index(places.len());
            let (solid, scale) = places[k];
            if let Some(outcome) = send(&scenes[k], portable::powi(10.0, SCALES[scale]), &mut random) {
                soak.note(number, (solid, scale), outcome);
            }
        }
        done(count);
        soak
    };
    Ok(chunks.par_iter().map(run).reduce(empty, Soak::plus))
}

impl Soak {
    /// The sum of both; the first mishaps of the two are kept, whichever was finished first.
    fn plus(mut self, other: Self) -> Self {
        for (own, others) in self.departures.iter_mut().flatten().zip(other.departures.iter().flatten()) {
            *own = own.plus(*others);
        }
        self.mishaps.extend(other.mishaps);
        self.mishaps.sort_by_key(|mishap| mishap.number);
        self.mishaps.truncate(KEPT);
        self
    }

    fn note(&mut self, number: u64, (solid, scale): (usize, usize), outcome: Outcome) {
        let counts = &mut self.departures[solid][scale];
        match outcome {
            Outcome::NotJudged => counts.not_judged += 1,
            Outcome::Right => counts.judged += 1,
            Outcome::Wrong(mishap) => {
                counts.judged += 1;
                *(if mishap.self_hit { &mut counts.self_hits } else { &mut counts.leaks }) += 1;
                if self.mishaps.len() < KEPT {
                    self.mishaps.push(Mishap { number, solid, scale, ..*mishap });
                }
            }
        }
    }

    /// All counts together.
    #[must_use]
    pub fn total(&self) -> Departures {
        self.departures.iter().flatten().fold(Departures::default(), |sum, counts| sum.plus(*counts))
    }
}

/// A scene with one solid at one scale.
fn scene(solid: usize, scale: usize) -> Result<Scene, String> {
    let (name, shape) = SOLIDS[solid];
    let text = format!(
        r#"{{"camera": {{"eye": [0, -9, 0], "look_at": [0, 0, 0], "up": [0, 0, 1], "field_of_view": 30}},
            "materials": {{"glass": {{"transparency": 1, "index_of_refraction": 1.5}}}},
            "objects": [{{{shape}, "material": "glass", "transform": [
                {{"rotate": {{"axis": [1, 2, 3], "degrees": 37}}}}, {{"scale": 1e{}}}]}}]}}"#,
        SCALES[scale]
    );
    load(&text, name).map_err(|errors| errors.to_string())
}

enum Outcome {
    NotJudged,
    Right,
    Wrong(Box<Mishap>),
}

/// Sends one ray, and one from where it hits; none if it hits nothing.
fn send(scene: &Scene, scale: f64, random: &mut Random) -> Option<Outcome> {
    let solid = &scene.objects[0].solid;
    let tracer = Tracer::new(scene);
    let ray = Ray::camera(DVec3::ZERO, DVec3::ONE);
    let ray = aimed(solid, scale, random, &ray);
    let surface = tracer.first_surface(&ray)?;
    let direction = other_direction(&ray, &surface, random);
    let spawned = tracer.leaving(&ray, &surface, direction);
    let counted = tracer.boundaries_ahead(&spawned, 0);
    let exact = solid.inside::<DoubleDouble>(spawned.origin, direction, &mut NullRecorder).boundaries();
    Some(judged(&ray, &surface, &spawned, &counted, &exact))
}

/// A ray from up to 10⁸ sizes away into the solid's box.
fn aimed(solid: &Solid, scale: f64, random: &mut Random, ray: &Ray) -> Ray {
    let extent = solid.extent();
    let (low, high) = if extent.is_unbounded() {
        (DVec3::splat(-3.0 * scale), DVec3::splat(3.0 * scale))
    } else {
        (extent.low, extent.high)
    };
    let target = random.within(low, high);
    let distance = scale * portable::powf(10.0, random.between(0.5, 8.0));
    let origin = target + random.direction() * distance;
    let direction = (target - origin).normalize();
    Ray { origin, direction, ..ray.clone() }
}

/// Mirrored, refracted either way, or anywhere.
fn other_direction(ray: &Ray, surface: &Surface, random: &mut Random) -> DVec3 {
    let refracted = |n1, n2| refract(ray.direction, surface.n_shading, n1, n2).refracted;
    match random.index(4) {
        0 => reflect(ray.direction, surface.n_shading),
        1 => refracted(1.0, 1.5).unwrap_or_else(|| random.direction()),
        2 => refracted(1.5, 1.0).unwrap_or_else(|| random.direction()),
        _ => random.direction(),
    }
}

fn judged(
    ray: &Ray,
    surface: &Surface,
    spawned: &Ray,
    counted: &[(Boundary, Sense)],
    exact: &[(Boundary, Sense)],
) -> Outcome {
    let normal = surface.n_geometric;
    let off = surface.boundary.error * normal.dot(ray.direction).abs()
        + 16.0 * f64::EPSILON * normal.abs().dot(surface.point.abs());
    let window = 4.0 * off / normal.dot(spawned.direction).abs();
    let within = |(boundary, _): &&(Boundary, Sense)| boundary.t.abs() <= window;
    let unclear = exact.iter().any(|(b, _)| b.t.abs() > window && b.t.abs() <= 4.0 * window);
    let unclear = !window.is_finite() || unclear || exact.iter().filter(within).count() > 1;
    // Whatever the window holds: a ray that goes in comes out next, and one that goes out may only go in.
    let goes_in = normal.dot(spawned.direction) <= 0.0;
    let keeps_account = surface.sense == Sense::Touch
        || counted.first().map_or(!goes_in || exact.is_empty(), |(_, sense)| (*sense == Sense::Leave) == goes_in);
    // Where rounding took the line off the surface that it left, its way to the next is shorter than rounding.
    let unclear = unclear || surface.sense != Sense::Touch && !exact.iter().any(|end| within(&end));
    if unclear && keeps_account {
        return Outcome::NotJudged;
    }
    let self_hit = counted.iter().any(|(boundary, _)| boundary.t <= window);
    let senses = |list: &[(Boundary, Sense)]| -> Vec<Sense> {
        list.iter().filter(|(boundary, _)| boundary.t > window).map(|(_, sense)| *sense).collect()
    };
    if !unclear && !self_hit && senses(counted) == senses(exact) {
        return Outcome::Right;
    }
    let times = |list: &[(Boundary, Sense)]| list.iter().map(|(boundary, _)| boundary.t).collect();
    Outcome::Wrong(Box::new(Mishap {
        number: 0,
        solid: 0,
        scale: 0,
        self_hit,
        origin: ray.origin,
        direction: ray.direction,
        point: spawned.origin,
        leaving: spawned.direction,
        window,
        counted: times(counted),
        exact: times(exact),
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_that_do_not_know_where_they_started_are_found_out() {
        let (mut hits, mut self_hits) = (0, 0);
        for solid in 0..SOLIDS.len() {
            let scene = scene(solid, 3).unwrap();
            let tracer = Tracer::new(&scene);
            for number in 0..200 {
                let random = &mut Random::new(5, number);
                let ray = aimed(&scene.objects[0].solid, 1.0, random, &Ray::camera(DVec3::ZERO, DVec3::ONE));
                let Some(surface) = tracer.first_surface(&ray) else { continue };
                let direction = other_direction(&ray, &surface, random);
                let forgetful = Ray { departure: None, ..tracer.leaving(&ray, &surface, direction) };
                let counted = tracer.boundaries_ahead(&forgetful, 0);
                let solid = &scene.objects[0].solid;
                let exact = solid.inside::<DoubleDouble>(forgetful.origin, direction, &mut NullRecorder).boundaries();
                hits += 1;
                let outcome = judged(&ray, &surface, &forgetful, &counted, &exact);
                self_hits += u32::from(matches!(outcome, Outcome::Wrong(mishap) if mishap.self_hit));
            }
        }
        // Rounding puts about every other hit point on the wrong side.
        assert!(self_hits * 4 > hits && self_hits < hits, "{self_hits} of {hits}");
    }

    #[test]
    fn a_ray_is_the_same_again_whatever_is_sent_beside_it() {
        let send = |rays: Range<u64>| soak(3, rays, || false, |_| {}).unwrap().total();
        let (first, second, both) = (send(0..500), send(500..1_000), send(0..1_000));
        assert_eq!(first.plus(second), both);
    }
}
