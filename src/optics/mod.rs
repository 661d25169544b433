//! What light does at a boundary between two media, which media a ray is inside (§ 6.4, § 6.4.1), and what becomes of light
//! of one wavelength.

mod colour_matching;
mod conductor;
mod dispersion;
mod explain;
mod flight;
mod interface;
mod media;
mod medium;
mod metal;
mod phase;
mod spectrum;

pub use conductor::{conductor_entry, conductor_reflectance, incidence, metal_reflectance};
pub use dispersion::Dispersion;
pub use explain::{index_lines, snell_entry, wavelength_entry};
pub use flight::{Flight, Walk, one_less_exp};
pub use interface::{Optics, reflect, refract};
pub use media::{MediaStack, Policy};
pub use medium::Medium;
pub use metal::Metal;
pub use phase::HenyeyGreenstein;
pub use spectrum::{Band, LONGEST, SHORTEST, YELLOW, bands, pure, share, white_up_to};
