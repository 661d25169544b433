//! What every primitive tells a recorder after its own working: d(t), and the hit times with their fates.

use super::{Bounds, Crossing, GenericRay, Part, Primitive};
use crate::math::{Real, portable};
use crate::record::{Accuracy, Candidate, CandidateFate, Entry, Measured, Sense, Sign, SignSpan, Triple, Value, What};

/// How many values of d(t) are kept: enough for a smooth curve at the width of a plot.
const SAMPLES: u32 = 65;

/// S as a value for a line of working.
pub(super) fn start<A: Real>(ray: &GenericRay<A>) -> Value {
    Value::Vector(ray.start())
}

/// c as a value for a line of working.
pub(super) fn course<A: Real>(ray: &GenericRay<A>) -> Value {
    Value::Vector(ray.course())
}

/// A number of a solver times an exact power of two, with its accuracy where the arithmetic keeps one.
pub(super) fn measured<A: Real>(x: A, power_of_two: f64) -> Measured<f64> {
    let value = x.to_f64() * power_of_two;
    Measured { value, accuracy: x.error().map(|error| accuracy::<A>(error * power_of_two, value)) }
}

/// A vector with the accuracy of its worst coordinate.
pub(super) fn measured_vector<A: Real>(v: [A; 3], power_of_two: f64) -> Measured<Triple> {
    let value = v.map(|x| x.to_f64() * power_of_two);
    let size = value.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let error = v.iter().filter_map(|x| x.error()).reduce(f64::max);
    Measured { value, accuracy: error.map(|error| accuracy::<A>(error * power_of_two, size)) }
}

/// An error, and the digits that it takes from a number of this size.
fn accuracy<A: Real>(error: f64, value: f64) -> Accuracy {
    let digits = -portable::log10(A::UNIT_ROUNDOFF);
    let lost = if error > 0.0 { digits + portable::log10(error / value.abs()) } else { 0.0 };
    Accuracy { error, digits_lost: lost.clamp(0.0, digits) }
}

/// A hit time that was looked at and does not count.
pub(super) fn rejected<A: Real>(
    shape: &impl Primitive,
    ray: &GenericRay<A>,
    (tau, part, sense): (f64, Part, Sense),
    reason: String,
) -> Candidate {
    Candidate {
        t: tau * ray.t_per_tau,
        part: part_name(shape, part),
        sense,
        point: ray.point(A::from_f64(tau)).to_array(),
        fate: CandidateFate::Rejected,
        reason,
    }
}

/// The name of a part.
pub(super) fn part_name(shape: &impl Primitive, part: Part) -> String {
    shape.parts().into_iter().nth(usize::from(part)).unwrap_or_default()
}

/// Every hit time that was looked at: the crossings found, and those that were rejected.
#[track_caller]
pub(super) fn roots<A: Real>(
    shape: &impl Primitive,
    ray: &GenericRay<A>,
    crossings: &[Crossing],
    rejected: Vec<Candidate>,
) -> Entry {
    let parts = shape.parts();
    let accepted = crossings.iter().map(|crossing| Candidate {
        t: crossing.t,
        part: parts.get(usize::from(crossing.part)).cloned().unwrap_or_default(),
        sense: crossing.sense,
        point: ray.point(A::from_f64(crossing.t / ray.t_per_tau)).to_array(),
        fate: CandidateFate::Accepted,
        reason: match crossing.sense {
            Sense::Enter => "the ray goes in here",
            Sense::Leave => "the ray comes out here",
            Sense::Touch => "the ray passes through the surface here",
        }
        .to_owned(),
    });
    let mut candidates: Vec<_> = accepted.chain(rejected).collect();
    candidates.sort_by(|a, b| a.t.total_cmp(&b.t));
    Entry::new(What::Roots { candidates })
}

/// d(t) = F(S + c t) of a closed solid: its values, and the signs between the crossings.
#[track_caller]
pub(super) fn implicit<A: Real>(shape: &impl Primitive, ray: &GenericRay<A>, crossings: &[Crossing]) -> Entry {
    let roots: Vec<f64> = crossings.iter().map(|crossing| crossing.t).collect();
    let starts_inside = match crossings.first() {
        Some(first) => first.sense == Sense::Leave,
        None => shape.implicit(ray.point(ray.foot())) < 0.0,
    };
    implicit_with_roots(shape, ray, roots, starts_inside)
}

/// d(t) with its zeros given; `starts_inside` says that it is negative before the first.
#[track_caller]
pub(super) fn implicit_with_roots<A: Real>(
    shape: &impl Primitive,
    ray: &GenericRay<A>,
    roots: Vec<f64>,
    starts_inside: bool,
) -> Entry {
    let [from, to] = interesting_range(shape.bounds(), ray, &roots);
    let samples = (0..SAMPLES)
        .map(|k| {
            let t = from + (to - from) * f64::from(k) / f64::from(SAMPLES - 1);
            [t, shape.implicit(ray.point(A::from_f64(t / ray.t_per_tau)))]
        })
        .collect();
    let ends: Vec<_> = [None].into_iter().chain(roots.iter().copied().map(Some)).chain([None]).collect();
    let signs = ends
        .windows(2)
        .enumerate()
        .map(|(k, pair)| {
            let inside = starts_inside != (k % 2 == 1);
            SignSpan { from: pair[0], to: pair[1], sign: if inside { Sign::Negative } else { Sign::Positive } }
        })
        .collect();
    Entry::new(What::Implicit { equation: shape.equation(), samples, roots, signs })
}

/// A bit more than what lies between the roots; where there are none, the neighbourhood of the foot.
fn interesting_range<A: Real>(bounds: Bounds, ray: &GenericRay<A>, roots: &[f64]) -> [f64; 2] {
    let [x, y, z] = ray.course();
    let length = glam::DVec3::new(x, y, z).length();
    let diagonal = (bounds.high - bounds.low).length();
    let size = if diagonal.is_finite() { diagonal } else { 4.0 } / length;
    let foot = ray.foot().to_f64() * ray.t_per_tau;
    let (Some(first), Some(last)) = (roots.first(), roots.last()) else {
        return [foot - 0.5 * size, foot + 0.5 * size];
    };
    let margin = if roots.len() == 1 { 0.5 * size } else { (0.35 * (last - first)).max(0.02 * size) };
    [first - margin, last + margin]
}
