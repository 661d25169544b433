//! What can be surveyed.

use serde::{Deserialize, Serialize};

/// A quantity that every pixel has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Quantity {
    /// How many rays it sends, of all kinds.
    Rays,
    /// How many tests against primitives and extents its rays take.
    Tests,
    /// How many rays the deepest of them is away from the eye, shadow rays left out.
    Depth,
    /// How long it takes.
    Time,
    /// The bound on the error of the first hit's time.
    Error,
    /// The object that is seen.
    Object,
    /// The normal of the surface that is seen.
    Normal,
    /// The digits of the first hit's time that are lost.
    Digits,
}

impl Quantity {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Self; 8] =
        [Self::Rays, Self::Tests, Self::Depth, Self::Time, Self::Error, Self::Object, Self::Normal, Self::Digits];

    /// Its name, as the command line takes it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rays => "rays",
            Self::Tests => "tests",
            Self::Depth => "depth",
            Self::Time => "time",
            Self::Error => "error",
            Self::Object => "object",
            Self::Normal => "normal",
            Self::Digits => "digits",
        }
    }

    /// What stands over its map.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Rays => "Rays",
            Self::Tests => "Tests",
            Self::Depth => "Depth",
            Self::Time => "Time",
            Self::Error => "Error of the hit time",
            Self::Object => "Objects",
            Self::Normal => "Normals",
            Self::Digits => "Digits lost",
        }
    }

    pub(super) const fn note(self) -> &'static str {
        match self {
            Self::Rays => "Rays of all kinds that each pixel sends.",
            Self::Tests => "Tests against primitives and extents that the rays of each pixel take.",
            Self::Depth => "How far the deepest ray of each pixel is from the eye; shadow rays are left out.",
            Self::Time => "What each pixel takes on one thread.",
            Self::Error => "The bound on the error of the hit time of the ray through each pixel's middle.",
            Self::Object => "What the ray through each pixel's middle hits first.",
            Self::Normal => "The outward normal where the ray through each pixel's middle hits, as seen from the eye.",
            Self::Digits => "What the arithmetic loses of the hit time of the ray through each pixel's middle.",
        }
    }

    pub(super) const fn unit(self) -> &'static str {
        match self {
            Self::Rays => "rays",
            Self::Tests => "tests",
            Self::Depth => "rays deep",
            Self::Time => "ns",
            Self::Error => "± t",
            Self::Digits => "digits",
            Self::Object | Self::Normal => "",
        }
    }

    /// How often each pixel is worked on: what its progress counts up to, for each pixel.
    #[must_use]
    pub const fn work_per_pixel(self) -> usize {
        match self {
            Self::Time => crate::laboratory::TIMINGS,
            _ => 1,
        }
    }
}
