//! The thin layer between the workbench and the system's window.

use crate::app::frame::layout::Shares;
use crate::app::workbench::Workbench;
use crate::folder::Outside;
use eframe::{CreationContext, Frame, NativeOptions, Storage};
use egui::{Ui, ViewportBuilder};

const SHARES_KEY: &str = "shares";

/// Opens the window and stays until it is closed.
pub fn open(name: &str, text: String, outside: Outside) -> Result<(), eframe::Error> {
    let viewport = ViewportBuilder::default()
        .with_title("rayscope")
        .with_app_id("rayscope")
        .with_inner_size([1280.0, 800.0])
        .with_min_inner_size([960.0, 600.0])
        .with_drag_and_drop(true);
    let options = NativeOptions { viewport, ..NativeOptions::default() };
    let create = move |creation: &CreationContext| Window::new(creation, name, &text, outside);
    eframe::run_native("rayscope", options, Box::new(move |creation| Ok(Box::new(create(creation)))))
}

struct Window {
    workbench: Workbench,
}

impl Window {
    fn new(creation: &CreationContext, name: &str, text: &str, outside: Outside) -> Self {
        let mut workbench = Workbench::new(&creation.egui_ctx, name, text, outside);
        let kept = creation.storage.and_then(|storage| storage.get_string(SHARES_KEY));
        if let Some(shares) = kept.and_then(|text| read_shares(&text)) {
            workbench.set_shares(shares);
        }
        Self { workbench }
    }
}

impl eframe::App for Window {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut Frame) {
        self.workbench.ui(ui);
    }

    fn save(&mut self, storage: &mut dyn Storage) {
        storage.set_string(SHARES_KEY, write_shares(self.workbench.shares()));
    }
}

fn write_shares(shares: Shares) -> String {
    [shares.left, shares.outline, shares.picture, shares.detail].map(|share| share.to_string()).join(" ")
}

/// Anything that is not four shares between 0 and 1 is passed over.
fn read_shares(text: &str) -> Option<Shares> {
    let numbers: Vec<f32> = text.split(' ').map(str::parse).collect::<Result<_, _>>().ok()?;
    match numbers[..] {
        [left, outline, picture, detail] if numbers.iter().all(|share| (0.0..=1.0).contains(share)) => {
            Some(Shares { left, outline, picture, detail })
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_read_back_as_they_were_written() {
        let shares = Shares { left: 0.25, outline: 0.5, picture: 0.75, detail: 0.125 };
        assert_eq!(read_shares(&write_shares(shares)), Some(shares));
    }

    #[test]
    fn shares_that_make_no_sense_are_passed_over() {
        for text in ["", "0.5 0.5 0.5", "0.5 0.5 0.5 NaN", "0.5 0.5 0.5 2", "a b c d"] {
            assert_eq!(read_shares(text), None, "{text}");
        }
    }
}
