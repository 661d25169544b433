//! What a surface carries: look-ups in images and environments, solid textures, bumps, frames and details, as plain data.

use super::Triple;
use schemars::JsonSchema;
use serde::Serialize;

/// The look-up of a surface's colour: the parent of the events that show how it came about.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Texture {
    /// The kind of texture, as scene files spell it.
    pub texture: String,
    /// The point in the texture's own space, which moves with the object; for an image (u, v, 0).
    pub point: Triple,
    /// What came out, linear RGB.
    pub colour: Triple,
}

/// From a point of a surface to a place in an image: (u, v) is known, and (s, t) = M_T⁻¹ (u, v).
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Mapping {
    /// The part of the surface.
    pub part: String,
    /// (u, v) of the hit.
    pub uv: [f64; 2],
    /// M_T: u = a_u s + b_u t + c_u, and v likewise.
    pub uv_from_st: [[f64; 3]; 2],
    /// M_T⁻¹.
    pub st_from_uv: [[f64; 3]; 2],
    /// (s, t): the image fills the square from 0 to 1, with t upwards.
    pub st: [f64; 2],
    /// The size of the image in texels.
    pub size: [u32; 2],
    /// The pixel's four corners, in texels from the top left corner of the image, in their order about the pixel; empty
    /// where the filter needs no footprint.
    pub footprint: Vec<[f64; 2]>,
    /// How many corner rays miss the part of the surface that was hit, and were taken to the plane that touches it there.
    pub off_the_surface: usize,
}

/// A texel and its share.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TexelShare {
    /// Column and row before wrapping: texel (0, 0) fills the square from (0, 0) to (1, 1) at the top left.
    pub at: [i64; 2],
    /// Its share of the result.
    pub weight: f64,
    /// Its colour, linear RGB.
    pub colour: Triple,
}

/// The texels that a look-up averages.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Texels {
    /// The filter, as scene files spell it.
    pub filter: String,
    /// The level of the pyramid: 0 is the image itself, each further one has half as many columns and rows.
    pub level: f64,
    /// Texels with the largest shares, the largest first; of a level's own grid.
    pub texels: Vec<TexelShare>,
    /// How many more there are.
    pub left_out: usize,
    /// The weighted sum.
    pub colour: Triple,
}

/// A corner of a lattice cell.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LatticeCorner {
    /// Where it is.
    pub at: [i64; 3],
    /// Its gradient; zero for value noise.
    pub gradient: Triple,
    /// What it says of the point: gradient · (p − corner), or its own value.
    pub value: f64,
    /// Its share: the product of three fades.
    pub weight: f64,
}

/// Noise at a point, from the eight corners of the lattice cell around it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Lattice {
    /// `gradient` or `value`.
    pub method: String,
    /// The point on the lattice.
    pub point: Triple,
    /// The point from the lowest corner of its cell, 0 to 1 in each coordinate.
    pub offset: Triple,
    /// The fade 6 x⁵ − 15 x⁴ + 10 x³ of each.
    pub fade: Triple,
    /// The corners, x fastest.
    pub corners: Vec<LatticeCorner>,
    /// The sum of values times weights.
    pub noise: f64,
}

/// One term of a turbulence.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Octave {
    /// Its number k from 0.
    pub k: u32,
    /// How many times the point is scaled: 2ᵏ s.
    pub frequency: f64,
    /// ½ gainᵏ.
    pub weight: f64,
    /// The noise there.
    pub noise: f64,
    /// weight · noise.
    pub term: f64,
}

/// The sum of a turbulence, term by term.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Octaves {
    /// The terms.
    pub rows: Vec<Octave>,
    /// Their sum.
    pub sum: f64,
}

/// A colour at a place of a spline.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Stop {
    /// The place, from −1 to 1.
    pub at: f64,
    /// The colour, linear RGB.
    pub colour: Triple,
}

/// A colour from a spline over [−1, 1].
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Undulate {
    /// Where it is asked for, brought into [−1, 1].
    pub argument: f64,
    /// The stops that the spline goes through.
    pub stops: Vec<Stop>,
    /// The segment that the argument lies in: from this stop to the next.
    pub segment: usize,
    /// The spline at equal steps from −1 to 1, for drawing.
    pub curve: Vec<Stop>,
    /// The colour.
    pub colour: Triple,
}

/// The ring of a log that a point lies in.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Rings {
    /// The distance from the log's axis.
    pub radius: f64,
    /// The radius after wobble, twist and noise, in rings.
    pub stirred: f64,
    /// ⌊stirred⌋.
    pub ring: f64,
    /// ⌊stirred⌋ mod 2: 0 is light, 1 is dark.
    pub dark: bool,
}

/// A perturbed normal (§ 6.3.2): N' = N + b_v (P_u × n) + b_u (n × P_v).
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Bump {
    /// The kind of bump, as scene files spell it.
    pub bump: String,
    /// ∂P/∂u in world space.
    pub p_u: Triple,
    /// ∂P/∂v in world space.
    pub p_v: Triple,
    /// b: how high the surface is raised, in the world's units.
    pub height: f64,
    /// ∂b/∂u and ∂b/∂v.
    pub slopes: [f64; 2],
    /// P_u × n.
    pub p_u_cross_n: Triple,
    /// n × P_v.
    pub n_cross_p_v: Triple,
    /// How far the terms that were dropped (b n_u and b n_v) would turn the normal further, in degrees; none where the
    /// surface does not say how its normal turns.
    pub dropped: Option<f64>,
    /// The unit normal before.
    pub before: Triple,
    /// The unit normal after.
    pub after: Triple,
}

/// A perturbed frame (§ 6.3.3): tangent T along the grain, B = T × N or N × T, and the normal N, all unit.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FrameMap {
    /// The kind of grain, as scene files spell it.
    pub frame: String,
    /// How far the grain is turned about the normal, in degrees.
    pub turn: f64,
    /// How far the normal is tilted along the grain and across it, as slopes.
    pub tilt: [f64; 2],
    /// T, B, N before.
    pub before: [Triple; 3],
    /// T, B, N after.
    pub after: [Triple; 3],
    /// Roughness along the grain and across it.
    pub roughness: [f64; 2],
}

/// A look-up in the environment.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Environment {
    /// `latitude_longitude` or `cross`.
    pub layout: String,
    /// The direction that is looked up, in world space.
    pub direction: Triple,
    /// Where it lies in the image, in texels from the top left corner.
    pub at: [f64; 2],
    /// The size of the image in texels.
    pub size: [u32; 2],
    /// The footprint's outline in texels from the top left corner; empty where only the nearest texel is asked for.
    pub footprint: Vec<[f64; 2]>,
    /// The solid angle of the footprint in steradians.
    pub solid_angle: f64,
    /// The nearest texel alone.
    pub nearest: Triple,
    /// What came out: the average over the footprint's solid angle, or the nearest texel.
    pub colour: Triple,
}

/// A polygon that lies on a face and takes precedence over it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Detail {
    /// The part of the surface.
    pub part: String,
    /// (u, v) of the hit, in the polygon's own cell where the pattern repeats.
    pub uv: [f64; 2],
    /// The polygon.
    pub polygon: Vec<[f64; 2]>,
    /// The material below it.
    pub below: String,
    /// Its own material.
    pub material: String,
}
