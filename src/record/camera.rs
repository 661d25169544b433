//! What a pixel is sampled by: places in the picture, on the lens and on lights, as plain data.

use super::Triple;
use schemars::JsonSchema;
use serde::Serialize;

/// One sample of a pixel: the parent of everything that happens to its ray.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Sample {
    /// Its number, from 0.
    pub number: u32,
    /// Where it lies in the picture, in pixels from the top left corner.
    pub at: [f64; 2],
    /// How far that is from the pixel's centre, in pixels.
    pub offset: [f64; 2],
    /// Its weight in the pixel before all weights are made to add up to 1: 1, or −1 where a filter dips below zero.
    pub weight: f64,
}

/// The samples of a pixel, taken together.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Average {
    /// How many samples there are.
    pub samples: u32,
    /// The reconstruction filter, as scene files spell it.
    pub filter: String,
    /// The sum of their weights.
    pub weights: f64,
    /// The standard error of the result, in linear RGB units, as the samples themselves suggest it; none for one sample.
    pub error: Option<f64>,
    /// Why no more samples were taken.
    pub stopped: String,
    /// The weighted mean, linear RGB.
    pub colour: Triple,
}

/// A ray through a point of a thin lens.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Lens {
    /// `disc`, `polygon` or `image`.
    pub aperture: String,
    /// The outline of the aperture in units of its radius, across and upwards; empty for an image.
    pub outline: Vec<[f64; 2]>,
    /// The radius of the lens, in the world's units.
    pub radius: f64,
    /// How far the plane of focus is from the lens along the view.
    pub focus_distance: f64,
    /// The place on the lens in units of its radius, across and upwards.
    pub at: [f64; 2],
    /// The middle of the lens, in world space.
    pub eye: Triple,
    /// The unit vector along the view.
    pub forward: Triple,
    /// The point of the lens that the ray starts from.
    pub point: Triple,
    /// The point of the plane of focus that the pixel's rays meet in, wherever on the lens they start.
    pub focus: Triple,
}

/// How far a point out of focus is spread over the picture.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Confusion {
    /// How far the point is from the lens along the view: z.
    pub depth: f64,
    /// The diameter of its circle of confusion on the image plane at distance 1.
    pub diameter: f64,
    /// The same in pixels.
    pub pixels: f64,
}

/// A point of a light that has a size.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LightSample {
    /// `disc`, `rectangle` or `sphere`.
    pub shape: String,
    /// Its number, from 0.
    pub number: u32,
    /// How many points of the light are asked at this hit.
    pub of: u32,
    /// Where it lies in the unit square that the light's shape is unrolled to.
    pub at: [f64; 2],
    /// The point in world space.
    pub point: Triple,
    /// The unit vector towards it.
    pub towards: Triple,
    /// How far it is.
    pub distance: f64,
    /// What arrives from it, by colour, as a share of the whole light.
    pub arriving: Triple,
    /// Its part of the diffuse term.
    pub diffuse: Triple,
    /// Its part of the specular term.
    pub specular: Triple,
}
