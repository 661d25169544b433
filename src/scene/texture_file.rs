//! What a surface carries, as scene files say it: the types that their JSON Schema is generated from.

use super::Colour;
use super::solid_file::Transform;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// An affine map by rows: u = a s + b t + c, and v likewise.
pub type MapFile = [[f64; 3]; 2];

/// How an image goes on beyond its edges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WrapFile {
    /// It begins again.
    #[default]
    Repeat,
    /// It begins again, mirrored.
    Mirror,
    /// Its last texels go on.
    Clamp,
}

/// How texels become one colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FilterFile {
    /// The texel that holds the point.
    Nearest,
    /// The four texels around the point.
    Bilinear,
    /// The four texels around the point, on two levels of the pyramid.
    Trilinear,
    /// Every texel, by the share of the pixel that it covers: exact.
    #[default]
    Area,
    /// An ellipse with soft edges: the elliptical weighted average.
    Ewa,
}

/// A kind of noise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NoiseFile {
    /// Each corner of the lattice has a slope: 0 at the corners themselves.
    #[default]
    Gradient,
    /// Each corner of the lattice has a value.
    Value,
}

/// A colour at a place between −1 and 1.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct StopFile {
    /// The place.
    #[schemars(range(min = -1.0, max = 1.0))]
    pub at: f64,
    /// The colour there.
    pub colour: Colour,
}

/// Noise of several sizes, added up: ½ Σ gainᵏ noise(2ᵏ p / size) for k from 0.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(default)]
#[schemars(deny_unknown_fields)]
pub struct TurbulenceFile {
    /// The size of the largest cells.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub size: f64,
    /// How many terms.
    #[schemars(range(min = 1, max = 16))]
    pub octaves: u32,
    /// How much weaker each term is than the one before.
    #[schemars(range(min = 0.0, max = 1.0))]
    pub gain: f64,
    /// Whether each term counts without its sign, which makes creases.
    pub absolute: bool,
    /// The kind of noise.
    pub noise: NoiseFile,
    /// Another seed is another noise.
    pub seed: u32,
}

impl Default for TurbulenceFile {
    fn default() -> Self {
        Self { size: 1.0, octaves: 6, gain: 0.5, absolute: false, noise: NoiseFile::Gradient, seed: 1 }
    }
}

/// Moves the point before the texture is looked up, by three turbulences.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(default)]
#[schemars(deny_unknown_fields)]
pub struct WarpFile {
    /// How far, along each axis.
    pub amount: f64,
    /// The turbulence.
    pub turbulence: TurbulenceFile,
}

impl Default for WarpFile {
    fn default() -> Self {
        Self { amount: 0.5, turbulence: TurbulenceFile::default() }
    }
}

macro_rules! texture_variants {
    ($($variant:ident $about:literal { $($(#[$attribute:meta])* $field:ident : $type:ty,)* })*) => {
        /// The colour of a surface, which its ambient and its diffuse colour are multiplied by.
        #[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
        #[serde(tag = "kind", rename_all = "snake_case")]
        #[schemars(deny_unknown_fields)]
        pub enum TextureFile {
            /// A picture that is pasted onto each part of the surface.
            Image {
                /// The picture: PNG, JPEG, Radiance HDR or `OpenEXR`, by its path from the scene's folder.
                file: String,
                /// How (u, v) of the surface follow from (s, t) of the picture, which fills the square from 0 to 1.
                #[serde(default = "identity")]
                uv_from_st: MapFile,
                /// The same for single parts of the surface, such as `top`.
                #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
                parts: BTreeMap<String, MapFile>,
                /// How it goes on beyond its edges.
                #[serde(default)]
                wrap: WrapFile,
                /// How texels become one colour.
                #[serde(default)]
                filter: FilterFile,
            },
            $(
                #[doc = $about]
                $variant {
                    $($(#[$attribute])* $field: $type,)*
                    /// The steps that take the texture from its own pose to its place in the object.
                    #[serde(default, skip_serializing_if = "Vec::is_empty")]
                    transform: Vec<Transform>,
                    /// Moves the point before the look-up.
                    #[serde(default, skip_serializing_if = "Option::is_none")]
                    #[schemars(with = "WarpFile")]
                    warp: Option<WarpFile>,
                    /// How fast its noise is stirred: turns of the slowest part in 1,000 frames.
                    #[serde(default)]
                    stir: f64,
                },
            )*
        }
    };
}

texture_variants! {
    Checker "Cubes of two colours in turn." {
        /// The two colours.
        #[serde(default = "black_and_white")]
        colours: [Colour; 2],
        /// The side of a cube.
        #[serde(default = "one")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        size: f64,
    }
    Gradient "Colours that change along an axis." {
        /// The axis, of any length.
        #[serde(default = "z_axis")]
        axis: [f64; 3],
        /// The way along it from the first stop to the last.
        #[serde(default = "one")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        length: f64,
        /// Whether it goes back and forth, or stays as it is beyond its ends.
        #[serde(default)]
        repeat: bool,
        /// The colours: −1 is the beginning of the way, 1 its end.
        #[serde(default = "dark_to_light")]
        #[schemars(length(min = 2))]
        stops: Vec<StopFile>,
    }
    Wood "The rings of a log: ⌊r⌋ mod 2." {
        /// The wood between the dark rings.
        #[serde(default = "light_wood")]
        light: Colour,
        /// The dark rings.
        #[serde(default = "dark_wood")]
        dark: Colour,
        /// The direction of the log's axis, of any length.
        #[serde(default = "z_axis")]
        axis: [f64; 3],
        /// The width of a ring.
        #[serde(default = "tenth")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        ring_width: f64,
        /// How much of a ring's width is a soft edge.
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 1.0))]
        soft_edge: f64,
        /// How far the rings are from round, in ring widths.
        #[serde(default)]
        wobble: f64,
        /// How many times a ring goes out and in on its way round.
        #[serde(default)]
        #[schemars(range(max = 64))]
        lobes: u32,
        /// How far the wobble turns on a unit's way along the axis, in degrees.
        #[serde(default)]
        twist: f64,
        /// Turbulence that moves the rings, by `amount` ring widths.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(with = "WarpFile")]
        uneven: Option<WarpFile>,
    }
    Noise "Noise of one size." {
        /// The size of a cell.
        #[serde(default = "one")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        size: f64,
        /// The kind of noise.
        #[serde(default)]
        noise: NoiseFile,
        /// Another seed is another noise.
        #[serde(default = "first_seed")]
        seed: u32,
        /// What is added to the noise's value …
        #[serde(default)]
        bias: f64,
        /// … after it was multiplied by this.
        #[serde(default = "one")]
        contrast: f64,
        /// The colours of what comes out.
        #[serde(default = "dark_to_light")]
        #[schemars(length(min = 2))]
        stops: Vec<StopFile>,
    }
    Turbulence "Noise of several sizes, added up." {
        /// The sum.
        #[serde(default)]
        turbulence: TurbulenceFile,
        /// What is added to its value …
        #[serde(default)]
        bias: f64,
        /// … after it was multiplied by this.
        #[serde(default = "one")]
        contrast: f64,
        /// The colours of what comes out.
        #[serde(default = "dark_to_light")]
        #[schemars(length(min = 2))]
        stops: Vec<StopFile>,
    }
    Marble "undulate(sin(z + A turb(p)))." {
        /// The direction across the veins, of any length.
        #[serde(default = "z_axis")]
        axis: [f64; 3],
        /// How far the sine's argument goes on a unit's way along the axis, in radians.
        #[serde(default = "marble_frequency")]
        frequency: f64,
        /// A: how far the turbulence pushes the veins, in radians.
        #[serde(default = "marble_amount")]
        amount: f64,
        /// What pushes the veins.
        #[serde(default)]
        turbulence: TurbulenceFile,
        /// The spline from dark to light.
        #[serde(default = "marble_stops")]
        #[schemars(length(min = 2))]
        stops: Vec<StopFile>,
    }
}

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

fn identity() -> MapFile {
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
}

fn black_and_white() -> [Colour; 2] {
    [Colour([0.05; 3]), Colour([0.9; 3])]
}

fn dark_to_light() -> Vec<StopFile> {
    vec![StopFile { at: -1.0, colour: Colour([0.0; 3]) }, StopFile { at: 1.0, colour: Colour([1.0; 3]) }]
}

fn marble_stops() -> Vec<StopFile> {
    let stop = |at, colour| StopFile { at, colour: Colour(colour) };
    vec![
        stop(-1.0, [0.06, 0.07, 0.11]),
        stop(-0.82, [0.3, 0.31, 0.36]),
        stop(-0.35, [0.78, 0.77, 0.75]),
        stop(1.0, [0.95, 0.94, 0.92]),
    ]
}

fn light_wood() -> Colour {
    Colour([0.6, 0.36, 0.16])
}

fn dark_wood() -> Colour {
    Colour([0.3, 0.14, 0.05])
}

fn z_axis() -> [f64; 3] {
    [0.0, 0.0, 1.0]
}

fn one() -> f64 {
    1.0
}

fn half() -> f64 {
    0.5
}

fn tenth() -> f64 {
    0.1
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

fn first_seed() -> u32 {
    1
}

fn marble_frequency() -> f64 {
    4.0
}

fn marble_amount() -> f64 {
    5.0
}

fn brushed_roughness() -> [f64; 2] {
    [0.4, 0.08]
}

fn woven_roughness() -> [f64; 2] {
    [0.3, 0.15]
}

fn grain_roughness() -> [f64; 2] {
    [0.3, 0.1]
}
