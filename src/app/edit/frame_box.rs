//! The box around the thing that is being edited, over the picture.

use crate::app::picture::placement::Placement;
use crate::scene::{LightKind, Scene};
use egui::{Color32, Painter, Pos2, Rect, Stroke, vec2};
use glam::DVec3;

/// Pairs of corners, numbered by bits for x, y and z, with an edge between them.
const EDGES: [[usize; 2]; 12] =
    [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];

/// Draws the edges of a solid's box, dashed, so that they are seen to be no part of the scene. A solid without bounds has none.
pub fn draw_box(painter: &Painter, scene: &Scene, place: &Placement, low: DVec3, high: DVec3) {
    if !(low.is_finite() && high.is_finite()) {
        return;
    }
    let corner = |i: usize| {
        let pick = |bit: usize, axis: usize| if i & bit == 0 { low[axis] } else { high[axis] };
        let point = DVec3::new(pick(1, 0), pick(2, 1), pick(4, 2));
        scene.camera.project(scene.image, point).map(|pixel| place.on_screen(pixel))
    };
    let painter = painter.with_clip_rect(painter.clip_rect().intersect(place.rect));
    for [from, to] in EDGES {
        if let (Some(from), Some(to)) = (corner(from), corner(to)) {
            dashed(&painter, from, to);
        }
    }
}

/// Light on dark dashes, seen on any colour.
fn dashed(painter: &Painter, from: Pos2, to: Pos2) {
    // A corner almost beside the eye lies millions of points away; nobody has room for so many dashes.
    let Some([from, to]) = within(painter.clip_rect().expand(10.0), from, to) else { return };
    painter.line_segment([from, to], Stroke::new(2.5, Color32::from_black_alpha(110)));
    painter.extend(egui::Shape::dashed_line(&[from, to], Stroke::new(1.2, Color32::WHITE), 5.0, 4.0));
}

/// The part of a line that lies in a rectangle, after Liang and Barsky (1984), "A New Concept and Method for Line Clipping".
fn within(rect: Rect, from: Pos2, to: Pos2) -> Option<[Pos2; 2]> {
    let way = to - from;
    let (mut first, mut last) = (0.0_f32, 1.0_f32);
    for (start, step, low, high) in
        [(from.x, way.x, rect.left(), rect.right()), (from.y, way.y, rect.top(), rect.bottom())]
    {
        if step == 0.0 {
            if start < low || start > high {
                return None;
            }
            continue;
        }
        let (one, other) = ((low - start) / step, (high - start) / step);
        first = first.max(one.min(other));
        last = last.min(one.max(other));
    }
    (first < last).then(|| [from + way * first, from + way * last])
}

/// Draws a cross with arrows where a thing without a box is.
pub fn draw_spot(painter: &Painter, scene: &Scene, place: &Placement, at: DVec3) {
    let Some(at) = scene.camera.project(scene.image, at).map(|pixel| place.on_screen(pixel)) else { return };
    for (width, colour) in [(3.5, Color32::from_black_alpha(160)), (1.5, Color32::WHITE)] {
        let stroke = Stroke::new(width, colour);
        painter.line_segment([at - vec2(9.0, 0.0), at + vec2(9.0, 0.0)], stroke);
        painter.line_segment([at - vec2(0.0, 9.0), at + vec2(0.0, 9.0)], stroke);
        painter.circle_stroke(at, 5.0, stroke);
    }
}

/// Where a light is; none for one infinitely far away.
#[must_use]
pub fn place_of_light(scene: &Scene, index: usize) -> Option<DVec3> {
    match &scene.lights.get(index)?.kind {
        LightKind::Point(at) => Some(*at),
        LightKind::Area(area) => Some(area.middle()),
        LightKind::Directional(_) => None,
    }
}
