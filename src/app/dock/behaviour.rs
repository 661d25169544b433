//! How docked panels look: a card with a header of tabs, the tools of the panel that is seen at the right end of it.

use super::{focus_of, header};
use crate::app::frame::theme::{PADDING, Palette, bold, drawing_theme};
use crate::app::frame::words::say;
use crate::app::pane::Pane;
use crate::app::workbench::Workbench;
use egui::emath::GuiRounding;
use egui::{
    Align, Color32, FontId, Id, Layout, Rect, RichText, Role, Sense, Stroke, StrokeKind, Ui, UiBuilder, Visuals,
    WidgetInfo, WidgetText, vec2,
};
use egui_tiles::{Behavior, SimplificationOptions, TabState, Tabs, TileId, Tiles, UiResponse};

/// Height of a header, in points.
const HEADER: f32 = 30.0;
/// The gap between two panels, in points; the handle that resizes them lies in it.
const GAP: f32 = 6.0;
/// Room at both sides of a tab's title, in points.
const BESIDE_TITLE: f32 = 7.0;
/// Width of an arrow with which tabs are scrolled, with the space beside it, in points.
const ARROW: f32 = HEADER + 8.0;
/// In so many frames the tabs are scrolled to the one that is seen: how wide they are together is not known in the first.
const TRIES: u8 = 3;
/// No panel becomes narrower or lower than this, in points.
const SMALLEST: f32 = 96.0;

/// Shows the panels of a workbench.
pub fn show(ui: &mut Ui, workbench: &mut Workbench) {
    let (mut tree, alone) = workbench.dock.begin();
    let mut docking = Docking { workbench, used: None };
    match alone {
        Some(pane) => docking.alone(ui, pane),
        None => tree.ui(&mut docking, ui),
    }
    let used = docking.used;
    workbench.dock.end(tree, used);
}

struct Docking<'a> {
    workbench: &'a mut Workbench,
    /// The panel that the pointer or the keys used in this frame.
    used: Option<Pane>,
}

impl Docking<'_> {
    /// Shows a panel that has the window to itself.
    fn alone(&mut self, ui: &mut Ui, pane: Pane) {
        let palette = Palette::current(ui.ctx());
        let (header, body) = {
            let whole = ui.available_rect_before_wrap();
            whole.split_top_bottom_at_y(whole.top() + HEADER)
        };
        ui.painter().rect_filled(header, 0.0, palette.header);
        let builder = UiBuilder::new().max_rect(header.shrink2(vec2(f32::from(PADDING), 2.0)));
        ui.scope_builder(builder.layout(Layout::left_to_right(Align::Center)), |ui| {
            ui.label(RichText::new(say(ui.ctx(), pane.word())).family(bold()));
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                self.workbench.alone_tools(ui, pane);
                let room = ui.available_width();
                header::show(ui, self.workbench, pane, room);
            });
        });
        ui.scope_builder(UiBuilder::new().max_rect(body), |ui| self.body(ui, pane));
    }

    fn body(&mut self, ui: &mut Ui, pane: Pane) {
        let palette = Palette::current(ui.ctx());
        let rect = ui.max_rect();
        ui.painter().rect_filled(rect, 0.0, palette.panel);
        let whole = ui.interact(rect, focus_of(pane), Sense::focusable_noninteractive());
        let title = say(ui.ctx(), pane.word());
        whole.widget_info(|| WidgetInfo::labeled(Role::Pane, true, &title));
        // Panels share the window by parts of pixels; what is in them lies on whole ones.
        let inside = rect.shrink(1.0).round_to_pixels(ui.pixels_per_point());
        let mut child = ui.new_child(UiBuilder::new().id_salt(pane.word()).max_rect(inside));
        child.shrink_clip_rect(rect);
        self.workbench.pane(&mut child, pane);
        if drawing_theme(ui.ctx()).is_high_contrast() {
            ui.painter().rect_stroke(rect, 0.0, Stroke::new(1.0, palette.edge), StrokeKind::Inside);
        }
        if whole.has_focus() {
            ui.painter().rect_stroke(rect, 0.0, Stroke::new(1.5, palette.accent), StrokeKind::Inside);
        }
        if whole.has_focus() || pressed_within(ui, rect) {
            self.used = Some(pane);
        }
    }
}

fn pressed_within(ui: &Ui, rect: Rect) -> bool {
    ui.input(|input| input.pointer.any_pressed() && input.pointer.interact_pos().is_some_and(|at| rect.contains(at)))
}

impl Behavior<Pane> for Docking<'_> {
    fn pane_ui(&mut self, ui: &mut Ui, _tile: TileId, pane: &mut Pane) -> UiResponse {
        self.body(ui, *pane);
        UiResponse::None
    }

    fn tab_title_for_pane(&mut self, pane: &Pane) -> WidgetText {
        let title = say(&self.workbench.ctx(), pane.word());
        RichText::new(title).font(title_font()).into()
    }

    fn tab_title_spacing(&self, _visuals: &Visuals) -> f32 {
        BESIDE_TITLE
    }

    fn top_bar_right_ui(&mut self, tiles: &Tiles<Pane>, ui: &mut Ui, tile: TileId, tabs: &Tabs, scroll: &mut f32) {
        if let Some(pane) = tabs.active.and_then(|active| tiles.get_pane(&active)) {
            ui.add_space(6.0);
            let room = ui.available_width() - widths(tiles, ui, tabs).map(|(_, width)| width).sum::<f32>();
            header::show(ui, self.workbench, *pane, room);
            show_tab(tiles, ui, tile, tabs, scroll);
        }
    }

    fn tab_bar_height(&self, _style: &egui::Style) -> f32 {
        HEADER
    }

    fn gap_width(&self, _style: &egui::Style) -> f32 {
        GAP
    }

    fn min_size(&self) -> f32 {
        SMALLEST
    }

    fn simplification_options(&self) -> SimplificationOptions {
        SimplificationOptions { all_panes_must_have_tabs: true, ..SimplificationOptions::default() }
    }

    fn tab_bar_color(&self, _visuals: &Visuals) -> Color32 {
        self.palette().header
    }

    fn tab_bg_color(&self, _visuals: &Visuals, _tiles: &Tiles<Pane>, _tile: TileId, state: &TabState) -> Color32 {
        if state.active { self.palette().panel } else { Color32::TRANSPARENT }
    }

    fn tab_outline_stroke(&self, _visuals: &Visuals, _tiles: &Tiles<Pane>, _tile: TileId, state: &TabState) -> Stroke {
        // Where contrast is high, panel and header have the same colour.
        if state.active { Stroke::new(1.0, self.palette().edge) } else { Stroke::NONE }
    }

    fn tab_text_color(&self, _visuals: &Visuals, _tiles: &Tiles<Pane>, _tile: TileId, state: &TabState) -> Color32 {
        if state.active { self.palette().text } else { self.palette().weak }
    }

    fn resize_stroke(&self, _style: &egui::Style, state: egui_tiles::ResizeState) -> Stroke {
        match state {
            egui_tiles::ResizeState::Idle => Stroke::NONE,
            _ => Stroke::new(2.0, self.palette().accent),
        }
    }
}

impl Docking<'_> {
    fn palette(&self) -> Palette {
        Palette::current(&self.workbench.ctx())
    }
}

/// How much room each tab of a header takes.
fn widths<'a>(tiles: &'a Tiles<Pane>, ui: &'a Ui, tabs: &'a Tabs) -> impl Iterator<Item = (TileId, f32)> + 'a {
    let width = |pane: &Pane| {
        let title = say(ui.ctx(), pane.word());
        ui.painter().layout_no_wrap(title, title_font(), Color32::WHITE).size().x + 2.0 * BESIDE_TITLE
    };
    tabs.children.iter().filter_map(move |&tile| Some((tile, width(tiles.get_pane(&tile)?))))
}

/// Scrolls to the tab of the panel that is seen when another one comes to the front, or the header's width changes.
fn show_tab(tiles: &Tiles<Pane>, ui: &Ui, tile: TileId, tabs: &Tabs, scroll: &mut f32) {
    let (place, room) = (Id::unique(("tab in sight", tile)), ui.available_width());
    let (active, width, tries) = ui.data(|data| data.get_temp(place)).unwrap_or((None, 0.0, 0));
    let is_known = active == tabs.active && (room - width).abs() < 1.0;
    let tries = if is_known { tries } else { 0 };
    if tries == TRIES {
        return;
    }
    ui.data_mut(|data| data.insert_temp(place, (tabs.active, room, tries + 1)));
    ui.ctx().request_repaint();
    let mut left = 0.0;
    for (tab, width) in widths(tiles, ui, tabs) {
        if Some(tab) == tabs.active {
            *scroll = scroll.max(left + width - (room - 2.0 * ARROW)).min(left);
        }
        left += width;
    }
    if left <= room {
        *scroll = 0.0;
    }
}

fn title_font() -> FontId {
    FontId::new(13.0, bold())
}
