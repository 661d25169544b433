//! What events are made of: kinds of rays, candidates, rows of the plane table, spans of an inside set.

use super::Triple;
use schemars::JsonSchema;
use serde::Serialize;

/// Why a ray was sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RayKind {
    /// From the eye, or from a point of its lens, through a pixel.
    Camera,
    /// From a hit, mirrored about the normal.
    Reflected,
    /// From a hit, through the surface.
    Refracted,
    /// From a hit or a point of a medium towards a light.
    Shadow,
    /// From a point of a medium, turned by what floats there.
    Scattered,
}

impl RayKind {
    /// All kinds, in the order in which they are listed everywhere.
    pub const ALL: [Self; 5] = [Self::Camera, Self::Reflected, Self::Refracted, Self::Shadow, Self::Scattered];

    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Camera => "camera",
            Self::Reflected => "reflected",
            Self::Refracted => "refracted",
            Self::Shadow => "shadow",
            Self::Scattered => "scattered",
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

/// How surely something is known: that there is a hit, or that there is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Certificate {
    /// The error bound of the fast arithmetic leaves no other answer.
    Certain,
    /// The fast arithmetic could not tell, the finer one could.
    Fallback,
    /// The ray's own numbers do not say: half a unit in their last places would change the answer. What is reported is the
    /// answer for the numbers exactly as they stand.
    Undecidable,
}

impl Certificate {
    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Certain => "certain",
            Self::Fallback => "decided by the fallback",
            Self::Undecidable => "undecidable at input precision",
        }
    }
}

/// One arithmetic's attempt at a solver's closest decision.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Tier {
    /// The arithmetic.
    pub arithmetic: String,
    /// The number whose sign decides.
    pub value: f64,
    /// Bound on its rounding error.
    pub doubt: f64,
    /// Whether the sign is beyond doubt.
    pub decided: bool,
    /// Operations of this arithmetic that the attempt took.
    pub operations: u64,
    /// The same in operations of `f64`.
    pub f64_operations: u64,
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
    /// How surely it is known to exist.
    pub certificate: Certificate,
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
    pub const fn sign(self) -> char {
        match self {
            Self::Union => '∪',
            Self::Intersection => '∩',
            Self::Difference => '−',
        }
    }
}
