//! Measuring: counts from one picture, prices from many.

use super::price::{Price, quantile};
use crate::record::Effect;
use crate::scene::{Image, Reason, Scene, reasons};
use crate::trace::{OneThread, Picture, Progress, render};
use serde::{Deserialize, Serialize};
use std::time::Duration;

/// How large the pictures are that are measured, and how often.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// The most columns; larger scenes are measured smaller, in their own shape.
    pub width: u32,
    /// How many pairs of pictures make a price.
    pub pairs: u32,
}

/// One effect.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Row {
    /// The effect, whether the scene calls for it, and why.
    pub reason: Reason,
    /// How often its code was entered.
    pub calls: u64,
    /// Rays that there would not be without it.
    pub rays: u64,
    /// What it costs; none where it does not run.
    pub price: Option<Price>,
    /// The picture without it; none where it does not run.
    pub without: Option<Picture>,
}

/// What all effects of a scene cost.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Ledger {
    /// A row for each effect.
    pub rows: Vec<Row>,
    /// The picture that was measured.
    pub picture: Picture,
    /// What it took in nanoseconds per pixel, the median.
    pub ns_per_pixel: f64,
    /// Half the distance between the quartiles of that.
    pub spread: f64,
    /// How many pairs of pictures make a price.
    pub pairs: u32,
}

/// Does some work and says how long the thread took for it.
pub type Clock = fn(&mut dyn FnMut()) -> Duration;

/// Measures a scene; none if it was cancelled. `progress` counts pixels, of which there are [`Size::pixels`] in all.
#[must_use]
pub fn measure(scene: &Scene, size: Size, clock: Clock, progress: &Progress) -> Option<Ledger> {
    OneThread::new()?.install(|| Measuring { clock, progress }.ledger(&size.of(scene), size.pairs))
}

struct Measuring<'a> {
    clock: Clock,
    progress: &'a Progress,
}

impl Size {
    /// The scene in this size.
    fn of(self, scene: &Scene) -> Scene {
        let Image { width, height } = scene.image;
        let mut smaller = scene.clone();
        if width > self.width {
            let share = f64::from(self.width) / f64::from(width);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "less than the height")]
            let height = ((f64::from(height) * share).round() as u32).max(1);
            smaller.image = Image { width: self.width, height };
        }
        smaller
    }

    /// How many pixels all pictures have together.
    #[must_use]
    pub fn pixels(self, scene: &Scene) -> usize {
        let Image { width, height } = self.of(scene).image;
        let pictures = 2 * self.pairs as usize * running(scene).count() + 1;
        width as usize * height as usize * pictures
    }
}

/// The effects that the scene calls for and that are switched on.
fn running(scene: &Scene) -> impl Iterator<Item = Effect> + '_ {
    let called = reasons(scene).into_iter().filter(|reason| reason.called_for).map(|reason| reason.effect);
    called.filter(|&effect| scene.effects.has(effect))
}

impl Measuring<'_> {
    fn ledger(&self, scene: &Scene, pairs: u32) -> Option<Ledger> {
        // The first picture is not timed: it warms caches up.
        let (picture, tally) = render(scene, self.progress);
        let pixels = picture.computed();
        let mut whole = Vec::new();
        let mut rows = Vec::new();
        for reason in reasons(scene) {
            let (effect, called_for) = (reason.effect, reason.called_for);
            let (calls, rays) = (tally.calls(effect), tally.sent(effect));
            let mut row = Row { reason, calls, rays, price: None, without: None };
            if called_for && scene.effects.has(effect) {
                let (timed, without) = self.pairs(scene, effect, pairs);
                whole.extend(timed.iter().map(|[with, _]| with.as_secs_f64() * 1e9 / pixels.max(1) as f64));
                row.price = Some(Price::of(&timed, pixels));
                row.without = without;
            }
            rows.push(row);
        }
        let ns_per_pixel = quantile(whole.clone(), 0.5);
        let spread = 0.5 * (quantile(whole.clone(), 0.75) - quantile(whole, 0.25));
        (!self.progress.cancelled()).then_some(Ledger { rows, picture, ns_per_pixel, spread, pairs })
    }

    /// Times with and without an effect, in turn, and the picture without it.
    fn pairs(&self, scene: &Scene, effect: Effect, pairs: u32) -> (Vec<[Duration; 2]>, Option<Picture>) {
        let without = scene.with_effects(scene.effects.without(effect));
        let mut picture = None;
        let timed = (0..pairs).map(|_| {
            let (with, _) = self.time(scene);
            let (time, other) = self.time(&without);
            picture = Some(other);
            [with, time]
        });
        (timed.collect(), picture)
    }

    fn time(&self, scene: &Scene) -> (Duration, Picture) {
        let mut picture = None;
        let taken = (self.clock)(&mut || picture = Some(render(scene, self.progress).0));
        (taken, picture.unwrap_or_else(|| render(scene, self.progress).0))
    }
}
