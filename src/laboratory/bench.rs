//! Timing in turn: all looks at the scene one after the other, an unchanging piece of work between them, and again from the start.

use super::stopwatch::{Taken, pinned_work, resolution};
use super::subject::Subject;
use super::timing::Repeat;
use super::{Stopwatch, Timing};
use crate::trace::{OneThread, Progress};
use std::time::Duration;

/// One reading of the clock covers at least so many of its steps, if need be by several pictures: then it is read to half a percent.
const STEPS: f64 = 200.0;

/// The most pictures of one reading: so many only where a picture has a handful of pixels.
const MOST_PICTURES: f64 = 1000.0;

/// The thread that is measured, its clock, and what was spent.
pub(super) struct Bench<'a> {
    thread: OneThread,
    pub stopwatch: &'a mut dyn Stopwatch,
    pub progress: &'a Progress,
    /// The smallest time that the clock can tell, in seconds.
    pub resolution: f64,
    /// Seconds on the wall that went into measuring.
    pub spent: f64,
    /// Seconds that the thread worked and that passed, while pictures were timed.
    pub timed: [f64; 2],
    /// What the pinned work took.
    pub pinned: Vec<Repeat>,
}

impl<'a> Bench<'a> {
    /// None if no thread can be started.
    pub fn new(stopwatch: &'a mut dyn Stopwatch, progress: &'a Progress) -> Option<Self> {
        let thread = OneThread::new()?;
        let resolution = thread.install(|| resolution(stopwatch));
        Some(Self { thread, stopwatch, progress, resolution, spent: 0.0, timed: [0.0; 2], pinned: Vec::new() })
    }

    /// Time on the measured thread.
    pub fn time(&mut self, work: &mut (dyn FnMut() -> u64 + Send)) -> Taken {
        let stopwatch = &mut *self.stopwatch;
        let taken = self.thread.install(|| stopwatch.time(work));
        self.spent += taken.wall.as_secs_f64();
        taken
    }

    /// Does work on all threads that there are, and counts its time as spent.
    pub fn spend(&mut self, work: &mut (dyn FnMut() -> u64 + Send)) -> f64 {
        let wall = self.stopwatch.time(work).wall.as_secs_f64();
        self.spent += wall;
        wall
    }

    /// Renders a subject for the first time: for its picture, and to warm up. Says what it took; none if it was interrupted.
    pub fn warm_up(&mut self, subject: &mut Subject) -> Option<Taken> {
        let progress = self.progress;
        let mut picture = None;
        let taken = self.time(&mut || {
            let rendered = subject.render(progress);
            let work = rendered.as_ref().map_or(0, |(_, work)| *work);
            picture = rendered.map(|(picture, _)| picture);
            work
        });
        subject.picture = Some(picture?);
        subject.batch = self.batch(taken.worked);
        Some(taken)
    }

    fn batch(&self, one: Duration) -> u32 {
        let wanted = STEPS * self.resolution / one.as_secs_f64().max(1e-9);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and the most")]
        let pictures = wanted.ceil().clamp(1.0, MOST_PICTURES) as u32;
        pictures
    }

    /// Times a subject once more. Interrupted readings are dropped.
    pub fn repeat(&mut self, subject: &mut Subject) {
        let progress = self.progress;
        let (scene, batch) = (&*subject, subject.batch);
        let taken = self.time(&mut || (0..batch).map_while(|_| scene.render(progress)).map(|(_, work)| work).sum());
        if progress.cancelled() {
            return;
        }
        let [worked, wall] = [taken.worked, taken.wall].map(|time| time.as_secs_f64());
        self.timed = [self.timed[0] + worked.min(wall), self.timed[1] + wall];
        subject.repeats.push(Repeat { seconds: worked / f64::from(batch), waiting: taken.waiting() });
    }

    /// Times all subjects in turn, with the pinned work before each.
    pub fn round(&mut self, subjects: &mut [Subject]) {
        for subject in subjects.iter_mut().filter(|subject| subject.picture.is_some()) {
            if self.progress.cancelled() {
                return;
            }
            self.pin();
            self.repeat(subject);
        }
    }

    fn pin(&mut self) {
        let taken = self.time(&mut pinned_work);
        self.pinned.push(Repeat { seconds: taken.worked.as_secs_f64(), waiting: taken.waiting() });
    }

    /// What the pinned work takes, and how steadily.
    pub fn pinned_timing(&self) -> Timing {
        Timing::of(&self.pinned, |seconds| seconds / self.resolution)
    }

    /// The share of the time on the wall in which the measured thread had to wait.
    pub fn waiting(&self) -> f64 {
        let [worked, wall] = self.timed;
        if wall > 0.0 { 1.0 - worked / wall } else { 0.0 }
    }

    /// The seconds on the wall that a round will take.
    pub fn price(&self, subjects: &[Subject]) -> f64 {
        let lasts = |repeat: &Repeat| repeat.seconds / (1.0 - repeat.waiting.min(0.9));
        let pinned = self.pinned.last().map_or(0.0, lasts);
        let each = |subject: &Subject| Some(lasts(subject.repeats.last()?) * f64::from(subject.batch) + pinned);
        subjects.iter().filter_map(each).sum()
    }
}
