//! How far a foreign number may lie from ours.
//!
//! **Rule.** A number may be off by `share` times the size of the numbers that it was worked out from, and by the bound on the error of
//! our own hit time. Errors grow on the way through the tree: every further ray is allowed four times as much. Where the other
//! program moves the start of a ray off the surface that it left, all that follows along this ray may be off by ten times that
//! distance.

use crate::math::portable;
use glam::DVec3;

/// The share that is allowed where nobody says otherwise: what is left of programs that print nine digits and compute in
/// double precision. Smaller would take rounding in printed numbers for departures; larger would miss a start that is half a
/// pixel off in a large picture.
pub const SHARE: f64 = 1e-6;

/// Directions, normals and colours may be off by this many shares: what follows from a point is less sure than the point.
const DERIVED: f64 = 10.0;
/// Colours hang on powers such as (r·v)²⁵⁰, which multiply a relative error by the exponent.
const COLOURS: f64 = 300.0;
/// The start of a ray may be moved by this share of the scene's coordinates there, to keep it off the surface that it left.
const START: f64 = 2e-3;
/// How much the distance of a start may grow: a ray along a surface meets the next one at a slant.
const SLANT: f64 = 10.0;

/// What is allowed along one ray.
#[derive(Clone, Copy, Debug)]
pub struct Allowance {
    share: f64,
    /// The share before it grew.
    plain: f64,
    /// How far the ray's start lies from ours.
    moved: f64,
}

impl Allowance {
    /// What is allowed along a ray, so many rays away from the camera ray, whose start lies `moved` from ours.
    pub fn new(share: f64, depth: u32, moved: f64) -> Self {
        Self { share: share * portable::powi(4.0, depth.min(5).cast_signed()), plain: share, moved }
    }

    /// How far the ray's start lies from ours.
    pub const fn moved(&self) -> f64 {
        self.moved
    }

    /// Of the start of a ray that was spawned.
    pub fn start(origin: DVec3) -> f64 {
        START * (1.0 + origin.abs().max_element())
    }

    /// Of a point.
    pub fn point(&self, point: DVec3, origin: DVec3) -> f64 {
        self.share * DERIVED * (1.0 + point.abs().max_element().max(origin.abs().max_element())) + SLANT * self.moved
    }

    /// Of a hit time whose own error is known.
    pub fn time(&self, t: f64, t_error: f64, [origin, direction]: [DVec3; 2]) -> f64 {
        let reach = origin.abs().max_element() / direction.length();
        self.share * DERIVED * (t.abs() + reach) + t_error + SLANT * self.moved / direction.length()
    }

    /// Of a unit vector.
    pub fn direction(&self) -> f64 {
        self.share * DERIVED + SLANT * self.moved
    }

    /// Of a vector of this size.
    pub fn vector(&self, size: f64) -> f64 {
        self.share * DERIVED * size + SLANT * self.moved
    }

    /// Of a colour. It is allowed no more on deeper rays: what is wrong there is to be found there, not where it is added up.
    pub fn colour(&self, colour: DVec3) -> f64 {
        self.plain * COLOURS * colour.abs().max_element().max(1.0) + SLANT * self.moved
    }
}
