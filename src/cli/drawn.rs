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
    /// Black and deep colours on white
    LightContrast,
    /// White and pale colours on black
    DarkContrast,
}

impl From<Theme> for view::Theme {
    fn from(theme: Theme) -> Self {
        match theme {
            Theme::Light => Self::Light,
            Theme::Dark => Self::Dark,
            Theme::LightContrast => Self::LightContrast,
            Theme::DarkContrast => Self::DarkContrast,
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

/// What a drawing is written as, where the ending of a file says so.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// `.svg`, and every ending that is none of the others
    Svg,
    /// `.png`
    Png,
    /// `.pdf`
    Pdf,
}

impl Ending {
    /// The ending of a file; the standard output has none.
    pub fn of(path: Option<&Path>) -> Self {
        match path.and_then(Path::extension).and_then(|ending| ending.to_str()) {
            Some("png") => Self::Png,
            Some("pdf") => Self::Pdf,
            _ => Self::Svg,
        }
    }

    /// The bytes of the file.
    pub fn bytes(self, title: &str, drawing: &Drawing) -> Vec<u8> {
        match self {
            Self::Svg => svg(drawing),
            Self::Png => png(drawing),
            Self::Pdf => pdf(title, drawing),
        }
    }
}

/// The bytes of a PDF file with one page.
pub fn pdf(title: &str, drawing: &Drawing) -> Vec<u8> {
    view::pdf(title, std::slice::from_ref(drawing))
}

/// Refuses to fill a terminal with the bytes of `what`, such as a PNG.
pub fn check_has_a_file(output: &Output, what: &str) -> Result<(), Failure> {
    if output.is_terminal() {
        return Err(Failure::usage(format!("{what} is no text for a terminal; name a file with -o")));
    }
    Ok(())
}

/// Where one drawing goes, as what the ending of the file says.
pub struct DrawingOutput {
    output: Output,
    ending: Ending,
}

impl DrawingOutput {
    /// Opens it, so that a wrong path is found out before the work begins.
    pub fn create(path: Option<&Path>) -> Result<Self, Failure> {
        Ok(Self { output: Output::create(path)?, ending: Ending::of(path) })
    }

    /// Writes the drawing.
    pub fn write(self, title: &str, drawing: &Drawing) -> Result<(), Failure> {
        self.output.write(&self.ending.bytes(title, drawing))
    }
}

/// A text that ends its last line.
pub fn with_newline(mut text: String) -> Vec<u8> {
    if !text.ends_with('\n') {
        text.push('\n');
    }
    text.into_bytes()
}
