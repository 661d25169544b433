//! Stories that are kept to be compared with.

use crate::app::story::recording::Recording;
use crate::app::workbench::OpenScene;
use crate::scene::Scene;
use crate::trace::RayTree;
use std::sync::Arc;

/// A story that is kept as it was when it was pinned.
#[derive(Clone, Debug)]
pub struct Pin {
    /// What it is called.
    pub name: String,
    /// The scene as it was.
    pub scene: Arc<Scene>,
    /// The pixel.
    pub pixel: [u32; 2],
    /// What happened.
    pub tree: Arc<RayTree>,
}

impl Pin {
    /// The story that is shown.
    pub fn of(recording: &Recording, open: &OpenScene) -> Self {
        let [x, y] = recording.pixel;
        let look = open.look.as_ref().map_or_else(String::new, |look| format!(", {}", look.name));
        Self {
            name: format!("{} ({x}, {y}){look}", open.name),
            scene: Arc::clone(&recording.scene),
            pixel: recording.pixel,
            tree: Arc::clone(&recording.tree),
        }
    }

    /// The same story to be shown.
    pub fn recording(&self) -> Recording {
        Recording::of_tree(Arc::clone(&self.scene), self.pixel, Arc::clone(&self.tree), None)
    }

    /// Whether it is this very story.
    pub fn is(&self, tree: &Arc<RayTree>) -> bool {
        Arc::ptr_eq(&self.tree, tree)
    }
}
