//! What lies over the picture: hatched pixels with an outline, or a map.

use crate::app::frame::theme::colour;
use crate::app::system;
use crate::query::Search;
use crate::view::{HeatMap, Theme};
use egui::{Color32, ColorImage, Context, TextureFilter, TextureHandle, TextureOptions};
use serde::{Deserialize, Serialize};

/// Something over the picture, in its size.
pub struct Layer {
    /// The pixels.
    pub texture: TextureHandle,
    /// How much of it is seen: white for all, fainter for less.
    pub tint: Color32,
}

/// The pixels of a layer, as data.
#[derive(Serialize, Deserialize)]
pub struct Pixels {
    size: [usize; 2],
    /// Four bytes each: red, green and blue, each times alpha, and alpha.
    rgba: Vec<u8>,
}

impl From<ColorImage> for Pixels {
    fn from(image: ColorImage) -> Self {
        Self { size: image.size, rgba: image.as_raw().to_vec() }
    }
}

/// The hatching of pixels that were found: light and dark by turns, so that it is seen on any picture.
const LIGHT: Color32 = Color32::from_rgba_premultiplied(230, 230, 230, 230);
const DARK: Color32 = Color32::from_rgba_premultiplied(10, 10, 16, 200);
/// Lines of the hatching across the picture: more would hide it, fewer would miss small places.
const LINES: u32 = 64;

/// The pixels that were found: an outline, and lines across where there is room for them.
pub fn found(search: &Search) -> Pixels {
    let [width, height] = search.grid.size;
    let matches = |x: i64, y: i64| {
        let inside = u32::try_from(x).ok().zip(u32::try_from(y).ok());
        inside.and_then(|pixel| search.grid.at(pixel.into())).unwrap_or(false)
    };
    let period = (width / LINES).max(4);
    let pixel = |x: u32, y: u32| {
        let [column, row] = [i64::from(x), i64::from(y)];
        if !matches(column, row) {
            return Color32::TRANSPARENT;
        }
        let is_rim = [(1, 0), (-1, 0), (0, 1), (0, -1)].iter().any(|(dx, dy)| !matches(column + dx, row + dy));
        match (x + y) % period {
            _ if is_rim => LIGHT,
            0 => LIGHT,
            1 => DARK,
            _ => Color32::TRANSPARENT,
        }
    };
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| pixel(x, y)).collect();
    ColorImage::new([width, height].map(|side| side as usize), pixels).into()
}

/// A map in its colours.
pub fn map(map: &HeatMap, theme: Theme) -> Pixels {
    ColorImage::new(map.size, map.colours(theme).into_iter().map(colour).collect()).into()
}

/// Puts a layer where it can be drawn from.
pub fn upload(ctx: &Context, name: &str, pixels: &Pixels) -> TextureHandle {
    // Large pixels have sharp edges; where several are one on screen, each has its share.
    let options = TextureOptions { minification: TextureFilter::Linear, ..TextureOptions::NEAREST };
    ctx.load_texture(name, ColorImage::from_rgba_premultiplied(pixels.size, &pixels.rgba), options)
}

/// Drops what may be large, in a thread of its own: that can take longer than a frame has.
pub fn drop_elsewhere<T: Send + 'static>(old: Option<T>) {
    let Some(old) = old else { return };
    // Where no thread can be started it is dropped here.
    system::begin("drop", move || drop(old));
}
