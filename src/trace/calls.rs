//! Which effects run: those that the scene calls for, and no others.

use super::ray::Tracer;
use crate::csg::Boundary;
use crate::record::{Counter, Effect, Recorder};
use crate::scene::{ALL_EFFECTS, Detail, Effects};
use glam::{DVec2, DVec3};

impl Tracer<'_> {
    /// Whether the scene calls for an effect. Each effect asks this before anything else.
    #[inline]
    pub(super) const fn calls_for(&self, effect: Effect) -> bool {
        (ALL_EFFECTS || matches!(effect, Effect::Shadows)) && self.scene.effects.has(effect)
    }

    /// Whether the scene calls for any of these effects.
    #[inline]
    pub(super) const fn calls_for_any(&self, effects: Effects) -> bool {
        ALL_EFFECTS && self.scene.effects.meets(effects)
    }

    /// The code of an effect is entered.
    #[inline]
    pub(super) fn enter<R: Recorder>(effect: Effect, recorder: &mut R) {
        recorder.count(Counter::Call(effect));
    }

    /// The material at a place on an object's surface, with the detail that decides it, if one does.
    pub(super) fn material_at(
        &self,
        object: usize,
        boundary: &Boundary,
        point: DVec3,
    ) -> (usize, Option<(&Detail, DVec2)>) {
        let object = &self.scene.objects[object];
        if self.calls_for(Effect::Details) {
            return object.material_at(boundary, point);
        }
        (object.leaf_materials[boundary.leaf], None)
    }
}
