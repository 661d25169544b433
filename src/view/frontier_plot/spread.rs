//! Where labels go: near their points where there is room, with a thin line where there is not, and in a column beside the
//! field as the last resort.
//!
//! First each label takes the cheapest free place; then, a few times over, each is taken up and put down again now that all
//! others have theirs (greedy placement with local improvement, as compared by Christensen, Marks and Shieber, 1995).

use super::Layout;
use super::axes::doubt_label;
use super::cluster::{Cluster, PITCH, SIZE};
use super::marker::{RADIUS, RING, bar, colour, knob_paths, staircase};
use super::paper::Paper;
use crate::math::portable;
use crate::view::drawing::{Anchor, Form, Frame, Spot, Stroke, length};
use crate::view::labels::{Label, clip};

/// Where a label stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The box that it fills.
    pub frame: Frame,
    /// Which end of its lines is flush.
    anchor: Anchor,
    /// The line to its point, if it stands far from it.
    pub leader: Option<[Spot; 2]>,
}

/// How far from the marker labels are tried, in points.
const DISTANCES: [f64; 13] = [0.0, 5.0, 12.0, 20.0, 30.0, 42.0, 56.0, 72.0, 90.0, 112.0, 136.0, 162.0, 190.0];
/// In how many directions, all round.
const DIRECTIONS: u32 = 16;
/// From this distance on a line leads to the marker.
const LEADER_FROM: f64 = 7.0;
/// How often all labels are put down anew, at most: mostly nothing moves any more after three or four times.
const ROUNDS: u32 = 12;

/// What it costs a label to stand where it stands. Only the proportions count: a label goes 50 points farther so that
/// its line crosses no other, but hardly farther to uncover a knob's thin line.
const PER_POINT: f64 = 0.22;
const ON_LEADER: f64 = 24.0;
const CROSSING: f64 = 11.0;
const LEADER_ON_MARKER: f64 = 5.0;
const STRANGER: f64 = 7.0;
const ON_FRONTIER: f64 = 12.0;
const ON_BAR: f64 = 3.0;
const ON_LINE: f64 = 0.7;
/// What is dearer than this goes into the column.
const TOO_DEAR: f64 = 75.0;

/// Places for the labels of all clusters, in their order; none where there is no room.
pub fn places(paper: &Paper, layout: &Layout) -> Vec<Option<Place>> {
    let field = Field::new(paper, layout);
    let mut order: Vec<usize> = (0..layout.clusters.len()).collect();
    // Those that matter first, then those with the most neighbours, which have the least choice.
    let crowd = |k: &usize| field.markers.iter().filter(|at| apart(**at, field.around(*k)) < 60.0).count();
    order.sort_by_key(|k| (!layout.clusters[*k].prominent, std::cmp::Reverse(crowd(k)), *k));
    let mut places: Vec<Option<Place>> = vec![None; order.len()];
    for _ in 0..ROUNDS {
        let before = places.clone();
        for &k in &order {
            places[k] = None;
            places[k] = field.best(k, &places).map(|(_, place)| place);
        }
        if places == before {
            break;
        }
    }
    if let Some(column) = paper.column {
        field.fill_column(column, &mut places);
    }
    places
}

/// Draws the labels with their lines, and those that have their places from the beginning.
pub fn draw(paper: &mut Paper, layout: &Layout, places: &[Option<Place>]) {
    if let Some(label) = doubt_label(paper, layout) {
        paper.put(Form::Text(label), None);
    }
    for (cluster, place) in layout.clusters.iter().zip(places) {
        let Some([from, to]) = place.as_ref().and_then(|place| place.leader) else { continue };
        let group = paper.plot.points[cluster.members[0]].group;
        let ink = colour(group, paper.palette).mixed(paper.palette.faint, 0.5);
        let form = Form::Line { points: vec![from, to], stroke: Stroke::solid(ink.faded(0.85), 0.8) };
        paper.put(form, Some(cluster.members[0]));
    }
    for (cluster, place) in layout.clusters.iter().zip(places) {
        if let Some(place) = place {
            write(paper, cluster, place);
        }
    }
    for label in &layout.lane_labels {
        let top = layout.field.high[1] + label.text - 0.5 * label.cluster.size()[1];
        write(paper, &label.cluster, &Place::at([label.x, top], label.cluster.size(), label.anchor));
    }
}

fn write(paper: &mut Paper, cluster: &Cluster, place: &Place) {
    let ink = if cluster.prominent { paper.palette.ink } else { paper.palette.faint };
    let x = match place.anchor {
        Anchor::Start => place.frame.low[0],
        Anchor::Middle => place.frame.middle()[0],
        Anchor::End => place.frame.high[0],
    };
    let mut y = place.frame.low[1] + 0.5 * PITCH;
    for line in &cluster.lines {
        let label = Label::new(line, SIZE, ink).face(cluster.face());
        let text = label.at([x, y], place.anchor, Some(paper.palette.ground));
        paper.put(Form::Text(text), Some(cluster.members[0]));
        y += PITCH;
    }
}

impl Place {
    /// A label of a size with its upper flush corner at `at`.
    fn at([x, top]: Spot, [width, height]: [f64; 2], anchor: Anchor) -> Self {
        let left = match anchor {
            Anchor::Start => x,
            Anchor::Middle => x - 0.5 * width,
            Anchor::End => x - width,
        };
        Self { frame: Frame { low: [left, top], high: [left + width, top + height] }, anchor, leader: None }
    }
}

/// Everything that labels keep off.
struct Field<'a> {
    layout: &'a Layout,
    canvas: Frame,
    /// The places of the markers.
    markers: Vec<Spot>,
    /// Where no label may be.
    blocked: Vec<Frame>,
    /// Where one had better not be, with what it costs.
    lines: Vec<([Spot; 2], f64)>,
    /// How far each cluster's label keeps from its marker.
    gaps: Vec<f64>,
}

impl<'a> Field<'a> {
    fn new(paper: &Paper, layout: &'a Layout) -> Self {
        let plot = paper.plot;
        let shown: Vec<usize> = layout.clusters.iter().flat_map(|cluster| cluster.members.iter().copied()).collect();
        let markers: Vec<Spot> = shown.iter().filter_map(|&k| layout.spots[k]).collect();
        let mut blocked: Vec<Frame> = shown
            .iter()
            .filter_map(|&k| {
                let radius = if plot.points[k].is_standard { RING } else { RADIUS } + 1.5;
                layout.spots[k].map(|at| Frame { low: at, high: at }.grown(radius))
            })
            .collect();
        blocked.extend(doubt_label(paper, layout).map(|label| label.frame()));
        let mut lines: Vec<([Spot; 2], f64)> = Vec::new();
        let stairs = staircase(plot, layout);
        lines.extend(stairs.windows(2).map(|ends| ([ends[0], ends[1]], ON_FRONTIER)));
        let sides = [layout.field.low[0], layout.field.high[0]];
        for &k in &shown {
            if let (Some([low, high]), Some([_, y])) = (bar(&layout.x, sides, &plot.points[k]), layout.spots[k]) {
                lines.push(([[low, y], [high, y]], ON_BAR));
            }
        }
        for path in knob_paths(plot, layout) {
            lines.extend(path.windows(2).map(|ends| ([ends[0], ends[1]], ON_LINE)));
        }
        let gap = |cluster: &Cluster| {
            let ringed = cluster.members.iter().any(|&k| plot.points[k].is_standard);
            if ringed { RING + 3.0 } else { RADIUS + 3.0 }
        };
        let gaps = layout.clusters.iter().map(gap).collect();
        Self { layout, canvas: layout.field.grown(-3.0), markers, blocked, lines, gaps }
    }

    /// The marker that a cluster's label belongs to.
    fn around(&self, k: usize) -> Spot {
        self.layout.spots[self.layout.clusters[k].members[0]].unwrap_or([0.0, 0.0])
    }

    /// The cheapest free place of a label, the others being where they are.
    fn best(&self, k: usize, others: &[Option<Place>]) -> Option<(f64, Place)> {
        let mut best: Option<(f64, Place)> = None;
        for distance in DISTANCES {
            let farness = PER_POINT * distance;
            if best.as_ref().is_some_and(|(least, _)| *least <= farness) {
                break;
            }
            for direction in 0..DIRECTIONS {
                let place = self.candidate(k, distance, direction);
                if !self.is_free(&place.frame, others) {
                    continue;
                }
                // Right of the point reads best: between places that are as good, the first one wins.
                let cost = farness + self.cost(k, &place, others);
                if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                    best = Some((cost, place));
                }
            }
        }
        best
    }

    fn candidate(&self, k: usize, distance: f64, direction: u32) -> Place {
        let around = self.around(k);
        let size = self.layout.clusters[k].size();
        // 0, then ever farther to both sides of it.
        let step = f64::from(direction.div_ceil(2)) * if direction.is_multiple_of(2) { 1.0 } else { -1.0 };
        let (sin, cos) = portable::sin_cos(step * std::f64::consts::TAU / f64::from(DIRECTIONS));
        let reach = self.gaps[k] + distance;
        let anchor = match cos {
            c if c > 0.3 => Anchor::Start,
            c if c < -0.3 => Anchor::End,
            _ => Anchor::Middle,
        };
        let middle = around[1] + sin * (reach + 0.5 * size[1]);
        let mut place = Place::at([around[0] + cos * reach, middle - 0.5 * size[1]], size, anchor);
        let nearest: Spot = std::array::from_fn(|i| around[i].max(place.frame.low[i]).min(place.frame.high[i]));
        let far = apart(around, nearest);
        if far > self.gaps[k] + LEADER_FROM {
            let share = (RADIUS + 1.0) / far;
            let start = std::array::from_fn(|i| around[i] + share * (nearest[i] - around[i]));
            place.leader = Some([start, nearest]);
        }
        place
    }

    fn is_free(&self, frame: &Frame, others: &[Option<Place>]) -> bool {
        let padded = frame.grown(1.0);
        self.canvas.holds(frame)
            && !self.blocked.iter().any(|taken| taken.overlaps(frame))
            && !others.iter().flatten().any(|other| other.frame.overlaps(&padded))
    }

    fn cost(&self, k: usize, place: &Place, others: &[Option<Place>]) -> f64 {
        let frame = &place.frame;
        let lines =
            self.lines.iter().filter(|(line, _)| clip(frame, *line).is_some()).map(|(_, cost)| cost).sum::<f64>();
        let own = self.around(k);
        let reach = apart(own, nearest(frame, own));
        let is_stranger = |at: &&Spot| {
            let distance = apart(**at, nearest(frame, **at));
            apart(**at, own) > 3.0 && distance < reach.max(RADIUS + 6.0)
        };
        let strangers = self.markers.iter().filter(is_stranger).count() as f64;
        let mut cost = lines + STRANGER * strangers;
        for other in others.iter().flatten() {
            if other.leader.is_some_and(|line| clip(frame, line).is_some()) {
                cost += ON_LEADER;
            }
        }
        place.leader.map_or(cost, |leader| cost + self.leader_cost(own, leader, others))
    }

    /// What a line costs: labels, markers and other lines that it passes over.
    fn leader_cost(&self, own: Spot, leader: [Spot; 2], others: &[Option<Place>]) -> f64 {
        let mut cost = 0.0;
        for other in others.iter().flatten() {
            if clip(&other.frame, leader).is_some() {
                cost += ON_LEADER;
            }
            if other.leader.is_some_and(|line| cross(line, leader)) {
                cost += CROSSING;
            }
        }
        let over = |at: &&Spot| {
            apart(**at, own) > 3.0 && clip(&Frame { low: **at, high: **at }.grown(RADIUS), leader).is_some()
        };
        cost + LEADER_ON_MARKER * self.markers.iter().filter(over).count() as f64
    }

    /// Moves labels without a place, or with a bad one, into the column, in the order of their heights.
    fn fill_column(&self, column: Frame, places: &mut [Option<Place>]) {
        let dear = |k: &usize| match &places[*k] {
            None => true,
            Some(place) => {
                let rest: Vec<_> =
                    places.iter().enumerate().map(|(i, other)| other.clone().filter(|_| i != *k)).collect();
                self.cost(*k, place, &rest) > TOO_DEAR
            }
        };
        let mut moved: Vec<usize> = (0..places.len()).filter(dear).collect();
        moved.sort_by(|a, b| self.around(*a)[1].total_cmp(&self.around(*b)[1]).then(a.cmp(b)));
        let heights: Vec<f64> = moved.iter().map(|&k| self.layout.clusters[k].size()[1] + 3.0).collect();
        let mut below: f64 = heights.iter().sum();
        let mut free_from = column.low[1];
        for (&k, height) in moved.iter().zip(heights) {
            // At the height of its marker where that leaves room for those above and below.
            let latest = column.high[1] - below;
            below -= height;
            let around = self.around(k);
            let top = (around[1] - 0.5 * height).min(latest).max(free_from);
            if top + height > column.high[1] + 3.0 {
                continue;
            }
            free_from = top + height;
            let mut place = Place::at([column.low[0] + 8.0, top], self.layout.clusters[k].size(), Anchor::Start);
            let end = [place.frame.low[0] - 3.0, place.frame.middle()[1]];
            let share = (RADIUS + 1.0) / apart(around, end).max(1.0);
            place.leader = Some([std::array::from_fn(|i| around[i] + share * (end[i] - around[i])), end]);
            places[k] = Some(place);
        }
    }
}

fn apart(a: Spot, b: Spot) -> f64 {
    length([a[0] - b[0], a[1] - b[1]])
}

/// The place of a frame that is nearest to another place.
fn nearest(frame: &Frame, at: Spot) -> Spot {
    std::array::from_fn(|i| at[i].max(frame.low[i]).min(frame.high[i]))
}

/// Whether two lines cross.
fn cross([a, b]: [Spot; 2], [c, d]: [Spot; 2]) -> bool {
    let side = |p: Spot, q: Spot, r: Spot| (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}
