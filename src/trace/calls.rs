//! Which effects run: those that the scene calls for, and no others.

use super::ray::Tracer;
use crate::csg::Boundary;
use crate::record::{Counter, Effect, Recorder};
use crate::scene::{Detail, Effects};
use glam::{DVec2, DVec3};

/// The effects that a tracer has code for. Not every combination is compiled: a picture is traced with the smallest repertoire
/// that holds what its scene calls for.
pub trait Repertoire: Copy + Sync {
    /// The set.
    const EFFECTS: Effects;

    /// Whether objects may let light through.
    const TRANSPARENCY: bool;
}

/// All effects of this build.
#[derive(Clone, Copy, Debug)]
pub struct Every;

impl Repertoire for Every {
    const EFFECTS: Effects = Effects::BUILT;
    const TRANSPARENCY: bool = true;
}

/// Mirrors, lenses and shadows among opaque objects in plain colours: a scene that calls for nothing else does not even pay for
/// being asked.
#[derive(Clone, Copy, Debug)]
pub struct Opaque;

impl Repertoire for Opaque {
    const EFFECTS: Effects = Effects::OPAQUE.and(Effects::BUILT);
    const TRANSPARENCY: bool = false;
}

impl<E: Repertoire> Tracer<'_, E> {
    /// Whether the scene calls for an effect. Each effect asks this before anything else.
    #[inline]
    pub(super) const fn calls_for(&self, effect: Effect) -> bool {
        E::EFFECTS.has(effect) && self.scene.effects.has(effect)
    }

    /// Whether the scene calls for any of these effects.
    #[inline]
    pub(super) const fn calls_for_any(&self, effects: Effects) -> bool {
        E::EFFECTS.meets(effects) && self.scene.effects.meets(effects)
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
