//! `rayscope` and `rayscope open`: the workbench.

use super::failure::Failure;
use super::scene_argument::SceneArgument;
use clap::Args;

/// Where the workbench starts when no scene is named.
const FIRST_SCENE: &str = "csg/bowl";

/// Open the workbench on a scene
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope open csg/bowl
  rayscope open my-scene.json")]
pub struct Open {
    #[command(flatten)]
    scene: SceneArgument,
}

impl Default for Open {
    fn default() -> Self {
        Self { scene: SceneArgument::named(FIRST_SCENE) }
    }
}

impl Open {
    /// Runs the workbench until its window is closed.
    #[cfg(feature = "workbench")]
    pub fn run(&self) -> Result<(), Failure> {
        crate::app::run(self.scene.name(), self.scene.text()?, self.scene.outside()).map_err(Failure::refused)
    }

    /// Says how to get the workbench.
    #[cfg(not(feature = "workbench"))]
    pub fn run(&self) -> Result<(), Failure> {
        Err(Failure::usage(format!(
            "this rayscope was built without the workbench; build it with `cargo build --release` (its default \
             features), or use `rayscope trace {}`",
            self.scene.name()
        )))
    }
}
