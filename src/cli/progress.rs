//! Work that takes its time: a bar on the standard error, and Ctrl-C.

use crate::trace::Progress;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{self, IsTerminal};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// How often the bar moves. Faster flickers, slower looks stuck.
const TICK: Duration = Duration::from_millis(100);

/// How long work goes on without a bar: what is done sooner needs none.
const PATIENCE: Duration = Duration::from_secs(1);

/// The first Ctrl-C asks the work to stop, the second ends the program. `stop` says whether it was asked before.
pub fn stop_on_ctrl_c(stop: impl Fn() -> bool + Send + 'static) {
    // Without a handler Ctrl-C ends the program at once, and nothing is written: no reason not to work.
    let _ = ctrlc::set_handler(move || {
        if stop() {
            std::process::exit(130);
        }
    });
}

/// Progress that the first Ctrl-C cancels; the second ends the program.
pub fn stopped_by_ctrl_c() -> Arc<Progress> {
    let progress = Arc::new(Progress::new());
    let stopping = Arc::clone(&progress);
    stop_on_ctrl_c(move || {
        let again = stopping.cancelled();
        stopping.cancel();
        again
    });
    progress
}

/// Does the work while a bar shows the time left, if there is a terminal to show it on.
pub fn with_bar<T>(total: usize, done: impl Fn() -> usize + Sync, work: impl FnOnce() -> T) -> T {
    if !io::stderr().is_terminal() {
        return work();
    }
    let finished = AtomicBool::new(false);
    thread::scope(|scope| {
        let watch = || draw_bar(total, &done, &finished);
        // Without a thread for it there is no bar, and the work is done all the same.
        let bar = thread::Builder::new().spawn_scoped(scope, watch).ok();
        let result = work();
        finished.store(true, Ordering::Release);
        if let Some(bar) = bar {
            bar.thread().unpark();
        }
        result
    })
}

fn draw_bar(total: usize, done: impl Fn() -> usize, finished: &AtomicBool) {
    let began = Instant::now();
    while !finished.load(Ordering::Acquire) && began.elapsed() < PATIENCE {
        thread::park_timeout(PATIENCE.saturating_sub(began.elapsed()));
    }
    if finished.load(Ordering::Acquire) {
        return;
    }
    let bar = ProgressBar::new(total as u64);
    if let Ok(style) = ProgressStyle::with_template("{wide_bar} {percent}%, {eta} left") {
        bar.set_style(style);
    }
    while !finished.load(Ordering::Acquire) {
        bar.set_position(done() as u64);
        thread::park_timeout(TICK);
    }
    bar.finish_and_clear();
}
