//! What light does at a boundary between two media, and which media a ray is inside (§ 6.4, § 6.4.1).

mod dispersion;
mod explain;
mod flight;
mod interface;
mod media;
mod medium;
mod phase;

pub use dispersion::Dispersion;
pub use explain::snell_entry;
pub use flight::{Flight, Walk, one_less_exp};
pub use interface::{Optics, reflect, refract};
pub use media::{MediaStack, Policy};
pub use medium::Medium;
pub use phase::HenyeyGreenstein;
