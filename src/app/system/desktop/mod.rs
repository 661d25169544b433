//! On a desktop: threads, files on disk, dialogues of the system.

mod journals;
mod start;
mod window;

pub use journals::{Journals, Left};
pub use start::{run, run_lesson};

use super::{NoDialogue, Picked, Unread};
use crate::app::frame::background::Background;
use crate::app::frame::task::Task;
use crate::scene::Scene;
use egui::{Context, DroppedFileHandle};
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

/// Begins to work on a thread of this name; returns whether one could be started.
pub fn begin(name: &str, work: impl FnOnce() + Send + 'static) -> bool {
    thread::Builder::new().name(name.to_owned()).spawn(work).is_ok()
}

/// The same for work that somebody waits for.
pub fn begin_at_once(name: &str, work: impl FnOnce() + Send + 'static) -> bool {
    begin(name, work)
}

/// Begins a task on a thread.
pub fn begin_task<T: Task>(ctx: &Context, scene: &Arc<Scene>, task: T) -> Option<Background<T::News>> {
    let scene = Arc::clone(scene);
    Background::start(ctx, T::NAME, move |progress, publish| task.run(&scene, progress, publish))
}

/// Over how many tasks a picture is spread: one has all cores.
pub const fn shares() -> u32 {
    1
}

/// Waits for what a thread sends, but not for long.
///
/// # Errors
/// If nothing came, or never will.
pub fn receive_within<T>(receiver: &Receiver<T>, patience: Duration) -> Result<T, RecvTimeoutError> {
    receiver.recv_timeout(patience)
}

/// Asks where a file is to be written, and waits for the answer; none if the dialogue was closed.
///
/// # Errors
/// If the system has no dialogue to show.
pub fn ask_where(title: Option<String>, name: &str, ending: &str) -> Result<Option<PathBuf>, NoDialogue> {
    let dialogue = rfd::FileDialog::new().set_file_name(name).add_filter(ending.to_uppercase(), &[ending]);
    let dialogue = match title {
        Some(title) => dialogue.set_title(title),
        None => dialogue,
    };
    answered(|| dialogue.save_file())
}

/// The answer of a dialogue, or that there was none: where a desktop lacks what shows dialogues, the library says only that
/// nothing was chosen, but it says so sooner than a person could.
fn answered(ask: impl FnOnce() -> Option<PathBuf>) -> Result<Option<PathBuf>, NoDialogue> {
    const SOONEST: Duration = Duration::from_millis(300);
    let begun = Instant::now();
    let answer = ask();
    if answer.is_none() && begun.elapsed() < SOONEST && cfg!(not(any(windows, target_os = "macos"))) {
        return Err(NoDialogue);
    }
    Ok(answer)
}

/// Lets a person choose a file; `given` is called with it, with none if the dialogue was closed, or with why there was none.
/// Returns whether there will be an answer.
pub fn ask_which(
    title: String,
    kind: String,
    endings: &'static [&'static str],
    given: impl FnOnce(Option<Picked>) + Send + 'static,
) -> bool {
    begin("file dialogue", move || {
        let dialogue = rfd::FileDialog::new().set_title(title).add_filter(kind, endings);
        given(match answered(|| dialogue.pick_file()) {
            Ok(path) => path.map(|path| Picked { name: path.display().to_string(), text: None }),
            Err(NoDialogue) => Some(Picked { name: String::new(), text: Some(Err(Unread::NoDialogue)) }),
        });
    })
}

/// Reads a file that was dropped on the window.
pub fn read_dropped(_ctx: &Context, file: &DroppedFileHandle, given: impl FnOnce(Picked)) {
    given(Picked::read(file.path().display().to_string(), file.bytes()));
}

/// Writes a new file whole or not at all: what was there before stays if the disk is full.
///
/// # Errors
/// What the system says.
pub fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".rayscope-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // As any other new file: the umask takes away what the user wants taken away.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut file = builder.tempfile_in(folder_of(path))?;
    file.write_all(bytes)?;
    file.persist(path)?;
    Ok(())
}

/// Writes a file beside the old one and then puts it in its place, so that at no moment there is only half of it. It keeps the
/// old one's permissions.
///
/// # Errors
/// What the system says.
pub fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = tempfile::NamedTempFile::new_in(folder_of(path))?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    if let Some(permissions) = fs::metadata(path).map(|metadata| metadata.permissions()).ok().or_else(plain_permissions)
    {
        file.as_file().set_permissions(permissions)?;
    }
    file.persist(path)?;
    Ok(())
}

/// Writes a file, and makes the folders that it belongs in.
///
/// # Errors
/// What the system says.
pub fn write_with_folders(path: &Path, bytes: &[u8]) -> io::Result<()> {
    fs::create_dir_all(folder_of(path))?;
    fs::write(path, bytes)
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// What a new file may be read and written by; temporary files are for their owner alone.
#[cfg(unix)]
#[expect(clippy::unnecessary_wraps, reason = "other systems have none")]
fn plain_permissions() -> Option<fs::Permissions> {
    Some(std::os::unix::fs::PermissionsExt::from_mode(0o644))
}

/// Elsewhere new files have what the folder says.
#[cfg(not(unix))]
fn plain_permissions() -> Option<fs::Permissions> {
    None
}
