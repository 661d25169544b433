//! `rayscope accuracy SCENE --pixel X,Y`: one ray by every method, as text or as JSON.

use super::failure::Failure;
use super::output::Output;
use super::progress::stopped_by_ctrl_c;
use super::trace::check_pixel;
use crate::cpu_time;
use crate::laboratory::{
    Number, OutlineRow, Story, Target, ThisRay, Timing, Told, this_ray, this_ray_text, time_methods,
};
use crate::scene::Scene;
use crate::trace::RayTree;
use crate::view;
use clap::ValueEnum;
use serde::Serialize;
use std::path::Path;

/// How often each method is timed.
const REPEATS: u32 = 15;

/// How the report is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Tables and an outline
    Text,
    /// One JSON object
    Json,
}

/// Measures one ray by every method, and writes what came of it; no output is the standard output.
pub fn report(scene: &Scene, target: Target, format: Format, output: Option<&Path>) -> Result<(), Failure> {
    if let Target::Pixel(pixel) = target {
        check_pixel(scene, pixel)?;
    }
    let output = Output::create(output)?;
    let progress = stopped_by_ctrl_c();
    let ray = this_ray(scene, target);
    let mut stopwatch = cpu_time::taken;
    let timings = time_methods(scene, target, &mut stopwatch, REPEATS, &|| progress.cancelled());
    if progress.cancelled() {
        return Err(Failure::interrupted("interrupted: nothing was written"));
    }
    let text = match format {
        Format::Text => this_ray_text(&ray, Some(&timings)),
        Format::Json => json(scene, &ray, &timings)?,
    };
    output.write(text.as_bytes())
}

/// The report as it is written. Digits are `null` where all are right, times where they cannot be told.
#[derive(Serialize)]
struct ReportFile<'a> {
    scene: &'a str,
    methods: Vec<MethodFile>,
    events: Vec<EventFile>,
}

#[derive(Serialize)]
struct MethodFile {
    name: &'static str,
    ns: Option<f64>,
    spread_ns: f64,
    repeats: u32,
    noise: Option<String>,
    /// Digits right of the time of the hit that is seen.
    hit_digits: Option<f64>,
    /// Whether there is such a hit, in the exact tree too.
    hit: bool,
    colour_digits: f64,
    verdict: String,
    parts: Option<PartingFile>,
}

#[derive(Serialize)]
struct PartingFile {
    event: u32,
    reason: String,
}

/// An event of the exact tree.
#[derive(Serialize)]
struct EventFile {
    id: u32,
    parent: Option<u32>,
    label: String,
    /// In the order of `methods`; `null` where the method's tree has no such event.
    methods: Vec<Option<ToldFile>>,
}

#[derive(Serialize)]
struct ToldFile {
    /// The same event in the method's own tree.
    event: u32,
    digits: Option<f64>,
    lost: f64,
    numbers: Vec<NumberFile>,
}

#[derive(Serialize)]
struct NumberFile {
    name: String,
    value: Vec<f64>,
    error: f64,
    digits: f64,
}

fn json(scene: &Scene, ray: &ThisRay, timings: &[Timing]) -> Result<String, Failure> {
    let methods = ray.stories.iter().zip(timings).map(|(story, timing)| method(story, timing, &ray.exact)).collect();
    let file = ReportFile { scene: &scene.title, methods, events: ray.outline().iter().map(event).collect() };
    let text = serde_json::to_string_pretty(&file).map_err(|error| Failure::refused(error.to_string()))?;
    Ok(text + "\n")
}

fn method(story: &Story, timing: &Timing, exact: &RayTree) -> MethodFile {
    MethodFile {
        name: story.method.name(),
        ns: timing.told().map(|seconds| seconds * 1e9),
        spread_ns: timing.spread * 1e9,
        repeats: timing.repeats,
        noise: timing.noise.map(|noise| noise.describe()),
        hit_digits: story.hit_digits(),
        hit: story.hit_digits().is_some(),
        colour_digits: story.colour_digits(exact),
        verdict: story.verdict(exact),
        parts: story
            .parting
            .as_ref()
            .map(|parting| PartingFile { event: parting.event, reason: parting.reason.clone() }),
    }
}

fn event(row: &OutlineRow) -> EventFile {
    let told = |told: &Option<(u32, &Told)>| {
        told.map(|(event, told)| ToldFile {
            event,
            digits: told.right,
            lost: told.lost,
            numbers: told.numbers.iter().map(number).collect(),
        })
    };
    EventFile {
        id: row.event.id,
        parent: row.event.parent,
        label: view::row(row.event).label,
        methods: row.by_method.iter().map(told).collect(),
    }
}

fn number(number: &Number) -> NumberFile {
    NumberFile { name: number.name.clone(), value: number.parts.clone(), error: number.error, digits: number.digits() }
}
