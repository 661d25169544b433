//! The ledger, measured behind the window's back.

use crate::app::system;
use crate::cpu_time::cpu_time;
use crate::ledger::{Ledger, Size, measure};
use crate::scene::Scene;
use crate::trace::Progress;
use egui::Context;
use std::sync::{Arc, Mutex, PoisonError};

/// Small enough that a ledger is there within seconds, large enough that a price is more than its spread.
const SIZE: Size = Size { width: 120, pairs: 3 };

/// Measures one scene; dropping it cancels the work.
pub struct LedgerJob {
    progress: Arc<Progress>,
    result: Arc<Mutex<Option<Arc<Ledger>>>>,
    pixels: usize,
}

impl Drop for LedgerJob {
    fn drop(&mut self) {
        self.progress.cancel();
    }
}

impl LedgerJob {
    /// Begins to measure; none where no thread can be started.
    pub fn start(ctx: &Context, scene: &Arc<Scene>) -> Option<Self> {
        let job = Self { progress: Arc::default(), result: Arc::default(), pixels: SIZE.pixels(scene) };
        let (ctx, scene) = (ctx.clone(), Arc::clone(scene));
        let (progress, result) = (Arc::clone(&job.progress), Arc::clone(&job.result));
        let work = move || {
            let ledger = measure(&scene, SIZE, |work| cpu_time(work).0, &progress);
            *result.lock().unwrap_or_else(PoisonError::into_inner) = ledger.map(Arc::new);
            ctx.request_repaint();
        };
        system::begin("ledger", work).then_some(job)
    }

    /// The ledger, once it is there.
    pub fn result(&self) -> Option<Arc<Ledger>> {
        self.result.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// The share of the work that is done, from 0 to 1.
    pub fn share_done(&self) -> f32 {
        (self.progress.done() as f32 / self.pixels.max(1) as f32).min(1.0)
    }
}
