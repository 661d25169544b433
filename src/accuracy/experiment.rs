//! Every solver followed into the distance, towards tangents, and to objects of small size: how large its error, and how often
//! its answer is wrong.
//!
//! **The truth** is what arithmetic with 32 digits finds for the ray as it is given. **The unit** of errors is the attainable
//! floor: what half a last digit (of `f64`) of the ray's numbers can move the hit by, u Σ|∂F/∂xᵢ| (|Sᵢ| + |t cᵢ|) / |∇F · c|, and
//! half a last digit of t. An answer is wrong where a hit is missing or one too many; of the others the largest error counts.

use super::hits::hits;
use super::oracle::Target;
use super::random::Random;
use super::subject::Subject;
use crate::csg::{Leaf, Placement, Solid};
use crate::math::{DoubleDouble, Real, portable};
use crate::record::NullRecorder;
use crate::shape::{Crossing, Crossings, GenericRay, Method, Primitive, Shape};
use glam::{DAffine3, DQuat, DVec3};
use rayon::prelude::*;

/// What is varied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Question {
    /// How far away the ray starts.
    Distance,
    /// How close to a tangent or an edge it passes.
    Tangency,
    /// How small the object is, where it stands one unit from the origin of the world.
    Scale,
}

/// Rays for each place on the x axis: enough for 99 of 100 to mean something.
pub const RAYS: u64 = 400;

/// One seed for all plots, so that they are the same wherever they are drawn.
const SEED: u64 = 2_026;

/// How the solvers did at one place, in the order of [`Method::ALL`].
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The distance or gap, in sizes; or the scale of the object.
    pub x: f64,
    /// The error that 99 of 100 rays do not exceed whose hits were all found; NaN where these are too few to say.
    pub error: [f64; 5],
    /// The share of wrong answers.
    pub wrong: [f64; 5],
}

impl Question {
    /// The places, in sizes or scales: two for each power of ten.
    #[must_use]
    pub fn places(self) -> Vec<f64> {
        let halves = |from: i32, to: i32| (from..=to).map(half_power_of_ten);
        match self {
            Self::Distance => halves(0, 16).collect(),
            Self::Tangency => halves(-32, -2).rev().collect(),
            Self::Scale => halves(-16, 0).rev().collect(),
        }
    }
}

/// √10ⁿ.
fn half_power_of_ten(n: i32) -> f64 {
    portable::powi(10.0, n.div_euclid(2)) * if n % 2 == 0 { 1.0 } else { 10.0_f64.sqrt() }
}

/// Sends all rays of an experiment with the cores of the current rayon pool; `stopped` is asked before each place, and
/// what comes after a yes is left out.
#[must_use]
pub fn experiment(
    question: Question,
    subject: &Subject,
    stopped: impl Fn() -> bool + Sync,
    done: impl Fn() + Sync,
) -> Vec<Place> {
    let places: Vec<(u64, f64)> = (0..).zip(question.places()).collect();
    places
        .par_iter()
        .filter(|_| !stopped())
        .map(|&(index, x)| {
            let place = place(question, subject, index, x);
            done();
            place
        })
        .collect()
}

fn place(question: Question, subject: &Subject, index: u64, x: f64) -> Place {
    let placement = (question == Question::Scale).then(|| placed(x)).flatten();
    let target = match &placement {
        Some(placement) => {
            Target::Solid(Box::new(Solid::leaf(Leaf::new("", subject.shape.clone(), placement.clone()))))
        }
        None => Target::Shape(subject.shape.clone()),
    };
    let (mut errors, mut wrong) = ([const { Vec::new() }; 5], [0_u32; 5]);
    let mut sent = 0_u32;
    for number in 0..RAYS {
        let mut random = Random::new(SEED, index * RAYS + number);
        let ray = match question {
            Question::Distance => Some(subject.ray_from(x, &mut random)),
            Question::Tangency => subject.ray_beside(x, &mut random),
            Question::Scale => {
                placement.as_ref().map(|placement| in_world(placement, subject.ray_from(NEAR, &mut random)))
            }
        };
        let Some((origin, direction)) = ray else { continue };
        sent += 1;
        let exact = match &placement {
            Some(placement) => exact_in_world(&subject.shape, placement, [origin, direction]),
            None => exact(&subject.shape, origin, direction),
        };
        for (k, solver) in Method::ALL.into_iter().enumerate() {
            match largest_error(&hits(solver, &target, origin, direction), &exact) {
                // A miss that is seen as one has no error.
                Some(_) if exact.is_empty() => {}
                Some(error) => errors[k].push(error),
                None => wrong[k] += 1,
            }
        }
    }
    Place { x, error: errors.map(most), wrong: wrong.map(|wrong| f64::from(wrong) / f64::from(sent.max(1))) }
}

/// Where small objects stand: one unit from the origin, at no simple number.
const SITE: DVec3 = DVec3::new(0.48, -0.6, 0.64);

/// Rays at small objects start so many of the object's sizes away: near enough that distance has no say.
const NEAR: f64 = 4.0;

/// The placement of an object of this scale.
fn placed(scale: f64) -> Option<Placement> {
    Placement::new(DAffine3::from_scale_rotation_translation(DVec3::splat(scale), DQuat::IDENTITY, SITE)).ok()
}

/// A ray in generic coordinates as a ray of the world, rounded to what its numbers can hold there.
fn in_world(placement: &Placement, (origin, direction): (DVec3, DVec3)) -> (DVec3, DVec3) {
    let world = placement.world_from_generic();
    (world.transform_point3(origin), world.transform_vector3(direction).normalize())
}

/// What 99 of 100 do not exceed.
fn most(mut errors: Vec<f64>) -> f64 {
    /// Fewer rays tell more of chance than of the solver; more would leave gaps where there is something to see.
    const FEWEST: usize = 8;
    errors.sort_by(f64::total_cmp);
    if errors.len() < FEWEST { f64::NAN } else { errors[(errors.len() - 1) * 99 / 100] }
}

/// The exact hits, each with its floor.
fn exact(shape: &Shape, origin: DVec3, direction: DVec3) -> Vec<(f64, f64)> {
    let ray = GenericRay::<DoubleDouble>::new(origin, direction);
    let mut found = Crossings::new();
    shape.crossings(&ray, &mut NullRecorder, &mut found);
    let floor = |hit: &Crossing| {
        let tau = hit.t / ray.t_per_tau;
        let normal = shape.normal(ray.point(DoubleDouble::from_f64(tau)), hit.part);
        let moved = normal.abs().dot(DVec3::from_array(ray.sway(tau)));
        let slope = normal.dot(DVec3::from_array(ray.direction.map(Real::to_f64))).abs();
        let half_ulp = 0.5 * (hit.t.abs().next_up() - hit.t.abs());
        f64::UNIT_ROUNDOFF * moved / slope * ray.t_per_tau + half_ulp
    };
    found.iter().map(|hit| (hit.t, floor(hit))).collect()
}

/// The same of a placed primitive, for the numbers of the ray in the world.
fn exact_in_world(shape: &Shape, placement: &Placement, line: [DVec3; 2]) -> Vec<(f64, f64)> {
    let ray = placement.generic_ray::<DoubleDouble>(&line);
    let mut found = Crossings::new();
    shape.crossings(&ray, &mut NullRecorder, &mut found);
    let floor = |hit: &Crossing| {
        let point = ray.point(DoubleDouble::from_f64(hit.t / ray.t_per_tau));
        let normal = placement.world_normal(shape.normal(point, hit.part));
        let moved = normal.abs().dot(line[0].abs() + line[1].abs() * hit.t.abs());
        let half_ulp = 0.5 * (hit.t.abs().next_up() - hit.t.abs());
        f64::UNIT_ROUNDOFF * moved / normal.dot(line[1]).abs() + half_ulp
    };
    found.iter().map(|hit| (hit.t, floor(hit))).collect()
}

/// The largest error in units of the floor; none where a hit is missing or one too many.
fn largest_error(found: &[f64], exact: &[(f64, f64)]) -> Option<f64> {
    let error = |(t, (exact, floor)): (&f64, &(f64, f64))| (t - exact).abs() / floor;
    (found.len() == exact.len()).then(|| found.iter().zip(exact).map(error).fold(0.0, f64::max))
}

#[cfg(test)]
mod tests {
    use super::super::subject::subject;
    use super::*;

    #[test]
    fn from_nearby_all_but_single_precision_are_as_good_as_can_be_and_from_afar_the_textbook_is_lost() {
        let sphere = subject("sphere").unwrap();
        let [near, far] = [(0, 3.0), (1, 1e8)].map(|(k, x)| place(Question::Distance, &sphere, k, x));
        for solver in [Method::Double, Method::Adaptive] {
            let k = Method::ALL.iter().position(|other| *other == solver).unwrap();
            assert!(near.error[k] < 4.0 && far.error[k] < 4.0, "{near:?} {far:?}");
            assert_eq!([near.wrong[k], far.wrong[k]], [0.0, 0.0]);
        }
        assert!(near.wrong[4] == 0.0 && far.wrong[4] > 0.1, "{near:?} {far:?}");
        assert!(near.error[0] > 1e5);
    }

    #[test]
    fn small_objects_are_found_by_all_since_rays_are_transformed_in_double_precision() {
        let cube = subject("cube").unwrap();
        let places = [(0, 1.0), (1, 1e-4), (2, 1e-8)].map(|(k, x)| place(Question::Scale, &cube, k, x));
        let of = |method| Method::ALL.iter().position(|other| *other == method).unwrap();
        for place in &places {
            for method in [Method::Double, Method::Adaptive] {
                assert!(place.error[of(method)] < 8.0 && place.wrong[of(method)] == 0.0, "{method:?} {place:?}");
            }
            assert_eq!(place.wrong[of(Method::Single)], 0.0, "{place:?}");
        }
        // At 10⁻⁸ eight of sixteen digits go into where the object stands: f32 adds little to that.
        let errors = places.map(|place| place.error[of(Method::Single)]);
        assert!(errors[0] > 1e7 && errors[2] < 1e4, "{errors:?}");
    }

    #[test]
    fn rays_beside_a_tangent_hit_and_miss_by_turns() {
        for name in ["sphere", "square", "tapered_cylinder", "cube", "convex_polyhedron", "torus", "superellipsoid"] {
            let subject = subject(name).unwrap();
            let mut hits = 0;
            for number in 0..200 {
                let Some((origin, direction)) = subject.ray_beside(1e-3, &mut Random::new(1, number)) else { continue };
                hits += u32::from(!exact(&subject.shape, origin, direction).is_empty());
            }
            assert!((60..140).contains(&hits), "{name}: {hits} of 200 hit");
        }
    }
}
