//! What a ray meets of a superellipsoid, by what is known of F along a line.
//!
//! F = (|x|ⁿ + |y|ⁿ)^(m/n) + |z|ᵐ. With exponents of 1 or more F is convex: two tangents bound it from below. With n = m
//! below 1 F is concave between the coordinate planes: it is least where the ray crosses one of them.

use super::line::{Line, PixelRay};
use super::number::{Big, Number};
use super::set::placement;
use super::truth::{Truth, Verdict};
use glam::DVec3;
use rayscope::scene::Scene;

/// The superellipsoid of the first leaf of the first object is all that there is.
pub struct SuperellipsoidAlone {
    /// The exponent of x and y.
    pub n: f64,
    /// The exponent of z; equal to n where that is below 1.
    pub m: f64,
}

/// A value with its slope along the ray.
struct Tangent<N> {
    delta: N,
    value: N,
    slope: N,
}

/// Beyond this a look in plain `f64` cannot be wrong.
const PLAIN: f64 = 1e-8;

impl SuperellipsoidAlone {
    /// F at a point with |x|, |y|, |z|.
    fn value<N: Number>(&self, [x, y, z]: [N; 3]) -> N {
        let round = x.power(self.n) + y.power(self.n);
        let round = if self.n == self.m { round } else { round.power(self.m / self.n) };
        round + z.power(self.m)
    }

    /// F with its slope, on the ray shrunk towards the middle by `scale`.
    fn tangent<N: Number>(&self, line: &Line<N>, delta: N, scale: &N) -> Tangent<N> {
        let p = line.at(&delta).map(|x| x / scale.clone());
        let c = line.c.each_ref().map(|x| x.clone() / scale.clone());
        let zero = N::of(0.0);
        // |x|ᵏ and its slope.
        let term = |i: usize, k: f64| {
            let size = p[i].size();
            if size == zero {
                return (zero.clone(), zero.clone());
            }
            let power = size.power(k);
            let slope = N::of(k) * power.clone() * c[i].clone() / p[i].clone();
            (power, slope)
        };
        let ((x, x_slope), (y, y_slope), (z, z_slope)) = (term(0, self.n), term(1, self.n), term(2, self.m));
        let (round, round_slope) = (x + y, x_slope + y_slope);
        if self.n == self.m || round == zero {
            return Tangent { delta, value: round + z, slope: round_slope + z_slope };
        }
        let power = round.power(self.m / self.n);
        let slope = N::of(self.m / self.n) * power.clone() * round_slope / round;
        Tangent { delta, value: power + z, slope: slope + z_slope }
    }

    /// Whether a convex one is hit; none where F comes within `near` of 1.
    fn convex<N: Number>(&self, line: &Line<N>, grown: f64, near: f64) -> Option<bool> {
        let scale = N::of(1.0) + N::of(grown);
        let [low, high] = within_the_box(line, 1.0 + 1e-3 + grown.abs())?;
        let (below, above) = (N::of(1.0) - N::of(near), N::of(1.0) + N::of(near));
        let zero = N::of(0.0);
        let mut left = self.tangent(line, low, &scale);
        let mut right = self.tangent(line, high, &scale);
        for step in 0..400 {
            if left.value < below || right.value < below {
                return Some(true);
            }
            let rises = left.slope >= zero;
            let falls = right.slope <= zero;
            if rises || falls {
                let least = if rises { left.value } else { right.value };
                return (least >= above).then_some(false);
            }
            let width = right.delta.clone() - left.delta.clone();
            let meet = left.delta.clone()
                + (right.value.clone() - left.value.clone() - right.slope.clone() * width.clone())
                    / (left.slope.clone() - right.slope.clone());
            let bound = left.value.clone() + left.slope.clone() * (meet.clone() - left.delta.clone());
            if bound >= above {
                return Some(false);
            }
            let middle = left.delta.clone() + width * N::of(0.5);
            let next = self.tangent(line, if step % 3 == 2 { middle } else { meet }, &scale);
            if next.slope < zero { left = next } else { right = next }
        }
        None
    }

    /// Whether a hollow one is hit; none where a move of the ray by `doubt` could change that.
    fn hollow<N: Number>(&self, line: &Line<N>, doubt: f64) -> Option<bool> {
        let one = N::of(1.0);
        let mut missed = true;
        for (_, point, room) in Self::crossings(line, doubt) {
            let (inner, outer) = (moved(&point, &room, -1.0), moved(&point, &room, 1.0));
            if self.value(outer) < one {
                return Some(true);
            }
            missed &= self.value(inner) >= one;
        }
        missed.then_some(false)
    }

    /// Where the ray crosses the coordinate planes: δ, the point, and how far a move of the ray by `doubt` moves it.
    fn crossings<N: Number>(line: &Line<N>, doubt: f64) -> Vec<(N, [N; 3], [N; 3])> {
        let across = (0..3).filter(|i| line.c[*i] != N::of(0.0));
        across
            .map(|i| {
                let delta = -line.l[i].clone() / line.c[i].clone();
                let mut point = line.at(&delta);
                point[i] = N::of(0.0);
                let steep = |j: usize| N::of(doubt) * (N::of(1.0) + (line.c[j].clone() / line.c[i].clone()).size());
                let room = std::array::from_fn(|j| if j == i { N::of(0.0) } else { steep(j) });
                (delta, point, room)
            })
            .collect()
    }

    fn decide<N: Number>(&self, line: &Line<N>, doubt: f64, near: f64) -> Option<bool> {
        if self.n < 1.0 {
            return self.hollow(line, doubt);
        }
        let [smaller, larger] = [-doubt, doubt].map(|grown| self.convex(line, grown, near));
        if smaller == larger { smaller } else { None }
    }

    /// Whether the first hit lies between two δ.
    fn first_between(&self, line: &Line<Big>, low: &Big, high: &Big) -> bool {
        let one = Big::of(1.0);
        let (before, after) = (self.tangent(line, low.clone(), &one), self.tangent(line, high.clone(), &one));
        if before.value < one {
            return false;
        }
        if self.n < 1.0 {
            let inside: Vec<Big> = Self::crossings(line, 0.0)
                .into_iter()
                .filter(|(_, point, _)| self.value(point.each_ref().map(Number::size)) < one)
                .map(|(delta, ..)| delta)
                .collect();
            return inside.iter().all(|delta| delta >= low)
                && (after.value < one || inside.iter().any(|delta| delta <= high));
        }
        let zero = Big::of(0.0);
        before.slope < zero && (after.value < one || (after.slope > zero && self.convex(line, 0.0, 0.0) == Some(true)))
    }

    fn gradient(&self, [x, y, z]: [f64; 3]) -> DVec3 {
        let round = (x.abs().powf(self.n) + y.abs().powf(self.n)).powf(self.m / self.n - 1.0);
        let share = |x: f64, k: f64| x.signum() * x.abs().powf(k - 1.0);
        DVec3::new(round * share(x, self.n), round * share(y, self.n), share(z, self.m))
    }
}

impl Truth for SuperellipsoidAlone {
    fn verdict(&self, scene: &Scene, ray: PixelRay) -> Verdict {
        let placement = placement(scene, [0, 0]);
        let seen = |hit: bool| hit.then_some(0);
        let plain = Line::<f64>::new(ray, &placement);
        let doubt = PLAIN.max(1e6 * plain.doubt);
        if self.n >= 1.0 && within_the_box(&plain, 1.0 + doubt).is_none() {
            return Verdict { seen: None, sure: true };
        }
        if let Some(hit) = self.decide(&plain, doubt, 1e-3 * doubt) {
            return Verdict { seen: seen(hit), sure: true };
        }
        let line = Line::<Big>::new(ray, &placement);
        if let Some(hit) = self.decide(&line, line.doubt, 0.0) {
            return Verdict { seen: seen(hit), sure: true };
        }
        let hit = if self.n < 1.0 { self.hollow(&line, 0.0) } else { self.convex(&line, 0.0, 0.0) };
        Verdict { seen: seen(hit.unwrap_or(false)), sure: false }
    }

    fn time(&self, scene: &Scene, ray: PixelRay, t: f64) -> Result<(), String> {
        let line = Line::<Big>::new(ray, &placement(scene, [0, 0]));
        let delta = line.delta(t);
        let room = line.tolerance(self.gradient(line.at(&delta).map(|x| x.nearest())), t);
        let room = if room.is_finite() { room } else { 16.0 * line.doubt };
        let ends = [delta.clone() - Big::of(room), delta + Big::of(room)];
        if self.first_between(&line, &ends[0], &ends[1]) {
            return Ok(());
        }
        let values = ends.map(|delta| (self.tangent(&line, delta, &Big::of(1.0)).value - Big::of(1.0)).nearest());
        Err(format!("F is {values:?} at t ∓ {:e}", room * line.per_delta))
    }
}

/// The stretch of the ray in the box from −size to size.
fn within_the_box<N: Number>(line: &Line<N>, size: f64) -> Option<[N; 2]> {
    let mut range: Option<[N; 2]> = None;
    for i in 0..3 {
        if line.c[i] == N::of(0.0) {
            if line.l[i].size() > N::of(size) {
                return None;
            }
            continue;
        }
        let at = |side: f64| (N::of(side) - line.l[i].clone()) / line.c[i].clone();
        let (a, b) = (at(-size), at(size));
        let [low, high] = if a < b { [a, b] } else { [b, a] };
        range = Some(match range {
            None => [low, high],
            Some([from, to]) => [if from > low { from } else { low }, if to < high { to } else { high }],
        });
    }
    range.filter(|[low, high]| low < high)
}

/// |p| moved away from the middle (or towards it), coordinate by coordinate.
fn moved<N: Number>(point: &[N; 3], room: &[N; 3], sign: f64) -> [N; 3] {
    std::array::from_fn(|i| {
        let size = point[i].size() + N::of(sign) * room[i].clone();
        if size < N::of(0.0) { N::of(0.0) } else { size }
    })
}
