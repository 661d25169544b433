//! Random numbers that are the same on every machine and any number of threads.
//!
//! Source: G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014 (SplitMix64).

use crate::math::portable;
use glam::DVec3;

/// A generator that is told by a seed alone.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The generator of stream `stream` of a seed; streams are independent, whoever asks first.
    #[must_use]
    pub fn new(seed: u64, stream: u64) -> Self {
        let mut random = Self(seed ^ stream.wrapping_mul(0xd134_2543_de82_ef95));
        random.bits();
        Self(random.bits() ^ stream)
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number from 0 to 1, without 1.
    pub fn share(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * portable::power_of_two(-53)
    }

    /// A number between two others.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }

    /// One of `count` things, counted from 0.
    pub fn index(&mut self, count: usize) -> usize {
        usize::try_from(self.bits() % count.max(1) as u64).unwrap_or(0)
    }

    /// A direction, all being as likely.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let v = DVec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0));
            if (1e-2..=1.0).contains(&v.length_squared()) {
                return v.normalize();
            }
        }
    }

    /// A point in a box.
    pub fn within(&mut self, low: DVec3, high: DVec3) -> DVec3 {
        DVec3::new(self.between(low.x, high.x), self.between(low.y, high.y), self.between(low.z, high.z))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_repeat_and_differ() {
        let first = |stream| Random::new(7, stream).bits();
        assert_eq!(first(3), first(3));
        let all: std::collections::BTreeSet<u64> = (0..1_000).map(first).collect();
        assert_eq!(all.len(), 1_000);
    }

    #[test]
    fn shares_fill_the_range_evenly() {
        let mut random = Random::new(1, 0);
        let mut counts = [0_i32; 10];
        for _ in 0..100_000 {
            let share = random.share();
            counts[(1..10_u8).filter(|k| share >= f64::from(*k) / 10.0).count()] += 1;
        }
        // Four standard deviations of a binomial count.
        assert!(counts.iter().all(|count| (count - 10_000).abs() < 380), "{counts:?}");
    }

    #[test]
    fn directions_are_unit_and_favour_no_side() {
        let mut random = Random::new(2, 0);
        let sum: DVec3 =
            (0..10_000).map(|_| random.direction()).inspect(|v| assert!((v.length() - 1.0).abs() < 1e-15)).sum();
        assert!(sum.length() < 400.0, "{sum}");
    }
}
