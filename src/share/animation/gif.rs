//! GIF: every frame in the same 256 colours, so that nothing flickers.

use super::quantise::{Histogram, Quantised};
use super::{AnimationError, FRAME, Film};
use image::codecs::gif::{GifEncoder, Repeat};
use image::{Delay, Frame, RgbaImage};
use std::time::Duration;

/// Frames of at most 256 colours are written as they are at any speed.
const SPEED: i32 = 10;

pub fn encode(film: &Film) -> Result<Vec<u8>, AnimationError> {
    let colours = colours(film)?;
    let mut bytes = Vec::new();
    let mut encoder = GifEncoder::new_with_speed(&mut bytes, SPEED);
    let refused = |error: image::ImageError| AnimationError::Encoder(error.to_string());
    encoder.set_repeat(Repeat::Infinite).map_err(refused)?;
    for place in 0..film.frames.len() {
        let mut rgba = film.painted(place)?.rgba;
        colours.replace(&mut rgba);
        let image = RgbaImage::from_raw(FRAME[0], FRAME[1], rgba)
            .ok_or_else(|| AnimationError::Encoder("a frame is not of the size of the others".to_owned()))?;
        let shown = Duration::from_millis(film.milliseconds(place).into());
        encoder
            .encode_frame(Frame::from_parts(image, 0, 0, Delay::from_saturating_duration(shown)))
            .map_err(refused)?;
    }
    drop(encoder);
    Ok(bytes)
}

/// The colours of all frames. A frame that differs from others by what it shows, not by its colours, tells the same: of
/// many frames some are looked at, spread over all of them.
fn colours(film: &Film) -> Result<Quantised, AnimationError> {
    const LOOKED_AT: usize = 40;
    let mut histogram = Histogram::default();
    for place in (0..film.frames.len()).step_by(film.frames.len().div_ceil(LOOKED_AT).max(1)) {
        histogram.add(&super::paint(&film.frames[place], 1.0).rgba);
        if !(film.watch)(film.frames.len(), 2 * film.frames.len()) {
            return Err(AnimationError::Cancelled);
        }
    }
    Ok(histogram.quantised())
}
