//! The regular polygon: an even map from the unit square.

use super::disc::polar;
use crate::math::sine_cosine;
use std::f64::consts::TAU;

/// The corner with this number of a regular polygon on the unit circle, anticlockwise from the angle `turn` in radians.
#[must_use]
pub fn polygon_corner(sides: u32, turn: f64, number: u32) -> [f64; 2] {
    let (sine, cosine) = sine_cosine(turn + TAU * f64::from(number) / f64::from(sides));
    [cosine, sine]
}

/// The point of a regular polygon on the unit circle for a point of the unit square; equal areas stay equal.
///
/// The square goes to the disc first, and the disc's sectors to the polygon's triangles: the way along an arc becomes the
/// way along its chord, which keeps areas in proportion.
#[must_use]
pub fn regular_polygon(sides: u32, turn: f64, square: [f64; 2]) -> [f64; 2] {
    let (radius, angle) = polar(square);
    let turns = (angle / TAU).rem_euclid(1.0) * f64::from(sides);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to the number of sides")]
    let side = turns as u32;
    let along = turns - f64::from(side);
    let [[ax, ay], [bx, by]] = [side, side + 1].map(|number| polygon_corner(sides, turn, number));
    [radius * (ax + (bx - ax) * along), radius * (ay + (by - ay) * along)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid() -> impl Iterator<Item = [f64; 2]> {
        (0..256).flat_map(|x| (0..256).map(move |y| [x, y].map(|k| (f64::from(k) + 0.5) / 256.0)))
    }

    /// A regular polygon on the unit circle has the second moment ∫x² / area = (2 + cos 2π/n) / 12 about any axis through
    /// its middle.
    #[test]
    fn the_points_fill_the_polygon_evenly() {
        for (sides, turn) in [(3, 0.3), (4, 0.0), (5, 1.0), (6, 0.1), (9, 2.0)] {
            let moment =
                |f: fn([f64; 2]) -> f64| grid().map(|p| f(regular_polygon(sides, turn, p))).sum::<f64>() / 65536.0;
            let second = (2.0 + (TAU / f64::from(sides)).cos()) / 12.0;
            for (mean, exact) in [
                (moment(|[x, _]| x), 0.0),
                (moment(|[_, y]| y), 0.0),
                (moment(|[x, _]| x * x), second),
                (moment(|[_, y]| y * y), second),
                (moment(|[x, y]| x * y), 0.0),
            ] {
                assert!((mean - exact).abs() < 2e-4, "{sides} sides: {mean} and not {exact}");
            }
        }
    }

    #[test]
    fn every_point_lies_behind_every_side() {
        for sides in 3..9 {
            let middle_of = |k: u32| polygon_corner(2 * sides, 0.4 + std::f64::consts::PI / f64::from(sides), 2 * k);
            let apothem = (std::f64::consts::PI / f64::from(sides)).cos();
            for [x, y] in grid().map(|p| regular_polygon(sides, 0.4, p)) {
                assert!((0..sides).map(middle_of).all(|[a, b]| a * x + b * y < apothem + 1e-12), "({x}, {y})");
            }
        }
    }
}
