//! Leaving a surface without hitting it again, and without an epsilon.
//!
//! A spawned ray starts on a boundary that is known: which object, and whether the ray leaves it or goes into it. Among
//! that object's boundaries along the new ray one is the boundary that was left, at t = 0 up to rounding. It is picked
//! out by what it is and by the *error bounds* of the two hit times, and is not counted. Every other boundary counts
//! from t = 0 on, however near: a shell 10⁻⁵ thick keeps its far side.

use super::closest::Surface;
use crate::csg::{Boundary, IntervalList};
use crate::record::Sense;
use glam::DVec3;

/// The boundary that a spawned ray started on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Departure {
    /// The object, by its place in the list.
    pub object: usize,
    /// What crossing that boundary at t = 0 does to the new ray's line.
    sense: Sense,
    /// Bound on how far from t = 0 the boundary can seem to be.
    window: f64,
}

/// Roundings in a hit point's coordinates: the product, the sum, and the inverse transform on the way back.
const POINT_ROUNDINGS: f64 = 8.0 * f64::EPSILON;

impl Departure {
    /// Leaving `surface`, which was hit along `incoming`, in the given direction.
    #[must_use]
    pub fn new(surface: &Surface, incoming: DVec3, direction: DVec3) -> Self {
        let outwards = direction.dot(surface.n_geometric);
        let sense = match (surface.sense, outwards > 0.0) {
            (Sense::Touch, _) => Sense::Touch,
            (_, true) => Sense::Leave,
            (_, false) => Sense::Enter,
        };
        let along_normal = surface.boundary.error * surface.n_geometric.dot(incoming).abs()
            + POINT_ROUNDINGS * surface.n_geometric.abs().dot(surface.point.abs());
        Self { object: surface.object, sense, window: 4.0 * along_normal / outwards.abs() }
    }

    /// The boundary in this object's list that the ray started on, if its line crosses it at all.
    ///
    /// A ray that leaves at a grazing angle may, by rounding, start beside the surface; then there is none.
    #[must_use]
    pub fn boundary(&self, object: usize, list: &IntervalList) -> Option<Boundary> {
        if object != self.object {
            return None;
        }
        list.boundaries()
            .into_iter()
            .filter(|(boundary, sense)| *sense == self.sense && boundary.t.abs() <= self.window + boundary.error)
            .map(|(boundary, _)| boundary)
            .min_by(|a, b| a.t.abs().total_cmp(&b.t.abs()))
    }
}
