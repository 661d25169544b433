//! Reconstruction filters: how the samples about a pixel are weighted.

/// How samples are weighted by their distance from the pixel's centre.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PixelFilter {
    /// All alike, over the pixel alone.
    #[default]
    Box,
    /// Less towards the centres of the neighbours, linearly.
    Tent,
    /// By a bell curve with a standard deviation of half a pixel, out to a pixel and a half.
    Gaussian,
    /// By the cubic of Mitchell and Netravali (1988, B = C = 1/3), out to two pixels.
    Mitchell,
}

impl PixelFilter {
    /// The word for it, as scene files spell it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Box => "box",
            Self::Tent => "tent",
            Self::Gaussian => "gaussian",
            Self::Mitchell => "mitchell",
        }
    }
}
