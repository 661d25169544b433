//! From a bracket on the quartic of a torus to the hit time.
//!
//! The turning point inside the solid is where the start comes from: with h the way from it to the crossing,
//! G = g + a₁ h + a₂ h² + a₃ h³ + h⁴, and h₀ = √(−g / a₂) but for what a₃ and the fourth power change. One step of
//! Householder's method of the third order leaves about the square root of an error in the last digit, and Newton's method
//! on F itself, which cancels less than G, the rest. Its steps never leave the bracket.

use super::GenericRay;
use super::boundary::Root;
use super::torus_quartic::{Bracket, Quartic};
use crate::math::{Real, dot};

/// Bisection alone ends after as many steps as a number has bits, even with a step of Newton's method before each.
const MOST_STEPS: u32 = 256;

/// F at a point of the ray, with what its slope and its gradient need.
struct Place<A> {
    /// F.
    value: A,
    /// ρ ∇F / 2, where ρ = √(x² + y²) is not zero.
    gradient: [A; 3],
    /// ρ F′ / 2.
    slope: A,
    /// ρ / 2.
    half_radius: A,
}

impl<A: Real> Place<A> {
    #[inline]
    fn new(quartic: &Quartic<A>, delta: A) -> Self {
        let [x, y, z] = quartic.point(delta);
        let radius = (x * x + y * y).sqrt();
        let from_middle = radius - quartic.d;
        let value = from_middle * from_middle + (z * z - A::ONE);
        // On the axis only z counts.
        let radius = if radius == A::ZERO { A::ONE } else { radius };
        let gradient = [x * from_middle, y * from_middle, z * radius];
        Self { value, gradient, slope: dot(gradient, quartic.course), half_radius: A::from_f64(0.5) * radius }
    }

    /// How far the time moves when S and c are off by one part in one, and so are the terms of F.
    #[inline]
    fn moved(&self, ray: &GenericRay<A>, quartic: &Quartic<A>, tau: f64) -> f64 {
        // The point is found by way of the foot, which may be farther off than the hit.
        let [x, y, z] = ray.sway(tau.abs() + quartic.line.foot.abs().to_f64());
        let [g_x, g_y, g_z] = self.gradient.map(|g| g.abs().to_f64());
        let (radius, d) = (2.0 * self.half_radius.to_f64(), quartic.d.to_f64());
        let own = radius * ((radius - d).abs() * (radius + d) + 1.0);
        (g_x * x + g_y * y + g_z * z + own) / self.slope.abs().to_f64()
    }

    /// The step of Newton's method.
    #[inline]
    fn step(&self) -> A {
        self.value * self.half_radius / self.slope
    }
}

/// The crossing in a bracket; `slope` is G′ at the turning points.
#[inline]
pub(super) fn crossing<A: Real>(ray: &GenericRay<A>, quartic: &Quartic<A>, slope: A, bracket: &Bracket<A>) -> Root {
    let (place, delta) = settle(quartic, bracket, start(quartic, slope, bracket));
    let tau = quartic.tau(delta).to_f64();
    Root { tau, error: ray.error_of_time(place.moved(ray, quartic, tau), tau), part: 0 }
}

/// A first approximation, by the quartic about the turning point; not a number where that does not cross zero.
#[inline]
fn start<A: Real>(quartic: &Quartic<A>, slope: A, bracket: &Bracket<A>) -> A {
    let number = A::from_f64;
    let (middle, g) = (bracket.inside.at, bracket.inside.value);
    let p = quartic.half_p + quartic.half_p;
    let (a1, a2, a3) = (slope, number(6.0) * middle * middle + p, number(4.0) * middle);
    // h is measured towards the crossing.
    let (a1, a3) = (a1 * bracket.outward, a3 * bracket.outward);
    let per_a2 = A::ONE / a2;
    let h = (-g * per_a2).sqrt();
    // h² (1 + b h / h₀) = h₀² has this root but for the third power of b.
    let b = (a3 + h) * h * per_a2;
    let h = h * (A::ONE + number(0.75) * b) / (A::ONE + number(1.25) * b);
    let h = h.min(bracket.high - bracket.low);
    let value = g + h * (a1 + h * (a2 + h * (a3 + h)));
    let slope = a1 + h * (a2 + a2 + h * (number(3.0) * a3 + number(4.0) * h));
    let second = a2 + h * (number(3.0) * a3 + number(6.0) * h);
    let third = a3 + number(4.0) * h;
    let (square, bend) = (slope * slope, value * second);
    let step = value * (square - bend) / (slope * (square - (bend + bend)) + value * value * third);
    middle + bracket.outward * (h - step)
}

/// Newton's method on F from `start`, in a bracket that only ever shrinks: the last place looked at, and the root.
#[inline]
fn settle<A: Real>(quartic: &Quartic<A>, bracket: &Bracket<A>, start: A) -> (Place<A>, A) {
    let (mut low, mut high) = (bracket.low, bracket.high);
    let middle = |low: A, high: A| low + A::from_f64(0.5) * (high - low);
    let mut delta = if low < start && start < high { start } else { middle(low, high) };
    let mut place = Place::new(quartic, delta);
    let entering = bracket.outward < A::ZERO;
    // So near to the surface F is nothing but rounding, and the next step the last that helps.
    let noise = A::UNIT_ROUNDOFF * (quartic.d.to_f64() + 1.0);
    for _ in 0..MOST_STEPS {
        if (place.value < A::ZERO) == entering {
            high = delta;
        } else {
            low = delta;
        }
        let step = place.step();
        let newton = delta - step;
        let fits = low < newton && newton < high;
        // The square of a relative error this small is below the last digit, for the slope changes over no shorter way than
        // that to the turning point.
        let short = 0.5 * A::UNIT_ROUNDOFF.sqrt() * (delta - bracket.inside.at).abs().to_f64();
        if step.abs().to_f64() <= short || place.value.abs().to_f64() <= noise {
            return (place, if fits { newton } else { delta });
        }
        let next = if fits { newton } else { middle(low, high) };
        if next == low || next == high {
            break;
        }
        delta = next;
        place = Place::new(quartic, delta);
    }
    (place, delta)
}
