//! The search for every crossing of a superellipsoid, with bounds instead of samples.
//!
//! The ray is cut at the sides of the box [−1, 1]³ and at the coordinate planes. On each stretch |x|, |y| and |z| are
//! linear, and the gauge g is smooth. The signs of g − 1 at the ends of a stretch are certain. A stretch is done when
//! bounds show that g − 1 is never 0, or that g only rises or only falls, so that the signs tell. Else it is halved.
//! That ends quickly, for the bounds close in with the square of the length; a touch, where they never do, is halved down to
//! neighbouring numbers and counted as undecided.
//!
//! The bounds: g rises with each of |x|, |y|, |z|. For n ≥ 1 the norm (|x|ⁿ + |y|ⁿ)^(1/n) is convex along a line within an
//! octant, for n ≤ 1 concave (Minkowski's inequality and its reverse), so its slope lies between those at the ends. The same
//! holds of g where n and m lie on one side of 1.

use super::GenericRay;
use super::gauge::{Bend, Exponents, norm, product};
use crate::math::{DoubleDouble, Range, Real, root_between};

/// What the search came to, in τ.
pub(super) struct Findings {
    /// Where it began and ended; none where the ray misses the box.
    pub range: Option<[f64; 2]>,
    /// Stretches that were bounded.
    pub stretches: usize,
    /// Stretches that were halved to the end.
    pub undecided: usize,
    /// The crossings, ascending.
    pub roots: Vec<f64>,
}

/// The ray in one coordinate: zero at `zero` where it moves, `resting` where it does not.
#[derive(Clone, Copy)]
struct Axis<A> {
    speed: A,
    zero: A,
    resting: A,
}

impl<A: Real> Axis<A> {
    /// By its distance from the zero, which keeps the digits of small values.
    fn at(&self, delta: A) -> A {
        if self.zero.is_finite() { self.speed * (delta - self.zero) } else { self.resting }
    }
}

/// The ray about the foot of the perpendicular.
struct Line<A> {
    foot: A,
    axes: [Axis<A>; 3],
}

impl<A: Real> Line<A> {
    fn new(ray: &GenericRay<A>) -> Self {
        let foot = ray.foot();
        let nearest = ray.at(foot);
        let axes = std::array::from_fn(|i| {
            let speed = ray.direction[i];
            Axis { speed, zero: -nearest[i] / speed, resting: nearest[i] }
        });
        Self { foot, axes }
    }

    fn at(&self, delta: A) -> [A; 3] {
        self.axes.map(|axis| axis.at(delta))
    }

    fn to_f64(&self) -> Line<f64> {
        let axes = self.axes.map(|axis| Axis {
            speed: axis.speed.to_f64(),
            zero: axis.zero.to_f64(),
            resting: axis.resting.to_f64(),
        });
        Line { foot: self.foot.to_f64(), axes }
    }

    /// The times in the box [−1, 1]³, a little widened so that nothing on its sides is lost.
    fn in_box(&self) -> Option<[A; 2]> {
        let (mut enter, mut leave) = (A::from_f64(f64::NEG_INFINITY), A::from_f64(f64::INFINITY));
        let slack = A::from_f64(1.0 + 64.0 * A::UNIT_ROUNDOFF);
        for axis in &self.axes {
            if !axis.zero.is_finite() {
                if axis.resting.abs() > slack {
                    return None;
                }
                continue;
            }
            let half = (slack / axis.speed).abs();
            enter = enter.max(axis.zero - half);
            leave = leave.min(axis.zero + half);
        }
        (enter < leave).then_some([enter, leave])
    }
}

/// g on one place of the ray.
#[derive(Clone, Copy)]
struct Probe {
    delta: f64,
    /// |x|, |y|, |z|.
    place: [f64; 3],
    /// (|x|ⁿ + |y|ⁿ)^(1/n), and its derivatives by |x| and |y|.
    radius: f64,
    radius_along: [f64; 2],
    /// g, and its derivatives by that radius and |z|.
    value: f64,
    value_along: [f64; 2],
    /// The sign of g − 1, 0 where even 32 digits do not tell.
    sign: i8,
}

impl Probe {
    /// The slopes of the radius and of g, as δ grows.
    fn slopes(&self, motion: [f64; 3]) -> (f64, f64) {
        let radius = product(self.radius_along[0], motion[0]) + product(self.radius_along[1], motion[1]);
        (radius, product(self.value_along[0], radius) + product(self.value_along[1], motion[2]))
    }
}

/// A stretch of the ray with its ends.
#[derive(Clone, Copy)]
struct Stretch {
    from: Probe,
    to: Probe,
}

/// Stretches that are bounded at most. Random rays need 4 on average and 71 at worst, exact touches some hundred. Fewer
/// would leave touches of sharp shapes undecided, more would only cost time there.
const MOST_STRETCHES: usize = 4000;

struct Search<'a, A> {
    exponents: Exponents,
    line: Line<A>,
    plain: Line<f64>,
    ray: &'a GenericRay<'a, A>,
    findings: Findings,
    /// The last place with a certain sign.
    last: (f64, i8),
}

/// Every crossing of the ray with the superellipsoid.
pub(super) fn search<A: Real>(exponents: Exponents, ray: &GenericRay<A>) -> Findings {
    let line = Line::new(ray);
    let plain = line.to_f64();
    let findings = Findings { range: None, stretches: 0, undecided: 0, roots: Vec::new() };
    let Some([from, to]) = line.in_box().map(|ends| ends.map(Real::to_f64)) else { return findings };
    let mut search = Search { exponents, line, plain, ray, findings, last: (from, 1) };
    search.findings.range = Some([from, to].map(|delta| delta + search.plain.foot));
    let mut cuts: Vec<(f64, Option<usize>)> = (0..3)
        .map(|i| (search.plain.axes[i].zero, Some(i)))
        .filter(|(delta, _)| from < *delta && *delta < to)
        .chain([(from, None), (to, None)])
        .collect();
    cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Outside of the box g is above 1.
    let mut start = Probe { sign: 1, ..search.probe(from, None) };
    for &(delta, axis) in &cuts[1..] {
        let mut end = search.probe(delta, axis);
        if delta >= to {
            end.sign = 1;
        }
        search.work_through(Stretch { from: start, to: end });
        start = end;
    }
    search.findings
}

impl<A: Real> Search<'_, A> {
    fn probe(&self, delta: f64, zero_axis: Option<usize>) -> Probe {
        let mut place = self.plain.at(delta).map(f64::abs);
        if let Some(axis) = zero_axis {
            place[axis] = 0.0;
        }
        let [x, y, z] = place;
        let Exponents { n, m } = self.exponents;
        // Derivatives depend on the direction alone, so where both arguments are zero the limit along the ray is taken.
        let speeds = self.plain.axes.map(|axis| axis.speed.abs());
        let (mut radius, mut radius_along) = norm(n, x, y);
        let mut arguments = (radius, z);
        if x == 0.0 && y == 0.0 {
            let (speed, along) = norm(n, speeds[0], speeds[1]);
            (radius, radius_along) = (0.0, if speed > 0.0 { along } else { [0.0; 2] });
            if z == 0.0 {
                arguments = (speed, speeds[2]);
            }
        }
        let value = norm(m, radius, z).0;
        let value_along = norm(m, arguments.0, arguments.1).1;
        let sign = self.sign(delta, value, zero_axis);
        Probe { delta, place, radius, radius_along, value, value_along, sign }
    }

    /// The sign of g − 1: with 32 digits where 16 do not tell.
    fn sign(&self, delta: f64, value: f64, zero_axis: Option<usize>) -> i8 {
        let excess = value - 1.0;
        if excess.abs() > self.exponents.rounding::<f64>() {
            return if excess > 0.0 { 1 } else { -1 };
        }
        let wide = Line::new(&self.ray.widen());
        let mut place = wide.at(DoubleDouble::from_f64(delta)).map(Real::abs);
        if let Some(axis) = zero_axis {
            place[axis] = DoubleDouble::ZERO;
        }
        let (value, _) = self.exponents.gauge(place);
        let excess = (value - DoubleDouble::ONE).to_f64();
        // Powers lose some digits of the 32.
        if excess.abs() <= 1e4 * self.exponents.rounding::<DoubleDouble>() {
            0
        } else if excess > 0.0 {
            1
        } else {
            -1
        }
    }

    /// Bounds a stretch, and halves it until all is decided; from left to right.
    fn work_through(&mut self, whole: Stretch) {
        // What |x|, |y| and |z| do as δ grows, all along the stretch.
        let middle = self.plain.at(0.5 * (whole.from.delta + whole.to.delta));
        let motion: [f64; 3] = std::array::from_fn(|i| self.plain.axes[i].speed * middle[i].signum());
        let mut waiting = vec![whole];
        while let Some(stretch) = waiting.pop() {
            self.findings.stretches += 1;
            if self.decided(&stretch, motion) {
                self.arrive(&stretch.to);
                continue;
            }
            let middle = 0.5 * (stretch.from.delta + stretch.to.delta);
            let neighbours = middle <= stretch.from.delta || middle >= stretch.to.delta;
            if neighbours || self.findings.stretches >= MOST_STRETCHES {
                self.findings.undecided += 1;
                self.arrive(&stretch.to);
                continue;
            }
            let middle = self.probe(middle, None);
            waiting.push(Stretch { from: middle, ..stretch });
            waiting.push(Stretch { to: middle, ..stretch });
        }
    }

    /// Whether the signs at the ends of the stretch say how often g − 1 changes its sign within: once or never.
    fn decided(&self, stretch: &Stretch, motion: [f64; 3]) -> bool {
        let widening = self.exponents.rounding::<f64>();
        let (from, to) = (&stretch.from, &stretch.to);
        let bend = self.exponents.bend();
        // A convex function is below zero on at most one stretch, which holds the ends that are; a concave one above.
        let other = match bend {
            Bend::Convex => -1,
            Bend::Concave => 1,
            Bend::Unknown => 2,
        };
        if from.sign == other || to.sign == other {
            return true;
        }
        let (start, end) = (from.slopes(motion), to.slopes(motion));
        let radius_slope = Range::between(start.0, end.0).widened(4.0 * widening);
        let radius = self.radii(stretch, radius_slope);
        let z = Range::between(from.place[2], to.place[2]);
        let slope = if bend == Bend::Unknown {
            self.slope_bound(radius, z, radius_slope, motion[2])
        } else {
            Range::between(start.1, end.1).widened(4.0 * widening)
        };
        if slope.keeps_sign() {
            return true;
        }
        // From either end g changes by no more than the slopes allow.
        let length = to.delta - from.delta;
        let (values, flipped) = ([from.value, to.value], Range { low: -slope.high, high: -slope.low });
        if lowest_of_two_lines(values, slope, length) > 1.0 + 4.0 * widening
            || -lowest_of_two_lines(values.map(|x| -x), flipped, length) < 1.0 - 4.0 * widening
        {
            return true;
        }
        let value = Range {
            low: norm(self.exponents.m, radius.low.max(0.0), z.low).0,
            high: norm(self.exponents.m, radius.high.max(0.0), z.high).0,
        }
        .widened(widening);
        value.low > 1.0 || value.high < 1.0
    }

    /// Bounds of the radius over the stretch.
    fn radii(&self, stretch: &Stretch, slope: Range) -> Range {
        let (from, to) = (&stretch.from, &stretch.to);
        let ends = Range::between(from.radius, to.radius);
        let (a, b) = (from.place, to.place);
        let inner = norm(self.exponents.n, a[0].min(b[0]), a[1].min(b[1])).0;
        let outer = norm(self.exponents.n, a[0].max(b[0]), a[1].max(b[1])).0;
        let bounds = if slope.keeps_sign() {
            ends
        } else if self.exponents.n >= 1.0 {
            Range { low: inner, high: ends.high }
        } else {
            Range { low: ends.low, high: outer }
        };
        bounds.widened(self.exponents.rounding::<f64>())
    }

    /// Bounds of the slope of g over a stretch, where exponents on both sides of 1 mix.
    fn slope_bound(&self, radius: Range, z: Range, radius_slope: Range, z_motion: f64) -> Range {
        let m = self.exponents.m;
        let widening = 8.0 * self.exponents.rounding::<f64>();
        // The partial derivatives depend on z / radius alone, and each runs one way with it.
        let flat = norm(m, radius.high, z.low.max(0.0)).1;
        let steep = norm(m, radius.low.max(0.0), z.high).1;
        let along_radius = Range::between(flat[0], steep[0]).widened(widening);
        let along_z = Range::between(flat[1], steep[1]).widened(widening);
        along_radius * radius_slope + along_z * Range::between(z_motion, z_motion)
    }

    /// Notes the sign at a place; where it changed, there is a crossing behind.
    fn arrive(&mut self, place: &Probe) {
        if place.sign == 0 {
            return;
        }
        let (before, sign_before) = self.last;
        if place.sign != sign_before {
            let root = self.crossing(before, place.delta, sign_before < 0);
            self.findings.roots.push(root);
        }
        self.last = (place.delta, place.sign);
    }

    /// The crossing between two places, in the ray's own arithmetic.
    fn crossing(&self, low: f64, high: f64, rising: bool) -> f64 {
        let root = root_between(A::from_f64(low), A::from_f64(high), rising, |delta| {
            let place = self.line.at(delta);
            let (value, gradient) = self.exponents.gauge(place.map(Real::abs));
            let slope = (0..3).fold(A::ZERO, |sum, i| {
                let speed = if place[i] < A::ZERO { -self.line.axes[i].speed } else { self.line.axes[i].speed };
                sum + product(gradient[i], speed)
            });
            (value - A::ONE, slope)
        });
        (self.line.foot + root).to_f64()
    }
}

/// A lower bound of a function between two places, given its values there and the range of its slope: where the line that
/// falls from the first as steeply as allowed meets the one that rises to the second.
fn lowest_of_two_lines([first, second]: [f64; 2], slope: Range, length: f64) -> f64 {
    let (fall, rise) = (slope.low, slope.high);
    if !(fall < 0.0 && rise > 0.0 && fall.is_finite() && rise.is_finite()) {
        return f64::NEG_INFINITY;
    }
    // first + fall x = second − rise (length − x)
    let x = ((first - second + rise * length) / (rise - fall)).clamp(0.0, length);
    (first + fall * x).min(second - rise * (length - x))
}
