//! Work on one thread alone, so that it can be timed.

#[cfg(not(target_arch = "wasm32"))]
use rayon::{ThreadPool, ThreadPoolBuilder};

/// A thread of its own; in a browser, where there is only one, that one.
pub struct OneThread {
    #[cfg(not(target_arch = "wasm32"))]
    pool: ThreadPool,
}

impl OneThread {
    /// None where no thread can be started.
    #[cfg(not(target_arch = "wasm32"))]
    #[must_use]
    pub fn new() -> Option<Self> {
        Some(Self { pool: ThreadPoolBuilder::new().num_threads(1).build().ok()? })
    }

    /// Always there.
    #[cfg(target_arch = "wasm32")]
    #[expect(clippy::unnecessary_wraps, reason = "elsewhere no thread may be had")]
    #[must_use]
    pub const fn new() -> Option<Self> {
        Some(Self {})
    }

    /// Does work on it, and waits for the result.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn install<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        self.pool.install(work)
    }

    /// Does work on it.
    #[cfg(target_arch = "wasm32")]
    #[expect(clippy::unused_self, reason = "elsewhere it is a thread of its own")]
    pub fn install<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        work()
    }
}
