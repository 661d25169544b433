//! Stepping as a moving picture: one frame for each step, as GIF or as animated PNG.

mod apng;
mod gif;
mod quantise;

use super::sheet::{SHEET, Sheet};
use super::{Account, Watch};
use crate::view::{Drawing, Pixels, paint};
use std::fmt::{self, Display, Formatter};

/// Columns and rows of a frame.
pub const FRAME: [u32; 2] = [960, 540];

/// Moving pictures have this many frames at most: a longer one is not watched to its end, and takes tens of megabytes.
pub const MOST_FRAMES: usize = 300;

/// A format of moving pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moving {
    /// 256 colours, shown everywhere.
    Gif,
    /// All colours.
    Apng,
}

/// Why there is no moving picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AnimationError {
    /// Nobody waits for it any more.
    Cancelled,
    /// The encoder refused.
    Encoder(String),
}

impl Display for AnimationError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cancelled => f.write_str("the moving picture was given up"),
            Self::Encoder(message) => write!(f, "the moving picture cannot be encoded: {message}"),
        }
    }
}

impl std::error::Error for AnimationError {}

/// The steps of a ray as a moving picture of [`FRAME`] pixels that begins again at its end; each step is shown for so many
/// seconds, the last for twice as many.
///
/// # Errors
/// If `watch` says that nobody waits any more, or the encoder refuses.
pub fn animation(account: &Account, moving: Moving, seconds: f64, watch: Watch) -> Result<Vec<u8>, AnimationError> {
    let steps = account.steps(MOST_FRAMES);
    let count = steps.events.len();
    let mut frames = Vec::new();
    for place in 0..count {
        // Drawing is half of the work, painting and encoding the other.
        if !watch(place, 2 * count) {
            return Err(AnimationError::Cancelled);
        }
        frames.push(Sheet::frame(account, &steps, place));
    }
    let film = Film { frames: &frames, milliseconds: milliseconds(seconds), watch };
    match moving {
        Moving::Gif => gif::encode(&film),
        Moving::Apng => apng::encode(&film),
    }
}

/// The frames of a moving picture, to be painted one at a time: a hundred of them painted take 200 MB.
struct Film<'a> {
    frames: &'a [Drawing],
    milliseconds: u16,
    watch: Watch<'a>,
}

impl Film<'_> {
    fn painted(&self, place: usize) -> Result<Pixels, AnimationError> {
        let count = self.frames.len();
        if !(self.watch)(count + place, 2 * count) {
            return Err(AnimationError::Cancelled);
        }
        Ok(paint(&self.frames[place], 1.0))
    }

    /// How long a frame is shown.
    fn milliseconds(&self, place: usize) -> u16 {
        if place + 1 == self.frames.len() { self.milliseconds.saturating_mul(2) } else { self.milliseconds }
    }
}

/// From a twentieth of a second, below which viewers set times of their own, to half a minute.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the range of u16")]
fn milliseconds(seconds: f64) -> u16 {
    let seconds = if seconds.is_finite() { seconds } else { 1.0 };
    (seconds.clamp(0.05, 30.0) * 1000.0).round() as u16
}

const _: () = assert!(FRAME[0] as f64 == SHEET[0] && FRAME[1] as f64 == SHEET[1]);
