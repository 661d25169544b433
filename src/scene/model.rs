//! A compiled scene: what the tracer sees.

use super::{Coat, Detail, LeafCoat, ObjectIndex};
use crate::csg::{Boundary, Solid};
use crate::shape::Primitive;
use crate::texture::image::Environment;
use glam::{DVec2, DVec3};
use smallvec::SmallVec;

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
    /// What it carries besides its plain colours, if anything.
    pub coat: Option<Box<Coat>>,
}

impl Material {
    /// Whether mirrored and refracted directions are looked up in the environment and not followed.
    #[must_use]
    pub fn mirrors_environment(&self) -> bool {
        self.coat.as_ref().is_some_and(|coat| coat.mirrors_environment)
    }
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

/// What a ray may be spared. None of it changes a picture; each can be left out to see what it saves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "independent switches, each used alone")]
pub struct Shortcuts {
    /// Tests against the boxes of solids and of what they are made of.
    pub boxes: bool,
    /// Tests against their balls.
    pub balls: bool,
    /// Tests of rays from the eye against the rectangles of objects in the picture.
    pub projections: bool,
    /// The trees of boxes over the objects, and over the operands of wide unions.
    pub hierarchy: bool,
    /// The grids of what the eye and the lights see.
    pub sights: bool,
}

impl Shortcuts {
    /// All of them.
    pub const ALL: Self = Self { boxes: true, balls: true, projections: true, hierarchy: true, sights: true };
    /// Every ray asks everything.
    pub const NONE: Self = Self { boxes: false, balls: false, projections: false, hierarchy: false, sights: false };
}

/// A solid with materials.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Its name.
    pub name: String,
    /// The geometry.
    pub solid: Solid,
    /// For each leaf the index of its material in [`Scene::materials`].
    pub leaf_materials: SmallVec<[usize; 1]>,
    /// The material that fills the object: an index into [`Scene::materials`].
    pub material: usize,
    /// The higher one wins under [`MediaPolicy::Priority`].
    pub priority: i32,
    /// For each leaf what its surface needs to know to carry something; none where nothing of the object does.
    pub coats: Option<Box<[LeafCoat]>>,
}

impl Object {
    /// The materials of its surface, those of details among them.
    pub fn surface_materials(&self) -> impl Iterator<Item = usize> {
        let details = self.coats.iter().flatten().flat_map(|coat| Detail::materials(&coat.details));
        self.leaf_materials.iter().copied().chain(details)
    }

    /// The material at a place on the surface, with the detail that decides it, if one does, and the place in its cell.
    #[must_use]
    pub fn material_at(&self, boundary: &Boundary, point: DVec3) -> (usize, Option<(&Detail, DVec2)>) {
        let plain = self.leaf_materials[boundary.leaf];
        let Some(coats) = &self.coats else { return (plain, None) };
        let details = &coats[boundary.leaf].details;
        if details.is_empty() {
            return (plain, None);
        }
        let leaf = &self.solid.leaves[boundary.leaf];
        let uv = leaf.shape.uv(leaf.placement.generic_point(point), boundary.part);
        let topmost = Detail::topmost(details, boundary.part, uv);
        (topmost.map_or(plain, |(detail, _)| detail.material), topmost)
    }
}

/// Light from infinitely far away.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneEnvironment {
    /// Its picture.
    pub map: Environment,
    /// Whether it is averaged over what a pixel sees of it.
    pub averaged: bool,
}

impl Scene {
    /// The same scene in another frame of its animation.
    #[must_use]
    pub fn at_frame(mut self, frame: f64) -> Self {
        for coat in self.materials.iter_mut().filter_map(|material| material.coat.as_deref_mut()) {
            coat.set_frame(frame);
        }
        self.frame = frame;
        self
    }
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
    /// What a ray sees that hits nothing, where there is no environment.
    pub background: Rgb,
    /// Light from infinitely far away, in all directions.
    pub environment: Option<SceneEnvironment>,
    /// Whether anything in the scene asks what a pixel sees of it, so that rays go with beams.
    pub needs_beams: bool,
    /// The frame of an animation: the time for everything that moves.
    pub frame: f64,
    /// The lights.
    pub lights: Vec<Light>,
    /// The materials.
    pub materials: Vec<Material>,
    /// The object list.
    pub objects: Vec<Object>,
    /// What is known of the object list before a ray is sent.
    pub index: ObjectIndex,
    /// What rays are spared.
    pub shortcuts: Shortcuts,
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
