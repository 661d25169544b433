//! A price: the difference of two times that were measured in turn.

use serde::{Deserialize, Serialize};
use std::time::Duration;

/// What something costs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Price {
    /// Nanoseconds per pixel more than without it; less than 0 where it saves time.
    pub ns_per_pixel: f64,
    /// Half the distance between the quartiles of what was measured, in nanoseconds per pixel.
    pub spread: f64,
    /// The share of the whole picture's time.
    pub share: f64,
}

impl Price {
    /// From pairs of times with and without something, for so many pixels.
    #[must_use]
    pub fn of(pairs: &[[Duration; 2]], pixels: usize) -> Self {
        let per_pixel = |time: Duration| time.as_secs_f64() * 1e9 / pixels.max(1) as f64;
        let differences: Vec<f64> =
            pairs.iter().map(|[with, without]| per_pixel(*with) - per_pixel(*without)).collect();
        let whole = quantile(pairs.iter().map(|[with, _]| per_pixel(*with)).collect(), 0.5);
        let ns_per_pixel = quantile(differences.clone(), 0.5);
        let spread = 0.5 * (quantile(differences.clone(), 0.75) - quantile(differences, 0.25));
        Self { ns_per_pixel, spread, share: if whole > 0.0 { ns_per_pixel / whole } else { 0.0 } }
    }

    /// Whether it can be told from nothing.
    #[must_use]
    pub fn is_clear(&self) -> bool {
        self.ns_per_pixel.abs() > self.spread
    }
}

/// The value below which a share of all values lies, between two of them by their distances; 0 for none.
#[must_use]
pub fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let Some(last) = values.len().checked_sub(1) else { return 0.0 };
    let at = share * last as f64;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and the last index")]
    let below = at.floor() as usize;
    let above = (below + 1).min(last);
    values[below] + (values[above] - values[below]) * (at - at.floor())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_price_is_the_median_difference_and_its_share_of_the_whole() {
        let nanoseconds = |with, without| [Duration::from_nanos(with), Duration::from_nanos(without)];
        let pairs = [nanoseconds(1000, 700), nanoseconds(1100, 700), nanoseconds(9000, 700)];
        let price = Price::of(&pairs, 10);
        assert!((price.ns_per_pixel - 40.0).abs() < 1e-9, "{price:?}");
        assert!((price.share - 400.0 / 1100.0).abs() < 1e-12, "{price:?}");
        assert!((price.spread - 0.5 * (435.0 - 35.0)).abs() < 1e-9 && !price.is_clear(), "{price:?}");
    }

    #[test]
    fn quantiles_lie_between_values_by_their_distances() {
        assert_eq!(quantile(vec![3.0, 1.0, 2.0], 0.5), 2.0);
        assert_eq!(quantile(vec![1.0, 2.0], 0.25), 1.25);
        assert_eq!(quantile(Vec::new(), 0.5), 0.0);
    }
}
