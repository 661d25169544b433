//! What lies around the scene and on its faces, as scene files say it: the environment and details.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Light from infinitely far away, as a picture of it in all directions.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct EnvironmentFile {
    /// The picture: PNG, JPEG, Radiance HDR or `OpenEXR`, by its path from the scene's folder.
    pub file: String,
    /// How directions lie in it.
    #[serde(default)]
    pub layout: LayoutFile,
    /// How far it is turned about the z axis, in degrees.
    #[serde(default)]
    pub turn: f64,
    /// Whether it is averaged over what a pixel sees of it, or the nearest texel is taken.
    #[serde(default)]
    pub filter: EnvironmentFilterFile,
}

/// How directions lie in the picture of an environment.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LayoutFile {
    /// Longitude across and latitude down: the top row is straight up.
    #[default]
    LatitudeLongitude,
    /// The six faces of a cube, unfolded to a cross, 4 × 3 or 3 × 4.
    Cross,
}

/// How the environment is looked up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum EnvironmentFilterFile {
    /// The average over the solid angle that the pixel sees.
    #[default]
    Area,
    /// The nearest texel.
    Nearest,
}

/// A polygon that lies on a flat part of a primitive and takes precedence over it.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct DetailFile {
    /// The part that it lies on, such as `top`; the only one if left out.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub part: String,
    /// Its corners (u, v).
    #[schemars(length(min = 3))]
    pub polygon: Vec<[f64; 2]>,
    /// The name of its material.
    pub material: String,
    /// How often it repeats along u and v; its corners are then those in one cell, from 0 to 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "[u32; 2]", inner(range(min = 1)))]
    pub repeat: Option<[u32; 2]>,
    /// Polygons that lie on this one, in the same coordinates.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub details: Vec<Self>,
}
