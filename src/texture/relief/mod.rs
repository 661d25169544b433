//! Bumps, frames and facets: what turns a normal without moving the surface.
//!
//! Everything is asked for one [`Site`]: a point with its tangents P_u and P_v and its outward unit normal in world space.

mod bump;
mod frame;
mod procedure;
mod site;
mod ward;

pub use bump::{BumpDerivative, Rise, raised};
pub use frame::{Frame, Grain};
pub use procedure::{Bump, Facets};
pub use site::{Site, turning};
pub use ward::Ward;
