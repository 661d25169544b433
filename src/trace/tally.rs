//! Counts what a picture took.

use super::overlap::Overlaps;
use crate::record::{Counter, Effect, Entry, RayKind, Recorder};
use crate::shape::Shape;

/// A [`Recorder`] that counts and keeps nothing else.
#[derive(Clone, Debug, PartialEq)]
pub struct Tally {
    rays: [u64; RayKind::ALL.len()],
    shape_tests: Vec<u64>,
    extent_tests: u64,
    extent_misses: u64,
    calls: [u64; Effect::ALL.len()],
    sent: [u64; Effect::ALL.len()],
    overlaps: Overlaps,
}

impl Default for Tally {
    fn default() -> Self {
        let shape_tests = vec![0; Shape::NAMES.len()];
        let (rays, calls, sent) = ([0; RayKind::ALL.len()], [0; Effect::ALL.len()], [0; Effect::ALL.len()]);
        Self { rays, shape_tests, extent_tests: 0, extent_misses: 0, calls, sent, overlaps: Overlaps::default() }
    }
}

impl Tally {
    /// How many rays of this kind were traced.
    #[must_use]
    pub const fn rays(&self, kind: RayKind) -> u64 {
        self.rays[kind as usize]
    }

    /// How often each shape was tested, in the order of the list of shapes.
    #[must_use]
    pub fn shape_tests(&self) -> Vec<(&'static str, u64)> {
        Shape::NAMES.iter().copied().zip(self.shape_tests.iter().copied()).collect()
    }

    /// How often a ray was tested against the box of one solid; the boxes of the hierarchy are not counted.
    #[must_use]
    pub const fn extent_tests(&self) -> u64 {
        self.extent_tests
    }

    /// How many of these tests spared the work behind them.
    #[must_use]
    pub const fn extent_misses(&self) -> u64 {
        self.extent_misses
    }

    /// How often the code of an effect was entered.
    #[must_use]
    pub const fn calls(&self, effect: Effect) -> u64 {
        self.calls[effect as usize]
    }

    /// How many rays were sent that there would not be without the effect.
    #[must_use]
    pub const fn sent(&self, effect: Effect) -> u64 {
        self.sent[effect as usize]
    }

    /// Where transparent objects fill the same space, which the scene forbids.
    #[must_use]
    pub const fn overlaps(&self) -> &Overlaps {
        &self.overlaps
    }

    /// What is counted from now on belongs to this pixel.
    pub(super) fn begin_pixel(&mut self, pixel: [u32; 2]) {
        self.overlaps.begin_pixel(pixel);
    }

    /// Adds the counts of another part of the picture.
    #[must_use]
    pub fn plus(mut self, other: &Self) -> Self {
        let add = |to: &mut [u64], from: &[u64]| to.iter_mut().zip(from).for_each(|(to, from)| *to += from);
        add(&mut self.rays, &other.rays);
        add(&mut self.shape_tests, &other.shape_tests);
        add(&mut self.calls, &other.calls);
        add(&mut self.sent, &other.sent);
        self.overlaps = self.overlaps.plus(&other.overlaps);
        self.extent_tests += other.extent_tests;
        self.extent_misses += other.extent_misses;
        self
    }
}

impl Recorder for Tally {
    const RECORDING: bool = false;

    fn begin(&mut self) {}

    fn end(&mut self, _describe: impl FnOnce() -> Entry) {}

    #[inline]
    fn count(&mut self, counter: Counter) {
        match counter {
            Counter::Ray(kind) => self.rays[kind as usize] += 1,
            Counter::ShapeTest(shape) => self.shape_tests[shape] += 1,
            Counter::ExtentTest => self.extent_tests += 1,
            Counter::ExtentMiss => self.extent_misses += 1,
            Counter::Call(effect) => self.calls[effect as usize] += 1,
            Counter::Sent(effect) => self.sent[effect as usize] += 1,
            Counter::Overlap { objects, interval } => self.overlaps.add(objects, interval),
        }
    }
}
