//! A study as a plot of error against seconds.

use super::{Knob, Point, Study};
use crate::view::{FrontierPlot, PlotPoint, brief};

/// The group of points that have several knobs.
const COMBINATIONS: &str = "combinations";

/// The plot of a study. Its first point is the scene as it stands; the others follow in the study's order.
#[must_use]
pub fn plot(study: &Study, scene_name: &str) -> FrontierPlot {
    // All of them, whatever the scene asks for: a knob looks the same in every plot.
    let groups: Vec<&str> = Knob::ALL.map(Knob::name).into_iter().chain([COMBINATIONS]).collect();
    let plotted = |point: &Point| PlotPoint {
        name: point.plain_name(),
        group: groups.iter().position(|group| *group == group_of(point)),
        seconds: point.timing.seconds,
        spread: point.timing.spread,
        error: point.errors.rmse,
        on_frontier: point.on_frontier,
        is_control: point.is_control(),
        is_standard: point.settings.is_empty(),
        noisy: point.timing.noise.is_some(),
    };
    let reference = match study.reference.error {
        0.0 => "nothing is left to chance".to_owned(),
        error => format!("the reference is sure to {} itself", brief(error)),
    };
    let picture = &study.standard.picture;
    FrontierPlot {
        title: format!("What accuracy costs: {scene_name}"),
        notes: vec![format!("{} × {} pixels on one thread; {reference}", picture.width, picture.height)],
        x_name: "time of one picture".to_owned(),
        y_name: "error: root mean square of linear RGB, against the reference".to_owned(),
        loose: groups.iter().position(|group| *group == COMBINATIONS),
        groups: groups.iter().map(|&group| group.to_owned()).collect(),
        points: study.all().map(plotted).collect(),
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
