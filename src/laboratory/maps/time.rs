//! What each pixel takes.

use super::size;
use crate::ledger::quantile;
use crate::record::NullRecorder;
use crate::scene::{Scene, Sights};
use crate::trace::{Progress, Tracer, trace_pixel_with};
use crate::view::{HeatMap, HeatScale};
use serde::{Deserialize, Serialize};
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

/// What pixels take, as far as it is known.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Times {
    /// Nanoseconds, row by row from the top; a block of pixels has those of its upper left one until each has its own.
    pub values: Vec<f64>,
    /// The side of the blocks; 1 where every pixel was timed.
    pub side: u32,
    /// Half the distance between the quartiles of a pixel's repeats, as a share of its median: half of the pixels have less.
    pub spread: f64,
}

/// The nanoseconds that each pixel takes on one thread, by a clock that says how much time has passed; none if it was
/// cancelled.
///
/// The clock should be one of the wall: those of threads are too coarse for a pixel. A thread that is made to wait spoils a pass of
/// a pixel, but not its median.
#[must_use]
pub fn time_map(scene: &Scene, now: &dyn Fn() -> Duration, progress: &Progress) -> Option<HeatMap> {
    time_pixels(scene, 1, now, progress, &mut |_| {}).map(|times| map_of_times(scene, &times))
}

/// The same, coarse to fine from blocks of the given side; `on_pass` sees what is known after each pass.
#[must_use]
pub fn time_pixels(
    scene: &Scene,
    side: u32,
    now: &dyn Fn() -> Duration,
    progress: &Progress,
    on_pass: &mut dyn FnMut(&Times),
) -> Option<Times> {
    let sights = scene.shortcuts.sights.then(|| Sights::new(scene));
    let tracer = sights.as_ref().map_or(Tracer::new(scene), |sights| Tracer::new(scene).with_sights(sights));
    let timer = Timer { tracer, now, progress };
    let [width, height] = size(scene.image);
    let coarsest = side.max(1).next_power_of_two();
    let mut times = Times { values: vec![0.0; width * height], side: coarsest, spread: 0.0 };
    let mut spreads = Vec::with_capacity(width * height);
    loop {
        let step = times.side;
        let is_new = |x: u32, y: u32| step == coarsest || !(x.is_multiple_of(2 * step) && y.is_multiple_of(2 * step));
        let all = (0..scene.image.height)
            .step_by(step as usize)
            .flat_map(|y| (0..scene.image.width).step_by(step as usize).map(move |x| [x, y]));
        let pixels: Vec<[u32; 2]> = all.filter(|&[x, y]| is_new(x, y)).collect();
        for (&[x, y], repeats) in pixels.iter().zip(timer.repeats(&pixels)?) {
            let [low, middle, high] = [0.25, 0.5, 0.75].map(|share| quantile(repeats.to_vec(), share));
            spreads.push(0.5 * (high - low) / middle.max(f64::MIN_POSITIVE));
            let columns = x as usize..(x as usize + step as usize).min(width);
            for row in (y as usize..height).take(step as usize) {
                times.values[row * width..][columns.clone()].fill(middle);
            }
        }
        times.spread = quantile(spreads.clone(), 0.5);
        on_pass(&times);
        if step == 1 {
            return Some(times);
        }
        times.side /= 2;
    }
}

/// Times pixels.
struct Timer<'a> {
    tracer: Tracer<'a>,
    now: &'a dyn Fn() -> Duration,
    progress: &'a Progress,
}

impl Timer<'_> {
    /// The nanoseconds of each pixel, repeat by repeat; none if it was cancelled.
    fn repeats(&self, pixels: &[[u32; 2]]) -> Option<Vec<[f64; PASSES]>> {
        // The first pass warms up, and tells how often to trace each pixel.
        let mut runs = Vec::with_capacity(pixels.len());
        for &pixel in pixels {
            let enough = LEAST.as_secs_f64() / self.run(pixel, 1)?.as_secs_f64().max(1e-9);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and the most")]
            let enough = enough.ceil().clamp(1.0, f64::from(MOST_RUNS)) as u32;
            runs.push(enough);
        }
        let mut times = vec![[0.0; PASSES]; runs.len()];
        for pass in 0..PASSES {
            for ((&pixel, &runs), times) in pixels.iter().zip(&runs).zip(&mut times) {
                times[pass] = 1e9 * self.run(pixel, runs)?.as_secs_f64() / f64::from(runs);
            }
        }
        Some(times)
    }

    /// Traces a pixel so often; none if it was cancelled.
    fn run(&self, [x, y]: [u32; 2], runs: u32) -> Option<Duration> {
        let began = (self.now)();
        for _ in 0..runs {
            black_box(trace_pixel_with(&self.tracer, x, y, &mut NullRecorder));
        }
        self.progress.advance();
        let taken = (self.now)().saturating_sub(began);
        (!self.progress.cancelled()).then_some(taken)
    }
}

/// The map of what pixels take.
#[must_use]
pub fn map_of_times(scene: &Scene, Times { values, spread, .. }: &Times) -> HeatMap {
    // A few stalls would spend the colours on themselves.
    let range = [0.005, 0.998].map(|share| quantile(values.clone(), share).max(1.0));
    let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
    let percent = 100.0 * spread;
    HeatMap {
        title: "Time".to_owned(),
        notes: vec![
            format!("Nanoseconds on one thread, the median of {PASSES}; {mean:.0} ns on average."),
            format!("Repeats of one pixel scatter by ± {percent:.0} %; what differs by less is noise."),
        ],
        size: size(scene.image),
        scale: HeatScale::Log(range),
        unit: "ns".to_owned(),
        values: values.clone(),
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
