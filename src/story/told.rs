//! A recorded tree as a story: how much of it is told, which rows are open, and where one stands in it.

use super::filter::Filter;
use super::index::Index;
use super::kind::Kind;
use super::level::Level;
use super::outline::Outline;
use super::shown::Shown;
use super::step::{Step, after, before};
use crate::record::{EventId, What};
use crate::trace::RayTree;
use std::sync::Arc;

/// A tree with all that stepping through it needs.
#[derive(Debug)]
pub struct Story {
    tree: Arc<RayTree>,
    index: Arc<Index>,
    level: Level,
    filter: Filter,
    matches: Option<Vec<bool>>,
    shown: Shown,
    outline: Outline,
    stops: Arc<[EventId]>,
    selected: EventId,
}

/// Where one stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The number of the step, from 1; where one stands between two steps, that of the one before, which may be 0.
    pub step: usize,
    /// How many steps there are at this level and with this filter.
    pub steps: usize,
    /// Whether one stands at a step, not between two.
    pub is_step: bool,
}

impl Story {
    /// The story of a tree, at its beginning.
    #[must_use]
    pub fn new(tree: Arc<RayTree>, level: Level, filter: Filter) -> Self {
        let index = Arc::new(Index::of(&tree));
        let matches = filter.matches(&tree, &index);
        let shown = Shown::new(&tree, &index, level, matches.as_deref());
        let outline = Outline::new(&tree, &index, &shown, level);
        Self { tree, index, level, filter, matches, shown, outline, stops: Arc::new([]), selected: 0 }
    }

    /// What happened.
    #[must_use]
    pub fn tree(&self) -> &Arc<RayTree> {
        &self.tree
    }

    /// What is known about its events by number.
    #[must_use]
    pub fn index(&self) -> &Arc<Index> {
        &self.index
    }

    /// Which events have rows.
    #[must_use]
    pub fn shown(&self) -> &Shown {
        &self.shown
    }

    /// Which rows are listed.
    #[must_use]
    pub fn outline(&self) -> &Outline {
        &self.outline
    }

    /// How much is told.
    #[must_use]
    pub fn level(&self) -> Level {
        self.level
    }

    /// What is looked for.
    #[must_use]
    pub fn filter(&self) -> &Filter {
        &self.filter
    }

    /// The selected event.
    #[must_use]
    pub fn selected(&self) -> EventId {
        self.selected
    }

    /// Selects an event and gives it a row; one that does not exist is passed over.
    pub fn select(&mut self, id: EventId) {
        if id < self.index.len() {
            self.outline.reveal(&self.index, &self.shown, id);
            self.selected = id;
        }
    }

    /// Selects the event where the story gets interesting: the first closest hit, or the nothing that was seen.
    pub fn select_outcome(&mut self) {
        let outcome = self.tree.events.iter().find(|e| matches!(e.what, What::Hit { .. } | What::Nothing { .. }));
        if let Some(id) = outcome.map(|event| event.id) {
            self.select(id);
        }
    }

    /// Where a move leads to; none if there is nothing there.
    #[must_use]
    pub fn target(&self, step: Step) -> Option<EventId> {
        step.target(&self.index, &self.shown, &self.stops, self.selected)
    }

    /// Moves; stays where there is nothing to move to. Returns whether it moved.
    pub fn step(&mut self, step: Step) -> bool {
        let target = self.target(step);
        if let Some(target) = target {
            self.select(target);
        }
        target.is_some()
    }

    /// The next or the previous event of a kind among those that are stepped to.
    #[must_use]
    pub fn of_kind(&self, kind: Kind, forward: bool) -> Option<EventId> {
        let steps = self.shown.steps_of(kind);
        if forward { after(steps, self.selected) } else { before(steps, self.selected) }
    }

    /// Where one stands among the steps of this level and filter.
    #[must_use]
    pub fn place(&self) -> Place {
        let steps = self.shown.steps();
        let found = steps.binary_search(&self.selected);
        let step = found.map_or_else(|between| between, |at| at + 1);
        Place { step, steps: steps.len(), is_step: found.is_ok() }
    }

    /// The event of the n-th step, counted from 1.
    #[must_use]
    pub fn nth(&self, n: usize) -> Option<EventId> {
        self.shown.steps().get(n.checked_sub(1)?).copied()
    }

    /// Tells more or less. The selected event keeps its row.
    pub fn set_level(&mut self, level: Level) {
        if self.level != level {
            self.level = level;
            self.shown = Shown::new(&self.tree, &self.index, level, self.matches.as_deref());
            self.outline = Outline::new(&self.tree, &self.index, &self.shown, level);
            self.select(self.selected);
        }
    }

    /// Looks for something. `matches` are what [`Filter::matches`] says, worked out by whoever has the time for it.
    pub fn set_filter(&mut self, filter: Filter, matches: Option<Vec<bool>>) {
        (self.filter, self.matches) = (filter, matches);
        self.shown = Shown::new(&self.tree, &self.index, self.level, self.matches.as_deref());
        self.outline.list(&self.index, &self.shown);
        for &found in self.shown.steps().iter().take(if self.matches.is_some() { FOUND_AND_SHOWN } else { 0 }) {
            self.outline.reveal(&self.index, &self.shown, found);
        }
        self.select(self.selected);
    }

    /// Opens or closes a row; a selection that would vanish moves up to the row that stays.
    pub fn set_open(&mut self, id: EventId, open: bool) {
        self.outline.set_open(&self.index, &self.shown, id, open);
        let hides = (id + 1..self.index.end(id)).contains(&self.selected);
        let selected = if !open && hides { id } else { self.selected };
        self.select(selected);
    }

    /// Opens or closes all rows. The selected one stays.
    pub fn set_all_open(&mut self, open: bool) {
        self.outline.set_all(&self.index, &self.shown, open);
        self.select(self.selected);
    }

    /// Whether the rows below this one are shown; none if there are none.
    #[must_use]
    pub fn is_open(&self, id: EventId) -> Option<bool> {
        self.outline.is_open(&self.index, &self.shown, id)
    }

    /// How many events this row alone tells of, and how many of them were skipped, cut off or rejected.
    #[must_use]
    pub fn inside(&self, id: EventId) -> (u32, u32) {
        let inside = self.outline.inside(&self.index, &self.shown, id);
        // Only where all of the row's parts are out of sight are its skips those of all its parts.
        let folded = inside == self.index.end(id) - id - 1;
        (inside, if folded { self.index.skips(id + 1, self.index.end(id)) } else { 0 })
    }

    /// The level of a row in the outline, from 0. A guest stands one below the row that it belongs to.
    #[must_use]
    pub fn depth(&self, id: EventId) -> u16 {
        self.shown.depth(id)
    }

    /// Where breakpoints stop, ascending.
    #[must_use]
    pub fn stops(&self) -> &[EventId] {
        &self.stops
    }

    /// The same list, to be held on to.
    #[must_use]
    pub fn stops_shared(&self) -> &Arc<[EventId]> {
        &self.stops
    }

    /// Sets where breakpoints stop, ascending.
    pub fn set_stops(&mut self, stops: Vec<EventId>) {
        if *self.stops != *stops {
            self.stops = stops.into();
        }
    }

    /// Plays on by some steps, up to the first stop on the way; returns whether the end of the story or a stop ended it.
    pub fn play(&mut self, steps: usize) -> bool {
        for _ in 0..steps {
            let (next, stop) = (self.target(Step::Next), self.target(Step::NextStop));
            // Where breakpoints stop need not be told at this level.
            let target = [next, stop].into_iter().flatten().min();
            let Some(target) = target else { return true };
            self.select(target);
            if Some(target) == stop {
                return true;
            }
        }
        false
    }
}

/// So many of the events that a filter finds are unfolded at once. More would hide how they lie in the tree, fewer would hide
/// what was looked for.
const FOUND_AND_SHOWN: usize = 200;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::story::testing::{bowl, fishbowl, small};

    fn story(tree: RayTree, level: Level) -> Story {
        Story::new(Arc::new(tree), level, Filter::default())
    }

    #[test]
    fn a_selected_event_has_a_row_whatever_the_level() {
        for level in Level::ALL {
            let mut story = story(bowl(), level);
            for id in [story.index().len() - 1, 20, 0] {
                story.select(id);
                assert!(story.outline().row_of(id).is_some(), "event {id} at {level:?}");
            }
            story.select(20);
            story.set_open(0, false);
            assert_eq!(story.selected(), 0);
        }
    }

    #[test]
    fn changing_the_level_keeps_the_selection_and_its_row() {
        let mut story = story(fishbowl(), Level::Everything);
        story.select(777);
        for level in [Level::Story, Level::Working, Level::Everything] {
            story.set_level(level);
            assert_eq!(story.selected(), 777);
            assert!(story.outline().row_of(777).is_some());
        }
    }

    #[test]
    fn places_count_the_steps_of_the_level() {
        let mut story = story(small(), Level::Story);
        story.select(7);
        assert_eq!(story.place(), Place { step: 3, steps: 5, is_step: true });
        story.select(8);
        assert_eq!(story.place(), Place { step: 3, steps: 5, is_step: false });
        assert_eq!([0, 1, 5, 6].map(|n| story.nth(n)), [None, Some(0), Some(11), None]);
    }

    #[test]
    fn playing_stops_at_a_breakpoint_between_two_steps_and_at_the_end() {
        let mut story = story(small(), Level::Story);
        story.set_stops(vec![4]);
        assert!(!story.play(1));
        assert_eq!(story.selected(), 1);
        assert!(story.play(5));
        assert_eq!(story.selected(), 4, "the breakpoint lies between two steps of this level");
        assert!(story.play(50));
        assert_eq!(story.selected(), 11);
    }

    #[test]
    fn going_to_a_kind_passes_over_all_others() {
        let mut story = story(small(), Level::Everything);
        assert_eq!(story.of_kind(Kind::Primitive, true), Some(3));
        story.select(9);
        assert_eq!((story.of_kind(Kind::Primitive, false), story.of_kind(Kind::Ray, true)), (Some(6), None));
    }

    #[test]
    fn what_a_filter_finds_is_unfolded() {
        let mut story = story(fishbowl(), Level::Everything);
        let filter = Filter { kinds: [Kind::Snell].into(), ..Filter::default() };
        let matches = filter.matches(story.tree(), story.index());
        story.set_filter(filter, matches);
        let laws = story.tree().events.iter().filter(|event| matches!(event.what, What::Snell { .. })).count();
        assert!(laws > 0 && story.place().steps == laws);
        for id in story.shown().steps().iter().take(5) {
            assert!(story.outline().row_of(*id).is_some());
        }
        story.set_filter(Filter::default(), None);
        assert_eq!(story.place().steps, story.tree().events.len());
    }

    #[test]
    fn a_folded_row_says_how_many_things_it_leaves_out() {
        let story = story(bowl(), Level::Story);
        let hit = story.tree().events.iter().find(|event| matches!(event.what, What::Hit { .. })).unwrap().id;
        assert_eq!(story.inside(hit), (0, 0));
        let told: u32 = story.shown().rows().iter().map(|&id| story.inside(id).0).sum();
        assert_eq!(told as usize + story.shown().rows().len(), story.tree().events.len());
    }
}
