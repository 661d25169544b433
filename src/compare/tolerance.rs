//! When two numbers count as the same.

/// How far two numbers may lie apart and still be the same.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tolerance {
    /// As a share of the larger one.
    pub relative: f64,
    /// In their own unit.
    pub absolute: f64,
}

impl Tolerance {
    /// Not a bit.
    pub const EXACT: Self = Self { relative: 0.0, absolute: 0.0 };

    /// Whether all of the numbers are the same, as the coordinates of one vector: the largest of them is the measure of
    /// all. What is no number is the same as what is no number.
    #[must_use]
    pub fn allows(&self, left: &[f64], right: &[f64]) -> bool {
        if left.len() != right.len() {
            return false;
        }
        let pairs = || std::iter::zip(left, right);
        let largest = pairs().flat_map(|(a, b)| [a.abs(), b.abs()]).filter(|x| x.is_finite()).fold(0.0, f64::max);
        let most = self.absolute.max(self.relative * largest);
        pairs().all(|(a, b)| a == b || (a.is_nan() && b.is_nan()) || (a - b).abs() <= most)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_a_tolerance_the_last_bit_counts() {
        let next = 1.0_f64.next_up();
        assert!(Tolerance::EXACT.allows(&[1.0], &[1.0]));
        assert!(!Tolerance::EXACT.allows(&[1.0], &[next]));
        assert!(Tolerance::EXACT.allows(&[f64::NAN, f64::INFINITY], &[f64::NAN, f64::INFINITY]));
        assert!(!Tolerance::EXACT.allows(&[f64::NAN], &[1.0]));
        assert!(!Tolerance::EXACT.allows(&[1.0], &[1.0, 2.0]));
    }

    #[test]
    fn a_vector_is_measured_by_its_largest_coordinate() {
        let tolerance = Tolerance { relative: 1e-3, absolute: 0.0 };
        assert!(tolerance.allows(&[1000.0, 0.0], &[1000.0, 0.5]));
        assert!(!tolerance.allows(&[1000.0, 0.0], &[1000.0, 1.5]));
    }
}
