//! The gauge of a superellipsoid along a ray: where the ray can be inside at all, and g with its slope at any place on it.
//!
//! Places are measured from the foot of the perpendicular, as δ. A coordinate is c (δ − δ₀) with δ₀ where it is zero, which
//! keeps the digits of small ones.

use super::GenericRay;
use super::boundary::Root;
use super::gauge::{Bend, Exponents, Level};
use crate::math::{Real, exp, portable};

/// The ray in one coordinate: c (δ − zero) + resting.
#[derive(Clone, Copy)]
struct Axis<A> {
    speed: A,
    zero: A,
    resting: A,
    moves: bool,
    /// How far off rounding may put the coordinate, in δ where it moves, as a share of the coordinate where it does not.
    haze: f64,
}

/// The ray about its foot, and the solid that it is to meet.
pub(super) struct Line<'a, A> {
    /// n and m.
    pub exponents: &'a Exponents,
    ray: &'a GenericRay<'a, A>,
    /// τ at the foot.
    pub foot: A,
    axes: [Axis<A>; 3],
    /// What the rounding of coordinates that rest at zero can do to ln g.
    dimness: f64,
}

/// ln g at one place of the ray.
#[derive(Clone, Copy, Debug)]
pub(super) struct Probe<A> {
    /// δ.
    pub at: A,
    /// F, which has the sign of g − 1.
    pub excess: f64,
    /// ln g.
    pub log: f64,
    /// (ln g)′.
    pub slope: f64,
    /// (ln g)″.
    pub bend: f64,
    /// The shares of the coordinates in g, and in its slope.
    shares: [f64; 3],
    along: [f64; 3],
}

/// Bounds on the errors of a probe.
#[derive(Clone, Copy, Debug)]
pub(super) struct Doubt {
    /// Of ln g.
    pub log: f64,
    /// Of (ln g)′.
    pub slope: f64,
}

impl<A> Probe<A> {
    /// 1 − 1/g, rather too near to zero than too far from it.
    ///
    /// x / (1 − e⁻ˣ) = x/2 + x/2 coth x/2 ≤ 1 + x/2 + x²/12, and near zero little less.
    #[inline]
    fn shortfall(&self) -> f64 {
        let x = self.log;
        if x.abs() < 0.3 { x / (1.0 + x * (0.5 + x * (1.0 / 12.0))) } else { 1.0 - exp(-x) }
    }

    /// How far from here the tangent of g gets to 1, in the direction in which it does. Where g is convex and above 1, or
    /// concave and below, it has no root before.
    #[inline]
    pub fn reach(&self, doubt: Doubt) -> f64 {
        let surely = (self.shortfall().abs() - 2.0 * doubt.log).max(0.0);
        surely / (self.slope.abs() + doubt.slope)
    }

    /// From here to where g is 1, rising or falling, if g² were a parabola: exact for spheres and for flat faces.
    #[inline]
    pub fn step(&self, rising: bool) -> f64 {
        let w = self.shortfall();
        // (g²)″ h² / 2 + (g²)′ h + g² = 1, divided by g².
        let (a, b, c) = (self.bend + 2.0 * self.slope * self.slope, self.slope, w * (2.0 - w));
        let root = (b * b - a * c).sqrt();
        let root = if rising { root } else { -root };
        if (b > 0.0) == rising { -c / (b + root) } else { (root - b) / a }
    }

    /// From here to where g would be least, or largest, if it were as it bends here.
    pub fn to_extreme(&self, bend: Bend) -> f64 {
        let square = self.slope * self.slope;
        if bend == Bend::Convex { -self.slope / (self.bend + 2.0 * square) } else { -self.slope / (self.bend + square) }
    }
}

impl<'a, A: Real> Line<'a, A> {
    #[inline]
    pub fn new(exponents: &'a Exponents, ray: &'a GenericRay<'a, A>) -> Self {
        let c = ray.direction;
        let foot = -(ray.origin[0] * c[0] + ray.origin[1] * c[1] + ray.origin[2] * c[2])
            / (c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
        let nearest = ray.at(foot);
        let sway = ray.sway(foot.to_f64().abs() + 2.0);
        let mut dimness = 0.0;
        let axes = std::array::from_fn(|i| {
            let zero = -nearest[i] / c[i];
            let blur = 4.0 * A::UNIT_ROUNDOFF * sway[i];
            if zero.is_finite() {
                let haze = blur / c[i].abs().to_f64();
                return Axis { speed: c[i], zero, resting: A::ZERO, moves: true, haze };
            }
            let resting = nearest[i];
            let size = resting.abs().to_f64();
            if size <= blur && blur > 0.0 {
                let exponent = exponents.of_axis(i);
                dimness += portable::powf(blur, exponent) / exponent;
            }
            let haze = if size > 0.0 { blur / size } else { 0.0 };
            Axis { speed: A::ZERO, zero: A::ZERO, resting, moves: false, haze }
        });
        Self { exponents, ray, foot, axes, dimness }
    }

    /// The coordinates at the foot.
    fn nearest(&self) -> [f64; 3] {
        self.axes.map(|axis| if axis.moves { -(axis.speed * axis.zero).to_f64() } else { axis.resting.to_f64() })
    }

    /// Where the ray is within the polyhedron that holds the solid; at its ends and beyond g is above 1.
    ///
    /// For all exponents g ≥ max(ρ, |z|) and ρ ≥ max(|x|, |y|), for n ≤ 1 ρ ≥ |x| + |y|, and for m ≤ 1 g ≥ ρ + |z|.
    #[inline]
    pub fn clip(&self) -> Option<[f64; 2]> {
        let (s, c) = (self.nearest(), self.axes.map(|axis| axis.speed.to_f64()));
        let sway = self.ray.sway(self.foot.to_f64().abs() + 2.0);
        let slack = 1.0 + f64::UNIT_ROUNDOFF * (64.0 + 16.0 * (sway[0] + sway[1] + sway[2]));
        let mut range = [f64::NEG_INFINITY, f64::INFINITY];
        let [x, y, z] = [0, 1, 2].map(|i| [s[i], c[i]]);
        let sum = |a: [f64; 2], b: [f64; 2]| [a[0] + b[0], a[1] + b[1]];
        let difference = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
        let across = if self.exponents.n < 1.0 { [sum(x, y), difference(x, y)] } else { [x, y] };
        for slab in across {
            if self.exponents.m < 1.0 {
                within(&mut range, sum(slab, z), slack);
                within(&mut range, difference(slab, z), slack);
            } else {
                within(&mut range, slab, slack);
            }
        }
        if self.exponents.m >= 1.0 {
            within(&mut range, z, slack);
        }
        (range[0] < range[1]).then_some(range)
    }

    /// Where the ray crosses coordinate planes between the ends of the range, ascending, with the axis.
    pub fn cuts(&self, [from, to]: [f64; 2], axes: &[usize]) -> ([(A, usize); 3], usize) {
        let (mut cuts, mut count) = ([(A::ZERO, 0); 3], 0);
        for &i in axes {
            let zero = self.axes[i].zero;
            if !self.axes[i].moves || zero.to_f64() <= from || zero.to_f64() >= to {
                continue;
            }
            let mut place = count;
            while place > 0 && zero < cuts[place - 1].0 {
                cuts[place] = cuts[place - 1];
                place -= 1;
            }
            cuts[place] = (zero, i);
            count += 1;
        }
        (cuts, count)
    }

    /// |x|, |y|, |z| at δ, and the share of itself by which each grows with δ.
    #[inline]
    pub fn place(&self, at: A) -> ([A; 3], [f64; 3]) {
        let gaps = self.axes.map(|axis| at - axis.zero);
        let place = std::array::from_fn(|i| (self.axes[i].speed * gaps[i] + self.axes[i].resting).abs());
        let rates = std::array::from_fn(|i| {
            let gap = gaps[i].to_f64();
            if self.axes[i].moves && gap != 0.0 { 1.0 / gap } else { 0.0 }
        });
        (place, rates)
    }

    /// ln g at δ.
    #[inline]
    pub fn probe(&self, at: A) -> Probe<A> {
        let (place, rates) = self.place(at);
        let level = self.exponents.level(place);
        self.measured(at, level, rates)
    }

    /// Bounds on the errors of a probe.
    #[inline]
    pub fn doubt(&self, probe: &Probe<A>) -> Doubt {
        let roundings = self.exponents.roundings();
        let log = A::UNIT_ROUNDOFF * roundings + self.blurred(probe.along, probe.shares);
        // Its terms have a few roundings more than ln g, and they are worked out in f64 at best.
        let size = probe.along[0].abs() + probe.along[1].abs() + probe.along[2].abs();
        Doubt { log, slope: size * f64::UNIT_ROUNDOFF.max(A::UNIT_ROUNDOFF) * (32.0 + 4.0 * roundings) }
    }

    /// The same for ln g where the ray crosses the plane in which a coordinate is zero.
    pub fn doubt_in_plane(&self, probe: &Probe<A>, axis: usize) -> f64 {
        self.doubt(probe).log + self.drift(axis) * probe.slope.abs()
    }

    /// How far off, in δ, the crossing of a coordinate plane is.
    pub fn drift(&self, axis: usize) -> f64 {
        self.axes[axis].haze
    }

    /// What a function is off by for the rounding of the coordinates, given how each moves it along the ray, and how much
    /// it would grow with the coordinate's logarithm.
    #[inline]
    pub fn blurred(&self, along: [f64; 3], by_log: [f64; 3]) -> f64 {
        let haze = |i: usize| {
            let axis = &self.axes[i];
            axis.haze * if axis.moves { along[i].abs() } else { by_log[i] }
        };
        self.dimness + haze(0) + haze(1) + haze(2)
    }

    /// How far off, as a share of itself, a coordinate may be and the slope of its power below 1, given the rate at which it
    /// grows.
    pub fn coarseness(&self, axis: usize, rate: f64) -> f64 {
        let Axis { haze, moves, .. } = self.axes[axis];
        let off = if moves { haze * rate.abs() } else { haze };
        // In its plane, or so near that it may be there, the slope has no bound.
        let in_plane = moves && rate == 0.0 || off >= 0.25;
        if in_plane { f64::INFINITY } else { 4.0 * (self.dimness + f64::UNIT_ROUNDOFF + off) }
    }

    /// ln g at τ, from coordinates with no error but their last rounding.
    #[inline]
    pub fn probe_exactly(&self, tau: A) -> (Probe<A>, [f64; 3]) {
        let (s, c) = (self.ray.origin, self.ray.direction);
        let place: [A; 3] = std::array::from_fn(|i| A::difference_of_products(A::ONE, s[i], -c[i], tau));
        let inverse: [f64; 3] = place.map(|x| if x == A::ZERO { 0.0 } else { 1.0 / x.to_f64() });
        let level = self.exponents.level(place.map(Real::abs));
        let rates = std::array::from_fn(|i| inverse[i] * c[i].to_f64());
        let gradient = std::array::from_fn(|i| inverse[i] * level.shares[i]);
        (self.measured(tau - self.foot, level, rates), gradient)
    }

    /// The first and second derivative of ln g by the shares of the coordinates in it.
    #[inline]
    fn measured(&self, at: A, level: Level<A>, rates: [f64; 3]) -> Probe<A> {
        let Exponents { n, m, .. } = *self.exponents;
        let excess = level.excess.to_f64();
        let [x, y, z] = level.shares;
        let [first, second, third] = [x * rates[0], y * rates[1], z * rates[2]];
        let across = first + second;
        let slope = across + third;
        let mixing = if n == m || x + y == 0.0 { 0.0 } else { (m - n) * across * across / (x + y) };
        let bend = mixing + (n - 1.0) * (first * rates[0] + second * rates[1]) + (m - 1.0) * third * rates[2]
            - m * slope * slope;
        Probe { at, excess, log: level.log, slope, bend, shares: level.shares, along: [first, second, third] }
    }

    /// How far ln g at δ moves when the ray's own numbers move by half a unit in their last places.
    pub fn input_doubt(&self, at: A) -> f64 {
        let Probe { along, shares, .. } = self.probe(at);
        // The haze of a coordinate is four roundings of what it was added up from.
        self.blurred(along, shares) * f64::UNIT_ROUNDOFF / (4.0 * A::UNIT_ROUNDOFF)
    }

    /// A root in a coordinate plane.
    pub fn root_in_plane(&self, at: A) -> Root {
        let tau = (self.foot + at).to_f64();
        let drift = self.axes.iter().filter(|axis| axis.moves).fold(0.0_f64, |most, axis| most.max(axis.haze));
        let error = drift * f64::UNIT_ROUNDOFF / A::UNIT_ROUNDOFF + f64::EPSILON * tau.abs();
        Root { tau, error, part: 0 }
    }

    /// A root, with the bound on its error; `probe` is next to it.
    pub fn root(&self, tau: A, probe: &Probe<A>, gradient: [f64; 3]) -> Root {
        let tau = tau.to_f64();
        let own = 2.0 * A::UNIT_ROUNDOFF * self.exponents.roundings() / probe.slope.abs();
        Root { tau, error: self.ray.error_for_slope(gradient, probe.slope, tau) + own, part: 0 }
    }
}

/// Cuts a range down to where |value + slope δ| ≤ slack; to nothing where that is never.
#[inline]
fn within(range: &mut [f64; 2], [value, slope]: [f64; 2], slack: f64) {
    let per_slope = 1.0 / slope;
    if per_slope.is_finite() {
        let (middle, half) = (-value * per_slope, slack * per_slope.abs());
        *range = [range[0].max(middle - half), range[1].min(middle + half)];
    } else if value.abs() > slack || value.is_nan() {
        *range = [0.0, 0.0];
    }
}
