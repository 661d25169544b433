//! The right end of a panel's header: its tools, and how things stand in it. The tabs come first: where they leave too little room,
//! the tools are in a menu and the words are cut.

use crate::app::frame::theme::Palette;
use crate::app::frame::words::{language, say};
use crate::app::pane::Pane;
use crate::app::workbench::Workbench;
use egui::text::LayoutJob;
use egui::{Id, TextStyle, Ui};

/// Less room than this is not worth a word, in points.
const LEAST_WORDS: f32 = 40.0;
/// Between tabs and tools, in points. Less, and a rounded width makes the arrows appear with which tabs are scrolled.
const GAP: f32 = 12.0;

/// Shows tools and words, from right to left, within as much room as the tabs leave.
pub fn show(ui: &mut Ui, workbench: &mut Workbench, pane: Pane, room: f32) {
    let begin = ui.available_width();
    let room = room - GAP;
    if wanted(ui, pane) > room {
        let menu = ui.menu_button(say(ui.ctx(), "tools-menu"), |ui| workbench.pane_tools(ui, pane));
        menu.response.on_hover_text(say(ui.ctx(), "tools-menu-about"));
    } else {
        workbench.pane_tools(ui, pane);
        let width = begin - ui.available_width();
        note(ui, pane, width);
        if width > room {
            // It was not known before how wide they are.
            ui.ctx().request_repaint();
        }
    }
    if let Some(state) = workbench.pane_state(ui.ctx(), pane) {
        words(ui, &state, room - (begin - ui.available_width()));
    }
}

/// How wide a panel's tools were when they were last shown beside each other.
fn wanted(ui: &Ui, pane: Pane) -> f32 {
    ui.data(|data| data.get_temp(place(ui, pane))).unwrap_or_default()
}

fn note(ui: &Ui, pane: Pane, width: f32) {
    let place = place(ui, pane);
    ui.data_mut(|data| data.insert_temp(place, width));
}

fn place(ui: &Ui, pane: Pane) -> Id {
    Id::unique(("tools", pane.word(), language(ui.ctx()).tag()))
}

/// As much of the words as there is room for; all of them under the pointer.
fn words(ui: &mut Ui, text: &str, room: f32) {
    if room < LEAST_WORDS {
        return;
    }
    let font = TextStyle::Small.resolve(ui.style());
    let mut job = LayoutJob::simple(text.to_owned(), font, Palette::current(ui.ctx()).weak, room);
    job.wrap.max_rows = 1;
    job.wrap.break_anywhere = true;
    let galley = ui.ctx().fonts_mut(|fonts| fonts.layout_job(job));
    let is_cut = galley.elided;
    let label = ui.label(galley);
    if is_cut {
        label.on_hover_text(text);
    }
}
