//! Which events of two recordings are the same, when the scene was changed in between: the selection stays where it was, and what changed
//! is marked.
//!
//! An event is known again by its way from the root: at each level what kind of event it is, whose, and the how many-th
//! of that kind it is among its neighbours.

use crate::record::{Event, EventId, What};
use crate::trace::RayTree;
use std::collections::{BTreeMap, BTreeSet};
use std::mem::Discriminant;

/// What is known of an event beside its neighbours.
type Step = (String, usize);

/// The kind of an event and whose it is.
fn label(event: &Event) -> String {
    let whose = match &event.what {
        What::Object { name, .. } | What::Primitive { name, .. } => name.as_str(),
        // Of what is rejected there may be many; a closest hit stays the closest hit, whatever was hit before.
        What::Rejected { object, .. } => object.as_str(),
        _ => "",
    };
    format!("{:?} {whose}", kind(event))
}

fn kind(event: &Event) -> Discriminant<What> {
    std::mem::discriminant(&event.what)
}

/// For each event its parent's number and its own step.
fn steps(tree: &RayTree) -> Vec<(Option<EventId>, Step)> {
    let mut counts: BTreeMap<(Option<EventId>, String), usize> = BTreeMap::new();
    let step = |event: &Event| {
        let label = label(event);
        let count = counts.entry((event.parent, label.clone())).or_insert(0);
        *count += 1;
        (event.parent, (label, *count))
    };
    tree.events.iter().map(step).collect()
}

/// For each event of `new` the event of `old` that stood there.
#[must_use]
pub fn counterparts(old: &RayTree, new: &RayTree) -> Vec<Option<EventId>> {
    let places: BTreeMap<(Option<EventId>, Step), EventId> =
        steps(old).into_iter().zip(old.events.iter().map(|event| event.id)).collect();
    let mut found: Vec<Option<EventId>> = Vec::with_capacity(new.events.len());
    for (parent, step) in steps(new) {
        // Parents come before their children, so theirs are known.
        let counterpart = match parent {
            None => places.get(&(None, step)).copied(),
            Some(parent) => {
                let old_parent = found.get(parent as usize).copied().flatten();
                old_parent.and_then(|old_parent| places.get(&(Some(old_parent), step)).copied())
            }
        };
        found.push(counterpart);
    }
    found
}

/// The event of `new` that stands where `event` stood in `old`, or where the nearest event above it did that is still there.
#[must_use]
pub fn same_event(old: &RayTree, new: &RayTree, event: EventId) -> EventId {
    let counterparts = counterparts(old, new);
    let way = old.path(event);
    let find = |wanted: EventId| counterparts.iter().position(|found| *found == Some(wanted));
    way.into_iter().rev().find_map(find).and_then(|place| EventId::try_from(place).ok()).unwrap_or(0)
}

/// The events of `new` that are not in `old`, or hold something else there. What is only around a change is not marked.
#[must_use]
pub fn changed_events(old: &RayTree, new: &RayTree) -> BTreeSet<EventId> {
    let differs = |(event, old_id): (&Event, Option<EventId>)| {
        let same =
            old_id.map(|id| old.event(id)).is_some_and(|old| old.what == event.what && old.working == event.working);
        (!same).then_some(event.id)
    };
    new.events.iter().zip(counterparts(old, new)).filter_map(differs).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{embedded_scene, load};
    use crate::trace::record_pixel;

    fn tree(text: &str) -> RayTree {
        let scene = load(text, "hello/sphere").unwrap();
        let [x, y] = scene.pixels[0];
        record_pixel(&scene, x, y)
    }

    fn sphere() -> String {
        embedded_scene("hello/sphere").unwrap().text.to_owned()
    }

    #[test]
    fn every_event_of_a_recording_is_its_own_counterpart() {
        let tree = tree(&sphere());
        let expected: Vec<_> = tree.events.iter().map(|event| Some(event.id)).collect();
        assert_eq!(counterparts(&tree, &tree), expected);
        assert!(changed_events(&tree, &tree).is_empty());
    }

    #[test]
    fn a_new_colour_changes_the_shading_and_not_the_hit() {
        let old = tree(&sphere());
        let new = tree(&sphere().replace("\"diffuse\": [0.58, 0.2, 0.1]", "\"diffuse\": [0.1, 0.2, 0.58]"));
        let changed = changed_events(&old, &new);
        let is_hit = |event: &&Event| matches!(event.what, What::Hit { .. } | What::Implicit { .. });
        assert!(new.events.iter().filter(is_hit).all(|event| !changed.contains(&event.id)));
        assert!(!changed.is_empty());
    }

    #[test]
    fn the_selection_stays_on_the_hit_when_another_object_comes_before_it() {
        let more = "\"objects\": [ { \"shape\": \"cube\", \"material\": \"clay\", \"transform\": [{ \"translate\": [50, 0, 0] }] },";
        let (old, new) = (tree(&sphere()), tree(&sphere().replacen("\"objects\": [", more, 1)));
        let hit = |tree: &RayTree| tree.events.iter().find(|event| matches!(event.what, What::Hit { .. })).unwrap().id;
        assert_ne!(hit(&old), hit(&new));
        assert_eq!(same_event(&old, &new, hit(&old)), hit(&new));
    }
}
