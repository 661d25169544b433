//! The search for every crossing of a superellipsoid, with proof instead of samples.
//!
//! **Convex** (n, m ≥ 1): g is convex along the whole ray, so the ray is inside on one stretch or never. Above 1 a tangent of
//! g bounds it from below: up to where the tangent reaches 1 there is no root. Either a place inside is found, and there
//! is one root on either side of it, or nothing is left of the range.
//!
//! **Concave** (n, m ≤ 1): so g is between two coordinate planes (the reverse of Minkowski's inequality). With both ends of
//! such a piece outside, it has no root; with one, one; with both inside there are two or none, found out as above with
//! tangents from below.
//!
//! **Mixed**: see `superellipsoid_mixed.rs`.
//!
//! Source: Hardy, Littlewood, Pólya, Inequalities, §§ 2.11, 3.18; S. Boyd, L. Vandenberghe, Convex Optimization, § 3.1.3
//! (a tangent bounds a convex function).

use super::GenericRay;
use super::boundary::{Root, Roots};
use super::gauge::{Bend, Exponents};
use super::solver::Attempt;
use super::superellipsoid_line::{Line, Probe};
use super::superellipsoid_root::{Bracket, Cusp, root_in};
use crate::math::Real;

/// What the search came to, in τ.
pub(super) struct Findings<A> {
    /// Where it began and ended; none where the ray misses what holds the solid.
    pub range: Option<[f64; 2]>,
    /// Stretches that were bounded.
    pub stretches: usize,
    /// Stretches that could not be decided.
    pub undecided: usize,
    /// The crossings, ascending. Two where g is convex, six at most where it is concave between four planes' pieces.
    pub roots: Roots<12>,
    /// The place whose sign was closest to the other one.
    pub closest: Option<Closest<A>>,
}

/// A place at which a sign was asked for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Closest<A> {
    /// δ.
    pub at: A,
    /// The number with that sign, over its doubt.
    margin: f64,
}

/// Which side of the surface is looked for.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Side {
    Inside,
    Outside,
}

/// Which crossings are asked for. Every decision is taken for both, in the same way; they differ in the work on roots.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Wanted {
    All,
    /// The first one if it lies ahead of the ray's start, else all.
    FirstAhead,
}

/// The work on one ray.
pub(super) struct Search<'a, A> {
    pub line: Line<'a, A>,
    pub findings: Findings<A>,
    pub decided: bool,
    wanted: Wanted,
    /// What was wanted is found.
    found: bool,
}

/// Places that are tried at most before a stretch is given up as touching: each cuts away a twentieth at least, so that the
/// smallest length is reached before.
const MOST_PLACES: usize = 1000;

/// The crossings of the ray with the superellipsoid.
#[inline]
pub(super) fn search<A: Real>(exponents: &Exponents, ray: &GenericRay<A>, wanted: Wanted) -> Attempt<Findings<A>> {
    let line = Line::new(exponents, ray);
    let findings = Findings { range: None, stretches: 0, undecided: 0, roots: Roots::new(), closest: None };
    let Some(range) = line.clip() else { return Attempt { found: findings, decided: true } };
    let mut search = Search { line, findings, decided: true, wanted, found: false };
    search.findings.range = Some(range.map(|delta| delta + search.line.foot.to_f64()));
    match exponents.bend() {
        Bend::Convex => search.convex(range),
        Bend::Concave => search.concave(range),
        Bend::Mixed => search.mixed(range),
    }
    Attempt { found: search.findings, decided: search.decided }
}

impl<A: Real> Search<'_, A> {
    /// Lengths below which neither the sign of g − 1 nor that of its slope can be told.
    pub fn shortest() -> f64 {
        A::UNIT_ROUNDOFF.sqrt()
    }

    fn convex(&mut self, [from, to]: [f64; 2]) {
        let [low, high] = [from, to].map(A::from_f64);
        let start = if from < 0.0 && 0.0 < to { A::ZERO } else { A::from_f64(0.5 * (from + to)) };
        let Some(inside) = self.seek([low, high], start, Side::Inside) else { return };
        // Whatever was tried before, this is what proves the hit.
        self.findings.closest = None;
        self.note(inside.at, inside.log, self.line.doubt(&inside).log);
        self.findings.stretches += 2;
        for (low, high, rising) in [(low, inside.at, false), (inside.at, high, true)] {
            let start = inside.at + A::from_f64(inside.step(rising));
            self.root(&Bracket { low, high, rising, start, cusp: None });
        }
    }

    fn concave(&mut self, range: [f64; 2]) {
        let (cuts, count) = self.line.cuts(range, &[0, 1, 2]);
        let [from, to] = range.map(A::from_f64);
        let (mut low, mut before) = (from, None);
        for &(at, axis) in &cuts[..count] {
            let probe = self.line.probe(at);
            let doubt = self.line.doubt_in_plane(&probe, axis);
            self.note(at, probe.log, doubt);
            if !self.is_told(probe.log, doubt) {
                return;
            }
            let exponent = self.line.exponents.of_axis(axis);
            let inside = is_inside::<A>(probe.log, doubt).then_some(Cusp {
                at,
                excess: probe.excess,
                exponent,
                touches: probe.log.abs() <= doubt,
            });
            self.piece([low, at], before, inside);
            (low, before) = (at, inside);
        }
        self.piece([low, to], before, None);
    }

    /// The roots between two neighbouring planes, given the ends that are inside.
    fn piece(&mut self, [low, high]: [A; 2], before: Option<Cusp<A>>, after: Option<Cusp<A>>) {
        self.findings.stretches += 1;
        let middle = low + (high - low) * A::from_f64(0.5);
        let outside = match (before, after) {
            (None, None) => return,
            (Some(_), None) => high,
            (None, Some(_)) => low,
            (Some(_), Some(_)) => match self.seek([low, high], middle, Side::Outside) {
                Some(probe) => probe.at,
                None => return,
            },
        };
        for (cusp, low, high, rising) in [(before, low, outside, true), (after, outside, high, false)] {
            if cusp.is_some() {
                let start = low + (high - low) * A::from_f64(0.5);
                self.root(&Bracket { low, high, rising, start, cusp });
            }
        }
    }

    /// A place on the wanted side of the surface, if there is one; g is convex, or concave and looked at from inside.
    fn seek(&mut self, [mut low, mut high]: [A; 2], mut at: A, wanted: Side) -> Option<Probe<A>> {
        let bend = if wanted == Side::Inside { Bend::Convex } else { Bend::Concave };
        for _ in 0..MOST_PLACES {
            self.findings.stretches += 1;
            let probe = self.line.probe(at);
            let doubt = self.line.doubt(&probe);
            self.note(at, probe.log, doubt.log);
            if !self.is_told(probe.log, doubt.log) || A::DOUBT_IS_ZERO && probe.log.abs() <= doubt.log {
                return None;
            }
            if is_inside::<A>(probe.log, doubt.log) == (wanted == Side::Inside) {
                return Some(probe);
            }
            let reach = probe.reach(doubt);
            if probe.slope.abs() > doubt.slope {
                let ahead = (probe.slope < 0.0) == (wanted == Side::Inside);
                if ahead {
                    low = at + A::from_f64(reach);
                } else {
                    high = at - A::from_f64(reach);
                }
            } else if reach >= (high - low).to_f64() {
                return None;
            }
            let length = (high - low).to_f64();
            if length <= 0.0 {
                return None;
            }
            if length < Self::shortest() {
                break;
            }
            let guess = at + A::from_f64(probe.to_extreme(bend));
            let margin = A::from_f64(0.05 * length);
            let fits = low < guess && guess < high;
            at = if fits { guess.max(low + margin).min(high - margin) } else { low + (high - low) * A::from_f64(0.5) };
        }
        self.give_up();
        None
    }

    /// A stretch that no bound decides.
    pub fn give_up(&mut self) {
        self.findings.undecided += 1;
        self.decided = false;
    }

    /// Adds the root in a bracket.
    pub fn root(&mut self, bracket: &Bracket<A>) {
        if (self.decided || A::FINEST) && !self.found {
            let root = root_in(&self.line, bracket);
            self.found = self.wanted == Wanted::FirstAhead && self.is_first_ahead(&root, bracket);
            self.findings.roots.push(root);
        }
    }

    /// Whether a root is the first of all, lies ahead, and would be the same if its fellows were known: the stretch is so
    /// long that they do not bound its error.
    fn is_first_ahead(&self, root: &Root, bracket: &Bracket<A>) -> bool {
        let inside = (self.line.foot + bracket.high).to_f64();
        self.findings.roots.as_ref().is_empty() && root.tau > 0.0 && root.error < 0.5 * (inside - root.tau)
    }

    /// Whether the sign at a place is told, or has to do.
    pub fn is_told(&mut self, value: f64, doubt: f64) -> bool {
        if value.abs() <= doubt {
            self.give_up();
        }
        self.decided || A::FINEST
    }

    /// Keeps the closest call.
    #[inline]
    pub fn note(&mut self, at: A, value: f64, doubt: f64) {
        let margin = value.abs() / doubt;
        if self.findings.closest.is_none_or(|closest| margin < closest.margin) {
            self.findings.closest = Some(Closest { at, margin });
        }
    }
}

/// What lies within the doubt of the finest arithmetic counts as inside: a touch from within is no hit.
fn is_inside<A: Real>(value: f64, doubt: f64) -> bool {
    value < 0.0 || A::DOUBT_IS_ZERO && value <= doubt
}

#[cfg(test)]
mod tests {
    use super::super::testing::solve;
    use super::super::{Primitive, Superellipsoid};
    use super::*;
    use crate::math::DoubleDouble;
    use glam::DVec3;
    use proptest::prelude::*;

    /// Whether the ray is inside at t, from the definition of F alone; unknown where rounding of t decides.
    fn is_inside_at(shape: &Superellipsoid, [n, m]: [f64; 2], origin: DVec3, direction: DVec3, t: f64) -> Option<bool> {
        let plain = shape.implicit(origin + direction * t);
        if plain.abs() > 1e-6 {
            return Some(plain < 0.0);
        }
        let number = DoubleDouble::from_f64;
        let place = |i: usize| (number(origin[i]) + number(direction[i]) * number(t)).abs();
        let power = |x: DoubleDouble, p: f64, q: f64| x.pow(number(p) / number(q));
        let radius = power(power(place(0), n, 1.0) + power(place(1), n, 1.0), m, n);
        let wide = (radius + power(place(2), m, 1.0) - DoubleDouble::ONE).to_f64();
        (wide.abs() > 1e-20).then_some(wide < 0.0)
    }

    /// Samples the sign of F and asserts that between neighbouring samples it changes as often as there are crossings, but
    /// for pairs between two samples.
    fn check_against_samples([n, m]: [f64; 2], origin: DVec3, direction: DVec3, samples: u32) {
        let shape = Superellipsoid::new(n, m).unwrap();
        let crossings = solve::<f64>(&shape, origin, direction);
        let middle = -origin.dot(direction) / direction.length_squared();
        let half = 2.0 / direction.length();
        let at = |k: u32| middle - half + 2.0 * half * (f64::from(k) + 0.37) / f64::from(samples);
        for t in (0..samples).map(at) {
            if crossings.iter().any(|crossing| (crossing.t - t).abs() <= crossing.error) {
                continue;
            }
            let before = crossings.iter().filter(|crossing| crossing.t < t).count();
            let inside = is_inside_at(&shape, [n, m], origin, direction, t);
            assert!(
                inside.is_none_or(|inside| inside == (before % 2 == 1)),
                "n = {n}, m = {m}, S = {origin}, c = {direction}, t = {t}: {inside:?} behind {before} of {crossings:?}"
            );
        }
    }

    /// An exponent from 0.1 to 50, evenly on a logarithmic scale.
    fn exponent() -> impl Strategy<Value = f64> {
        (0.1_f64.ln()..50.0_f64.ln()).prop_map(f64::exp)
    }

    fn vector(size: f64) -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-size..size).prop_map(DVec3::from_array)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(400))]

        #[test]
        fn dense_samples_find_no_crossing_that_was_missed(n in exponent(), m in exponent(), origin in vector(5.0), aim in vector(0.7)) {
            check_against_samples([n, m], origin, aim - origin, 2000);
        }

        #[test]
        fn so_it_is_in_coordinate_planes_and_along_axes(n in exponent(), m in exponent(), origin in vector(5.0), aim in vector(0.7), axis in 0..3_usize) {
            let mut flat = [origin.to_array(), (aim - origin).to_array()];
            flat[0][axis] = 0.0;
            flat[1][axis] = 0.0;
            check_against_samples([n, m], flat[0].into(), flat[1].into(), 1000);
            let mut straight = [0.0; 3];
            straight[axis] = 2.0;
            check_against_samples([n, m], aim, straight.into(), 1000);
        }

        #[test]
        fn exponents_at_the_ends_are_no_exception(
            n in prop::sample::select(vec![0.05, 0.3, 1.0, 2.0, 20.0, 1000.0]),
            m in prop::sample::select(vec![0.05, 0.3, 1.0, 2.0, 20.0, 1000.0]),
            origin in vector(5.0),
            aim in vector(1.0),
        ) {
            check_against_samples([n, m], origin, aim - origin, 1000);
        }
    }

    fn times(n: f64, m: f64, origin: [f64; 3], direction: [f64; 3]) -> Vec<f64> {
        let shape = Superellipsoid::new(n, m).unwrap();
        solve::<f64>(&shape, origin.into(), direction.into()).iter().map(|hit| hit.t).collect()
    }

    #[test]
    fn a_gap_of_three_hundred_millionths_beyond_a_cusp_is_found() {
        // √|x| + √y = 1 with √y = 1 − 2⁻¹³, of which the square is exact, so |x| = 2⁻²⁶.
        let (height, half) = ((1.0 - 2.0_f64.powi(-13)).powi(2), 2.0_f64.powi(-26));
        let expect = |found: Vec<f64>| {
            assert_eq!(found.len(), 2, "{found:?}");
            assert!(found.iter().zip([2.0 - half, 2.0 + half]).all(|(a, b)| (a - b).abs() < 1e-15), "{found:?}");
        };
        for m in [0.3, 0.5, 0.9, 1.0, 2.0, 7.5] {
            expect(times(0.5, m, [-2.0, height, 0.0], [1.0, 0.0, 0.0]));
        }
        for n in [0.3, 0.5, 0.9, 1.0, 2.0, 7.5] {
            expect(times(n, 0.5, [height, 0.0, -2.0], [0.0, 0.0, 1.0]));
            expect(times(n, 0.5, [-2.0, 0.0, height], [1.0, 0.0, 0.0]));
        }
    }

    #[test]
    fn the_smallest_and_the_largest_exponents_meet_diagonals_where_they_should() {
        // 2 x^p = 1.
        let (small, large) = (2.0_f64.powi(-20), 2.0_f64.powf(-0.001));
        let cases = [
            (0.05, 0.05, [1.0, 1.0, 0.0], small),
            (0.05, 1000.0, [1.0, 1.0, 0.0], small),
            (1000.0, 0.05, [1.0, 0.0, 1.0], small),
            (1000.0, 1000.0, [0.0, 1.0, 1.0], large),
            (1000.0, 0.05, [1.0, 1.0, 0.0], large),
            (0.05, 1000.0, [1.0, 0.0, 1.0], large),
        ];
        for (n, m, direction, expected) in cases {
            let found = times(n, m, [0.0; 3], direction);
            assert_eq!(found.len(), 2, "{n} {m}: {found:?}");
            assert!((found[0] + expected).abs() < 1e-14 && (found[1] - expected).abs() < 1e-14, "{n} {m}: {found:?}");
        }
    }

    #[test]
    fn ordinary_rays_need_few_stretches() {
        // Convex: a place inside and what is on either side. Concave: four pieces, and a tangent in each of the middle two.
        for (n, m, most) in [(2.0, 2.0, 3), (8.0, 8.0, 3), (0.5, 0.5, 6), (3.0, 0.7, 12), (0.7, 3.0, 12)] {
            let exponents = Exponents::new(n, m);
            let ray = GenericRay::<f64>::new(DVec3::new(3.0, 1.0, 0.5), DVec3::new(-3.0, -0.8, -0.4));
            let attempt = search(&exponents, &ray, Wanted::All);
            let stretches = attempt.found.stretches;
            assert!(attempt.decided && attempt.found.undecided == 0 && stretches <= most, "{n} {m}: {stretches}");
            // The hollow one is left and entered again: at t = 1.1 it is √0.3 + √0.12 + √0.06 = 1.14.
            let expected = if n == m && n < 1.0 { 4 } else { 2 };
            assert_eq!(attempt.found.roots.as_ref().len(), expected, "{n} {m}");
        }
    }

    #[test]
    fn rays_through_a_flat_pole_need_no_more_digits() {
        let origin = DVec3::new(-16.7, -6.7, 23.8);
        for (n, m) in [(0.8, 8.0), (0.8, 20.0), (0.8, 300.0), (0.5, 20.0), (0.3, 40.0)] {
            let shape = Superellipsoid::new(n, m).unwrap();
            for aim in [[0.1, 0.05], [-0.05, 0.1], [0.001, 0.002], [-0.07, -0.01], [1e-5, 1e-4]] {
                let target = DVec3::new(aim[0], aim[1], 1.0);
                let ray = GenericRay::<f64>::new(origin, target - origin);
                let attempt = search(&shape.exponents, &ray, Wanted::All);
                assert!(
                    attempt.decided && attempt.found.stretches < 20,
                    "{n} {m} {aim:?}: {}",
                    attempt.found.stretches
                );
                let entry = ray.point(attempt.found.roots.as_ref()[0].tau);
                // |z| = (1 − ρᵐ)^(1/m), which is at least 1 − ρᵐ.
                let radius = (entry.x.abs().powf(n) + entry.y.abs().powf(n)).powf(1.0 / n);
                let missing = 1.0 - entry.z;
                assert!(-1e-13 < missing && missing < radius.powf(m) + 1e-13, "{n} {m} {aim:?}: {entry}");
            }
        }
    }
}
