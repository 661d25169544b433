//! Lights, as scene files say them.

use super::file::Colour;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A light: a point, a direction, or one that has a size.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(untagged)]
#[schemars(deny_unknown_fields)]
pub enum LightFile {
    /// A point; its light does not fade with distance.
    Point {
        /// Its name; `light 1`, `light 2` … if left out.
        #[serde(default, skip_serializing_if = "String::is_empty")]
        name: String,
        /// Where it is.
        point: [f64; 3],
        /// Its colour.
        #[serde(default = "white")]
        colour: Colour,
    },
    /// A light infinitely far away.
    Directional {
        /// Its name; `light 1`, `light 2` … if left out.
        #[serde(default, skip_serializing_if = "String::is_empty")]
        name: String,
        /// The direction **towards** the light, of any length.
        directional: [f64; 3],
        /// Its colour.
        #[serde(default = "white")]
        colour: Colour,
    },
    /// A light that has a size: as many point lights, evenly spread, as there are samples. It is not seen itself.
    Area {
        /// Its name; `light 1`, `light 2` … if left out.
        #[serde(default, skip_serializing_if = "String::is_empty")]
        name: String,
        /// Its shape.
        area: AreaFile,
        /// How many of its points are asked at each hit, for each sample of the pixel.
        #[serde(default = "one_sample")]
        #[schemars(range(min = 1, max = 4096))]
        samples: u32,
        /// Its colour.
        #[serde(default = "white")]
        colour: Colour,
    },
}

/// The shape of a light.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
#[schemars(deny_unknown_fields)]
pub enum AreaFile {
    /// A disc.
    Disc {
        /// Its middle.
        centre: [f64; 3],
        /// The direction that it faces; both of its sides give light.
        normal: [f64; 3],
        /// Its radius.
        #[schemars(extend("exclusiveMinimum" = 0))]
        radius: f64,
    },
    /// A rectangle, or any parallelogram.
    Rectangle {
        /// One of its corners.
        corner: [f64; 3],
        /// The edges that start there.
        edges: [[f64; 3]; 2],
    },
    /// A sphere.
    Sphere {
        /// Its middle.
        centre: [f64; 3],
        /// Its radius.
        #[schemars(extend("exclusiveMinimum" = 0))]
        radius: f64,
    },
}

fn white() -> Colour {
    Colour([1.0; 3])
}

const fn one_sample() -> u32 {
    1
}
