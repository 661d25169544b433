//! What light does at a boundary between two media, and which media a ray is inside (§ 6.4, § 6.4.1).

mod dispersion;
mod explain;
mod interface;
mod media;
mod medium;

pub use dispersion::Dispersion;
pub use explain::snell_entry;
pub use interface::{Optics, reflect, refract};
pub use media::{MediaStack, Policy};
pub use medium::Medium;
