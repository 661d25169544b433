//! The thin layer between the workbench and the system's window.

use crate::app::workbench::Workbench;
use crate::folder::Outside;
use crate::lesson_folder::Lessons;
use crate::share::link::Link;
use eframe::{CreationContext, Frame, NativeOptions, Storage};
use egui::{Ui, ViewportBuilder};

const KEPT: &str = "kept";
/// The name that the system knows the program by.
const NAME: &str = "rayscope";

/// What the window begins with.
pub enum Start {
    /// A scene.
    Scene {
        /// Its name, or its file's.
        name: String,
        /// Its text.
        text: String,
        /// Which files it may name.
        outside: Outside,
        /// What is followed as soon as the window is there.
        link: Option<Box<Link>>,
    },
    /// Lessons.
    Lessons(Lessons),
}

/// Opens the window and stays until it is closed.
pub fn open(start: Start) -> Result<(), eframe::Error> {
    let viewport = ViewportBuilder::default()
        .with_title("rayscope")
        .with_app_id(NAME)
        .with_inner_size([1280.0, 800.0])
        .with_min_inner_size([960.0, 600.0])
        .with_drag_and_drop(true);
    let options = NativeOptions { viewport, ..NativeOptions::default() };
    let create = move |creation: &CreationContext| Window::new(creation, start);
    eframe::run_native(NAME, options, Box::new(move |creation| Ok(Box::new(create(creation)))))
}

struct Window {
    workbench: Workbench,
}

impl Window {
    fn new(creation: &CreationContext, start: Start) -> Self {
        let ctx = &creation.egui_ctx;
        let mut workbench = match &start {
            Start::Scene { name, text, outside, .. } => Workbench::new(ctx, name, text, *outside),
            Start::Lessons(_) => Workbench::at_first_scene(ctx),
        };
        if let Some(kept) = creation.storage.and_then(|storage| storage.get_string(KEPT)) {
            workbench.take_up(&kept);
        }
        if let Some(folder) = eframe::storage_dir(NAME) {
            workbench.keep_edits_in(&folder.join("recovery"));
        }
        match start {
            Start::Scene { link: Some(link), .. } => workbench.follow(ctx, &link),
            Start::Scene { link: None, .. } => workbench.offer_tour(),
            Start::Lessons(lessons) => workbench.use_lessons(lessons),
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
