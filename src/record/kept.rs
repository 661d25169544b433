//! A recorder for tests.

use super::{Counter, Entry, Recorder};

/// Keeps what is reported, in the order in which it ends.
#[derive(Default)]
pub struct Kept(pub Vec<Entry>);

impl Recorder for Kept {
    const RECORDING: bool = true;

    fn begin(&mut self) {}

    fn end(&mut self, describe: impl FnOnce() -> Entry) {
        self.0.push(describe());
    }

    fn count(&mut self, _counter: Counter) {}
}
