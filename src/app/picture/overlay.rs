//! The mark of the recorded pixel over the picture.

use egui::{Color32, Painter, Rect, Stroke, StrokeKind, vec2};

/// Light on dark, so that it is seen on any colour, and open in the middle, so that the pixel itself is seen. Over a picture that
/// is hatched or coloured it stands on a ground of its own.
pub fn draw_crosshair(painter: &Painter, pixel: Rect, picture: Rect, is_covered: bool) {
    let painter = painter.with_clip_rect(painter.clip_rect().intersect(picture.expand(12.0)));
    let frame = pixel.expand(2.0);
    let arms = [
        (vec2(frame.left() - 14.0, pixel.center().y), vec2(frame.left() - 3.0, pixel.center().y)),
        (vec2(frame.right() + 3.0, pixel.center().y), vec2(frame.right() + 14.0, pixel.center().y)),
        (vec2(pixel.center().x, frame.top() - 14.0), vec2(pixel.center().x, frame.top() - 3.0)),
        (vec2(pixel.center().x, frame.bottom() + 3.0), vec2(pixel.center().x, frame.bottom() + 14.0)),
    ];
    if is_covered {
        let ground = Stroke::new(9.0, Color32::from_black_alpha(170));
        for (from, to) in arms {
            painter.line_segment([from.to_pos2(), to.to_pos2()], ground);
        }
    }
    for (width, ink) in [(3.5, Color32::from_black_alpha(200)), (1.5, Color32::WHITE)] {
        let stroke = Stroke::new(width, ink);
        for (from, to) in arms {
            painter.line_segment([from.to_pos2(), to.to_pos2()], stroke);
        }
        painter.rect_stroke(frame, 1.0, stroke, StrokeKind::Middle);
    }
}
