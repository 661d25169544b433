//! Formulas: LaTeX laid out as TeX does it, for the screen, for pages and for print.
//!
//! RaTeX parses and lays out; here its letters and rules become outlines, which drawings, SVG and pixels share. Everything is
//! measured in em, the size of the text around, with x to the right and y down from the baseline.

mod laid_out;
mod letters;
mod svg;
#[cfg(test)]
mod tests;
mod words;

pub use letters::FONTS_IN_BROWSERS;
pub use svg::SharedLetters;

use super::drawing::{Form, Frame, Spot};
use super::outline::{Pen, frame_of, rectangle};
use super::paint::stamped;
use super::palette::Colour;
use letters::Letter;
use std::fmt;

/// A formula that is laid out.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// How wide it is, in em.
    pub width: f64,
    /// How far it rises above the baseline, in em.
    pub height: f64,
    /// How far it goes below the baseline, in em.
    pub depth: f64,
    /// It in words: `d of t equals (S plus c t) squared`.
    pub words: String,
    parts: Vec<Part>,
}

/// A piece of a formula.
#[derive(Clone, Debug, PartialEq)]
enum Part {
    /// A letter of that size with its origin at a place.
    Letter { letter: Letter, at: Spot, size: f64 },
    /// A line of a fraction, a root, a table.
    Rule(Frame),
    /// Anything else: the arrows and braces that grow with what they span.
    Area(Vec<Pen>),
}

/// Why a formula cannot be set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FormulaError {
    /// What is wrong.
    pub message: String,
    /// The byte of the LaTeX text where it was noticed, where that is known.
    pub at: Option<usize>,
}

impl fmt::Display for FormulaError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.at {
            Some(at) => write!(f, "{} (at character {} of the formula)", self.message, at + 1),
            None => f.write_str(&self.message),
        }
    }
}

impl std::error::Error for FormulaError {}

/// A formula in pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FormulaPixels {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// The rows above the baseline.
    pub baseline: u32,
    /// Red, green, blue and alpha for each pixel, row by row, the colours already multiplied with alpha.
    pub rgba: Vec<u8>,
}

impl Formula {
    /// Sets a formula, in a line of its own or within running text.
    ///
    /// # Errors
    /// If the text is no LaTeX that can be set, with the place where that is known.
    pub fn typeset(latex: &str, display: bool) -> Result<Self, FormulaError> {
        let nodes = laid_out::parsed(latex)?;
        let words = words::of(&nodes);
        let (parts, [width, height, depth]) = laid_out::parts(latex, &nodes, display)?;
        Ok(Self { width, height, depth, words, parts }.holding_its_ink())
    }

    /// Slanted letters lean out of their boxes. The formula's own box holds them, so that nothing is cut off.
    fn holding_its_ink(mut self) -> Self {
        let frames = self.parts.iter().filter_map(|part| frame_of(&part.outline()));
        let mut ink = Frame { low: [0.0, -self.height], high: [self.width, self.depth] };
        for frame in frames {
            ink.low = std::array::from_fn(|i| ink.low[i].min(frame.low[i]));
            ink.high = std::array::from_fn(|i| ink.high[i].max(frame.high[i]));
        }
        let left = ink.low[0];
        if left < 0.0 {
            for part in &mut self.parts {
                part.shift(-left);
            }
        }
        Self { width: ink.high[0] - left, height: -ink.low[1], depth: ink.high[1], ..self }
    }

    /// The outlines of all that is drawn, to be filled by winding one by one.
    pub fn outlines(&self) -> impl Iterator<Item = Vec<Pen>> + '_ {
        self.parts.iter().map(Part::outline).filter(|outline| !outline.is_empty())
    }

    /// The formula as marks of a drawing, with the left end of its baseline at `at` and an em of that many points.
    #[must_use]
    pub fn marks(&self, at: Spot, em: f64, fill: Colour) -> Vec<Form> {
        let place = |spot: Spot| [at[0] + spot[0] * em, at[1] + spot[1] * em];
        let placed = |outline: Vec<Pen>| outline.into_iter().map(|step| step.moved(place)).collect();
        self.outlines().map(|outline| Form::Outline { steps: placed(outline), fill }).collect()
    }

    /// The formula in pixels, with an em of that many pixels. Nothing is drawn beyond a size that no screen has.
    #[must_use]
    pub fn pixels(&self, em: f32, colour: Colour) -> FormulaPixels {
        let em = if em.is_finite() { f64::from(em).clamp(1.0, 512.0) } else { 16.0 };
        let baseline = (self.height * em).ceil();
        let size = [(self.width * em).ceil(), baseline + (self.depth * em).ceil()];
        let place = |spot: Spot| [spot[0] * em, baseline + spot[1] * em];
        let outlines: Vec<Vec<Pen>> =
            self.outlines().map(|outline| outline.into_iter().map(|step| step.moved(place)).collect()).collect();
        let (pixels, baseline) = stamped(size, baseline, &outlines, colour);
        FormulaPixels { width: pixels.width, height: pixels.height, baseline, rgba: pixels.rgba }
    }
}

impl Part {
    fn outline(&self) -> Vec<Pen> {
        match self {
            Self::Letter { letter, at, size } => {
                let unit = size / 1000.0;
                let place = |spot: Spot| [at[0] + spot[0] * unit, at[1] - spot[1] * unit];
                letter.outline().into_iter().map(|step| step.moved(place)).collect()
            }
            Self::Rule(frame) => rectangle(*frame).to_vec(),
            Self::Area(steps) => steps.clone(),
        }
    }

    fn shift(&mut self, by: f64) {
        match self {
            Self::Letter { at, .. } => at[0] += by,
            Self::Rule(frame) => {
                frame.low[0] += by;
                frame.high[0] += by;
            }
            Self::Area(steps) => steps.iter_mut().for_each(|step| *step = step.moved(|[x, y]| [x + by, y])),
        }
    }
}

/// A formula in words, for whoever hears it; of one that cannot be set, the LaTeX itself.
#[must_use]
pub fn in_words(latex: &str) -> String {
    laid_out::parsed(latex).map_or_else(|_| latex.to_owned(), |nodes| words::of(&nodes))
}
