//! Reconstruction filters: how the samples about a pixel are weighted.
//!
//! Samples are not weighted by the filter but placed by it: as often as the filter is high. So they keep equal weights, and
//! each pixel has samples of its own that no other pixel uses. Where a filter dips below zero, the weight is −1.
//!
//! **Source** M. Ernst, M. Stamminger, G. Greiner, Filter Importance Sampling (IEEE Symposium on Interactive Ray Tracing,
//! 2006); D. Mitchell and A. Netravali, Reconstruction Filters in Computer Graphics (SIGGRAPH 1988), equation 8.

use crate::math::exp;
use std::sync::LazyLock;

/// How samples are weighted by their distance from the pixel's centre.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PixelFilter {
    /// All alike, over the pixel alone.
    #[default]
    Box,
    /// Less towards the centres of the neighbours, linearly.
    Tent,
    /// By a bell curve with a standard deviation of half a pixel, out to a pixel and a half.
    Gaussian,
    /// By the cubic of Mitchell and Netravali (1988, B = C = 1/3), out to two pixels.
    Mitchell,
}

impl PixelFilter {
    /// The word for it, as scene files spell it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Box => "box",
            Self::Tent => "tent",
            Self::Gaussian => "gaussian",
            Self::Mitchell => "mitchell",
        }
    }

    /// Where the sample for a point of the unit square lies, in pixels from the pixel's centre, and its weight: 1 or −1.
    #[must_use]
    pub fn place(self, [x, y]: [f64; 2]) -> ([f64; 2], f64) {
        let ((x, across), (y, down)) = (self.along(x), self.along(y));
        ([x, y], across * down)
    }

    /// The same along one axis.
    fn along(self, share: f64) -> (f64, f64) {
        match self {
            Self::Box => (share - 0.5, 1.0),
            Self::Tent if share < 0.5 => ((2.0 * share).sqrt() - 1.0, 1.0),
            Self::Tent => (1.0 - (2.0 - 2.0 * share).sqrt(), 1.0),
            Self::Gaussian => GAUSSIAN.invert(share),
            Self::Mitchell => MITCHELL.invert(share),
        }
    }
}

/// exp(−x² / (2 σ²)) with σ = 1/2, out to a pixel and a half.
static GAUSSIAN: LazyLock<Table> = LazyLock::new(|| Table::new(1.5, |x| exp(-2.0 * x * x)));

static MITCHELL: LazyLock<Table> = LazyLock::new(|| Table::new(2.0, mitchell));

/// The cubic with B = C = 1/3, for which its authors plead; 18 times as high.
fn mitchell(x: f64) -> f64 {
    let x = x.abs();
    if x < 1.0 { (21.0 * x - 36.0) * x * x + 16.0 } else { ((-7.0 * x + 36.0) * x - 60.0) * x + 32.0 }
}

/// Steps of a table. With fewer the moments of the filters would be off in the fifth digit; more take memory for nothing.
const STEPS: u32 = 4096;

/// The sums of a function's magnitude from −`reach` on, and its signs, step by step.
struct Table {
    reach: f64,
    sums: Vec<f64>,
    signs: Vec<f64>,
}

impl Table {
    fn new(reach: f64, f: impl Fn(f64) -> f64) -> Self {
        let width = 2.0 * reach / f64::from(STEPS);
        let (mut sums, mut signs) = (vec![0.0], Vec::new());
        let mut sum = 0.0;
        for step in 0..STEPS {
            let height = f((f64::from(step) + 0.5) * width - reach);
            sum += height.abs();
            sums.push(sum);
            signs.push(if height < 0.0 { -1.0 } else { 1.0 });
        }
        Self { reach, sums, signs }
    }

    /// The place up to which the magnitude adds up to `share` of the whole, and the sign there.
    fn invert(&self, share: f64) -> (f64, f64) {
        let wanted = share * self.sums[self.signs.len()];
        let end = self.sums.partition_point(|&sum| sum <= wanted).clamp(1, self.signs.len());
        let (low, high) = (self.sums[end - 1], self.sums[end]);
        let step = (end - 1) as f64 + (wanted - low) / (high - low);
        (2.0 * self.reach * step / f64::from(STEPS) - self.reach, self.signs[end - 1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The weighted mean of xᵏ over many places.
    fn moment(filter: PixelFilter, k: i32) -> f64 {
        const COUNT: u32 = 1 << 16;
        let places = || (0..COUNT).map(|n| filter.along((f64::from(n) + 0.5) / f64::from(COUNT)));
        let weights: f64 = places().map(|(_, weight)| weight).sum();
        places().map(|(x, weight)| weight * x.powi(k)).sum::<f64>() / weights
    }

    fn assert_moments(filter: PixelFilter, second: f64, fourth: f64) {
        for (k, exact) in [(1, 0.0), (2, second), (3, 0.0), (4, fourth)] {
            let mean = moment(filter, k);
            assert!((mean - exact).abs() < 2e-4, "{}, {k}: {mean} and not {exact}", filter.name());
        }
    }

    #[test]
    fn the_box_has_a_twelfth_of_a_square_pixel_for_its_second_moment() {
        assert_moments(PixelFilter::Box, 1.0 / 12.0, 1.0 / 80.0);
    }

    #[test]
    fn the_tent_has_a_sixth() {
        assert_moments(PixelFilter::Tent, 1.0 / 6.0, 1.0 / 15.0);
    }

    /// A normal curve cut off at three standard deviations: 1 − 2·3 φ(3)/P and 3 − 2·3 (3² + 3) φ(3)/P in units of σ² and σ⁴,
    /// with φ(3) = 0.004432 and P = 0.997300.
    #[test]
    fn the_bell_curve_has_its_standard_deviation_but_for_what_is_cut_off() {
        let cut = 6.0 * 0.004_431_848 / 0.997_300_204;
        assert_moments(PixelFilter::Gaussian, (1.0 - cut) / 4.0, (3.0 - 12.0 * cut) / 16.0);
    }

    /// Mitchell's filters with B + 2 C = 1 keep all quadratic polynomials but for B: ∫x² f = B/3, and ∫x⁴ f by parts of the
    /// cubic pieces: 2 ∫₀¹ x⁴ (21 x³ − 36 x² + 16)/18 + 2 ∫₁² x⁴ (−7 x³ + 36 x² − 60 x + 32)/18.
    #[test]
    fn the_cubic_has_the_moments_of_its_pieces() {
        let near = 21.0 / 8.0 - 36.0 / 7.0 + 16.0 / 5.0;
        let far = -7.0 * 255.0 / 8.0 + 36.0 * 127.0 / 7.0 - 60.0 * 63.0 / 6.0 + 32.0 * 31.0 / 5.0;
        assert_moments(PixelFilter::Mitchell, 1.0 / 9.0, (near + far) / 9.0);
    }

    #[test]
    fn only_the_cubic_dips_below_zero_and_there_alone() {
        for filter in [PixelFilter::Box, PixelFilter::Tent, PixelFilter::Gaussian, PixelFilter::Mitchell] {
            for n in 0..1000 {
                let (x, weight) = filter.along((f64::from(n) + 0.5) / 1000.0);
                let dips = filter == PixelFilter::Mitchell && mitchell(x) < -1e-2;
                assert!(!dips || weight == -1.0, "{} at {x}", filter.name());
                assert!(weight == 1.0 || filter == PixelFilter::Mitchell && x.abs() > 8.0 / 7.0 - 1e-3);
            }
        }
    }
}
