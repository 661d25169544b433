//! Drawings as pixels. The only file that knows tiny-skia.

use super::drawing::{Anchor, Drawing, Form, Frame, HALO, Spot, Stroke, Text};
use super::fonts::glyphs;
use super::outline::Pen;
use super::palette::Colour;
use crate::math::portable;
use ab_glyph::OutlineCurve;
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, PremultipliedColorU8, StrokeDash, Transform,
};

/// A painted drawing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixels {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Red, green, blue and straight alpha for each pixel, row by row.
    pub rgba: Vec<u8>,
}

/// Paints a drawing.
#[must_use]
pub fn paint(drawing: &Drawing, pixels_per_point: f32) -> Pixels {
    let Some(pixmap) = painted(drawing, pixels_per_point) else {
        return Pixels { width: 0, height: 0, rgba: Vec::new() };
    };
    let straight = |pixel: &PremultipliedColorU8| {
        let colour = pixel.demultiply();
        [colour.red(), colour.green(), colour.blue(), colour.alpha()]
    };
    let rgba = pixmap.pixels().iter().flat_map(straight).collect();
    Pixels { width: pixmap.width(), height: pixmap.height(), rgba }
}

/// Paints a drawing as a PNG file.
#[must_use]
pub fn png(drawing: &Drawing, pixels_per_point: f32) -> Vec<u8> {
    painted(drawing, pixels_per_point).and_then(|pixmap| pixmap.encode_png().ok()).unwrap_or_default()
}

fn painted(drawing: &Drawing, pixels_per_point: f32) -> Option<Pixmap> {
    let scale = if pixels_per_point.is_finite() { pixels_per_point.clamp(0.1, 16.0) } else { 1.0 };
    let pixels = |points: f64| whole((points * f64::from(scale)).round(), 32_768);
    let mut pixmap = Pixmap::new(pixels(drawing.width), pixels(drawing.height))?;
    let Colour { r, g, b, a } = drawing.background;
    pixmap.fill(Color::from_rgba8(r, g, b, a));
    let mut painter = Painter { pixmap, transform: Transform::from_scale(scale, scale) };
    for mark in &drawing.marks {
        painter.form(&mark.form);
    }
    Some(painter.pixmap)
}

/// Outlines of one colour on a clear ground, and the whole rows above a height; the colours multiplied with alpha. No formula has
/// 2¹⁵ rows or columns.
pub(super) fn stamped(size: [f64; 2], above: f64, outlines: &[Vec<Pen>], colour: Colour) -> (Pixels, u32) {
    let [width, height] = size.map(|x| whole(x, 32_768));
    let Some(pixmap) = Pixmap::new(width, height) else {
        return (Pixels { width: 0, height: 0, rgba: Vec::new() }, 0);
    };
    let mut painter = Painter { pixmap, transform: Transform::identity() };
    for steps in outlines {
        painter.outline(steps, colour);
    }
    (Pixels { width, height, rgba: painter.pixmap.take() }, whole(above, height))
}

struct Painter {
    pixmap: Pixmap,
    transform: Transform,
}

impl Painter {
    fn form(&mut self, form: &Form) {
        match form {
            Form::Line { points, stroke } => self.stroke(polyline(points, false), stroke),
            Form::Area { rings, fill } => self.fill(closed(rings), *fill),
            Form::Circle { centre, radius, fill, stroke } => {
                let path = || PathBuilder::from_circle(narrow(centre[0]), narrow(centre[1]), narrow(*radius));
                self.fill_if(path(), *fill);
                self.stroke_if(path(), *stroke);
            }
            Form::Arc { centre, radius, angles, stroke } => {
                self.stroke(polyline(&arc_points(*centre, *radius, *angles), false), stroke);
            }
            Form::Arrow { from, to, head, stroke } => {
                let (shaft_end, tip) = arrow_head(*from, *to, *head);
                self.stroke(polyline(&[*from, shaft_end], false), stroke);
                self.fill(polyline(&tip, true), stroke.colour);
            }
            Form::Rect { frame, fill, stroke } => {
                self.fill_if(polyline(&corners(frame), true), *fill);
                self.stroke_if(polyline(&corners(frame), true), *stroke);
            }
            Form::Text(text) => self.text(text),
            Form::Outline { steps, fill } => self.outline(steps, *fill),
        }
    }

    fn outline(&mut self, steps: &[Pen], fill: Colour) {
        let Some(path) = pen_path(steps) else { return };
        self.pixmap.fill_path(&path, &paint_of(fill), FillRule::Winding, self.transform, None);
    }

    fn fill_if(&mut self, path: Option<Path>, colour: Option<Colour>) {
        if let Some(colour) = colour {
            self.fill(path, colour);
        }
    }

    fn stroke_if(&mut self, path: Option<Path>, stroke: Option<Stroke>) {
        if let Some(stroke) = stroke {
            self.stroke(path, &stroke);
        }
    }

    fn fill(&mut self, path: Option<Path>, colour: Colour) {
        if let Some(path) = path {
            self.pixmap.fill_path(&path, &paint_of(colour), FillRule::EvenOdd, self.transform, None);
        }
    }

    fn stroke(&mut self, path: Option<Path>, stroke: &Stroke) {
        let Some(path) = path else { return };
        let dash = stroke.dash.and_then(|dash| StrokeDash::new(dash.map(narrow).to_vec(), 0.0));
        let line_cap = if dash.is_some() { LineCap::Butt } else { LineCap::Round };
        let stroke_of = tiny_skia::Stroke {
            width: narrow(stroke.width),
            line_cap,
            line_join: LineJoin::Round,
            dash,
            ..Default::default()
        };
        self.pixmap.stroke_path(&path, &paint_of(stroke.colour), &stroke_of, self.transform, None);
    }

    fn text(&mut self, text: &Text) {
        let path = text_path(text);
        if let (Some(halo), Some(path)) = (text.halo, &path) {
            self.stroke(Some(path.clone()), &Stroke::solid(halo, HALO * text.size));
        }
        let Some(path) = path else { return };
        // Letters overlap themselves where strokes cross, so they are filled by winding.
        self.pixmap.fill_path(&path, &paint_of(text.colour), FillRule::Winding, self.transform, None);
    }
}

/// tiny-skia computes in `f32`: a canvas of 16,384 points has 2⁻¹⁰ of a point left.
#[expect(clippy::cast_possible_truncation, reason = "see above")]
fn narrow(x: f64) -> f32 {
    x as f32
}

/// A whole number of at least 1 and at most `most`.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the range of u32")]
fn whole(x: f64, most: u32) -> u32 {
    x.clamp(1.0, f64::from(most)) as u32
}

fn paint_of(colour: Colour) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Default::default() };
    paint.set_color_rgba8(colour.r, colour.g, colour.b, colour.a);
    paint
}

fn polyline(points: &[Spot], close: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    add_ring(&mut path, points, close);
    path.finish()
}

fn closed(rings: &[Vec<Spot>]) -> Option<Path> {
    let mut path = PathBuilder::new();
    for ring in rings {
        add_ring(&mut path, ring, true);
    }
    path.finish()
}

fn add_ring(path: &mut PathBuilder, points: &[Spot], close: bool) {
    if points.len() < 2 {
        return;
    }
    for (i, at) in points.iter().enumerate() {
        let [x, y] = at.map(narrow);
        if i == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
    }
    if close {
        path.close();
    }
}

/// A polyline within a hundredth of a point of the arc.
fn arc_points(centre: Spot, radius: f64, angles: [f64; 2]) -> Vec<Spot> {
    let steps = whole(((angles[1] - angles[0]).abs() * radius.sqrt() * 3.6).ceil().max(4.0), 360);
    let at = |step: u32| {
        let angle = angles[0] + (angles[1] - angles[0]) * f64::from(step) / f64::from(steps);
        [centre[0] + radius * portable::cos(angle), centre[1] + radius * portable::sin(angle)]
    };
    (0..=steps).map(at).collect()
}

/// Where the shaft ends, and the triangle of the head.
pub(super) fn arrow_head(from: Spot, to: Spot, head: f64) -> (Spot, [Spot; 3]) {
    let along = [to[0] - from[0], to[1] - from[1]];
    let length = super::drawing::length(along);
    if length == 0.0 {
        return (to, [to; 3]);
    }
    let head = head.min(length);
    let unit = along.map(|x| x / length);
    let back = [to[0] - unit[0] * head, to[1] - unit[1] * head];
    let side = [-unit[1] * head * 0.38, unit[0] * head * 0.38];
    // The shaft ends within the head, so that no gap shows between them.
    let shaft_end = [to[0] - unit[0] * head * 0.8, to[1] - unit[1] * head * 0.8];
    (shaft_end, [to, [back[0] + side[0], back[1] + side[1]], [back[0] - side[0], back[1] - side[1]]])
}

fn corners(frame: &Frame) -> [Spot; 4] {
    let ([x0, y0], [x1, y1]) = (frame.low, frame.high);
    [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
}

fn text_path(text: &Text) -> Option<Path> {
    let left = match text.anchor {
        Anchor::Start => text.at[0],
        Anchor::Middle | Anchor::End => text.frame().low[0],
    };
    let (size, baseline) = (narrow(text.size), narrow(text.at[1]));
    let mut path = PathBuilder::new();
    for glyph in glyphs(&text.text, text.face) {
        let place = |p: ab_glyph::Point| {
            (narrow(left) + (glyph.x + p.x * glyph.scale) * size, baseline - p.y * glyph.scale * size)
        };
        add_outline(&mut path, &glyph.curves, place);
    }
    path.finish()
}

/// Adds the closed contours of a glyph; a new one begins wherever a curve does not start at the last one's end.
fn add_outline(path: &mut PathBuilder, curves: &[OutlineCurve], place: impl Fn(ab_glyph::Point) -> (f32, f32)) {
    let mut pen = None;
    for curve in curves {
        let (start, end) = match curve {
            OutlineCurve::Line(a, b) | OutlineCurve::Quad(a, _, b) | OutlineCurve::Cubic(a, _, _, b) => (*a, *b),
        };
        if pen != Some(start) {
            if pen.is_some() {
                path.close();
            }
            let (x, y) = place(start);
            path.move_to(x, y);
        }
        let (x, y) = place(end);
        match curve {
            OutlineCurve::Line(..) => path.line_to(x, y),
            OutlineCurve::Quad(_, c, _) => {
                let (cx, cy) = place(*c);
                path.quad_to(cx, cy, x, y);
            }
            OutlineCurve::Cubic(_, c, d, _) => {
                let ((cx, cy), (dx, dy)) = (place(*c), place(*d));
                path.cubic_to(cx, cy, dx, dy, x, y);
            }
        }
        pen = Some(end);
    }
    if pen.is_some() {
        path.close();
    }
}

fn pen_path(steps: &[Pen]) -> Option<Path> {
    let mut path = PathBuilder::new();
    for step in steps {
        match *step {
            Pen::Move([x, y]) => path.move_to(narrow(x), narrow(y)),
            Pen::Line([x, y]) => path.line_to(narrow(x), narrow(y)),
            Pen::Quad(c, end) => {
                let ([cx, cy], [x, y]) = (c.map(narrow), end.map(narrow));
                path.quad_to(cx, cy, x, y);
            }
            Pen::Cubic(c, d, end) => {
                let ([cx, cy], [dx, dy], [x, y]) = (c.map(narrow), d.map(narrow), end.map(narrow));
                path.cubic_to(cx, cy, dx, dy, x, y);
            }
            Pen::Close => path.close(),
        }
    }
    path.finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::{Face, Theme};

    #[test]
    fn an_area_with_a_hole_is_painted_by_even_and_odd() {
        let palette = Theme::Light.palette();
        let mut drawing = Drawing::new([40.0, 40.0], palette.ground);
        let square = |low: f64, high: f64| vec![[low, low], [high, low], [high, high], [low, high]];
        drawing.put(Form::Area { rings: vec![square(4.0, 36.0), square(12.0, 28.0)], fill: palette.left }, None);
        let pixels = paint(&drawing, 2.0);
        assert_eq!((pixels.width, pixels.height), (80, 80));
        let at = |x: usize, y: usize| &pixels.rgba[(y * 80 + x) * 4..][..4];
        let Colour { r, g, b, .. } = palette.left;
        assert_eq!(at(16, 16), [r, g, b, 255]);
        assert_eq!(at(40, 40), [255, 255, 255, 255]);
        assert_eq!(at(2, 2), [255, 255, 255, 255]);
    }

    #[test]
    fn a_text_is_painted_within_its_frame() {
        let palette = Theme::Light.palette();
        let mut drawing = Drawing::new([200.0, 40.0], palette.ground);
        let text = Text {
            at: [100.0, 25.0],
            text: "Ágy √θ₁ ∩ (−1)".into(),
            anchor: Anchor::Middle,
            size: 14.0,
            colour: palette.ink,
            face: Face::Sans,
            halo: None,
        };
        let frame = text.frame().grown(1.5);
        drawing.put(Form::Text(text), None);
        let pixels = paint(&drawing, 1.0);
        let mut painted = 0;
        for (i, pixel) in pixels.rgba.chunks(4).enumerate() {
            if pixel != [255; 4] {
                painted += 1;
                let at = [(i % 200) as f64, (i / 200) as f64];
                // The accent of the capital rises above the frame by design.
                assert!(frame.contains(at) || at[1] > 10.0, "{at:?}");
            }
        }
        assert!(painted > 200, "{painted}");
    }
}
