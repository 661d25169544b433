//! `rayscope scan`: texture scanning beside inverse scanning, as a drawing, counts or data.

use super::drawn::{self, Theme, with_newline};
use super::failure::Failure;
use super::output::Output;
use super::scene_argument::{SceneArgument, SizeArguments};
use crate::trace::{Scanning, srgb};
use crate::view::{Drawing, scan_drawing, scan_text};
use clap::{Args, ValueEnum};
use serde::Serialize;
use std::path::PathBuf;

/// The drawing's size in points.
const SIZE: [f64; 2] = [1120.0, 510.0];

/// More columns or rows could not be told apart in the drawing.
const LONGEST_SIDE: u32 = 400;

/// Bring the picture on a flat surface to the screen texel by texel, and pixel by pixel
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope scan textures/scanning                         how many holes and overlaps each order leaves
  rayscope scan textures/scanning --format png -o scan.png
  rayscope scan textures/image_map --object floor --columns 96 --format svg -o floor.svg
  rayscope scan textures/scanning --format json -o scan.json    how often each pixel was painted

Texture scanning carries each texel forward to a pixel; inverse scanning asks for each pixel where it
lies on the picture (§ 6.3.1). The surface is scanned alone and whole: what stands before it is left out.")]
pub struct Scan {
    #[command(flatten)]
    scene: SceneArgument,
    /// The object whose picture is scanned [default: the first that has one on a flat part]
    #[arg(long, value_name = "NAME")]
    object: Option<String>,
    /// The part of its surface, such as `top` [default: the first that is turned towards the eye]
    #[arg(long, value_name = "NAME")]
    part: Option<String>,
    /// Columns of the picture that is painted; few, so that each pixel can be seen
    #[arg(long, value_name = "N", default_value_t = 48, value_parser = clap::value_parser!(u32).range(1..=i64::from(LONGEST_SIDE)))]
    columns: u32,
    /// What to write
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Colours of the drawing
    #[arg(long, value_enum, default_value_t = Theme::Light)]
    theme: Theme,
    /// Where to write it [default: the standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// How many holes and overlaps there are
    Text,
    /// How often each pixel was painted, and in which colour
    Json,
    /// Both pictures as SVG
    Svg,
    /// Both pictures as PNG
    Png,
    /// Both pictures as PDF
    Pdf,
}

/// Both scans as data.
#[derive(Serialize)]
struct Written<'a> {
    scene: &'a str,
    object: &'a str,
    part: &'a str,
    /// Columns and rows of the picture on the surface.
    texels: [u32; 2],
    /// Columns and rows of the picture that is painted.
    pixels: [u32; 2],
    /// Pixels whose middle the picture on the surface covers.
    covered: usize,
    forward: Order<'a>,
    inverse: Order<'a>,
}

/// One order.
#[derive(Serialize)]
struct Order<'a> {
    /// Covered pixels that were not painted.
    holes: usize,
    /// Pixels that were painted more than once.
    overlaps: usize,
    /// How often each pixel was painted, row by row from the top.
    painted: &'a [u32],
    /// The sRGB colour of each, likewise; black where none was painted.
    colours: Vec<[u8; 3]>,
}

impl Scan {
    /// Scans in both orders and writes what came of it.
    pub fn run(&self) -> Result<(), Failure> {
        let scene = self.scene.load()?;
        let output = Output::create(self.output.as_deref())?;
        match self.format {
            Format::Png => drawn::check_has_a_file(&output, "a PNG")?,
            Format::Pdf => drawn::check_has_a_file(&output, "a PDF")?,
            Format::Text | Format::Json | Format::Svg => {}
        }
        let size = SizeArguments::of_width(Some(self.columns)).apply(scene.image)?;
        if size.height > LONGEST_SIDE {
            let problem = format!("{} columns of this scene's picture have {} rows", self.columns, size.height);
            return Err(Failure::usage(format!(
                "{problem}; at most {LONGEST_SIDE} can be drawn: give fewer --columns"
            )));
        }
        let scanning = Scanning::new(&scene, size, self.object.as_deref(), self.part.as_deref())
            .map_err(|problem| Failure::usage(format!("{}: {problem}", self.scene.name())))?;
        output.write(&self.written(&scanning)?)
    }

    fn written(&self, scanning: &Scanning) -> Result<Vec<u8>, Failure> {
        match self.format {
            Format::Text => Ok(with_newline(scan_text(scanning))),
            Format::Json => serde_json::to_string(&Written::new(self.scene.name(), scanning))
                .map(with_newline)
                .map_err(|error| Failure::refused(error.to_string())),
            Format::Svg => Ok(drawn::svg(&self.drawing(scanning))),
            Format::Png => Ok(drawn::png(&self.drawing(scanning))),
            Format::Pdf => Ok(drawn::pdf(self.scene.name(), &self.drawing(scanning))),
        }
    }

    fn drawing(&self, scanning: &Scanning) -> Drawing {
        scan_drawing(scanning, SIZE, self.theme.into())
    }
}

impl<'a> Written<'a> {
    fn new(scene: &'a str, scanning: &'a Scanning) -> Self {
        let order = |scan: &'a crate::texture::image::Scan| Order {
            holes: scan.holes(&scanning.inverse),
            overlaps: scan.overlaps(),
            painted: &scan.painted,
            colours: scan.colours.iter().map(|colour| srgb(*colour)).collect(),
        };
        Self {
            scene,
            object: &scanning.object,
            part: &scanning.part,
            texels: scanning.texels,
            pixels: scanning.pixels,
            covered: scanning.covered(),
            forward: order(&scanning.forward),
            inverse: order(&scanning.inverse),
        }
    }
}
