//! The solvers as textbooks print them, kept as an exhibit: students can watch them fail.
//!
//! Nothing that renders uses this module, unless a picture is asked for that shows what these solvers do. Each solver takes the same ray and gives the same [`Crossing`]s as the real one, in
//! plain `f64`, without error bounds (every `error` is 0) and without a second opinion (every certificate says *certain*,
//! rightly or not). So the two can be compared in time and in truth, ray by ray. Each file says where its solver fails,
//! why, and which book it is from.
//!
//! On rays that start a few sizes away, and neither touch nor meet an edge, all of them are right.

mod combine;
mod convex;
mod ferrari;
mod flat;
mod sphere;
mod superellipsoid;
mod tapered;
mod torus;

pub use combine::combine;

use super::{Crossing, Crossings, GenericRay, Part, Shape, report};
use crate::record::{Certificate, Recorder, Sense};

/// The solvers, with what can be set of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exhibit {
    /// How many stretches of a ray are looked at for hits with a superellipsoid, at least 2. Fewer lose more chords, more
    /// cost more; none is enough.
    pub stretches: u32,
}

impl Exhibit {
    /// As it is printed.
    pub const PRINTED: Self = Self { stretches: 33 };

    /// Appends what the textbook's solver finds. All that it tells is d(t) and the hit times: it keeps no account of more.
    pub fn crossings<R: Recorder>(
        self,
        shape: &Shape,
        ray: &GenericRay<f64>,
        recorder: &mut R,
        crossings: &mut Crossings,
    ) {
        let begin = crossings.len();
        self.solve(shape, ray, crossings);
        if R::RECORDING && !matches!(shape, Shape::Square(_)) {
            recorder.note(|| report::implicit(shape, ray, &crossings[begin..]));
        }
        recorder.note(|| report::roots(shape, ray, &crossings[begin..], Vec::new()));
    }

    fn solve(self, shape: &Shape, ray: &GenericRay<f64>, crossings: &mut Crossings) {
        match shape {
            Shape::Plane(_) => flat::plane(ray, crossings),
            Shape::Square(_) => flat::square(ray, crossings),
            Shape::Sphere(_) => sphere::crossings(ray, crossings),
            Shape::TaperedCylinder(solid) => tapered::crossings(solid.s, ray, crossings),
            Shape::Cylinder(_) => tapered::crossings(1.0, ray, crossings),
            Shape::Cone(_) => tapered::crossings(0.0, ray, crossings),
            Shape::Cube(_) => convex::cube(ray, crossings),
            Shape::ConvexPolyhedron(solid) => convex::polyhedron(solid.planes(), ray, crossings),
            Shape::Torus(solid) => torus::crossings(solid.d, ray, crossings),
            Shape::Superellipsoid(solid) => {
                superellipsoid::crossings(solid.exponents, self.stretches.max(2), ray, crossings);
            }
        }
    }
}

/// Appends what the textbook's solver finds.
pub fn crossings(shape: &Shape, ray: &GenericRay<f64>, crossings: &mut Crossings) {
    Exhibit::PRINTED.solve(shape, ray, crossings);
}

/// A crossing at the solver's parameter τ, taken for exact.
fn crossing(ray: &GenericRay<f64>, tau: f64, sense: Sense, part: Part) -> Crossing {
    Crossing { t: tau * ray.t_per_tau, error: 0.0, sense, part, certificate: Certificate::Certain }
}

/// Sorts hit times and lets the ray go in and out by turns.
fn append_alternating(ray: &GenericRay<f64>, hits: &mut [(f64, Part)], crossings: &mut Crossings) {
    hits.sort_by(|a, b| a.0.total_cmp(&b.0));
    let senses = [Sense::Enter, Sense::Leave].into_iter().cycle();
    crossings.extend(hits.iter().zip(senses).map(|(&(tau, part), sense)| crossing(ray, tau, sense, part)));
}

#[cfg(test)]
mod tests;
