//! What is drawn over the picture: the recorded pixel, and the hits of its rays.

use crate::app::frame::theme::colour;
use crate::app::picture::placement::Placement;
use crate::app::story::recording::{HitMark, Recording};
use crate::record::RayKind;
use crate::scene::Scene;
use egui::{Color32, Painter, Rect, Stroke, StrokeKind, vec2};

/// Light on dark, so that it is seen on any colour, and open in the middle, so that the pixel itself is seen.
pub fn draw_crosshair(painter: &Painter, pixel: Rect, picture: Rect) {
    let painter = painter.with_clip_rect(painter.clip_rect().intersect(picture.expand(12.0)));
    let frame = pixel.expand(2.0);
    let arms = [
        (vec2(frame.left() - 14.0, pixel.center().y), vec2(frame.left() - 3.0, pixel.center().y)),
        (vec2(frame.right() + 3.0, pixel.center().y), vec2(frame.right() + 14.0, pixel.center().y)),
        (vec2(pixel.center().x, frame.top() - 14.0), vec2(pixel.center().x, frame.top() - 3.0)),
        (vec2(pixel.center().x, frame.bottom() + 3.0), vec2(pixel.center().x, frame.bottom() + 14.0)),
    ];
    for (width, ink) in [(3.5, Color32::from_black_alpha(200)), (1.5, Color32::WHITE)] {
        let stroke = Stroke::new(width, ink);
        for (from, to) in arms {
            painter.line_segment([from.to_pos2(), to.to_pos2()], stroke);
        }
        painter.rect_stroke(frame, 1.0, stroke, StrokeKind::Middle);
    }
}

/// The hits up to the selected event, and the spawned rays that led to them, as the camera sees them.
pub fn draw_hits(painter: &Painter, scene: &Scene, place: &Placement, recording: &Recording) {
    let seen = |point| scene.camera.project(scene.image, point).map(|pixel| place.on_screen(pixel));
    let painter = painter.with_clip_rect(painter.clip_rect().intersect(place.rect));
    for HitMark { event, kind, from, point } in &recording.hits {
        if *event > recording.selected() {
            break;
        }
        let Some(at) = seen(*point) else { continue };
        if let Some(from) = from.and_then(seen) {
            painter.line_segment([from, at], Stroke::new(3.0, Color32::from_black_alpha(150)));
            painter.line_segment([from, at], Stroke::new(1.5, ray_colour(*kind)));
        }
        if *kind != RayKind::Camera {
            painter.circle(at, 3.5, ray_colour(*kind), Stroke::new(1.0, Color32::from_black_alpha(200)));
        }
    }
}

/// Rays have the colours of the drawings on dark ground: with a dark rim they are seen on any colour.
fn ray_colour(kind: RayKind) -> Color32 {
    let palette = crate::view::Theme::Dark.palette();
    colour(match kind {
        RayKind::Camera => palette.camera,
        RayKind::Reflected => palette.reflected,
        RayKind::Refracted => palette.refracted,
        RayKind::Shadow => palette.shadow,
        RayKind::Scattered => palette.scattered,
    })
}
