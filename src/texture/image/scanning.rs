//! The two orders in which an image can be brought into a picture (§ 6.3.1).
//!
//! Texture scanning carries each texel forward to the picture: where the image is drawn larger pixels are left out, where it is
//! drawn smaller they are painted again and again. Inverse scanning asks for each pixel where it lies on the image, and so
//! paints every one exactly once.

use super::texels::Texels;
use super::wrap::{Wraps, cell};
use glam::{DVec2, DVec3};

/// What scanning painted.
#[derive(Clone, Debug, PartialEq)]
pub struct Scan {
    /// Columns of the picture.
    pub width: u32,
    /// Rows of the picture.
    pub height: u32,
    /// How often each pixel was painted, row by row from the top.
    pub painted: Vec<u32>,
    /// The colour that was painted last; black where none was.
    pub colours: Vec<DVec3>,
}

impl Scan {
    fn blank([width, height]: [u32; 2]) -> Self {
        let count = width as usize * height as usize;
        Self { width, height, painted: vec![0; count], colours: vec![DVec3::ZERO; count] }
    }

    /// Texture scanning: the middle of each texel is carried from (s, t) to the picture, in pixels from its top left corner, and the
    /// pixel there is painted. What comes to nowhere, or beyond the picture, is left out.
    #[must_use]
    pub fn forward(texels: &Texels, size: [u32; 2], picture_from_st: impl Fn(DVec2) -> Option<DVec2>) -> Self {
        let mut scan = Self::blank(size);
        let [columns, rows] = texels.size();
        for row in 0..rows {
            for column in 0..columns {
                let across = (f64::from(column) + 0.5) / f64::from(columns);
                let down = (f64::from(row) + 0.5) / f64::from(rows);
                let pixel = picture_from_st(DVec2::new(across, 1.0 - down)).and_then(|at| scan.pixel(at));
                if let Some(pixel) = pixel {
                    scan.painted[pixel] += 1;
                    scan.colours[pixel] = texels.at([i64::from(column), i64::from(row)], Wraps::default());
                }
            }
        }
        scan
    }

    /// Inverse scanning: the middle of each pixel is carried from the picture to (s, t), and the pixel is painted with the texel there if
    /// that lies within the image.
    #[must_use]
    pub fn inverse(texels: &Texels, size: [u32; 2], st_from_picture: impl Fn(DVec2) -> Option<DVec2>) -> Self {
        let mut scan = Self::blank(size);
        let [columns, rows] = texels.size().map(f64::from);
        for y in 0..size[1] {
            for x in 0..size[0] {
                let middle = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
                let st = st_from_picture(middle).filter(|st| st.cmpge(DVec2::ZERO).all() && st.cmple(DVec2::ONE).all());
                if let (Some(st), Some(pixel)) = (st, scan.pixel(middle)) {
                    scan.painted[pixel] += 1;
                    scan.colours[pixel] =
                        texels.at([cell(st.x * columns), cell((1.0 - st.y) * rows)], Wraps::default());
                }
            }
        }
        scan
    }

    /// How many pixels were painted more than once.
    #[must_use]
    pub fn overlaps(&self) -> usize {
        self.painted.iter().filter(|count| **count > 1).count()
    }

    /// How many pixels were left out that `other` painted.
    #[must_use]
    pub fn holes(&self, other: &Self) -> usize {
        self.painted.iter().zip(&other.painted).filter(|(own, other)| **own == 0 && **other > 0).count()
    }

    /// The place of a pixel in the lists.
    fn pixel(&self, at: DVec2) -> Option<usize> {
        let [x, y] = [at.x, at.y].map(|place| u32::try_from(cell(place)).ok().filter(|_| place.is_finite()));
        let (x, y) = (x.filter(|x| *x < self.width)?, y.filter(|y| *y < self.height)?);
        Some(y as usize * self.width as usize + x as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::image::Homography;

    /// A square seen at a slant: its near edge is 80 pixels wide, its far one 12, where 40 texels lie side by side.
    fn slanted() -> (Texels, Homography) {
        let colours = (0..1600_u16).map(|i| [f32::from(i), 1.0, 0.0]).collect();
        let texels = Texels::from_linear(40, 40, colours).unwrap();
        let corners = [[8.3, 86.1], [88.4, 80.2], [60.7, 9.6], [48.1, 11.3]];
        (texels, Homography::from_corners(corners).unwrap())
    }

    #[test]
    fn texture_scanning_leaves_holes_and_overlaps_and_inverse_scanning_neither() {
        let (texels, map) = slanted();
        let forward = Scan::forward(&texels, [96, 96], |st| Some(map.apply(st)));
        let back = map.inverse();
        let inverse = Scan::inverse(&texels, [96, 96], |at| {
            let st = back * at.extend(1.0);
            Some(st.truncate() / st.z)
        });
        assert_eq!(forward.painted.iter().sum::<u32>(), 1600);
        assert!(forward.holes(&inverse) > 500, "{} holes", forward.holes(&inverse));
        assert!(forward.overlaps() > 100, "{} overlaps", forward.overlaps());
        assert_eq!(inverse.overlaps(), 0);
        // Inverse scanning paints as many pixels as the quadrilateral has area, about half its outline's pixels more or less.
        let area = 0.5 * ((60.7 - 8.3) * (11.3 - 80.2) - (48.1 - 88.4) * (9.6 - 86.1_f64)).abs();
        let painted = inverse.painted.iter().sum::<u32>();
        assert!((f64::from(painted) - area).abs() < 30.0, "{painted} pixels of {area}");
    }

    #[test]
    fn both_orders_agree_where_a_texel_is_a_pixel() {
        let texels = Texels::from_linear(4, 3, (0..12_u8).map(|i| [f32::from(i); 3]).collect()).unwrap();
        let forward = Scan::forward(&texels, [4, 3], |st| Some(DVec2::new(st.x * 4.0, (1.0 - st.y) * 3.0)));
        let inverse = Scan::inverse(&texels, [4, 3], |at| Some(DVec2::new(at.x / 4.0, 1.0 - at.y / 3.0)));
        assert_eq!(forward, inverse);
        assert_eq!(forward.painted, [1; 12]);
    }

    #[test]
    fn what_comes_to_nowhere_is_left_out() {
        let texels = Texels::from_linear(1, 1, vec![[1.0; 3]]).unwrap();
        for at in [None, Some(DVec2::NAN), Some(DVec2::new(-0.5, 0.5)), Some(DVec2::splat(1e300))] {
            assert_eq!(Scan::forward(&texels, [2, 2], |_| at).painted, [0; 4]);
        }
    }
}
