//! The frontier: the points that no other point beats (V. Pareto's optimum, here of two things).
//!
//! Times are uncertain, and so are errors. One point is *clearly faster* than another where their times differ by more than twice
//! what both are uncertain by together, and *clearly closer* where its error is smaller by more than one part in a hundred.
//! Then, going from the smallest error to the largest, a point is on the frontier if it is clearly faster than every point on it so
//! far; and where it is, those of them that are not clearly closer leave it.
//!
//! So each point on the frontier is clearly faster than all that are closer; and whatever is not on it has a point beside it
//! that is as close and not clearly slower. Where times and errors are exact this is Pareto's frontier itself.

use super::Timing;
use crate::math::portable;

/// What counts of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standing {
    /// Seconds.
    pub seconds: f64,
    /// By how many seconds that may be off: one standard deviation.
    pub uncertainty: f64,
    /// The error.
    pub error: f64,
}

/// Errors that differ by a smaller share of themselves are the same to anyone; with more, frontiers lose steps that can be seen.
const CLOSER: f64 = 0.01;

/// Standard deviations of a difference that make it clear: chance alone shows as much in one of twenty.
const CLEAR: f64 = 2.0;

impl Standing {
    /// Whether it is faster than another one, and not by chance.
    #[must_use]
    pub fn is_clearly_faster(&self, other: &Self) -> bool {
        other.seconds - self.seconds > CLEAR * portable::hypot(self.uncertainty, other.uncertainty)
    }

    /// Whether its error is smaller by what matters.
    #[must_use]
    pub fn is_clearly_closer(&self, other: &Self) -> bool {
        self.error < (1.0 - CLOSER) * other.error
    }
}

/// Which of them are on the frontier.
#[must_use]
pub fn frontier(standings: &[Standing]) -> Vec<bool> {
    let mut order: Vec<usize> = (0..standings.len()).collect();
    let key = |k: &usize| [standings[*k].error, standings[*k].seconds];
    order.sort_by(|a, b| {
        let ([error_a, time_a], [error_b, time_b]) = (key(a), key(b));
        error_a.total_cmp(&error_b).then(time_a.total_cmp(&time_b)).then(a.cmp(b))
    });
    let mut kept: Vec<usize> = Vec::new();
    for k in order {
        if kept.iter().all(|&other| standings[k].is_clearly_faster(&standings[other])) {
            while kept.last().is_some_and(|&last| !standings[last].is_clearly_closer(&standings[k])) {
                kept.pop();
            }
            kept.push(k);
        }
    }
    (0..standings.len()).map(|k| kept.contains(&k)).collect()
}

impl Timing {
    /// What counts of something that takes this time and errs by so much; none where the time is not to be told.
    #[must_use]
    pub fn standing(&self, error: f64) -> Option<Standing> {
        let seconds = self.told()?;
        Some(Standing { seconds, uncertainty: seconds * self.uncertainty(), error })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn exact(seconds: f64, error: f64) -> Standing {
        Standing { seconds, uncertainty: 0.0, error }
    }

    fn standings(uncertainty: f64) -> impl Strategy<Value = Vec<Standing>> {
        // Few different values, so that equal times and equal errors are met often.
        let one = (1_u32..40, 0_u32..12).prop_map(move |(time, error)| {
            let seconds = f64::from(time);
            Standing { seconds, uncertainty: uncertainty * seconds, error: f64::from(error) * 0.1 }
        });
        prop::collection::vec(one, 0..40)
    }

    #[test]
    fn of_two_points_that_are_alike_the_first_is_kept() {
        assert_eq!(frontier(&[exact(1.0, 0.5), exact(1.0, 0.5)]), [true, false]);
    }

    #[test]
    fn a_point_that_is_closer_by_nothing_that_matters_and_slower_is_not_on_it() {
        assert_eq!(frontier(&[exact(10.0, 0.500), exact(1.0, 0.501)]), [false, true]);
        assert_eq!(frontier(&[exact(10.0, 0.400), exact(1.0, 0.501)]), [true, true]);
    }

    #[test]
    fn a_point_that_is_faster_by_chance_is_not_on_it() {
        let noisy = |seconds, error| Standing { seconds, uncertainty: 0.05, error };
        assert_eq!(frontier(&[noisy(1.0, 0.1), noisy(0.9, 0.3)]), [true, false]);
        assert_eq!(frontier(&[noisy(1.0, 0.1), noisy(0.8, 0.3)]), [true, true]);
    }

    proptest! {
        #[test]
        fn with_exact_numbers_it_is_what_no_other_point_beats(points in standings(0.0)) {
            let on = frontier(&points);
            for (k, point) in points.iter().enumerate() {
                let beats = |(j, other): (usize, &Standing)| {
                    let no_worse = other.seconds <= point.seconds && other.error <= point.error;
                    let better = other.seconds < point.seconds || other.error < point.error;
                    no_worse && (better || j < k)
                };
                prop_assert_eq!(on[k], !points.iter().enumerate().any(beats), "{:?}", point);
            }
        }

        #[test]
        fn along_it_whatever_is_less_close_is_clearly_faster(points in standings(0.05)) {
            let on = frontier(&points);
            let kept: Vec<_> = points.iter().zip(&on).filter(|(_, on)| **on).map(|(point, _)| point).collect();
            for (a, b) in kept.iter().flat_map(|a| kept.iter().map(move |b| (a, b))) {
                prop_assert!(!a.is_clearly_closer(b) || b.is_clearly_faster(a), "{:?} {:?}", a, b);
            }
        }

        #[test]
        fn whatever_is_not_on_it_has_a_point_beside_it_that_is_as_close_and_not_clearly_slower(points in standings(0.05)) {
            let on = frontier(&points);
            for point in points.iter().zip(&on).filter(|(_, on)| !**on).map(|(point, _)| point) {
                let serves = |other: &Standing| other.error <= point.error && !point.is_clearly_faster(other);
                prop_assert!(points.iter().zip(&on).any(|(other, on)| *on && serves(other)), "{:?}", point);
            }
        }

        #[test]
        fn the_order_of_the_points_does_not_matter(points in standings(0.05)) {
            let kept = |points: &[Standing]| {
                let on = frontier(points);
                let mut kept: Vec<_> =
                    points.iter().zip(on).filter(|(_, on)| *on).map(|(p, _)| [p.error, p.seconds]).collect();
                kept.sort_by(|a, b| a[0].total_cmp(&b[0]));
                kept
            };
            let reversed: Vec<_> = points.iter().rev().copied().collect();
            prop_assert_eq!(kept(&points), kept(&reversed));
        }
    }
}
