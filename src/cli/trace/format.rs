//! What a trace can be written as.

use crate::cli::failure::Failure;
use clap::ValueEnum;

/// A format of a trace.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// The tree of events with the working behind every number
    Text,
    /// The same as JSON
    Json,
    /// A drawing as SVG
    Svg,
    /// A drawing as PNG
    Png,
    /// Drawings as PDF, one on each page
    Pdf,
    /// A worked example as Markdown, with its drawings as SVG files beside it
    Markdown,
    /// Slides for a browser, one for each step: one file that needs no network
    Slides,
    /// Slides as PDF, one page for each step
    SlidesPdf,
    /// The steps as a moving picture of 960 × 540 pixels in 256 colours
    Gif,
    /// The steps as a moving picture of 960 × 540 pixels in all colours (animated PNG)
    Apng,
    /// A link that opens the same in the workbench
    Link,
}

impl Format {
    /// Whether it shows drawings.
    pub const fn has_drawings(self) -> bool {
        !matches!(self, Self::Text | Self::Json | Self::Link)
    }

    /// Whether it goes through the ray step by step.
    pub const fn has_steps(self) -> bool {
        matches!(self, Self::Markdown | Self::Slides | Self::SlidesPdf | Self::Gif | Self::Apng)
    }

    /// Whether it is one drawing and no more.
    pub const fn is_one_drawing(self) -> bool {
        matches!(self, Self::Svg | Self::Png)
    }

    /// Whether it moves.
    pub const fn moves(self) -> bool {
        matches!(self, Self::Gif | Self::Apng)
    }

    /// What a terminal cannot show of it.
    pub const fn binary(self) -> Option<&'static str> {
        match self {
            Self::Png | Self::Apng => Some("a PNG"),
            Self::Pdf | Self::SlidesPdf => Some("a PDF"),
            Self::Gif => Some("a GIF"),
            _ => None,
        }
    }

    /// Refuses options that mean nothing for it.
    pub fn check(self, asked: &Asked) -> Result<(), Failure> {
        let refuse = |message: &str| Err(Failure::usage(message));
        if asked.views > 0 && !self.has_drawings() {
            return refuse(
                "--view says what a picture shows, so it needs a format with pictures: --format svg or --format png, pdf, \
                 markdown, slides, slides-pdf, gif or apng",
            );
        }
        if asked.views > 1 && self.is_one_drawing() {
            return refuse("one file of this format holds one drawing; name one --view, or take --format pdf");
        }
        if asked.level && !self.has_steps() {
            return refuse(
                "--level says which steps are told, so it needs --format markdown, slides, slides-pdf, gif or apng",
            );
        }
        if asked.seconds && !self.moves() {
            return refuse("--seconds says how long a step is shown, so it needs --format gif or --format apng");
        }
        if asked.event && (self.has_steps() || matches!(self, Self::Text | Self::Json)) {
            return refuse("--event says what a drawing is about, so it needs --format svg, png, pdf or link");
        }
        Ok(())
    }
}

/// Which options were given.
pub struct Asked {
    /// How many views.
    pub views: usize,
    /// Whether a level.
    pub level: bool,
    /// Whether a time.
    pub seconds: bool,
    /// Whether an event.
    pub event: bool,
}
