//! The curves in which two leaves of a solid meet, as far as they are edges of the solid.
//!
//! Where an outline of one leaf passes through the surface of the other, a curve begins; from there it is followed step by step
//! along ∇F × ∇G, each step brought back onto both surfaces by Newton's method (Hoschek and Lasser, 1993, § 12.2).

use super::membership::Membership;
use super::{WireLine, bounds_something, outline};
use glam::DVec3;

/// Steps along a curve for the size of the smaller leaf. Longer ones show corners, shorter ones only take longer.
const STEPS: f64 = 48.0;
/// The most steps of one curve in one direction.
const LONGEST: u32 = 400;
/// The most pairs of leaves that are looked at: beyond them a solid has more edges than can be told apart.
const MOST_PAIRS: usize = 300;
/// Points of an outline that is searched for beginnings.
const OUTLINE: usize = 400;

/// All edges of a solid between two of its leaves.
pub(super) fn creases(object: usize, membership: &Membership) -> Vec<WireLine> {
    let leaves = &membership.solid.leaves;
    let extents: Vec<_> =
        leaves.iter().map(|leaf| crate::csg::Enclosure::of_primitive(&leaf.shape, &leaf.placement).extent).collect();
    let pairs = (0..leaves.len()).flat_map(|a| (a + 1..leaves.len()).map(move |b| [a, b]));
    let meeting = pairs
        .filter(|&[a, b]| bounds_something(&leaves[a]) && bounds_something(&leaves[b]) && extents[a].meets(extents[b]));
    let mut lines = Vec::new();
    for pair in meeting.take(MOST_PAIRS) {
        let size = |leaf: usize| {
            let length = (extents[leaf].high - extents[leaf].low).length();
            if length.is_finite() { length } else { 8.0 * membership.scale(leaf) }
        };
        let step = size(pair[0]).min(size(pair[1])) / STEPS;
        let tracing = Tracing { membership, pair, step };
        lines.extend(tracing.curves().into_iter().flat_map(|curve| tracing.edges(object, &curve)));
    }
    lines
}

struct Tracing<'a> {
    membership: &'a Membership<'a>,
    pair: [usize; 2],
    step: f64,
}

impl Tracing<'_> {
    /// Every curve once.
    fn curves(&self) -> Vec<Vec<DVec3>> {
        let mut curves: Vec<Vec<DVec3>> = Vec::new();
        for seed in self.seeds() {
            let is_new = curves.iter().flatten().all(|point| point.distance(seed) > 1.2 * self.step);
            if let Some(seed) = Some(seed).filter(|_| is_new).and_then(|seed| self.settled(seed)) {
                curves.push(self.curve(seed));
            }
        }
        curves
    }

    /// Where the outline of one leaf passes through the surface of the other.
    fn seeds(&self) -> Vec<DVec3> {
        let [a, b] = self.pair;
        let mut seeds = Vec::new();
        for (own, other) in [(a, b), (b, a)] {
            for line in outline(&self.membership.solid.leaves[own], OUTLINE, true) {
                for ends in line.windows(2) {
                    let signs = [ends[0], ends[1]].map(|point| self.membership.value(other, point) < 0.0);
                    if signs[0] != signs[1] {
                        seeds.push(self.crossing(other, [ends[0], ends[1]], signs[0]));
                    }
                }
            }
        }
        seeds
    }

    fn crossing(&self, other: usize, [mut from, mut to]: [DVec3; 2], begins: bool) -> DVec3 {
        for _ in 0..40 {
            let middle = from.midpoint(to);
            if (self.membership.value(other, middle) < 0.0) == begins {
                from = middle;
            } else {
                to = middle;
            }
        }
        from
    }

    /// The nearest point of both surfaces; none where they do not cross near there.
    fn settled(&self, mut point: DVec3) -> Option<DVec3> {
        let [a, b] = self.pair;
        for _ in 0..12 {
            let [f, g] = [a, b].map(|leaf| self.membership.value(leaf, point));
            let [n, m] = [a, b].map(|leaf| self.membership.gradient(leaf, point));
            // The shortest move s with n·s = −f and m·s = −g lies in the plane of both gradients.
            let (nn, mm, nm) = (n.dot(n), m.dot(m), n.dot(m));
            let determinant = nn * mm - nm * nm;
            let is_crossing = determinant > 1e-9 * nn * mm;
            if !is_crossing {
                return None;
            }
            let shift = n * ((g * nm - f * mm) / determinant) + m * ((f * nm - g * nn) / determinant);
            point += shift;
            let is_near = shift.length() < 4.0 * self.step;
            if !is_near {
                return None;
            }
            if shift.length() < 1e-9 * self.step {
                return Some(point);
            }
        }
        None
    }

    /// Both ways from the seed, or once round.
    fn curve(&self, seed: DVec3) -> Vec<DVec3> {
        let (mut points, closed) = self.followed(seed, 1.0);
        if closed {
            points.push(seed);
            return points;
        }
        let (mut back, _) = self.followed(seed, -1.0);
        back.reverse();
        back.pop();
        back.extend(points);
        back
    }

    /// The points from the seed on, and whether they lead back to it.
    fn followed(&self, seed: DVec3, way: f64) -> (Vec<DVec3>, bool) {
        let mut points = vec![seed];
        let mut heading = self.heading(seed) * way;
        let mut at = seed;
        for count in 0..LONGEST {
            let next = [1.0, 0.5, 0.2]
                .into_iter()
                .filter_map(|share| self.settled(at + heading * self.step * share))
                .find(|next| next.distance(at) > 0.1 * self.step && (*next - at).dot(heading) > 0.0);
            let Some(next) = next else { return (points, false) };
            if count > 3 && next.distance(seed) < 0.8 * self.step {
                return (points, true);
            }
            let along = self.heading(next);
            heading = if along.dot(next - at) < 0.0 { -along } else { along };
            at = next;
            points.push(at);
        }
        (points, false)
    }

    /// The direction of the curve.
    fn heading(&self, point: DVec3) -> DVec3 {
        let [n, m] = self.pair.map(|leaf| self.membership.gradient(leaf, point));
        n.cross(m).normalize_or_zero()
    }

    /// The parts of a curve that are edges of the solid: where it matters of both leaves whether they hold the point.
    fn edges(&self, object: usize, curve: &[DVec3]) -> Vec<WireLine> {
        let runs = curve.chunk_by(|a, b| self.is_edge(*a) == self.is_edge(*b));
        let edges = runs.filter(|run| run.len() > 1 && self.is_edge(run[0]));
        let line = |run: &[DVec3]| WireLine {
            object,
            points: run.to_vec(),
            normals: run.iter().map(|point| self.normals(*point)).collect(),
            is_crease: true,
        };
        edges.map(line).collect()
    }

    fn is_edge(&self, point: DVec3) -> bool {
        let [a, b] = self.pair;
        let holds = |first: bool, second: bool| self.membership.holds_with(point, &[(a, first), (b, second)]);
        let all = [holds(false, false), holds(false, true), holds(true, false), holds(true, true)];
        let on_first = all[0] != all[2] || all[1] != all[3];
        let on_second = all[0] != all[1] || all[2] != all[3];
        on_first && on_second
    }

    fn normals(&self, point: DVec3) -> [DVec3; 2] {
        let [a, b] = self.pair;
        let holds = |first: bool, second: bool| self.membership.holds_with(point, &[(a, first), (b, second)]);
        // A leaf whose holding the point takes it out of the solid is turned round.
        let turned_first = (holds(false, false) && !holds(true, false)) || (holds(false, true) && !holds(true, true));
        let turned_second = (holds(false, false) && !holds(false, true)) || (holds(true, false) && !holds(true, true));
        let out = |leaf: usize, turned: bool| {
            let normal = self.membership.gradient(leaf, point).normalize_or_zero();
            if turned { -normal } else { normal }
        };
        [out(a, turned_first), out(b, turned_second)]
    }
}
