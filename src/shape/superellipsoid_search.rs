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
use super::boundary::Roots;
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

/// The work on one ray.
pub(super) struct Search<'a, A> {
    pub line: Line<'a, A>,
    pub findings: Findings<A>,
    pub decided: bool,
}

/// Places that are tried at most before a stretch is given up as touching: each cuts away a twentieth at least, so that the
/// smallest length is reached before.
const MOST_PLACES: usize = 1000;

/// Every crossing of the ray with the superellipsoid.
#[inline]
pub(super) fn search<A: Real>(exponents: &Exponents, ray: &GenericRay<A>) -> Attempt<Findings<A>> {
    let line = Line::new(exponents, ray);
    let findings = Findings { range: None, stretches: 0, undecided: 0, roots: Roots::new(), closest: None };
    let Some(range) = line.clip() else { return Attempt { found: findings, decided: true } };
    let mut search = Search { line, findings, decided: true };
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
            self.root(Bracket { low, high, rising, start, cusp: None });
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
            let inside = is_inside::<A>(probe.log, doubt).then_some(Cusp { at, excess: probe.excess, exponent });
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
                self.root(Bracket { low, high, rising, start, cusp });
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
    pub fn root(&mut self, bracket: Bracket<A>) {
        if self.decided || A::FINEST {
            self.findings.roots.push(root_in(&self.line, bracket));
        }
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
pub(super) fn is_inside<A: Real>(value: f64, doubt: f64) -> bool {
    value < 0.0 || A::DOUBT_IS_ZERO && value <= doubt
}
