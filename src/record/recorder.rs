//! Who listens while a ray is traced.

use super::{Effect, Entry, RayKind};

/// Something that is counted, whatever else is recorded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Counter {
    /// A ray of this kind was traced.
    Ray(RayKind),
    /// A ray was tested against a primitive; the number is the shape's place in the list of shapes.
    ShapeTest(usize),
    /// A ray was tested against the box of one solid. Boxes of several objects, which are tested four at a time, are not
    /// counted.
    ExtentTest,
    /// An extent test that spared the work behind it.
    ExtentMiss,
    /// The code of an effect was entered.
    Call(Effect),
    /// An effect sent a ray that there would not be without it.
    Sent(Effect),
    /// A ray came into a transparent object within another one, which the scene forbids.
    Overlap {
        /// The two objects, by their places in the list.
        objects: [usize; 2],
        /// The hit times between which the ray is in both.
        interval: [f64; 2],
    },
}

/// Listens to the one tracing code path. A recorder never answers a question and never changes a result.
///
/// Events nest: everything reported between [`begin`](Recorder::begin) and the matching [`end`](Recorder::end) becomes
/// a child of the event that `end` describes. Descriptions are closures, so that a recorder which does not keep them
/// pays nothing for them.
pub trait Recorder {
    /// Whether descriptions are kept. Work that serves only a description stands behind this constant.
    const RECORDING: bool;

    /// Opens an event whose description follows with the matching [`end`](Recorder::end).
    fn begin(&mut self);

    /// Describes and closes the event that was opened last.
    fn end(&mut self, describe: impl FnOnce() -> Entry);

    /// Counts one occurrence.
    fn count(&mut self, counter: Counter);

    /// Whether lines of working are to carry their true errors, by arithmetic with 77 digits, in place of bounds on them. It
    /// decides how things are told, and is asked only where they are.
    fn is_measuring(&self) -> bool {
        false
    }

    /// Reports what `work` does as the parts of an event, which is described by the result. Where nothing is recorded
    /// the result goes straight to the caller: one that a description might borrow would first have to be copied.
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "measured: results are large, and would be copied on their way")]
    fn event<T>(&mut self, work: impl FnOnce(&mut Self) -> T, describe: impl FnOnce(&T) -> Entry) -> T {
        if !Self::RECORDING {
            return work(self);
        }
        self.begin();
        let result = work(self);
        self.end(|| describe(&result));
        result
    }

    /// Reports an event without children.
    #[inline]
    fn note(&mut self, describe: impl FnOnce() -> Entry) {
        self.begin();
        self.end(describe);
    }
}

/// Keeps nothing, and compiles to nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NullRecorder;

impl Recorder for NullRecorder {
    const RECORDING: bool = false;

    #[inline]
    fn begin(&mut self) {}

    #[inline]
    fn end(&mut self, _describe: impl FnOnce() -> Entry) {}

    #[inline]
    fn count(&mut self, _counter: Counter) {}
}
