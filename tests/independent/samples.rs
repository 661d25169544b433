//! Crossings of a superellipsoid: the line is cut where the surface may have an edge, each piece is sampled densely, and
//! every place where the samples turn towards zero is looked into.

use super::big::{Big, Line, big, near};
use super::exact::Exact;
use super::sturm::root_between;

/// Samples of a piece. Fewer would step over what is narrow in shapes of mixed exponents; more would take longer.
const SAMPLES: u32 = 300;

/// Values further from zero than this have the sign that they have in `f64`.
const SURE: f64 = 1e-6;

/// The intervals in which the value changes its sign once.
pub fn brackets(solid: &Exact, line: &Line, exponents: [f64; 2], growth: f64) -> Vec<[Big; 2]> {
    let search = Search::new(solid, line, exponents, growth);
    let cuts = cuts(line);
    let mut times: Vec<Big> = Vec::new();
    for pair in cuts.windows(2) {
        times.extend(search.piece(&pair[0], &pair[1]));
    }
    times.extend(cuts.last().cloned());
    let negative: Vec<bool> = times.iter().map(|t| search.is_negative(t)).collect();
    let changes = (1..times.len()).filter(|&k| negative[k] != negative[k - 1]);
    changes.map(|k| [times[k - 1].clone(), times[k].clone()]).collect()
}

/// The places where the value changes its sign.
pub fn sign_changes(solid: &Exact, line: &Line, exponents: [f64; 2], growth: f64) -> Vec<Big> {
    let value = |t: &Big| solid.value(&line.at(t), growth);
    let brackets = brackets(solid, line, exponents, growth).into_iter();
    brackets.map(|[low, high]| root_between(low, high, value)).collect()
}

/// Where the line leaves a box around the solid, crosses a plane of symmetry, and passes the axis of z, ascending.
fn cuts(line: &Line) -> Vec<Big> {
    let end = &line.per_length * big(2.0);
    let (l, c) = (&line.nearest, &line.direction);
    let mut cuts: Vec<Big> = (0..3)
        .filter(|&i| c[i] != Big::ZERO)
        .map(|i| -&l[i] / &c[i])
        .filter(|t| -end.clone() < *t && *t < end)
        .collect();
    let across = &c[0] * &c[0] + &c[1] * &c[1];
    if across > Big::ZERO {
        cuts.push(-(&l[0] * &c[0] + &l[1] * &c[1]) / across);
    }
    cuts.retain(|t| -end.clone() < *t && *t < end);
    cuts.extend([-end.clone(), end]);
    cuts.sort();
    cuts.dedup();
    cuts
}

struct Search<'a> {
    solid: &'a Exact,
    line: &'a Line,
    growth: f64,
    exponents: [f64; 2],
    nearest: [f64; 3],
    direction: [f64; 3],
}

impl<'a> Search<'a> {
    fn new(solid: &'a Exact, line: &'a Line, exponents: [f64; 2], growth: f64) -> Self {
        let [nearest, direction] = [&line.nearest, &line.direction].map(|v| std::array::from_fn(|i| near(&v[i])));
        Self { solid, line, growth, exponents, nearest, direction }
    }

    fn rough(&self, t: f64) -> f64 {
        let [n, m] = self.exponents;
        let [x, y, z] =
            std::array::from_fn(|i| ((self.nearest[i] + self.direction[i] * t) / (1.0 + self.growth)).abs());
        (x.powf(n) + y.powf(n)).powf(m / n) + z.powf(m) - 1.0
    }

    fn is_exactly_negative(&self, t: &Big) -> bool {
        self.solid.value(&self.line.at(t), self.growth) < Big::ZERO
    }

    fn is_negative(&self, t: &Big) -> bool {
        let rough = self.rough(near(t));
        if rough.abs() > SURE { rough < 0.0 } else { self.is_exactly_negative(t) }
    }

    /// The beginning of a piece, the samples on either side of which the sign is in question, and the turning points near
    /// zero.
    fn piece(&self, low: &Big, high: &Big) -> Vec<Big> {
        let (start, length) = (near(low), near(&(high - low)));
        // Closer together at the ends, where exponents below 1 bend most.
        let place = |k: u32| {
            let share = f64::from(k) / f64::from(SAMPLES);
            start + length * (share * share * (3.0 - 2.0 * share))
        };
        let times = self.refined((0..=SAMPLES).map(place).collect());
        let values: Vec<f64> = times.iter().map(|t| self.rough(*t)).collect();
        let exact = |k: usize| if k == 0 { low.clone() } else { big(times[k]) };
        let last = times.len() - 1;
        let mut all = vec![low.clone()];
        for k in 0..=last {
            let (before, after) = (k.saturating_sub(1), last.min(k + 1));
            let turns = |other: usize| values[k].abs() <= values[other].abs() && values[k] * values[other] > 0.0;
            if turns(before) && turns(after) {
                all.extend(self.turning_point(&exact(before), &exact(after), values[k] > 0.0));
            }
            if values[k] * values[after] <= 0.0 || values[k].abs() < SURE {
                all.extend([exact(before), exact(k), exact(after)]);
            }
        }
        all.retain(|t| low <= t && t < high);
        all.sort();
        all.dedup();
        all
    }

    /// More samples where the sign changes: what is in question once may be so three times.
    fn refined(&self, mut times: Vec<f64>) -> Vec<f64> {
        let negative: Vec<bool> = times.iter().map(|t| self.rough(*t) < 0.0).collect();
        let last = times.len() - 1;
        for k in (0..last).filter(|&k| negative[k] != negative[k + 1]) {
            let (from, to) = (times[k.saturating_sub(1)], times[last.min(k + 2)]);
            times.extend((1..64).map(|step| from + (to - from) * f64::from(step) / 64.0));
        }
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }

    /// The least value between two times (the greatest of a negative one), by the golden section, if it may matter.
    fn turning_point(&self, low: &Big, high: &Big, least: bool) -> Option<Big> {
        let sign = if least { 1.0 } else { -1.0 };
        let found = golden(near(low), near(high), 60, |t| sign * self.rough(t));
        if sign * self.rough(found) > SURE {
            return None;
        }
        let width = big(1e-6) * (high - low);
        let value = |t: &Big| big(sign) * self.solid.value(&self.line.at(t), self.growth);
        let (mut a, mut b) = (big(found) - &width, big(found) + &width);
        let inner = |a: &Big, b: &Big| (b - a) * big(GOLDEN);
        let (mut c, mut d) = (&a + inner(&a, &b), &b - inner(&a, &b));
        let (mut at_c, mut at_d) = (value(&c), value(&d));
        // The value is level there: its error is the square of the place's.
        for _ in 0..40 {
            if at_c < at_d {
                (b, d, at_d) = (d, c, at_c);
                c = &a + inner(&a, &b);
                at_c = value(&c);
            } else {
                (a, c, at_c) = (c, d, at_d);
                d = &b - inner(&a, &b);
                at_d = value(&d);
            }
        }
        Some((a + b) * big(0.5)).filter(|t| low < t && t < high)
    }
}

/// The smaller part of a golden section.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

fn golden(mut low: f64, mut high: f64, steps: u32, value: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..steps {
        let step = (high - low) * GOLDEN;
        let (c, d) = (low + step, high - step);
        if value(c) < value(d) { high = d } else { low = c }
    }
    0.5 * (low + high)
}
