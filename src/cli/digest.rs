//! `rayscope digest`: what two machines, or two builds, are compared by.

use super::failure::Failure;
use super::output::Output;
use crate::scene::{embedded_scene, embedded_scenes, load};
use crate::trace::digests;
use clap::Args;
use std::fmt::Write;

/// Print digests of pictures and records, to compare machines
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope digest > here.txt        all scenes that come with the program
  rayscope digest csg/bowl optics/fishbowl --width 640

Equal lines mean equal bits. The first line of a scene is for its picture, the others are for the pixels that
tell its story, recorded in full. Records name lines of the source: compare builds of the same source.")]
pub struct Digest {
    /// Scenes that come with the program [default: all]
    #[arg(value_name = "SCENE")]
    scenes: Vec<String>,
    /// Columns of the pictures
    #[arg(long, value_name = "N", default_value_t = 120, value_parser = clap::value_parser!(u32).range(1..=4096))]
    width: u32,
}

impl Digest {
    /// Prints the digests.
    pub fn run(&self) -> Result<(), Failure> {
        let all = || embedded_scenes().into_iter().map(|scene| scene.name).collect();
        let names: Vec<String> = if self.scenes.is_empty() { all() } else { self.scenes.clone() };
        let mut text = String::new();
        for name in &names {
            let embedded = embedded_scene(name).ok_or_else(|| {
                Failure::usage(format!("no scene {name} comes with the program; `rayscope scenes` lists them"))
            })?;
            let scene = load(embedded.text, name).map_err(|errors| Failure::usage(errors.to_string()))?;
            for line in digests(name, &scene, self.width) {
                let _ = writeln!(text, "{line}");
            }
        }
        Output::Standard.write(text.as_bytes())
    }
}
