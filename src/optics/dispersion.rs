//! Glass that bends each wavelength by another angle.

/// An index of refraction for each wavelength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dispersion {
    /// Sellmeier: n² = 1 + Σ Bᵢ λ² / (λ² − Cᵢ), λ in micrometres and C in their squares.
    Sellmeier {
        /// B₁ to B₃.
        b: [f64; 3],
        /// C₁ to C₃ in µm².
        c: [f64; 3],
    },
    /// Cauchy: n = A + B / λ² + C / λ⁴, λ in micrometres.
    Cauchy([f64; 3]),
}

impl Dispersion {
    /// The index at a wavelength in nanometres.
    #[must_use]
    pub fn index(&self, nanometres: f64) -> f64 {
        let squared = (nanometres * 1e-3).powi(2);
        match self {
            Self::Sellmeier { b, c } => {
                let terms = b.iter().zip(c).map(|(b, c)| b * squared / (squared - c));
                (1.0 + terms.sum::<f64>()).sqrt()
            }
            Self::Cauchy([a, b, c]) => a + b / squared + c / (squared * squared),
        }
    }
}
