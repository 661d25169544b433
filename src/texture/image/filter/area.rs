//! The exact average over a pixel.
//!
//! The map from a pixel to a plane in perspective is a homography, which takes lines to lines. So the columns and rows of
//! texels are straight lines on the pixel, too, and cut it into convex pieces of one texel each. A piece's area on the
//! *pixel* is the texel's share; its area on the image would give too little to what is near and too much to what is far.
//!
//! **Accuracy**: rounding alone up to `MOST_TOUCHED` texels. With more, a level of the pyramid stands in for the image, whose
//! blocks count as a whole although the pixel's edge and its perspective weigh their texels differently.
//!
//! A quadrilateral without a homography (a pixel on a curved edge) is taken in two triangles, each with an affine map.

use super::Ground;
use crate::record::Recorder;
use crate::texture::image::footprint::Footprint;
use crate::texture::image::homography::Homography;
use crate::texture::image::polygon::Polygon;
use crate::texture::image::sum::Sum;
use crate::texture::image::wrap::cell;
use arrayvec::ArrayVec;
use glam::{DVec2, DVec3};

/// A part of the pixel, and its map to the image.
struct Patch {
    polygon: Polygon,
    map: Homography,
}

/// The average over the pixel; none if it comes to nothing.
pub(super) fn colour<R: Recorder>(ground: Ground, footprint: &Footprint, recorder: &mut R) -> Option<DVec3> {
    let (level, scale) = ground.level(|scale| footprint.scaled(scale).texels());
    let texels = ground.texels.level(level);
    let footprint = footprint.scaled(scale);
    let mut sum = Sum::new::<R>(texels, ground.wraps);
    if texels.size() == [1, 1] {
        sum.add([cell(footprint.corners[0][0]), cell(footprint.corners[0][1])], 1.0);
    } else {
        for patch in patches(&footprint) {
            add_patch(&mut sum, &patch);
        }
    }
    (!sum.is_empty()).then(|| sum.finish("area", level, recorder))
}

/// The whole pixel, or its two halves.
fn patches(footprint: &Footprint) -> ArrayVec<Patch, 2> {
    if let Some(map) = Homography::from_corners(footprint.corners) {
        return std::iter::once(Patch { polygon: Polygon::new(&[DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y]), map })
            .collect();
    }
    let triangle = |corners: [usize; 3]| Patch {
        polygon: Polygon::new(&[DVec2::ZERO, DVec2::X, DVec2::Y]),
        map: Homography::from_triangle(corners.map(|i| DVec2::from(footprint.corners[i]))),
    };
    [triangle([0, 1, 2]), triangle([0, 2, 3])].into()
}

fn add_patch(sum: &mut Sum, patch: &Patch) {
    cut(&patch.polygon, &patch.map, 1, |row, strip| {
        cut(strip, &patch.map, 0, |column, piece| sum.add([column, row], piece.area()));
    });
}

/// Cuts a polygon of the pixel along the columns (`axis` 0) or rows (`axis` 1) of texels.
fn cut(polygon: &Polygon, map: &Homography, axis: usize, mut each: impl FnMut(i64, &Polygon)) {
    let places = polygon.corners().iter().map(|corner| map.apply(*corner)[axis]);
    let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    if low > high {
        return;
    }
    let last = cell(high);
    let mut rest = polygon.clone();
    for index in cell(low)..last {
        let [piece, beyond] = rest.split(map.line(axis, (index + 1) as f64));
        if !piece.corners().is_empty() {
            each(index, &piece);
        }
        rest = beyond;
    }
    if !rest.corners().is_empty() {
        each(last, &rest);
    }
}
