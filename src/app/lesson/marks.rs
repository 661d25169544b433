//! Places in the picture and in the side view that a question was answered with, and the right ones.

use super::answering::Mark;
use crate::app::frame::theme::Palette;
use egui::{Color32, Pos2, Rect, Stroke, Ui, vec2};

/// Draws them: a cross for a click, a ring for the right place. Light on dark, so that they are seen on any colour.
pub fn draw(ui: &Ui, marks: &[Mark], on_screen: impl Fn([f64; 2]) -> Pos2) {
    let accent = Palette::current(ui.ctx()).accent;
    for mark in marks {
        let c = on_screen(mark.at);
        for (width, ink) in [(4.5, Color32::from_black_alpha(200)), (2.0, Color32::WHITE)] {
            let stroke = Stroke::new(width, ink);
            if mark.is_right {
                ui.painter().circle_stroke(c, 9.0, stroke);
            } else {
                for arm in [vec2(5.0, 5.0), vec2(5.0, -5.0)] {
                    ui.painter().line_segment([c - arm, c + arm], stroke);
                }
            }
        }
        if mark.is_right {
            ui.painter().circle_stroke(c, 11.5, Stroke::new(2.0, accent));
        }
    }
}

/// A place of a drawing on screen.
pub fn within(rect: Rect, [x, y]: [f64; 2]) -> Pos2 {
    #[expect(clippy::cast_possible_truncation, reason = "screen coordinates are f32")]
    let shift = vec2(x as f32, y as f32);
    rect.min + shift
}
