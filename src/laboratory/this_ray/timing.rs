//! What each method takes for one ray.

use super::{Target, by};
use crate::laboratory::stopwatch::resolution;
use crate::laboratory::{Repeat, Stopwatch, Timing};
use crate::scene::Scene;
use crate::shape::Method;
use std::hint::black_box;

/// A ray is traced so often in one go that the clock makes at least so many steps: then it is read to half a percent. More
/// would keep a person waiting.
const STEPS: f64 = 200.0;

/// At most so often in one go, however little the clock shows.
const MOST_RAYS: u32 = 1 << 20;

/// The times of one ray by each of [`Method::ALL`], measured in turn: A B C A B C. Fewer repeats than asked for where
/// `stopped` says yes.
pub fn time_methods(
    scene: &Scene,
    target: Target,
    stopwatch: &mut dyn Stopwatch,
    repeats: u32,
    stopped: &dyn Fn() -> bool,
) -> Vec<Timing> {
    let scenes = Method::ALL.map(|method| by(scene, method));
    let resolution = resolution(stopwatch);
    let counts = scenes.each_ref().map(|scene| enough(scene, target, STEPS * resolution, stopwatch, stopped));
    let mut times = [const { Vec::new() }; Method::ALL.len()];
    for _ in 0..repeats {
        for (k, times) in times.iter_mut().enumerate() {
            if stopped() {
                break;
            }
            times.push(repeat(&scenes[k], target, counts[k], stopwatch));
        }
    }
    let steps = |count: u32| move |seconds: f64| seconds * f64::from(count) / resolution;
    times.iter().zip(counts).map(|(times, count)| Timing::of(times, steps(count))).collect()
}

/// How many rays take long enough to be timed together. These first ones also warm caches up.
fn enough(
    scene: &Scene,
    target: Target,
    shortest: f64,
    stopwatch: &mut dyn Stopwatch,
    stopped: &dyn Fn() -> bool,
) -> u32 {
    let mut count = 1;
    while count < MOST_RAYS && !stopped() && seconds(scene, target, count, stopwatch).0 < shortest {
        count *= 2;
    }
    count
}

fn repeat(scene: &Scene, target: Target, count: u32, stopwatch: &mut dyn Stopwatch) -> Repeat {
    let (seconds, waiting) = seconds(scene, target, count, stopwatch);
    Repeat { seconds: seconds / f64::from(count), waiting }
}

/// What so many rays take, and the share of the time in which the thread waited.
fn seconds(scene: &Scene, target: Target, count: u32, stopwatch: &mut dyn Stopwatch) -> (f64, f64) {
    let taken = stopwatch.time(&mut || {
        for _ in 0..count {
            black_box(black_box(target).trace(black_box(scene)));
        }
        u64::from(count)
    });
    (taken.worked.as_secs_f64(), taken.waiting())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laboratory::Taken;
    use crate::scene::{embedded_scene, load};
    use std::time::Duration;

    #[test]
    fn a_clock_that_gives_every_ray_a_microsecond_is_believed() {
        let embedded = embedded_scene("hello/sphere").unwrap();
        let scene = load(embedded.text, &embedded.name).unwrap();
        let mut clock = |work: &mut (dyn FnMut() -> u64 + Send)| {
            let worked = Duration::from_micros(work());
            Taken { worked, wall: worked }
        };
        let timings = time_methods(&scene, Target::Pixel([0, 0]), &mut clock, 5, &|| false);
        assert_eq!(timings.len(), Method::ALL.len());
        for timing in timings {
            assert_eq!((timing.repeats, timing.told()), (5, Some(1e-6)), "{timing:?}");
        }
    }
}
