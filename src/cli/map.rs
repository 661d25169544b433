//! `rayscope map`: a quantity of every pixel, as a picture with a legend.

use super::drawn::{DrawingOutput, MAP_SIZE, Theme};
use super::failure::Failure;
use super::profile_argument::ProfileArgument;
use super::progress::{stopped_by_ctrl_c, with_bar};
use super::scene_argument::{SceneArgument, SizeArguments};
use crate::query::{Quantity, survey};
use crate::view::heat_map;
use clap::Args;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

/// Show a quantity of every pixel as a map
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope map optics/fishbowl --of rays -o rays.png       how many rays each pixel sends
  rayscope map csg/bowl --of tests -o tests.svg            how many tests they take
  rayscope map csg/bowl --of object -o objects.png         what is seen where
  rayscope map hard/far_torus --of digits --accuracy draft -o digits.png

`rayscope accuracy SCENE --map error` shows how far a picture is from a reference; --of error is the bound on the error
of the first hit's time.")]
pub struct Map {
    #[command(flatten)]
    scene: SceneArgument,
    /// What is mapped
    #[arg(long, value_name = "QUANTITY", value_parser = quantities())]
    of: String,
    #[command(flatten)]
    size: SizeArguments,
    #[command(flatten)]
    profile: ProfileArgument,
    /// Colours of the drawing
    #[arg(long, value_enum, default_value_t = Theme::Light)]
    theme: Theme,
    /// The file to write, .png, .svg or .pdf [default: SVG on the standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Map {
    /// Surveys the picture and draws the map.
    pub fn run(&self) -> Result<(), Failure> {
        let scene = Arc::new(self.profile.apply(self.scene.load_sized(self.size)?)?);
        let quantity = Quantity::ALL.into_iter().find(|quantity| quantity.name() == self.of);
        let quantity = quantity.ok_or_else(|| Failure::usage(format!("there is no quantity {}", self.of)))?;
        let output = DrawingOutput::create(self.output.as_deref())?;
        let progress = stopped_by_ctrl_c();
        let began = Instant::now();
        let work = quantity.work_per_pixel() * scene.image.width as usize * scene.image.height as usize;
        let known =
            with_bar(work, || progress.done(), || survey(&scene, quantity, 1, &|| began.elapsed(), &progress, |_| {}));
        let known = known.ok_or_else(|| Failure::interrupted("interrupted: nothing was written"))?;
        output.write(&scene.title, &heat_map(&known.map(&scene), MAP_SIZE, self.theme.into()))
    }
}

fn quantities() -> clap::builder::PossibleValuesParser {
    Quantity::ALL.map(Quantity::name).into()
}
