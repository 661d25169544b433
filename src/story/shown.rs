//! Which events have rows at a level of detail and with a filter, and how many have none.

use super::filter::Filter;
use super::index::Index;
use super::kind::Kind;
use super::level::Level;
use crate::record::EventId;
use crate::trace::RayTree;

/// Stands for no event.
const NONE: EventId = EventId::MAX;

/// The events that have rows, in order, and what that leaves out.
#[derive(Debug)]
pub struct Shown {
    /// Events with rows: those that are looked for, and what they are parts of.
    rows: Vec<EventId>,
    /// Events that are looked for.
    steps: Vec<EventId>,
    /// The same by kind.
    steps_of: Vec<Vec<EventId>>,
    /// For each event the nearest one with a row above it.
    parents: Vec<EventId>,
    /// For each event how many with rows are above it.
    depths: Vec<u16>,
    /// For each event with a row how many without one are told by it.
    untold: Vec<u32>,
    by_filter: usize,
    deeper: usize,
}

impl Shown {
    /// The rows at this level; `matches` are those of a filter.
    #[must_use]
    pub fn new(tree: &RayTree, index: &Index, level: Level, matches: Option<&[bool]>) -> Self {
        let told = |id: EventId| index.level(id) <= level;
        let matched = |id: EventId| matches.is_none_or(|matches| matches[id as usize]);
        let is_row = rows_needed(tree, index, |id| told(id) && matched(id), told);
        let rows: Vec<EventId> = (0..index.len()).filter(|&id| is_row[id as usize]).collect();
        let steps: Vec<EventId> = rows.iter().copied().filter(|&id| matched(id)).collect();
        let mut steps_of = vec![Vec::new(); Kind::ALL.len()];
        for &id in &steps {
            steps_of[index.kind(id) as usize].push(id);
        }
        let (parents, depths) = places(tree, &is_row);
        let mut untold = vec![0; tree.events.len()];
        for id in (0..index.len()).filter(|&id| !is_row[id as usize]) {
            if let Some(count) = untold.get_mut(parents[id as usize] as usize) {
                *count += 1;
            }
        }
        let all = (0..index.len()).filter(|&id| told(id)).count();
        let deeper = match matches {
            Some(_) => (0..index.len()).filter(|&id| !told(id) && matched(id)).count(),
            None => 0,
        };
        Self { by_filter: all - rows.len(), deeper, rows, steps, steps_of, parents, depths, untold }
    }

    /// The same, for a filter that is worked out on the way.
    #[must_use]
    pub fn with(tree: &RayTree, index: &Index, level: Level, filter: &Filter) -> Self {
        Self::new(tree, index, level, filter.matches(tree, index).as_deref())
    }

    /// All events with rows, in order.
    #[must_use]
    pub fn rows(&self) -> &[EventId] {
        &self.rows
    }

    /// All events that one steps to, in order.
    #[must_use]
    pub fn steps(&self) -> &[EventId] {
        &self.steps
    }

    /// Those of one kind.
    #[must_use]
    pub fn steps_of(&self, kind: Kind) -> &[EventId] {
        &self.steps_of[kind as usize]
    }

    /// Whether an event has a row at this level and with this filter.
    #[must_use]
    pub fn has_row(&self, id: EventId) -> bool {
        self.rows.binary_search(&id).is_ok()
    }

    /// Whether an event is looked for, and not only there for what it holds.
    #[must_use]
    pub fn is_step(&self, id: EventId) -> bool {
        self.steps.binary_search(&id).is_ok()
    }

    /// The nearest event above that has a row.
    #[must_use]
    pub fn parent(&self, id: EventId) -> Option<EventId> {
        Some(self.parents[id as usize]).filter(|&parent| parent != NONE)
    }

    /// How many events above have rows.
    #[must_use]
    pub fn depth(&self, id: EventId) -> u16 {
        self.depths[id as usize]
    }

    /// How many events without rows belong to this row.
    #[must_use]
    pub fn untold(&self, id: EventId) -> u32 {
        self.untold[id as usize]
    }

    /// How many rows of this level the filter takes away.
    #[must_use]
    pub fn hidden_by_filter(&self) -> usize {
        self.by_filter
    }

    /// How many events the filter finds that this level does not tell.
    #[must_use]
    pub fn found_deeper(&self) -> usize {
        self.deeper
    }

    /// The rows after `id` and before `end`.
    #[must_use]
    pub fn rows_between(&self, id: EventId, end: EventId) -> &[EventId] {
        let from = self.rows.partition_point(|&row| row <= id);
        let to = self.rows.partition_point(|&row| row < end);
        &self.rows[from..to.max(from)]
    }
}

/// What is looked for has a row, and so has everything above it that the level tells.
fn rows_needed(
    tree: &RayTree,
    index: &Index,
    wanted: impl Fn(EventId) -> bool,
    told: impl Fn(EventId) -> bool,
) -> Vec<bool> {
    let mut holds: Vec<bool> = (0..index.len()).map(wanted).collect();
    for event in tree.events.iter().rev() {
        if let (true, Some(parent)) = (holds[event.id as usize], event.parent) {
            holds[parent as usize] = true;
        }
    }
    for id in 0..index.len() {
        // The root holds everything, and an outline without it would have several beginnings.
        holds[id as usize] = id == 0 || (holds[id as usize] && told(id));
    }
    holds
}

fn places(tree: &RayTree, is_row: &[bool]) -> (Vec<EventId>, Vec<u16>) {
    let mut parents = Vec::with_capacity(is_row.len());
    let mut depths: Vec<u16> = Vec::with_capacity(is_row.len());
    for event in &tree.events {
        let (parent, depth) = match event.parent {
            None => (NONE, 0),
            Some(above) if is_row[above as usize] => (above, depths[above as usize].saturating_add(1)),
            Some(above) => (parents[above as usize], depths[above as usize]),
        };
        parents.push(parent);
        depths.push(depth);
    }
    (parents, depths)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::story::testing::{bowl, fishbowl, small};

    fn shown(level: Level, filter: &Filter) -> Shown {
        let tree = small();
        Shown::with(&tree, &Index::of(&tree), level, filter)
    }

    #[test]
    fn each_level_tells_all_that_the_level_before_tells() {
        for tree in [small(), bowl(), fishbowl()] {
            let index = Index::of(&tree);
            let [story, working, everything] =
                Level::ALL.map(|level| Shown::with(&tree, &index, level, &Filter::default()));
            assert!(story.rows().iter().all(|&id| working.has_row(id)));
            assert_eq!(everything.rows().len(), tree.events.len());
            assert!(story.rows().len() < working.rows().len() && working.rows().len() <= tree.events.len());
        }
    }

    #[test]
    fn what_has_no_row_is_counted_by_the_row_that_it_belongs_to() {
        for tree in [small(), bowl(), fishbowl()] {
            let index = Index::of(&tree);
            for level in Level::ALL {
                let shown = Shown::with(&tree, &index, level, &Filter::default());
                let untold: u32 = shown.rows().iter().map(|&id| shown.untold(id)).sum();
                assert_eq!(untold as usize + shown.rows().len(), tree.events.len());
            }
        }
    }

    #[test]
    fn the_story_of_the_small_tree_is_its_rays_and_what_they_see() {
        let story = shown(Level::Story, &Filter::default());
        assert_eq!(story.rows(), [0, 1, 7, 10, 11]);
        assert_eq!((story.parent(9), story.depth(9), story.untold(7)), (Some(7), 2, 2));
        assert_eq!(story.untold(0), 5);
    }

    #[test]
    fn a_filter_keeps_what_it_finds_and_all_that_is_above_it() {
        let filter = Filter { objects: ["a".to_owned()].into(), kinds: [Kind::Primitive].into(), ..Filter::default() };
        let all = shown(Level::Everything, &filter);
        assert_eq!(all.rows(), [0, 2, 3, 4, 7, 8, 9]);
        assert_eq!(all.steps(), [3, 4, 9]);
        assert_eq!((all.hidden_by_filter(), all.found_deeper()), (5, 0));
        let story = shown(Level::Story, &filter);
        assert!(story.steps().is_empty());
        assert_eq!((story.rows(), story.found_deeper()), ([0].as_slice(), 3));
    }

    #[test]
    fn rows_between_two_events_are_those_after_the_first() {
        let all = shown(Level::Everything, &Filter::default());
        assert_eq!(all.rows_between(2, 5), [3, 4]);
        assert!(all.rows_between(3, 4).is_empty());
    }
}
