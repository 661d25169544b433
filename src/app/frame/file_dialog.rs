//! The dialogue for choosing a file. The window goes on working meanwhile.

use crate::app::frame::words::say;
use crate::app::system::{self, Picked};
use egui::{Context, DroppedFileHandle};
use std::sync::mpsc::{Receiver, TryRecvError, channel};

/// At most one dialogue.
#[derive(Default)]
pub struct FileDialog {
    answer: Option<Receiver<Option<Picked>>>,
}

impl FileDialog {
    /// Opens the dialogue for scenes unless it is open.
    pub fn open(&mut self, ctx: &Context) {
        self.open_for(ctx, say(ctx, "file-open"), say(ctx, "file-scenes"), &["json"]);
    }

    /// Opens a dialogue of this title for files of a kind, unless one is open.
    pub fn open_for(&mut self, ctx: &Context, title: String, kind: String, endings: &'static [&'static str]) {
        // A browser does not tell that its dialogue was closed.
        if self.answer.is_some() && cfg!(not(target_arch = "wasm32")) {
            return;
        }
        let (sender, receiver) = channel();
        let ctx = ctx.clone();
        let given = move |picked| {
            // The window may have gone away meanwhile; then nobody waits for this.
            let _ = sender.send(picked);
            ctx.request_repaint();
        };
        self.answer = system::ask_which(title, kind, endings, given).then_some(receiver);
    }

    /// Takes a file that was dropped on the window as if it were chosen.
    pub fn take(&mut self, ctx: &Context, file: &DroppedFileHandle) {
        let (sender, receiver) = channel();
        system::read_dropped(ctx, file, move |picked| {
            // As above.
            let _ = sender.send(Some(picked));
        });
        self.answer = Some(receiver);
    }

    /// The file that was chosen, once.
    pub fn chosen(&mut self) -> Option<Picked> {
        match self.answer.as_ref()?.try_recv() {
            Ok(picked) => {
                self.answer = None;
                picked
            }
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => {
                self.answer = None;
                None
            }
        }
    }
}
