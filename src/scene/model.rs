//! A compiled scene: what the tracer sees.

use super::{Camera, Coat, Detail, Effects, Image, LeafCoat, Lens, Light, ObjectIndex, Origin, Sampling};
use crate::csg::{Boundary, Solid};
use crate::optics::{Dispersion, Medium};
use crate::shape::{Primitive, Solving};
use crate::texture::image::Environment;
use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};
use smallvec::SmallVec;

/// Linear RGB.
pub type Rgb = DVec3;

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
    /// Index of refraction relative to vacuum; of a dispersive material that at 587.56 nm, the yellow line of helium.
    pub index_of_refraction: f64,
    /// What decides how much is mirrored and how much goes through.
    pub split: Split,
    /// The index of refraction by wavelength, where it depends on it.
    pub dispersion: Option<Dispersion>,
    /// What fills an object of this material, where that takes light away.
    pub medium: Option<Medium>,
    /// What it carries besides its plain colours, if anything.
    pub coat: Option<Box<Coat>>,
}

/// What decides how much light is mirrored at a surface and how much goes through.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Split {
    /// Fixed weights, whatever the angle: those of Hill's shading model.
    #[default]
    Weights,
    /// Fresnel's equations for two media that do not absorb.
    Dielectric,
    /// Fresnel's equations for a metal of index η + i k, by colour; nothing goes through.
    Conductor {
        /// η.
        eta: Rgb,
        /// k.
        k: Rgb,
    },
}

impl Material {
    /// Whether it mirrors light or lets it through.
    #[inline]
    #[must_use]
    pub fn sends_rays(&self) -> bool {
        self.reflectivity > 0.0 || self.transparency > 0.0 || self.split != Split::Weights
    }

    /// The index of refraction for a wavelength in nanometres, or for light of all of them.
    #[must_use]
    pub fn index_at(&self, wavelength: Option<f64>) -> f64 {
        match (&self.dispersion, wavelength) {
            (Some(dispersion), Some(nanometres)) => dispersion.index(nanometres),
            _ => self.index_of_refraction,
        }
    }

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
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
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

/// Whether anything asks what a pixel sees of it.
pub(super) fn needs_beams(environment: Option<&SceneEnvironment>, materials: &[Material]) -> bool {
    environment.is_some_and(|environment| environment.averaged)
        || materials.iter().filter_map(|material| material.coat.as_ref()).any(|coat| coat.needs_footprints())
}

impl Scene {
    /// The same scene with other effects switched on. Those that nothing in it calls for stay without effect.
    #[must_use]
    pub fn with_effects(&self, effects: Effects) -> Self {
        Self { effects, origin: self.origin.by_effects(effects), ..self.clone() }
    }

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
    /// The lens, if it has one.
    pub lens: Option<Box<Lens>>,
    /// The picture.
    pub image: Image,
    /// How its pixels are sampled.
    pub sampling: Sampling,
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
    /// How hits are found.
    pub solving: Solving,
    /// The effects that it calls for; no other effect runs any code.
    pub effects: Effects,
    /// What happens where transparent objects overlap.
    pub media: MediaPolicy,
    /// Where a ray's tree ends.
    pub limits: Limits,
    /// The pixel that tells the scene's story best: where the workbench starts and what the snapshot pins.
    pub pixels: Vec<[u32; 2]>,
    /// What it was made from.
    pub origin: Origin,
}
