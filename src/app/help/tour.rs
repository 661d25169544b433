//! The tour of the first visit: a few cards, each beside the panel that it is about.

use super::Outcome;
use crate::app::frame::theme::{Palette, bold};
use crate::app::frame::words::{say, say_with};
use crate::app::pane::Pane;
use crate::app::workbench::Workbench;
use egui::{Area, Frame, Id, Key, Order, Pos2, Rect, RichText, Stroke, StrokeKind, Ui};

/// Width of a card, in points.
const WIDTH: f32 = 320.0;
/// Height that a card is taken to have where it is placed, in points.
const HEIGHT: f32 = 170.0;

/// The stops: a panel, and the name of what is said of it in the catalogue of words.
const STOPS: [(Pane, &str); 6] = [
    (Pane::Picture, "tour-picture"),
    (Pane::Story, "tour-story"),
    (Pane::Detail, "tour-detail"),
    (Pane::Side, "tour-side"),
    (Pane::Along, "tour-along"),
    (Pane::Story, "tour-more"),
];

/// Where the tour is.
#[derive(Default)]
pub struct Tour {
    stop: usize,
}

impl Tour {
    /// Shows the card of this stop.
    pub fn ui(&mut self, ui: &Ui, workbench: &mut Workbench) -> Outcome {
        let (pane, word) = STOPS[self.stop.min(STOPS.len() - 1)];
        workbench.dock.reveal(pane);
        let window = ui.ctx().content_rect();
        let about = workbench.dock.rect_of(pane).unwrap_or(window);
        let accent = Palette::current(ui.ctx()).accent;
        let painter = ui.ctx().layer_painter(egui::LayerId::new(Order::Foreground, Id::unique("tour frame")));
        painter.rect_stroke(about.expand(2.0), 6.0, Stroke::new(3.0, accent), StrokeKind::Outside);
        let place = beside(about, window);
        let area = Area::new(Id::unique("tour")).order(Order::Tooltip).fixed_pos(place).constrain(true);
        area.show(ui.ctx(), |ui| Frame::popup(ui.style()).inner_margin(14).show(ui, |ui| self.card(ui, word)).inner)
            .inner
    }

    fn card(&mut self, ui: &mut Ui, word: &str) -> Outcome {
        ui.set_width(WIDTH);
        let (at, count) = (self.stop + 1, STOPS.len());
        let place = say_with(ui.ctx(), "tour-place", &[("at", at.into()), ("count", count.into())]);
        ui.label(RichText::new(place).small().weak());
        ui.label(RichText::new(say(ui.ctx(), word)).family(bold()).size(15.0));
        ui.label(say(ui.ctx(), &format!("{word}-about")));
        ui.add_space(6.0);
        let mut outcome = Outcome::Stay;
        ui.horizontal(|ui| {
            let is_last = at == count;
            let next = ui.button(say(ui.ctx(), if is_last { "tour-end" } else { "tour-next" }));
            let back = ui.add_enabled(self.stop > 0, egui::Button::new(say(ui.ctx(), "tour-back")));
            let skip = !is_last && ui.button(say(ui.ctx(), "tour-skip")).clicked();
            let (enter, escape) = ui.input(|input| (input.key_pressed(Key::Enter), input.key_pressed(Key::Escape)));
            if next.clicked() || (enter && !back.has_focus()) {
                self.stop += 1;
            } else if back.clicked() {
                self.stop -= 1;
            }
            if skip || escape || self.stop == count {
                outcome = Outcome::Close;
            }
        });
        outcome
    }
}

/// Beside what the card is about, on the side with more room.
fn beside(about: Rect, window: Rect) -> Pos2 {
    let gap = 12.0;
    let right = window.right() - about.right();
    let left = about.left() - window.left();
    let x = if right >= left { about.right() + gap } else { about.left() - gap - WIDTH - 28.0 };
    let y = (about.center().y - HEIGHT / 2.0).max(window.top() + gap).min((window.bottom() - HEIGHT - gap).max(gap));
    Pos2::new(x, y)
}
