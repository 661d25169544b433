//! The eye: a pinhole or a thin lens, the image plane, and how its pixels are sampled.

use crate::sample::{Aperture, PixelFilter};
use glam::DVec3;

/// The eye and the image plane, resolved to an orthonormal frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Where the eye is.
    pub eye: DVec3,
    /// Unit vector to the right of the image.
    pub right: DVec3,
    /// Unit vector towards the top of the image.
    pub up: DVec3,
    /// Unit vector into the image.
    pub forward: DVec3,
    /// Half the height of the image plane at distance 1: tan(vertical field of view / 2).
    pub half_height: f64,
}

impl Camera {
    /// The direction of the ray through the point (x, y) of the picture, not normalised: its end lies on the image plane at
    /// distance 1. Pixels have side 1, and the centre of the top left one is (0.5, 0.5).
    #[must_use]
    pub fn ray_direction(&self, image: Image, x: f64, y: f64) -> DVec3 {
        self.direction_through(self.place(image, x, y))
    }

    /// The direction of the ray through a place on the image plane at distance 1, across and upwards from its middle.
    #[must_use]
    pub fn direction_through(&self, [across, upwards]: [f64; 2]) -> DVec3 {
        self.forward + self.right * across + self.up * upwards
    }

    /// Where the point (x, y) of the picture lies on the image plane at distance 1: across and upwards from its middle.
    #[must_use]
    pub fn place(&self, image: Image, x: f64, y: f64) -> [f64; 2] {
        let (half_width, half_height) = self.half_size(image);
        let across = half_width * (2.0 * x / f64::from(image.width) - 1.0);
        let upwards = half_height * (1.0 - 2.0 * y / f64::from(image.height));
        [across, upwards]
    }

    /// The point of the picture at a place on the image plane: what [`place`](Self::place) undoes.
    #[must_use]
    pub fn pixel_at(&self, image: Image, [across, upwards]: [f64; 2]) -> [f64; 2] {
        let (half_width, half_height) = self.half_size(image);
        let (width, height) = (f64::from(image.width), f64::from(image.height));
        [0.5 * (1.0 + across / half_width) * width, 0.5 * (1.0 - upwards / half_height) * height]
    }

    /// Where a point of the world appears in the picture; none if it is not in front of the eye.
    #[must_use]
    pub fn project(&self, image: Image, world: DVec3) -> Option<[f64; 2]> {
        let from_eye = world - self.eye;
        let depth = from_eye.dot(self.forward);
        let pixel = self.pixel_at(image, [from_eye.dot(self.right) / depth, from_eye.dot(self.up) / depth]);
        (depth > 0.0 && pixel.iter().all(|x| x.is_finite())).then_some(pixel)
    }

    /// Half the width and height of the image plane at distance 1.
    #[must_use]
    pub fn half_size(&self, image: Image) -> (f64, f64) {
        (self.half_height * f64::from(image.width) / f64::from(image.height), self.half_height)
    }
}

/// The picture's size in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Image {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

/// A thin lens in the place of the pinhole.
#[derive(Clone, Debug, PartialEq)]
pub struct Lens {
    /// Its radius.
    pub radius: f64,
    /// How far the plane of focus is from it, along the view.
    pub focus: f64,
    /// The shape of its opening.
    pub aperture: Aperture,
}

/// How pixels are sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Rays through each pixel; 1 is one through its centre.
    pub samples: u32,
    /// How they are weighted.
    pub filter: PixelFilter,
    /// More samples where a pixel is not sure of its colour.
    pub adaptive: Option<Adaptive>,
    /// Another seed is another pattern.
    pub seed: u32,
    /// Points of the lens for each place in a pixel, where there is a lens.
    pub lens_samples: u32,
    /// How many wavelengths a ray is split into where it first meets a dispersive surface.
    pub wavelengths: u32,
}

/// The number of samples is doubled until a pixel is sure enough.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adaptive {
    /// The most that a pixel may get.
    pub most: u32,
    /// The standard error in linear RGB at which it is sure enough.
    pub error: f64,
}

impl Sampling {
    /// One ray through each pixel's centre.
    pub const CENTRE: Self =
        Self { samples: 1, filter: PixelFilter::Box, adaptive: None, seed: 0, lens_samples: 1, wavelengths: 16 };

    /// Whether pixels have more than one sample.
    #[must_use]
    pub fn is_many(&self) -> bool {
        self.samples > 1 || self.adaptive.is_some_and(|adaptive| adaptive.most > 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const IMAGE: Image = Image { width: 200, height: 100 };
    const CAMERA: Camera =
        Camera { eye: DVec3::ZERO, right: DVec3::X, up: DVec3::Z, forward: DVec3::Y, half_height: 0.5 };

    #[test]
    fn the_middle_of_the_picture_is_straight_ahead() {
        assert_eq!(CAMERA.ray_direction(IMAGE, 100.0, 50.0), DVec3::Y);
    }

    #[test]
    fn the_corners_are_half_a_picture_away() {
        assert_eq!(CAMERA.ray_direction(IMAGE, 0.0, 0.0), DVec3::new(-1.0, 1.0, 0.5));
        assert_eq!(CAMERA.ray_direction(IMAGE, 200.0, 100.0), DVec3::new(1.0, 1.0, -0.5));
    }

    #[test]
    fn projecting_a_point_of_a_ray_gives_the_pixel_of_the_ray() {
        let [x, y] = CAMERA.project(IMAGE, CAMERA.ray_direction(IMAGE, 33.5, 71.5) * 8.0).unwrap();
        assert!((x - 33.5).abs() < 1e-12 && (y - 71.5).abs() < 1e-12);
    }

    #[test]
    fn what_is_behind_or_beside_the_eye_is_not_in_the_picture() {
        assert_eq!(CAMERA.project(IMAGE, -DVec3::Y), None);
        assert_eq!(CAMERA.project(IMAGE, DVec3::X), None);
    }
}
