//! A lesson on disk, read anew when it is saved.

use crate::app::frame::background::Background;
use crate::lesson_folder::Lessons;
use crate::trace::Progress;
use egui::Context;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// How often the files are looked at. More often, and a disk on the network is kept busy; less, and a teacher waits.
const PAUSE: Duration = Duration::from_secs(1);
/// How soon it is noticed that nobody wants to know any more.
const NAP: Duration = Duration::from_millis(50);

/// A lesson that is watched. Dropping it ends that.
pub struct Watch {
    job: Option<Background<Changed>>,
}

/// What was changed.
pub struct Changed {
    /// The lessons as they are now, or why they cannot be read.
    pub lessons: Result<Lessons, String>,
    /// Whether it is the text alone: then no scene has to be compiled anew.
    pub is_text_alone: bool,
}

/// A file with what changes when it is saved.
type Seen = Vec<(PathBuf, Option<SystemTime>, u64)>;

impl Watch {
    /// Begins to watch a lesson's file, and what lies beside it.
    pub fn start(ctx: &Context, file: &Path) -> Self {
        let path = file.to_owned();
        let mut before = seen(file);
        let work = move |progress: &Progress, publish: &mut dyn FnMut(Changed)| {
            while rested(progress) {
                let now = seen(&path);
                if now != before {
                    let is_text = |(file, ..): &&(PathBuf, _, _)| file.extension().is_some_and(|ending| ending == "md");
                    let rest = |all: &Seen| all.iter().filter(|file| !is_text(file)).cloned().collect::<Vec<_>>();
                    let is_text_alone = rest(&before) == rest(&now);
                    before = now;
                    publish(Changed { lessons: Lessons::named(&path.display().to_string()), is_text_alone });
                }
            }
        };
        Self { job: Background::start(ctx, "watch", work) }
    }

    /// What was changed, once.
    pub fn take(&self) -> Option<Changed> {
        self.job.as_ref()?.take()
    }
}

/// Waits; returns whether anybody still wants to know.
fn rested(progress: &Progress) -> bool {
    let mut left = PAUSE;
    while !progress.cancelled() {
        if left.is_zero() {
            return true;
        }
        std::thread::sleep(NAP);
        left = left.saturating_sub(NAP);
    }
    false
}

/// The files of a lesson, and the glossary beside its folder.
fn seen(file: &Path) -> Seen {
    let folder = file.parent().unwrap_or(Path::new("."));
    let mut paths: Vec<PathBuf> =
        fs::read_dir(folder).into_iter().flatten().filter_map(|entry| Some(entry.ok()?.path())).collect();
    paths.sort();
    paths.push(folder.join("../glossary.md"));
    let measured = |path: PathBuf| {
        let metadata = fs::metadata(&path).ok()?;
        Some((path, metadata.modified().ok(), metadata.len()))
    };
    paths.into_iter().filter_map(measured).collect()
}
