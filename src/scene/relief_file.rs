//! What turns a surface's normal and its frame, as scene files say it.

use super::texture_file::{MapFile, TurbulenceFile, WrapFile, first_seed, identity, one, tenth, z_axis};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Turns the normal as if the surface were raised, without moving it.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
#[schemars(deny_unknown_fields)]
pub enum BumpFile {
    /// Raised by noise of several sizes.
    Noise {
        /// How high, in the world's units; less than 0 turns hills into hollows.
        height: f64,
        /// The noise.
        #[serde(default)]
        turbulence: TurbulenceFile,
        /// How fast it is stirred: turns of the slowest part in 1,000 frames.
        #[serde(default)]
        stir: f64,
    },
    /// Raised by ripples about an axis.
    Waves {
        /// How high, in the world's units.
        height: f64,
        /// From crest to crest.
        #[serde(default = "one")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        length: f64,
        /// A point of the axis.
        #[serde(default)]
        centre: [f64; 3],
        /// How fast they run outwards: wave lengths in 1,000 frames.
        #[serde(default)]
        speed: f64,
    },
    /// Small facets, each turned at random.
    Facets {
        /// The size of the cubes that hold one facet each.
        #[serde(default = "tenth")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        size: f64,
        /// The greatest tilt in degrees.
        #[schemars(range(min = 0.0, max = 80.0))]
        tilt: f64,
        /// Another seed is another pattern.
        #[serde(default = "first_seed")]
        seed: u32,
    },
    /// Raised by a picture: black is low and white is high.
    Image {
        /// How high white is, in the world's units.
        height: f64,
        /// The picture, by its path from the scene's folder.
        file: String,
        /// How (u, v) of the surface follow from (s, t) of the picture.
        #[serde(default = "identity")]
        uv_from_st: MapFile,
        /// The same for single parts of the surface.
        #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
        parts: BTreeMap<String, MapFile>,
        /// How it goes on beyond its edges.
        #[serde(default)]
        wrap: WrapFile,
    },
}

/// Turns the whole frame of the surface, with a grain along which highlights are drawn out.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
#[schemars(deny_unknown_fields)]
pub enum FrameFile {
    /// Metal brushed along u.
    Brushed {
        /// Roughness along the grain and across it.
        #[serde(default = "brushed_roughness")]
        #[schemars(inner(range(min = 0.01, max = 1.0)))]
        roughness: [f64; 2],
        /// How far the streaks turn the grain at most, in degrees.
        #[serde(default = "five")]
        waver: f64,
        /// How many streaks there are on the way across the surface.
        #[serde(default = "hundred")]
        streaks: f64,
        /// Another seed is another pattern.
        #[serde(default = "first_seed")]
        seed: u32,
    },
    /// Cloth of threads along u and v that pass over and under each other.
    Woven {
        /// Roughness along a thread and across it.
        #[serde(default = "woven_roughness")]
        #[schemars(inner(range(min = 0.01, max = 1.0)))]
        roughness: [f64; 2],
        /// Threads on the way along u and along v.
        #[serde(default = "threads")]
        threads: [f64; 2],
        /// How round a thread is: the slope at its edges.
        #[serde(default = "half")]
        #[schemars(range(min = 0.0, max = 4.0))]
        roundness: f64,
    },
    /// Streaks of wood along an axis.
    Grain {
        /// Roughness along the grain and across it.
        #[serde(default = "grain_roughness")]
        #[schemars(inner(range(min = 0.01, max = 1.0)))]
        roughness: [f64; 2],
        /// The direction of the grain, of any length.
        #[serde(default = "z_axis")]
        axis: [f64; 3],
        /// How far the streaks turn the grain at most, in degrees.
        #[serde(default = "five")]
        waver: f64,
        /// The size of the streaks.
        #[serde(default = "tenth")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        size: f64,
        /// Another seed is another pattern.
        #[serde(default = "first_seed")]
        seed: u32,
    },
}

fn half() -> f64 {
    0.5
}

fn five() -> f64 {
    5.0
}

fn hundred() -> f64 {
    100.0
}

fn threads() -> [f64; 2] {
    [40.0, 40.0]
}

fn brushed_roughness() -> [f64; 2] {
    [0.08, 0.4]
}

fn woven_roughness() -> [f64; 2] {
    [0.15, 0.3]
}

fn grain_roughness() -> [f64; 2] {
    [0.1, 0.3]
}
