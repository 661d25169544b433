//! The comparison of the story that is shown with the pinned one, worked out behind the window's back.

use super::pin::Pin;
use crate::app::frame::background::Background;
use crate::compare::{Departure, Standing, Tolerance, TreeDifference, difference};
use egui::Context;
use std::sync::Arc;

/// Two stories beside each other.
pub struct Stories {
    /// The story that was shown.
    pub left: Pin,
    /// The pinned one.
    pub right: Pin,
    /// Their events in pairs.
    pub pairs: TreeDifference,
    /// The first difference.
    pub first: Option<Departure>,
    /// The first event that goes another way.
    pub parting: Option<Departure>,
    /// The rows that hold something different, and all rows below those that are in one story alone.
    pub different: Vec<usize>,
}

impl Stories {
    fn new(left: Pin, right: Pin) -> Self {
        let exact = Tolerance::EXACT;
        let pairs = difference(&left.tree, &right.tree, &exact);
        let first = pairs.first_departure(&left.tree, &right.tree, &exact);
        let parting = pairs.first_parting(&left.tree, &right.tree, &exact);
        let different = (0..pairs.pairs.len()).filter(|&row| pairs.pairs[row].different > 0).collect();
        Self { left, right, pairs, first, parting, different }
    }

    /// The next row after `row`, or the one before it, that is not the same.
    pub fn neighbour(&self, row: Option<usize>, is_forward: bool) -> Option<usize> {
        let is_different = |&row: &usize| self.pairs.pairs[row].standing != Standing::Same;
        if is_forward {
            (row.map_or(0, |row| row + 1)..self.pairs.pairs.len()).find(is_different)
        } else {
            (0..row.unwrap_or(self.pairs.pairs.len())).rev().find(is_different)
        }
    }
}

/// The newest comparison, and the one that is being worked out.
#[derive(Default)]
pub struct StoriesJob {
    shown: Option<Arc<Stories>>,
    running: Option<(Pin, Pin, Background<Arc<Stories>>)>,
}

impl StoriesJob {
    /// The comparison of these two; none while it is worked out, for another one's figures would be taken for its own.
    pub fn update(&mut self, ctx: &Context, left: &Pin, right: &Pin) -> Option<&Arc<Stories>> {
        if let Some((_, _, job)) = &self.running {
            let news = job.take();
            if news.is_some() || job.is_finished() {
                (self.running, self.shown) = (None, news);
            }
        }
        // Where the pinned story itself is looked at, the comparison stays.
        let is_shown = self
            .shown
            .as_ref()
            .is_some_and(|shown| shown.right.is(&right.tree) && (shown.left.is(&left.tree) || right.is(&left.tree)));
        let is_running = self.running.as_ref().is_some_and(|(a, b, _)| a.is(&left.tree) && b.is(&right.tree));
        if !is_shown && !is_running {
            let (a, b) = (left.clone(), right.clone());
            let job = Background::start(ctx, "compare", move |_, publish| publish(Arc::new(Stories::new(a, b))));
            self.running = job.map(|job| (left.clone(), right.clone(), job));
            self.shown = None;
        }
        self.shown.as_ref()
    }

    /// The comparison that is shown.
    pub fn shown(&self) -> Option<&Arc<Stories>> {
        self.shown.as_ref()
    }

    /// Whether one is being worked out.
    pub fn is_running(&self) -> bool {
        self.running.is_some()
    }

    /// Forgets everything.
    pub fn reset(&mut self) {
        *self = Self::default();
    }
}
