//! A homogeneous medium that absorbs light and turns it.

use glam::DVec3;

/// What a medium does to light on its way, by colour and unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// σ_a: the share that is absorbed.
    pub absorption: DVec3,
    /// σ_s: the share that is turned into other directions.
    pub scattering: DVec3,
    /// g of Henyey and Greenstein: the mean cosine of the angle by which light is turned.
    pub anisotropy: f64,
    /// Whether light that was turned once may be turned again.
    pub multiple: bool,
}
