//! A compiled scene: what the tracer sees.

use crate::csg::Solid;
use glam::DVec3;

/// Linear RGB.
pub type Rgb = DVec3;

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
        let (half_width, half_height) = self.half_size(image);
        let across = half_width * (2.0 * x / f64::from(image.width) - 1.0);
        let upwards = half_height * (1.0 - 2.0 * y / f64::from(image.height));
        self.forward + self.right * across + self.up * upwards
    }

    /// Where a point of the world appears in the picture; none if it is not in front of the eye.
    #[must_use]
    pub fn project(&self, image: Image, world: DVec3) -> Option<[f64; 2]> {
        let (half_width, half_height) = self.half_size(image);
        let from_eye = world - self.eye;
        let depth = from_eye.dot(self.forward);
        let across = from_eye.dot(self.right) / (depth * half_width);
        let upwards = from_eye.dot(self.up) / (depth * half_height);
        let pixel = [0.5 * (1.0 + across) * f64::from(image.width), 0.5 * (1.0 - upwards) * f64::from(image.height)];
        (depth > 0.0 && pixel.iter().all(|x| x.is_finite())).then_some(pixel)
    }

    /// Half the width and height of the image plane at distance 1.
    fn half_size(&self, image: Image) -> (f64, f64) {
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

/// Where light comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// A point; its light does not fade with distance.
    Point(DVec3),
    /// From infinitely far away; the unit vector **towards** the light.
    Directional(DVec3),
}

/// A light source.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Its name.
    pub name: String,
    /// Point or directional.
    pub kind: LightKind,
    /// Its colour, not limited to 1.
    pub colour: Rgb,
}

/// How a surface answers light.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name.
    pub name: String,
    /// Ambient colour.
    pub ambient: Rgb,
    /// Diffuse colour.
    pub diffuse: Rgb,
    /// Specular colour.
    pub specular: Rgb,
    /// Phong exponent of the specular term.
    pub exponent: f64,
    /// Weight of the reflected ray, 0 to 1.
    pub reflectivity: f64,
    /// Weight of the transmitted ray, 0 to 1.
    pub transparency: f64,
    /// Index of refraction relative to vacuum.
    pub index_of_refraction: f64,
}

/// What happens where transparent objects overlap (§ 6.4.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MediaPolicy {
    /// Policy 1: they may not; overlaps are reported and the most recently entered object wins.
    Forbid,
    /// Policy 2: the most recently entered object wins.
    MostRecent,
    /// Policy 2: the object with the highest priority wins; among equals the most recently entered.
    Priority,
}

/// Where a ray's tree ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Rays deeper than this are not spawned.
    pub depth: u32,
    /// Rays whose colour would count less than this in the pixel are not spawned.
    pub contribution: f64,
}

/// A solid with materials.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Its name.
    pub name: String,
    /// The geometry.
    pub solid: Solid,
    /// For each leaf the index of its material in [`Scene::materials`].
    pub leaf_materials: Vec<usize>,
    /// The material that fills the object: an index into [`Scene::materials`].
    pub material: usize,
    /// The higher one wins under [`MediaPolicy::Priority`].
    pub priority: i32,
}

/// A scene, ready to be traced.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// One line.
    pub title: String,
    /// A paragraph for the student.
    pub about: String,
    /// The sections of the syllabus that it shows.
    pub sections: Vec<String>,
    /// The eye.
    pub camera: Camera,
    /// The picture.
    pub image: Image,
    /// Ambient light.
    pub ambient: Rgb,
    /// What a ray sees that hits nothing.
    pub background: Rgb,
    /// The lights.
    pub lights: Vec<Light>,
    /// The materials.
    pub materials: Vec<Material>,
    /// The object list.
    pub objects: Vec<Object>,
    /// What happens where transparent objects overlap.
    pub media: MediaPolicy,
    /// Where a ray's tree ends.
    pub limits: Limits,
    /// The pixel that tells the scene's story best: where the workbench starts and what the snapshot pins.
    pub pixels: Vec<[u32; 2]>,
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
