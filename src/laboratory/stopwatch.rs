//! How time is taken. The clock itself comes from outside, so that the laboratory runs wherever there is one, and so that
//! tests can bring a clock that does what they say.

use crate::ledger::quantile;
use std::hint::black_box;
use std::time::Duration;

/// What a piece of work took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Taken {
    /// How long the thread worked for it.
    pub worked: Duration,
    /// How long it took by the clock on the wall.
    pub wall: Duration,
}

impl Taken {
    /// The share of the time on the wall in which the thread had to wait for others; 0 where the clock cannot tell.
    #[must_use]
    pub fn waiting(&self) -> f64 {
        let (worked, wall) = (self.worked.as_secs_f64(), self.wall.as_secs_f64());
        if wall > worked { 1.0 - worked / wall } else { 0.0 }
    }
}

/// Does a piece of work and says what it took. The work says how much it did, in rays and tests: a clock of a test may go by
/// that; others have no use for it.
pub trait Stopwatch: Send {
    /// Does the work once.
    fn time(&mut self, work: &mut (dyn FnMut() -> u64 + Send)) -> Taken;
}

impl<F: FnMut(&mut (dyn FnMut() -> u64 + Send)) -> Taken + Send> Stopwatch for F {
    fn time(&mut self, work: &mut (dyn FnMut() -> u64 + Send)) -> Taken {
        self(work)
    }
}

/// How many steps the pinned piece of work has: some milliseconds of any machine of our days. Fewer could not be told from
/// the clock's own steps; more would take time away from what is measured.
const STEPS: u64 = 2_000_000;

/// How often nothing is timed to learn what the clock says to it.
const NOTHINGS: usize = 21;

/// A piece of work that never changes: what the machine takes for it says how steady the machine is.
#[must_use]
pub fn pinned_work() -> u64 {
    steps(STEPS)
}

/// Each step needs the result of the one before, so that no machine can do them at once.
fn steps(count: u64) -> u64 {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    for _ in 0..count {
        state = black_box(state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f));
    }
    black_box(state);
    count
}

/// The smallest time that the clock can tell, in seconds: what it says to no work at all, or where that is nothing, the least
/// that it ever says.
#[must_use]
pub fn resolution(stopwatch: &mut dyn Stopwatch) -> f64 {
    let nothings = (0..NOTHINGS).map(|_| stopwatch.time(&mut || 0).worked.as_secs_f64()).collect();
    let median = quantile(nothings, 0.5);
    if median > 0.0 {
        return median;
    }
    // A clock that moves in steps: work that grows until it is seen.
    (0..32)
        .map(|doublings| stopwatch.time(&mut || steps(1 << doublings)).worked.as_secs_f64())
        .find(|&t| t > 0.0)
        .unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn taken(worked: u64, wall: u64) -> Taken {
        Taken { worked: Duration::from_micros(worked), wall: Duration::from_micros(wall) }
    }

    #[test]
    fn waiting_is_what_the_wall_clock_shows_beyond_the_work() {
        assert_eq!(taken(750, 1000).waiting(), 0.25);
        assert_eq!(taken(1000, 1000).waiting(), 0.0);
        assert_eq!(taken(1001, 1000).waiting(), 0.0);
        assert_eq!(taken(0, 0).waiting(), 0.0);
    }

    #[test]
    fn the_resolution_of_a_clock_that_costs_time_is_what_it_costs() {
        let mut dear = |work: &mut (dyn FnMut() -> u64 + Send)| taken(7 + work(), 0);
        assert_eq!(resolution(&mut dear), 7e-6);
    }

    #[test]
    fn the_resolution_of_a_clock_that_moves_in_steps_is_a_step() {
        let mut coarse = |work: &mut (dyn FnMut() -> u64 + Send)| taken(work() / 10_000 * 10_000, 0);
        assert_eq!(resolution(&mut coarse), 0.01);
    }

    #[test]
    fn pinned_work_is_the_same_every_time() {
        assert_eq!(pinned_work(), pinned_work());
    }
}
