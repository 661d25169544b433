//! The primitive that an event is about, and the ray in its generic coordinates: what was recorded of it, and the shape
//! itself, so that F can be read at any point.

use super::events_of::Story;
use crate::csg::Leaf;
use crate::record::{Candidate, CandidateFate, EventId, What};
use crate::scene::Scene;
use crate::shape::Primitive;
use crate::trace::RayTree;
use glam::DVec3;

/// A recorded primitive with its shape.
#[derive(Clone, Copy, Debug)]
pub(super) struct PrimitiveAt<'a> {
    /// Its `Primitive` event.
    pub event: EventId,
    /// Its `Transform` event.
    pub transform: EventId,
    pub leaf: &'a Leaf,
    /// World to generic.
    pub inverse: [[f64; 4]; 3],
    /// S.
    pub origin: DVec3,
    /// c.
    pub direction: DVec3,
    candidates: Option<(EventId, &'a [Candidate])>,
}

impl<'a> PrimitiveAt<'a> {
    /// The primitive that `selected` is about. None where there is none, or where the scene is not the one that was recorded.
    pub fn of(scene: &'a Scene, tree: &'a RayTree, selected: EventId) -> Option<Self> {
        let story = Story::of(tree, selected)?;
        let event = story.primitive_near(selected)?;
        let What::Primitive { shape, leaf, .. } = &tree.event(event).what else { return None };
        let What::Object { index, .. } = &tree.event(story.object_near(event)?).what else { return None };
        let leaf = scene.objects.get(*index)?.solid.leaves.get(*leaf).filter(|leaf| leaf.shape.name() == shape)?;
        let transform = story.transform_of(event)?;
        let What::Transform { inverse, origin, direction, .. } = &tree.event(transform).what else { return None };
        let mut below = event..tree.subtree_end(event);
        let candidates = below.find_map(|id| match &tree.event(id).what {
            What::Roots { candidates } => Some((id, candidates.as_slice())),
            _ => None,
        });
        let [origin, direction] = [origin, direction].map(|v| DVec3::from_array(*v));
        Some(Self { event, transform, leaf, inverse: *inverse, origin, direction, candidates })
    }

    /// S + c t.
    pub fn point(&self, t: f64) -> DVec3 {
        self.origin + self.direction * t
    }

    /// d(t) = F(S + c t).
    pub fn d(&self, t: f64) -> f64 {
        self.leaf.shape.implicit(self.point(t))
    }

    /// The hit times that were kept and those that were not, with their event.
    pub fn candidates(&self) -> impl Iterator<Item = (EventId, &'a Candidate)> + use<'a> {
        let (event, all) = self.candidates.unwrap_or((self.event, &[]));
        all.iter().map(move |candidate| (event, candidate))
    }

    /// The hit times that were kept.
    pub fn hits(&self) -> impl Iterator<Item = f64> + use<'a> {
        self.candidates().filter(|(_, c)| c.fate == CandidateFate::Accepted).map(|(_, c)| c.t)
    }

    /// An outward unit normal at a hit, in generic coordinates.
    pub fn normal(&self, candidate: &Candidate) -> DVec3 {
        let part = self.leaf.parts.iter().position(|part| *part == candidate.part).unwrap_or(0);
        let part = u16::try_from(part).unwrap_or(0);
        self.leaf.shape.normal(DVec3::from_array(candidate.point), part).normalize_or_zero()
    }
}
