//! The disc: an even map from the unit square.

use crate::math::sine_cosine_of_eighth;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// The point of the unit disc for a point of the unit square. Equal areas stay equal, and squares about the middle become
/// rings about the middle; the middle itself stays where it is.
///
/// Source: P. Shirley and K. Chiu, A Low Distortion Map Between Disk and Square (Journal of Graphics Tools 2(3), 1997).
#[inline]
#[must_use]
pub fn concentric_disc(square: [f64; 2]) -> [f64; 2] {
    let [a, b] = square.map(|x| 2.0 * x - 1.0);
    let is_above = a.abs() <= b.abs();
    let [radius, other] = exchanged_if(is_above, [a, b]);
    // In the middle both are 0, and the angle is any.
    let quotient = other / if radius == 0.0 { 1.0 } else { radius };
    let (sine, cosine) = sine_cosine_of_eighth(FRAC_PI_4 * quotient);
    exchanged_if(is_above, [radius * cosine, radius * sine])
}

/// The two numbers, in the other order where `condition` holds: by their bits, for a branch would be guessed wrong at every
/// other random point.
#[inline]
fn exchanged_if(condition: bool, pair: [f64; 2]) -> [f64; 2] {
    let [a, b] = pair.map(f64::to_bits);
    let turned = (a ^ b) & u64::from(condition).wrapping_neg();
    [a, b].map(|bits| f64::from_bits(bits ^ turned))
}

/// The same point by its distance from the middle and its angle in radians.
pub(super) fn polar(square: [f64; 2]) -> (f64, f64) {
    let [a, b] = square.map(|x| 2.0 * x - 1.0);
    if a == 0.0 && b == 0.0 {
        return (0.0, 0.0);
    }
    let (radius, angle) =
        if a.abs() > b.abs() { (a, FRAC_PI_4 * (b / a)) } else { (b, FRAC_PI_2 - FRAC_PI_4 * (a / b)) };
    if radius < 0.0 { (-radius, angle + PI) } else { (radius, angle) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_and_the_edges_of_the_square_go_to_the_middle_and_the_rim_of_the_disc() {
        let near = |[x, y]: [f64; 2], [a, b]: [f64; 2]| (x - a).abs() < 1e-15 && (y - b).abs() < 1e-15;
        assert_eq!(concentric_disc([0.5, 0.5]), [0.0, 0.0]);
        assert!(near(concentric_disc([1.0, 0.5]), [1.0, 0.0]));
        assert!(near(concentric_disc([0.0, 0.5]), [-1.0, 0.0]));
        assert!(near(concentric_disc([0.5, 1.0]), [0.0, 1.0]));
        assert!(near(concentric_disc([0.5, 0.0]), [0.0, -1.0]));
        let corner = f64::sqrt(0.5);
        assert!(near(concentric_disc([1.0, 1.0]), [corner, corner]));
        assert!(near(concentric_disc([0.0, 1.0]), [-corner, corner]));
    }

    /// The area of the image of a small square is π times its own, wherever it lies: by the corners' cross product.
    #[test]
    fn the_map_keeps_areas() {
        let h = 1e-5;
        for (x, y) in [(0.1, 0.3), (0.9, 0.55), (0.4, 0.8), (0.51, 0.2), (0.7, 0.69)] {
            let corner = |dx: f64, dy: f64| concentric_disc([x + dx, y + dy]);
            let ([ax, ay], [bx, by]) = (corner(-h, -h), corner(h, h));
            let ([cx, cy], [dx, dy]) = (corner(h, -h), corner(-h, h));
            let area = 0.5 * ((bx - ax) * (dy - cy) - (by - ay) * (dx - cx)).abs();
            assert!((area / (4.0 * h * h) - std::f64::consts::PI).abs() < 1e-6, "({x}, {y}): {area}");
        }
    }
}
