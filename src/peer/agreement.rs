//! How far two pictures of the same scene agree.

/// How far two pictures agree, channel by channel in sRGB bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// The share of pixels none of whose channels differ by more than [`Self::CLOSE`].
    pub share: f64,
    /// The largest difference of a channel.
    pub worst: u8,
}

impl Agreement {
    /// What two ways of rounding the same colour can differ by, with one to spare.
    pub const CLOSE: u8 = 2;

    /// Compares two pictures of three bytes a pixel; none where their sizes differ or they have no pixels.
    #[must_use]
    pub fn of(one: &[u8], other: &[u8]) -> Option<Self> {
        if one.len() != other.len() || one.is_empty() || !one.len().is_multiple_of(3) {
            return None;
        }
        let worst_of = |(a, b): (&[u8], &[u8])| a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0);
        let differences: Vec<u8> = one.chunks_exact(3).zip(other.chunks_exact(3)).map(worst_of).collect();
        let close = differences.iter().filter(|difference| **difference <= Self::CLOSE).count();
        let worst = differences.iter().copied().max().unwrap_or(0);
        Some(Self { share: close as f64 / differences.len() as f64, worst })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_agrees_if_all_of_its_channels_do() {
        let agreement = Agreement::of(&[0, 0, 0, 10, 10, 10], &[2, 0, 1, 10, 13, 10]);
        assert_eq!(agreement, Some(Agreement { share: 0.5, worst: 3 }));
    }

    #[test]
    fn pictures_of_different_sizes_are_not_compared() {
        assert_eq!(Agreement::of(&[0; 3], &[0; 6]), None);
        assert_eq!(Agreement::of(&[], &[]), None);
    }
}
