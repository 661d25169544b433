//! `rayscope trace`: the whole story of one pixel or ray, as text, data or drawing.

use super::drawn::{self, Theme, with_newline};
use super::failure::Failure;
use super::output::Output;
use super::profile_argument::ProfileArgument;
use super::scene_argument::{SceneArgument, SizeArguments};
use super::trace_drawing::TraceDrawing;
use crate::scene::Scene;
use crate::trace::{RayTree, TraceFile, record_pixel, record_ray};
use crate::view::{Drawing, tree_text};
use clap::{Args, ValueEnum};
use glam::DVec3;
use std::path::PathBuf;

/// Show everything that the ray of one pixel did
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope trace csg/bowl                                 the pixel that tells the scene's story best
  rayscope trace csg/bowl --pixel 320,240                 (0,0) is the top left pixel
  rayscope trace csg/bowl --ray 0,0,9,0,0,-1              a ray of your own: origin, direction
  rayscope trace csg/bowl --format json -o bowl.json      as data; `rayscope schema trace` describes it
  rayscope trace csg/bowl --format svg -o bowl.svg        the side view
  rayscope trace textures/filters --format png --drawing texture -o texels.png    the pixel on the texels")]
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
    #[command(flatten)]
    profile: ProfileArgument,
    /// What to write
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Which drawing an SVG or PNG shows [default: side]
    #[arg(long, value_enum)]
    drawing: Option<TraceDrawing>,
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
    /// A drawing as SVG
    Svg,
    /// A drawing as PNG
    Png,
}

impl Trace {
    /// Records the ray and writes it out.
    pub fn run(&self) -> Result<(), Failure> {
        if self.drawing.is_some() && matches!(self.format, Format::Text | Format::Json) {
            return Err(Failure::usage(
                "--drawing says what a picture shows, so it needs --format svg or --format png",
            ));
        }
        let scene = self.profile.apply(self.scene.load_sized(self.size)?)?;
        let output = Output::create(self.output.as_deref())?;
        if self.format == Format::Png {
            drawn::check_png_has_a_file(&output)?;
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
        check_pixel(scene, [x, y])?;
        Ok(record_pixel(scene, x, y))
    }

    fn written(&self, scene: &Scene, tree: &RayTree) -> Result<Vec<u8>, Failure> {
        match self.format {
            Format::Text => Ok(with_newline(tree_text(tree))),
            Format::Json => serde_json::to_string(&TraceFile::new(self.scene.name(), tree))
                .map(with_newline)
                .map_err(|error| Failure::refused(error.to_string())),
            Format::Svg => Ok(drawn::svg(&self.drawn(scene, tree)?)),
            Format::Png => Ok(drawn::png(&self.drawn(scene, tree)?)),
        }
    }

    fn drawn(&self, scene: &Scene, tree: &RayTree) -> Result<Drawing, Failure> {
        self.drawing.unwrap_or(TraceDrawing::Side).drawn(scene, tree, self.theme)
    }
}

/// Refuses a pixel that the scene's picture does not have.
pub fn check_pixel(scene: &Scene, [x, y]: [u32; 2]) -> Result<(), Failure> {
    let (width, height) = (scene.image.width, scene.image.height);
    if x < width && y < height {
        return Ok(());
    }
    Err(Failure::usage(format!(
        "pixel {x},{y} lies outside the picture of {width} × {height} pixels; the last one is {},{}",
        width - 1,
        height - 1
    )))
}

/// Column and row of a pixel.
pub fn pixel(text: &str) -> Result<[u32; 2], String> {
    let numbers: Option<Vec<u32>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    numbers
        .and_then(|numbers| numbers.try_into().ok())
        .ok_or_else(|| "expected a column and a row such as 320,240, counted from 0".to_owned())
}

/// Origin and direction of a ray.
pub fn ray(text: &str) -> Result<[DVec3; 2], String> {
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
