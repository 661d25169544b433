//! Drawings as files: the theme that is asked for, and the bytes.

use super::failure::Failure;
use super::output::Output;
use crate::view::{self, Drawing};
use clap::ValueEnum;
use std::path::Path;

/// Maps are this large, in points.
pub const MAP_SIZE: [f64; 2] = [900.0, 560.0];

/// PNGs have two pixels a point.
const PIXELS_PER_POINT: f32 = 2.0;

/// Colours of drawings.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Theme {
    /// Dark on white
    Light,
    /// Light on black
    Dark,
}

impl From<Theme> for view::Theme {
    fn from(theme: Theme) -> Self {
        match theme {
            Theme::Light => Self::Light,
            Theme::Dark => Self::Dark,
        }
    }
}

/// The bytes of an SVG file.
pub fn svg(drawing: &Drawing) -> Vec<u8> {
    with_newline(view::svg(drawing))
}

/// The bytes of a PNG file.
pub fn png(drawing: &Drawing) -> Vec<u8> {
    view::png(drawing, PIXELS_PER_POINT)
}

/// Refuses to fill a terminal with the bytes of a PNG.
pub fn check_png_has_a_file(output: &Output) -> Result<(), Failure> {
    if output.is_terminal() {
        return Err(Failure::usage("a PNG is no text for a terminal; name a file with -o"));
    }
    Ok(())
}

/// Where one drawing goes: a PNG where the name of the file ends so, else an SVG.
pub struct DrawingOutput {
    output: Output,
    is_png: bool,
}

impl DrawingOutput {
    /// Opens it, so that a wrong path is found out before the work begins.
    pub fn create(path: Option<&Path>) -> Result<Self, Failure> {
        let is_png = path.and_then(Path::extension).is_some_and(|ending| ending == "png");
        Ok(Self { output: Output::create(path)?, is_png })
    }

    /// Writes the drawing.
    pub fn write(self, drawing: &Drawing) -> Result<(), Failure> {
        self.output.write(&if self.is_png { png(drawing) } else { svg(drawing) })
    }
}

/// A text that ends its last line.
pub fn with_newline(mut text: String) -> Vec<u8> {
    if !text.ends_with('\n') {
        text.push('\n');
    }
    text.into_bytes()
}
