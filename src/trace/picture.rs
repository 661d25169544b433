//! Whole pictures: every pixel by the same function, on all cores, coarse to fine where somebody is watching.

use super::encoding::srgb;
use super::pixel::trace_pixel_with;
use super::ray::Tracer;
use super::tally::Tally;
use crate::scene::{Rgb, Scene, Sights};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// The step of the workbench's first pass: one pixel in 8 × 8. Larger blocks would show nothing recognisable; smaller ones
/// would take longer to appear.
pub const FIRST_BLOCK: u32 = 8;

/// A picture in linear RGB. Pixels that were not reached yet hold the colour of a coarser pass, or the background.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Picture {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    pixels: Vec<Rgb>,
    computed: usize,
}

/// Which strips of a picture are rendered: those whose number leaves this rest. A strip is as high as a block of the first pass, so
/// that the blocks of all passes stay within it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Share {
    /// The rest.
    pub index: u32,
    /// What the number is divided by, 1 or more.
    pub of: u32,
}

impl Share {
    /// All strips.
    pub const WHOLE: Self = Self { index: 0, of: 1 };

    /// Whether a row of a picture belongs to it; `strip` is the height of a strip.
    #[must_use]
    pub const fn has(self, y: u32, strip: u32) -> bool {
        y / strip % self.of == self.index
    }
}

/// How far a picture has come, shared with whoever watches it.
#[derive(Default)]
pub struct Progress {
    cancelled: AtomicBool,
    done: AtomicUsize,
    told: Option<Box<dyn Fn(usize) + Send + Sync>>,
}

/// After so many pixels those are told who cannot look for themselves.
const TELLING: usize = 1 << 10;

impl Progress {
    /// Nothing done yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Asks the renderer to stop; it does so within a few pixels.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Whether it was asked to stop.
    #[must_use]
    pub fn cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// Nothing done yet; `tell` is called with how many pixels are finished, now and then.
    #[must_use]
    pub fn told_to(tell: impl Fn(usize) + Send + Sync + 'static) -> Self {
        Self { told: Some(Box::new(tell)), ..Self::default() }
    }

    /// Counts one more pixel that is finished.
    pub fn advance(&self) {
        let before = self.done.fetch_add(1, Ordering::Relaxed);
        if let Some(tell) = &self.told
            && (before + 1).is_multiple_of(TELLING)
        {
            tell(before + 1);
        }
    }

    /// Takes over how many pixels are finished from whoever finished them.
    pub fn set_done(&self, done: usize) {
        self.done.store(done, Ordering::Relaxed);
    }

    /// How many pixels are finished.
    #[must_use]
    pub fn done(&self) -> usize {
        self.done.load(Ordering::Relaxed)
    }
}

impl Picture {
    fn new(scene: &Scene) -> Self {
        let (width, height) = (scene.image.width, scene.image.height);
        let pixels = vec![scene.background; width as usize * height as usize];
        Self { width, height, pixels, computed: 0 }
    }

    /// A picture of colours that were worked out elsewhere, row by row from the top; none if there are too many or too few.
    #[must_use]
    pub fn from_pixels(width: u32, height: u32, pixels: Vec<Rgb>) -> Option<Self> {
        let computed = pixels.len();
        (width as usize * height as usize == computed).then_some(Self { width, height, pixels, computed })
    }

    /// The linear colours of all pixels, row by row from the top.
    #[must_use]
    pub fn pixels(&self) -> &[Rgb] {
        &self.pixels
    }

    /// The linear colour of a pixel; (0, 0) is the top left one.
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> Rgb {
        self.pixels[y as usize * self.width as usize + x as usize]
    }

    /// How many pixels were traced.
    #[must_use]
    pub const fn computed(&self) -> usize {
        self.computed
    }

    /// Three sRGB bytes a pixel, row by row from the top.
    #[must_use]
    pub fn to_rgb8(&self) -> Vec<u8> {
        rgb8(&self.pixels)
    }

    /// The same of the rows of a share alone; `strip` is the height of a strip.
    #[must_use]
    pub fn share_to_rgb8(&self, share: Share, strip: u32) -> Vec<u8> {
        let rows = self.pixels.chunks(self.width.max(1) as usize).zip(0..);
        rows.filter(|&(_, y)| share.has(y, strip)).flat_map(|(row, _)| rgb8(row)).collect()
    }
}

/// Renders on all threads of the current pool. When it is cancelled the picture holds what was finished until then.
#[must_use]
pub fn render(scene: &Scene, progress: &Progress) -> (Picture, Tally) {
    render_rows(scene, 1, progress, |_, _| {})
}

/// Renders coarse to fine: the first pass traces one pixel of each block of `step` × `step`, each further pass halves
/// the blocks and traces only the pixels that are new. `on_pass` sees the picture after each finished pass.
#[must_use]
pub fn render_rows(
    scene: &Scene,
    step: u32,
    progress: &Progress,
    on_pass: impl FnMut(&Picture, u32),
) -> (Picture, Tally) {
    render_share(scene, step, Share::WHOLE, progress, on_pass)
}

/// The same for a share of the picture; the other rows keep the background.
#[must_use]
pub fn render_share(
    scene: &Scene,
    step: u32,
    share: Share,
    progress: &Progress,
    mut on_pass: impl FnMut(&Picture, u32),
) -> (Picture, Tally) {
    let mut picture = Picture::new(scene);
    let mut tally = Tally::default();
    let sights = scene.shortcuts.sights.then(|| Sights::new(scene));
    let tracer = sights.as_ref().map_or(Tracer::new(scene), |sights| Tracer::new(scene).with_sights(sights));
    let coarsest = step.max(1).next_power_of_two();
    let mut side = coarsest;
    while side > 0 && !progress.cancelled() {
        let band = picture.width as usize * side as usize;
        // Row by row: rows through glass take many times as long as others, and a large share of them would be waited for.
        let bands = picture
            .pixels
            .par_chunks_mut(band)
            .with_max_len(1)
            .zip((0..picture.height).into_par_iter().step_by(side as usize))
            .filter(|&(_, y)| share.has(y, coarsest));
        let traced = bands.map(|(band, y)| trace_row(&tracer, y, [side, coarsest], band, progress));
        let (computed, passed) = traced.reduce(Default::default, |a, b| (a.0 + b.0, a.1.plus(&b.1)));
        picture.computed += computed;
        tally = tally.plus(&passed);
        if !progress.cancelled() {
            on_pass(&picture, side);
        }
        side /= 2;
    }
    (picture, tally)
}

/// Traces the new pixels of a row in one pass, and paints their blocks into the band of the picture below its upper edge.
/// Returns how many there were, with their account.
fn trace_row(
    tracer: &Tracer,
    y: u32,
    [side, coarsest]: [u32; 2],
    band: &mut [Rgb],
    progress: &Progress,
) -> (usize, Tally) {
    let (mut computed, mut tally) = (0, Tally::default());
    let width = tracer.scene.image.width;
    for x in (0..width).step_by(side as usize) {
        if progress.cancelled() {
            break;
        }
        let known = side < coarsest && x.is_multiple_of(2 * side) && y.is_multiple_of(2 * side);
        if !known {
            tally.begin_pixel([x, y]);
            let colour = trace_pixel_with(tracer, x, y, &mut tally);
            let block = x as usize..x.saturating_add(side).min(width) as usize;
            band.chunks_mut(width as usize).for_each(|line| line[block.clone()].fill(colour));
            computed += 1;
            progress.advance();
        }
    }
    (computed, tally)
}

/// Three sRGB bytes a pixel.
fn rgb8(pixels: &[Rgb]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(3 * pixels.len());
    // A coarse picture is made of blocks of one colour, and many a fine one has a plain background.
    for run in pixels.chunk_by(|a, b| a == b) {
        bytes.extend(std::iter::repeat_n(srgb(run[0]), run.len()).flatten());
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_has_its_own_bytes_in_a_run_of_one_colour_and_beside_it() {
        let pixels = vec![Rgb::ONE, Rgb::ZERO, Rgb::ZERO, Rgb::ONE, Rgb::NAN, Rgb::ZERO];
        let picture = Picture { width: 3, height: 2, pixels, computed: 0 };
        let white = [true, false, false, true, false, false];
        assert_eq!(picture.to_rgb8(), white.map(|white| if white { [255; 3] } else { [0; 3] }).concat());
    }
}
