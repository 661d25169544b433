//! A worked example and the drawings beside it.

use super::told::Told;
use crate::cli::failure::{Failure, reason};
use crate::cli::output::Output;
use std::fs;
use std::path::{Path, PathBuf};

/// What the Markdown is called in a folder of its own.
const NAME: &str = "trace.md";

/// Writes the Markdown to a file and the drawings beside it; to the standard output the Markdown alone, with the drawings in
/// words.
pub fn write(told: &Told, output: Option<&Path>) -> Result<(), Failure> {
    let Some(path) = output.filter(|path| *path != Path::new("-")) else {
        return Output::create(None)?.write(told.paper(None)?.text.as_bytes());
    };
    let path = file_in(path)?;
    let markdown = Output::create(Some(&path))?;
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    // The names stand within Markdown, where spaces and brackets would end a link.
    let stem: String = stem.chars().map(|c| if c.is_alphanumeric() || "-_".contains(c) { c } else { '-' }).collect();
    let paper = told.paper(Some(&stem))?;
    for (name, svg) in &paper.figures {
        Output::create(Some(&path.with_file_name(name)))?.write(svg.as_bytes())?;
    }
    markdown.write(paper.text.as_bytes())
}

/// The file itself, or `trace.md` in a folder, which is made if the path says that it is one.
fn file_in(path: &Path) -> Result<PathBuf, Failure> {
    let says_folder = path.as_os_str().to_string_lossy().ends_with(std::path::is_separator);
    if says_folder {
        fs::create_dir_all(path).map_err(|error| {
            Failure::refused(format!("cannot make the folder {}: {}", path.display(), reason(&error)))
        })?;
    }
    Ok(if path.is_dir() { path.join(NAME) } else { path.to_owned() })
}
