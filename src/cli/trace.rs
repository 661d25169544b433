//! `rayscope trace`: the whole story of one pixel or ray, as text, data or drawing.

use super::failure::Failure;
use super::output::Output;
use super::scene_argument::{SceneArgument, SizeArguments};
use crate::scene::Scene;
use crate::trace::{RayTree, TraceFile, record_pixel, record_ray};
use crate::view::{self, SectionPlane, SideViewOptions};
use clap::{Args, ValueEnum};
use glam::DVec3;
use std::path::PathBuf;

/// Drawings are this large, in points, and PNGs have two pixels a point.
const DRAWING_SIZE: [f64; 2] = [960.0, 600.0];
const PIXELS_PER_POINT: f32 = 2.0;

/// Show everything that the ray of one pixel did
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope trace csg/bowl                                 the pixel that tells the scene's story best
  rayscope trace csg/bowl --pixel 320,240                 (0,0) is the top left pixel
  rayscope trace csg/bowl --ray 0,0,9,0,0,-1              a ray of your own: origin, direction
  rayscope trace csg/bowl --format json -o bowl.json      as data; `rayscope schema trace` describes it
  rayscope trace csg/bowl --format svg -o bowl.svg        the side view")]
pub struct Trace {
    #[command(flatten)]
    scene: SceneArgument,
    /// The pixel, counted from 0 at the top left
    #[arg(long, value_name = "X,Y", value_parser = pixel, conflicts_with = "ray")]
    pixel: Option<[u32; 2]>,
    /// A ray instead of a pixel: origin and direction; the direction's length is the unit of t
    #[arg(long, value_name = "OX,OY,OZ,DX,DY,DZ", value_parser = ray, allow_hyphen_values = true)]
    ray: Option<[DVec3; 2]>,
    #[command(flatten)]
    size: SizeArguments,
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
    /// The tree of events with the working behind every number
    Text,
    /// The same as JSON
    Json,
    /// The side view as SVG
    Svg,
    /// The side view as PNG
    Png,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Theme {
    /// Dark on white
    Light,
    /// Light on black
    Dark,
}

impl Trace {
    /// Records the ray and writes it out.
    pub fn run(&self) -> Result<(), Failure> {
        let scene = self.scene.load_sized(self.size)?;
        let output = Output::create(self.output.as_deref())?;
        if self.format == Format::Png && output.is_terminal() {
            return Err(Failure::usage("a PNG is no text for a terminal; name a file with -o"));
        }
        let tree = self.record(&scene)?;
        output.write(&self.written(&scene, &tree)?)
    }

    fn record(&self, scene: &Scene) -> Result<RayTree, Failure> {
        if let Some([origin, direction]) = self.ray {
            return Ok(record_ray(scene, origin, direction));
        }
        let (width, height) = (scene.image.width, scene.image.height);
        let telling = scene.pixels.first().copied().unwrap_or([width / 2, height / 2]);
        let [x, y] = self.pixel.unwrap_or(telling);
        if x >= width || y >= height {
            return Err(Failure::usage(format!(
                "pixel {x},{y} lies outside the picture of {width} × {height} pixels; the last one is {},{}",
                width - 1,
                height - 1
            )));
        }
        Ok(record_pixel(scene, x, y))
    }

    fn written(&self, scene: &Scene, tree: &RayTree) -> Result<Vec<u8>, Failure> {
        match self.format {
            Format::Text => Ok(with_newline(view::tree_text(tree))),
            Format::Json => serde_json::to_string(&TraceFile::new(self.scene.name(), tree))
                .map(with_newline)
                .map_err(|error| Failure::refused(error.to_string())),
            Format::Svg => Ok(with_newline(view::svg(&self.drawing(scene, tree)))),
            Format::Png => Ok(view::png(&self.drawing(scene, tree), PIXELS_PER_POINT)),
        }
    }

    /// The side view with everything that happened up to the last event.
    fn drawing(&self, scene: &Scene, tree: &RayTree) -> view::Drawing {
        let options = SideViewOptions {
            size: DRAWING_SIZE,
            theme: match self.theme {
                Theme::Light => view::Theme::Light,
                Theme::Dark => view::Theme::Dark,
            },
            plane: SectionPlane::RayAndUp,
            zoom: 1.0,
            pan: [0.0, 0.0],
        };
        view::side_view(scene, tree, tree.end().saturating_sub(1), &options)
    }
}

fn with_newline(mut text: String) -> Vec<u8> {
    if !text.ends_with('\n') {
        text.push('\n');
    }
    text.into_bytes()
}

fn pixel(text: &str) -> Result<[u32; 2], String> {
    let numbers: Option<Vec<u32>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    numbers
        .and_then(|numbers| numbers.try_into().ok())
        .ok_or_else(|| "expected a column and a row such as 320,240, counted from 0".to_owned())
}

fn ray(text: &str) -> Result<[DVec3; 2], String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    let numbers: [f64; 6] = numbers
        .and_then(|numbers| numbers.try_into().ok())
        .ok_or("expected six numbers, origin and direction, such as 0,0,9,0,0,-1")?;
    if numbers.iter().any(|number| !number.is_finite()) {
        return Err("every number has to be finite".to_owned());
    }
    let [ox, oy, oz, dx, dy, dz] = numbers;
    let direction = DVec3::new(dx, dy, dz);
    if direction == DVec3::ZERO {
        return Err("the direction has no length, so it leads nowhere".to_owned());
    }
    Ok([DVec3::new(ox, oy, oz), direction])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_is_a_column_and_a_row() {
        assert_eq!(pixel("320,240"), Ok([320, 240]));
        assert_eq!(pixel(" 0 , 7 "), Ok([0, 7]));
        for wrong in ["", "3", "3,4,5", "-1,2", "1.5,2", "x,y", "99999999999,0"] {
            assert!(pixel(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_ray_is_an_origin_and_a_direction_that_leads_somewhere() {
        assert_eq!(ray("0,0,9,0,0,-1"), Ok([DVec3::new(0.0, 0.0, 9.0), DVec3::NEG_Z]));
        for wrong in ["", "0,0,9", "0,0,9,0,0,0", "0,0,9,0,0,NaN", "inf,0,0,0,0,1", "0,0,9,0,0,-1,4"] {
            assert!(ray(wrong).is_err(), "{wrong}");
        }
    }
}
