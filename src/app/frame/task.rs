//! Work on a whole scene, as data: so that it can be done where no memory is shared.
//!
//! On a desktop a task runs on a thread, beside the scene that is there. In a browser it is sent to a worker, with what the scene is
//! made from, and its news are sent back.

use super::background::Background;
use crate::app::system;
use crate::scene::Scene;
use crate::trace::Progress;
use egui::Context;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::sync::Arc;

/// Work on a whole scene that tells news as it goes.
pub trait Task: Serialize + DeserializeOwned + Send + 'static {
    /// By which it is known to workers; the name of its thread.
    const NAME: &'static str;
    /// What it tells.
    type News: Serialize + DeserializeOwned + Send + 'static;

    /// Does the work.
    fn run(self, scene: &Arc<Scene>, progress: &Progress, publish: &mut dyn FnMut(Self::News));
}

/// Begins a task; none where no thread can be started and no worker.
pub fn begin<T: Task>(ctx: &Context, scene: &Arc<Scene>, task: T) -> Option<Background<T::News>> {
    system::begin_task(ctx, scene, task)
}
