//! The map from a pixel to the plane of an image, which perspective makes a homography.

use glam::{DMat3, DVec2, DVec3};

/// The map from the pixel, the unit square, to a quadrilateral: (x, y) = (X/W, Y/W) with X, Y and W linear in the place within
/// the pixel. W is positive all over the pixel.
///
/// Source: P. S. Heckbert, Fundamentals of Texture Mapping and Image Warping, Master's thesis, Berkeley 1989, § 2.2.3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Homography {
    /// X, Y and W, each to be multiplied by (p, q, 1).
    rows: [DVec3; 3],
}

impl Homography {
    /// The homography that takes (0, 0), (1, 0), (1, 1) and (0, 1) to these corners; none where there is none that keeps the
    /// pixel in one piece: if the quadrilateral has a corner that points inwards, crosses itself or lies on a line without
    /// being a parallelogram.
    #[must_use]
    pub fn from_corners(corners: [[f64; 2]; 4]) -> Option<Self> {
        let [c0, c1, c2, c3] = corners.map(DVec2::from);
        let twist = c0 - c1 + c2 - c3;
        let (g, h) = if twist == DVec2::ZERO {
            (0.0, 0.0)
        } else {
            let (d1, d2) = (c1 - c2, c3 - c2);
            let determinant = d1.perp_dot(d2);
            (twist.perp_dot(d2) / determinant, d1.perp_dot(twist) / determinant)
        };
        // W at the four corners; linear, so that it is positive within as well.
        let is_whole = 1.0 + g > 0.0 && 1.0 + h > 0.0 && 1.0 + g + h > 0.0 && g.is_finite() && h.is_finite();
        let p = c1 * (1.0 + g) - c0;
        let q = c3 * (1.0 + h) - c0;
        let rows = [DVec3::new(p.x, q.x, c0.x), DVec3::new(p.y, q.y, c0.y), DVec3::new(g, h, 1.0)];
        (is_whole && rows.iter().all(|row| row.is_finite())).then_some(Self { rows })
    }

    /// The affine map that takes (0, 0), (1, 0) and (0, 1) to these corners.
    #[must_use]
    pub fn from_triangle([c0, c1, c2]: [DVec2; 3]) -> Self {
        let (p, q) = (c1 - c0, c2 - c0);
        Self { rows: [DVec3::new(p.x, q.x, c0.x), DVec3::new(p.y, q.y, c0.y), DVec3::Z] }
    }

    /// Where a place of the pixel lies on the image.
    #[must_use]
    pub fn apply(&self, place: DVec2) -> DVec2 {
        let place = place.extend(1.0);
        let [x, y, w] = self.rows.map(|row| row.dot(place));
        DVec2::new(x / w, y / w)
    }

    /// The line of the pixel that lies on the line x = `value` of the image (`axis` 0) or y = `value` (`axis` 1), as a vector
    /// whose product with (p, q, 1) is negative where x or y is less.
    #[must_use]
    pub fn line(&self, axis: usize, value: f64) -> DVec3 {
        self.rows[axis] - self.rows[2] * value
    }

    /// The map back, as a matrix for (x, y, 1), up to a factor; without meaning where the quadrilateral has no area.
    #[must_use]
    pub fn inverse(&self) -> DMat3 {
        DMat3::from_cols_array_2d(&self.rows.map(|row| row.to_array())).transpose().inverse()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [DVec2; 4] = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];

    #[test]
    fn corners_go_to_corners_and_come_back() {
        let corners = [[3.0, 1.0], [9.0, 2.0], [7.0, 8.0], [2.0, 4.0]];
        let map = Homography::from_corners(corners).unwrap();
        for (place, corner) in SQUARE.into_iter().zip(corners) {
            assert!((map.apply(place) - DVec2::from(corner)).length() < 1e-14);
            let back = map.inverse() * DVec2::from(corner).extend(1.0);
            assert!((back.truncate() / back.z - place).length() < 1e-14);
        }
    }

    #[test]
    fn the_diagonals_of_the_pixel_meet_where_those_of_the_footprint_do() {
        // The diagonals from (0, 0) to (4, 4) and from (3, 0) to (0, 2) meet where y = x and 2 x + 3 y = 6.
        let map = Homography::from_corners([[0.0, 0.0], [3.0, 0.0], [4.0, 4.0], [0.0, 2.0]]).unwrap();
        assert!((map.apply(DVec2::splat(0.5)) - DVec2::splat(1.2)).length() < 1e-14);
        // The line y = 1.2 of the image passes the middle of the pixel.
        assert!(map.line(1, 1.2).dot(DVec3::new(0.5, 0.5, 1.0)).abs() < 1e-14);
    }

    #[test]
    fn what_perspective_cannot_make_of_a_square_has_no_homography() {
        let bow_tie = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        let dart = [[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]];
        let on_a_line = [[0.0, 0.0], [1.0, 0.0], [3.0, 0.0], [7.0, 0.0]];
        let nowhere = [[0.0, 0.0], [1.0, f64::NAN], [1.0, 1.0], [0.0, 1.0]];
        for corners in [bow_tie, dart, on_a_line, nowhere] {
            assert_eq!(Homography::from_corners(corners), None, "{corners:?}");
        }
        // A pixel that collapses to a point has one: every place goes there.
        assert_eq!(Homography::from_corners([[2.0, 3.0]; 4]).unwrap().apply(DVec2::ONE), DVec2::new(2.0, 3.0));
    }
}
