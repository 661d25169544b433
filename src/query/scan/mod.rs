//! Searching a whole picture: the pixels in whose stories a question holds of an event.

mod needs;

use super::passes::{Grid, ask_all};
use super::{Query, Vocabulary};
use crate::record::EventId;
use crate::scene::{Scene, Sights};
use crate::trace::{Progress, Tally, Tracer, TreeRecorder, trace_pixel_with};
use crate::view::{Row, row};
use needs::Need;
use serde::{Deserialize, Serialize};
use std::sync::{Mutex, PoisonError};

/// A pixel in whose story a question holds of an event.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Found {
    /// The pixel.
    pub pixel: [u32; 2],
    /// The first event of which it holds.
    pub event: EventId,
    /// That event in a line.
    pub row: Row,
}

/// What a search has found so far.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Search {
    /// Whether each pixel matches.
    pub grid: Grid<bool>,
    /// The pixels that do, in reading order.
    pub found: Vec<Found>,
}

/// Asks every pixel of a scene's picture, coarse to fine from blocks of the given side. `on_pass` sees what was found after each
/// pass. None if it was cancelled before the last.
///
/// The answer is that of recording every pixel in full. But a pixel is first traced without recording, which takes far less
/// time, and not recorded if what rays were sent and which effects were run exclude that it matches.
pub fn scan(
    scene: &Scene,
    query: &Query,
    side: u32,
    progress: &Progress,
    mut on_pass: impl FnMut(Search),
) -> Option<Search> {
    let need = Need::of(&query.expression, &Vocabulary::of(scene));
    let sights = (scene.shortcuts.sights && need.asks_rays()).then(|| Sights::new(scene));
    let tracer = sights.as_ref().map_or(Tracer::new(scene), |sights| Tracer::new(scene).with_sights(sights));
    let found: Mutex<Vec<Found>> = Mutex::new(Vec::new());
    let sorted = || {
        let mut found = found.lock().unwrap_or_else(PoisonError::into_inner);
        found.sort_unstable_by_key(|found| [found.pixel[1], found.pixel[0]]);
        found.clone()
    };
    let ask = |pixel: [u32; 2]| {
        let first = may_match(&need, &tracer, pixel).then(|| first_match(scene, query, pixel)).flatten();
        let matches = first.is_some();
        if let Some(first) = first {
            found.lock().unwrap_or_else(PoisonError::into_inner).push(first);
        }
        matches
    };
    let each = |grid: &Grid<bool>| on_pass(Search { grid: grid.clone(), found: sorted() });
    let grid = ask_all(scene.image, side, false, progress, ask, each)?;
    Some(Search { grid, found: sorted() })
}

/// Whether what the pixel's rays did leaves it open that it matches.
fn may_match(need: &Need, tracer: &Tracer, [x, y]: [u32; 2]) -> bool {
    if !need.asks_rays() {
        return *need != Need::Never;
    }
    let mut tally = Tally::default();
    let _ = trace_pixel_with(tracer, x, y, &mut tally);
    need.is_met(&tally)
}

/// Records a pixel; the first event of which the question holds.
fn first_match(scene: &Scene, query: &Query, pixel: [u32; 2]) -> Option<Found> {
    let mut recorder = TreeRecorder::new();
    let _ = trace_pixel_with(&Tracer::new(scene), pixel[0], pixel[1], &mut recorder);
    let tree = recorder.finish();
    let event = query.first(&tree)?;
    Some(Found { pixel, event, row: row(tree.event(event)) })
}
