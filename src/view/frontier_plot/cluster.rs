//! Points that stand so near to each other that they share a label.

use super::{FrontierPlot, PlotPoint};
use crate::view::drawing::{Spot, length};
use crate::view::fonts::{Face, text_width};

/// Points that share a label.
#[derive(Clone, Debug, PartialEq)]
pub struct Cluster {
    /// Their places in the list; the first is the one that the label stands for.
    pub members: Vec<usize>,
    /// What the label says, line by line.
    pub lines: Vec<String>,
    /// Whether one of them is on the frontier or the standard.
    pub prominent: bool,
}

/// The size of labels in points, and how wide one may be before it goes on in the next line.
pub const SIZE: f64 = 10.5;
pub const WIDEST: f64 = 150.0;

impl Cluster {
    /// A label for these points.
    pub fn of(plot: &FrontierPlot, mut members: Vec<usize>) -> Self {
        let matters = |k: &usize| plot.points[*k].is_standard || plot.points[*k].on_frontier;
        members.sort_by_key(|k| (!plot.points[*k].is_standard, *k));
        let prominent = members.iter().any(matters);
        let lines = wrapped(names(plot, &members));
        Self { members, lines, prominent }
    }

    /// Width and height of the label.
    pub fn size(&self) -> [f64; 2] {
        let width = self.lines.iter().map(|line| text_width(line, SIZE, self.face())).fold(0.0, f64::max);
        [width, PITCH * self.lines.len() as f64]
    }

    /// What matters is bold.
    pub const fn face(&self) -> Face {
        if self.prominent { Face::Bold } else { Face::Sans }
    }
}

/// From one line of a label to the next, in points.
pub const PITCH: f64 = 12.5;

/// Gathers points that are no farther than `within` from each other; those of different knobs only if `mixed`.
pub fn clusters(
    plot: &FrontierPlot,
    spots: &[Option<Spot>],
    points: impl Iterator<Item = usize>,
    within: f64,
    mixed: bool,
) -> Vec<Cluster> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for k in points {
        let Some(spot) = spots[k] else { continue };
        let near = |other: &usize| {
            let close = spots[*other].is_some_and(|other| length([other[0] - spot[0], other[1] - spot[1]]) <= within);
            close && (mixed || plot.points[*other].group == plot.points[k].group)
        };
        match groups.iter_mut().find(|group| group.iter().all(near)) {
            Some(group) => group.push(k),
            None => groups.push(vec![k]),
        }
    }
    groups.into_iter().map(|members| Cluster::of(plot, members)).collect()
}

/// The names, those of one group in one piece: `depth 4, 8`.
fn names(plot: &FrontierPlot, members: &[usize]) -> Vec<String> {
    let mut pieces: Vec<(Option<usize>, String)> = Vec::new();
    for point in members.iter().map(|&k| &plot.points[k]) {
        let before = pieces.iter_mut().find(|(group, _)| group.is_some() && *group == point.group);
        match (before, value(plot, point)) {
            (Some((_, piece)), Some(value)) => {
                piece.push_str(", ");
                piece.push_str(value);
            }
            _ => pieces.push((point.group, point.name.clone())),
        }
    }
    pieces.into_iter().map(|(_, piece)| piece).collect()
}

/// A point's name without that of its group; none where it does not begin with it.
fn value<'a>(plot: &FrontierPlot, point: &'a PlotPoint) -> Option<&'a str> {
    let group = plot.groups.get(point.group?)?;
    point.name.strip_prefix(group.as_str())?.strip_prefix(' ')
}

/// The pieces in lines that are not too wide, divided between pieces.
fn wrapped(pieces: Vec<String>) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for piece in pieces {
        match lines.last_mut() {
            Some(line) if text_width(line, SIZE, Face::Bold) + text_width(&piece, SIZE, Face::Bold) < WIDEST => {
                line.push_str(" · ");
                line.push_str(&piece);
            }
            _ => lines.push(piece),
        }
    }
    lines
}
