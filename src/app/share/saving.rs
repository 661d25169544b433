//! Making and writing in a thread of its own, with the dialogue that asks for the file.

use super::Aim;
use super::product::{Files, Material, Product, Result};
use crate::app::frame::background::Background;
use crate::app::frame::words::say;
use crate::app::system::{self, NoDialogue};
use egui::Context;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How fine progress is told.
const PARTS: usize = 1000;

/// Work that is going on. Dropping it gives it up.
pub struct Saving {
    job: Background<Result>,
    parts: Arc<AtomicUsize>,
}

impl Saving {
    /// Begins; none where no thread can be started.
    pub fn start(ctx: &Context, material: Material, product: Product, aim: Aim) -> Option<Self> {
        let parts = Arc::new(AtomicUsize::new(0));
        let missing = say(ctx, "file-no-dialogue-to-save");
        let (shown, repaint) = (Arc::clone(&parts), ctx.clone());
        let job = Background::start(ctx, "share", move |progress, publish| {
            let watch = |done: usize, of: usize| {
                shown.store(PARTS * done / of.max(1), Ordering::Relaxed);
                repaint.request_repaint();
                !progress.cancelled()
            };
            publish(match aim {
                Aim::Clipboard => product.copy(&material, &watch),
                Aim::File(path) => save(&material, product, &path, &watch),
                Aim::Ask => match system::ask_where(None, &product.file_name(&material.name), product.ending()) {
                    Ok(Some(path)) => save(&material, product, &path, &watch),
                    Ok(None) => Result::Given,
                    Err(NoDialogue) => Result::Failed(missing),
                },
            });
        })?;
        Some(Self { job, parts })
    }

    /// What came of it, once.
    pub fn take(&self) -> Option<Result> {
        // A thread that died has nothing to hand over and never will.
        let died = self.job.is_finished().then_some(Result::Given);
        self.job.take().or(died)
    }

    /// The share that is done, 0 to 1.
    pub fn share_done(&self) -> f32 {
        self.parts.load(Ordering::Relaxed) as f32 / PARTS as f32
    }
}

fn save(material: &Material, product: Product, path: &Path, watch: &dyn Fn(usize, usize) -> bool) -> Result {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    // The names stand within Markdown, where spaces and brackets would end a link.
    let stem: String = stem.chars().map(|c| if c.is_alphanumeric() || "-_".contains(c) { c } else { '-' }).collect();
    match product.files(material, &stem, watch) {
        Ok(None) => Result::Given,
        Ok(Some(files)) => match write(path, &files) {
            Ok(()) => Result::Saved(path.to_owned()),
            Err(error) => Result::Failed(format!("{}: {error}", path.display())),
        },
        Err(why) => Result::Failed(why),
    }
}

/// Writes what lies beside the file first, so that the file never shows what is not there.
fn write(path: &Path, files: &Files) -> std::io::Result<()> {
    for (name, text) in &files.beside {
        system::write_whole(&path.with_file_name(name), text.as_bytes())?;
    }
    system::write_whole(path, &files.main)
}
