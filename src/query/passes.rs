//! Something asked of every pixel, coarse to fine: an answer for the whole picture comes at once, and becomes exact.

use crate::scene::Image;
use crate::trace::Progress;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// The first pass asks one pixel in 8 × 8: fewer would show nothing recognisable, more would take longer to appear.
pub const FIRST_SIDE: u32 = 8;

/// An answer for each pixel, as far as it is known: a block of pixels has the answer of its upper left one until each has its own.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Grid<T> {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Row by row from the top.
    pub cells: Vec<T>,
    /// The side of the blocks; 1 where every pixel has its own answer.
    pub side: u32,
}

impl<T: Copy> Grid<T> {
    /// The answer for a pixel, or for the block that it lies in.
    #[must_use]
    pub fn at(&self, [x, y]: [u32; 2]) -> Option<T> {
        let is_within = x < self.size[0] && y < self.size[1];
        is_within.then(|| self.cells[y as usize * self.size[0] as usize + x as usize])
    }

    /// Whether the pixel was asked itself.
    #[must_use]
    pub const fn is_exact(&self, [x, y]: [u32; 2]) -> bool {
        x.is_multiple_of(self.side) && y.is_multiple_of(self.side)
    }

    /// The pixels that were asked, in reading order, with their answers.
    pub fn asked(&self) -> impl Iterator<Item = ([u32; 2], T)> {
        let [width, height] = self.size;
        let step = self.side.max(1) as usize;
        let pixels = (0..height).step_by(step).flat_map(move |y| (0..width).step_by(step).map(move |x| [x, y]));
        pixels.filter_map(|pixel| Some((pixel, self.at(pixel)?)))
    }
}

/// Asks every pixel, on all cores, in passes that halve the blocks; `on_pass` sees what there is after each. None if it was
/// cancelled before the last.
pub(super) fn ask_all<T: Copy + Send + Sync>(
    image: Image,
    side: u32,
    nothing: T,
    progress: &Progress,
    ask: impl Fn([u32; 2]) -> T + Sync,
    mut on_pass: impl FnMut(&Grid<T>),
) -> Option<Grid<T>> {
    let size = [image.width, image.height];
    let coarsest = side.max(1).next_power_of_two();
    let mut grid = Grid { size, cells: vec![nothing; image.width as usize * image.height as usize], side: coarsest };
    loop {
        let row = Row { width: image.width, sides: [grid.side, coarsest] };
        let band = image.width as usize * grid.side as usize;
        let rows = (0..image.height).into_par_iter().step_by(grid.side as usize);
        let bands = grid.cells.par_chunks_mut(band.max(1)).with_max_len(1).zip(rows);
        bands.for_each(|(band, y)| row.ask(y, band, progress, &ask));
        if progress.cancelled() {
            return None;
        }
        on_pass(&grid);
        if grid.side == 1 {
            return Some(grid);
        }
        grid.side /= 2;
    }
}

/// One row of one pass.
struct Row {
    width: u32,
    /// The side of this pass's blocks, and of the first pass's.
    sides: [u32; 2],
}

impl Row {
    fn ask<T: Copy>(&self, y: u32, band: &mut [T], progress: &Progress, ask: &impl Fn([u32; 2]) -> T) {
        let [side, coarsest] = self.sides;
        for x in (0..self.width).step_by(side as usize) {
            if progress.cancelled() {
                return;
            }
            let is_known = side < coarsest && x.is_multiple_of(2 * side) && y.is_multiple_of(2 * side);
            if !is_known {
                let answer = ask([x, y]);
                let block = x as usize..x.saturating_add(side).min(self.width) as usize;
                band.chunks_mut(self.width as usize).for_each(|line| line[block.clone()].fill(answer));
                progress.advance();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    #[test]
    fn every_pixel_is_asked_once_and_blocks_hold_the_answer_of_their_corner() {
        let count = AtomicUsize::new(0);
        let ask = |[x, y]: [u32; 2]| {
            count.fetch_add(1, Ordering::Relaxed);
            10 * y + x
        };
        let mut passes = Vec::new();
        let image = Image { width: 7, height: 5 };
        let grid = ask_all(image, 4, 0, &Progress::new(), ask, |grid| passes.push(grid.clone())).unwrap();
        assert_eq!(count.load(Ordering::Relaxed), 35);
        assert_eq!(grid.cells, (0..35).map(|k| 10 * (k / 7) + k % 7).collect::<Vec<_>>());
        assert_eq!(passes.iter().map(|pass| pass.side).collect::<Vec<_>>(), [4, 2, 1]);
        assert_eq!((passes[0].at([3, 3]), passes[0].at([6, 4]), passes[1].at([3, 3])), (Some(0), Some(44), Some(22)));
        assert_eq!(passes[0].asked().count(), 4);
        assert_eq!(passes[0].at([7, 0]), None);
    }

    #[test]
    fn a_cancelled_search_ends_with_nothing() {
        let progress = Progress::new();
        progress.cancel();
        assert_eq!(ask_all(Image { width: 3, height: 2 }, 8, 0, &progress, |_| 1, |_| {}), None);
    }
}
