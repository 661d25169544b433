//! `--stats`: what a picture took, as JSON.

use crate::record::RayKind;
use crate::scene::Scene;
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
    pub effects: Vec<Effect>,
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
pub struct Effect {
    pub name: &'static str,
    pub called_for: bool,
    pub why: String,
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

/// What the scene calls for, from its lights and the materials that its objects use.
pub fn effects(scene: &Scene) -> Vec<Effect> {
    let used = |counts: fn(&crate::scene::Material) -> bool| {
        let mut names: Vec<&str> = scene
            .objects
            .iter()
            .flat_map(|object| object.leaf_materials.iter().chain([&object.material]))
            .filter_map(|&index| scene.materials.get(index))
            .filter(|material| counts(material))
            .map(|material| material.name.as_str())
            .collect();
        names.sort_unstable();
        names.dedup();
        names.join(", ")
    };
    let lights: Vec<&str> = scene.lights.iter().map(|light| light.name.as_str()).collect();
    vec![
        Effect::new("shadows", "lights", &lights.join(", ")),
        Effect::new("reflection", "reflecting materials", &used(|material| material.reflectivity > 0.0)),
        Effect::new("refraction", "transparent materials", &used(|material| material.transparency > 0.0)),
    ]
}

impl Effect {
    fn new(name: &'static str, what: &str, names: &str) -> Self {
        let why = if names.is_empty() { format!("no {what}") } else { format!("{what}: {names}") };
        Self { name, called_for: !names.is_empty(), why }
    }
}
