//! What each pixel takes.

use super::size;
use crate::ledger::quantile;
use crate::record::NullRecorder;
use crate::scene::{Scene, Sights};
use crate::trace::{Progress, Tracer, trace_pixel_with};
use crate::view::{HeatMap, HeatScale};
use std::hint::black_box;
use std::time::Duration;

/// How often each pixel is timed; the median counts. All pixels are timed once before any is timed again, so that a
/// disturbance meets different pixels each time.
pub const PASSES: usize = 5;

/// A pixel is traced until this much time has passed. Less would be lost between two readings of a clock, which take some
/// tens of nanoseconds; more would take a minute for a picture of sky.
const LEAST: Duration = Duration::from_micros(2);

/// No pixel is traced more often than this in one go, whatever the clock says.
const MOST_RUNS: u32 = 64;

/// The nanoseconds that each pixel takes on one thread, by a clock that says how much time has passed; none if it was
/// cancelled.
///
/// The clock should be one of the wall: those of threads are too coarse for a pixel. A thread that is made to wait spoils a pass of
/// a pixel, but not its median.
#[must_use]
pub fn time_map(scene: &Scene, now: &dyn Fn() -> Duration, progress: &Progress) -> Option<HeatMap> {
    let sights = scene.shortcuts.sights.then(|| Sights::new(scene));
    let tracer = sights.as_ref().map_or(Tracer::new(scene), |sights| Tracer::new(scene).with_sights(sights));
    let [width, height] = [scene.image.width, scene.image.height];
    let pixels = || (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
    let run = |[x, y]: [u32; 2], runs: u32| {
        let began = now();
        for _ in 0..runs {
            black_box(trace_pixel_with(&tracer, x, y, &mut NullRecorder));
        }
        progress.advance();
        now().saturating_sub(began)
    };
    // The first pass warms up, and tells how often to trace each pixel.
    let mut runs = Vec::with_capacity(width as usize * height as usize);
    for pixel in pixels() {
        if progress.cancelled() {
            return None;
        }
        let enough = LEAST.as_secs_f64() / run(pixel, 1).as_secs_f64().max(1e-9);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and the most")]
        let enough = enough.ceil().clamp(1.0, f64::from(MOST_RUNS)) as u32;
        runs.push(enough);
    }
    let mut times = vec![[0.0; PASSES]; runs.len()];
    for pass in 0..PASSES {
        for ((pixel, &runs), times) in pixels().zip(&runs).zip(&mut times) {
            if progress.cancelled() {
                return None;
            }
            times[pass] = 1e9 * run(pixel, runs).as_secs_f64() / f64::from(runs);
        }
    }
    Some(map(scene, times.iter().map(|times| quantile(times.to_vec(), 0.5)).collect()))
}

fn map(scene: &Scene, values: Vec<f64>) -> HeatMap {
    // A few stalls would spend the colours on themselves.
    let range = [0.005, 0.998].map(|share| quantile(values.clone(), share).max(1.0));
    let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
    HeatMap {
        title: "Time".to_owned(),
        notes: vec![format!("Nanoseconds on one thread, the median of {PASSES}; {mean:.0} ns on average.")],
        size: size(scene.image),
        scale: HeatScale::Log(range),
        unit: "ns".to_owned(),
        values,
        ..HeatMap::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Image, embedded_scene, load};
    use std::cell::Cell;

    #[test]
    fn a_clock_that_moves_by_a_step_each_time_it_is_read_gives_every_pixel_that_step() {
        let name = "hello/sphere";
        let mut scene = load(embedded_scene(name).unwrap().text, name).unwrap();
        scene.image = Image { width: 4, height: 3 };
        let time = Cell::new(Duration::ZERO);
        let now = || {
            time.set(time.get() + Duration::from_micros(7));
            time.get()
        };
        let map = time_map(&scene, &now, &Progress::new()).unwrap();
        assert_eq!(map.values.len(), 12);
        assert!(map.values.iter().all(|ns| (ns - 7_000.0).abs() < 1e-6), "{:?}", map.values);
    }
}
