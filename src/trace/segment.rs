//! What media take away from light on its way.

use super::ray::{Ray, Tracer};
use crate::record::{Effect, Recorder};
use crate::scene::{ALL_EFFECTS, Rgb};

impl Tracer<'_> {
    /// The share of a light at `limit` that the media along a shadow ray let through, by colour.
    pub(super) fn clearness<R: Recorder>(&self, _shadow: &Ray, _limit: f64, _recorder: &mut R) -> Rgb {
        if !(ALL_EFFECTS && self.scene.effects.has(Effect::Attenuation)) {
            return Rgb::ONE;
        }
        Rgb::ONE
    }
}
