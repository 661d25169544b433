//! The elliptical weighted average: a Gaussian of the pixel's size and shape.
//!
//! The pixel's square, and each texel's, is replaced by a round Gaussian; on the image the pixel's becomes an ellipse, whose
//! axes come from the means of the footprint's opposite sides. The two covariances add up.
//!
//! **Accuracy**: a Gaussian is not a square. On a checkerboard it comes within 3/255 of the average over the pixel where the
//! pixel is at least 12 cells wide at any slant up to 89.5°, or 4 cells at slants from 75° on, and where all of the ellipse lies in
//! one cell. In between it does not: an edge through the pixel is off by up to 12/255 (no round weight can do better than
//! 5/255, since the square's answer depends on the direction of the edge), and a pixel 1 to 2 cells wide by up to 42/255.
//! An ellipse also leaves out that perspective shifts the pixel's weight towards what is near.
//!
//! Source: P. S. Heckbert, Fundamentals of Texture Mapping and Image Warping, Master's thesis, Berkeley 1989, § 3.5.

use super::Ground;
use crate::math::{exp, portable};
use crate::record::Recorder;
use crate::texture::image::footprint::Footprint;
use crate::texture::image::sum::Sum;
use crate::texture::image::wrap::cell;
use glam::{DVec2, DVec3};

/// The variance of a pixel's Gaussian along each of its sides, in squared sides, and of a texel's likewise. A square has 1/12;
/// a little more gives the smallest error at an edge, 12/255 against 17/255 with 1/12 and 16/255 with 0.12.
const VARIANCE: f64 = 0.1;

/// The ellipse ends at this many standard deviations, where the weight has come down to 1/90. What lies outside counts
/// nothing, and the weights are lowered by their value there, so that they end in 0.
const REACH: f64 = 3.0;

/// The most that an ellipse may be longer than wide; beyond that it is made wider, and so blurs across. Without a bound a
/// pixel at a horizon would touch texels without end; with a smaller one slanted ground blurs where it need not.
const MOST_ECCENTRIC: f64 = 64.0;

/// A covariance matrix of two rows.
#[derive(Clone, Copy)]
struct Covariance {
    xx: f64,
    xy: f64,
    yy: f64,
}

impl Covariance {
    /// That of a pixel's Gaussian, in texels of a level, made wider where it is too slim.
    fn new(axes: [DVec2; 2], scale: DVec2) -> Self {
        let [a, b] = axes.map(|axis| axis * scale);
        let mut sum = Self {
            xx: VARIANCE * (a.x * a.x + b.x * b.x + 1.0),
            xy: VARIANCE * (a.x * a.y + b.x * b.y),
            yy: VARIANCE * (a.y * a.y + b.y * b.y + 1.0),
        };
        let largest = sum.largest();
        let smallest = sum.xx + sum.yy - largest;
        let wider = (largest / (MOST_ECCENTRIC * MOST_ECCENTRIC) - smallest).max(0.0);
        sum.xx += wider;
        sum.yy += wider;
        sum
    }

    /// The larger of its two eigenvalues.
    fn largest(self) -> f64 {
        f64::midpoint(self.xx + self.yy, portable::hypot(self.xx - self.yy, 2.0 * self.xy))
    }

    fn determinant(self) -> f64 {
        self.xx * self.yy - self.xy * self.xy
    }

    /// The number of texels that the ellipse touches: its area, and its outline's box.
    fn texels(self) -> f64 {
        let half = REACH * (self.xx.sqrt() + self.yy.sqrt());
        std::f64::consts::PI * REACH * REACH * self.determinant().max(0.0).sqrt() + 4.0 * half
    }
}

/// The average about `point`, in texels of the image; none where the footprint is too large for numbers.
pub(super) fn colour<R: Recorder>(
    ground: Ground,
    point: DVec2,
    footprint: &Footprint,
    recorder: &mut R,
) -> Option<DVec3> {
    let axes = footprint.axes();
    let (level, scale) = ground.level(|scale| Covariance::new(axes, scale).texels());
    let texels = ground.texels.level(level);
    let covariance = Covariance::new(axes, scale);
    let centre = point * scale;
    let determinant = covariance.determinant();
    if !(determinant > 0.0 && determinant.is_finite() && centre.is_finite()) {
        return None;
    }
    let mut sum = Sum::new::<R>(texels, ground.wraps);
    if texels.size() == [1, 1] {
        sum.add([cell(centre.x), cell(centre.y)], 1.0);
    } else {
        add_ellipse(&mut sum, centre, covariance);
    }
    (!sum.is_empty()).then(|| sum.finish("ewa", level, recorder))
}

/// Row by row, the texels whose centres lie within the ellipse.
fn add_ellipse(sum: &mut Sum, centre: DVec2, covariance: Covariance) {
    let Covariance { xy, yy, .. } = covariance;
    let determinant = covariance.determinant();
    let at_the_edge = exp(-REACH * REACH / 2.0);
    let tall = REACH * yy.sqrt();
    for row in cell(centre.y - tall - 0.5) + 1..=cell(centre.y + tall - 0.5) {
        let dy = row as f64 + 0.5 - centre.y;
        // The Gaussian in x at this height: its middle, its variance, and what is left of the reach.
        let middle = centre.x + xy / yy * dy;
        let variance = determinant / yy;
        let spent = dy * dy / yy;
        let wide = (variance * (REACH * REACH - spent).max(0.0)).sqrt();
        for column in cell(middle - wide - 0.5) + 1..=cell(middle + wide - 0.5) {
            let dx = column as f64 + 0.5 - middle;
            let weight = exp(-(spent + dx * dx / variance) / 2.0) - at_the_edge;
            sum.add([column, row], weight.max(0.0));
        }
    }
}
