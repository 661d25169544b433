//! The system's dialogue for choosing a file, on a thread of its own so that the window goes on working.

use crate::app::frame::words::say;
use egui::Context;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, TryRecvError, channel};

/// At most one dialogue.
#[derive(Default)]
pub struct FileDialog {
    answer: Option<Receiver<Option<PathBuf>>>,
}

impl FileDialog {
    /// Opens the dialogue for scenes unless it is open.
    pub fn open(&mut self, ctx: &Context) {
        self.open_for(ctx, say(ctx, "file-open"), say(ctx, "file-scenes"), &["json"]);
    }

    /// Opens a dialogue of this title for files of a kind, unless one is open.
    pub fn open_for(&mut self, ctx: &Context, title: String, kind: String, endings: &'static [&'static str]) {
        if self.answer.is_some() {
            return;
        }
        let (sender, receiver) = channel();
        let ctx = ctx.clone();
        let ask = move || {
            let dialogue = rfd::FileDialog::new().set_title(title).add_filter(kind, endings);
            // The window may have gone away meanwhile; then nobody waits for this.
            let _ = sender.send(dialogue.pick_file());
            ctx.request_repaint();
        };
        let started = std::thread::Builder::new().name("file dialogue".to_owned()).spawn(ask);
        self.answer = started.is_ok().then_some(receiver);
    }

    /// The file that was chosen, once.
    pub fn chosen(&mut self) -> Option<PathBuf> {
        match self.answer.as_ref()?.try_recv() {
            Ok(path) => {
                self.answer = None;
                path
            }
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => {
                self.answer = None;
                None
            }
        }
    }
}
