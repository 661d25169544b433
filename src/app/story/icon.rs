//! Pictures on the buttons that move and play, in the manner of a debugger's.

use crate::story::Step;
use egui::{Color32, Painter, Pos2, Shape, Stroke, Vec2, pos2, vec2};

/// What a button shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Icon {
    /// A move.
    Move(Step),
    /// To play.
    Play,
    /// To pause.
    Pause,
}

/// Draws it within 16 × 14 points about `c`.
pub fn draw(painter: &Painter, icon: Icon, c: Pos2, colour: Color32) {
    match icon {
        Icon::Move(step) => draw_move(painter, step, c, colour),
        Icon::Play => {
            let rim = [vec2(-4.5, -6.0), vec2(6.5, 0.0), vec2(-4.5, 6.0)].map(|corner| c + corner);
            painter.add(Shape::closed_line(rim.to_vec(), Stroke::new(1.8, colour)));
        }
        Icon::Pause => {
            for x in [-3.0, 3.0] {
                painter.line_segment([c + vec2(x, -5.5), c + vec2(x, 5.5)], Stroke::new(3.0, colour));
            }
        }
    }
}

fn draw_move(painter: &Painter, step: Step, c: Pos2, colour: Color32) {
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
                .map(|angle| c + vec2(0.0, 1.0) + 7.0 * Vec2::angled(-angle))
                .collect();
            painter.add(Shape::line(arc, line));
            let tip = c + vec2(7.0, 3.5);
            let head = vec![tip + vec2(-4.0, -4.0), tip + vec2(4.0, -4.0), tip];
            painter.add(Shape::convex_polygon(head, colour, Stroke::NONE));
            dot(c + vec2(0.0, 5.5));
        }
        Step::PreviousSame | Step::NextSame => {
            let right = if step == Step::NextSame { 1.0 } else { -1.0 };
            dot(c - vec2(6.0 * right, 0.0));
            arrow(painter, c - vec2(3.0 * right, 0.0), c + vec2(3.0 * right, 0.0), line);
            dot(c + vec2(6.5 * right, 0.0));
        }
        Step::PreviousStop | Step::NextStop => {
            let right = if step == Step::NextStop { 1.0 } else { -1.0 };
            triangle(c - vec2(2.5 * right, 0.0), right);
            painter.circle_stroke(c + vec2(5.0 * right, 0.0), 2.6, line);
        }
    }
}

fn arrow(painter: &Painter, from: Pos2, to: Pos2, line: Stroke) {
    painter.line_segment([from, to], line);
    let back = (from - to).normalized() * 4.5;
    let side = pos2(-back.y, back.x).to_vec2();
    painter.line_segment([to, to + back + side], line);
    painter.line_segment([to, to + back - side], line);
}
