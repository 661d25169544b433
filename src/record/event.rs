//! The events of a traced pixel, in the order in which they happen.

use super::{Value, Working};
use schemars::JsonSchema;
use serde::Serialize;

/// A point, direction or linear RGB colour.
pub type Triple = [f64; 3];

/// An event's place in the order of events.
pub type EventId = u32;

/// Where in the source a number was computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Source {
    /// Path from the root of the repository.
    pub file: &'static str,
    /// Line, counted from 1.
    pub line: u32,
}

/// One thing that happened, with its place in the tree.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Event {
    /// Its number: events are numbered in the order in which they began.
    pub id: EventId,
    /// The event that it is a part of; none for the root.
    pub parent: Option<EventId>,
    /// What happened.
    #[serde(flatten)]
    pub what: What,
    /// The working behind the numbers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub working: Vec<Working>,
    /// Where it was computed.
    pub source: Source,
}

/// The description of an event, before it has a place in a tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// What happened.
    pub what: What,
    /// The working behind the numbers.
    pub working: Vec<Working>,
    /// Where it was computed.
    pub source: Source,
}

impl Entry {
    /// Describes an event; the caller's place in the source is kept with it.
    #[must_use]
    #[track_caller]
    pub fn new(what: What) -> Self {
        let place = std::panic::Location::caller();
        Self { what, working: Vec::new(), source: Source { file: place.file(), line: place.line() } }
    }

    /// Adds a line of working: `symbol = formula`, with `bindings` put in, `= result`.
    #[must_use]
    pub fn line(mut self, symbol: &str, formula: &str, bindings: &[(&str, Value)], result: impl Into<Value>) -> Self {
        self.working.push(Working::new(symbol, formula, bindings, result.into()));
        self
    }
}

/// Why a ray was sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RayKind {
    /// From the eye through a pixel's centre.
    Camera,
    /// From a hit, mirrored about the normal.
    Reflected,
    /// From a hit, through the surface.
    Refracted,
    /// From a hit towards a light.
    Shadow,
}

impl RayKind {
    /// All kinds, in the order in which they are listed everywhere.
    pub const ALL: [Self; 4] = [Self::Camera, Self::Reflected, Self::Refracted, Self::Shadow];

    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Camera => "camera",
            Self::Reflected => "reflected",
            Self::Refracted => "refracted",
            Self::Shadow => "shadow",
        }
    }
}

/// What a boundary does to a ray that crosses it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Sense {
    /// The ray goes into the solid.
    Enter,
    /// The ray comes out of the solid.
    Leave,
    /// The ray meets a surface that bounds nothing (a square).
    Touch,
}

/// Whether a candidate hit time is on the primitive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CandidateFate {
    /// It is.
    Accepted,
    /// It is not; the reason stands beside it.
    Rejected,
}

/// A hit time that a solver came up with.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Candidate {
    /// The hit time, shared by world and generic coordinates.
    pub t: f64,
    /// The part of the surface that it would lie on.
    pub part: String,
    /// What it would do to the ray.
    pub sense: Sense,
    /// The point in generic coordinates.
    pub point: Triple,
    /// Whether it counts.
    pub fate: CandidateFate,
    /// Why it counts, or why not.
    pub reason: String,
}

/// How a ray stands to a plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PlaneSense {
    /// The ray goes from the outside to the inside: the denominator is negative, for the normal points outward.
    Entering,
    /// The ray goes from the inside to the outside: the denominator is positive.
    Leaving,
    /// The ray runs beside the plane, on its inside.
    ParallelInside,
    /// The ray runs beside the plane, on its outside: it misses the solid.
    ParallelOutside,
}

/// A row of the plane table of § 6.2.3, filled in for one ray.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PlaneRow {
    /// The plane's number.
    pub plane: usize,
    /// The plane's name (`top`, `plane 7`).
    pub name: String,
    /// The outward normal m.
    pub normal: Triple,
    /// A point on the plane.
    pub spot: Triple,
    /// m · (spot − S).
    pub numerator: f64,
    /// m · c.
    pub denominator: f64,
    /// numerator / denominator, unless parallel.
    pub t: Option<f64>,
    /// Entering, leaving or parallel.
    pub sense: PlaneSense,
    /// The latest entering time so far; none before the first.
    pub t_in: Option<f64>,
    /// The earliest leaving time so far; none before the first.
    pub t_out: Option<f64>,
}

/// The sign of d(t).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Sign {
    /// Outside.
    Positive,
    /// Inside.
    Negative,
}

/// A stretch of the ray on which d(t) keeps its sign. `null` ends are unbounded.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SignSpan {
    /// Where it begins.
    pub from: Option<f64>,
    /// Where it ends.
    pub to: Option<f64>,
    /// The sign between.
    pub sign: Sign,
}

/// One end of an inside interval: which surface it lies on.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Edge {
    /// The hit time.
    pub t: f64,
    /// The leaf of the CSG tree, counted from 0, left to right.
    pub leaf: usize,
    /// The leaf's name.
    pub name: String,
    /// The part of the leaf's surface.
    pub part: String,
    /// Whether the leaf is subtracted, so that its normal is turned round.
    pub flipped: bool,
}

/// An inside interval along the ray. A missing end is unbounded.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Span {
    /// Where the ray goes in.
    pub enter: Option<Edge>,
    /// Where the ray comes out.
    pub leave: Option<Edge>,
}

/// A Boolean operator on solids.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Operator {
    /// In either.
    Union,
    /// In both.
    Intersection,
    /// In the left and not in the right.
    Difference,
}

impl Operator {
    /// The word for it, as scene files spell it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Union => "union",
            Self::Intersection => "intersection",
            Self::Difference => "difference",
        }
    }

    /// The sign for it.
    #[must_use]
    pub const fn sign(self) -> &'static str {
        match self {
            Self::Union => "∪",
            Self::Intersection => "∩",
            Self::Difference => "−",
        }
    }
}

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
    /// One of the six steps of § 6.1.
    Step {
        /// 1 to 6.
        number: u8,
        /// The step in words.
        title: String,
    },
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
        /// The share of the reflected colour.
        share: f64,
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
        /// Which limit: `depth`, `contribution`, `recording size`.
        limit: String,
        /// Its value.
        at: f64,
        /// The number that met it.
        value: f64,
        /// What is therefore missing.
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
    /// The pixel as it is written.
    Written {
        /// Linear RGB before clamping.
        linear: Triple,
        /// sRGB as stored in the picture.
        srgb: [u8; 3],
    },
}
