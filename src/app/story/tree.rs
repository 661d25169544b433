//! The ray's story as an outline: one line for each event, laid out only where it is seen.

use super::recording::Recording;
use crate::app::frame::theme::{PADDING, Palette};
use crate::app::frame::words::{say, say_with};
use crate::record::EventId;
use crate::story::{Step, Story};
use crate::view::{Row, row, untold_row};
use egui::{
    Align2, Context, EventFilter, FontId, Key, Rect, Response, Role, ScrollArea, Sense, Stroke, TextStyle, Ui,
    WidgetInfo, pos2, vec2,
};
use std::ops::Range;
use std::sync::Arc;

/// Height of a row, in points.
const ROW: f32 = 23.0;
/// How far a level is moved to the right.
const INDENT: f32 = 15.0;
/// So many levels are moved to the right; deeper rows would have no room for words.
const MOST_INDENTS: f32 = 16.0;
/// Width of the column of triangles.
const TRIANGLE: f32 = 16.0;
/// Width of the column of icons.
const ICON: f32 = 20.0;

/// Shows the outline and lets the pointer and the keys move in it.
pub fn ui(ui: &mut Ui, recording: Option<&mut Recording>) {
    let Some(recording) = recording else { return };
    ui.spacing_mut().item_spacing.y = 0.0;
    let mut area = ScrollArea::vertical().auto_shrink(false).id_salt("outline");
    if let Some(offset) = offset_of_selection(ui, recording) {
        area = area.vertical_scroll_offset(offset);
    }
    let focus = ui.scope_id().with("outline keys");
    let told = recording.rows_told();
    let rows = told + usize::from(told < recording.story().outline().len());
    let output = area.show_rows(ui, ROW, rows, |ui, range| show_rows(ui, recording, range, told));
    let seen = Seen {
        offset: output.state.clamped_offset().y,
        height: output.inner_rect.height(),
        place: (recording.pixel, recording.selected()),
    };
    ui.ctx().data_mut(|data| data.insert_temp(focus, seen));
    // The outline as a whole takes the focus, so that it does not get lost when the focused row scrolls away.
    let whole = ui.interact(output.inner_rect, focus, Sense::focusable_noninteractive());
    let name = say(ui.ctx(), "step-tree");
    whole.widget_info(|| WidgetInfo::labeled(Role::Tree, true, &name));
    if let Some(asked) = output.inner {
        match asked {
            Asked::Select(id) => recording.select(id),
            Asked::Open(id, open) => recording.set_open(id, open),
            Asked::Lift => recording.veil = None,
        }
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

/// What an outline showed last: in a layout, and in the window by itself, there is one each.
#[derive(Clone, Copy)]
struct Seen {
    offset: f32,
    height: f32,
    /// The pixel and the selected event.
    place: ([u32; 2], EventId),
}

/// What a click on a row asks for.
enum Asked {
    Select(EventId),
    Open(EventId, bool),
    Lift,
}

/// Where to scroll, if the selection moved out of sight, or the panel became so low that it is out of sight: its row goes to the
/// third of the height.
fn offset_of_selection(ui: &Ui, recording: &mut Recording) -> Option<f32> {
    let height = ui.available_height();
    if height < ROW {
        // Nothing is seen yet: the panel comes to its height later.
        return None;
    }
    let focus = ui.scope_id().with("outline keys");
    // The height was another one before in another layout, or behind another panel.
    let seen: Option<Seen> = ui.ctx().data(|data| data.get_temp(focus));
    let (offset, before) = seen.map_or((0.0, height), |seen| (seen.offset, seen.height));
    let top = recording.story().outline().row_of(recording.selected()).map(|row| row as f32 * ROW);
    let is_in = |height: f32| top.is_some_and(|top| top >= offset && top + ROW <= offset + height);
    // It may have moved, and been followed, where the outline lay in another place.
    let is_known = seen.is_some_and(|seen| seen.place == (recording.pixel, recording.selected()));
    let has_moved = std::mem::take(&mut recording.selection_moved) || !is_known;
    let was_seen = before > height && is_in(before);
    let target = top.filter(|_| (has_moved || was_seen) && !is_in(height));
    target.map(|top| (top - height / 3.0).max(0.0))
}

/// The rows of a range, the first `told` of which are told.
fn show_rows(ui: &mut Ui, recording: &Recording, range: Range<usize>, told: usize) -> Option<Asked> {
    let mut asked = None;
    for place in range {
        if place >= told {
            let lifts = ui.horizontal(|ui| {
                ui.add_space(f32::from(PADDING));
                ui.link(say(ui.ctx(), "lesson-veil")).clicked()
            });
            asked = asked.or(lifts.inner.then_some(Asked::Lift));
        } else if let Some(id) = recording.story().outline().row(place) {
            asked = show_row(ui, recording, id).or(asked);
        }
    }
    asked
}

/// A row with what stands around it.
#[expect(clippy::struct_excessive_bools, reason = "they do not depend on each other")]
struct Line {
    row: Row,
    selected: bool,
    open: Option<bool>,
    depth: u16,
    /// It is not looked for itself, but holds something that is.
    is_context: bool,
    is_stop: bool,
    /// A lesson marks it.
    is_marked: bool,
    /// What it tells of beside itself, in words.
    beside: Vec<String>,
    /// The same for the eye.
    badge: String,
}

impl Line {
    /// The row of an event; without what came of it, where that `is_kept` for answers.
    fn of(ctx: &Context, story: &Story, id: EventId, is_kept: bool) -> Self {
        let (inside, skips) = if is_kept { (0, 0) } else { story.inside(id) };
        let event = story.tree().event(id);
        let is_stop = story.stops().binary_search(&id).is_ok();
        let is_guest = story.outline().is_guest(id);
        let counted = |word: &str, count: u32| say_with(ctx, word, &[("count", count.into())]);
        let mut beside = Vec::new();
        if is_stop {
            beside.push(say(ctx, "step-row-stop"));
        }
        if is_guest {
            beside.push(say(ctx, "step-row-guest"));
        }
        if inside > 0 {
            beside.push(counted("step-row-inside", inside));
        }
        if skips > 0 {
            beside.push(counted("step-row-skips", skips));
        }
        let badge = match (inside, skips) {
            (0, _) => String::new(),
            (inside, 0) => format!("+{inside}"),
            (inside, skips) => format!("+{inside} ✗{skips}"),
        };
        Self {
            row: if is_kept { untold_row(event) } else { row(event) },
            selected: story.selected() == id,
            open: story.is_open(id),
            depth: story.depth(id),
            is_context: is_guest || !story.shown().is_step(id),
            is_stop,
            is_marked: false,
            beside,
            badge,
        }
    }

    fn text(&self) -> String {
        if self.row.numbers.is_empty() {
            self.row.label.clone()
        } else {
            format!("{}, {}", self.row.label, self.row.numbers)
        }
    }
}

/// Shows a row; returns what a click on it asks for.
fn show_row(ui: &mut Ui, recording: &Recording, id: EventId) -> Option<Asked> {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
    let response = ui.interact(rect, ui.scope_id().with(("row", id)), Sense::click());
    let mut line = Line::of(ui.ctx(), recording.story(), id, recording.keeps_outcome(id));
    line.is_marked = recording.marked.contains(&id);
    if line.is_marked {
        line.beside.push(say(ui.ctx(), "lesson-marked"));
    }
    if recording.changed.contains(&id) {
        line.row.numbers = format!("• {} {}", say(ui.ctx(), "edit-changed"), line.row.numbers);
    }
    name_row(ui, &response, &line);

    let left = rect.left() + 4.0 + INDENT * f32::from(line.depth).min(MOST_INDENTS);
    let triangle = Rect::from_min_size(pos2(left, rect.top()), vec2(TRIANGLE, ROW));
    let is_whole = paint_row(ui, rect, left, &line, response.hovered());
    paint_triangle(ui, triangle, line.open);

    let on_triangle = response.interact_pointer_pos().is_some_and(|at| at.x < triangle.right());
    let (clicked, twice) = (response.clicked(), response.double_clicked());
    // What is seen anyway would only hide the rows below.
    if !is_whole || !line.beside.is_empty() {
        response.on_hover_ui(|ui| {
            ui.label(line.text());
            if !line.beside.is_empty() {
                ui.label(line.beside.join(", "));
            }
        });
    }
    match line.open {
        Some(open) if twice || (clicked && on_triangle) => Some(Asked::Open(id, !open)),
        _ => clicked.then_some(Asked::Select(id)),
    }
}

/// Tells screen readers and tests what the row says.
fn name_row(ui: &Ui, response: &Response, line: &Line) {
    response.widget_info(|| WidgetInfo::labeled(Role::TreeItem, true, line.text()));
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_level(usize::from(line.depth) + 1);
        node.set_selected(line.selected);
        if let Some(open) = line.open {
            node.set_expanded(open);
        }
        // Not in the name, which stays the same when the row is folded.
        if !line.beside.is_empty() {
            node.set_description(line.beside.join(", "));
        }
    });
}

/// Paints a row; returns whether there was room for all of it.
fn paint_row(ui: &Ui, rect: Rect, left: f32, line: &Line, hovered: bool) -> bool {
    let palette = Palette::current(ui.ctx());
    let painter = ui.painter_at(rect);
    if line.selected {
        painter.rect_filled(rect, 0.0, palette.selected);
        painter.rect_filled(Rect::from_min_size(rect.min, vec2(3.0, ROW)), 0.0, palette.accent);
    } else if hovered {
        painter.rect_filled(rect, 0.0, palette.hovered);
    }
    let middle = rect.center().y;
    if line.is_marked {
        let frame = rect.shrink2(vec2(1.0, 1.5));
        painter.rect_stroke(frame, 3.0, Stroke::new(1.5, palette.accent), egui::StrokeKind::Inside);
    }
    if line.is_stop {
        painter.circle_filled(pos2(rect.left() + 8.0, middle), 4.0, palette.problem);
    }
    let body = TextStyle::Body.resolve(ui.style());
    let small = FontId::proportional(12.0);
    let icon = pos2(left + TRIANGLE + ICON / 2.0 - 2.0, middle);
    painter.text(icon, Align2::CENTER_CENTER, line.row.icon, body.clone(), palette.accent);
    // On the colour of the selection, only the full ink can be read.
    let weak = if line.selected { palette.text } else { palette.weak };
    let ink = if line.is_context { weak } else { palette.text };
    let mut right = rect.right() - 8.0;
    if !line.badge.is_empty() {
        let badge = painter.text(pos2(right, middle), Align2::RIGHT_CENTER, &line.badge, small.clone(), weak);
        right = badge.left() - 8.0;
    }
    let x = left + TRIANGLE + ICON;
    let label = elided(ui, &line.row.label, body, ink, right - x);
    painter.galley(pos2(x, middle - label.size().y / 2.0), Arc::clone(&label), ink);
    let x = x + label.size().x + 10.0;
    if right - x <= 24.0 {
        return !label.elided && line.row.numbers.is_empty();
    }
    let numbers = elided(ui, &line.row.numbers, small, weak, right - x);
    let is_whole = !label.elided && !numbers.elided;
    painter.galley(pos2(x, middle - numbers.size().y / 2.0), numbers, weak);
    is_whole
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
    let outline = recording.story().outline();
    let neighbour = |distance: isize| {
        let place = outline.row_of(id)?.saturating_add_signed(distance).min(outline.len().checked_sub(1)?);
        outline.row(place).filter(|&row| row != id)
    };
    #[expect(clippy::cast_possible_truncation, reason = "a panel is a few hundred rows high")]
    let page = ((whole.rect.height() / ROW) as isize).max(1);
    let moves = [(Key::ArrowUp, -1), (Key::ArrowDown, 1), (Key::PageUp, -page), (Key::PageDown, page)];
    let target = moves.into_iter().find(|(key, _)| pressed(*key)).and_then(|(_, distance)| neighbour(distance));
    if let Some(target) = target {
        recording.select(target);
    }
    match recording.story().is_open(id) {
        Some(true) if pressed(Key::ArrowLeft) => recording.set_open(id, false),
        Some(false) if pressed(Key::ArrowRight) => recording.set_open(id, true),
        _ if pressed(Key::ArrowLeft) => recording.step(Step::Out),
        _ if pressed(Key::ArrowRight) => recording.step(Step::Into),
        _ => {}
    }
}
