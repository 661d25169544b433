//! Metals whose complex index of refraction is known.
//!
//! **Sources.** Silver, gold and copper: P. B. Johnson and R. W. Christy, Optical constants of the noble metals, Phys. Rev. B 6
//! (1972), 4370. Aluminium: A. D. Rakić, Algorithm for the determination of intrinsic optical constants of metal films,
//! Appl. Opt. 34 (1995), 4755. Between the entries of their tables the values are linear in the wavelength.

use glam::DVec3;

/// The complex index η + i k of a metal for light of 650, 550 and 450 nm, which stand for red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metal {
    /// η.
    pub eta: DVec3,
    /// k.
    pub k: DVec3,
}

impl Metal {
    /// Ag.
    pub const SILVER: Self = Self::new([0.0522, 0.0596, 0.0400], [4.409, 3.597, 2.648]);
    /// Au.
    pub const GOLD: Self = Self::new([0.1556, 0.4241, 1.3831], [3.602, 2.472, 1.916]);
    /// Cu.
    pub const COPPER: Self = Self::new([0.2378, 1.0066, 1.2404], [3.626, 2.582, 2.393]);
    /// Al.
    pub const ALUMINIUM: Self = Self::new([1.5580, 1.0152, 0.6332], [7.712, 6.627, 5.454]);

    const fn new(eta: [f64; 3], k: [f64; 3]) -> Self {
        Self { eta: DVec3::from_array(eta), k: DVec3::from_array(k) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::metal_reflectance;

    /// The entries of the tables on both sides of 650, 550 and 450 nm: λ in nm, η and k.
    type Neighbours = [[[f64; 3]; 2]; 3];

    const SILVER: Neighbours = [
        [[616.8, 0.06, 4.152], [659.5, 0.05, 4.483]],
        [[548.6, 0.06, 3.586], [582.1, 0.05, 3.858]],
        [[430.5, 0.04, 2.462], [450.9, 0.04, 2.657]],
    ];
    const GOLD: Neighbours = [
        [[616.8, 0.21, 3.272], [659.5, 0.14, 3.697]],
        [[548.6, 0.43, 2.455], [582.1, 0.29, 2.863]],
        [[430.5, 1.45, 1.948], [450.9, 1.38, 1.914]],
    ];
    const COPPER: Neighbours = [
        [[616.8, 0.30, 3.205], [659.5, 0.22, 3.747]],
        [[548.6, 1.02, 2.577], [582.1, 0.70, 2.704]],
        [[430.5, 1.25, 2.305], [450.9, 1.24, 2.397]],
    ];
    const ALUMINIUM: Neighbours = [
        [[619.93, 1.3660, 7.4052], [652.25, 1.5724, 7.7354]],
        [[516.60, 0.8734, 6.2418], [563.57, 1.0728, 6.7839]],
        [[442.80, 0.6079, 5.3676], [476.87, 0.7278, 5.7781]],
    ];

    #[test]
    fn each_index_lies_between_its_neighbours_in_the_published_table() {
        for (metal, table) in
            [(Metal::SILVER, SILVER), (Metal::GOLD, GOLD), (Metal::COPPER, COPPER), (Metal::ALUMINIUM, ALUMINIUM)]
        {
            for (channel, (nanometres, [low, high])) in [650.0, 550.0, 450.0].into_iter().zip(table).enumerate() {
                let along = (nanometres - low[0]) / (high[0] - low[0]);
                for (number, found) in [(1, metal.eta[channel]), (2, metal.k[channel])] {
                    let expected = low[number] + along * (high[number] - low[number]);
                    assert!((found - expected).abs() < 6e-4, "{nanometres} nm: {found} is not {expected}");
                }
            }
        }
    }

    #[test]
    fn head_on_the_metals_have_the_colours_that_people_know() {
        let mirrored = |metal: Metal| metal_reflectance([1.0, 0.0], 1.0, metal.eta, metal.k);
        assert!(mirrored(Metal::SILVER).min_element() > 0.97, "silver is the best mirror");
        let aluminium = mirrored(Metal::ALUMINIUM);
        assert!(aluminium.min_element() > 0.89 && aluminium.max_element() < 0.93);
        for metal in [Metal::GOLD, Metal::COPPER] {
            let DVec3 { x: red, y: green, z: blue } = mirrored(metal);
            assert!(red > 0.93 && red > green && green > blue && blue < 0.6, "{red}, {green}, {blue}");
        }
        // Gold is yellow: it mirrors green well. Copper is red.
        assert!(mirrored(Metal::GOLD).y > mirrored(Metal::COPPER).y + 0.1);
    }
}
