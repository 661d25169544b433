//! What a desktop and a browser do differently: running work beside the window, files, and the window itself. Both have the same names.

#[cfg(target_arch = "wasm32")]
mod browser;
#[cfg(not(target_arch = "wasm32"))]
mod desktop;
mod picked;

#[cfg(target_arch = "wasm32")]
pub use browser::*;
#[cfg(not(target_arch = "wasm32"))]
pub use desktop::*;
pub use picked::{NoDialogue, Picked, Unread};

use std::time::Duration;
use web_time::{SystemTime, UNIX_EPOCH};

/// How long ago 1970 began.
pub fn since_1970() -> Duration {
    SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default()
}
