//! Files in a browser: chosen by a person one by one, and written as downloads.

use super::host;
use crate::app::system::{NoDialogue, Picked};
use egui::{Context, DroppedFileHandle};
use std::io;
use std::path::{Path, PathBuf};

/// A browser asks by itself, or has a folder for what is downloaded: the name is all that can be said.
///
/// # Errors
/// None.
#[expect(clippy::unnecessary_wraps, reason = "on a desktop the dialogue can be closed, or there may be none")]
pub fn ask_where(_title: Option<String>, name: &str, _ending: &str) -> Result<Option<PathBuf>, NoDialogue> {
    Ok(Some(PathBuf::from(name)))
}

/// Lets a person choose a file; `given` is called with it. If none is chosen, nothing is called.
pub fn ask_which(
    _title: String,
    _kind: String,
    endings: &'static [&'static str],
    given: impl FnOnce(Option<Picked>) + 'static,
) -> bool {
    let accept: Vec<String> = endings.iter().map(|ending| format!(".{ending}")).collect();
    host::open(&accept.join(","), move |name, bytes| given(Some(Picked::read(name, Ok(bytes)))));
    true
}

/// Reads a file that was dropped on the page.
pub fn read_dropped(ctx: &Context, file: &DroppedFileHandle, given: impl FnOnce(Picked) + 'static) {
    let (ctx, file) = (ctx.clone(), DroppedFileHandle::clone(file));
    wasm_bindgen_futures::spawn_local(async move {
        let bytes = file.bytes_async().await;
        given(Picked::read(file.path().display().to_string(), bytes));
        ctx.request_repaint();
    });
}

/// Hands a file over as a download.
///
/// # Errors
/// None: whether it is kept is the browser's to say.
pub fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    host::save(&name, kind_of(&name), bytes);
    Ok(())
}

/// Hands a file over as a download.
///
/// # Errors
/// None.
pub fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    write_whole(path, bytes)
}

/// Hands a file over as a download, without the folder that it belongs in.
///
/// # Errors
/// None.
pub fn write_with_folders(path: &Path, bytes: &[u8]) -> io::Result<()> {
    write_whole(path, bytes)
}

/// The media type of a file.
fn kind_of(name: &str) -> &'static str {
    match name.rsplit('.').next().unwrap_or_default() {
        "json" => "application/json",
        "jsonl" => "application/x-ndjson",
        "png" | "apng" => "image/png",
        "gif" => "image/gif",
        "svg" => "image/svg+xml",
        "pdf" => "application/pdf",
        "html" => "text/html",
        "md" => "text/markdown",
        "csv" => "text/csv",
        "txt" => "text/plain",
        _ => "application/octet-stream",
    }
}
