//! From a stretch between the turning points of a torus's quartic to the two hit times.
//!
//! The turning points inside the solid are where the starts come from: with h the way from one to the crossing,
//! G = g + a₁ h + a₂ h² + a₃ h³ + h⁴, and h₀ = √(−g / a₂) but for what a₃ and the fourth power change. One step of
//! Householder's method of the third order leaves about the square root of an error in the last digit, and Chebyshev's method
//! on F itself, which cancels less than G, the rest. Its steps never leave the bracket.
//!
//! A ray that enters leaves too, and both crossings take the same steps, side by side.

use super::GenericRay;
use super::boundary::Root;
use super::torus_quartic::{Quartic, Stretch};
use crate::math::{Pair, Real};

/// Bisection alone ends after as many steps as a number has bits, even with a step of Chebyshev's method before each.
const MOST_STEPS: u32 = 256;

/// The directions from the inside to the two crossings: back to where the ray enters, on to where it leaves.
const OUTWARD: [f64; 2] = [-1.0, 1.0];

/// F at two points of the ray, with what its slopes and its gradient need.
struct Places<A> {
    /// F.
    value: Pair<A>,
    /// ρ ∇F / 2, where ρ = √(x² + y²) is not zero.
    gradient: [Pair<A>; 3],
    /// ρ.
    radius: Pair<A>,
    /// 2 / (ρ F′).
    per_slope: Pair<A>,
    /// The step of Chebyshev's method towards the root.
    step: Pair<A>,
}

impl<A: Real> Places<A> {
    #[inline]
    fn new(quartic: &Quartic<A>, delta: Pair<A>) -> Self {
        let ([l_x, l_y, l_z], [c_x, c_y, c_z]) = (quartic.line.nearest, quartic.course);
        let [x, y, z] = [delta * c_x + l_x, delta * c_y + l_y, delta * c_z + l_z];
        let radius = (x * x + y * y).sqrt();
        let from_middle = radius - quartic.d;
        let value = from_middle * from_middle + (z * z - A::ONE);
        // On the axis only z counts.
        let radius = radius.map(|radius| if radius == A::ZERO { A::ONE } else { radius });
        let outward = x * c_x + y * c_y;
        let slope = from_middle * outward + radius * z * c_z;
        let per_both = (radius * slope).map(|both| A::ONE / both);
        let (per_radius, per_slope) = (slope * per_both, radius * per_both);
        // ρ² F″ / 2.
        let bend = outward * outward * per_radius * quartic.d
            + (from_middle * (c_x * c_x + c_y * c_y) + radius * (c_z * c_z)) * radius;
        let half = A::from_f64(0.5);
        let newton = value * half * (radius * per_slope);
        Self {
            value,
            gradient: [x * from_middle, y * from_middle, z * radius],
            radius,
            per_slope,
            step: newton + newton * newton * half * (bend * per_both),
        }
    }

    /// How far the times move when S and c are off by one part in one, and so are the terms of F.
    #[inline]
    fn moved(&self, ray: &GenericRay<A>, quartic: &Quartic<A>, tau: Pair<f64>) -> Pair<f64> {
        // The point is found by way of the foot, which may be farther off than the hit.
        let way = tau.map(f64::abs) + quartic.line.foot.abs().to_f64();
        let size = |x: Pair<A>| x.map(|x| x.abs().to_f64());
        let (radius, d) = (size(self.radius), quartic.d.to_f64());
        let own = radius * ((radius - d).map(f64::abs) * (radius + d) + 1.0);
        let sway = |axis: usize| way * ray.direction_size[axis] + ray.origin_size[axis];
        let [g_x, g_y, g_z] = self.gradient.map(size);
        (g_x * sway(0) + g_y * sway(1) + g_z * sway(2) + own) * size(self.per_slope)
    }
}

/// Where the ray enters and leaves in a stretch; `slope` is G′ at the turning points.
#[inline]
pub(super) fn crossings<A: Real>(
    ray: &GenericRay<A>,
    quartic: &Quartic<A>,
    slope: A,
    stretch: &Stretch<A>,
) -> [Root; 2] {
    let (places, delta) = settle(quartic, stretch, start(quartic, slope, stretch));
    let tau = delta.map(|delta| quartic.tau(delta).to_f64());
    let roots = places.moved(ray, quartic, tau).with(tau, |moved, tau| Root {
        tau,
        error: ray.error_of_time(moved, tau),
        part: 0,
    });
    roots.0
}

/// First approximations, by the quartic about the turning points; not numbers where that does not cross zero.
#[inline]
fn start<A: Real>(quartic: &Quartic<A>, slope: A, stretch: &Stretch<A>) -> Pair<A> {
    let number = A::from_f64;
    let outward = Pair(OUTWARD.map(number));
    let (middle, g) = (stretch.inside, stretch.value);
    // h is measured towards the crossings.
    let a1 = outward * slope;
    let a2 = middle * middle * number(6.0) + (quartic.half_p + quartic.half_p);
    let a3 = outward * middle * number(4.0);
    let per_a2 = a2.map(|a2| A::ONE / a2);
    let h = (g * per_a2).map(|square| (-square).sqrt());
    // h² (1 + b h / h₀) = h₀² has this root but for the third power of b.
    let b = (a3 + h) * h * per_a2;
    let h = h * (b * number(0.75) + A::ONE) / (b * number(1.25) + A::ONE);
    let h = h.with(outward * (stretch.outside - middle), A::min);
    let value = g + h * (a1 + h * (a2 + h * (a3 + h)));
    let slope = a1 + h * (a2 + a2 + h * (a3 * number(3.0) + h * number(4.0)));
    let second = a2 + h * (a3 * number(3.0) + h * number(6.0));
    let third = a3 + h * number(4.0);
    let (square, bend) = (slope * slope, value * second);
    let step = value * (square - bend) / (slope * (square - (bend + bend)) + value * value * third);
    middle + outward * (h - step)
}

/// Chebyshev's method on F from `start`, in brackets that only ever shrink: the last places looked at, and the roots.
#[inline]
fn settle<A: Real>(quartic: &Quartic<A>, stretch: &Stretch<A>, start: Pair<A>) -> (Places<A>, Pair<A>) {
    let mut brackets = stretch.inside.with(stretch.outside, |inside, outside| Bracket { inside, outside });
    let mut delta = brackets.with(start, Bracket::holds).choose(start, brackets.map(Bracket::middle));
    // So near to the surface F is nothing but rounding, and the next step the last that helps.
    let noise = A::UNIT_ROUNDOFF * (quartic.d.to_f64() + 1.0);
    // The third power of a relative error this small is below the last digit, for the slopes change over no shorter way
    // than that to a turning point or to the axis.
    let fourth_root = A::UNIT_ROUNDOFF.sqrt().sqrt();
    let short = fourth_root * fourth_root.sqrt();
    let mut steps = 0;
    loop {
        let places = Places::new(quartic, delta);
        brackets = brackets.with(delta.zip(places.value), |bracket, (delta, value)| bracket.narrowed(delta, value));
        let next = delta - places.step;
        let fits = brackets.with(next, Bracket::holds);
        let way = (delta - stretch.inside).with(delta - stretch.outside, |a, b| A::min(a.abs(), b.abs()));
        let way = way.with(places.radius, A::min);
        let is_short = places.step.with(way, |step, way| step.abs().to_f64() <= short * way.to_f64());
        let near = is_short.with(places.value, |is_short, value| is_short || value.abs().to_f64() <= noise);
        let kept = fits.choose(next, delta);
        steps += 1;
        if near == Pair([true; 2]) || steps == MOST_STEPS {
            return (places, kept);
        }
        delta = fits.with(near, |fits, near| fits || near).choose(kept, brackets.map(Bracket::middle));
    }
}

/// A place inside the solid and one outside, between which the surface is crossed.
#[derive(Clone, Copy)]
struct Bracket<A> {
    inside: A,
    outside: A,
}

impl<A: Real> Bracket<A> {
    #[inline]
    fn holds(self, x: A) -> bool {
        self.inside < x && x < self.outside || self.outside < x && x < self.inside
    }

    #[inline]
    fn middle(self) -> A {
        self.inside + A::from_f64(0.5) * (self.outside - self.inside)
    }

    #[inline]
    fn narrowed(self, x: A, value: A) -> Self {
        if value < A::ZERO { Self { inside: x, ..self } } else { Self { outside: x, ..self } }
    }
}
