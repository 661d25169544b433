//! In a browser: work between frames and in workers, files as downloads, the page's canvas.

mod account;
mod address;
mod asked;
mod digest;
mod files;
mod host;
mod journals;
mod page;
mod turns;
mod worker;
mod workers;

pub use files::{ask_where, ask_which, read_dropped, replace, write_whole, write_with_folders};
pub use journals::{Journals, Left};
pub use page::run_in_browser;
pub use turns::{begin, begin_at_once, receive_within};
pub use workers::{begin_task, shares};
