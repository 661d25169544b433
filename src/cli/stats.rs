//! `--stats`: what a picture took, as JSON.

use crate::record::RayKind;
use crate::scene::{Reason, Scene, reasons};
use crate::trace::{Overlap, Tally};
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
    /// Where transparent objects fill the same space, which the scene forbids.
    pub overlaps: Vec<OverlapStats<'a>>,
}

/// Two transparent objects that fill the same space.
#[derive(Debug, Serialize)]
pub struct OverlapStats<'a> {
    pub objects: [&'a str; 2],
    /// How many rays found it.
    pub rays: u64,
    /// The first pixel whose rays did.
    pub pixel: [u32; 2],
    /// The hit times between which that ray is in both.
    pub interval: [f64; 2],
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

/// Where transparent objects fill the same space.
pub fn overlaps<'a>(scene: &'a Scene, tally: &'a Tally) -> Vec<OverlapStats<'a>> {
    let stats = |(objects, overlap): ([&'a str; 2], &Overlap)| OverlapStats {
        objects,
        rays: overlap.rays,
        pixel: overlap.pixel,
        interval: overlap.interval,
    };
    tally.overlaps().named(scene).map(stats).collect()
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
