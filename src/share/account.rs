//! A recorded ray as it is told to other people: in which scene, along which steps, with which drawings.

use crate::record::{EventId, What};
use crate::scene::Scene;
use crate::story::{Filter, Index, Level, Shown};
use crate::trace::RayTree;
use crate::view::{Theme, View};

/// A recorded ray, and how it is told.
#[derive(Clone, Copy)]
pub struct Account<'a> {
    /// The scene that it was recorded in.
    pub scene: &'a Scene,
    /// The scene's name, or its file's.
    pub name: &'a str,
    /// What happened.
    pub tree: &'a RayTree,
    /// How much of it is told.
    pub level: Level,
    /// The drawings of each step; where none are named, those that tell most.
    pub views: &'a [&'static View],
    /// Light or dark.
    pub theme: Theme,
    /// A link that opens the same.
    pub link: Option<&'a str>,
}

/// The events that are told, in order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Steps {
    /// Their numbers.
    pub events: Vec<EventId>,
    /// For each how many of those before it hold it.
    pub depths: Vec<usize>,
    /// How many more there are at this level than could be told.
    pub left_out: usize,
}

impl Account<'_> {
    /// The steps at the level that is asked for; `most` at most, and how many are left out for that reason.
    #[must_use]
    pub fn steps(&self, most: usize) -> Steps {
        let shown = Shown::with(self.tree, &Index::of(self.tree), self.level, &Filter::default());
        let all = shown.steps();
        let events: Vec<EventId> = all.iter().copied().take(most).collect();
        let depths = events.iter().map(|&event| usize::from(shown.depth(event))).collect();
        Steps { left_out: all.len() - events.len(), events, depths }
    }

    /// What was traced, in words: `pixel 310, 240 of 640 × 480`.
    #[must_use]
    pub fn aim(&self) -> String {
        match self.tree.events.first().map(|event| &event.what) {
            Some(What::Pixel { x, y, width, height }) => format!("pixel {x}, {y} of {width} × {height}"),
            _ => "a given ray".to_owned(),
        }
    }

    /// The scene's title, or its name where it has none.
    #[must_use]
    pub fn title(&self) -> &str {
        if self.scene.title.is_empty() { self.name } else { &self.scene.title }
    }
}

impl Steps {
    /// What is to be said where not all steps could be told.
    #[must_use]
    pub fn left_out_in_words(&self, what: &str) -> Option<String> {
        let left_out = self.left_out;
        (left_out > 0).then(|| {
            format!(
                "{left_out} more steps at this level are left out: {what} hold {} at most. A coarser level tells the ray's \
                 whole story in fewer.",
                self.events.len()
            )
        })
    }
}
