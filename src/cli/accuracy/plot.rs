//! `--plot`: error against seconds.

use super::super::drawn::{Ending, Theme};
use super::Findings;
use crate::laboratory::plot;
use crate::view::frontier_plot;
use std::path::{Path, PathBuf};

/// Plots are this large, in points.
const SIZE: [f64; 2] = [900.0, 640.0];

/// A file that a plot can be written to.
pub fn file(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    match path.extension().and_then(|ending| ending.to_str()) {
        Some("svg" | "png" | "pdf") => Ok(path),
        _ => Err("expected a file that ends in .svg, .png or .pdf".to_owned()),
    }
}

/// The bytes of the plot, as the file's ending says.
pub fn plotted(findings: &Findings, theme: Theme, path: &Path) -> Vec<u8> {
    let drawing = frontier_plot(&plot(&findings.run.study, findings.scene_name), SIZE, theme.into());
    Ending::of(Some(path)).bytes(findings.scene_name, &drawing)
}
