//! The picture: hover to read a pixel, click to record it, arrow keys to go to its neighbours.

use crate::app::frame::theme::Palette;
use crate::app::frame::words::{say, say_with};
use crate::app::picture::hits::Hits;
use crate::app::picture::overlay::draw_crosshair;
use crate::app::picture::placement::Placement;
use crate::app::picture::reading::Reading;
use crate::app::search::pane::Layer;
use crate::app::story::recording::Recording;
use crate::scene::Scene;
use egui::{
    Color32, EventFilter, Id, Key, Pos2, Rect, Response, Role, Sense, Stroke, StrokeKind, TextureHandle, Ui, Vec2,
    WidgetInfo, pos2, vec2,
};

/// Height of the line below the picture that reads the pixel under the pointer.
const READOUT: f32 = 26.0;

/// What the picture's panel remembers between frames.
#[derive(Debug, Default)]
pub struct ImagePanel {
    reading: Option<Reading>,
    hits: Hits,
    /// Where the picture lies on screen, and the widget that it is.
    pub seen: Option<(Placement, Id)>,
    /// Where it was clicked in this frame, in its pixels.
    pub clicked: Option<[f64; 2]>,
}

/// What the panel shows.
pub struct ImageView<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The picture as far as it goes.
    pub texture: Option<TextureHandle>,
    /// The recorded pixel.
    pub recording: Option<&'a Recording>,
    /// What lies over the picture, the lowest first.
    pub layers: &'a [Layer],
    /// What is told of a pixel besides its colour.
    pub told: &'a dyn Fn([u32; 2]) -> Option<String>,
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
        let name = say(ui.ctx(), "picture-name");
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &name));
        let response = response.on_hover_cursor(egui::CursorIcon::Crosshair);
        self.seen = Some((place, response.id));
        let click = response.interact_pointer_pos().filter(|_| response.clicked());
        self.clicked = click.map(|at| place.in_pixels(at));

        let painter = ui.painter_at(above);
        match &view.texture {
            Some(texture) => {
                painter.image(texture.id(), place.rect, unit_square(), Color32::WHITE);
            }
            None => {
                painter.rect_filled(place.rect, 0.0, palette.panel);
            }
        }
        for layer in view.layers {
            painter.image(layer.texture.id(), place.rect, unit_square(), layer.tint);
        }
        painter.rect_stroke(place.rect, 0.0, Stroke::new(1.0, palette.edge), StrokeKind::Outside);
        if let Some(recording) = view.recording {
            self.hits.draw(&painter, view.scene, &place, recording);
            // A ray of its own goes through no pixel.
            if recording.loose_ray().is_none() {
                draw_crosshair(&painter, place.pixel_rect(recording.pixel), place.rect, !view.layers.is_empty());
            }
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
            self.reading = hovered.map(|pixel| Reading::of(scene, pixel));
        }
    }

    /// The line below the picture.
    fn readout(&self, ui: &mut Ui, line: Rect, view: &ImageView) {
        let palette = Palette::current(ui.ctx());
        let of_pixel = view.recording.filter(|recording| recording.loose_ray().is_none());
        let focused = of_pixel.map(|recording| recording.pixel);
        let (text, swatch) = match (&self.reading, focused) {
            (Some(reading), _) => {
                let told = (view.told)(reading.pixel).map(|told| format!(" · {told}")).unwrap_or_default();
                (reading.text() + &told, Some(reading.srgb()))
            }
            (None, Some([x, y])) => (say_with(ui.ctx(), "picture-recorded", &[("x", x.into()), ("y", y.into())]), None),
            (None, None) => (say(ui.ctx(), "picture-none"), None),
        };
        let mut x = line.left() + 10.0;
        if let Some([r, g, b]) = swatch {
            let square = Rect::from_center_size(pos2(x + 6.0, line.center().y), Vec2::splat(12.0));
            ui.painter().rect_filled(square, 2.0, Color32::from_rgb(r, g, b));
            ui.painter().rect_stroke(square, 2.0, Stroke::new(1.0, palette.edge), StrokeKind::Outside);
            x += 20.0;
        }
        let place = Rect::from_min_max(pos2(x, line.top()), line.max - vec2(8.0, 0.0));
        let label = egui::Label::new(egui::RichText::new(text).small().color(palette.weak)).truncate();
        let builder = egui::UiBuilder::new().max_rect(place).layout(egui::Layout::left_to_right(egui::Align::Center));
        ui.scope_builder(builder, |ui| ui.add(label));
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
