//! What lies over the picture: hatched pixels with an outline, or a map.

use crate::app::frame::theme::colour;
use crate::query::Search;
use crate::view::{Colour, HeatMap, Theme};
use egui::{Color32, ColorImage, Context, TextureHandle, TextureOptions};

/// The hatching of pixels that were found: light and dark by turns, so that it is seen on any picture.
const LIGHT: Color32 = Color32::from_rgba_premultiplied(230, 230, 230, 230);
const DARK: Color32 = Color32::from_rgba_premultiplied(10, 10, 16, 200);
/// Pixels of the picture from one line of the hatching to the next.
const PERIOD: u32 = 6;

/// The pixels that were found: an outline, and lines across where there is room for them.
pub fn found(ctx: &Context, search: &Search) -> TextureHandle {
    let [width, height] = search.grid.size;
    let matches = |x: i64, y: i64| {
        let inside = u32::try_from(x).ok().zip(u32::try_from(y).ok());
        inside.and_then(|pixel| search.grid.at(pixel.into())).unwrap_or(false)
    };
    let pixel = |x: u32, y: u32| {
        let [column, row] = [i64::from(x), i64::from(y)];
        if !matches(column, row) {
            return Color32::TRANSPARENT;
        }
        let is_rim = [(1, 0), (-1, 0), (0, 1), (0, -1)].iter().any(|(dx, dy)| !matches(column + dx, row + dy));
        match (x + y) % PERIOD {
            _ if is_rim => LIGHT,
            0 => LIGHT,
            1 => DARK,
            _ => Color32::TRANSPARENT,
        }
    };
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| pixel(x, y)).collect();
    texture(ctx, "found", [width, height], pixels)
}

/// A map, so opaque.
pub fn map(ctx: &Context, map: &HeatMap, theme: Theme, opacity: f32) -> TextureHandle {
    let faded = |own: Colour| colour(own.faded(f64::from(opacity)));
    let pixels = map.colours(theme).into_iter().map(faded).collect();
    let size = map.size.map(|side| u32::try_from(side).unwrap_or(u32::MAX));
    texture(ctx, "map", size, pixels)
}

fn texture(ctx: &Context, name: &str, size: [u32; 2], pixels: Vec<Color32>) -> TextureHandle {
    let image = ColorImage::new(size.map(|side| side as usize), pixels);
    ctx.load_texture(name, image, TextureOptions::NEAREST)
}
