//! The eye, its lens, and how pixels are sampled, as scene files say it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The eye and where it looks.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(default)]
#[schemars(deny_unknown_fields)]
pub struct CameraFile {
    /// Where the eye is: the middle of the lens, if there is one.
    pub eye: [f64; 3],
    /// The point in the middle of the picture; not the eye itself.
    pub look_at: [f64; 3],
    /// The direction that is up in the picture; not parallel to the view.
    pub up: [f64; 3],
    /// The vertical field of view in degrees, between 0 and 180.
    #[schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 180))]
    pub field_of_view: f64,
    /// A thin lens in place of a pinhole: what is not at its focus is blurred.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "LensFile")]
    pub lens: Option<LensFile>,
}

impl Default for CameraFile {
    fn default() -> Self {
        Self { eye: [4.0, -6.0, 3.0], look_at: [0.0; 3], up: [0.0, 0.0, 1.0], field_of_view: 35.0, lens: None }
    }
}

/// A thin lens.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LensFile {
    /// Its radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// How far along the view, from the eye, things are sharp.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub focus: f64,
    /// The shape of its opening, which spots of blur take on.
    #[serde(default)]
    pub aperture: ApertureFile,
}

/// The shape of a lens's opening.
#[derive(Clone, Debug, Default, Deserialize, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
#[schemars(deny_unknown_fields)]
pub enum ApertureFile {
    /// All of the lens.
    #[default]
    Disc,
    /// A regular polygon with its corners on the rim of the lens.
    Polygon {
        /// How many sides it has.
        #[schemars(range(min = 3, max = 64))]
        sides: u32,
        /// How far it is turned anticlockwise, as seen from behind the camera, from a corner on the right; in degrees.
        #[serde(default)]
        turn: f64,
    },
    /// A picture that fills the square around the lens: white lets light through, black does not.
    Image {
        /// The picture, by its path from the scene's folder.
        file: String,
    },
}

/// How pixels are sampled.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(default)]
#[schemars(deny_unknown_fields)]
pub struct SamplingFile {
    /// Rays through each pixel. If left out: 16 where the scene has a lens, a light with a size or a medium that scatters,
    /// and otherwise 1, through the pixel's centre.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "u32", range(min = 1, max = 65536))]
    pub samples: Option<u32>,
    /// How the samples of a pixel are weighted; it needs more than one.
    pub filter: PixelFilterFile,
    /// More samples where a pixel is not sure of its colour.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "AdaptiveFile")]
    pub adaptive: Option<AdaptiveFile>,
    /// Another seed is another pattern of samples.
    pub seed: u32,
    /// How many wavelengths a ray is split into where it first meets a dispersive surface.
    #[schemars(range(min = 1, max = 256))]
    pub wavelengths: u32,
}

impl Default for SamplingFile {
    fn default() -> Self {
        Self { samples: None, filter: PixelFilterFile::default(), adaptive: None, seed: 0, wavelengths: 16 }
    }
}

/// More samples where they are needed: their number is doubled until the pixel is sure enough.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct AdaptiveFile {
    /// The most that a pixel may get.
    #[schemars(range(min = 1, max = 65536))]
    pub most: u32,
    /// The standard error of its colour, in linear RGB, at which it is sure enough.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub error: f64,
}

/// How samples are weighted by their distance from the pixel's centre.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PixelFilterFile {
    /// All alike, over the pixel alone.
    #[default]
    Box,
    /// Less towards the centres of the neighbours, linearly.
    Tent,
    /// By a bell curve with a standard deviation of half a pixel, out to a pixel and a half.
    Gaussian,
    /// By the cubic of Mitchell and Netravali, out to two pixels: sharper, with weights below zero.
    Mitchell,
}
