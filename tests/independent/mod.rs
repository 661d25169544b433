//! A reference of our own: where a line crosses a solid, to 40 digits and more.

#![allow(dead_code, reason = "each test uses its own part of it")]

pub mod big;
pub mod exact;
pub mod random;
pub mod rays;
pub mod samples;
pub mod solids;
pub mod sturm;

use big::{Big, Line};
use exact::Exact;
use glam::DVec3;
use rayscope::math::Real;
use rayscope::record::NullRecorder;
use rayscope::shape::{Crossings, GenericRay, Primitive, Shape};

/// How far the rounding of the ray's numbers can move it against the solid, in units of length.
pub fn doubt(origin: DVec3) -> f64 {
    2.0 * f64::EPSILON * (origin.abs().max_element() + 1.0)
}

/// The exact crossings, where they are determined by the ray's numbers: a solid grown or shrunk by the doubt has as many.
pub fn determined(solid: &Exact, line: &Line, doubt: f64) -> Option<Vec<Big>> {
    let exact = solid.crossings(line, 0.0)?;
    let same = |growth: f64| solid.count(line, growth) == Some(exact.len());
    (same(doubt) && same(-doubt)).then_some(exact)
}

/// What the program finds.
pub fn solve<A: Real>(shape: &Shape, origin: DVec3, direction: DVec3) -> Crossings {
    let mut crossings = Crossings::new();
    shape.crossings(&GenericRay::<A>::new(origin, direction), &mut NullRecorder, &mut crossings);
    crossings
}
