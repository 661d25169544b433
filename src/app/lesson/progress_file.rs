//! What a student has done, as a file: written out and read in when asked for.

use crate::app::frame::background::Background;
use crate::lesson::Progress;
use egui::Context;
use std::path::{Path, PathBuf};

/// The name that is offered for the file.
const NAME: &str = "rayscope-progress.json";

/// What came of it.
pub enum Exchange {
    /// It was written there.
    Written(PathBuf),
    /// It was read.
    Read(Progress),
    /// The dialogue was closed.
    Given,
    /// Why not.
    Failed(String),
}

/// Asks where to, and writes.
pub fn export(ctx: &Context, progress: &Progress) -> Option<Background<Exchange>> {
    let text = progress.to_json();
    Background::start(ctx, "progress", move |_, publish| {
        let path = rfd::FileDialog::new().set_file_name(NAME).add_filter("JSON", &["json"]).save_file();
        publish(path.map_or(Exchange::Given, |path| write(&path, &text)));
    })
}

/// Asks what from, and reads.
pub fn import(ctx: &Context) -> Option<Background<Exchange>> {
    Background::start(ctx, "progress", |_, publish| {
        let path = rfd::FileDialog::new().add_filter("JSON", &["json"]).pick_file();
        publish(path.map_or(Exchange::Given, |path| read(&path)));
    })
}

/// Writes what was done to a file.
pub fn write(path: &Path, text: &str) -> Exchange {
    match std::fs::write(path, text) {
        Ok(()) => Exchange::Written(path.to_owned()),
        Err(error) => Exchange::Failed(format!("{}: {error}", path.display())),
    }
}

/// Reads what was done from a file.
pub fn read(path: &Path) -> Exchange {
    let text = std::fs::read_to_string(path).map_err(|error| error.to_string());
    match text.and_then(|text| Progress::read(&text)) {
        Ok(progress) => Exchange::Read(progress),
        Err(error) => Exchange::Failed(format!("{}: {error}", path.display())),
    }
}
