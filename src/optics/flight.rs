//! How far light comes in a medium before it is turned, by chance.
//!
//! The three colours may be turned after different ways. One number then chooses a colour and a distance that suits it,
//! and the result counts by the mean of the three densities (the balance heuristic). A colour is chosen in proportion to
//! what the path still counts in it: so the sum of what it counts in all three never grows, however often it is turned.
//!
//! Source: E. Veach, *Robust Monte Carlo methods for light transport simulation*, thesis, Stanford 1997, § 9.2.2; for media A. Wilkie
//! and others, *Hero wavelength spectral sampling*, Computer Graphics Forum 33 (2014).

use super::Medium;
use crate::math::{exp, ln};
use glam::DVec3;

/// A place where light is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flight {
    /// How far it is, in the world's units.
    pub distance: f64,
    /// The probability density of that distance, per unit of length: the mean of those of the colours.
    pub density: f64,
    /// The densities by colour.
    pub densities: DVec3,
    /// The probabilities with which the colours are chosen.
    pub odds: DVec3,
    /// σ_s exp(−σ_t distance) / density.
    pub weight: DVec3,
    /// The colour that chose the distance: 0, 1 or 2.
    pub colour: usize,
    /// The number in [0, 1) that was left for the distance once the colour was chosen.
    pub share: f64,
}

/// What a path in a medium meets first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Walk {
    /// The end of the way; with what counts what lies there.
    Through(DVec3),
    /// A place where it is turned.
    Turned(Flight),
}

impl Medium {
    /// A place on a way of this length (which may have no end) where light is turned, for a number in [0, 1). The density is that of
    /// the exponential distribution, cut off where the way ends. `tint` is what the path counts by colour, up to a factor.
    #[must_use]
    pub fn turned_within(&self, length: f64, tint: DVec3, chance: f64) -> Flight {
        let rates = self.extinction();
        // On a way without end there is no even spread for a colour that is never turned.
        let has_density = rates.map(|rate| f64::from(rate > 0.0 || length.is_finite()));
        let odds = odds(rates, tint * has_density, has_density);
        let (colour, share) = chosen(odds, chance);
        let all = |rate: f64| one_less_exp(rate * length);
        let rate = rates[colour];
        let distance = if rate == 0.0 { share * length } else { (-log_one_less(share * all(rate)) / rate).min(length) };
        let densities = rates.map(|rate| match rate == 0.0 {
            true if length.is_finite() => 1.0 / length,
            true => 0.0,
            false => rate * exp(-rate * distance) / all(rate),
        });
        self.flight(distance, densities, odds, (colour, share))
    }

    /// Whether a path goes all of its way of this length or is turned before, and where, for a number in [0, 1).
    #[must_use]
    pub fn walk(&self, length: f64, tint: DVec3, chance: f64) -> Walk {
        let rates = self.extinction();
        let odds = odds(rates, tint, DVec3::ONE);
        let (colour, share) = chosen(odds, chance);
        let rate = rates[colour];
        let distance = if rate == 0.0 { f64::INFINITY } else { -log_one_less(share) / rate };
        if distance >= length {
            let left = self.transmittance(length);
            return Walk::Through(left / odds.dot(left));
        }
        let densities = rates.map(|rate| rate * exp(-rate * distance));
        Walk::Turned(self.flight(distance, densities, odds, (colour, share)))
    }

    fn flight(&self, distance: f64, densities: DVec3, odds: DVec3, (colour, share): (usize, f64)) -> Flight {
        let density = odds.dot(densities);
        let weight = self.scattering * self.transmittance(distance) / density;
        Flight { distance, density, densities, odds, weight, colour, share }
    }
}

/// The probabilities of the colours: in proportion to `wanted`, or to `possible` where nothing is wanted. Where all rates are alike
/// there is nothing to choose.
fn odds(rates: DVec3, wanted: DVec3, possible: DVec3) -> DVec3 {
    if rates == DVec3::splat(rates.x) {
        return DVec3::X;
    }
    let sum = wanted.element_sum();
    if sum > 0.0 && sum.is_finite() { wanted / sum } else { possible / possible.element_sum() }
}

/// The colour that a number in [0, 1) falls to, and what is left of the number for the distance.
fn chosen(odds: DVec3, chance: f64) -> (usize, f64) {
    /// The largest number below 1.
    const ALMOST_ONE: f64 = 1.0 - 0.5 * f64::EPSILON;
    let mut below = 0.0;
    let mut last = (0, chance);
    for colour in (0..3).filter(|&colour| odds[colour] > 0.0) {
        last = (colour, ((chance - below) / odds[colour]).clamp(0.0, ALMOST_ONE));
        below += odds[colour];
        if chance < below {
            break;
        }
    }
    last
}

/// Below this the differences are worked out by their series: the next terms are smaller than a rounding.
const SMALL: f64 = 1e-4;

/// 1 − e⁻ˣ for x ≥ 0, with all its digits where x is small.
#[must_use]
pub fn one_less_exp(x: f64) -> f64 {
    if x < SMALL { x * (1.0 - x / 2.0 * (1.0 - x / 3.0 * (1.0 - x / 4.0))) } else { 1.0 - exp(-x) }
}

/// ln(1 − y) for 0 ≤ y < 1, with all its digits where y is small.
fn log_one_less(y: f64) -> f64 {
    if y < SMALL { -y * (1.0 + y * (1.0 / 2.0 + y * (1.0 / 3.0 + y / 4.0))) } else { ln(1.0 - y) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn medium(absorption: [f64; 3], scattering: [f64; 3]) -> Medium {
        let (absorption, scattering) = (absorption.into(), scattering.into());
        Medium { absorption, scattering, anisotropy: 0.0, multiple: true }
    }

    const GREY: [f64; 3] = [0.25; 3];
    const COLOURED: [f64; 3] = [0.0, 0.5, 4.0];
    /// What the path counted before.
    const TINT: DVec3 = DVec3::new(0.5, 1.0, 0.25);
    const EVEN: u32 = 40_000;

    /// The mean of f over evenly spread numbers.
    fn over_all(f: impl Fn(f64) -> DVec3) -> DVec3 {
        (0..EVEN).map(|k| f((f64::from(k) + 0.5) / f64::from(EVEN))).sum::<DVec3>() / f64::from(EVEN)
    }

    #[test]
    fn places_on_a_way_count_all_the_light_that_is_turned_on_it() {
        // ∫ σ_s exp(−σ_t s) ds = σ_s / σ_t (1 − exp(−σ_t length)).
        for (absorption, scattering) in [(GREY, GREY), (COLOURED, GREY), ([0.0; 3], COLOURED), (GREY, COLOURED)] {
            for length in [1e-9, 0.01, 1.0, 30.0, f64::INFINITY] {
                let fog = medium(absorption, scattering);
                let found = over_all(|chance| fog.turned_within(length, TINT, chance).weight);
                let turned = |rate: f64| if rate == 0.0 { 0.0 } else { -(-rate * length).exp_m1() / rate };
                let expected = fog.scattering * fog.extinction().map(turned);
                let off = (found - expected).abs();
                let bound = expected * 2e-3 + 1e-300;
                assert!(off.cmple(bound).all(), "{absorption:?} {scattering:?} {length}: {found}, not {expected}");
            }
        }
    }

    #[test]
    fn a_path_is_turned_and_goes_through_as_often_as_the_law_says() {
        for (absorption, scattering) in [(GREY, GREY), (COLOURED, GREY), ([0.0; 3], COLOURED)] {
            for length in [0.01, 1.0, 30.0] {
                let fog = medium(absorption, scattering);
                let through = over_all(|chance| match fog.walk(length, TINT, chance) {
                    Walk::Through(weight) => weight,
                    Walk::Turned(_) => DVec3::ZERO,
                });
                let turned = over_all(|chance| match fog.walk(length, TINT, chance) {
                    Walk::Through(_) => DVec3::ZERO,
                    Walk::Turned(flight) => flight.weight,
                });
                let left = fog.transmittance(length);
                let albedo = fog.scattering / fog.extinction().max(DVec3::splat(1e-300));
                assert!((through - left).abs().max_element() < 2e-3, "{length}: {through}, not {left}");
                let expected = albedo * (DVec3::ONE - left);
                assert!((turned - expected).abs().max_element() < 2e-3, "{length}: {turned}, not {expected}");
            }
        }
    }

    #[test]
    fn where_all_colours_are_alike_a_path_is_weighed_by_nothing_but_what_is_absorbed() {
        let fog = medium([0.0; 3], [0.7; 3]);
        for k in 0..100 {
            let weight = match fog.walk(2.0, TINT, f64::from(k) / 100.0) {
                Walk::Through(weight) => weight,
                Walk::Turned(flight) => flight.weight,
            };
            assert!((weight - DVec3::ONE).abs().max_element() < 1e-15, "{weight}");
        }
    }

    #[test]
    fn what_a_path_counts_in_all_colours_together_never_grows() {
        let fog = medium([0.0; 3], COLOURED);
        for k in 0..1000 {
            let weight = match fog.walk(1.5, TINT, f64::from(k) / 1000.0) {
                Walk::Through(weight) => weight,
                Walk::Turned(flight) => flight.weight,
            };
            assert!((TINT * weight).element_sum() <= TINT.element_sum() * (1.0 + 1e-12), "{weight}");
        }
    }

    proptest! {
        #[test]
        fn small_differences_keep_their_digits(power in -30.0..1.0_f64) {
            let x = 10_f64.powf(power);
            prop_assert!((one_less_exp(x) + (-x).exp_m1()).abs() <= 1e-11 * x);
            let y = x.min(0.999);
            prop_assert!((log_one_less(y) - (-y).ln_1p()).abs() <= 1e-11 * y.max((-y).ln_1p().abs()));
        }
    }
}
