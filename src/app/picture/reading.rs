//! What is read of the pixel under the pointer: its colour and the object that is seen in it.

use crate::record::{Counter, Entry, NullRecorder, Recorder, What};
use crate::scene::{Rgb, Scene};
use crate::trace::{srgb, trace_pixel};
use crate::view::brief;

/// The pixel under the pointer, as traced.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// The pixel.
    pub pixel: [u32; 2],
    /// Its colour.
    pub linear: Rgb,
    /// What is seen in it; none for the background.
    pub object: Option<String>,
}

impl Reading {
    /// Traces a pixel.
    #[must_use]
    pub fn of(scene: &Scene, pixel: [u32; 2]) -> Self {
        let mut listener = FirstHit::default();
        let _ = trace_pixel(scene, pixel[0], pixel[1], &mut listener);
        let linear = trace_pixel(scene, pixel[0], pixel[1], &mut NullRecorder);
        Self { pixel, linear, object: listener.object }
    }

    /// The colour as the picture holds it.
    #[must_use]
    pub fn srgb(&self) -> [u8; 3] {
        srgb(self.linear)
    }

    /// `(310, 240) · bowl · linear 0.5, 0.2, 0.1 · sRGB 188, 124, 89`.
    #[must_use]
    pub fn text(&self) -> String {
        let [x, y] = self.pixel;
        let linear = self.linear.to_array().map(brief).join(", ");
        let stored = self.srgb().map(|channel| channel.to_string()).join(", ");
        let object = self.object.as_deref().unwrap_or("background");
        format!("({x}, {y}) · {object} · linear {linear} · sRGB {stored}")
    }
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
