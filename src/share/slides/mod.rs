//! Slides, one for each step: as a page that any browser shows without a network, and as a PDF.

mod html;

use super::sheet::Sheet;
use super::{Account, Cancelled, Watch};
use crate::view::pdf;

pub use html::slides;

/// Talks hold this many slides: a longer one is not given, and browsers stall on the page.
pub const MOST_SLIDES: usize = 300;

/// The slides as a PDF, one page for each.
///
/// # Errors
/// If `watch` says that nobody waits any more.
pub fn slides_pdf(account: &Account, watch: Watch) -> Result<Vec<u8>, Cancelled> {
    let steps = account.steps(MOST_SLIDES);
    let mut sheets = Vec::new();
    for place in 0..steps.events.len() {
        if !watch(place, steps.events.len()) {
            return Err(Cancelled);
        }
        sheets.push(Sheet::slide(account, &steps, place));
    }
    Ok(pdf(&format!("{}, {}", account.title(), account.aim()), &sheets))
}
