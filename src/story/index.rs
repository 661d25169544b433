//! What stepping, folding and filtering ask about a tree again and again, worked out once, in flat lists.

use super::kind::Kind;
use super::level::{Level, level_of};
use super::skip::{self, Cut};
use crate::record::{Event, EventId, RayKind, What};
use crate::trace::RayTree;
use std::collections::BTreeMap;

/// The ray that an event belongs to: a spawned ray with all that happens to it, or the camera ray's whole sample or pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scope {
    /// The event that holds all of it.
    pub event: EventId,
    /// Why the ray was sent.
    pub kind: RayKind,
    /// How many rays it is away from the camera ray.
    pub depth: u32,
}

/// The number that stands for no object.
const NO_OBJECT: u32 = 0;

/// A tree's events by number: where each ends, of which ray and object it is, and at which level it is told.
#[derive(Debug)]
pub struct Index {
    ends: Vec<EventId>,
    kinds: Vec<Kind>,
    levels: Vec<Level>,
    /// For each event its ray, by its place in `scopes`.
    scope_of: Vec<u32>,
    scopes: Vec<Scope>,
    /// For each event its object, by its place in `objects`.
    object_of: Vec<u32>,
    objects: Vec<String>,
    /// For each event how many before it were skipped, cut off or rejected; one more than there are events.
    skips_before: Vec<u32>,
    /// For each way of leaving something out the events that do so.
    cuts: [Vec<EventId>; Cut::ALL.len()],
    present: Vec<bool>,
}

impl Index {
    /// Works through the tree once.
    #[must_use]
    pub fn of(tree: &RayTree) -> Self {
        let kinds: Vec<Kind> = tree.events.iter().map(|event| Kind::of(&event.what)).collect();
        let (scope_of, scopes) = scopes(tree);
        let (object_of, objects) = objects(tree, &scope_of);
        let levels = levels(tree, &kinds, (&scope_of, &scopes), &object_of);
        let (skips_before, cuts) = skips(tree);
        let mut present = vec![false; Kind::ALL.len()];
        for &kind in &kinds {
            present[kind as usize] = true;
        }
        Self { ends: ends(tree), kinds, levels, scope_of, scopes, object_of, objects, skips_before, cuts, present }
    }

    /// How many events there are.
    #[must_use]
    pub fn len(&self) -> EventId {
        EventId::try_from(self.ends.len()).unwrap_or(EventId::MAX)
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The number after the last event below `id`.
    #[must_use]
    pub fn end(&self, id: EventId) -> EventId {
        self.ends[id as usize]
    }

    /// The kind of an event.
    #[must_use]
    pub fn kind(&self, id: EventId) -> Kind {
        self.kinds[id as usize]
    }

    /// The level at which an event is told.
    #[must_use]
    pub fn level(&self, id: EventId) -> Level {
        self.levels[id as usize]
    }

    /// The ray that an event belongs to.
    #[must_use]
    pub fn scope(&self, id: EventId) -> Scope {
        self.scopes[self.scope_of[id as usize] as usize]
    }

    /// The object that an event is about, or that what it is a part of is about.
    #[must_use]
    pub fn object(&self, id: EventId) -> Option<&str> {
        let object = self.object_of[id as usize];
        (object != NO_OBJECT).then(|| self.objects[object as usize].as_str())
    }

    /// The names of all objects that something is about, in the order in which they are met.
    pub fn objects(&self) -> impl Iterator<Item = &str> {
        self.objects.iter().skip(1).map(String::as_str)
    }

    /// Every kind of ray that there is, in the order of the list of kinds.
    pub fn ray_kinds(&self) -> impl Iterator<Item = RayKind> {
        RayKind::ALL.into_iter().filter(|kind| self.scopes.iter().any(|scope| scope.kind == *kind))
    }

    /// Whether there is an event of this kind.
    #[must_use]
    pub fn has(&self, kind: Kind) -> bool {
        self.present[kind as usize]
    }

    /// The events that left something out in this way, in order.
    #[must_use]
    pub fn cut_events(&self, cut: Cut) -> &[EventId] {
        &self.cuts[cut as usize]
    }

    /// How many rays there are.
    #[must_use]
    pub fn rays(&self) -> usize {
        self.scopes.len()
    }

    /// How many of the events `from..to` are things that were skipped, cut off or rejected.
    #[must_use]
    pub fn skips(&self, from: EventId, to: EventId) -> u32 {
        self.skips_before[to as usize] - self.skips_before[from as usize]
    }
}

fn skips(tree: &RayTree) -> (Vec<u32>, [Vec<EventId>; Cut::ALL.len()]) {
    let mut cuts: [Vec<EventId>; Cut::ALL.len()] = std::array::from_fn(|_| Vec::new());
    let mut before = Vec::with_capacity(tree.events.len() + 1);
    let mut skips = 0;
    before.push(skips);
    for event in &tree.events {
        if let Some(cut) = skip::cut(&event.what) {
            cuts[cut as usize].push(event.id);
            skips += 1;
        }
        before.push(skips);
    }
    (before, cuts)
}

fn ends(tree: &RayTree) -> Vec<EventId> {
    let mut ends: Vec<EventId> = tree.events.iter().map(|event| event.id + 1).collect();
    // Parts come after their whole, so that each is complete when it is its turn.
    for event in tree.events.iter().rev() {
        if let Some(parent) = event.parent {
            ends[parent as usize] = ends[parent as usize].max(ends[event.id as usize]);
        }
    }
    ends
}

fn scopes(tree: &RayTree) -> (Vec<u32>, Vec<Scope>) {
    let mut scope_of: Vec<u32> = Vec::with_capacity(tree.events.len());
    let mut scopes = Vec::new();
    for event in &tree.events {
        let own = match &event.what {
            // A camera ray's event lies beside what happens to it, not above it.
            What::Ray { ray, depth, .. } if *ray != RayKind::Camera => Some((*ray, *depth)),
            What::Sample(_) => Some((RayKind::Camera, 0)),
            _ if event.parent.is_none() => Some((RayKind::Camera, 0)),
            _ => None,
        };
        let place = match (own, event.parent) {
            (Some((kind, depth)), _) => {
                scopes.push(Scope { event: event.id, kind, depth });
                u32::try_from(scopes.len() - 1).unwrap_or(u32::MAX)
            }
            (None, Some(parent)) => scope_of[parent as usize],
            (None, None) => 0,
        };
        scope_of.push(place);
    }
    (scope_of, scopes)
}

/// Objects are numbered from 1 as they are met. What is inside the search of an object, or says its name, is about it.
fn objects(tree: &RayTree, scope_of: &[u32]) -> (Vec<u32>, Vec<String>) {
    let mut objects = vec![String::new()];
    let mut numbers: BTreeMap<&str, u32> = BTreeMap::new();
    let mut object_of: Vec<u32> = Vec::with_capacity(tree.events.len());
    for event in &tree.events {
        let number = match (named(event), event.parent) {
            (Some(name), _) => *numbers.entry(name).or_insert_with(|| {
                objects.push(name.to_owned());
                u32::try_from(objects.len() - 1).unwrap_or(NO_OBJECT)
            }),
            (None, Some(parent)) if scope_of[parent as usize] == scope_of[event.id as usize] => {
                object_of[parent as usize]
            }
            _ => NO_OBJECT,
        };
        object_of.push(number);
    }
    (object_of, objects)
}

/// The object that an event names.
fn named(event: &Event) -> Option<&str> {
    match &event.what {
        What::Object { name: object, .. }
        | What::Moved { object, .. }
        | What::Rejected { object, .. }
        | What::Hit { object, .. }
        | What::Shadow { object, .. }
        | What::Medium { object, .. } => Some(object),
        _ => None,
    }
}

fn levels(tree: &RayTree, kinds: &[Kind], (scope_of, scopes): (&[u32], &[Scope]), object_of: &[u32]) -> Vec<Level> {
    let mut hit = vec![NO_OBJECT; scopes.len()];
    for event in tree.events.iter().filter(|event| matches!(event.what, What::Hit { .. })) {
        hit[scope_of[event.id as usize] as usize] = object_of[event.id as usize];
    }
    let level = |event: &Event| {
        let (scope, object) = (scope_of[event.id as usize] as usize, object_of[event.id as usize]);
        level_of(event, &scopes[scope], object != NO_OBJECT && hit[scope] == object)
    };
    let mut levels: Vec<Level> = tree.events.iter().map(level).collect();
    let mut below = vec![Level::Everything; levels.len()];
    for event in tree.events.iter().rev() {
        let id = event.id as usize;
        if kinds[id].names_what_is_below() {
            levels[id] = levels[id].min(below[id]);
        }
        if let Some(parent) = event.parent {
            below[parent as usize] = below[parent as usize].min(below[id]).min(levels[id]);
        }
    }
    levels
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::story::testing::{bowl, fishbowl};

    #[test]
    fn an_events_end_is_that_of_its_subtree() {
        let tree = bowl();
        let index = Index::of(&tree);
        for event in &tree.events {
            assert_eq!(index.end(event.id), tree.subtree_end(event.id));
        }
    }

    #[test]
    fn what_happens_to_a_spawned_ray_is_its_own() {
        let tree = fishbowl();
        let index = Index::of(&tree);
        for event in &tree.events {
            let above = tree.path(event.id).into_iter().rev().find_map(|id| match &tree.event(id).what {
                What::Ray { ray, depth, .. } if *ray != RayKind::Camera => Some((*ray, *depth)),
                _ => None,
            });
            let scope = index.scope(event.id);
            assert_eq!((scope.kind, scope.depth), above.unwrap_or((RayKind::Camera, 0)), "event {}", event.id);
        }
    }

    #[test]
    fn the_working_of_an_object_is_about_that_object() {
        let tree = bowl();
        let index = Index::of(&tree);
        let object = tree.events.iter().find(|event| matches!(event.what, What::Object { .. })).unwrap();
        let What::Object { name, .. } = &object.what else { unreachable!() };
        for id in object.id..index.end(object.id) {
            assert_eq!(index.object(id), Some(name.as_str()));
        }
        assert_eq!(index.object(0), None);
    }

    #[test]
    fn skips_are_counted_like_one_by_one() {
        let tree = fishbowl();
        let index = Index::of(&tree);
        let (from, to) = (100, tree.end() - 50);
        let counted = (from..to).filter(|&id| skip::cut(&tree.event(id).what).is_some()).count();
        assert_eq!(index.skips(from, to) as usize, counted);
        assert!(counted > 0);
        let listed: usize = Cut::ALL.iter().map(|&cut| index.cut_events(cut).len()).sum();
        assert_eq!(listed, index.skips(0, tree.end()) as usize);
    }
}
