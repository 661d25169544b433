//! The ray's story as an outline: one line for each event, laid out only where it is seen.

use crate::app::frame::empty::empty;
use crate::app::frame::theme::Palette;
use crate::app::frame::words::say;
use crate::app::story::recording::Recording;
use crate::record::EventId;
use crate::view::{Row, row};
use egui::{
    Align2, EventFilter, FontId, Key, Rect, Response, Role, ScrollArea, Sense, Stroke, TextStyle, Ui, WidgetInfo, pos2,
    vec2,
};
use std::sync::Arc;

/// Height of a row, in points.
const ROW: f32 = 23.0;
/// How far a level is moved to the right.
const INDENT: f32 = 15.0;
/// Width of the column of triangles.
const TRIANGLE: f32 = 16.0;
/// Width of the column of icons.
const ICON: f32 = 20.0;

/// Shows the outline and lets the pointer and the keys move in it.
pub fn ui(ui: &mut Ui, recording: Option<&mut Recording>) {
    let Some(recording) = recording else {
        empty(ui, "Click a pixel in the picture, and the story of its ray is told here.");
        return;
    };
    ui.spacing_mut().item_spacing.y = 0.0;
    let mut area = ScrollArea::vertical().auto_shrink(false).id_salt("outline");
    if let Some(offset) = offset_of_selection(ui, recording) {
        area = area.vertical_scroll_offset(offset);
    }
    let focus = ui.scope_id().with("outline keys");
    let output = area.show_rows(ui, ROW, recording.outline.rows().len(), |ui, range| {
        let ids = recording.outline.rows()[range].to_vec();
        let mut clicked = false;
        for id in ids {
            clicked |= show_row(ui, recording, id);
        }
        clicked
    });
    ui.ctx().data_mut(|data| data.insert_temp(focus, [output.state.clamped_offset().y, output.inner_rect.height()]));
    // The outline as a whole takes the focus, so that it does not get lost when the focused row scrolls away.
    let whole = ui.interact(output.inner_rect, focus, Sense::focusable_noninteractive());
    whole.widget_info(|| WidgetInfo::labeled(Role::Tree, true, "The ray's story"));
    if output.inner {
        // Only now: a click beside the outline itself, as one on a row is, takes its focus away.
        whole.request_focus();
    }
    if whole.has_focus() {
        let palette = Palette::current(ui.ctx());
        let edge = Stroke::new(1.0, palette.accent);
        ui.painter().rect_stroke(output.inner_rect, 0.0, edge, egui::StrokeKind::Inside);
        keys(ui, recording, &whole);
    }
}

/// Where to scroll, if the selection moved out of sight: its row goes to the third of the height.
fn offset_of_selection(ui: &Ui, recording: &mut Recording) -> Option<f32> {
    if !std::mem::take(&mut recording.selection_moved) {
        return None;
    }
    let focus = ui.scope_id().with("outline keys");
    let [offset, height] = ui.ctx().data(|data| data.get_temp(focus)).unwrap_or([0.0, ui.available_height()]);
    let top = recording.outline.row_of(recording.selected())? as f32 * ROW;
    let in_sight = top >= offset && top + ROW <= offset + height;
    (!in_sight).then(|| (top - height / 3.0).max(0.0))
}

/// Shows a row; returns whether it was clicked.
fn show_row(ui: &mut Ui, recording: &mut Recording, id: EventId) -> bool {
    let tree = Arc::clone(&recording.tree);
    let mut row = row(tree.event(id));
    if recording.changed.contains(&id) {
        row.numbers = format!("● {} {}", say(ui.ctx(), "edit-changed"), row.numbers);
    }
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
    let response = ui.interact(rect, ui.scope_id().with(("row", id)), Sense::click());
    let selected = recording.selected() == id;
    let open = recording.outline.is_open(id);
    name_row(ui, &response, &row, selected, open, recording.outline.depth(id));

    let left = rect.left() + 4.0 + INDENT * f32::from(recording.outline.depth(id));
    let triangle = Rect::from_min_size(pos2(left, rect.top()), vec2(TRIANGLE, ROW));
    let elided = paint_row(ui, rect, left, &row, selected, response.hovered());
    paint_triangle(ui, triangle, open);

    let response = if elided { response.on_hover_text(full_text(&row)) } else { response };
    if response.clicked() {
        let on_triangle = response.interact_pointer_pos().is_some_and(|at| at.x < triangle.right());
        match open {
            Some(open) if on_triangle => recording.set_open(id, !open),
            _ => recording.select(id),
        }
    }
    if let (true, Some(open)) = (response.double_clicked(), open) {
        recording.set_open(id, !open);
    }
    response.clicked()
}

/// Tells screen readers and tests what the row says.
fn name_row(ui: &Ui, response: &Response, row: &Row, selected: bool, open: Option<bool>, depth: u16) {
    let text = full_text(row);
    response.widget_info(|| WidgetInfo::labeled(Role::TreeItem, true, &text));
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_level(usize::from(depth) + 1);
        node.set_selected(selected);
        if let Some(open) = open {
            node.set_expanded(open);
        }
    });
}

fn full_text(row: &Row) -> String {
    if row.numbers.is_empty() { row.label.clone() } else { format!("{}, {}", row.label, row.numbers) }
}

/// Paints the row; returns whether something of it did not fit.
fn paint_row(ui: &Ui, rect: Rect, left: f32, row: &Row, selected: bool, hovered: bool) -> bool {
    let palette = Palette::current(ui.ctx());
    let painter = ui.painter_at(rect);
    if selected {
        painter.rect_filled(rect, 0.0, palette.selected);
        painter.rect_filled(Rect::from_min_size(rect.min, vec2(3.0, ROW)), 0.0, palette.accent);
    } else if hovered {
        painter.rect_filled(rect, 0.0, palette.hovered);
    }
    let middle = rect.center().y;
    let body = TextStyle::Body.resolve(ui.style());
    let icon = pos2(left + TRIANGLE + ICON / 2.0 - 2.0, middle);
    painter.text(icon, Align2::CENTER_CENTER, row.icon, body.clone(), palette.accent);
    let x = left + TRIANGLE + ICON;
    let label = elided(ui, &row.label, body, palette.text, rect.right() - 8.0 - x);
    painter.galley(pos2(x, middle - label.size().y / 2.0), Arc::clone(&label), palette.text);
    let x = x + label.size().x + 10.0;
    let mut cut = label.elided;
    if rect.right() - 8.0 - x > 24.0 {
        let numbers = elided(ui, &row.numbers, FontId::proportional(12.0), palette.weak, rect.right() - 8.0 - x);
        cut |= numbers.elided;
        painter.galley(pos2(x, middle - numbers.size().y / 2.0), numbers, palette.weak);
    } else {
        cut |= !row.numbers.is_empty();
    }
    cut
}

/// One line, ended by `…` where it does not fit.
fn elided(ui: &Ui, text: &str, font: FontId, colour: egui::Color32, width: f32) -> Arc<egui::Galley> {
    let mut job = egui::text::LayoutJob::simple_singleline(text.to_owned(), font, colour);
    job.wrap = egui::text::TextWrapping::truncate_at_width(width.max(0.0));
    ui.ctx().fonts_mut(|fonts| fonts.layout_job(job))
}

fn paint_triangle(ui: &Ui, place: Rect, open: Option<bool>) {
    let Some(open) = open else { return };
    let (c, r) = (place.center(), 3.5);
    let points = if open {
        vec![c + vec2(-r, -r * 0.6), c + vec2(r, -r * 0.6), c + vec2(0.0, r * 0.8)]
    } else {
        vec![c + vec2(-r * 0.6, -r), c + vec2(r * 0.8, 0.0), c + vec2(-r * 0.6, r)]
    };
    let colour = Palette::current(ui.ctx()).weak;
    ui.painter().add(egui::Shape::convex_polygon(points, colour, Stroke::NONE));
}

/// Up and down move by rows; left and right fold and open, or move to the whole and to the first part.
fn keys(ui: &Ui, recording: &mut Recording, whole: &Response) {
    let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(whole.id, filter));
    let pressed = |key| ui.input(|input| input.key_pressed(key));
    let id = recording.selected();
    let neighbour = |distance: isize| {
        let row = recording.outline.row_of(id)?.checked_add_signed(distance)?;
        recording.outline.rows().get(row).copied()
    };
    #[expect(clippy::cast_possible_truncation, reason = "a panel is a few hundred rows high")]
    let page = ((whole.rect.height() / ROW) as isize).max(1);
    let moves = [(Key::ArrowUp, -1), (Key::ArrowDown, 1), (Key::PageUp, -page), (Key::PageDown, page)];
    if let Some(target) = moves.into_iter().find(|(key, _)| pressed(*key)).and_then(|(_, distance)| neighbour(distance))
    {
        recording.select(target);
    }
    match recording.outline.is_open(id) {
        Some(true) if pressed(Key::ArrowLeft) => recording.set_open(id, false),
        Some(false) if pressed(Key::ArrowRight) => recording.set_open(id, true),
        _ if pressed(Key::ArrowLeft) => recording.step(crate::app::story::stepper::Step::Out),
        _ if pressed(Key::ArrowRight) => recording.step(crate::app::story::stepper::Step::Into),
        _ => {}
    }
}
