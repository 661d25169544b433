//! The scene file: the Rust types that its JSON Schema is generated from.
//!
//! Every field has a default, so that `{}` is a scene (an empty one). What the schema can say is checked by
//! [`check`](super::check) before anything is read; the readers here are [`Lenient`], so that one bad field does not keep
//! the others from being looked at.

use super::SolidFile;
use super::around_file::EnvironmentFile;
use super::camera_file::{CameraFile, SamplingFile};
use super::glass_file::{DispersionFile, FresnelFile, MediumFile};
use super::lenient::Lenient;
use super::light_file::LightFile;
use super::relief_file::{BumpFile, FrameFile};
use super::texture_file::TextureFile;
use schemars::{JsonSchema, Schema};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// The greatest number of pixels of an image. More would need over 1.5 GB while it is computed; fewer would refuse posters.
pub const MOST_PIXELS: u64 = 64_000_000;

/// A scene: camera, lights, materials and objects. Distances have no unit; colours are linear RGB.
#[derive(Clone, Debug, Default, Deserialize, Serialize, JsonSchema)]
#[serde(default)]
#[schemars(deny_unknown_fields, title = "rayscope scene")]
pub struct SceneFile {
    /// Where the schema of this file is, for editors. Not used otherwise.
    #[serde(rename = "$schema")]
    pub schema: Lenient<String>,
    /// One line.
    pub title: Lenient<String>,
    /// A paragraph for the student: what to click and what to look for.
    pub about: Lenient<String>,
    /// The sections of the syllabus that the scene shows, such as "6.5.1".
    pub sections: Lenient<Vec<Lenient<String>>>,
    /// The eye.
    pub camera: Lenient<CameraFile>,
    /// The picture's size.
    pub image: Lenient<ImageFile>,
    /// How pixels are sampled.
    pub sampling: Lenient<SamplingFile>,
    /// Ambient light: every surface sends back this times its ambient colour.
    pub ambient: Lenient<Ambient>,
    /// What a ray sees that hits nothing.
    pub background: Lenient<Background>,
    /// A picture of the light from all directions, which a ray sees that hits nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "EnvironmentFile")]
    pub environment: Option<Lenient<EnvironmentFile>>,
    /// The frame of an animation: the time for everything that moves.
    pub frame: Lenient<f64>,
    /// The lights.
    pub lights: Lenient<Vec<Lenient<LightFile>>>,
    /// The materials by name.
    pub materials: Lenient<BTreeMap<String, Lenient<MaterialFile>>>,
    /// Solids by name, for objects and parts to be copies of: `{"shape": "copy", "solid": NAME}`.
    #[schemars(with = "BTreeMap<String, SolidFile>")]
    pub solids: Lenient<Map<String, Value>>,
    /// The objects: solids with a name and a material.
    #[schemars(with = "Vec<SolidFile>")]
    pub objects: Lenient<Vec<Value>>,
    /// What happens where transparent objects overlap.
    pub media: Lenient<MediaFile>,
    /// Where a ray's tree ends.
    pub limits: Lenient<LimitsFile>,
    /// The pixels [column, row] that tell the scene's story best; (0, 0) is the top left one.
    pub pixels: Lenient<Vec<Lenient<[u32; 2]>>>,
}

/// A colour in linear RGB: 0 is none, 1 is full.
#[derive(Clone, Copy, Debug, Default, Deserialize, Serialize, JsonSchema)]
pub struct Colour(#[schemars(inner(range(min = 0.0)))] pub [f64; 3]);

/// Ambient light.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, JsonSchema)]
#[schemars(inline)]
pub struct Ambient(pub Colour);

impl Default for Ambient {
    fn default() -> Self {
        Self(Colour([1.0; 3]))
    }
}

/// The background's colour.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, JsonSchema)]
#[schemars(inline)]
pub struct Background(pub Colour);

impl Default for Background {
    fn default() -> Self {
        Self(Colour([0.30, 0.40, 0.52]))
    }
}

/// The picture's size in pixels, 64,000,000 at most.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(default)]
#[schemars(deny_unknown_fields)]
pub struct ImageFile {
    /// Columns.
    #[schemars(range(min = 1))]
    pub width: u32,
    /// Rows.
    #[schemars(range(min = 1))]
    pub height: u32,
}

impl Default for ImageFile {
    fn default() -> Self {
        Self { width: 640, height: 480 }
    }
}

/// How a surface answers light.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(default)]
#[schemars(deny_unknown_fields)]
pub struct MaterialFile {
    /// The colour that it sends back of ambient light.
    pub ambient: Colour,
    /// The colour that it scatters into all directions.
    pub diffuse: Colour,
    /// The colour of its highlights.
    pub specular: Colour,
    /// The exponent of its highlights: the higher, the smaller and sharper they are.
    #[schemars(range(min = 0.0))]
    pub exponent: f64,
    /// The weight of the mirrored ray.
    #[schemars(range(min = 0.0, max = 1.0))]
    pub reflectivity: f64,
    /// The weight of the ray that goes through.
    #[schemars(range(min = 0.0, max = 1.0))]
    pub transparency: f64,
    /// The index of refraction relative to vacuum: glass 1.5, water 1.33. More than 0.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub index_of_refraction: f64,
    /// A colour that changes from place to place, which the ambient and the diffuse colour are multiplied by.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "TextureFile")]
    pub texture: Option<TextureFile>,
    /// Turns its normal as if it were raised.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "BumpFile")]
    pub bump: Option<BumpFile>,
    /// Turns its frame, with a grain that draws out its highlights.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "FrameFile")]
    pub frame: Option<FrameFile>,
    /// Fresnel's equations decide how much is mirrored and how much goes through, in place of `reflectivity`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "FresnelFile")]
    pub fresnel: Option<FresnelFile>,
    /// An index of refraction that depends on the wavelength, in place of `index_of_refraction`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "DispersionFile")]
    pub dispersion: Option<DispersionFile>,
    /// What fills an object of this material, where it takes light away; the material has to be transparent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "MediumFile")]
    pub medium: Option<MediumFile>,
    /// Whether mirrored and refracted directions are followed, or only looked up in the environment.
    pub mirrors: MirrorsFile,
}

/// What mirrored and refracted directions show.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MirrorsFile {
    /// The scene: a ray is sent.
    #[default]
    Scene,
    /// The environment alone, as if nothing else were there: no ray is sent.
    Environment,
}

impl Default for MaterialFile {
    fn default() -> Self {
        Self {
            ambient: Colour([0.1; 3]),
            diffuse: Colour([0.6; 3]),
            specular: Colour([0.0; 3]),
            exponent: 32.0,
            reflectivity: 0.0,
            transparency: 0.0,
            index_of_refraction: 1.0,
            texture: None,
            bump: None,
            frame: None,
            fresnel: None,
            dispersion: None,
            medium: None,
            mirrors: MirrorsFile::Scene,
        }
    }
}

/// What happens where transparent objects overlap (§ 6.4.1).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MediaFile {
    /// They may not. Where they do, it is reported, and the most recently entered object wins.
    #[default]
    Forbid,
    /// The most recently entered object wins.
    MostRecent,
    /// The object with the highest priority wins; among equals the most recently entered.
    Priority,
}

/// Where a ray's tree ends.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(default)]
#[schemars(deny_unknown_fields)]
pub struct LimitsFile {
    /// How many rays away from the camera ray a ray may be.
    // Light that glass has caught seldom goes round more often. A path of this length takes a tenth of a second and 70 MB.
    #[schemars(range(max = 100_000))]
    pub depth: u32,
    /// Rays whose colour would count less than this in the pixel are not followed.
    #[schemars(range(min = 0.0, max = 1.0))]
    pub contribution: f64,
}

impl Default for LimitsFile {
    fn default() -> Self {
        Self { depth: 8, contribution: 0.002 }
    }
}

/// The JSON Schema of scene files.
#[cfg(not(target_arch = "wasm32"))]
#[must_use]
pub fn scene_schema() -> Schema {
    schemars::schema_for!(SceneFile)
}

/// The JSON Schema of scene files, as the program has written it elsewhere: what makes it need not be sent to browsers.
#[cfg(target_arch = "wasm32")]
#[must_use]
pub fn scene_schema() -> Schema {
    written_schema(include_str!("../../scenes/scene.schema.json"))
}

/// A schema from its text. A test holds these texts to what they were made from.
#[cfg(target_arch = "wasm32")]
pub(super) fn written_schema(text: &str) -> Schema {
    serde_json::from_str(text).unwrap_or_default()
}
