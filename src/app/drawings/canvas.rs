//! A drawing on screen: painted by a background thread at the screen's resolution, and only when its inputs change.

use crate::app::system;
use crate::view::{Drawing, paint};
use egui::emath::GuiRounding;
use egui::{Color32, ColorImage, Context, Painter, Pos2, Rect, TextureHandle, TextureOptions, pos2};
use std::sync::mpsc::{Receiver, TryRecvError, channel};

/// Shows the drawing that belongs to a key. While a new one is painted, the old one stays.
pub struct Canvas<K> {
    shown: Option<Shown<K>>,
    pending: Option<Receiver<Painted<K>>>,
}

/// A drawing that is on screen.
pub struct Shown<K> {
    /// What it was drawn for.
    pub key: K,
    /// The marks; none if there was nothing to draw.
    pub drawing: Option<Drawing>,
    /// The marks as pixels.
    pub texture: Option<TextureHandle>,
}

struct Painted<K> {
    key: K,
    drawing: Option<Drawing>,
    image: Option<ColorImage>,
}

impl<K> Default for Canvas<K> {
    fn default() -> Self {
        Self { shown: None, pending: None }
    }
}

impl<K: Clone + PartialEq + Send + 'static> Canvas<K> {
    /// The newest drawing that is ready. If it does not belong to `key`, `draw` is set to work.
    pub fn update(
        &mut self,
        ctx: &Context,
        key: &K,
        draw: impl FnOnce() -> Option<Drawing> + Send + 'static,
    ) -> Option<&Shown<K>> {
        self.receive(ctx);
        let up_to_date = self.shown.as_ref().is_some_and(|shown| shown.key == *key);
        // One at a time: what is asked for meanwhile is started when this one is done, and only the newest of it.
        if !up_to_date && self.pending.is_none() {
            self.pending = start(ctx, key.clone(), draw);
        }
        self.shown.as_ref()
    }

    fn receive(&mut self, ctx: &Context) {
        let Some(pending) = &self.pending else { return };
        match pending.try_recv() {
            Ok(painted) => {
                let previous = self.shown.take().and_then(|shown| shown.texture);
                let texture = painted.image.map(|image| upload(ctx, previous, image));
                self.shown = Some(Shown { key: painted.key, drawing: painted.drawing, texture });
                self.pending = None;
            }
            Err(TryRecvError::Empty) => {}
            Err(TryRecvError::Disconnected) => self.pending = None,
        }
    }
}

/// Puts a drawing on screen with its corner here, each of its pixels on one of the screen's: between two of them, lines and letters
/// would be blurred. Returns where it lies.
pub fn put(painter: &Painter, texture: &TextureHandle, corner: Pos2) -> Rect {
    let pixels_per_point = painter.pixels_per_point();
    let size = texture.size_vec2() / pixels_per_point;
    let place = Rect::from_min_size(corner.round_to_pixels(pixels_per_point), size);
    painter.image(texture.id(), place, Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0)), Color32::WHITE);
    place
}

fn start<K: Send + 'static>(
    ctx: &Context,
    key: K,
    draw: impl FnOnce() -> Option<Drawing> + Send + 'static,
) -> Option<Receiver<Painted<K>>> {
    let (sender, receiver) = channel();
    let (ctx, pixels_per_point) = (ctx.clone(), ctx.pixels_per_point());
    let work = move || {
        let drawing = draw();
        let image = drawing.as_ref().map(|drawing| {
            let pixels = paint(drawing, pixels_per_point);
            ColorImage::from_rgba_unmultiplied([pixels.width as usize, pixels.height as usize], &pixels.rgba)
        });
        // The window may have gone away meanwhile; then nobody waits for this.
        let _ = sender.send(Painted { key, drawing, image });
        ctx.request_repaint();
    };
    system::begin("draw", work).then_some(receiver)
}

fn upload(ctx: &Context, previous: Option<TextureHandle>, image: ColorImage) -> TextureHandle {
    match previous {
        Some(mut texture) => {
            texture.set(image, TextureOptions::LINEAR);
            texture
        }
        None => ctx.load_texture("drawing", image, TextureOptions::LINEAR),
    }
}
