//! `--plot`: error against seconds.

use super::super::drawn::{self, Theme};
use super::Findings;
use super::figures::short;
use crate::laboratory::{Knob, Point};
use crate::view::{FrontierPlot, PlotPoint, frontier_plot};
use std::path::{Path, PathBuf};

/// Plots are this large, in points.
const SIZE: [f64; 2] = [900.0, 640.0];

/// The group of points that have several knobs.
const COMBINATIONS: &str = "combinations";

/// A file that a plot can be written to.
pub fn file(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    match path.extension().and_then(|ending| ending.to_str()) {
        Some("svg" | "png") => Ok(path),
        _ => Err("expected a file that ends in .svg or .png".to_owned()),
    }
}

/// The bytes of the plot, as the file's ending says.
pub fn plotted(findings: &Findings, theme: Theme, path: &Path) -> Vec<u8> {
    let drawing = frontier_plot(&plot(findings), SIZE, theme.into());
    if path.extension().is_some_and(|ending| ending == "png") { drawn::png(&drawing) } else { drawn::svg(&drawing) }
}

fn plot(findings: &Findings) -> FrontierPlot {
    let study = &findings.run.study;
    let picture = &study.standard.picture;
    let group_names = Knob::ALL.map(Knob::name).into_iter().chain([COMBINATIONS]);
    let used = |name: &&str| study.points.iter().any(|point| group_of(point) == *name);
    let groups: Vec<&str> = group_names.filter(used).collect();
    let plotted = |point: &Point| PlotPoint {
        name: if point.settings.is_empty() { "as it stands".to_owned() } else { point.name() },
        group: groups.iter().position(|group| *group == group_of(point)),
        seconds: point.timing.seconds,
        spread: point.timing.spread,
        error: point.errors.rmse,
        on_frontier: point.on_frontier,
        is_control: point.is_control(),
        is_standard: point.settings.is_empty(),
        noisy: point.timing.noise.is_some(),
    };
    let own_error = match study.reference.error {
        0.0 => "exact: nothing in the scene is left to chance".to_owned(),
        error => format!("sure to {} itself", short(error)),
    };
    FrontierPlot {
        title: format!("What accuracy costs: {}", findings.scene_name),
        notes: vec![format!(
            "{} × {} pixels on one thread; the reference is {own_error}",
            picture.width, picture.height
        )],
        x_name: "time of one picture".to_owned(),
        y_name: "error (root mean square, linear RGB)".to_owned(),
        groups: groups.iter().map(|&group| group.to_owned()).collect(),
        points: std::iter::once(&study.standard).chain(&study.points).map(plotted).collect(),
        reference_error: study.reference.error,
    }
}

fn group_of(point: &Point) -> &'static str {
    match point.settings.as_slice() {
        [] => "",
        [setting] => setting.knob.name(),
        _ => COMBINATIONS,
    }
}
