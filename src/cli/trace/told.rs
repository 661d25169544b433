//! Traces that go through the ray step by step.

use super::format::Format;
use super::shown::ShownArguments;
use crate::cli::failure::Failure;
use crate::cli::progress::{stopped_by_ctrl_c, with_bar};
use crate::scene::Scene;
use crate::share::{self, Account, AnimationError, Cancelled, Moving, Watch, animation, slides, slides_pdf};
use crate::story;
use crate::trace::RayTree;
use clap::{Args, ValueEnum};
use std::sync::atomic::{AtomicUsize, Ordering};

/// How much is told, and how fast.
#[derive(Args, Clone, Copy, Debug)]
pub struct ToldArguments {
    /// Which steps worked examples, slides and moving pictures go through [default: story]
    #[arg(long, value_enum)]
    pub level: Option<Level>,
    /// How long a moving picture shows each step, from 0.05 to 30 [default: 1.5]
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub seconds: Option<f64>,
}

/// How much of what happened is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Level {
    /// Rays, what they hit, the lights, the colours
    Story,
    /// The same with objects, primitives, CSG, Snell's law and shading
    Working,
    /// All that was recorded
    Everything,
}

impl From<Level> for story::Level {
    fn from(level: Level) -> Self {
        match level {
            Level::Story => Self::Story,
            Level::Working => Self::Working,
            Level::Everything => Self::Everything,
        }
    }
}

fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse::<f64>().ok().filter(|seconds| (0.05..=30.0).contains(seconds));
    seconds.ok_or_else(|| "expected a number of seconds from 0.05 to 30".to_owned())
}

/// Seconds for each step where none are asked for: long enough to read a row.
const SECONDS: f64 = 1.5;

/// A ray that is told step by step.
pub struct Told<'a> {
    account: Account<'a>,
    seconds: f64,
}

impl ToldArguments {
    /// The ray, as it is to be told.
    pub fn told<'a>(
        &self,
        scene: &'a Scene,
        name: &'a str,
        tree: &'a RayTree,
        shown: &'a ShownArguments,
        link: Option<&'a str>,
    ) -> Told<'a> {
        let level = self.level.unwrap_or(Level::Story).into();
        let account = Account { scene, name, tree, level, views: shown.views(), theme: shown.theme.into(), link };
        Told { account, seconds: self.seconds.unwrap_or(SECONDS) }
    }
}

impl Told<'_> {
    /// The bytes of slides or of a moving picture.
    pub fn written(&self, format: Format) -> Result<Vec<u8>, Failure> {
        let account = &self.account;
        let moving = |moving| {
            watched(|watch| animation(account, moving, self.seconds, watch)).map_err(|error| match error {
                AnimationError::Cancelled => interrupted(Cancelled),
                AnimationError::Encoder(_) => Failure::refused(error.to_string()),
            })
        };
        match format {
            Format::SlidesPdf => watched(|watch| slides_pdf(account, watch)).map_err(interrupted),
            Format::Gif => moving(Moving::Gif),
            Format::Apng => moving(Moving::Apng),
            _ => watched(|watch| slides(account, watch)).map(String::into_bytes).map_err(interrupted),
        }
    }

    /// The worked example; `stem` begins the names of its drawings.
    pub fn paper(&self, stem: Option<&str>) -> Result<share::Paper, Failure> {
        watched(|watch| share::markdown(&self.account, stem, watch)).map_err(interrupted)
    }
}

/// Does the work under a bar; Ctrl-C stops it between two steps.
fn watched<T>(work: impl FnOnce(Watch) -> T) -> T {
    /// The bar's length: how many steps there are is known only once the work goes on.
    const PARTS: usize = 1000;
    let progress = stopped_by_ctrl_c();
    let parts = AtomicUsize::new(0);
    let watch = |done: usize, of: usize| {
        parts.store(PARTS * done / of.max(1), Ordering::Relaxed);
        !progress.cancelled()
    };
    with_bar(PARTS, || parts.load(Ordering::Relaxed), || work(&watch))
}

fn interrupted(_: Cancelled) -> Failure {
    Failure::interrupted("interrupted: nothing was written")
}
