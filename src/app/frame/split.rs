//! Dividing a rectangle in two with a handle between, in proportions that survive a change of the window's size.

use egui::{CursorIcon, Key, Rect, Role, Sense, Ui, WidgetInfo, pos2};

/// The gap between two panels, in points; the handle lies in it.
pub const GAP: f32 = 6.0;

/// Which way the two parts lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Left and right.
    Beside,
    /// Above and below.
    Below,
}

/// Divides `whole` at `fraction`, which the handle changes. `smallest` is the least that each part keeps, in points.
pub fn split(
    ui: &Ui,
    name: &str,
    whole: Rect,
    direction: Direction,
    fraction: &mut f32,
    smallest: f32,
) -> (Rect, Rect) {
    let length = match direction {
        Direction::Beside => whole.width(),
        Direction::Below => whole.height(),
    } - GAP;
    let smallest = smallest.min(length / 2.0);
    let range = (smallest / length.max(1.0))..=(1.0 - smallest / length.max(1.0));
    let clamp = |f: f32| f.clamp(*range.start(), *range.end());
    let (_, handle, _) = cut(whole, direction, length * clamp(*fraction));
    let response = ui.interact(handle, ui.scope_id().with(("split", name)), Sense::drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Splitter, true, name));
    let cursor = match direction {
        Direction::Beside => CursorIcon::ResizeHorizontal,
        Direction::Below => CursorIcon::ResizeVertical,
    };
    let response = response.on_hover_and_drag_cursor(cursor);
    if response.dragged() || response.has_focus() {
        let dragged = response.drag_delta();
        let moved = match direction {
            Direction::Beside => dragged.x,
            Direction::Below => dragged.y,
        };
        *fraction = clamp(clamp(*fraction) + moved / length.max(1.0) + keyed(ui, &response));
    }
    if response.hovered() || response.dragged() || response.has_focus() {
        let colour = ui.visuals().selection.stroke.color.gamma_multiply(0.6);
        ui.painter().rect_filled(handle.shrink(2.0), 1.0, colour);
    }
    let (first, _, second) = cut(whole, direction, length * clamp(*fraction));
    (first, second)
}

/// How far the arrow keys move a handle that has the focus.
fn keyed(ui: &Ui, response: &egui::Response) -> f32 {
    if !response.has_focus() {
        return 0.0;
    }
    let filter = egui::EventFilter { horizontal_arrows: true, vertical_arrows: true, ..Default::default() };
    ui.ctx().memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    ui.ctx().input(|input| {
        let presses = |key| f32::from(u8::from(input.key_pressed(key)));
        let forward = presses(Key::ArrowRight) + presses(Key::ArrowDown);
        let backward = presses(Key::ArrowLeft) + presses(Key::ArrowUp);
        0.02 * (forward - backward)
    })
}

/// The first part, the handle and the second part.
fn cut(whole: Rect, direction: Direction, at: f32) -> (Rect, Rect, Rect) {
    match direction {
        Direction::Beside => {
            let (a, b) = ((whole.left() + at).round(), (whole.left() + at + GAP).round());
            (
                Rect::from_min_max(whole.min, pos2(a, whole.bottom())),
                Rect::from_min_max(pos2(a, whole.top()), pos2(b, whole.bottom())),
                Rect::from_min_max(pos2(b, whole.top()), whole.max),
            )
        }
        Direction::Below => {
            let (a, b) = ((whole.top() + at).round(), (whole.top() + at + GAP).round());
            (
                Rect::from_min_max(whole.min, pos2(whole.right(), a)),
                Rect::from_min_max(pos2(whole.left(), a), pos2(whole.right(), b)),
                Rect::from_min_max(pos2(whole.left(), b), whole.max),
            )
        }
    }
}
