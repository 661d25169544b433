//! The ledger, measured behind the window's back.

use crate::app::frame::background::Background;
use crate::app::frame::task::{self, Task};
use crate::cpu_time::cpu_time;
use crate::ledger::{Ledger, Size, measure};
use crate::scene::Scene;
use crate::trace::Progress;
use egui::Context;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Small enough that a ledger is there within seconds, large enough that a price is more than its spread.
const SIZE: Size = Size { width: 120, pairs: 3 };

/// To measure what each effect of a scene costs.
#[derive(Serialize, Deserialize)]
pub struct MeasureEffects;

impl Task for MeasureEffects {
    const NAME: &'static str = "ledger";
    type News = Ledger;

    fn run(self, scene: &Arc<Scene>, progress: &Progress, publish: &mut dyn FnMut(Ledger)) {
        if let Some(ledger) = measure(scene, SIZE, |work| cpu_time(work).0, progress) {
            publish(ledger);
        }
    }
}

/// Measures one scene; dropping it cancels the work.
pub struct LedgerJob {
    work: Background<Ledger>,
    pixels: usize,
}

impl LedgerJob {
    /// Begins to measure; none where no thread can be started.
    pub fn start(ctx: &Context, scene: &Arc<Scene>) -> Option<Self> {
        Some(Self { work: task::begin(ctx, scene, MeasureEffects)?, pixels: SIZE.pixels(scene) })
    }

    /// The ledger, once, when it is there.
    pub fn result(&self) -> Option<Ledger> {
        self.work.take()
    }

    /// The share of the work that is done, from 0 to 1.
    pub fn share_done(&self) -> f32 {
        (self.work.done() as f32 / self.pixels.max(1) as f32).min(1.0)
    }
}
