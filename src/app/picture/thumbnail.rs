//! Small pictures that grow under the pointer.

use crate::app::frame::theme::Palette;
use crate::app::picture::renderer::SAMPLING;
use crate::trace::Picture;
use egui::{
    Color32, ColorImage, Context, Rect, Response, Sense, Stroke, StrokeKind, TextureHandle, Ui, Vec2, pos2, vec2,
};

/// A picture under the pointer is this many times as wide.
const GROWN: f32 = 3.0;

/// Shows a picture `width` points wide, with its meaning as a tooltip.
pub fn thumbnail(ui: &mut Ui, texture: &TextureHandle, width: f32, meaning: &str) -> Response {
    let size = texture.size_vec2();
    let height = width * size.y / size.x.max(1.0);
    let (rect, response) = ui.allocate_exact_size(vec2(width, height), Sense::hover());
    let whole = Rect::from_min_size(pos2(0.0, 0.0), Vec2::splat(1.0));
    ui.painter().image(texture.id(), rect, whole, Color32::WHITE);
    ui.painter().rect_stroke(rect, 0.0, Stroke::new(1.0, Palette::current(ui.ctx()).edge), StrokeKind::Outside);
    response.on_hover_ui(|ui| {
        ui.label(meaning);
        ui.image((texture.id(), vec2(GROWN * width, GROWN * height)));
    })
}

/// A picture as a texture.
pub fn texture(ctx: &Context, name: &str, picture: &Picture) -> TextureHandle {
    load(ctx, name, picture, &picture.to_rgb8())
}

/// How two pictures of one size differ, as parts of the largest difference of a channel, and how large that is.
pub fn difference(ctx: &Context, a: &Picture, b: &Picture) -> (TextureHandle, u8) {
    let (ours, others) = (a.to_rgb8(), b.to_rgb8());
    let differences: Vec<u8> = ours.iter().zip(&others).map(|(a, b)| a.abs_diff(*b)).collect();
    let largest = differences.iter().copied().max().unwrap_or(0);
    // A difference of a few steps would look black.
    let scaled = |d: &u8| u8::try_from(u32::from(*d) * 255 / u32::from(largest.max(1))).unwrap_or(u8::MAX);
    let bytes: Vec<u8> = differences.iter().map(scaled).collect();
    (load(ctx, "difference", a, &bytes), largest)
}

fn load(ctx: &Context, name: &str, picture: &Picture, bytes: &[u8]) -> TextureHandle {
    let size = [picture.width as usize, picture.height as usize];
    ctx.load_texture(name, ColorImage::from_rgb(size, bytes), SAMPLING)
}
