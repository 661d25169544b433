//! Whole pictures: every pixel by the same function, on all cores, coarse to fine where somebody is watching.

use super::pixel::trace_pixel_with;
use super::ray::Tracer;
use super::tally::Tally;
use crate::scene::{Rgb, Scene, Sights};
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// The step of the workbench's first pass: one pixel in 8 × 8. Larger blocks would show nothing recognisable; smaller ones
/// would take longer to appear.
pub const FIRST_BLOCK: u32 = 8;

/// A picture in linear RGB. Pixels that were not reached yet hold the colour of a coarser pass, or the background.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    pixels: Vec<Rgb>,
    computed: usize,
}

/// How far a picture has come, shared with whoever watches it.
#[derive(Debug, Default)]
pub struct Progress {
    cancelled: AtomicBool,
    done: AtomicUsize,
}

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
        let mut bytes = Vec::with_capacity(3 * self.pixels.len());
        // A power is dear. A coarse picture is made of blocks of one colour, and many a fine one has a plain background.
        for run in self.pixels.chunk_by(|a, b| a == b) {
            bytes.extend(std::iter::repeat_n(srgb(run[0]), run.len()).flatten());
        }
        bytes
    }

    /// Paints a block, cut off at the picture's edges.
    fn fill(&mut self, x: u32, y: u32, side: u32, colour: Rgb) {
        let (right, bottom) = (x.saturating_add(side).min(self.width), y.saturating_add(side).min(self.height));
        for row in y..bottom {
            let start = row as usize * self.width as usize;
            self.pixels[start + x as usize..start + right as usize].fill(colour);
        }
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
    mut on_pass: impl FnMut(&Picture, u32),
) -> (Picture, Tally) {
    let mut picture = Picture::new(scene);
    let mut tally = Tally::default();
    let sights = scene.shortcuts.sights.then(|| Sights::new(scene));
    let tracer = sights.as_ref().map_or(Tracer::new(scene), |sights| Tracer::new(scene).with_sights(sights));
    let coarsest = step.max(1).next_power_of_two();
    let mut side = coarsest;
    while side > 0 && !progress.cancelled() {
        let rows: Vec<u32> = (0..picture.height).step_by(side as usize).collect();
        let traced: Vec<Row> = rows.par_iter().map(|&y| trace_row(&tracer, y, side, coarsest, progress)).collect();
        for row in &traced {
            row.pixels.iter().for_each(|&(x, colour)| picture.fill(x, row.y, side, colour));
            picture.computed += row.pixels.len();
            tally = tally.plus(&row.tally);
        }
        if !progress.cancelled() {
            on_pass(&picture, side);
        }
        side /= 2;
    }
    (picture, tally)
}

/// The new pixels of a row in one pass.
struct Row {
    y: u32,
    pixels: Vec<(u32, Rgb)>,
    tally: Tally,
}

fn trace_row(tracer: &Tracer, y: u32, side: u32, coarsest: u32, progress: &Progress) -> Row {
    let mut row = Row { y, pixels: Vec::new(), tally: Tally::default() };
    for x in (0..tracer.scene.image.width).step_by(side as usize) {
        if progress.cancelled() {
            break;
        }
        let known = side < coarsest && x.is_multiple_of(2 * side) && y.is_multiple_of(2 * side);
        if !known {
            row.pixels.push((x, trace_pixel_with(tracer, x, y, &mut row.tally)));
            progress.done.fetch_add(1, Ordering::Relaxed);
        }
    }
    row
}

/// Linear RGB, clamped to [0, 1], as sRGB bytes (IEC 61966-2-1).
#[must_use]
pub fn srgb(linear: Rgb) -> [u8; 3] {
    linear.to_array().map(|channel| {
        let clamped = channel.clamp(0.0, 1.0);
        let encoded = if clamped <= 0.003_130_8 { 12.92 * clamped } else { 1.055 * clamped.powf(1.0 / 2.4) - 0.055 };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 255")]
        let byte = (255.0 * encoded).round() as u8;
        byte
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_bytes_are_those_of_the_standard() {
        assert_eq!(srgb(Rgb::ZERO), [0, 0, 0]);
        assert_eq!(srgb(Rgb::ONE), [255, 255, 255]);
        assert_eq!(srgb(Rgb::new(0.5, 0.214_041, 0.002)), [188, 127, 7]);
        assert_eq!(srgb(Rgb::new(-1.0, 2.0, f64::INFINITY)), [0, 255, 255]);
    }

    #[test]
    fn every_pixel_has_its_own_bytes_in_a_run_of_one_colour_and_beside_it() {
        let pixels = vec![Rgb::ONE, Rgb::ZERO, Rgb::ZERO, Rgb::ONE, Rgb::NAN, Rgb::ZERO];
        let picture = Picture { width: 3, height: 2, pixels, computed: 0 };
        let white = [true, false, false, true, false, false];
        assert_eq!(picture.to_rgb8(), white.map(|white| if white { [255; 3] } else { [0; 3] }).concat());
    }
}
