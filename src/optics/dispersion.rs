//! Glass that bends each wavelength by another angle.
//!
//! **Equations.** With x = λ² in µm²: Sellmeier n² = 1 + Σ Bᵢ x / (x − Cᵢ); Cauchy n = A + B / x + C / x².
//!
//! **Sources.** N-BK7 and N-SF11: Schott, optical glass data sheets (2017). Water at 20 °C: M. Daimon and A. Masumura,
//! Measurement of the refractive index of distilled water, Appl. Opt. 46 (2007), table 3. Diamond: F. Peter, Z. Phys. 15
//! (1923), 358.

use super::spectrum::{LONGEST, SHORTEST};
use crate::record::{Binding, Entry};

/// An index of refraction for each wavelength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dispersion {
    /// Sellmeier: n² = 1 + Σ Bᵢ λ² / (λ² − Cᵢ), λ in micrometres and C in their squares.
    Sellmeier {
        /// B₁ to B₄.
        b: [f64; 4],
        /// C₁ to C₄ in µm².
        c: [f64; 4],
    },
    /// Cauchy: n = A + B / λ² + C / λ⁴, λ in micrometres.
    Cauchy([f64; 3]),
}

impl Dispersion {
    /// Schott N-BK7, a crown glass: n_d = 1.5168, Abbe number 64.17.
    pub const BK7: Self = Self::Sellmeier {
        b: [1.039_612_12, 0.231_792_344, 1.010_469_45, 0.0],
        c: [0.006_000_698_67, 0.020_017_914_4, 103.560_653, 0.0],
    };
    /// Schott N-SF11, a dense flint glass: n_d = 1.78472, Abbe number 25.68.
    pub const SF11: Self = Self::Sellmeier {
        b: [1.737_596_95, 0.313_747_346, 1.898_781_01, 0.0],
        c: [0.013_188_707, 0.062_306_814_2, 155.236_29, 0.0],
    };
    /// Water at 20 °C, beside vacuum.
    pub const WATER: Self = Self::Sellmeier {
        b: [0.568_402_756_5, 0.172_617_739_1, 0.020_861_895_78, 0.113_074_868_8],
        c: [0.005_101_829_712, 0.018_211_539_36, 0.026_207_222_93, 10.697_927_21],
    };
    /// Diamond.
    pub const DIAMOND: Self =
        Self::Sellmeier { b: [0.3306, 4.3356, 0.0, 0.0], c: [0.175 * 0.175, 0.106 * 0.106, 0.0, 0.0] };

    /// The index at a wavelength in nanometres.
    #[must_use]
    pub fn index(&self, nanometres: f64) -> f64 {
        let squared = squared_micrometres(nanometres);
        match self {
            Self::Sellmeier { b, c } => {
                let terms = b.iter().zip(c).map(|(b, c)| b * squared / (squared - c));
                (1.0 + terms.sum::<f64>()).sqrt()
            }
            Self::Cauchy([a, b, c]) => a + b / squared + c / (squared * squared),
        }
    }

    /// A wavelength in nanometres, among those that are seen, at which no index follows that light could have: it is not
    /// a real number, or smaller than `least`.
    #[must_use]
    pub fn fails_at(&self, least: f64) -> Option<f64> {
        let all = (0..=400).map(|i| SHORTEST + f64::from(i) * (LONGEST - SHORTEST) / 400.0);
        // Between two wavelengths at which all is well, n² may still go through infinity.
        let poles = match self {
            Self::Sellmeier { b, c } => {
                b.iter().zip(c).filter(|(b, _)| **b != 0.0).map(|(_, c)| 1e3 * c.sqrt()).collect()
            }
            Self::Cauchy(_) => Vec::new(),
        };
        let at_pole = poles.into_iter().find(|pole| (SHORTEST..=LONGEST).contains(pole));
        at_pole.or_else(|| {
            all.into_iter().find(|&nanometres| {
                let index = self.index(nanometres);
                !(index.is_finite() && index >= least)
            })
        })
    }

    /// Adds the working of the index on one side of an interface, which is called `symbol`.
    #[must_use]
    pub fn working(&self, entry: Entry, symbol: &'static str, nanometres: f64) -> Entry {
        let squared = squared_micrometres(nanometres);
        let wavelength = [("λ", nanometres.into())];
        let entry = entry.line("x", "(λ / 1000)²", &wavelength, squared);
        let index = self.index(nanometres);
        let x: Binding = ("x", squared.into());
        match self {
            Self::Cauchy([a, b, c]) => {
                let bindings = [x, ("A", (*a).into()), ("B", (*b).into()), ("C", (*c).into())];
                entry.line(symbol, "A + B / x + C / x²", &bindings, index)
            }
            Self::Sellmeier { b, c } => {
                let names = [["B₁", "C₁"], ["B₂", "C₂"], ["B₃", "C₃"], ["B₄", "C₄"]];
                let terms = names.into_iter().zip(b.iter().zip(c));
                let own = terms.flat_map(|([name_b, name_c], (b, c))| [(name_b, (*b).into()), (name_c, (*c).into())]);
                let bindings: Vec<Binding> = std::iter::once(x).chain(own).collect();
                let formula = if b[3] != 0.0 {
                    "√(1 + B₁ x / (x − C₁) + B₂ x / (x − C₂) + B₃ x / (x − C₃) + B₄ x / (x − C₄))"
                } else if b[2] != 0.0 {
                    "√(1 + B₁ x / (x − C₁) + B₂ x / (x − C₂) + B₃ x / (x − C₃))"
                } else {
                    "√(1 + B₁ x / (x − C₁) + B₂ x / (x − C₂))"
                };
                entry.line(symbol, formula, &bindings, index)
            }
        }
    }
}

/// λ² in µm².
fn squared_micrometres(nanometres: f64) -> f64 {
    let micrometres = nanometres * 1e-3;
    micrometres * micrometres
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The Fraunhofer lines d, F and C in nanometres.
    const D_F_C: [f64; 3] = [587.5618, 486.1327, 656.2725];

    #[test]
    fn schotts_glasses_have_the_indices_and_abbe_numbers_of_their_data_sheets() {
        for (glass, n_d, abbe) in [(Dispersion::BK7, 1.5168, 64.17), (Dispersion::SF11, 1.78472, 25.68)] {
            let [d, f, c] = D_F_C.map(|line| glass.index(line));
            assert!((d - n_d).abs() < 5e-6, "n_d = {d}, not {n_d}");
            let number = (d - 1.0) / (f - c);
            assert!((number - abbe).abs() < 5e-3, "Abbe number {number}, not {abbe}");
        }
    }

    #[test]
    fn water_and_diamond_have_the_indices_of_the_handbooks() {
        // The handbooks tell the index of water beside air, Daimon and Masumura beside vacuum.
        let beside_vacuum = |(nanometres, beside_air): (f64, f64)| (nanometres, 1.000_273 * beside_air);
        for (medium, tolerance, known) in [
            (Dispersion::WATER, 3e-5, [(656.3, 1.33115), (589.3, 1.33299), (486.1, 1.33712)].map(beside_vacuum)),
            (Dispersion::DIAMOND, 7e-4, [(656.3, 2.4099), (589.3, 2.4175), (486.1, 2.4354)]),
        ] {
            for (nanometres, expected) in known {
                let index = medium.index(nanometres);
                assert!((index - expected).abs() < tolerance, "{index} at {nanometres} nm, not {expected}");
            }
        }
    }

    #[test]
    fn cauchys_formula_is_a_sum_of_even_powers() {
        // 1.5 + 0.004 / 0.25 + 0.0002 / 0.0625 at 500 nm.
        let glass = Dispersion::Cauchy([1.5, 0.004, 0.0002]);
        assert!((glass.index(500.0) - (1.5 + 0.016 + 0.0032)).abs() < 1e-15);
    }

    #[test]
    fn an_index_that_light_could_not_have_is_found_where_it_fails() {
        let least = 1e-3;
        assert_eq!(Dispersion::BK7.fails_at(least), None);
        assert_eq!(Dispersion::WATER.fails_at(least), None);
        // n = 1 − 0.2 / λ² falls below 0.001 where λ² < 0.2002…, at 447.4 nm.
        assert_eq!(Dispersion::Cauchy([1.0, -0.2, 0.0]).fails_at(least), Some(380.0));
        assert_eq!(Dispersion::Cauchy([-1.0, 0.5, 0.0]).fails_at(least), Some(707.0));
        // n² goes through infinity at 500 nm, although it is positive at 380.
        let pole = Dispersion::Sellmeier { b: [-0.01, 0.0, 0.0, 0.0], c: [0.25, 0.0, 0.0, 0.0] };
        assert_eq!(pole.fails_at(least), Some(500.0));
    }
}
