//! The opening of a lens.

use super::{Mask, concentric_disc, polygon_corner, regular_polygon};
use std::f64::consts::TAU;
use std::sync::Arc;

/// The shape of the opening, within the unit disc or, as a picture, within the square around it.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Aperture {
    /// The disc itself.
    #[default]
    Disc,
    /// A regular polygon with its corners on the unit circle.
    Polygon {
        /// How many sides it has, 3 or more.
        sides: u32,
        /// How far it is turned anticlockwise from a corner on the right, in radians.
        turn: f64,
    },
    /// A picture that fills the square from −1 to 1: white lets light through, black does not.
    Image(Arc<Mask>),
}

/// Corners of the outline of a disc, which is drawn and not reckoned with.
const CORNERS: u32 = 48;

impl Aperture {
    /// The word for it, as scene files spell it.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Disc => "disc",
            Self::Polygon { .. } => "polygon",
            Self::Image(_) => "image",
        }
    }

    /// The point of the opening for a point of the unit square, across and upwards; equal areas let through as much light.
    #[must_use]
    pub fn point(&self, square: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Disc => concentric_disc(square),
            Self::Polygon { sides, turn } => regular_polygon(*sides, *turn, square),
            Self::Image(mask) => {
                let [across, down] = mask.point(square);
                [2.0 * across - 1.0, 1.0 - 2.0 * down]
            }
        }
    }

    /// The corners of the opening; none for a picture.
    #[must_use]
    pub fn outline(&self) -> Vec<[f64; 2]> {
        let corners = |sides: u32, turn: f64| (0..sides).map(|k| polygon_corner(sides, turn, k)).collect();
        match self {
            Self::Disc => corners(CORNERS, 0.5 * TAU / f64::from(CORNERS)),
            Self::Polygon { sides, turn } => corners(*sides, *turn),
            Self::Image(_) => Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_stands_upright_in_the_lens() {
        // Bright at the top right alone.
        let image = Aperture::Image(Arc::new(Mask::new(2, &[0.0, 1.0, 0.0, 0.0]).unwrap()));
        for square in [[0.1, 0.2], [0.9, 0.9], [0.5, 0.0]] {
            let [across, upwards] = image.point(square);
            assert!(across >= 0.0 && upwards >= 0.0, "({across}, {upwards})");
        }
    }

    #[test]
    fn a_square_that_is_turned_by_half_a_right_angle_stands_upright() {
        let aperture = Aperture::Polygon { sides: 4, turn: std::f64::consts::FRAC_PI_4 };
        let corner = 0.5_f64.sqrt();
        for [x, y] in aperture.outline() {
            assert!((x.abs() - corner).abs() < 1e-15 && (y.abs() - corner).abs() < 1e-15, "({x}, {y})");
        }
    }
}
