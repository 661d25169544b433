//! Laws of the difference of two trees.

use super::*;
use crate::record::{Entry, Event, EventId, What};
use crate::scene::{Profile, Scene, embedded_scene, load};
use crate::trace::{RayTree, record_pixel};

fn scene(name: &str) -> Scene {
    load(embedded_scene(name).unwrap().text, name).unwrap()
}

fn recorded(name: &str) -> RayTree {
    let scene = scene(name);
    let [x, y] = scene.pixels[0];
    record_pixel(&scene, x, y)
}

fn exact(left: &RayTree, right: &RayTree) -> TreeDifference {
    difference(left, right, &Tolerance::EXACT)
}

/// The tree with an event put in before event `before`, as a sibling of it.
fn with_event_before(tree: &RayTree, before: EventId, what: What) -> RayTree {
    let mut tree = tree.clone();
    let parent = tree.event(before).parent;
    for event in &mut tree.events {
        event.id += EventId::from(event.id >= before);
        event.parent = event.parent.map(|parent| parent + EventId::from(parent >= before));
    }
    let entry = Entry::new(what);
    let event = Event { id: before, parent, what: entry.what, working: entry.working, source: entry.source };
    tree.events.insert(before as usize, event);
    tree
}

#[test]
fn a_tree_does_not_differ_from_itself() {
    for name in ["csg/bowl", "optics/glass_ball", "textures/wood", "primitives/superellipsoid"] {
        let tree = recorded(name);
        let pairs = exact(&tree, &tree.clone());
        assert!(pairs.is_empty(), "{name}");
        assert_eq!(pairs.counts(), [tree.events.len(), 0, 0, 0], "{name}");
        assert_eq!(pairs.first_departure(&tree, &tree, &Tolerance::EXACT), None);
    }
}

#[test]
fn every_event_of_either_tree_is_in_one_row_in_order() {
    let (left, right) = (recorded("csg/bowl"), recorded("csg/lens"));
    let pairs = exact(&left, &right);
    let ids = |side: usize| pairs.pairs.iter().filter_map(|pair| [pair.left, pair.right][side]).collect::<Vec<_>>();
    assert_eq!(ids(0), (0..left.end()).collect::<Vec<_>>());
    assert_eq!(ids(1), (0..right.end()).collect::<Vec<_>>());
    for (row, pair) in pairs.pairs.iter().enumerate() {
        let below = &pairs.pairs[row..pair.end as usize];
        let different = below.iter().filter(|pair| pair.standing != Standing::Same).count();
        assert_eq!(pair.different as usize, different);
    }
}

#[test]
fn with_the_sides_changed_round_the_same_rows_differ() {
    let scene = scene("optics/fresnel");
    let [x, y] = scene.pixels[0];
    let (left, right) = (record_pixel(&scene, x, y), record_pixel(&scene, x + 40, y + 10));
    let (there, back) = (exact(&left, &right), exact(&right, &left));
    let [same, changed, only_left, only_right] = there.counts();
    assert!(changed > 0 && only_left + only_right > 0);
    assert_eq!(back.counts(), [same, changed, only_right, only_left]);
}

#[test]
fn an_event_that_was_put_in_is_the_only_difference_wherever_it_was_put() {
    let tree = recorded("csg/bowl");
    let inserted = What::Moved { object: "nobody".to_owned(), by: 1.0 };
    for before in (1..tree.end()).step_by(7) {
        let more = with_event_before(&tree, before, inserted.clone());
        let pairs = exact(&tree, &more);
        assert_eq!(pairs.counts(), [tree.events.len(), 0, 0, 1], "before {before}");
        let departure = pairs.first_departure(&tree, &more, &Tolerance::EXACT).unwrap();
        assert_eq!(departure.right, before);
        assert_eq!(Some(departure.left), tree.event(before).parent);
        let fewer = exact(&more, &tree);
        assert_eq!(fewer.counts(), [tree.events.len(), 0, 1, 0], "before {before}");
    }
}

#[test]
fn an_event_that_says_what_its_neighbour_says_is_found_by_what_it_says() {
    let tree = recorded("csg/bowl");
    let rejected = tree.events.iter().find(|event| matches!(event.what, What::Rejected { .. })).unwrap();
    let What::Rejected { object, leaf, part, t, reason } = rejected.what.clone() else { unreachable!() };
    let twin = What::Rejected { object, leaf, part, t: t + 1.0, reason };
    let more = with_event_before(&tree, rejected.id, twin);
    let only: Vec<_> = exact(&tree, &more).pairs.into_iter().filter(|pair| pair.standing != Standing::Same).collect();
    assert_eq!(only.len(), 1);
    assert_eq!((only[0].right, only[0].standing), (Some(rejected.id), Standing::OnlyRight));
}

#[test]
fn a_changed_number_is_named_with_both_values() {
    let left = recorded("hello/sphere");
    let mut right = left.clone();
    let hit = right.events.iter_mut().find(|event| matches!(event.what, What::Hit { .. })).unwrap();
    let id = hit.id;
    let What::Hit { t, .. } = &mut hit.what else { unreachable!() };
    let before = *t;
    *t = 4.75;
    let departure = exact(&left, &right).first_departure(&left, &right, &Tolerance::EXACT).unwrap();
    assert_eq!((departure.left, departure.right), (id, id));
    assert_eq!(departure.why, format!("t: {} here, 4.75 there", crate::record::format_number(before)));
    let hit = right.events.iter_mut().find(|event| event.id == id).unwrap();
    let What::Hit { t, .. } = &mut hit.what else { unreachable!() };
    *t = before.next_up();
    let departure = exact(&left, &right).first_departure(&left, &right, &Tolerance::EXACT).unwrap();
    assert_eq!(departure.why, format!("t: {before:?} here, {:?} there", before.next_up()));
    let tolerance = Tolerance { relative: 1e-12, absolute: 0.0 };
    assert!(difference(&left, &right, &tolerance).is_empty());
}

#[test]
fn settings_are_compared_by_the_trees_that_they_give() {
    let scene = scene("optics/glass_ball");
    let (_, draft) = Profile::NAMED.iter().find(|(name, _)| *name == "draft").unwrap();
    let [x, y] = scene.pixels[0];
    let (left, right) = (record_pixel(&scene, x, y), record_pixel(&scene.with_profile(draft), x, y));
    let pairs = exact(&left, &right);
    assert!(!pairs.is_empty());
    assert!(pairs.first_departure(&left, &right, &Tolerance::EXACT).is_some());
}

#[test]
fn what_an_edit_changed_is_all_that_differs() {
    let text = embedded_scene("hello/sphere").unwrap().text;
    let brighter = text.replacen("\"ambient\": [0.17, 0.19, 0.23]", "\"ambient\": [0.34, 0.38, 0.46]", 1);
    assert_ne!(text, brighter);
    let scenes = [text, &brighter].map(|text| load(text, "edited").unwrap());
    let [x, y] = scenes[0].pixels[0];
    let [left, right] = scenes.map(|scene| record_pixel(&scene, x, y));
    let pairs = exact(&left, &right);
    let kinds: Vec<_> = pairs.different().map(|row| &left.event(pairs.pairs[row].left.unwrap()).what).collect();
    assert!(!kinds.is_empty());
    let expected = |what: &What| matches!(what, What::Ambient { .. } | What::Colour { .. } | What::Written { .. });
    assert!(kinds.into_iter().all(expected));
}

#[test]
fn the_text_marks_every_row_and_says_in_words_what_differs() {
    let (left, right) = (recorded("csg/bowl"), recorded("csg/lens"));
    let text = difference_text(&exact(&left, &right), [&left, &right], &Tolerance::EXACT);
    assert!(text.contains("first difference: "), "{text}");
    assert!(text.contains("\n- ") && text.contains(" [only here]"), "{text}");
    assert!(text.contains("\n+ ") && text.contains(" [only there]"), "{text}");
    assert!(text.contains("\n~ "), "{text}");
    let nothing = difference_text(&exact(&left, &left), [&left, &left], &Tolerance::EXACT);
    assert_eq!(nothing, format!("no difference in {} events\n", left.events.len()));
}

/// A root with so many copies of a tree below it.
fn copies(tree: &RayTree, count: EventId) -> RayTree {
    let mut events = vec![Event { id: 0, parent: None, ..tree.events[0].clone() }];
    for copy in 0..count {
        let start = 1 + copy * tree.end();
        events.extend(tree.events.iter().map(|event| Event {
            id: event.id + start,
            parent: Some(event.parent.map_or(0, |parent| parent + start)),
            ..event.clone()
        }));
    }
    RayTree { events }
}

#[test]
fn one_event_among_a_hundred_thousand_is_found() {
    let tree = recorded("csg/bowl");
    let many = copies(&tree, 100_000 / tree.end() + 1);
    assert!(many.events.len() > 100_000);
    let place = many.end() / 2;
    let more = with_event_before(&many, place, What::Moved { object: "nobody".to_owned(), by: 1.0 });
    let pairs = exact(&many, &more);
    assert_eq!(pairs.counts(), [many.events.len(), 0, 0, 1]);
    assert_eq!(pairs.first_departure(&many, &more, &Tolerance::EXACT).unwrap().right, place);
}
