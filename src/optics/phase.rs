//! By which angle a medium turns light: the phase function of Henyey and Greenstein.
//!
//! p(cosθ) = (1 − g²) / (4π (1 + g² − 2 g cosθ)^(3/2)) per steradian, where θ lies between the way that light comes and the
//! way that it goes on, and g is the mean of cosθ.
//!
//! Source: L. C. Henyey, J. L. Greenstein, *Diffuse radiation in the galaxy*, Astrophysical Journal 93 (1941), equation 2.

use crate::math::sine_cosine;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// The phase function of a medium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HenyeyGreenstein {
    /// g, between −1 and 1: the mean cosine.
    pub anisotropy: f64,
}

impl HenyeyGreenstein {
    /// p per steradian; over all directions it integrates to 1.
    #[must_use]
    pub fn value(self, cosine: f64) -> f64 {
        let g = self.anisotropy;
        let squared = 1.0 + g * g - 2.0 * g * cosine;
        (1.0 - g * g) / (4.0 * PI * squared * squared.sqrt())
    }

    /// The cosine below which a share of all light is turned: the inverse of the distribution, for a share in [0, 1].
    ///
    /// The usual form, (1 + g² − ((1 − g²) / (1 + g x))²) / 2g with x = 2 share − 1, has 0 / 0 where g = 0. Multiplied out the
    /// numerator has a factor g, which is cancelled here.
    #[must_use]
    pub fn cosine(self, share: f64) -> f64 {
        let (g, x) = (self.anisotropy, 2.0 * share - 1.0);
        let numerator = 2.0 * x + g * (3.0 + x * x + g * (2.0 * x + g * (x * x - 1.0)));
        let root = 1.0 + g * x;
        (numerator / (2.0 * root * root)).clamp(-1.0, 1.0)
    }

    /// A unit direction, chosen as often as light is turned there from the unit direction `onward`, with its cosine.
    #[must_use]
    pub fn turned(self, onward: DVec3, [share, around]: [f64; 2]) -> (DVec3, f64) {
        let cosine = self.cosine(share);
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        let (across, up) = onward.any_orthonormal_pair();
        let (sine_around, cosine_around) = sine_cosine(TAU * around);
        let direction = onward * cosine + (across * cosine_around + up * sine_around) * sine;
        (direction.normalize(), cosine)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOME: [f64; 9] = [-0.95, -0.5, -1e-3, -1e-9, 0.0, 1e-12, 0.3, 0.76, 0.95];

    /// ∫ f dμ from −1 to 1 by Simpson's rule.
    fn integral(f: impl Fn(f64) -> f64) -> f64 {
        const STEPS: u32 = 200_000;
        let h = 2.0 / f64::from(STEPS);
        let weight = |i: u32| {
            if i == 0 || i == STEPS {
                1.0
            } else if i % 2 == 1 {
                4.0
            } else {
                2.0
            }
        };
        (0..=STEPS).map(|i| weight(i) * f(-1.0 + h * f64::from(i))).sum::<f64>() * h / 3.0
    }

    #[test]
    fn all_light_goes_somewhere_and_its_mean_cosine_is_g() {
        for g in SOME {
            let phase = HenyeyGreenstein { anisotropy: g };
            let all = TAU * integral(|cosine| phase.value(cosine));
            let mean = TAU * integral(|cosine| cosine * phase.value(cosine));
            assert!((all - 1.0).abs() < 1e-10 && (mean - g).abs() < 1e-10, "g = {g}: {all}, {mean}");
        }
    }

    /// The share of light that is turned to a cosine below this one, by hand: ∫ 2π p dμ from −1.
    fn share_below(g: f64, cosine: f64) -> f64 {
        if g.abs() < 1e-8 {
            // To first order in g: p = (1 + 3 g μ) / 4π.
            return 0.5 * (cosine + 1.0) + 0.75 * g * (cosine * cosine - 1.0);
        }
        (1.0 - g * g) / (2.0 * g) * (1.0 / (1.0 + g * g - 2.0 * g * cosine).sqrt() - 1.0 / (1.0 + g))
    }

    #[test]
    fn the_inverse_undoes_the_distribution() {
        for g in SOME {
            let phase = HenyeyGreenstein { anisotropy: g };
            for k in 0..=1000 {
                let share = f64::from(k) / 1000.0;
                let back = share_below(g, phase.cosine(share));
                // Rounding in the distribution itself grows as 1 / g where g is small.
                let bound = 1e-13 + 1e-15 / g.abs().max(1e-8);
                assert!((back - share).abs() < bound, "g = {g}: {share} came back as {back}");
            }
        }
    }

    #[test]
    fn without_preference_the_cosine_is_spread_evenly() {
        let phase = HenyeyGreenstein { anisotropy: 0.0 };
        assert_eq!([0.0, 0.25, 0.5, 1.0].map(|share| phase.cosine(share)), [-1.0, -0.5, 0.0, 1.0]);
        assert!((phase.value(0.3) - 0.25 / PI).abs() < 1e-17);
    }

    #[test]
    fn a_turned_direction_has_the_cosine_and_unit_length() {
        let onward = DVec3::new(0.48, -0.6, 0.64);
        for g in SOME {
            for k in 0..100 {
                let share = f64::from(k) / 100.0;
                let (direction, cosine) = HenyeyGreenstein { anisotropy: g }.turned(onward, [share, 0.37 * share]);
                assert!((direction.length() - 1.0).abs() < 1e-15);
                assert!((direction.dot(onward) - cosine).abs() < 1e-15, "g = {g}, share {share}");
            }
        }
    }
}
