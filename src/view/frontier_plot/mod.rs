//! Error against seconds, both by their logarithms: what accuracy costs, and which settings nothing beats.
//!
//! Every point is labelled. Knobs are told apart by shape as well as by colour. What has no error at all, which a logarithm
//! cannot show, stands in a lane of its own below.

mod axes;
mod cluster;
mod lane;
mod legend;
mod marker;
mod paper;
mod scale;
mod spread;
#[cfg(test)]
mod tests;

use super::drawing::{Drawing, Frame, Spot};
use super::palette::Theme;
use cluster::Cluster;
use paper::Paper;
use scale::LogScale;
pub(super) use scale::error;
pub use scale::seconds;

/// What is to be plotted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FrontierPlot {
    /// One line.
    pub title: String,
    /// A line or two of explanation.
    pub notes: Vec<String>,
    /// The name of the x axis. Its numbers carry their units.
    pub x_name: String,
    /// The name of the y axis with its unit.
    pub y_name: String,
    /// The names of the groups that points belong to, in the order of the legend.
    pub groups: Vec<String>,
    /// The group whose points have no order, by its place in the list: no line goes through them.
    pub loose: Option<usize>,
    /// The points, those of a group in the order in which its thin line goes through them.
    pub points: Vec<PlotPoint>,
    /// By how much the reference may be off itself, in the units of the errors; 0 where it is sure.
    pub reference_error: f64,
}

/// A setting with its time and its error.
#[derive(Clone, Debug, Default, PartialEq)]
#[expect(clippy::struct_excessive_bools, reason = "any of them may go together")]
pub struct PlotPoint {
    /// Its name, which may begin with that of its group.
    pub name: String,
    /// The group, by its place in the list; none for what belongs to none.
    pub group: Option<usize>,
    /// The time in seconds.
    pub seconds: f64,
    /// Half the distance between the quartiles, in seconds.
    pub spread: f64,
    /// The error; 0 where there is none, exactly.
    pub error: f64,
    /// Whether no other point beats it in both.
    pub on_frontier: bool,
    /// Whether it is there to show that nothing changes.
    pub is_control: bool,
    /// Whether it is what all others are changes of.
    pub is_standard: bool,
    /// Whether its time is lost in noise.
    pub noisy: bool,
}

/// How near to each other, in points, markers share one label. The first is for markers that cover each other; the
/// others are for drawings that are too small for a label each.
const MERGED_WITHIN: [f64; 5] = [3.0, 8.0, 15.0, 26.0, 45.0];
/// The lane takes at most the first share of the height; in small drawings so many points, but no more than the second.
const MOST_LANE: (f64, f64, f64) = (0.45, 190.0, 0.7);

/// Draws the plot. A mark's event is the place of its point in the list of points.
#[must_use]
pub fn frontier_plot(plot: &FrontierPlot, size: [f64; 2], theme: Theme) -> Drawing {
    let mut paper = Paper::new(plot, size, theme);
    let field = paper.heading();
    let (layout, places) = labelled(plot, &paper, field);
    axes::draw(&mut paper, &layout);
    marker::draw(&mut paper, &layout);
    spread::draw(&mut paper, &layout, &places);
    paper.drawing.description = description(plot);
    paper.drawing
}

/// The plot in words: every setting with its time and its error, those that nothing beats first.
fn description(plot: &FrontierPlot) -> String {
    let mut text = format!("{}. {}", plot.title, plot.notes.join(" "));
    let told = |point: &PlotPoint| {
        let error = if point.error > 0.0 { error(point.error) } else { "no error".to_owned() };
        format!(" {}: {}, {error};", point.name, seconds(point.seconds))
    };
    for (is_best, heading) in [(true, " Nothing beats:"), (false, " Others:")] {
        let points: Vec<String> = plot.points.iter().filter(|point| point.on_frontier == is_best).map(told).collect();
        if !points.is_empty() {
            text.push_str(heading);
            text.push_str(&points.concat());
        }
    }
    text
}

/// Where everything but the labels of the upper field lies.
struct Layout {
    /// The field of points that have an error.
    field: Frame,
    /// The field of points that have none; none where there are no such points.
    lane: Option<Frame>,
    /// From seconds to points.
    x: LogScale,
    /// From errors to points.
    y: LogScale,
    /// The place of each point's marker; none where its time or error is no number.
    spots: Vec<Option<Spot>>,
    /// The points that share labels.
    clusters: Vec<Cluster>,
    /// Labels that have their place already: those of the lane.
    lane_labels: Vec<lane::LaneLabel>,
}

/// The layout with the least merging that leaves room for all labels.
fn labelled(plot: &FrontierPlot, paper: &Paper, field: Frame) -> (Layout, Vec<Option<spread::Place>>) {
    let mut best: Option<(usize, Layout, Vec<Option<spread::Place>>)> = None;
    for within in MERGED_WITHIN {
        let layout = laid_out(plot, field, within);
        let places = spread::places(paper, &layout);
        let missing = places.iter().filter(|place| place.is_none()).count();
        if best.as_ref().is_none_or(|(least, ..)| missing < *least) {
            best = Some((missing, layout, places));
        }
        if missing == 0 {
            break;
        }
    }
    best.map_or_else(|| (laid_out(plot, field, MERGED_WITHIN[0]), Vec::new()), |(_, layout, places)| (layout, places))
}

fn laid_out(plot: &FrontierPlot, whole: Frame, within: f64) -> Layout {
    let told = |point: &&PlotPoint| point.seconds.is_finite() && point.error.is_finite();
    let seconds = plot.points.iter().filter(told).flat_map(|point| {
        let reach = point.spread.max(0.0).min(0.5 * point.seconds.max(0.0));
        [point.seconds - reach, point.seconds + reach]
    });
    let x = LogScale::over(seconds, [whole.low[0] + 14.0, whole.high[0] - 14.0]);
    let (share, points, largest_share) = MOST_LANE;
    let most = (share * whole.size()[1]).max(points.min(largest_share * whole.size()[1]));
    let (lane_labels, height) = lane::pack(plot, &x, whole, within, most);
    let lane = (height > 0.0).then(|| Frame { low: [whole.low[0], whole.high[1] - height], high: whole.high });
    let bottom = lane.map_or(whole.high[1], |lane| lane.low[1]);
    let field = Frame { low: whole.low, high: [whole.high[0], bottom] };
    let errors = plot.points.iter().filter(told).map(|point| point.error).chain([plot.reference_error]);
    let y = LogScale::over(errors, [field.high[1] - 14.0, field.low[1] + 14.0]);
    let mut spots: Vec<Option<Spot>> = plot.points.iter().map(|point| spot(point, &x, &y)).collect();
    for label in &lane_labels {
        for &k in &label.members {
            spots[k] = Some([x.at(plot.points[k].seconds), bottom + label.height]);
        }
    }
    let above = |k: &usize| plot.points[*k].error > 0.0;
    let clusters = cluster::clusters(plot, &spots, (0..plot.points.len()).filter(above), within, true);
    Layout { field, lane, x, y, spots, clusters, lane_labels }
}

/// Where the marker of a point with an error stands.
fn spot(point: &PlotPoint, x: &LogScale, y: &LogScale) -> Option<Spot> {
    (point.seconds.is_finite() && point.error.is_finite() && point.error > 0.0)
        .then(|| [x.at(point.seconds), y.at(point.error)])
}
