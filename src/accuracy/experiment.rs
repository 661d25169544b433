//! Every solver followed into the distance, and towards tangents: how large its error, and how often its answer is wrong.
//!
//! **The truth** is what arithmetic with 32 digits finds for the ray as it is given. **The unit** of errors is the attainable
//! floor: what half a last digit (of `f64`) of the ray's numbers can move the hit by, u Σ|∂F/∂xᵢ| (|Sᵢ| + |t cᵢ|) / |∇F · c|, and
//! half a last digit of t. An answer is wrong where a hit is missing or one too many; of the others the largest error counts.

use super::hits::hits;
use super::oracle::Target;
use super::random::Random;
use super::subject::Subject;
use crate::math::{DoubleDouble, Real};
use crate::record::NullRecorder;
use crate::shape::{Crossing, Crossings, GenericRay, Method, Primitive, Shape};
use glam::DVec3;
use rayon::prelude::*;

/// What is varied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Question {
    /// How far away the ray starts.
    Distance,
    /// How close to a tangent or an edge it passes.
    Tangency,
}

/// Rays for each place on the x axis: enough for 99 of 100 to mean something.
pub const RAYS: u64 = 400;

/// One seed for all plots, so that they are the same wherever they are drawn.
const SEED: u64 = 2_026;

/// How the solvers did at one place, in the order of [`Method::ALL`].
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The distance or gap, in sizes.
    pub x: f64,
    /// The error that 99 of 100 rays do not exceed whose hits were all found; NaN where these are too few to say.
    pub error: [f64; 5],
    /// The share of wrong answers.
    pub wrong: [f64; 5],
}

impl Question {
    /// The places, in sizes: two for each power of ten.
    #[must_use]
    pub fn places(self) -> Vec<f64> {
        let halves = |from: i32, to: i32| (from..=to).map(|half| 10.0_f64.powf(0.5 * f64::from(half)));
        match self {
            Self::Distance => halves(0, 16).collect(),
            Self::Tangency => halves(-32, -2).rev().collect(),
        }
    }
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
    let target = Target::Shape(subject.shape.clone());
    let (mut errors, mut wrong) = ([const { Vec::new() }; 5], [0_u32; 5]);
    let mut sent = 0_u32;
    for number in 0..RAYS {
        let mut random = Random::new(SEED, index * RAYS + number);
        let ray = match question {
            Question::Distance => Some(subject.ray_from(x, &mut random)),
            Question::Tangency => subject.ray_beside(x, &mut random),
        };
        let Some((origin, direction)) = ray else { continue };
        sent += 1;
        let exact = exact(&subject.shape, origin, direction);
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
