//! What a study is asked to do, and what it works with.

use super::timing::Repeat;
use super::{Goal, Knob, Setting, Stopwatch, Store, Study};
use crate::trace::Progress;

/// What is to be measured, and for how long.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// The most columns of the pictures that are measured. They are fewer where the budget would not do for enough repeats.
    pub width: u32,
    /// How many seconds all of it may take, about.
    pub budget: f64,
    /// The knobs that are tried.
    pub knobs: Vec<Knob>,
    /// The seed of the pictures that are measured, if not the scene's own.
    pub seed: Option<u32>,
    /// Whether combinations of knobs are measured, too.
    pub combines: bool,
    /// What is to be answered in the end: combinations are chosen for it.
    pub goals: Vec<Goal>,
}

impl Default for Plan {
    fn default() -> Self {
        Self { width: 160, budget: 30.0, knobs: Knob::ALL.to_vec(), seed: None, combines: true, goals: Vec::new() }
    }
}

/// What a study cannot do by itself.
pub struct Tools<'a> {
    /// Takes time.
    pub stopwatch: &'a mut dyn Stopwatch,
    /// Keeps references.
    pub store: &'a mut dyn Store,
    /// Cancels.
    pub progress: &'a Progress,
    /// Is shown what is known after each round.
    pub watch: &'a mut dyn FnMut(&dyn Fn() -> Study),
}

/// What an earlier run measured of the same scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Earlier {
    /// The size of its pictures, in columns and rows.
    pub size: [u32; 2],
    /// The seed of its pictures, if it was not the scene's own.
    pub seed: Option<u32>,
    /// Each look at the scene with what it took.
    pub repeats: Vec<(Vec<Setting>, Vec<Repeat>)>,
    /// What the pinned work took.
    pub pinned: Vec<Repeat>,
}
