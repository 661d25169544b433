//! The ledger: what each effect of a scene costs, measured by leaving it out.
//!
//! Counts say how often the code of an effect was entered and how many rays there are because of it. Its price is how much
//! longer a picture takes with it than without it, on one thread. Both pictures are rendered in turn, with, without, with,
//! without, so that a machine that slows down slows down both; the price is the median of the differences, and half the
//! distance between their quartiles is its spread. A price within its own spread is not told from nothing.

mod measure;
mod price;

pub use measure::{Clock, Ledger, Row, Size, measure};
pub use price::{Price, quantile};
