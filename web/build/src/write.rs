//! Writes the pages into a folder.

use crate::pack::Packed;
use std::path::Path;

/// Names the folder as one that a build wrote, so that the next may replace it; and tells the sizes.
const SIZES: &str = "sizes.txt";

/// For hosts that take headers from a file; the name is one that none takes unasked.
const HEADERS: &str = include_str!("../headers.example");

/// Whether the folder may be written to: it is not there, or empty, or left by an earlier build.
pub fn check(out: &Path) -> Result<(), String> {
    let is_empty = std::fs::read_dir(out).map_or(true, |mut entries| entries.next().is_none());
    if is_empty && !out.is_file() || out.join(SIZES).is_file() {
        return Ok(());
    }
    Err(format!(
        "{} holds something that no earlier build wrote, and would be replaced: name another folder with -o, or empty it",
        out.display()
    ))
}

/// Writes all files with their variants.
pub fn write(out: &Path, files: &[Packed]) -> Result<(), String> {
    if out.is_dir() {
        std::fs::remove_dir_all(out).map_err(|error| format!("{} cannot be replaced: {error}", out.display()))?;
    }
    for packed in files {
        let path = out.join(&packed.named.file.path);
        write_one(&path, &packed.named.file.bytes)?;
        for (end, variant) in [("gz", &packed.gzip), ("br", &packed.brotli)] {
            if let Some(variant) = variant {
                let mut name = path.clone().into_os_string();
                name.push(format!(".{end}"));
                write_one(Path::new(&name), variant)?;
            }
        }
    }
    write_one(&out.join("headers.example"), HEADERS.as_bytes())
}

/// Writes the table of sizes, last: where it is, all of the build is.
pub fn finish(out: &Path, table: &str) -> Result<(), String> {
    write_one(&out.join(SIZES), table.as_bytes())
}

fn write_one(path: &Path, bytes: &[u8]) -> Result<(), String> {
    let told = |error: std::io::Error| format!("{} cannot be written: {error}", path.display());
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(told)?;
    }
    std::fs::write(path, bytes).map_err(told)
}
