//! What a student has done, as a file: written out and read in when asked for.

use crate::app::frame::background::Background;
use crate::app::frame::words::say;
use crate::app::system::{self, NoDialogue, Picked};
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
    let missing = say(ctx, "file-no-dialogue-to-save");
    Background::start(ctx, "progress", move |_, publish| {
        publish(match system::ask_where(None, NAME, "json") {
            Ok(Some(path)) => write(&path, &text),
            Ok(None) => Exchange::Given,
            Err(NoDialogue) => Exchange::Failed(missing),
        });
    })
}

/// Writes what was done to a file.
pub fn write(path: &Path, text: &str) -> Exchange {
    match system::write_whole(path, text.as_bytes()) {
        Ok(()) => Exchange::Written(path.to_owned()),
        Err(error) => Exchange::Failed(format!("{}: {error}", path.display())),
    }
}

/// Reads what was done from a file.
pub fn read(picked: &Picked) -> Exchange {
    match picked.whole().and_then(|text| Progress::read(&text)) {
        Ok(progress) => Exchange::Read(progress),
        Err(error) => Exchange::Failed(format!("{}: {error}", picked.name)),
    }
}
