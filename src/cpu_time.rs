//! How long a thread has worked, not counting what it waited for.

use crate::laboratory::Taken;
use std::time::Duration;
use web_time::Instant;

/// Where Linux says how many nanoseconds this thread has run.
#[cfg(not(target_arch = "wasm32"))]
const SCHEDULER: &str = "/proc/thread-self/schedstat";

/// A rest in which the scheduler brings its account up to date; while a thread runs, that happens only every few
/// milliseconds. Any length will do.
#[cfg(not(target_arch = "wasm32"))]
const REST: Duration = Duration::from_micros(1);

/// Whether times are CPU times here; elsewhere they are those of the clock on the wall.
#[must_use]
pub fn is_cpu_time() -> bool {
    worked().is_some()
}

/// Does the work and says how long this thread took for it.
pub fn cpu_time<T>(work: impl FnOnce() -> T) -> (Duration, T) {
    let (began, before) = (Instant::now(), worked());
    let result = work();
    let taken = match (before, worked()) {
        (Some(before), Some(after)) => after.saturating_sub(before),
        _ => began.elapsed(),
    };
    (taken, result)
}

/// Does the work and says how long this thread worked for it and how long that was by the clock on the wall.
pub fn taken(work: &mut (dyn FnMut() -> u64 + Send)) -> Taken {
    let mut wall = Duration::ZERO;
    let (worked, ()) = cpu_time(|| {
        let began = Instant::now();
        work();
        wall = began.elapsed();
    });
    Taken { worked, wall }
}

/// The time that this thread has run.
#[cfg(not(target_arch = "wasm32"))]
fn worked() -> Option<Duration> {
    std::thread::sleep(REST);
    let text = std::fs::read_to_string(SCHEDULER).ok()?;
    text.split_whitespace().next()?.parse().ok().map(Duration::from_nanos)
}

/// No browser tells.
#[cfg(target_arch = "wasm32")]
const fn worked() -> Option<Duration> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn even_a_short_time_is_more_than_none_and_no_longer_than_the_clock_says() {
        let clock = Instant::now();
        let (taken, sum) = cpu_time(|| (0..20_000_u64).fold(1_u64, |sum, k| sum.wrapping_mul(31) ^ k));
        assert_ne!(sum, 0);
        assert!(taken > Duration::ZERO && taken <= clock.elapsed(), "{taken:?} of {:?}", clock.elapsed());
    }
}
