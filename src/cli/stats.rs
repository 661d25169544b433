//! `--stats`: what a picture took, as JSON.

use crate::record::{Lookup, RayKind};
use crate::scene::{Coat, Material, Object, Scene, Texture};
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
    /// What surfaces carry, and how often it was looked up.
    pub lookups: BTreeMap<&'static str, u64>,
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

/// How often each thing that a surface can carry was looked up.
pub fn lookups(tally: &Tally) -> BTreeMap<&'static str, u64> {
    Lookup::ALL.iter().map(|&lookup| (lookup.name(), tally.lookups(lookup))).collect()
}

/// What the scene calls for, from its lights and the materials that its objects use.
pub fn effects(scene: &Scene) -> Vec<Effect> {
    let used = |counts: &dyn Fn(&Material) -> bool| {
        let mut names: Vec<&str> = scene
            .objects
            .iter()
            .flat_map(|object| object.surface_materials().chain([object.material]))
            .filter_map(|index| scene.materials.get(index))
            .filter(|material| counts(material))
            .map(|material| material.name.as_str())
            .collect();
        names.sort_unstable();
        names.dedup();
        names.join(", ")
    };
    let carrying = |has: fn(&Coat) -> bool| used(&|material| material.coat.as_deref().is_some_and(has));
    let lights: Vec<&str> = scene.lights.iter().map(|light| light.name.as_str()).collect();
    let has_details = |object: &&Object| object.coats.iter().flatten().any(|coat| !coat.details.is_empty());
    let detailed: Vec<&str> = scene.objects.iter().filter(has_details).map(|object| object.name.as_str()).collect();
    let environment = scene.environment.as_ref().map_or("", |environment| environment.map.layout().name());
    vec![
        Effect::new("shadows", "lights", &lights.join(", ")),
        Effect::new("reflection", "reflecting materials", &used(&|material| material.reflectivity > 0.0)),
        Effect::new("refraction", "transparent materials", &used(&|material| material.transparency > 0.0)),
        Effect::new(
            "image textures",
            "materials with pictures",
            &carrying(|coat| matches!(coat.texture, Some(Texture::Image { .. }))),
        ),
        Effect::new(
            "solid textures",
            "materials with solid textures",
            &carrying(|coat| matches!(coat.texture, Some(Texture::Solid(_)))),
        ),
        Effect::new("bumps", "bumpy materials", &carrying(|coat| coat.bump.is_some())),
        Effect::new("frames", "materials with a grain", &carrying(|coat| coat.frame.is_some())),
        Effect::new("details", "objects with details", &detailed.join(", ")),
        Effect::new("environment", "environment", environment),
    ]
}

impl Effect {
    fn new(name: &'static str, what: &str, names: &str) -> Self {
        let why = if names.is_empty() { format!("no {what}") } else { format!("{what}: {names}") };
        Self { name, called_for: !names.is_empty(), why }
    }
}
