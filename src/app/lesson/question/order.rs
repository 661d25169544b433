//! Things that are put in order: by buttons, by keys, or dragged.

use crate::app::frame::theme::Palette;
use crate::app::frame::words::{say, say_with};
use crate::app::lesson::text::Reader;
use crate::lesson::prose::{Line, Told, plain};
use egui::{Button, CursorIcon, Frame, Margin, Rect, Role, Sense, Stroke, Ui, WidgetInfo, vec2};

/// Shows the things in their order and lets them be moved.
pub fn ui(ui: &mut Ui, reader: &mut Reader, items: &[Line<Told>], chosen: &mut Vec<usize>) {
    let mut rows = Vec::new();
    let mut moved = None;
    for place in 0..chosen.len() {
        let (rect, asked) = row(ui, reader, items, chosen, place);
        rows.push(rect);
        moved = moved.or(asked);
    }
    let target = match moved {
        Some(Move::By(place, distance)) => Some((place, place.saturating_add_signed(distance))),
        Some(Move::To(place, y)) => {
            let below = rows.iter().filter(|row| y > row.center().y).count();
            // It leaves its own place before it takes another one.
            Some((place, if below > place { below - 1 } else { below }))
        }
        None => None,
    };
    if let Some((from, to)) = target
        && to < chosen.len()
        && from != to
    {
        let item = chosen.remove(from);
        chosen.insert(to, item);
    }
}

/// How a thing is moved.
#[derive(Clone, Copy)]
enum Move {
    /// By so many places.
    By(usize, isize),
    /// To where the pointer is.
    To(usize, f32),
}

fn row(ui: &mut Ui, reader: &mut Reader, items: &[Line<Told>], chosen: &[usize], place: usize) -> (Rect, Option<Move>) {
    let palette = Palette::current(ui.ctx());
    let item = chosen[place];
    let Some(line) = items.get(item) else { return (Rect::NOTHING, None) };
    let mut asked = None;
    let frame = Frame::new().fill(palette.panel).stroke(Stroke::new(1.0, palette.edge)).corner_radius(4);
    let shown = frame.inner_margin(Margin::symmetric(6, 3)).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.horizontal(|ui| {
            asked = handle(ui, item, place);
            for (sign, word, distance) in [("▲", "lesson-up", -1_isize), ("▼", "lesson-down", 1)] {
                let is_possible = place.checked_add_signed(distance).is_some_and(|to| to < chosen.len());
                let name = say_with(ui.ctx(), word, &[("item", (&plain(line)).into())]);
                // The button belongs to the thing, so that the focus goes along with it.
                let button = ui.push_id((item, distance), |ui| ui.add_enabled(is_possible, Button::new(sign).small()));
                button.inner.widget_info(|| WidgetInfo::labeled(Role::Button, is_possible, &name));
                if button.inner.clicked() {
                    asked = Some(Move::By(place, distance));
                }
            }
            ui.label(format!("{}.", place + 1));
            reader.option(ui, line);
        });
    });
    (shown.response.rect, asked)
}

/// Where a thing is taken to be dragged.
fn handle(ui: &mut Ui, item: usize, place: usize) -> Option<Move> {
    let (rect, _) = ui.allocate_exact_size(vec2(14.0, 18.0), Sense::hover());
    let response = ui.interact(rect, ui.scope_id().with(("handle", item)), Sense::DRAG);
    let colour = Palette::current(ui.ctx()).weak;
    for y in [-4.0, 0.0, 4.0] {
        let c = rect.center() + vec2(0.0, y);
        ui.painter().line_segment([c - vec2(5.0, 0.0), c + vec2(5.0, 0.0)], Stroke::new(1.5, colour));
    }
    let about = say(ui.ctx(), "lesson-drag");
    let response = response.on_hover_cursor(CursorIcon::Grab).on_hover_text(about);
    let at = response.interact_pointer_pos().filter(|_| response.dragged())?;
    Some(Move::To(place, at.y))
}
