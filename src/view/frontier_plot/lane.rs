//! The lane of the points that have no error at all: there only the time counts, so that they are stacked in rows.

use super::cluster::{Cluster, PITCH, clusters};
use super::marker::{RADIUS, RING, bar};
use super::scale::LogScale;
use super::{FrontierPlot, PlotPoint};
use crate::view::drawing::{Anchor, Frame, Spot};

/// A label in the lane, with the points it stands for.
#[derive(Clone, Debug, PartialEq)]
pub struct LaneLabel {
    /// What it says.
    pub cluster: Cluster,
    /// The same as those of the cluster.
    pub members: Vec<usize>,
    /// The end of the label that is next to its markers.
    pub x: f64,
    /// Which end that is.
    pub anchor: Anchor,
    /// How far below the lane's upper edge the middle of the markers lies.
    pub height: f64,
    /// How far below it the middle of the label lies.
    pub text: f64,
}

/// Room above the first row and below the last one.
const EDGE: f64 = 6.0;
/// Room between a marker and its label.
const GAP: f64 = RADIUS + 4.0;
/// Room between two rows.
const BETWEEN: f64 = 2.5;

/// The labels of all points without an error and the height of the lane, which is 0 if there are none.
///
/// Points merge, at first within `within` and then farther, and those of different knobs last, until the lane is no
/// higher than `most`.
pub fn pack(plot: &FrontierPlot, x: &LogScale, whole: Frame, within: f64, most: f64) -> (Vec<LaneLabel>, f64) {
    let exact = |k: &usize| plot.points[*k].error == 0.0 && plot.points[*k].seconds.is_finite();
    let indices: Vec<usize> = (0..plot.points.len()).filter(exact).collect();
    if indices.is_empty() {
        return (Vec::new(), 0.0);
    }
    let spots: Vec<Option<Spot>> = plot.points.iter().map(|point| Some([x.at(point.seconds), 0.0])).collect();
    let packed =
        |within: f64, mixed: bool| rows(clusters(plot, &spots, indices.iter().copied(), within, mixed), plot, x, whole);
    let farther = std::iter::successors(Some(within), |within| Some(within * 1.6));
    let all: Vec<f64> = farther.take_while(|within| *within < 2.0 * whole.size()[0]).collect();
    let mut tried = [false, true].into_iter().flat_map(|mixed| all.iter().map(move |within| (*within, mixed)));
    let fits = tried.find_map(|(within, mixed)| Some(packed(within, mixed)).filter(|(_, height)| *height <= most));
    fits.unwrap_or_else(|| packed(whole.size()[0], true))
}

/// Where a label stands to its markers, and what it takes of its row.
struct Stand {
    x: f64,
    anchor: Anchor,
    taken: [f64; 2],
    /// Whether there is room for it neither right nor left of the markers.
    below: bool,
}

impl Stand {
    fn of([low, high]: [f64; 2], width: f64, whole: Frame) -> Self {
        let [left, right] = [whole.low[0] + 4.0, whole.high[0] - 4.0];
        if high + GAP + width <= right {
            let taken = [low - GAP, high + GAP + width + 6.0];
            return Self { x: high + GAP, anchor: Anchor::Start, taken, below: false };
        }
        if low - GAP - width >= left {
            let taken = [low - GAP - width - 6.0, high + GAP];
            return Self { x: low - GAP, anchor: Anchor::End, taken, below: false };
        }
        let x = f64::midpoint(low, high).min(right - 0.5 * width).max(left + 0.5 * width);
        Self { x, anchor: Anchor::Middle, taken: [f64::NEG_INFINITY, f64::INFINITY], below: true }
    }
}

/// From where to where a point is drawn, but for the marker's own radius.
fn reach(point: &PlotPoint, x: &LogScale, whole: Frame) -> [f64; 2] {
    let at = x.at(point.seconds);
    let ring = if point.is_standard { RING - RADIUS } else { 0.0 };
    let [low, high] = bar(x, [whole.low[0], whole.high[0]], point).unwrap_or([at, at]);
    [low.min(at - ring), high.max(at + ring)]
}

/// A row of the lane.
struct Row {
    taken: Vec<[f64; 2]>,
    height: f64,
}

/// Puts labels in rows, the slowest first, each in the first row that is free there.
fn rows(mut clusters: Vec<Cluster>, plot: &FrontierPlot, x: &LogScale, whole: Frame) -> (Vec<LaneLabel>, f64) {
    let ends = |cluster: &Cluster| {
        let reaches = cluster.members.iter().map(|&k| reach(&plot.points[k], x, whole));
        reaches.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], end| [low.min(end[0]), high.max(end[1])])
    };
    clusters.sort_by(|a, b| ends(b)[1].total_cmp(&ends(a)[1]).then(a.members.cmp(&b.members)));
    let mut rows: Vec<Row> = Vec::new();
    let mut placed: Vec<(usize, bool, LaneLabel)> = Vec::new();
    for cluster in clusters {
        let [width, own_height] = cluster.size();
        let Stand { x, anchor, taken, below } = Stand::of(ends(&cluster), width, whole);
        let height = if below { PITCH + own_height } else { own_height.max(PITCH) };
        let is_free = |row: &Row| {
            row.height >= height && row.taken.iter().all(|other| taken[1] <= other[0] || other[1] <= taken[0])
        };
        let row = rows.iter().position(is_free).unwrap_or_else(|| {
            rows.push(Row { taken: Vec::new(), height });
            rows.len() - 1
        });
        rows[row].taken.push(taken);
        let members = cluster.members.clone();
        placed.push((row, below, LaneLabel { cluster, members, x, anchor, height: 0.0, text: 0.0 }));
    }
    let mut tops = vec![EDGE];
    for row in &rows {
        tops.push(tops[tops.len() - 1] + row.height + BETWEEN);
    }
    for (row, below, label) in &mut placed {
        let middle = tops[*row] + 0.5 * rows[*row].height;
        [label.height, label.text] =
            if *below { [tops[*row] + 0.5 * PITCH, middle + 0.5 * PITCH] } else { [middle; 2] };
    }
    let height = tops[rows.len()] - BETWEEN + EDGE;
    (placed.into_iter().map(|(_, _, label)| label).collect(), height)
}
