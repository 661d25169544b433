//! The stepper: seven buttons, each with a picture, a word and a key.

use crate::app::frame::theme::Palette;
use crate::app::story::recording::Recording;
use crate::app::story::stepper::Step;
use egui::{
    Align2, Color32, FontId, Painter, Pos2, Rect, Response, Role, Sense, Shape, Stroke, StrokeKind, Ui, WidgetInfo,
    pos2, vec2,
};

/// Height of the toolbar, in points.
pub const HEIGHT: f32 = 50.0;

/// Shows the buttons.
pub fn ui(ui: &mut Ui, recording: Option<&mut Recording>) {
    let moves = Step::ALL.map(|step| {
        let target = recording.as_ref().and_then(|recording| step.target(&recording.tree, recording.selected()));
        (step, target)
    });
    let chosen = buttons(ui, &moves);
    if let (Some(recording), Some(step)) = (recording, chosen) {
        recording.step(step);
    }
}

/// `step 12 of 148`, counted from 1, and by which method, if not by the scene's own.
#[must_use]
pub fn position(recording: Option<&Recording>) -> String {
    let Some(recording) = recording else { return String::new() };
    let by = recording.by.map_or_else(String::new, |method| format!("by {} · ", method.name()));
    format!("{by}step {} of {}", recording.selected() + 1, recording.tree.end())
}

fn buttons(ui: &mut Ui, moves: &[(Step, Option<u32>)]) -> Option<Step> {
    let width = ((ui.available_width() - 6.0 * 4.0) / 7.0).min(64.0);
    ui.spacing_mut().item_spacing.x = 4.0;
    let mut chosen = None;
    ui.horizontal(|ui| {
        for &(step, target) in moves {
            let response = ui.add_enabled_ui(target.is_some(), |ui| button(ui, step, width)).inner;
            if response.clicked() {
                chosen = Some(step);
            }
        }
    });
    chosen
}

fn button(ui: &mut Ui, step: Step, width: f32) -> Response {
    let (rect, response) = ui.allocate_exact_size(vec2(width, HEIGHT - 8.0), Sense::click());
    let enabled = ui.is_enabled();
    response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, step.name()));
    let tip = format!("{} Key: {}", step.meaning(), key_name(step));
    let response = response.on_hover_text(&tip).on_disabled_hover_text(tip);
    let palette = Palette::current(ui.ctx());
    let style = ui.style().interact(&response);
    let painter = ui.painter();
    painter.rect(rect, style.corner_radius, style.weak_bg_fill, style.bg_stroke, StrokeKind::Inside);
    if response.has_focus() {
        painter.rect_stroke(rect.shrink(1.0), 4.0, Stroke::new(1.5, palette.accent), StrokeKind::Inside);
    }
    draw_icon(painter, step, pos2(rect.center().x, rect.top() + 14.0), palette.accent);
    let word = pos2(rect.center().x, rect.bottom() - 11.0);
    painter.text(word, Align2::CENTER_CENTER, step.name(), FontId::proportional(12.0), palette.text);
    response
}

fn key_name(step: Step) -> &'static str {
    step.key().name()
}

/// Pictures in the manner of a debugger's, within 16 × 14 points about `c`.
fn draw_icon(painter: &Painter, step: Step, c: Pos2, colour: Color32) {
    let line = Stroke::new(1.8, colour);
    let triangle = |at: Pos2, right: f32| {
        let points = vec![at + vec2(-4.0 * right, -5.5), at + vec2(5.0 * right, 0.0), at + vec2(-4.0 * right, 5.5)];
        painter.add(Shape::convex_polygon(points, colour, Stroke::NONE));
    };
    let bar = |x: f32| painter.line_segment([c + vec2(x, -5.5), c + vec2(x, 5.5)], line);
    let dot = |at: Pos2| painter.circle_filled(at, 2.3, colour);
    match step {
        Step::First => {
            bar(-5.5);
            triangle(c + vec2(1.5, 0.0), -1.0);
        }
        Step::Back => triangle(c, -1.0),
        Step::Next => triangle(c, 1.0),
        Step::Last => {
            bar(5.5);
            triangle(c - vec2(1.5, 0.0), 1.0);
        }
        Step::Into => {
            arrow(painter, c + vec2(0.0, -7.0), c + vec2(0.0, 2.0), line);
            dot(c + vec2(0.0, 5.5));
        }
        Step::Out => {
            arrow(painter, c + vec2(0.0, 2.0), c + vec2(0.0, -7.0), line);
            dot(c + vec2(0.0, 5.5));
        }
        Step::Over => {
            let arc: Vec<Pos2> = (0..=12)
                .map(|i| std::f32::consts::PI * (1.0 - i as f32 / 12.0))
                .map(|angle| c + vec2(7.0 * angle.cos(), 1.0 - 7.0 * angle.sin()))
                .collect();
            painter.add(Shape::line(arc, line));
            let tip = c + vec2(7.0, 3.5);
            let head = vec![tip + vec2(-4.0, -4.0), tip + vec2(4.0, -4.0), tip];
            painter.add(Shape::convex_polygon(head, colour, Stroke::NONE));
            dot(c + vec2(0.0, 5.5));
        }
    }
}

fn arrow(painter: &Painter, from: Pos2, to: Pos2, line: Stroke) {
    painter.line_segment([from, to], line);
    let back = (from - to).normalized() * 4.5;
    let side = vec2(-back.y, back.x);
    painter.line_segment([to, to + back + side], line);
    painter.line_segment([to, to + back - side], line);
}

/// The room that the toolbar takes of `rect`, and what is left below it.
#[must_use]
pub fn cut(rect: Rect) -> (Rect, Rect) {
    rect.split_top_bottom_at_y(rect.top() + HEIGHT)
}
