//! The thin layer between the workbench and the window or the page that it is in.

use crate::app::workbench::Workbench;
use crate::folder::Outside;
use crate::lesson_folder::Lessons;
use crate::share::link::Link;
use eframe::{CreationContext, Frame, Storage};
use egui::Ui;

/// Where it is kept; in a browser other pages of the same site may keep something, too.
const KEPT: &str = if cfg!(target_arch = "wasm32") { "rayscope.kept" } else { "kept" };

/// What the window begins with.
pub struct Start {
    /// The name of the scene, or its file's.
    pub name: String,
    /// Its text.
    pub text: String,
    /// Which files it may name.
    pub outside: Outside,
    /// What is followed as soon as the window is there.
    pub link: Option<Box<Link>>,
    /// Lessons to be used in place of those that come with the program.
    pub lessons: Option<Lessons>,
}

/// The workbench in a window.
pub struct Window {
    /// The workbench.
    pub workbench: Workbench,
}

impl Window {
    /// A workbench that begins with this, and with what was kept the last time.
    pub fn new(creation: &CreationContext, start: Start) -> Self {
        let ctx = &creation.egui_ctx;
        let mut workbench = Workbench::new(ctx, &start.name, &start.text, start.outside);
        if let Some(kept) = creation.storage.and_then(|storage| storage.get_string(KEPT)) {
            workbench.take_up(&kept);
        }
        match (start.link, start.lessons) {
            (_, Some(lessons)) => workbench.use_lessons(lessons),
            (Some(link), None) => workbench.follow(ctx, &link),
            (None, None) => workbench.offer_tour(),
        }
        Self { workbench }
    }
}

impl eframe::App for Window {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut Frame) {
        self.workbench.ui(ui);
    }

    fn save(&mut self, storage: &mut dyn Storage) {
        storage.set_string(KEPT, self.workbench.keep());
    }
}
