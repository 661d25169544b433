//! The picture: hover to read a pixel, click to record it, arrow keys to go to its neighbours.

use super::recording::{HitMark, Recording};
use super::theme::{Palette, colour};
use crate::record::{Counter, Entry, NullRecorder, RayKind, Recorder, What, format_number};
use crate::scene::{Rgb, Scene};
use crate::trace::{srgb, trace_pixel};
use egui::{
    Color32, EventFilter, Key, Painter, Pos2, Rect, Response, Role, Sense, Stroke, StrokeKind, TextureHandle, Ui, Vec2,
    WidgetInfo, pos2, vec2,
};

/// Height of the line below the picture that reads the pixel under the pointer.
const READOUT: f32 = 26.0;

/// The pixel under the pointer, as traced.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    pixel: [u32; 2],
    linear: Rgb,
    object: Option<String>,
}

/// What the picture's panel remembers between frames.
#[derive(Debug, Default)]
pub struct ImagePanel {
    reading: Option<Reading>,
}

/// What the panel shows.
pub struct ImageView<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The picture as far as it goes.
    pub texture: Option<TextureHandle>,
    /// The recorded pixel.
    pub recording: Option<&'a Recording>,
}

impl ImagePanel {
    /// Forgets what was read: the scene has changed.
    pub fn reset(&mut self) {
        self.reading = None;
    }

    /// Shows the picture; returns the pixel that was chosen, if one was.
    pub fn ui(&mut self, ui: &mut Ui, view: &ImageView) -> Option<[u32; 2]> {
        let palette = Palette::current(ui.ctx());
        let (above, line) = {
            let all = ui.available_rect_before_wrap();
            all.split_top_bottom_at_y(all.bottom() - READOUT)
        };
        ui.painter().rect_filled(above, 0.0, palette.backdrop);
        let place = Placement::fit(view.scene, above.shrink(8.0), ui.pixels_per_point());
        let response = ui.interact(place.rect, ui.scope_id().with("picture"), Sense::click());
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, "Rendered image"));
        let response = response.on_hover_cursor(egui::CursorIcon::Crosshair);

        let painter = ui.painter_at(above);
        match &view.texture {
            Some(texture) => {
                painter.image(texture.id(), place.rect, unit_square(), Color32::WHITE);
            }
            None => {
                painter.rect_filled(place.rect, 0.0, palette.panel);
            }
        }
        painter.rect_stroke(place.rect, 0.0, Stroke::new(1.0, palette.edge), StrokeKind::Outside);
        if let Some(recording) = view.recording {
            draw_hits(&painter, view.scene, &place, recording);
            draw_crosshair(&painter, place.pixel_rect(recording.pixel), place.rect);
        }
        if response.has_focus() {
            painter.rect_stroke(place.rect, 0.0, Stroke::new(2.0, palette.accent), StrokeKind::Outside);
        }

        let hovered = response.hover_pos().and_then(|position| place.pixel_at(position));
        self.read(view.scene, hovered);
        self.readout(ui, line, view);
        chosen(ui, &response, &place, view.recording.map(|recording| recording.pixel))
    }

    fn read(&mut self, scene: &Scene, hovered: Option<[u32; 2]>) {
        if self.reading.as_ref().map(|reading| reading.pixel) != hovered {
            self.reading = hovered.map(|pixel| read_pixel(scene, pixel));
        }
    }

    /// `(310, 240) · bowl · linear (0.5, 0.2, 0.1) · sRGB 188, 124, 89`.
    fn readout(&self, ui: &mut Ui, line: Rect, view: &ImageView) {
        let palette = Palette::current(ui.ctx());
        let focused = view.recording.map(|recording| recording.pixel);
        let (text, swatch) = match (&self.reading, focused) {
            (Some(reading), _) => (describe(reading), Some(srgb(reading.linear))),
            (None, Some([x, y])) => {
                (format!("Pixel ({x}, {y}) is recorded. Click another, or use the arrow keys."), None)
            }
            (None, None) => ("Click a pixel to record what its ray does.".to_owned(), None),
        };
        let mut x = line.left() + 10.0;
        if let Some([r, g, b]) = swatch {
            let square = Rect::from_center_size(pos2(x + 6.0, line.center().y), Vec2::splat(12.0));
            ui.painter().rect_filled(square, 2.0, Color32::from_rgb(r, g, b));
            ui.painter().rect_stroke(square, 2.0, Stroke::new(1.0, palette.edge), StrokeKind::Outside);
            x += 20.0;
        }
        let place = Rect::from_min_max(pos2(x, line.top()), line.max - vec2(8.0, 0.0));
        let label = egui::Label::new(egui::RichText::new(text).size(12.0).color(palette.weak)).truncate();
        let builder = egui::UiBuilder::new().max_rect(place).layout(egui::Layout::left_to_right(egui::Align::Center));
        ui.scope_builder(builder, |ui| ui.add(label));
    }
}

fn describe(reading: &Reading) -> String {
    let [x, y] = reading.pixel;
    let [r, g, b] = srgb(reading.linear);
    let linear = reading.linear.to_array().map(format_number).join(", ");
    let object = reading.object.as_deref().unwrap_or("background");
    format!("({x}, {y}) · {object} · linear {linear} · sRGB {r}, {g}, {b}")
}

/// Where the picture lies on screen.
struct Placement {
    rect: Rect,
    size: [u32; 2],
}

impl Placement {
    /// The largest picture that fits, in whole screen pixels per pixel if that costs no more than a fifth of its size.
    fn fit(scene: &Scene, room: Rect, pixels_per_point: f32) -> Self {
        let size = [scene.image.width, scene.image.height];
        let points = vec2(size[0] as f32, size[1] as f32) / pixels_per_point;
        let largest = (room.width() / points.x).min(room.height() / points.y).max(0.0);
        let whole = largest.floor();
        let scale = if whole >= 0.8 * largest && whole >= 1.0 { whole } else { largest };
        let min = room.center() - points * scale / 2.0;
        let min = pos2((min.x * pixels_per_point).round(), (min.y * pixels_per_point).round()) / pixels_per_point;
        Self { rect: Rect::from_min_size(min, points * scale), size }
    }

    /// The corner of a picture's pixel on screen; continuous, so that (0.5, 0.5) is the middle of the first.
    fn on_screen(&self, [x, y]: [f64; 2]) -> Pos2 {
        #[expect(clippy::cast_possible_truncation, reason = "screen coordinates are f32")]
        let share = vec2(x as f32 / self.size[0] as f32, y as f32 / self.size[1] as f32);
        self.rect.min + share * self.rect.size()
    }

    fn pixel_rect(&self, [x, y]: [u32; 2]) -> Rect {
        let (x, y) = (f64::from(x), f64::from(y));
        Rect::from_min_max(self.on_screen([x, y]), self.on_screen([x + 1.0, y + 1.0]))
    }

    fn pixel_at(&self, position: Pos2) -> Option<[u32; 2]> {
        let share = (position - self.rect.min) / self.rect.size();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "inside the picture, see below")]
        let pixel = [(share.x * self.size[0] as f32) as u32, (share.y * self.size[1] as f32) as u32];
        let inside = share.x >= 0.0 && share.y >= 0.0 && pixel[0] < self.size[0] && pixel[1] < self.size[1];
        inside.then_some(pixel)
    }
}

fn unit_square() -> Rect {
    Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0))
}

/// The pixel that a click or an arrow key chose.
fn chosen(ui: &Ui, response: &Response, place: &Placement, recorded: Option<[u32; 2]>) -> Option<[u32; 2]> {
    if response.clicked() {
        response.request_focus();
        return response.interact_pointer_pos().and_then(|position| place.pixel_at(position));
    }
    if !response.has_focus() {
        return None;
    }
    let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    let [x, y] = recorded?;
    let [width, height] = place.size;
    let pixel = ui.input(|input| {
        let stride = if input.modifiers.shift { 10 } else { 1 };
        let moved = |at: u32, back, forward, end: u32| {
            let at = if input.key_pressed(back) { at.saturating_sub(stride) } else { at };
            if input.key_pressed(forward) { (at + stride).min(end - 1) } else { at }
        };
        [moved(x, Key::ArrowLeft, Key::ArrowRight, width), moved(y, Key::ArrowUp, Key::ArrowDown, height)]
    });
    (pixel != [x, y]).then_some(pixel)
}

/// Light on dark, so that it is seen on any colour, and open in the middle, so that the pixel itself is seen.
fn draw_crosshair(painter: &Painter, pixel: Rect, picture: Rect) {
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
fn draw_hits(painter: &Painter, scene: &Scene, place: &Placement, recording: &Recording) {
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
    })
}

fn read_pixel(scene: &Scene, pixel: [u32; 2]) -> Reading {
    let mut listener = FirstHit::default();
    let _ = trace_pixel(scene, pixel[0], pixel[1], &mut listener);
    let linear = trace_pixel(scene, pixel[0], pixel[1], &mut NullRecorder);
    Reading { pixel, linear, object: listener.object }
}

/// Listens for the name of the object that is seen, and to nothing after it.
#[derive(Default)]
struct FirstHit {
    object: Option<String>,
    decided: bool,
}

impl Recorder for FirstHit {
    const RECORDING: bool = true;

    fn begin(&mut self) {}

    fn end(&mut self, describe: impl FnOnce() -> Entry) {
        if self.decided {
            return;
        }
        match describe().what {
            What::Hit { object, .. } => (self.object, self.decided) = (Some(object), true),
            What::Nothing { .. } => self.decided = true,
            _ => {}
        }
    }

    fn count(&mut self, _counter: Counter) {}
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place() -> Placement {
        Placement { rect: Rect::from_min_size(pos2(10.0, 20.0), vec2(40.0, 20.0)), size: [4, 2] }
    }

    #[test]
    fn a_point_on_screen_belongs_to_the_pixel_drawn_there() {
        assert_eq!(place().pixel_at(pos2(10.0, 20.0)), Some([0, 0]));
        assert_eq!(place().pixel_at(pos2(49.9, 39.9)), Some([3, 1]));
        assert_eq!(place().pixel_at(pos2(9.9, 30.0)), None);
        assert_eq!(place().pixel_at(pos2(30.0, 40.1)), None);
    }

    #[test]
    fn a_pixel_covers_its_share_of_the_picture() {
        assert_eq!(place().pixel_rect([1, 1]), Rect::from_min_max(pos2(20.0, 30.0), pos2(30.0, 40.0)));
    }
}
