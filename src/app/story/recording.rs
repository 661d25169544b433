//! The recorded pixel that all panels look at, and the one selection that they share.

use crate::app::story::outline::Outline;
use crate::app::story::stepper::Step;
use crate::record::{EventId, RayKind, What};
use crate::scene::Scene;
use crate::shape::Method;
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
    /// Which rows are shown.
    pub outline: Outline,
    /// All hits, in the order in which they happened.
    pub hits: Vec<HitMark>,
    /// The method that hits were found by, where it is not the scene's own.
    pub by: Option<Method>,
    /// The events that an edit of the scene changed.
    pub changed: BTreeSet<EventId>,
    selected: EventId,
    /// Whether the selection moved since the tree panel last scrolled to it.
    pub selection_moved: bool,
}

impl Recording {
    /// Records a pixel.
    #[must_use]
    pub fn new(scene: &Arc<Scene>, pixel: [u32; 2]) -> Self {
        Self::of_tree(Arc::clone(scene), pixel, Arc::new(record_pixel(scene, pixel[0], pixel[1])), None)
    }

    /// A pixel that was recorded elsewhere, by a method that may not be the scene's own.
    #[must_use]
    pub fn of_tree(scene: Arc<Scene>, pixel: [u32; 2], tree: Arc<RayTree>, by: Option<Method>) -> Self {
        let (outline, hits) = (Outline::new(&tree), hits(&tree));
        Self { pixel, scene, tree, outline, hits, by, changed: BTreeSet::new(), selected: 0, selection_moved: true }
    }

    /// The selected event: the step of the story at which all panels stand.
    #[must_use]
    pub fn selected(&self) -> EventId {
        self.selected
    }

    /// Selects an event and shows its row.
    pub fn select(&mut self, id: EventId) {
        if id < self.tree.end() {
            self.outline.reveal(&self.tree, id);
            self.selection_moved |= self.selected != id;
            self.selected = id;
        }
    }

    /// Moves the selection; stays where there is nothing to move to.
    pub fn step(&mut self, step: Step) {
        if let Some(target) = step.target(&self.tree, self.selected) {
            self.select(target);
        }
    }

    /// Selects the event where the story gets interesting: the first closest hit, or the nothing that was seen.
    pub fn select_outcome(&mut self) {
        let outcome = self.tree.events.iter().find(|e| matches!(e.what, What::Hit { .. } | What::Nothing { .. }));
        if let Some(id) = outcome.map(|event| event.id) {
            self.select(id);
        }
    }

    /// The event whose intervals are plotted, and the one whose d(t) is: the selected one, or if that is a hit, the
    /// search that found it.
    #[must_use]
    pub fn plotted(&self) -> Plotted {
        let as_selected = Plotted { intervals: self.selected, signs: self.selected };
        let (What::Hit { object, leaf, .. } | What::Rejected { object, leaf, .. }) =
            &self.tree.event(self.selected).what
        else {
            return as_selected;
        };
        let is_object =
            |id: &EventId| matches!(&self.tree.event(*id).what, What::Object { name, .. } if name == object);
        let Some(search) = (0..self.selected).rev().find(is_object) else { return as_selected };
        let is_leaf = |id: &EventId| matches!(&self.tree.event(*id).what, What::Primitive { name, .. } if name == leaf);
        let primitive = (search..self.tree.subtree_end(search)).find(is_leaf);
        Plotted { intervals: search, signs: primitive.unwrap_or(search) }
    }

    /// Opens or folds a row; a selection that would vanish moves up to the row that stays.
    pub fn set_open(&mut self, id: EventId, open: bool) {
        self.outline.set_open(id, open);
        if self.outline.row_of(self.selected).is_none() {
            self.selected = id;
        }
    }
}

fn hits(tree: &RayTree) -> Vec<HitMark> {
    let mark = |event: &crate::record::Event| match &event.what {
        What::Hit { point, .. } => {
            let (kind, from) = ray_above(tree, event.id);
            Some(HitMark { event: event.id, kind, from, point: DVec3::from_array(*point) })
        }
        _ => None,
    };
    tree.events.iter().filter_map(mark).collect()
}

/// The ray that an event belongs to. A camera ray's event lies beside its hit, not above it.
fn ray_above(tree: &RayTree, id: EventId) -> (RayKind, Option<DVec3>) {
    let spawned = tree.path(id).into_iter().rev().find_map(|above| match &tree.event(above).what {
        What::Ray { ray, origin, .. } if *ray != RayKind::Camera => Some((*ray, Some(DVec3::from_array(*origin)))),
        _ => None,
    });
    spawned.unwrap_or((RayKind::Camera, None))
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

    #[test]
    fn a_selected_event_always_has_a_row() {
        let mut recording = bowl();
        for id in [recording.tree.end() - 1, 20, 0] {
            recording.select(id);
            assert!(recording.outline.row_of(id).is_some());
        }
        recording.select(20);
        recording.set_open(0, false);
        assert_eq!(recording.selected(), 0);
    }
}
