//! Work that is done behind the window's back and brings its results as it goes.

use crate::app::system;
use crate::trace::Progress;
use egui::Context;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use web_time::Instant;

/// Dropping it cancels the work.
pub struct Background<T> {
    progress: Arc<Progress>,
    latest: Arc<Mutex<Latest<T>>>,
    began: Instant,
    /// Called once when the work is given up, where it cannot look whether it is.
    give_up: Option<Box<dyn FnOnce() + Send>>,
}

/// The other end of the work: where its results are handed over. Dropping it ends the work.
pub struct Results<T> {
    progress: Arc<Progress>,
    latest: Arc<Mutex<Latest<T>>>,
    ctx: Context,
}

impl<T> Results<T> {
    /// Hands over a result.
    pub fn publish(&self, result: T) {
        lock(&self.latest).result = Some(result);
        self.ctx.request_repaint();
    }

    /// Lets whoever waits look how far the work has come.
    #[cfg(target_arch = "wasm32")]
    pub fn look(&self) {
        self.ctx.request_repaint();
    }

    /// How far the work has come, and whether it is given up.
    pub fn progress(&self) -> &Progress {
        &self.progress
    }
}

impl<T> Drop for Results<T> {
    fn drop(&mut self) {
        lock(&self.latest).finished = true;
        self.ctx.request_repaint();
    }
}

struct Latest<T> {
    result: Option<T>,
    finished: bool,
}

impl<T> Drop for Background<T> {
    fn drop(&mut self) {
        self.cancel();
        if let Some(give_up) = self.give_up.take() {
            give_up();
        }
    }
}

impl<T> Background<T> {
    /// Asks the work to stop; it does so as soon as it can.
    pub fn cancel(&self) {
        self.progress.cancel();
    }

    /// Work that somebody else does, with the end where its results are handed over.
    pub fn of(ctx: &Context) -> (Self, Results<T>) {
        let latest = Arc::new(Mutex::new(Latest { result: None, finished: false }));
        let job = Self { progress: Arc::default(), latest, began: Instant::now(), give_up: None };
        let results =
            Results { progress: Arc::clone(&job.progress), latest: Arc::clone(&job.latest), ctx: ctx.clone() };
        (job, results)
    }

    /// The same, with what is to be done if it is given up.
    #[cfg(target_arch = "wasm32")]
    #[must_use]
    pub fn or_else(mut self, give_up: impl FnOnce() + Send + 'static) -> Self {
        self.give_up = Some(Box::new(give_up));
        self
    }
}

impl<T: Send + 'static> Background<T> {
    /// Begins to work in a thread of this name; none where no thread can be started. The work hands over each result as it
    /// comes.
    pub fn start(
        ctx: &Context,
        name: &str,
        work: impl FnOnce(&Progress, &mut dyn FnMut(T)) + Send + 'static,
    ) -> Option<Self> {
        let (job, results) = Self::of(ctx);
        let all = move || work(results.progress(), &mut |result| results.publish(result));
        system::begin(name, all).then_some(job)
    }

    /// The newest result, if it was not taken yet.
    pub fn take(&self) -> Option<T> {
        lock(&self.latest).result.take()
    }

    /// Whether all work is done, or its thread died, which leaves nobody else to hold the results.
    pub fn is_finished(&self) -> bool {
        lock(&self.latest).finished || Arc::strong_count(&self.latest) == 1
    }

    /// How many pixels it has finished.
    pub fn done(&self) -> usize {
        self.progress.done()
    }

    /// How long it has been at work, in seconds.
    pub fn seconds(&self) -> f64 {
        self.began.elapsed().as_secs_f64()
    }
}

/// A thread that died while it held the lock left a whole result behind: each is put there in one move.
fn lock<T>(latest: &Mutex<Latest<T>>) -> MutexGuard<'_, Latest<T>> {
    latest.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::mpsc::channel;

    #[test]
    fn dropping_the_job_cancels_the_work() {
        let (sender, receiver) = channel();
        let (begin, begun) = channel();
        let work = move |progress: &Progress, publish: &mut dyn FnMut(u8)| {
            publish(1);
            begin.send(()).unwrap();
            while !progress.cancelled() {
                std::thread::yield_now();
            }
            sender.send(progress.cancelled()).unwrap();
        };
        let job = Background::start(&Context::default(), "test", work).unwrap();
        begun.recv().unwrap();
        assert_eq!((job.take(), job.take(), job.is_finished()), (Some(1), None, false));
        drop(job);
        assert_eq!(receiver.recv(), Ok(true));
    }
}
