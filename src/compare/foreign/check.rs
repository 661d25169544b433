//! One thing that a foreign ray tracer says, beside what we recorded.

use crate::compare::Said;
use crate::record::EventId;

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// Where a ray starts.
    RayOrigin,
    /// Where a ray goes, up to its length.
    RayDirection,
    /// S of the primitive below this event.
    GenericOrigin(EventId),
    /// c of the primitive below this event.
    GenericDirection(EventId),
    /// The hit times with this primitive.
    Hits(EventId),
    /// The hit times with this compound.
    Edges(EventId),
    /// The intervals inside this object.
    Inside(EventId),
    /// Which object is hit, or none.
    HitObject,
    /// Which primitive of the object is hit.
    HitLeaf,
    /// The hit time.
    HitTime,
    /// The hit point.
    Point,
    /// The normal that shading uses.
    Normal,
    /// The normal out of the solid.
    Outward,
    /// The direction to the light of this event.
    Towards(EventId),
    /// Whether the light of this event arrives.
    Lit(EventId),
    /// What stands before the light of this event.
    BlockedBy(EventId),
    /// The diffuse term of the light of this event.
    Diffuse(EventId),
    /// The specular term of the light of this event.
    Specular(EventId),
    /// The mirrored direction, up to its length.
    Reflected,
    /// n₁ and n₂.
    Indices,
    /// The refracted direction, up to its length.
    Refracted,
    /// A ray that ours does not send.
    ExtraRay,
    /// A term of the colour of a ray.
    Term(Term),
    /// The colour that a ray brings back.
    Colour,
    /// The bytes of the pixel.
    Written,
}

/// A term of the colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Term {
    /// Ambient.
    Ambient,
    /// Diffuse, all lights.
    Diffuse,
    /// Specular, all lights.
    Specular,
    /// Along the mirrored ray.
    Mirrored,
    /// Along the refracted ray.
    Transmitted,
}

impl Subject {
    /// The words for it.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::RayOrigin => "the ray's origin",
            Self::RayDirection => "the ray's direction",
            Self::GenericOrigin(_) => "S, the origin in generic coordinates",
            Self::GenericDirection(_) => "c, the direction in generic coordinates",
            Self::Hits(_) => "the hit times",
            Self::Edges(_) => "the hit times with the compound",
            Self::Inside(_) => "the intervals inside the object",
            Self::HitObject => "the object that is hit",
            Self::HitLeaf => "the primitive that is hit",
            Self::HitTime => "t",
            Self::Point => "the hit point",
            Self::Normal => "the normal that shading uses",
            Self::Outward => "the normal out of the solid",
            Self::Towards(_) => "the direction towards the light",
            Self::Lit(_) => "whether light arrives",
            Self::BlockedBy(_) => "what stands before the light",
            Self::Diffuse(_) => "the diffuse term",
            Self::Specular(_) => "the specular term",
            Self::Reflected => "the mirrored direction",
            Self::Indices => "n₁ and n₂",
            Self::Refracted => "the refracted direction",
            Self::ExtraRay => "a ray that is sent",
            Self::Term(Term::Ambient) => "the ambient term",
            Self::Term(Term::Diffuse) => "the diffuse terms of all lights",
            Self::Term(Term::Specular) => "the specular terms of all lights",
            Self::Term(Term::Mirrored) => "what the mirrored ray adds",
            Self::Term(Term::Transmitted) => "what the refracted ray adds",
            Self::Colour => "the colour that the ray brings back",
            Self::Written => "the bytes of the pixel",
        }
    }

    /// Whether only the direction of a vector counts, and not its length.
    #[must_use]
    pub const fn is_direction(self) -> bool {
        matches!(self, Self::RayDirection | Self::Reflected | Self::Refracted)
    }
}

/// One thing that was compared.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// The line that says it, from 1.
    pub line: usize,
    /// Our event that says it.
    pub event: EventId,
    /// Its place in the order of the story: results come after what they were worked out from.
    pub order: EventId,
    /// The ray, by its place among ours.
    pub ray: usize,
    /// Their unit of t in ours, where a direction of theirs was printed.
    pub unit: Option<f64>,
    /// A hit time that goes with words: of a blocker, in their unit.
    pub time: Option<f64>,
    /// What is compared.
    pub subject: Subject,
    /// What we recorded.
    pub ours: Said,
    /// What the other says, its times in our unit.
    pub theirs: Said,
    /// How far they may lie apart.
    pub allowed: f64,
    /// How far they lie apart; infinite where they are not of one kind.
    pub off: f64,
}

impl Check {
    /// Whether the two agree.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.off <= self.allowed
    }

    /// Their numbers; none where they said no numbers.
    #[must_use]
    pub fn numbers(&self) -> &[f64] {
        match &self.theirs {
            Said::Numbers(numbers) => numbers,
            Said::Words(_) => &[],
        }
    }
}

/// How far two lists of numbers lie apart at most.
#[must_use]
pub fn apart(a: &[f64], b: &[f64]) -> f64 {
    if a.len() != b.len() {
        return f64::INFINITY;
    }
    let one = |(a, b): (&f64, &f64)| if a == b || (a.is_nan() && b.is_nan()) { 0.0 } else { (a - b).abs() };

    std::iter::zip(a, b).map(one).fold(0.0, |most: f64, off| if off.is_nan() { f64::INFINITY } else { most.max(off) })
}

/// The vector with length 1; the vector itself where it has none.
#[must_use]
pub fn unit(v: &[f64]) -> Vec<f64> {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length > 0.0 && length.is_finite() { v.iter().map(|x| x / length).collect() } else { v.to_vec() }
}
