//! The right end of a panel's header: its tools, and how things stand in it. The tabs come first: where they leave too little room,
//! the tools are in a menu and the words are cut.

use crate::app::frame::theme::Palette;
use crate::app::frame::words::{language, say};
use crate::app::pane::Pane;
use crate::app::workbench::Workbench;
use egui::{Color32, FontId, Id, Label, RichText, Role, TextStyle, Ui, WidgetInfo};

/// Between tabs and tools, in points. Less, and a rounded width makes the arrows appear with which tabs are scrolled.
const GAP: f32 = 12.0;
/// The sign of a menu.
const MENU: &str = "⏷";
/// Between the parts of what is said in a header.
const BETWEEN: &str = " · ";

/// Shows tools and words, from right to left, within as much room as the tabs leave.
pub fn show(ui: &mut Ui, workbench: &mut Workbench, pane: Pane, room: f32) {
    let begin = ui.available_width();
    let room = (room - GAP).max(0.0);
    if wanted(ui, pane) > room {
        menu(ui, workbench, pane, room);
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

/// The tools below a word, or below a sign alone.
fn menu(ui: &mut Ui, workbench: &mut Workbench, pane: Pane, room: f32) {
    let name = say(ui.ctx(), "tools-menu");
    let title = format!("{name}  {MENU}");
    let around = 2.0 * ui.spacing().button_padding.x + 2.0;
    let fits = width(ui, &title, &TextStyle::Button.resolve(ui.style())) + around <= room;
    let menu = ui.menu_button(if fits { &title } else { MENU }, |ui| workbench.pane_tools(ui, pane));
    menu.response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    menu.response.on_hover_text(say(ui.ctx(), "tools-menu-about"));
}

/// How wide a panel's tools were when they were last shown beside each other.
fn wanted(ui: &Ui, pane: Pane) -> f32 {
    let place = place(ui, pane);
    ui.data(|data| data.get_temp(place)).unwrap_or_default()
}

fn note(ui: &Ui, pane: Pane, width: f32) {
    let place = place(ui, pane);
    ui.data_mut(|data| data.insert_temp(place, width));
}

fn place(ui: &Ui, pane: Pane) -> Id {
    Id::unique(("tools", pane.word(), language(ui.ctx()).tag()))
}

/// As many parts of the words as there is room for; all of them under the pointer and to screen readers. Half a number is none.
fn words(ui: &mut Ui, text: &str, room: f32) {
    let font = TextStyle::Small.resolve(ui.style());
    let room = room - ui.spacing().item_spacing.x;
    let ends = text.match_indices(BETWEEN).map(|(end, _)| end).chain([text.len()]);
    let shown = ends.map(|end| &text[..end]).filter(|part| width(ui, part, &font) <= room).last();
    let Some(shown) = shown.filter(|shown| !shown.is_empty()) else { return };
    let weak = Palette::current(ui.ctx()).weak;
    let label = ui.add(Label::new(RichText::new(shown).font(font).color(weak)).extend());
    label.widget_info(|| WidgetInfo::labeled(Role::Label, true, text));
    if shown.len() < text.len() {
        label.on_hover_text(text);
    }
}

fn width(ui: &Ui, text: &str, font: &FontId) -> f32 {
    ui.painter().layout_no_wrap(text.to_owned(), font.clone(), Color32::WHITE).size().x
}
