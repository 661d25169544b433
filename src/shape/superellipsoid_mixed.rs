//! The search where one exponent is above 1 and the other below, so that g is neither convex nor concave.
//!
//! With ρ = (|x|ⁿ + |y|ⁿ)^(1/n) and σ = (1 − |z|ᵐ)^(1/m), the radius of the solid at the height z, the ray is inside where
//! d = ρ − σ is below 0. For n ≥ 1 > m both ρ and σ are convex where z keeps its sign, for n < 1 ≤ m both are concave where x
//! and y keep theirs. On such a piece each of them lies between its chord and its tangents, and its slope between those at the
//! ends. So two straight lines from either end bound d from below and from above, and a stretch is done when these show that
//! d keeps its sign, or the slopes that it only rises or only falls. Else it is halved where it is in doubt. The bounds
//! close in with the square of the length.
//!
//! At a flat pole (m > 1) σ is as steep as it is uncertain, but g is neither: where |z| rises steadily and ρ is concave,
//! (gᵐ)′/m = ρᵐ⁻¹ ρ′ + |z|ᵐ⁻¹ |z|′ is bounded from below by the values at the ends, and where the bound is positive g only rises.
//!
//! Source: R. Horst, H. Tuy, Global Optimization, 3rd ed. (1996), ch. X (differences of convex functions).

use super::gauge::Exponents;
use super::superellipsoid_line::Line;
use super::superellipsoid_root::{Bracket, Cusp};
use super::superellipsoid_search::Search;
use crate::math::{Real, portable};

/// d = ρ − σ at one place of the ray.
#[derive(Clone, Copy)]
struct Cut<A> {
    /// δ.
    at: A,
    radius: A,
    section: A,
    /// d, and bound on its error.
    value: f64,
    doubt: f64,
    inside: bool,
    /// Whether it is on the surface, as far as can be told.
    touches: bool,
    /// ρ′ and σ′; in a plane with a cusp there are none.
    slopes: [f64; 2],
    /// ρ, rather too large than too small, and how far off ρ′ may be.
    most: f64,
    slope_doubt: f64,
    /// |z|, rather too small than too large, and |z|′.
    height: f64,
    climb: f64,
    /// The exponent of a coordinate that is zero here and makes a cusp.
    cusp: Option<f64>,
}

/// Stretches that are bounded at most. Random rays need a handful, touches a few hundred.
const MOST_STRETCHES: usize = 2000;

impl<A: Real> Cut<A> {
    /// How far Newton's step goes into the stretch, if it stays there.
    fn newton(&self, ahead: bool, length: f64) -> Option<f64> {
        let step = -self.value / (self.slopes[0] - self.slopes[1]);
        let inwards = if ahead { step } else { -step };
        (self.cusp.is_none() && 0.0 < inwards && inwards < length).then_some(inwards)
    }

    /// ρ′ and σ′ towards the side on which the stretch lies.
    fn slopes_towards(&self, ahead: bool, n: f64) -> [f64; 2] {
        let away = if ahead { f64::INFINITY } else { f64::NEG_INFINITY };
        match self.cusp {
            Some(_) if n < 1.0 => [away, self.slopes[1]],
            Some(_) => [self.slopes[0], -away],
            None => self.slopes,
        }
    }
}

/// The steepest fall and the steepest rise of lines from the two ends of a stretch, which bound d from below and from above.
struct Lines {
    lower: [f64; 2],
    upper: [f64; 2],
    /// Bounds of d′.
    slope: [f64; 2],
}

impl<A: Real> Search<'_, A> {
    /// Every crossing, for exponents on both sides of 1.
    pub fn mixed(&mut self, range: [f64; 2]) {
        let axes: &[usize] = if self.line.exponents.n < 1.0 { &[0, 1] } else { &[2] };
        let (cuts, count) = self.line.cuts(range, axes);
        let [from, to] = range.map(A::from_f64);
        let mut left = self.cut(from, None, true);
        for &(at, axis) in &cuts[..count] {
            let right = self.cut(at, Some(axis), false);
            self.settle(&left, &right);
            left = right;
        }
        let right = self.cut(to, None, true);
        self.settle(&left, &right);
    }

    fn cut(&mut self, at: A, plane: Option<usize>, is_end: bool) -> Cut<A> {
        let line = &self.line;
        let mut cut = cut(line, at);
        if let Some(axis) = plane {
            cut.doubt += line.drift(axis) * (cut.slopes[0] - cut.slopes[1]).abs();
            cut.cusp = Some(line.exponents.of_axis(axis));
        }
        if is_end {
            cut.inside = false;
            return cut;
        }
        let (mut value, mut doubt) = (cut.value, cut.doubt);
        if value.abs() <= doubt {
            // Near the poles g keeps digits that σ loses.
            let probe = line.probe(at);
            value = probe.log;
            doubt = plane.map_or_else(|| line.doubt(&probe).log, |axis| line.doubt_in_plane(&probe, axis));
        }
        self.note(at, value, doubt);
        self.is_told(value, doubt);
        // What cannot be told from a touch by 32 digits counts as outside.
        cut.touches = A::DOUBT_IS_ZERO && value.abs() <= doubt;
        cut.inside = value < 0.0 && !cut.touches;
        cut
    }

    /// Bounds a stretch, and halves it until all is decided; from left to right.
    fn settle(&mut self, left: &Cut<A>, right: &Cut<A>) {
        if !self.decided && !A::FINEST {
            return;
        }
        self.findings.stretches += 1;
        let length = (right.at - left.at).to_f64();
        if length <= 0.0 || length.is_nan() {
            return;
        }
        let lines = self.lines(left, right, length);
        let doubts = left.doubt + right.doubt;
        let margin = 2.0 * doubts / length;
        // How far the sign of either end is sure to last.
        let lasts = |cut: &Cut<A>, towards: f64| {
            let falls = towards + margin;
            if falls <= 0.0 { f64::INFINITY } else { (cut.value.abs() - cut.doubt).max(0.0) / falls }
        };
        let ahead = lasts(left, if left.inside { lines.upper[0] } else { -lines.lower[0] });
        let behind = lasts(right, if right.inside { -lines.upper[1] } else { lines.lower[1] });
        if left.inside == right.inside {
            if ahead + behind >= length || self.is_steady(left, right, length) {
                return;
            }
        } else {
            let sure = if left.inside { lines.slope[0] } else { -lines.slope[1] };
            if sure > margin || length < Self::shortest() || self.is_steady(left, right, length) {
                self.root_between(left, right, length);
                return;
            }
        }
        if length < Self::shortest() || self.findings.stretches >= MOST_STRETCHES {
            self.give_up();
            return;
        }
        let (ahead, behind) = (ahead.min(length), behind.min(length));
        let share = 0.5 * (ahead + (length - behind)) / length;
        let share = if share.is_nan() { 0.5 } else { share.clamp(0.05, 0.95) };
        let middle = self.cut(left.at + A::from_f64(share * length), None, false);
        self.settle(left, &middle);
        self.settle(&middle, right);
    }

    /// Whether g is sure to rise, or to fall, all the way as |z| does.
    fn is_steady(&self, left: &Cut<A>, right: &Cut<A>, length: f64) -> bool {
        let Exponents { n, m, .. } = *self.line.exponents;
        // Towards the larger |z|, ρ falls fastest at the end, and was at the beginning no more than what it fell by larger.
        let (low, high, towards) = if left.climb > 0.0 { (left, right, 1.0) } else { (right, left, -1.0) };
        let climb = low.climb * towards;
        let fall = high.slope_doubt - towards * high.slopes_towards(towards < 0.0, n)[0];
        let over = (high.most + fall * length) / low.height;
        let rises = n < 1.0 && climb > 0.0 && low.height > 0.0;
        rises && (fall <= 0.0 || portable::powf(over, m - 1.0) * fall < 0.9 * climb)
    }

    fn lines(&self, left: &Cut<A>, right: &Cut<A>, length: f64) -> Lines {
        let n = self.line.exponents.n;
        let ([r, s], [u, v]) = (left.slopes_towards(true, n), right.slopes_towards(false, n));
        let radius = (right.radius - left.radius).to_f64() / length;
        let section = (right.section - left.section).to_f64() / length;
        let (by_radius, by_section) = ([r - section, u - section], [radius - s, radius - v]);
        if n < 1.0 {
            Lines { lower: by_section, upper: by_radius, slope: [u - s, r - v] }
        } else {
            Lines { lower: by_radius, upper: by_section, slope: [r - v, u - s] }
        }
    }

    /// The one root of a stretch.
    fn root_between(&mut self, left: &Cut<A>, right: &Cut<A>, length: f64) {
        if let Some(touching) = [left, right].into_iter().find(|cut| cut.touches) {
            self.findings.roots.push(self.line.root_in_plane(touching.at));
            return;
        }
        let inside = if left.inside { left } else { right };
        let cusp = inside.cusp.map(|exponent| {
            let excess = self.line.probe(inside.at).excess;
            Cusp { at: inside.at, excess, exponent, touches: false }
        });
        let start = match (left.newton(true, length), right.newton(false, length)) {
            (Some(a), Some(b)) if a > b => right.at - A::from_f64(b),
            (Some(a), _) => left.at + A::from_f64(a),
            (None, Some(b)) => right.at - A::from_f64(b),
            (None, None) => left.at + A::from_f64(0.5 * length),
        };
        self.root(&Bracket { low: left.at, high: right.at, rising: left.inside, start, cusp });
    }
}

/// d at δ.
fn cut<A: Real>(line: &Line<A>, at: A) -> Cut<A> {
    let ([x, y, z], rates) = line.place(at);
    let (radius, shares) = line.exponents.radius(x, y);
    let (section, steepness) = line.exponents.section(z);
    let (rho, sigma) = (radius.to_f64(), section.to_f64());
    let terms = [rho * shares[0] * rates[0], rho * shares[1] * rates[1]];
    // At the poles σ is 0, and steep or flat as m makes it.
    let poles = sigma == 0.0 || !steepness.is_finite();
    let limit = if line.exponents.m > 1.0 { -f64::INFINITY * rates[2].signum() } else { 0.0 };
    let section_slope = if poles { limit } else { -sigma * steepness * rates[2] };
    let rounding = A::UNIT_ROUNDOFF * line.exponents.roundings();
    let blurred =
        line.blurred([terms[0], terms[1], section_slope], [rho * shares[0], rho * shares[1], sigma * steepness]);
    // 1 − |z|ᵐ is off by a few roundings of 1, whatever is left of it; near the poles the root makes much of that.
    let rest = 1.0 / (1.0 + steepness);
    let off = rounding * line.exponents.m;
    let cancelled = if rest < 1e4 * off || !blurred.is_finite() {
        portable::powf(rest + off, 1.0 / line.exponents.m)
    } else {
        sigma * rounding / rest + blurred
    };
    let doubt = rounding * (rho + sigma) + cancelled;
    let value = (radius - section).to_f64();
    let by_place = line.blurred([terms[0], terms[1], 0.0], [rho * shares[0], rho * shares[1], 0.0]);
    Cut {
        at,
        radius,
        section,
        value,
        doubt,
        inside: value < 0.0,
        touches: false,
        slopes: [terms[0] + terms[1], section_slope],
        most: rho * (1.0 + rounding) + by_place,
        slope_doubt: (terms[0].abs() + terms[1].abs())
            * (rounding + line.coarseness(0, rates[0]).max(line.coarseness(1, rates[1]))),
        height: (z.to_f64() * (1.0 - line.coarseness(2, rates[2]))).max(0.0),
        climb: z.to_f64() * rates[2],
        cusp: None,
    }
}
