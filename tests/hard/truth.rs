//! What is asked of an exact answer.

use super::line::PixelRay;
use rayscope::scene::Scene;

/// The number of the material that a pixel shows; none for the background.
pub type Seen = Option<usize>;

/// The exact answer for a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// What is seen with the numbers as they are given.
    pub seen: Seen,
    /// Whether half-ulp changes of these numbers leave it so.
    pub sure: bool,
}

/// The exact answer for every pixel of a picture.
pub trait Truth: Sync {
    /// What the pixel of this ray shows.
    fn verdict(&self, scene: &Scene, ray: PixelRay) -> Verdict;

    /// Whether the first hit is at t, within what half-ulp changes do; the error says what is right.
    fn time(&self, scene: &Scene, ray: PixelRay, t: f64) -> Result<(), String>;
}
