//! `rayscope export`: a scene in another program's language.

use super::failure::Failure;
use super::output::Output;
use super::scene_argument::SceneArgument;
use crate::peer::to_povray;
use clap::Args;
use std::path::PathBuf;

/// Write a scene in the language of another program
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope export --povray csg/bowl -o bowl.pov
  povray +Ibowl.pov +W640 +H480

Every number is written with all of its digits. A scene that POV-Ray's language cannot say (coloured
highlights, transparent objects that may overlap, a torus whose tube overlaps itself) is refused
with the reason, and nothing is written.

One thing looks different for transparent objects: where all light is reflected POV-Ray gives it the
weight 1, not reflectivity + transparency.")]
pub struct Export {
    /// In POV-Ray 3.7's scene description language
    #[arg(long, required = true)]
    povray: bool,
    #[command(flatten)]
    scene: SceneArgument,
    /// Where to write it [default: the standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Export {
    /// Translates and writes.
    pub fn run(&self) -> Result<(), Failure> {
        let scene = self.scene.load()?;
        let output = Output::create(self.output.as_deref())?;
        let text = to_povray(&scene).map_err(|message| {
            Failure::refused(format!("the scene {} cannot be said in POV-Ray's language: {message}", self.scene.name()))
        })?;
        output.write(text.as_bytes())
    }
}
