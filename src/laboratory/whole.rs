//! What holds for a small picture need not hold for the whole one: where a pixel covers less of a texture, filters have less to do.
//! So an answer is looked at in the whole picture's own size: all of it where there is time for that, for pixels by themselves take
//! longer than beside each other, and otherwise one pixel in so many.

use super::bench::Bench;
use super::errors::rmse;
use super::reference::{Sums, is_random, reference_scene};
use super::timing::Repeat;
use super::{Answer, Timing};
use crate::scene::{Image, Scene};
use crate::trace::{Picture, Progress, render_rows};

/// So many pixels are traced at least. Fewer miss what is small.
const PIXELS: u64 = 2000;

/// The most pixels of a row that one of them stands for.
const COARSEST: u32 = 8;

/// How often each is timed, and how often at most where the thread has to wait.
const REPEATS: u32 = 5;
const MOST_REPEATS: usize = 15;

/// So many of the clock's steps can be told as a time.
const READABLE: f64 = 150.0;

/// Pictures of the reference where chance decides: it errs by half of what one of them does.
const PICTURES: u32 = 4;

/// The answer with figures of the whole picture; as it is where these would take more than so many seconds, or are lost in noise.
pub(super) fn checked(answer: Answer, scene: &Scene, bench: &mut Bench, seconds: f64) -> Answer {
    let Some(step) = step(scene.image, [answer.seconds, seconds], bench.resolution) else { return answer };
    if bench.progress.cancelled() {
        return answer;
    }
    let looked_at = scene.with_profile(&answer.profile);
    let Some((whole, spread)) = whole(&looked_at, step, bench) else { return answer };
    let error = rmse(&sparse(&looked_at, step).0, &reference(scene, step));
    answer.with_figures(whole, spread, error)
}

/// What the whole picture takes, and how far that scatters; none if that is lost in noise.
fn whole(scene: &Scene, step: u32, bench: &mut Bench) -> Option<(f64, f64)> {
    let fine = time(scene, step, bench);
    let a = fine.told()?;
    if step == 1 {
        return Some((a, fine.spread));
    }
    let b = time(scene, 2 * step, bench).told()?;
    // What a picture takes beyond its pixels is in both, and one has four times the pixels of the other.
    let share = 1.0 / f64::from(step * step);
    let whole = a + (1.0 - share) * (a - b) / (0.75 * share);
    (a > b).then_some((whole, fine.spread / a * whole))
}

/// One pixel of so many by so many is traced, and for comparison one of four times as many: as many as there is time for, if
/// these are enough, and take long enough for the clock to tell. A picture takes about `seconds`, and there are `most`.
fn step(Image { width, height }: Image, [seconds, most]: [f64; 2], resolution: f64) -> Option<u32> {
    let pixels = u64::from(width) * u64::from(height);
    let is_affordable = |step: &u32| {
        let compared = if *step == 1 { 1.0 } else { 1.25 };
        compared * f64::from(REPEATS) * seconds / f64::from(step * step) <= most
    };
    let is_enough = |step: &u32| {
        let square = step * step;
        *step == 1 || pixels / u64::from(square) >= PIXELS && seconds / f64::from(4 * square) >= READABLE * resolution
    };
    (0..=COARSEST.ilog2()).map(|power| 1 << power).find(is_affordable).filter(is_enough)
}

fn time(scene: &Scene, step: u32, bench: &mut Bench) -> Timing {
    let resolution = bench.resolution;
    let mut repeats = Vec::new();
    loop {
        let taken = bench.time(&mut || sparse(scene, step).1);
        repeats.push(Repeat { seconds: taken.worked.as_secs_f64(), waiting: taken.waiting() });
        let timing =
            Timing::of(&repeats, |seconds| if resolution > 0.0 { seconds / resolution } else { f64::INFINITY });
        let count = repeats.len();
        if count >= MOST_REPEATS || (count >= REPEATS as usize && timing.told().is_some()) {
            return timing;
        }
    }
}

/// One pixel of each square, which has its colour.
fn sparse(scene: &Scene, step: u32) -> (Picture, u64) {
    let progress = Progress::new();
    let (picture, tally) = render_rows(scene, step, &progress, |_, _| progress.cancel());
    (picture, super::subject::work_of(&tally))
}

fn reference(scene: &Scene, step: u32) -> Picture {
    let mut sums = Sums::new(scene.image.width, scene.image.height);
    for number in 0..if is_random(scene) { PICTURES } else { 1 } {
        sums.add(&sparse(&reference_scene(scene, number), step).0);
    }
    sums.mean().unwrap_or_else(|| sparse(scene, step).0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_looked_at_as_a_whole_where_there_is_time_for_that_and_otherwise_by_one_pixel_of_many() {
        let step_of = |seconds| step(Image { width: 640, height: 480 }, [seconds, 5.0], 1e-6);
        assert_eq!([step_of(0.9), step_of(3.0), step_of(10.0)], [Some(1), Some(2), Some(4)]);
        assert_eq!(step_of(1000.0), None);
    }

    #[test]
    fn too_few_pixels_and_too_short_a_time_tell_nothing() {
        assert_eq!(step(Image { width: 40, height: 30 }, [3.0, 5.0], 1e-6), None);
        assert_eq!(step(Image { width: 640, height: 480 }, [3.0, 5.0], 0.1), None);
    }
}
