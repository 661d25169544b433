//! The section of a solid by the drawing's plane, exact to a small part of a point.
//!
//! Parallel rays sweep the plane from top to bottom, one for each point of height, and each is asked where it is inside.
//! Runs of neighbouring rows that belong together make a chain with a left and a right side. Where rows do not belong
//! together one to one (something begins, ends, splits or joins), where a side comes to another surface, or where it
//! bends, the gap between the rows is halved until it is too small to see.

use super::super::drawing::{Frame, Spot};
use super::fit::corners;
use super::plane::PlaneView;
use crate::csg::{Boundary, Solid};
use crate::math::portable;
use crate::record::NullRecorder;
use crate::shape::Part;

/// The filled area and its outline.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::view) struct Section {
    /// Rings of the area.
    pub rings: Vec<Vec<Spot>>,
    /// Lines round it; rings alone would also show the seams between chains.
    pub outline: Vec<Vec<Spot>>,
    /// The middle of a wide run, with the run's length: where a name has room.
    pub middle: Option<(Spot, f64)>,
}

/// Rows this far apart are looked at first.
const ROW: f64 = 1.0;
/// Halvings of a gap: sides end within 1/64 of a point, which nobody sees. More would only take longer.
const HALVINGS: u32 = 6;
/// Runs are cut this far outside the canvas, so that the cut does not show as an outline.
const OUTSIDE: f64 = 6.0;
/// A side that moves less than this from row to row is taken as straight between them.
const STEP: f64 = 1.2;
/// The middle of a straight side lies this close to the mean of its ends.
const BEND: f64 = 0.1;

/// Where a side of a run comes from: leaf and part, or the cut at the canvas.
type Origin = Option<(usize, Part)>;

#[derive(Clone, Copy, Debug, PartialEq)]
struct Run {
    ends: [f64; 2],
    origins: [Origin; 2],
}

#[derive(Clone, Debug)]
struct Row {
    y: f64,
    runs: Vec<Run>,
}

#[derive(Clone, Debug, Default)]
struct Chain {
    left: Vec<Spot>,
    right: Vec<Spot>,
}

/// The section of a solid within the canvas.
pub(in crate::view) fn section(solid: &Solid, plane: &PlaneView, canvas: Frame) -> Section {
    let canvas = canvas.grown(OUTSIDE);
    let (chains, open, middles, section) = Default::default();
    let mut sweep = Sweep { solid, plane, canvas, chains, open, middles, section };
    let [top, bottom] = sweep.heights();
    if top >= bottom {
        return sweep.section;
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a canvas has at most 16,384 rows")]
    let rows = ((bottom - top) / ROW).ceil() as u32;
    let mut upper = Row { y: top, runs: Vec::new() };
    for i in 0..=rows {
        let lower = sweep.row(top + (bottom - top) * f64::from(i) / f64::from(rows));
        sweep.connect(&upper, &lower, HALVINGS);
        upper = lower;
    }
    sweep.finish()
}

struct Sweep<'a> {
    solid: &'a Solid,
    plane: &'a PlaneView,
    canvas: Frame,
    chains: Vec<Chain>,
    /// The chain of each run of the row that was connected last.
    open: Vec<usize>,
    /// Middle and length of every run.
    middles: Vec<(Spot, f64)>,
    section: Section,
}

impl Sweep<'_> {
    /// The heights between which there can be anything.
    fn heights(&self) -> [f64; 2] {
        let [top, bottom] = [self.canvas.low[1], self.canvas.high[1]];
        let extent = self.solid.extent();
        if !(extent.low.is_finite() && extent.high.is_finite()) {
            return [top, bottom];
        }
        let heights = corners(extent.low, extent.high).map(|corner| self.plane.spot(corner)[1]);
        let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), y| (a.min(y), b.max(y)));
        [(low - ROW).max(top), (high + ROW).min(bottom)]
    }

    /// The inside runs at a height. The direction is a point of the drawing long, so that t is x.
    fn row(&mut self, y: f64) -> Row {
        let [low, high] = [self.canvas.low[0], self.canvas.high[0]];
        let (origin, direction) = (self.plane.world([0.0, y]), self.plane.across / self.plane.scale);
        let list = self.solid.inside::<f64>(origin, direction, &mut NullRecorder);
        let mut runs = Vec::with_capacity(list.intervals().len());
        for interval in list.intervals() {
            let end = |boundary: Option<Boundary>, cut: f64| match boundary {
                Some(b) if low < b.t && b.t < high => (b.t, Some((b.leaf, b.part))),
                Some(b) => (b.t.max(low).min(high), None),
                None => (cut, None),
            };
            let ((from, from_origin), (to, to_origin)) = (end(interval.enter, low), end(interval.leave, high));
            if from < to {
                runs.push(Run { ends: [from, to], origins: [from_origin, to_origin] });
                self.note_middle([from, to], y);
            }
        }
        Row { y, runs }
    }

    fn note_middle(&mut self, [from, to]: [f64; 2], y: f64) {
        let visible = self.canvas.grown(-OUTSIDE);
        let (from, to) = (from.max(visible.low[0]), to.min(visible.high[0]));
        if from < to && visible.low[1] < y && y < visible.high[1] {
            self.middles.push(([f64::midpoint(from, to), y], to - from));
        }
    }

    /// Of the runs that are nearly as long as the longest, the one in the middle.
    fn middle(&self) -> Option<(Spot, f64)> {
        let longest = self.middles.iter().map(|(_, length)| *length).fold(0.0, f64::max);
        let mut wide: Vec<_> = self.middles.iter().filter(|(_, length)| *length >= 0.85 * longest).collect();
        wide.sort_by(|a, b| a.0[1].total_cmp(&b.0[1]));
        wide.get(wide.len() / 2).map(|middle| **middle)
    }

    fn connect(&mut self, upper: &Row, lower: &Row, halvings: u32) {
        let groups = groups(&upper.runs, &lower.runs);
        let simple = |group: &Group| {
            let ([a], [b]) = (&group.upper[..], &group.lower[..]) else { return false };
            is_straight(&upper.runs[*a], &lower.runs[*b])
        };
        if halvings > 0 && !groups.iter().all(simple) {
            let middle = self.row(f64::midpoint(upper.y, lower.y));
            let left = if continues_straight(upper, &middle, lower) { 0 } else { halvings - 1 };
            self.connect(upper, &middle, left);
            self.connect(&middle, lower, left);
            return;
        }
        let mut open = vec![usize::MAX; lower.runs.len()];
        for group in &groups {
            if let ([a], [b]) = (&group.upper[..], &group.lower[..]) {
                open[*b] = self.open[*a];
                self.extend(open[*b], lower.y, &lower.runs[*b]);
            } else {
                self.change(upper, lower, group, &mut open);
            }
        }
        self.open = open;
    }

    /// Ends the chains above and begins those below, half way between the rows.
    fn change(&mut self, upper: &Row, lower: &Row, group: &Group, open: &mut [usize]) {
        let y = f64::midpoint(upper.y, lower.y);
        for &a in &group.upper {
            self.extend(self.open[a], y, &upper.runs[a]);
        }
        for &b in &group.lower {
            self.chains.push(Chain::default());
            open[b] = self.chains.len() - 1;
            self.extend(open[b], y, &lower.runs[b]);
            self.extend(open[b], lower.y, &lower.runs[b]);
        }
        let ends = |runs: &[Run], picked: &[usize]| picked.iter().flat_map(|&i| runs[i].ends).collect::<Vec<_>>();
        let mut cuts = ends(&upper.runs, &group.upper);
        cuts.extend(ends(&lower.runs, &group.lower));
        cuts.sort_by(f64::total_cmp);
        // Between an odd and the next even cut, one of the two rows is inside and the other is not.
        let caps = cuts.chunks_exact(2).filter(|pair| pair[0] < pair[1]);
        self.section.outline.extend(caps.map(|pair| vec![[pair[0], y], [pair[1], y]]));
    }

    fn extend(&mut self, chain: usize, y: f64, run: &Run) {
        if let Some(chain) = self.chains.get_mut(chain) {
            chain.left.push([run.ends[0], y]);
            chain.right.push([run.ends[1], y]);
        }
    }

    fn finish(mut self) -> Section {
        self.section.middle = self.middle();
        for chain in self.chains.into_iter().filter(|chain| chain.left.len() > 1) {
            let (left, right) = (thinned(&chain.left), thinned(&chain.right));
            self.section.rings.push(left.iter().chain(right.iter().rev()).copied().collect());
            self.section.outline.extend([left, right]);
        }
        self.section
    }
}

/// Runs of two rows that overlap each other, directly or through others.
#[derive(Debug, Default)]
struct Group {
    upper: Vec<usize>,
    lower: Vec<usize>,
}

fn groups(upper: &[Run], lower: &[Run]) -> Vec<Group> {
    let mut all: Vec<(Run, bool, usize)> = upper.iter().enumerate().map(|(i, run)| (*run, true, i)).collect();
    all.extend(lower.iter().enumerate().map(|(i, run)| (*run, false, i)));
    all.sort_by(|a, b| a.0.ends[0].total_cmp(&b.0.ends[0]));
    let mut groups: Vec<Group> = Vec::new();
    let mut reach = f64::NEG_INFINITY;
    for (run, is_upper, i) in all {
        if run.ends[0] >= reach || groups.is_empty() {
            groups.push(Group::default());
        }
        reach = reach.max(run.ends[1]);
        if let Some(group) = groups.last_mut() {
            if is_upper { &mut group.upper } else { &mut group.lower }.push(i);
        }
    }
    groups
}

/// Whether both sides stay on their surfaces and move little.
fn is_straight(a: &Run, b: &Run) -> bool {
    a.origins == b.origins && (0..2).all(|i| (a.ends[i] - b.ends[i]).abs() < STEP)
}

/// Whether the middle row lies on the straight lines between the outer two.
fn continues_straight(upper: &Row, middle: &Row, lower: &Row) -> bool {
    let same = upper.runs.len() == lower.runs.len() && upper.runs.len() == middle.runs.len();
    same && upper.runs.iter().zip(&middle.runs).zip(&lower.runs).all(|((a, m), b)| {
        let overlaps = a.ends[0] < b.ends[1] && b.ends[0] < a.ends[1];
        let straight = (0..2).all(|i| (m.ends[i] - f64::midpoint(a.ends[i], b.ends[i])).abs() < BEND);
        overlaps && straight && a.origins == b.origins && a.origins == m.origins
    })
}

/// The polyline without points that lie on the line between their neighbours.
fn thinned(points: &[Spot]) -> Vec<Spot> {
    /// Smaller keeps points that nobody sees; larger shows corners on circles.
    const CLOSE: f64 = 0.02;
    let mut kept: Vec<Spot> = Vec::new();
    let mut first_skipped = 0;
    for (i, &point) in points.iter().enumerate() {
        let Some(&last) = kept.last() else {
            kept.push(point);
            first_skipped = 1;
            continue;
        };
        let bends = points[first_skipped..i].iter().any(|&skipped| distance_from_line(skipped, last, point) > CLOSE);
        if bends {
            kept.push(points[i - 1]);
            first_skipped = i;
        }
    }
    kept.extend(points.last().filter(|_| points.len() > 1));
    kept
}

fn distance_from_line(at: Spot, from: Spot, to: Spot) -> f64 {
    let along = [to[0] - from[0], to[1] - from[1]];
    let length = portable::hypot(along[0], along[1]);
    let offset = [at[0] - from[0], at[1] - from[1]];
    if length == 0.0 {
        portable::hypot(offset[0], offset[1])
    } else {
        (offset[0] * along[1] - offset[1] * along[0]).abs() / length
    }
}
