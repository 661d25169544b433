//! The part of an image that a pixel covers.

use glam::DVec2;

/// A pixel's four corners on an image, in texels from its top left corner, in their order about the pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footprint {
    /// The corners.
    pub corners: [[f64; 2]; 4],
}

impl Footprint {
    /// The same in a level of the pyramid: columns and rows scaled.
    #[must_use]
    pub fn scaled(&self, by: DVec2) -> Self {
        Self { corners: self.corners.map(|[x, y]| [x * by.x, y * by.y]) }
    }

    /// Whether all corners are places.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.corners.as_flattened().iter().all(|value| value.is_finite())
    }

    /// The sides, each from its corner to the next.
    fn sides(&self) -> [DVec2; 4] {
        let corner = |i: usize| DVec2::from(self.corners[i % 4]);
        std::array::from_fn(|i| corner(i + 1) - corner(i))
    }

    /// The length of the longest side, in texels.
    #[must_use]
    pub fn longest_side(&self) -> f64 {
        self.sides().map(DVec2::length).into_iter().fold(0.0, f64::max)
    }

    /// The pixel's width and height as they lie on the image: the means of opposite sides, in texels.
    #[must_use]
    pub fn axes(&self) -> [DVec2; 2] {
        let [a, b, c, d] = self.sides();
        [(a - c) / 2.0, (b - d) / 2.0]
    }

    /// A bound on the number of texels that the footprint touches: its area, and what its outline crosses.
    #[must_use]
    pub fn texels(&self) -> f64 {
        let [first, second] = [[0, 1, 2], [0, 2, 3]].map(|[i, j, k]| {
            let corner = |i: usize| DVec2::from(self.corners[i]);
            (corner(j) - corner(i)).perp_dot(corner(k) - corner(i)).abs() / 2.0
        });
        let outline: f64 = self.sides().iter().map(|side| side.x.abs() + side.y.abs()).sum();
        first + second + outline + 4.0
    }
}

/// The corners brought as near to the centre as the surface's periods allow: across a seam u jumps by a period, and a pixel
/// there would otherwise seem to cover the whole surface.
#[must_use]
pub(super) fn across_seams(centre: DVec2, corners: [DVec2; 4], period: [Option<f64>; 2]) -> [DVec2; 4] {
    let nearest = |centre: f64, corner: f64, period: Option<f64>| match period {
        Some(period) => corner - ((corner - centre) / period).round() * period,
        None => corner,
    };
    corners.map(|corner| DVec2::new(nearest(centre.x, corner.x, period[0]), nearest(centre.y, corner.y, period[1])))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_on_a_seam_stays_small() {
        let corners = [(0.99, 0.1), (0.02, 0.1), (0.02, 0.2), (0.98, 0.2)].map(DVec2::from);
        let whole = across_seams(DVec2::new(0.995, 0.15), corners, [Some(1.0), None]);
        let u: Vec<f64> = whole.iter().map(|corner| corner.x).collect();
        assert!(u.iter().zip([0.99, 1.02, 1.02, 0.98]).all(|(x, y)| (x - y).abs() < 1e-15), "{u:?}");
        assert_eq!(across_seams(DVec2::new(0.5, 0.5), corners, [None, None]), corners);
    }

    #[test]
    fn axes_and_sides_are_those_of_a_parallelogram() {
        let footprint = Footprint { corners: [[0.0, 0.0], [4.0, 2.0], [3.0, 5.0], [-1.0, 3.0]] };
        assert_eq!(footprint.axes(), [DVec2::new(4.0, 2.0), DVec2::new(-1.0, 3.0)]);
        assert_eq!(footprint.longest_side(), 20.0_f64.sqrt());
        // The area is 4·3 + 2·1 = 14.
        assert!(footprint.texels() >= 14.0);
    }
}
