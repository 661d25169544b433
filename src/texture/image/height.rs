//! An image as a relief: its luminance as a smooth height, with slopes.

use super::texels::Texels;
use super::wrap::{Wraps, cell};
use glam::{DVec2, DVec3};

/// The luminance of linear sRGB (Rec. ITU-R BT.709).
const LUMINANCE: DVec3 = DVec3::new(0.2126, 0.7152, 0.0722);

/// The luminance at `point`, in texels from the top left corner, and its slopes along columns and rows: a cubic B-spline with the
/// texels as its control points. It has continuous curvature, so that a bump shows no edges along texels, and never goes
/// beyond the texels around it; in return it smooths what is one texel wide.
pub(super) fn height_and_slopes(texels: &Texels, wraps: Wraps, point: DVec2) -> (f64, DVec2) {
    let place = point - 0.5;
    let [x, y] = [cell(place.x), cell(place.y)];
    let part = (place - place.floor()).to_array().map(|part| if part.is_finite() { part } else { 0.5 });
    let [(wx, dx), (wy, dy)] = part.map(spline);
    let (mut height, mut slopes) = (0.0, DVec2::ZERO);
    for (j, row) in (y - 1..=y + 2).enumerate() {
        for (i, column) in (x - 1..=x + 2).enumerate() {
            let value = texels.at([column, row], wraps).dot(LUMINANCE);
            height += value * wx[i] * wy[j];
            slopes += value * DVec2::new(dx[i] * wy[j], wx[i] * dy[j]);
        }
    }
    (height, slopes)
}

/// The weights of four control points in a row at `x` from the second (0) to the third (1), and their derivatives.
fn spline(x: f64) -> ([f64; 4], [f64; 4]) {
    let rest = 1.0 - x;
    let weights = [
        rest * rest * rest / 6.0,
        (4.0 - 6.0 * x * x + 3.0 * x * x * x) / 6.0,
        (4.0 - 6.0 * rest * rest + 3.0 * rest * rest * rest) / 6.0,
        x * x * x / 6.0,
    ];
    let slopes = [-rest * rest / 2.0, (3.0 * x - 4.0) * x / 2.0, (4.0 - 3.0 * rest) * rest / 2.0, x * x / 2.0];
    (weights, slopes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::image::Wrap;

    #[test]
    fn a_plane_of_texels_gives_a_plane() {
        let data = (0..64_u8).map(|i| [f32::from(i % 8) * 0.5 + f32::from(i / 8) * 2.0; 3]).collect();
        let texels = Texels::from_linear(8, 8, data).unwrap();
        let (height, slopes) = height_and_slopes(&texels, Wraps::default(), DVec2::new(3.3, 4.6));
        assert!((height - (2.8 * 0.5 + 4.1 * 2.0)).abs() < 1e-12);
        assert!((slopes - DVec2::new(0.5, 2.0)).length() < 1e-12);
    }

    #[test]
    fn slopes_are_those_of_the_height_and_have_no_jumps() {
        let data = (0..35_u16).map(|i| [f32::from(i * 29 % 17), f32::from(i * 13 % 5), 0.5]).collect();
        let texels = Texels::from_linear(7, 5, data).unwrap();
        let wraps = Wraps { columns: Wrap::Mirror, rows: Wrap::Repeat };
        let at = |x, y| height_and_slopes(&texels, wraps, DVec2::new(x, y));
        for i in 0..400 {
            let (x, y) = (f64::from(i) * 0.0625 - 6.0, f64::from(i) * 0.04 - 5.0);
            let step = 1e-5;
            let along_x = (at(x + step, y).0 - at(x - step, y).0) / (2.0 * step);
            let along_y = (at(x, y + step).0 - at(x, y - step).0) / (2.0 * step);
            let slopes = at(x, y).1;
            assert!((slopes - DVec2::new(along_x, along_y)).length() < 1e-6, "{x}, {y}");
            assert!((at(x + 1e-9, y + 1e-9).1 - slopes).length() < 1e-6, "{x}, {y}");
        }
    }
}
