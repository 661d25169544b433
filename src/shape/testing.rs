//! What the tests of shapes share.

use super::{Approach, Crossings, GenericRay, Primitive};
use crate::math::Real;
use crate::record::{Kept, NullRecorder, Sense, What};
use glam::DVec3;

pub(super) use Sense::{Enter, Leave, Touch};

/// Instances of a shape that between them show all that is special about it, for the battery.
pub(super) trait Samples: Primitive + Sized {
    fn samples() -> Vec<Self>;
}

/// All crossings of the ray S + c t.
pub(super) fn solve<A: Real>(shape: &impl Primitive, origin: DVec3, direction: DVec3) -> Crossings {
    let mut crossings = Crossings::new();
    shape.crossings(&GenericRay::<A>::new(origin, direction), &mut NullRecorder, &mut crossings);
    crossings
}

/// The ray S + c t, which is in generic coordinates already.
pub(super) struct Straight(pub DVec3, pub DVec3);

impl Approach for Straight {
    fn generic<A: Real>(&self) -> GenericRay<'_, A> {
        GenericRay::new(self.0, self.1)
    }
}

/// All crossings as (t, sense, part), with t rounded to 12 decimals: what a person works out on paper.
pub(super) fn hits(shape: &impl Primitive, origin: [f64; 3], direction: [f64; 3]) -> Vec<(f64, Sense, String)> {
    let parts = shape.parts();
    solve::<f64>(shape, origin.into(), direction.into())
        .into_iter()
        .map(|hit| ((hit.t * 1e12).round() / 1e12, hit.sense, parts[usize::from(hit.part)].clone()))
        .collect()
}

/// Asserts what [`hits`] finds.
#[track_caller]
pub(super) fn expect(shape: &impl Primitive, origin: [f64; 3], direction: [f64; 3], expected: &[(f64, Sense, &str)]) {
    let found = hits(shape, origin, direction);
    let found: Vec<_> = found.iter().map(|(t, sense, part)| (*t, *sense, part.as_str())).collect();
    assert_eq!(found, expected);
}

/// Everything that the shape reports on the ray S + c t.
pub(super) fn record(shape: &impl Primitive, origin: DVec3, direction: DVec3) -> (Vec<What>, Crossings) {
    let (mut kept, mut crossings) = (Kept::default(), Crossings::new());
    shape.crossings(&GenericRay::<f64>::new(origin, direction), &mut kept, &mut crossings);
    (kept.0.into_iter().map(|entry| entry.what).collect(), crossings)
}
