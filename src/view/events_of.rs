//! Which events belong together: those of one ray, those of the hit that ended it.

use super::flights::{End, Flights};
use crate::record::{Event, EventId, RayKind, What};
use crate::trace::RayTree;

/// A tree with what belongs to which ray.
pub(super) struct Story<'t> {
    pub tree: &'t RayTree,
    pub flights: Flights,
}

impl<'t> Story<'t> {
    /// None where the tree does not have the event.
    pub fn of(tree: &'t RayTree, selected: EventId) -> Option<Self> {
        (selected < tree.end()).then(|| Self { tree, flights: Flights::of(tree) })
    }

    /// The events of the ray that `event` belongs to, in order.
    pub fn of_same_ray(&self, event: EventId) -> impl Iterator<Item = &'t Event> + '_ {
        let owner = self.flights.owner(event);
        self.tree.events.iter().filter(move |other| self.flights.owner(other.id) == owner)
    }

    /// The event of this kind that `selected` is about: itself, or the first of its ray at or after the last one before
    /// the selection, or for a spawned ray that has none, the one of the ray that sent it.
    pub fn nearest(&self, selected: EventId, is_it: impl Fn(&What) -> bool) -> Option<EventId> {
        let mut from = selected;
        loop {
            let own: Vec<EventId> =
                self.of_same_ray(from).filter(|event| is_it(&event.what)).map(|event| event.id).collect();
            let before = own.iter().rev().find(|id| **id <= from).or(own.first());
            if let Some(found) = before {
                return Some(*found);
            }
            from = self.tree.event(self.flights.ray_of(from).event).parent.filter(|above| *above < from)?;
        }
    }

    /// The hit that ends the ray of `event`.
    pub fn hit(&self, event: EventId) -> Option<EventId> {
        match self.flights.ray_of(event).end {
            End::Hit { event, .. } => Some(event),
            _ => None,
        }
    }

    /// The search for hits with one object that `selected` belongs to; else the one that found the hit of its ray; else the
    /// ray's first.
    pub fn object_near(&self, selected: EventId) -> Option<EventId> {
        let is_object = |id: &EventId| matches!(self.tree.event(*id).what, What::Object { .. });
        let above = self.tree.path(selected).into_iter().rev().find(is_object);
        let of_hit = || {
            let hit = self.hit(selected)?;
            let What::Hit { object, .. } = &self.tree.event(hit).what else { return None };
            let is_it =
                |id: &EventId| matches!(&self.tree.event(*id).what, What::Object { name, .. } if name == object);
            (0..hit).rev().find(is_it)
        };
        let first = || self.of_same_ray(selected).map(|event| event.id).find(is_object);
        above.or_else(of_hit).or_else(first)
    }

    /// The primitive that `selected` belongs to; else, among those below it or of its object, the one that was hit or the
    /// first one that was worked out.
    pub fn primitive_near(&self, selected: EventId) -> Option<EventId> {
        let is_primitive = |id: &EventId| self.is_worked_out(*id);
        if let Some(above) = self.tree.path(selected).into_iter().rev().find(is_primitive) {
            return Some(above);
        }
        let object = self.object_near(selected)?;
        let is_within = |id: EventId| (object..self.tree.subtree_end(object)).contains(&id);
        let scope = if is_within(selected) { selected } else { object };
        let among: Vec<EventId> = (scope..self.tree.subtree_end(scope)).filter(is_primitive).collect();
        let wanted = self.hit(object).map(|hit| &self.tree.event(hit).what);
        let is_hit = |id: &&EventId| match (wanted, &self.tree.event(**id).what) {
            (Some(What::Hit { leaf, .. }), What::Primitive { name, .. }) => leaf == name,
            _ => false,
        };
        among.iter().find(is_hit).or(among.first()).copied()
    }

    /// Whether it is a primitive whose ray was taken to generic coordinates.
    fn is_worked_out(&self, id: EventId) -> bool {
        matches!(self.tree.event(id).what, What::Primitive { .. }) && self.transform_of(id).is_some()
    }

    /// The `Transform` event below a primitive.
    pub fn transform_of(&self, primitive: EventId) -> Option<EventId> {
        (primitive..self.tree.subtree_end(primitive))
            .find(|id| matches!(self.tree.event(*id).what, What::Transform { .. }))
    }

    /// The first ray of a kind that the ray of `event` sent after it.
    pub fn sent(&self, event: EventId, kind: RayKind) -> Option<EventId> {
        let own = self.flights.owner(event);
        let is_sent = |id: EventId| self.tree.event(id).parent.map(|parent| self.flights.owner(parent)) == Some(own);
        let rays = self.flights.all.iter().filter(|flight| flight.kind == kind && flight.event > event);
        rays.map(|flight| flight.event).find(|id| is_sent(*id))
    }
}
