//! `--stats`: what a picture took, as JSON.

use crate::record::RayKind;
use crate::scene::{Reason, Scene, reasons};
use crate::trace::Tally;
use serde::Serialize;
use std::collections::BTreeMap;
use std::time::Duration;

/// What a picture took.
#[derive(Debug, Serialize)]
pub struct Stats<'a> {
    pub scene: &'a str,
    pub width: u32,
    pub height: u32,
    /// Pixels that were finished; fewer than all if it was interrupted.
    pub pixels: usize,
    pub interrupted: bool,
    pub threads: usize,
    pub rays: BTreeMap<&'static str, u64>,
    pub tests: BTreeMap<&'static str, u64>,
    pub extents: Extents,
    pub seconds: Seconds,
    pub effects: Vec<EffectStats>,
}

/// Tests against the boxes of single solids; those of the hierarchy are not counted.
#[derive(Debug, Serialize)]
pub struct Extents {
    pub tests: u64,
    /// Tests that spared the work behind them.
    pub misses: u64,
}

/// Wall-clock seconds by phase, to the microsecond.
#[derive(Debug, Serialize)]
pub struct Seconds {
    pub load: f64,
    pub render: f64,
    pub write: f64,
}

/// Something that a scene may or may not call for.
#[derive(Debug, PartialEq, Eq, Serialize)]
pub struct EffectStats {
    pub name: &'static str,
    pub called_for: bool,
    pub why: String,
    /// How often its code was entered.
    pub calls: u64,
    /// Rays that would not have been sent without it.
    pub rays: u64,
}

impl Seconds {
    pub fn new(load: Duration, render: Duration, write: Duration) -> Self {
        let seconds = |phase: Duration| phase.as_micros() as f64 / 1e6;
        Self { load: seconds(load), render: seconds(render), write: seconds(write) }
    }
}

/// Rays by kind.
pub fn rays(tally: &Tally) -> BTreeMap<&'static str, u64> {
    RayKind::ALL.iter().map(|&kind| (kind.name(), tally.rays(kind))).collect()
}

/// Tests by shape.
pub fn tests(tally: &Tally) -> BTreeMap<&'static str, u64> {
    tally.shape_tests().into_iter().collect()
}

/// Tests against the boxes of single solids; those of the hierarchy are not counted.
pub fn extents(tally: &Tally) -> Extents {
    Extents { tests: tally.extent_tests(), misses: tally.extent_misses() }
}

/// What the scene calls for, and what came of it.
pub fn effects(scene: &Scene, tally: &Tally) -> Vec<EffectStats> {
    let stats = |Reason { effect, called_for, why }| EffectStats {
        name: effect.name(),
        called_for,
        why,
        calls: tally.calls(effect),
        rays: tally.sent(effect),
    };
    reasons(scene).into_iter().map(stats).collect()
}
