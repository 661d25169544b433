//! `rayscope` and `rayscope open`: the workbench.

use super::failure::Failure;
use super::scene_argument::SceneArgument;
use crate::share::link::{Link, LinkError};
use clap::Args;

/// Where the workbench starts when no scene is named.
const FIRST_SCENE: &str = "csg/bowl";

/// Open the workbench on a scene, or on what a link says
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope open csg/bowl
  rayscope open my-scene.json
  rayscope open 'rayscope:csg/bowl?pixel=310,240&event=57&preset=inspect'

The workbench makes links (Share, Copy link), and so does `rayscope trace … --format link`. A link opens the
scene, the pixel, the event, the layout and the colours again; a scene that does not come with the program
travels in the link as text. The same may stand behind the # of a web address.")]
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
        let link = self.link()?;
        // Behind a link's scene stands the first one, should it be one that cannot be opened.
        let scene = if link.is_some() { SceneArgument::named(FIRST_SCENE) } else { self.scene.clone() };
        crate::app::run(scene.name(), scene.text()?, self.scene.outside(), link).map_err(Failure::refused)
    }

    /// Says how to get the workbench.
    #[cfg(not(feature = "workbench"))]
    pub fn run(&self) -> Result<(), Failure> {
        self.link()?;
        Err(Failure::usage(format!(
            "this rayscope was built without the workbench; build it with `cargo build --release` (its default \
             features), or use `rayscope trace {}`",
            self.scene.name()
        )))
    }

    /// The link, if that is what was given.
    fn link(&self) -> Result<Option<Link>, Failure> {
        let text = self.scene.name();
        if !Link::looks_like_one(text) {
            return Ok(None);
        }
        text.parse().map(Some).map_err(|error: LinkError| Failure::usage(error.to_string()))
    }
}
