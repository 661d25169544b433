//! Lights.

use super::Rgb;
use glam::DVec3;

/// Where light comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// A point; its light does not fade with distance.
    Point(DVec3),
    /// From infinitely far away; the unit vector **towards** the light.
    Directional(DVec3),
    /// From every point of a shape alike.
    Area(Area),
}

/// A light source.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Its name.
    pub name: String,
    /// Point, directional or with a size.
    pub kind: LightKind,
    /// How many points of it are asked at each hit; 1 where it has no size.
    pub samples: u32,
    /// Its colour, not limited to 1.
    pub colour: Rgb,
}

/// The shape of a light that has a size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Area {
    /// A disc: its middle, and two radii at right angles.
    Disc {
        /// Its middle.
        centre: DVec3,
        /// Two radii at right angles.
        radii: [DVec3; 2],
    },
    /// A parallelogram.
    Rectangle {
        /// One of its corners.
        corner: DVec3,
        /// The edges that start there.
        edges: [DVec3; 2],
    },
    /// A sphere.
    Sphere {
        /// Its middle.
        centre: DVec3,
        /// Its radius.
        radius: f64,
    },
}

impl Area {
    /// The word for it, as scene files spell it.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Disc { .. } => "disc",
            Self::Rectangle { .. } => "rectangle",
            Self::Sphere { .. } => "sphere",
        }
    }
}
