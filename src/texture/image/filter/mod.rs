//! How a look-up weighs texels.

mod area;
mod bilinear;
mod ewa;
mod nearest;
mod trilinear;

use super::footprint::Footprint;
use super::texels::Texels;
use super::wrap::Wraps;
use crate::record::Recorder;
use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

/// The most texels that a footprint may touch before it is taken to a coarser level of the pyramid. With fewer, the blocks of
/// texels that stand for their texels would be seen at the edges of a long footprint; with more, a picture with a horizon
/// waits for a few rows of pixels there.
const MOST_TOUCHED: f64 = 16384.0;

/// A way to weigh texels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Filter {
    /// The texel that the point lies in.
    Nearest,
    /// The four texels around the point, by its distance from their centres.
    #[default]
    Bilinear,
    /// Bilinear in the two levels of the pyramid whose texels are nearest in size to the pixel's longest side.
    Trilinear,
    /// The average over the pixel, as if each texel were a square of one colour: exact for a plane seen in perspective.
    Area,
    /// The elliptical weighted average: a Gaussian about the point in place of the pixel's square.
    Ewa,
}

/// What a filter works on: an image, and the way that it goes on beyond its edges.
#[derive(Clone, Copy)]
struct Ground<'a> {
    texels: &'a Texels,
    wraps: Wraps,
}

impl Ground<'_> {
    /// The coarsest level that is needed to touch no more than `MOST_TOUCHED` texels, and the factors from texels of the
    /// image to its own. The last level has one texel, so that nothing is won beyond it.
    fn level(&self, touched: impl Fn(DVec2) -> f64) -> (usize, DVec2) {
        let mut level = 0;
        while touched(self.scale(level)) > MOST_TOUCHED && level + 1 < self.texels.levels() {
            level += 1;
        }
        (level, self.scale(level))
    }

    /// The factors from texels of the image to those of a level.
    fn scale(&self, level: usize) -> DVec2 {
        let size = |texels: &Texels| DVec2::from(texels.size().map(f64::from));
        size(self.texels.level(level)) / size(self.texels)
    }
}

impl Filter {
    /// Its name in scene files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Nearest => "nearest",
            Self::Bilinear => "bilinear",
            Self::Trilinear => "trilinear",
            Self::Area => "area",
            Self::Ewa => "ewa",
        }
    }

    /// Whether it asks how much of the image the pixel covers.
    #[must_use]
    pub fn needs_footprint(self) -> bool {
        !matches!(self, Self::Nearest | Self::Bilinear)
    }

    /// The colour at `point`, in texels from the top left corner, for a pixel with this footprint. Without one, or with one
    /// that is not to be used, the answer is the bilinear one, and is reported as such.
    pub fn colour(
        self,
        texels: &Texels,
        wraps: Wraps,
        point: DVec2,
        footprint: Option<&Footprint>,
        recorder: &mut impl Recorder,
    ) -> DVec3 {
        let ground = Ground { texels, wraps };
        let footprint = footprint.filter(|footprint| footprint.is_finite());
        let found = match (self, footprint) {
            (Self::Nearest, _) => Some(nearest::colour(ground, point, recorder)),
            (Self::Trilinear, Some(footprint)) => Some(trilinear::colour(ground, point, footprint, recorder)),
            (Self::Area, Some(footprint)) => area::colour(ground, footprint, recorder),
            (Self::Ewa, Some(footprint)) => ewa::colour(ground, point, footprint, recorder),
            _ => None,
        };
        found.unwrap_or_else(|| bilinear::colour(ground, 0, point, recorder))
    }
}
