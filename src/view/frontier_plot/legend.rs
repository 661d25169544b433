//! The legend: which sign is which knob, and what else the drawing says.

use super::PlotPoint;
use super::marker::{Look, RADIUS, sign};
use super::paper::{MARGIN, Paper, SMALL};
use crate::view::drawing::{Anchor, Form, Spot, Stroke};
use crate::view::fonts::{Face, text_width};
use crate::view::labels::shortened;

/// The width of a legend beside the field.
pub const WIDTH: f64 = 168.0;
/// Narrower drawings have the legend above the field.
const WIDE: f64 = 720.0;
const PITCH: f64 = 15.0;
/// From a sign to its name.
const INDENT: f64 = 13.0;

/// What a line of the legend shows.
#[derive(Clone, Copy)]
enum Sign {
    Group(usize),
    Standard,
    Frontier,
    Beaten,
    Noisy,
}

/// Whether the legend stands beside the field.
pub fn stands_beside(width: f64) -> bool {
    width >= WIDE
}

/// The entries that the plot has a use for.
fn entries(paper: &Paper) -> Vec<(Sign, String)> {
    let points = &paper.plot.points;
    let is_beaten = |point: &PlotPoint| !point.on_frontier && !point.noisy && !point.is_control;
    let has_group = |group: usize| points.iter().any(|point| point.group == Some(group));
    let groups = paper.plot.groups.iter().enumerate().filter(|(k, _)| has_group(*k));
    let mut entries: Vec<_> = groups.map(|(k, name)| (Sign::Group(k), name.clone())).collect();
    let others = [
        (points.iter().any(|point| point.is_standard), Sign::Standard, "the scene as it stands"),
        (points.iter().any(|point| point.on_frontier), Sign::Frontier, "the frontier"),
        (points.iter().any(is_beaten), Sign::Beaten, "beaten in time and error"),
        (points.iter().any(|point| point.noisy), Sign::Noisy, "time lost in noise"),
    ];
    entries.extend(others.into_iter().filter(|(used, ..)| *used).map(|(_, sign, name)| (sign, name.to_owned())));
    entries
}

/// One entry below the other, from `at` on; returns the height below the last one.
pub fn column(paper: &mut Paper, at: Spot) -> f64 {
    let [x, mut y] = [at[0] + RADIUS + 2.0, at[1] + 0.5 * PITCH];
    for (sign, name) in entries(paper) {
        let name = shortened(&name, WIDTH - INDENT - 20.0, SMALL, Face::Sans);
        entry(paper, sign, &name, [x, y]);
        y += PITCH;
    }
    y - 0.5 * PITCH
}

/// The entries beside each other in as many rows as they need; returns the height below the last row.
pub fn rows(paper: &mut Paper, top: f64, width: f64) -> f64 {
    let (mut x, mut y) = (MARGIN, top + 0.5 * PITCH - 4.0);
    for (sign, name) in entries(paper) {
        let needed = 2.0 * RADIUS + INDENT + text_width(&name, SMALL, Face::Sans) + 6.0;
        if x > MARGIN && x + needed > MARGIN + width {
            (x, y) = (MARGIN, y + PITCH);
        }
        entry(paper, sign, &name, [x + RADIUS + 1.0, y]);
        x += needed;
    }
    y + 0.5 * PITCH + 4.0
}

fn entry(paper: &mut Paper, shown: Sign, name: &str, at: Spot) {
    let look = |group, prominent, noisy| Look { group, prominent, noisy };
    match shown {
        Sign::Group(group) => sign(paper, at, look(Some(group), true, false), None),
        Sign::Standard => {
            let stroke = Some(Stroke::solid(paper.palette.ink, 1.4));
            paper.put(Form::Circle { centre: at, radius: RADIUS + 2.0, fill: None, stroke }, None);
        }
        Sign::Frontier => {
            let stroke = Stroke::solid(paper.palette.camera, 2.0);
            let [x, y] = at;
            let points = vec![[x - 6.0, y - 4.0], [x, y - 4.0], [x, y + 4.0], [x + 6.0, y + 4.0]];
            paper.put(Form::Line { points, stroke }, None);
        }
        Sign::Beaten => sign(paper, at, look(None, false, false), None),
        Sign::Noisy => sign(paper, at, look(None, false, true), None),
    }
    paper.text(name, [at[0] + INDENT, at[1]], Anchor::Start, paper.palette.ink);
}
