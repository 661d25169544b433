//! The recorded pixel that all panels look at, and the one selection that they share.

use crate::record::{EventId, RayKind, What};
use crate::scene::Scene;
use crate::shape::Method;
use crate::story::{Filter, Index, Level, Step, Story};
use crate::trace::{RayTree, record_pixel};
use glam::DVec3;
use std::collections::BTreeSet;
use std::sync::Arc;

/// A hit, and the ray that made it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HitMark {
    /// The event of the hit.
    pub event: EventId,
    /// Why the ray was sent.
    pub kind: RayKind,
    /// Where the ray started, in world space; none for the camera ray.
    pub from: Option<DVec3>,
    /// Where it hit, in world space.
    pub point: DVec3,
}

/// What the plots look at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plotted {
    /// The event whose intervals are plotted.
    pub intervals: EventId,
    /// The event whose d(t) is plotted.
    pub signs: EventId,
}

/// A pixel's tree with what the panels need beside it.
#[derive(Debug)]
pub struct Recording {
    /// The pixel.
    pub pixel: [u32; 2],
    /// The scene that it was recorded in.
    pub scene: Arc<Scene>,
    /// What happened.
    pub tree: Arc<RayTree>,
    /// All hits, in the order in which they happened.
    pub hits: Vec<HitMark>,
    /// The method that hits were found by, where it is not the scene's own.
    pub by: Option<Method>,
    /// The time on the current ray that the drawings mark; none where nobody asked for one.
    pub probe_t: Option<f64>,
    /// The events that an edit of the scene changed.
    pub changed: BTreeSet<EventId>,
    /// The events that a lesson marks.
    pub marked: BTreeSet<EventId>,
    /// The last event whose row is told while a lesson's questions are open: those behind it would tell the answers.
    pub veil: Option<EventId>,
    story: Story,
    plotted: Plotted,
    /// Whether the selection or the rows moved since the tree panel last scrolled to it.
    pub(in crate::app) selection_moved: bool,
}

impl Recording {
    /// Records a pixel.
    #[must_use]
    pub fn new(scene: &Arc<Scene>, pixel: [u32; 2]) -> Self {
        Self::told(scene, pixel, Level::default(), Filter::default())
    }

    /// Records a pixel and tells its story at a level and with a filter.
    #[must_use]
    pub fn told(scene: &Arc<Scene>, pixel: [u32; 2], level: Level, filter: Filter) -> Self {
        let tree = Arc::new(record_pixel(scene, pixel[0], pixel[1]));
        Self::of_tree(Arc::clone(scene), pixel, tree, None).told_as(level, filter)
    }

    /// A pixel that was recorded elsewhere, by a method that may not be the scene's own.
    #[must_use]
    pub fn of_tree(scene: Arc<Scene>, pixel: [u32; 2], tree: Arc<RayTree>, by: Option<Method>) -> Self {
        let story = Story::new(Arc::clone(&tree), Level::default(), Filter::default());
        let hits = hits(&tree, story.index());
        let plotted = Plotted { intervals: 0, signs: 0 };
        Self {
            pixel,
            scene,
            tree,
            hits,
            by,
            probe_t: None,
            changed: BTreeSet::new(),
            marked: BTreeSet::new(),
            veil: None,
            story,
            plotted,
            selection_moved: true,
        }
    }

    /// How many rows are told: all, but for those that a lesson keeps for its answers. Whoever steps further sees further.
    #[must_use]
    pub fn rows_told(&self) -> usize {
        let outline = self.story.outline();
        let Some(last) = self.last_told() else { return outline.len() };
        (0..outline.len()).take_while(|&place| outline.row(place).is_some_and(|id| id <= last)).count()
    }

    /// The last event that is told, where a lesson keeps the others for its answers.
    #[must_use]
    pub fn last_told(&self) -> Option<EventId> {
        self.veil.map(|veil| veil.max(self.story.selected()))
    }

    /// Whether a lesson keeps for its answers what came of an event: of the one that it asks about, and of those that are still
    /// under way there.
    #[must_use]
    pub fn keeps_outcome(&self, id: EventId) -> bool {
        self.last_told().is_some_and(|last| {
            let is_under_way = id <= last && last < self.story.index().end(id);
            // Who stepped further wants to know what comes of the event where they stand.
            is_under_way && (id < last || self.veil == Some(id))
        })
    }

    /// The same, told at a level and with a filter.
    #[must_use]
    pub fn told_as(mut self, level: Level, filter: Filter) -> Self {
        self.change(|story| {
            story.set_level(level);
            let matches = filter.matches(story.tree(), story.index());
            story.set_filter(filter, matches);
        });
        self
    }

    /// Origin and direction, where it is of a ray of its own and of no pixel.
    #[must_use]
    pub fn loose_ray(&self) -> Option<[DVec3; 2]> {
        loose_ray(&self.tree)
    }

    /// How it is told: levels, rows, and where one stands.
    #[must_use]
    pub const fn story(&self) -> &Story {
        &self.story
    }

    /// Changes how it is told, or where one stands.
    pub(in crate::app) fn change<T>(&mut self, change: impl FnOnce(&mut Story) -> T) -> T {
        let outcome = change(&mut self.story);
        self.plotted = plotted(&self.story);
        self.selection_moved = true;
        outcome
    }

    /// The selected event: the step of the story at which all panels stand.
    #[must_use]
    pub fn selected(&self) -> EventId {
        self.story.selected()
    }

    /// Selects an event and shows its row.
    pub fn select(&mut self, id: EventId) {
        self.change(|story| story.select(id));
    }

    /// Moves the selection; stays where there is nothing to move to.
    pub fn step(&mut self, step: Step) {
        self.change(|story| story.step(step));
    }

    /// Selects the event where the story gets interesting: the first closest hit, or the nothing that was seen.
    pub fn select_outcome(&mut self) {
        self.change(Story::select_outcome);
    }

    /// The event whose intervals are plotted, and the one whose d(t) is: the selected one, or if that is a hit, the
    /// search that found it.
    #[must_use]
    pub fn plotted(&self) -> Plotted {
        self.plotted
    }

    /// Opens or folds a row; a selection that would vanish moves up to the row that stays.
    pub fn set_open(&mut self, id: EventId, open: bool) {
        let before = (self.selected(), self.selection_moved);
        self.change(|story| story.set_open(id, open));
        // Folding is no reason to scroll.
        self.selection_moved = before.1 || before.0 != self.selected();
    }
}

/// Origin and direction, where a tree is of a ray of its own and of no pixel.
#[must_use]
pub fn loose_ray(tree: &RayTree) -> Option<[DVec3; 2]> {
    match tree.events.first()?.what {
        What::LooseRay { origin, direction } => Some([origin, direction].map(DVec3::from_array)),
        _ => None,
    }
}

fn plotted(story: &Story) -> Plotted {
    let (tree, index, selected) = (story.tree(), story.index(), story.selected());
    let as_selected = Plotted { intervals: selected, signs: selected };
    let (What::Hit { object, leaf, .. } | What::Rejected { object, leaf, .. }) = &tree.event(selected).what else {
        return as_selected;
    };
    let is_object = |id: &EventId| matches!(&tree.event(*id).what, What::Object { name, .. } if name == object);
    // A ray looks for hits before it is hit, so its own events are enough.
    let Some(search) = (index.scope(selected).event..selected).rev().find(is_object) else { return as_selected };
    let is_leaf = |id: &EventId| matches!(&tree.event(*id).what, What::Primitive { name, .. } if name == leaf);
    let primitive = (search..index.end(search)).find(is_leaf);
    Plotted { intervals: search, signs: primitive.unwrap_or(search) }
}

fn hits(tree: &RayTree, index: &Index) -> Vec<HitMark> {
    let mark = |event: &crate::record::Event| match &event.what {
        What::Hit { point, .. } => {
            let scope = index.scope(event.id);
            let from = match &tree.event(scope.event).what {
                What::Ray { origin, .. } => Some(DVec3::from_array(*origin)),
                _ => None,
            };
            Some(HitMark { event: event.id, kind: scope.kind, from, point: DVec3::from_array(*point) })
        }
        _ => None,
    };
    tree.events.iter().filter_map(mark).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{embedded_scene, load};

    fn bowl() -> Recording {
        let embedded = embedded_scene("csg/bowl").expect("the bowl is embedded");
        let scene = load(embedded.text, &embedded.name).expect("embedded scenes have no errors");
        let pixel = scene.pixels[0];
        Recording::new(&Arc::new(scene), pixel)
    }

    #[test]
    fn the_plots_of_a_hit_are_those_of_the_object_and_the_primitive_that_were_hit() {
        let mut recording = bowl();
        recording.select_outcome();
        let What::Hit { object, leaf, .. } = recording.tree.event(recording.selected()).what.clone() else {
            panic!("the first of the bowl's pixels shows the bowl");
        };
        let Plotted { intervals, signs } = recording.plotted();
        assert!(matches!(&recording.tree.event(intervals).what, What::Object { name, .. } if *name == object));
        assert!(matches!(&recording.tree.event(signs).what, What::Primitive { name, .. } if *name == leaf));
    }

    #[test]
    fn the_first_hit_is_the_camera_rays_and_all_hits_are_in_order() {
        let recording = bowl();
        assert_eq!((recording.hits[0].kind, recording.hits[0].from), (RayKind::Camera, None));
        assert!(recording.hits.is_sorted_by_key(|hit| hit.event));
    }
}
