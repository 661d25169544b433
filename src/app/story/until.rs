//! The search for the next pixel at which a breakpoint stops, as work that can be sent away.

use crate::app::frame::task::Task;
use crate::query::Query;
use crate::scene::Scene;
use crate::story::next_pixel;
use crate::trace::Progress;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// To go through the pixels after this one to the first at which a question holds.
#[derive(Serialize, Deserialize)]
pub struct Until {
    /// The pixel.
    pub from: [u32; 2],
    /// The questions.
    pub questions: Vec<Query>,
}

impl Task for Until {
    const NAME: &'static str = "until";
    type News = Option<[u32; 2]>;

    fn run(self, scene: &Arc<Scene>, progress: &Progress, publish: &mut dyn FnMut(Self::News)) {
        publish(next_pixel(scene, self.from, &self.questions, progress));
    }
}
