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
pub(super) fn identity() -> MapFile {
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

pub(super) fn z_axis() -> [f64; 3] {
    [0.0, 0.0, 1.0]
}

pub(super) fn one() -> f64 {
    1.0
}

pub(super) fn tenth() -> f64 {
    0.1
}

pub(super) fn first_seed() -> u32 {
    1
}

fn marble_frequency() -> f64 {
    4.0
}

fn marble_amount() -> f64 {
    5.0
}
