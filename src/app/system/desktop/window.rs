//! The window of a desktop.

use super::Journals;
use crate::app::window::{Start, Window};
use eframe::{CreationContext, NativeOptions};
use egui::ViewportBuilder;

/// The name that the system knows the program by.
const NAME: &str = "rayscope";

/// Opens the window and stays until it is closed.
///
/// # Errors
/// Why there is none.
pub fn open(start: Start) -> Result<(), eframe::Error> {
    let viewport = ViewportBuilder::default()
        .with_title("rayscope")
        .with_app_id(NAME)
        .with_inner_size([1280.0, 800.0])
        .with_min_inner_size([960.0, 600.0])
        .with_drag_and_drop(true);
    let options = NativeOptions { viewport, ..NativeOptions::default() };
    let create = move |creation: &CreationContext| {
        let mut window = Window::new(creation, start);
        if let Some(folder) = eframe::storage_dir(NAME) {
            window.workbench.keep_edits(Journals::in_folder(&folder.join("recovery")));
        }
        window
    };
    eframe::run_native(NAME, options, Box::new(move |creation| Ok(Box::new(create(creation)))))
}
