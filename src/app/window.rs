//! The thin layer between the workbench and the system's window.

use crate::app::workbench::Workbench;
use crate::folder::Outside;
use crate::share::link::Link;
use eframe::{CreationContext, Frame, NativeOptions, Storage};
use egui::{Ui, ViewportBuilder};

const KEPT: &str = "kept";
/// The name that the system knows the program by.
const NAME: &str = "rayscope";

/// Opens the window and stays until it is closed.
pub fn open(name: &str, text: String, outside: Outside, link: Option<Link>) -> Result<(), eframe::Error> {
    let viewport = ViewportBuilder::default()
        .with_title("rayscope")
        .with_app_id(NAME)
        .with_inner_size([1280.0, 800.0])
        .with_min_inner_size([960.0, 600.0])
        .with_drag_and_drop(true);
    let options = NativeOptions { viewport, ..NativeOptions::default() };
    let create = move |creation: &CreationContext| Window::new(creation, name, &text, outside, link.as_ref());
    eframe::run_native(NAME, options, Box::new(move |creation| Ok(Box::new(create(creation)))))
}

struct Window {
    workbench: Workbench,
}

impl Window {
    fn new(creation: &CreationContext, name: &str, text: &str, outside: Outside, link: Option<&Link>) -> Self {
        let mut workbench = Workbench::new(&creation.egui_ctx, name, text, outside);
        if let Some(kept) = creation.storage.and_then(|storage| storage.get_string(KEPT)) {
            workbench.take_up(&kept);
        }
        if let Some(folder) = eframe::storage_dir(NAME) {
            workbench.keep_edits_in(&folder.join("recovery"));
        }
        match link {
            Some(link) => workbench.follow(&creation.egui_ctx, link),
            None => workbench.offer_tour(),
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
