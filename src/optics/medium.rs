//! A homogeneous medium that absorbs light and turns it.

use crate::math::exp;
use glam::DVec3;

/// What a medium does to light on its way, by colour and unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// σ_a: the share that is absorbed.
    pub absorption: DVec3,
    /// σ_s: the share that is turned into other directions.
    pub scattering: DVec3,
    /// g of Henyey and Greenstein: the mean cosine of the angle by which light is turned.
    pub anisotropy: f64,
    /// Whether light that was turned once may be turned again.
    pub multiple: bool,
}

impl Medium {
    /// σ_t = σ_a + σ_s: all that is taken from the light, in 1 / unit of length.
    #[must_use]
    pub fn extinction(&self) -> DVec3 {
        self.absorption + self.scattering
    }

    /// exp(−σ_t length): what is left after a way that may have no end (Bouguer 1729, Lambert 1760, Beer 1852).
    #[must_use]
    pub fn transmittance(&self, length: f64) -> DVec3 {
        // Where nothing is taken the length does not matter, not even one without end.
        self.extinction().map(|rate| if rate == 0.0 { 1.0 } else { exp(-rate * length) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RED_GLASS: Medium = Medium {
        absorption: DVec3::new(0.0, 0.5, 2.0),
        scattering: DVec3::new(0.0, 0.25, 0.0),
        anisotropy: 0.0,
        multiple: false,
    };

    #[test]
    fn what_is_left_falls_by_the_same_factor_on_each_unit_of_length() {
        let [one, three] = [1.0, 3.0].map(|length| RED_GLASS.transmittance(length));
        assert!((one * one * one - three).abs().max_element() < 1e-15, "{one} {three}");
        assert_eq!(RED_GLASS.transmittance(0.0), DVec3::ONE);
    }

    #[test]
    fn a_way_without_end_leaves_only_the_colours_that_are_not_touched() {
        assert_eq!(RED_GLASS.transmittance(f64::INFINITY), DVec3::new(1.0, 0.0, 0.0));
    }
}
