//! What can happen to a ray, one variant each.

use super::camera::{Average, Confusion, Lens, LightSample, Sample};
use super::medium::{Overlap, Passage, Phase, Scatter, Segment};
use super::spectrum::{Conductor, Wavelength};
use super::surface::{
    Bump, Detail, Environment, FrameMap, Lattice, Mapping, Octaves, Rings, Texels, Texture, Undulate,
};
use super::{Candidate, Certificate, Operator, PlaneRow, RayKind, Sense, SignSpan, Span, Tier, Triple};
use schemars::JsonSchema;
use serde::Serialize;

/// What happened. The order of the variants is the order in which a ray meets them.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum What {
    /// The whole story of one pixel; (0, 0) is the top left one.
    Pixel {
        /// Column.
        x: u32,
        /// Row.
        y: u32,
        /// Columns in the image.
        width: u32,
        /// Rows in the image.
        height: u32,
    },
    /// The whole story of a ray that was given instead of a pixel.
    LooseRay {
        /// Where it starts, in world space.
        origin: Triple,
        /// Where it goes, in world space; the length is kept.
        direction: Triple,
    },
    /// One sample of a pixel that takes several.
    Sample(Sample),
    /// One of the six steps of § 6.1.
    Step {
        /// 1 to 6.
        number: u8,
        /// The step in words.
        title: String,
    },
    /// A ray that starts at a point of a lens.
    Lens(Lens),
    /// A ray P(t) = origin + direction t in world space.
    Ray {
        /// Why it was sent.
        ray: RayKind,
        /// Where it starts.
        origin: Triple,
        /// Where it goes; not normalised for the camera ray.
        direction: Triple,
        /// How many rays it is away from the camera ray.
        depth: u32,
        /// The medium that it travels in.
        medium: String,
        /// The share of its colour in the pixel, at most 1.
        weight: f64,
        /// The one wavelength that it has, in nanometres; none where it has all of them.
        #[serde(skip_serializing_if = "Option::is_none")]
        wavelength: Option<f64>,
        /// The surface that it left, whose own hit at t = 0 is not counted.
        left: Option<String>,
    },
    /// The search for hits with one object.
    Object {
        /// Its place in the object list.
        index: usize,
        /// Its name.
        name: String,
        /// How many inside intervals the ray has in it.
        intervals: usize,
    },
    /// A test against a box that holds the solid.
    Extent {
        /// The solid's name.
        of: String,
        /// The corner with the smallest coordinates, in world space; `null` where unbounded.
        low: Triple,
        /// The corner with the largest coordinates, in world space; `null` where unbounded.
        high: Triple,
        /// The times between which the ray is in the box; none if it misses.
        inside: Option<[f64; 2]>,
    },
    /// A test against a ball that holds the solid, where that is much smaller than its box.
    Ball {
        /// The solid's name.
        of: String,
        /// Its middle, in world space.
        centre: Triple,
        /// Its radius.
        radius: f64,
        /// How far from the middle the ray's line passes.
        distance: f64,
        /// Whether it passes through.
        is_met: bool,
    },
    /// A test of a ray from the eye against the rectangle of the picture that holds an object.
    Projection {
        /// The object's name.
        of: String,
        /// The left and the top edge, in pixels from the top left corner of the picture.
        low: [f64; 2],
        /// The right and the bottom edge, likewise.
        high: [f64; 2],
        /// Where the ray passes the picture, likewise.
        at: [f64; 2],
        /// Whether the ray passes through the rectangle.
        holds: bool,
    },
    /// The ray in a primitive's generic coordinates: S + c t, with the same t as in world space.
    Transform {
        /// The primitive's name.
        of: String,
        /// The inverse of the object's matrix, world to generic, three rows of four.
        inverse: [[f64; 4]; 3],
        /// S.
        origin: Triple,
        /// c, not normalised.
        direction: Triple,
    },
    /// A primitive's own hits, before any CSG.
    Primitive {
        /// The shape, as scene files spell it.
        shape: String,
        /// The primitive's name.
        name: String,
        /// Its place among the leaves of its object.
        leaf: usize,
        /// How many hits were found, on the whole line.
        hits: usize,
    },
    /// The plane table of a cube or convex polyhedron, or of a slab of another shape.
    Planes {
        /// The rows, as far as they were worked out.
        rows: Vec<PlaneRow>,
        /// Why the table was left before its last row, if it was.
        stopped: Option<String>,
    },
    /// A quadratic A t² + 2 B t + C = 0 in t measured from `recentred_at`.
    Quadratic {
        /// What it says.
        about: String,
        /// A.
        a: f64,
        /// B, half the linear coefficient.
        b: f64,
        /// C.
        c: f64,
        /// B² − A C.
        discriminant: f64,
        /// The hit time about which the equation is written.
        recentred_at: f64,
        /// The real roots as hit times, ascending.
        roots: Vec<f64>,
    },
    /// A quartic in t measured from `recentred_at`.
    Quartic {
        /// From the constant term up to the fourth power.
        coefficients: [f64; 5],
        /// The hit time about which the equation is written.
        recentred_at: f64,
        /// The real roots as hit times, ascending.
        roots: Vec<f64>,
    },
    /// A search for all zeros of d(t) by bounds on stretches of the ray.
    Search {
        /// Where it began and ended.
        range: Option<[f64; 2]>,
        /// Stretches on which d(t) was bounded.
        stretches: usize,
        /// Stretches that could not be decided down to the last bit.
        undecided: usize,
        /// The zeros found, ascending.
        roots: Vec<f64>,
    },
    /// How a solver came to be sure: its closest decision, and the arithmetic that it took.
    Decision {
        /// The question whose answer was closest to the other one.
        question: String,
        /// The attempts, the fastest arithmetic first.
        tiers: Vec<Tier>,
        /// How far the deciding number moves when the ray's own numbers move by half a unit in their last places.
        input_doubt: f64,
        /// The hit time near which it hangs; none where it is about the whole ray.
        near: Option<f64>,
        /// How surely the answer is known.
        certificate: Certificate,
    },
    /// d(t) = F(S + c t): positive outside, zero on the surface, negative inside.
    Implicit {
        /// F(x, y, z) in words.
        equation: String,
        /// Pairs (t, d), ascending in t.
        samples: Vec<[f64; 2]>,
        /// Where d is zero and changes its sign.
        roots: Vec<f64>,
        /// Where d is positive and where it is negative.
        signs: Vec<SignSpan>,
    },
    /// Every hit time of a primitive that was looked at, with its fate and the reason. The last event below the
    /// primitive's own.
    Roots {
        /// The hit times, ascending.
        candidates: Vec<Candidate>,
    },
    /// A node of a CSG tree: left list, right list, combined list.
    Combine {
        /// The node's name.
        name: String,
        /// The operator.
        operator: Operator,
        /// The left solid's inside intervals.
        left: Vec<Span>,
        /// The right solid's inside intervals; none if it was never asked.
        right: Option<Vec<Span>>,
        /// The result's inside intervals.
        combined: Vec<Span>,
        /// Why the work ended early, if it did.
        early_out: Option<String>,
    },
    /// A spawned ray that rounding had set down on the wrong side of the surface that it left: the object was asked again
    /// from a start beside it.
    Moved {
        /// The object.
        object: String,
        /// How far the start was moved along the normal.
        by: f64,
    },
    /// A hit that is not the one that is seen.
    Rejected {
        /// The object.
        object: String,
        /// The primitive within it.
        leaf: String,
        /// The part of its surface.
        part: String,
        /// The hit time.
        t: f64,
        /// Why not.
        reason: String,
    },
    /// The closest hit in front.
    Hit {
        /// The object.
        object: String,
        /// The primitive within it.
        leaf: String,
        /// The shape of the primitive, as scene files spell it.
        shape: String,
        /// The part of its surface.
        part: String,
        /// The material.
        material: String,
        /// The hit time.
        t: f64,
        /// The bound on the error of the hit time.
        t_error: f64,
        /// How surely it is known that there is a hit.
        certificate: Certificate,
        /// What the boundary does to the ray.
        sense: Sense,
        /// The point in world space.
        point: Triple,
        /// The point in the primitive's generic coordinates.
        generic_point: Triple,
        /// The outward unit normal of the solid, in world space.
        n_geometric: Triple,
        /// The unit normal that shading uses, on the side that the ray came from.
        n_shading: Triple,
        /// Surface coordinates (u, v), each from 0 to 1.
        uv: [f64; 2],
    },
    /// No hit in front: the ray sees the background.
    Nothing {
        /// The background's colour.
        background: Triple,
    },
    /// How far the hit is out of focus.
    Confusion(Confusion),
    /// A polygon on a face takes precedence over the face.
    Detail(Detail),
    /// The colour of a textured surface.
    Texture(Texture),
    /// From the surface to a place in an image.
    Mapping(Mapping),
    /// The texels that are averaged.
    Texels(Texels),
    /// Noise from the corners of a lattice cell.
    Lattice(Lattice),
    /// Turbulence: noise of several sizes added up.
    Octaves(Octaves),
    /// A colour from a spline.
    Undulate(Undulate),
    /// The ring of a log.
    Rings(Rings),
    /// A normal that is perturbed.
    Bump(Bump),
    /// A frame that is perturbed.
    FrameMap(FrameMap),
    /// A look-up in the environment.
    Environment(Environment),
    /// A stretch inside a medium.
    Segment(Segment),
    /// A point at which light is turned.
    Scatter(Scatter),
    /// By how much light is turned there.
    Phase(Phase),
    /// What comes out of a stretch of a medium.
    Passage(Passage),
    /// The ambient term.
    Ambient {
        /// Its colour.
        colour: Triple,
    },
    /// One light's diffuse and specular terms.
    Light {
        /// The light's name.
        name: String,
        /// The unit vector towards it.
        towards: Triple,
        /// How far it is; none for a directional light.
        distance: Option<f64>,
        /// The share of its light that arrives, by colour.
        arriving: Triple,
        /// The diffuse term.
        diffuse: Triple,
        /// The specular term.
        specular: Triple,
    },
    /// A point of a light that has a size.
    LightSample(LightSample),
    /// Something between a hit and a light.
    Shadow {
        /// The object in the way.
        object: String,
        /// The hit time along the shadow ray.
        t: f64,
        /// The share of light that it lets through.
        passes: f64,
        /// The rule that was applied.
        reason: String,
    },
    /// The mirrored direction r = dir − 2 (dir · m) m.
    Reflection {
        /// The direction, of the length of `dir`.
        direction: Triple,
        /// The share of the reflected colour; the largest of three where they differ.
        share: f64,
        /// The shares of red, green and blue, where they differ.
        #[serde(skip_serializing_if = "Option::is_none")]
        shares: Option<Triple>,
    },
    /// Snell's law at an interface.
    Snell {
        /// Index of refraction on the incoming side.
        n1: f64,
        /// Index of refraction on the far side.
        n2: f64,
        /// Angle of incidence in degrees.
        theta1: f64,
        /// Angle of refraction in degrees; none for total internal reflection.
        theta2: Option<f64>,
        /// The critical angle in degrees; none where n1 < n2.
        critical: Option<f64>,
        /// Whether all light is reflected.
        total_internal_reflection: bool,
        /// The refracted unit direction; none for total internal reflection.
        refracted: Option<Triple>,
        /// Unpolarised Fresnel reflectance.
        reflectance: f64,
    },
    /// A ray takes one wavelength.
    Wavelength(Wavelength),
    /// The reflectance of a metal.
    Conductor(Conductor),
    /// Two transparent objects fill the same space, which policy 1 forbids.
    Overlap(Overlap),
    /// The media on both sides of a boundary.
    Medium {
        /// The object whose boundary it is.
        object: String,
        /// The medium before.
        before: String,
        /// The medium after.
        after: String,
        /// The policy that decided, and how.
        decided: String,
        /// Two transparent objects overlap here, which policy 1 forbids.
        interpenetration: bool,
        /// The boundary lies inside a medium that wins over it, so that the ray passes as if it were not there.
        hidden: bool,
    },
    /// Something that was stopped or left out.
    Limit {
        /// Which limit: `depth`, `contribution`, `rays`, `turns`, `recording size`.
        limit: String,
        /// Its value.
        at: f64,
        /// The number that met it.
        value: f64,
        /// What is therefore missing, or stands for what is.
        consequence: String,
    },
    /// The colour that a ray brings back, as the sum of its five components.
    Colour {
        /// Ambient.
        ambient: Triple,
        /// Diffuse, all lights.
        diffuse: Triple,
        /// Specular, all lights.
        specular: Triple,
        /// Reflected, weighted.
        reflected: Triple,
        /// Transmitted, weighted.
        transmitted: Triple,
        /// The sum.
        total: Triple,
    },
    /// The samples of a pixel, taken together.
    Average(Average),
    /// The pixel as it is written.
    Written {
        /// Linear RGB before clamping.
        linear: Triple,
        /// sRGB as stored in the picture.
        srgb: [u8; 3],
    },
}
