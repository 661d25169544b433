//! The one root of a superellipsoid's gauge in a stretch of the ray where its sign is known to change once.
//!
//! Steps are those of a parabola through g² (Laguerre's idea: cubic convergence), or next to a cusp, where g − g₀ grows with
//! a power p < 1 of the distance d, those of Newton's method in dᵖ. The bracket of signs only ever shrinks, and steps that
//! leave it are halvings. The last ones are taken from coordinates without error but their own rounding.

use super::boundary::Root;
use super::superellipsoid_line::{Line, Probe};
use crate::math::{Real, portable};

/// A stretch with one root in it.
pub(super) struct Bracket<A> {
    /// δ at its ends.
    pub low: A,
    pub high: A,
    /// Whether g rises through 1.
    pub rising: bool,
    /// Where to begin.
    pub start: A,
    /// The cusp at the end that is inside, if there is one.
    pub cusp: Option<Cusp<A>>,
}

/// A place in a coordinate plane, below the surface.
#[derive(Clone, Copy)]
pub(super) struct Cusp<A> {
    /// δ.
    pub at: A,
    /// F there.
    pub excess: f64,
    /// How F grows with the distance.
    pub exponent: f64,
    /// Whether it is on the surface itself, as far as can be told.
    pub touches: bool,
}

impl<A: Real> Cusp<A> {
    /// Newton's step for F as a function of dᵖ, or where that goes astray the chord's from the cusp; far enough away in
    /// comparison with the step, that of g². With the order of its convergence.
    fn step(&self, probe: &Probe<A>, rising: bool, m: f64) -> (f64, i32) {
        let distance = (probe.at - self.at).to_f64();
        let usual = probe.step(rising);
        if usual.abs() < 0.2 * distance.abs() {
            return (usual, 3);
        }
        // F′ = m T (ln g)′.
        let slope = m * (1.0 + probe.excess) * probe.slope;
        let newton = 1.0 - self.exponent * probe.excess / (slope * distance);
        let chord = self.excess / (self.excess - probe.excess);
        let factor = if newton > 0.0 && slope * distance > 0.0 { newton } else { chord };
        (distance * (portable::powf(factor, 1.0 / self.exponent) - 1.0), 2)
    }
}

/// Errors of δ below this do not show in the result.
const SHORT: f64 = f64::EPSILON / 64.0;
/// Steps shorter than this are followed by exact coordinates: they cost less than one more step.
const NEAR: f64 = 0.1;
/// Halving alone ends after as many steps as numbers have bits; twice that, for every other step after the first few is one.
const MOST_STEPS: usize = 240;

/// The root.
pub(super) fn root_in<A: Real>(line: &Line<A>, bracket: &Bracket<A>) -> Root {
    let Bracket { mut low, mut high, rising, start, cusp } = *bracket;
    if let Some(touching) = cusp.filter(|cusp| cusp.touches) {
        return line.root_in_plane(touching.at);
    }
    let half = A::from_f64(0.5);
    let middle = |low: A, high: A| low + (high - low) * half;
    let mut at = if low < start && start < high { start } else { middle(low, high) };
    let mut last = (high - low).to_f64();
    let short = SHORT.max(A::UNIT_ROUNDOFF / 32.0);
    // Convergence shows in two steps of the method, not in one after a halving.
    let mut converges = false;
    let (mut exact, mut best) = (line.exponents.is_smooth(), None);
    for round in 0..MOST_STEPS {
        let tau = line.foot + at;
        let (probe, gradient) = if exact { line.probe_exactly(tau) } else { (line.probe(at), [0.0; 3]) };
        if (probe.excess < 0.0) == rising {
            low = at;
        } else {
            high = at;
        }
        let (step, order) = match cusp {
            Some(cusp) => cusp.step(&probe, rising, line.exponents.m),
            None => (probe.step(rising), 3),
        };
        let size = step.abs();
        let next = at + A::from_f64(step);
        let fits = low < next && next < high || next == at;
        if exact {
            // What the next step would be, as the last two go.
            let scale = cusp.map_or(last, |cusp| last.min((at - cusp.at).to_f64().abs()));
            let expected = size * portable::powi(size / scale, if converges { order } else { 1 });
            let in_noise = probe.log.abs() <= 2.0 * A::UNIT_ROUNDOFF * line.exponents.roundings();
            // Far from the surface a step of nothing only says that T has overflowed.
            // A step within the rounding of τ may leave the bracket, whose ends were not rounded so.
            let least = short.max(A::UNIT_ROUNDOFF * tau.abs().to_f64());
            let done = in_noise || probe.excess.abs() < 0.1 && (fits && expected <= short || size <= least);
            let moved = if size.is_finite() && (fits || size <= NEAR * last) { tau + A::from_f64(step) } else { tau };
            best = Some(line.root(moved, &probe, gradient));
            if done {
                break;
            }
        }
        let halve = !fits || round > 10 && round % 2 == 0;
        at = if halve { middle(low, high) } else { next };
        if halve && (at == low || at == high) {
            exact = true;
        }
        last = if halve { (high - low).to_f64() } else { size };
        converges = !halve;
        exact |= last < NEAR;
    }
    best.unwrap_or_default()
}
