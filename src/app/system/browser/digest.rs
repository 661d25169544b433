//! Digests from a worker: what browsers are held to the desktop by.

use crate::app::frame::task::Task;
use crate::scene::Scene;
use crate::trace::{Progress, digests};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// To work out the digests of a scene.
#[derive(Serialize, Deserialize)]
pub struct Digests {
    /// The columns of its picture.
    pub width: u32,
}

impl Task for Digests {
    const NAME: &'static str = "digests";
    type News = Vec<String>;

    fn run(self, scene: &Arc<Scene>, _progress: &Progress, publish: &mut dyn FnMut(Vec<String>)) {
        publish(digests(&scene.recipe().name, scene, self.width));
    }
}
