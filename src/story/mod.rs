//! Stepping through a recorded ray: how much of it has rows, how one moves in it, where one stops.
//!
//! A tree is worked through once ([`Index`]); after that every move is a search in a sorted list, however many events
//! there are.

mod breakpoint;
mod filter;
mod index;
mod kind;
mod level;
#[cfg(test)]
mod levels_tests;
mod outline;
mod play;
mod shown;
mod skip;
mod step;
#[cfg(test)]
mod testing;
mod told;
mod until;

pub use breakpoint::{Breakpoint, Breakpoints};
pub use filter::Filter;
pub use index::{Index, Scope};
pub use kind::Kind;
pub use level::Level;
pub use outline::Outline;
pub use play::{Player, SPEEDS};
pub use shown::Shown;
pub use skip::{Cut, Skip, all_skips, cut, skips};
pub use step::Step;
pub use told::{Place, Story};
pub use until::next_pixel;
