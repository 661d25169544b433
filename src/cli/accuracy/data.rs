//! `--format json`: everything that was measured, and all that a later run needs to add to it.

use super::super::failure::Failure;
use super::Findings;
use crate::cpu_time;
use crate::laboratory::{Answer, Goal, Point, Repeat, Timing, what_is_true};
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// The knob of the scene as it stands, and of points with several knobs.
pub const STANDARD: &str = "scene";
pub const COMBINATION: &str = "combination";

#[derive(Serialize)]
struct File<'a> {
    scene: &'a str,
    version: &'static str,
    /// The scene's text and files as a number.
    identity: String,
    width: u32,
    height: u32,
    /// Of the scene's own picture.
    whole: [u32; 2],
    #[serde(skip_serializing_if = "Option::is_none")]
    seed: Option<u32>,
    interrupted: bool,
    clock: Clock,
    pinned: Pinned,
    reference: ReferenceData,
    points: Vec<PointData>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    answers: Vec<AnswerData>,
}

/// How time was taken.
#[derive(Serialize)]
struct Clock {
    /// `cpu`, or `wall` where there is no other.
    kind: &'static str,
    /// The smallest difference that it tells, in seconds.
    resolution: f64,
    /// The share of the time on the wall in which the thread had to wait.
    waiting: f64,
    /// How many threads were timed.
    threads: u32,
    /// Seconds on the wall of the whole run.
    spent: f64,
}

#[derive(Serialize)]
struct Pinned {
    seconds: f64,
    spread: f64,
    repeats: u32,
    #[serde(flatten)]
    each: Repeats,
}

#[derive(Serialize)]
struct ReferenceData {
    /// What its colours are.
    truth: &'static str,
    profile: Value,
    pictures: u32,
    cached: bool,
    /// The standard error of its mean, as a root mean square.
    error: f64,
}

#[derive(Serialize)]
struct PointData {
    knob: String,
    value: String,
    /// None where it is lost in noise.
    seconds: Option<f64>,
    spread: f64,
    repeats: u32,
    /// The root mean square error.
    error: f64,
    frontier: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    noise: Option<String>,
    p999: f64,
    wrong_pixels: usize,
    dissimilarity: f64,
    /// The root mean square difference from the scene as it stands.
    change: f64,
    control: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    instructions: Option<u64>,
    settings: Vec<SettingData>,
    #[serde(flatten)]
    each: Repeats,
}

/// A knob and its value.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct SettingData {
    /// Its name.
    pub knob: String,
    /// As it is shown.
    pub value: String,
}

/// The repeats behind a time.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub struct Repeats {
    /// Each in seconds.
    pub times: Vec<f64>,
    /// The share of each that was waited.
    pub waits: Vec<f64>,
}

impl Repeats {
    fn of(repeats: &[Repeat]) -> Self {
        let times = repeats.iter().map(|repeat| repeat.seconds).collect();
        Self { times, waits: repeats.iter().map(|repeat| repeat.waiting).collect() }
    }

    /// The repeats again.
    pub fn to_repeats(&self) -> Vec<Repeat> {
        let pairs = self.times.iter().zip(&self.waits);
        pairs.map(|(&seconds, &waiting)| Repeat { seconds, waiting }).collect()
    }
}

#[derive(Serialize)]
struct AnswerData {
    #[serde(skip_serializing_if = "Option::is_none")]
    for_time: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    for_error: Option<f64>,
    met: bool,
    name: String,
    profile: Value,
    /// Of the whole picture.
    seconds: f64,
    spread: f64,
    error: f64,
}

/// Everything as one JSON object.
pub fn json(findings: &Findings) -> Result<String, Failure> {
    let run = findings.run;
    let study = &run.study;
    let points = std::iter::once(&study.standard).chain(&study.points).zip(&run.repeats).enumerate();
    let file = File {
        scene: findings.scene_name,
        version: env!("CARGO_PKG_VERSION"),
        identity: format!("{:016x}", findings.identity),
        width: study.standard.picture.width,
        height: study.standard.picture.height,
        whole: [run.whole.width, run.whole.height],
        seed: findings.seed,
        interrupted: run.is_cut_short,
        clock: Clock {
            kind: if cpu_time::is_cpu_time() { "cpu" } else { "wall" },
            resolution: study.resolution,
            waiting: study.waiting,
            threads: 1,
            spent: run.spent,
        },
        pinned: pinned(&run.pinned_timing, &run.pinned),
        reference: ReferenceData {
            truth: what_is_true(findings.scene),
            profile: profile(&study.reference.profile)?,
            pictures: study.reference.pictures,
            cached: study.reference.cached,
            error: study.reference.error,
        },
        points: points
            .map(|(k, (point, repeats))| point_data(point, repeats, findings.instructions.get(k).copied().flatten()))
            .collect(),
        answers: run.answers.iter().map(answer_data).collect::<Result<_, _>>()?,
    };
    let text = serde_json::to_string_pretty(&file).map_err(|error| Failure::refused(error.to_string()))?;
    Ok(text + "\n")
}

fn pinned(timing: &Timing, repeats: &[Repeat]) -> Pinned {
    let Timing { seconds, spread, repeats: count, .. } = *timing;
    Pinned { seconds, spread, repeats: count, each: Repeats::of(repeats) }
}

fn profile(profile: &crate::scene::Profile) -> Result<Value, Failure> {
    let text = profile.to_json("").map_err(Failure::refused)?;
    serde_json::from_str(&text).map_err(|error| Failure::refused(error.to_string()))
}

fn point_data(point: &Point, repeats: &[Repeat], instructions: Option<u64>) -> PointData {
    let (knob, value) = knob_and_value(point);
    let setting = |setting: &crate::laboratory::Setting| SettingData {
        knob: setting.knob.name().to_owned(),
        value: setting.value.clone(),
    };
    PointData {
        knob,
        value,
        seconds: point.timing.told(),
        spread: point.timing.spread,
        repeats: point.timing.repeats,
        error: point.errors.rmse,
        frontier: point.on_frontier,
        noise: point.timing.noise.map(|noise| noise.describe()),
        p999: point.errors.p999,
        wrong_pixels: point.errors.wrong_pixels,
        dissimilarity: point.errors.dissimilarity,
        change: point.change.rmse,
        control: point.is_control(),
        instructions,
        settings: point.settings.iter().map(setting).collect(),
        each: Repeats::of(repeats),
    }
}

fn answer_data(answer: &Answer) -> Result<AnswerData, Failure> {
    let (for_time, for_error) = match answer.goal {
        Goal::Time(seconds) => (Some(seconds), None),
        Goal::Error(error) => (None, Some(error)),
    };
    Ok(AnswerData {
        for_time,
        for_error,
        met: answer.is_met,
        name: answer.name.clone(),
        profile: profile(&answer.profile)?,
        seconds: answer.seconds,
        spread: answer.spread,
        error: answer.error,
    })
}

/// How a point is named in two columns.
pub fn knob_and_value(point: &Point) -> (String, String) {
    match point.settings.as_slice() {
        [] => (STANDARD.to_owned(), "as it stands".to_owned()),
        [setting] => (setting.knob.name().to_owned(), setting.value.clone()),
        _ => (COMBINATION.to_owned(), point.name()),
    }
}
