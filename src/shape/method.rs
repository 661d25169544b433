//! How hit times are found: the ways that a picture, a record or an experiment can be asked to go.

use super::textbook::Exhibit;
use super::{Approach, Crossing, Crossings, Primitive, Shape};
use crate::math::{Alone, DoubleDouble, Precise, Real};
use crate::record::NullRecorder;
use serde::{Deserialize, Serialize};

/// An arithmetic and what is done where it cannot tell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Method {
    /// The program's solvers in single precision, with nothing to fall back on.
    Single,
    /// The same in double precision: recentred, and as sure as 16 digits allow.
    Double,
    /// What the program renders with: double precision, and 32 digits where these leave the answer open. Every answer has
    /// a certificate.
    #[default]
    Adaptive,
    /// 32 digits from the start.
    DoubleDouble,
    /// The textbook's solvers in double precision, which have no bounds on their errors.
    Textbook,
    /// 77 digits: far too slow for pictures. It is what the others are measured against, and none of those that are offered.
    Exact,
}

impl Method {
    /// All that are offered, in the order in which they are shown.
    pub const ALL: [Self; 5] = [Self::Single, Self::Double, Self::Adaptive, Self::DoubleDouble, Self::Textbook];

    /// Its name, as it is shown.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Single => "f32",
            Self::Double => "f64",
            Self::Adaptive => "adaptive",
            Self::DoubleDouble => "double-double",
            Self::Textbook => "textbook",
            Self::Exact => "exact",
        }
    }

    /// How much coarser than those of `f64` the last digits of its numbers are.
    #[must_use]
    pub fn coarseness(self) -> f64 {
        match self {
            Self::Single => f32::UNIT_ROUNDOFF / f64::UNIT_ROUNDOFF,
            _ => 1.0,
        }
    }
}

/// How hits with superellipsoids are searched for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Search {
    /// By the method's own solver, which cannot step over a hit.
    #[default]
    Certified,
    /// As textbooks do: d(t) is looked at in so many equal stretches of the ray's way through the box, at least 2, and each
    /// change of sign is closed in on. A chord shorter than a stretch is never seen.
    Stretches(u32),
}

/// How a ray's hits are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Solving {
    /// With all shapes.
    pub method: Method,
    /// With superellipsoids.
    pub search: Search,
}

impl Solving {
    /// What the program renders with.
    pub const STANDARD: Self = Self { method: Method::Adaptive, search: Search::Certified };

    /// The textbook's solver, where it takes the place of the shape's own.
    #[must_use]
    #[inline]
    pub const fn exhibit(self, shape: &Shape) -> Option<Exhibit> {
        match self {
            Self::STANDARD => None,
            other => other.exhibit_for(shape),
        }
    }

    #[inline(never)]
    const fn exhibit_for(self, shape: &Shape) -> Option<Exhibit> {
        match (shape, self.search, self.method) {
            (Shape::Superellipsoid(_), Search::Stretches(stretches), _) => Some(Exhibit { stretches }),
            (_, _, Method::Textbook) => Some(Exhibit::PRINTED),
            _ => None,
        }
    }

    /// The first crossing with t > 0, and nothing about it told.
    #[inline]
    pub fn first_crossing(self, shape: &Shape, approach: &impl Approach) -> Option<Crossing> {
        match (self.exhibit(shape), self.method) {
            (Some(exhibit), _) => exhibited(exhibit, shape, approach),
            (None, Method::Adaptive) => shape.first_crossing::<f64>(approach),
            (None, Method::Single) => out_of_line::<Alone<f32>>(shape, approach),
            (None, Method::Double | Method::Textbook) => out_of_line::<Alone<f64>>(shape, approach),
            (None, Method::DoubleDouble) => out_of_line::<DoubleDouble>(shape, approach),
            (None, Method::Exact) => out_of_line::<Precise>(shape, approach),
        }
    }
}

/// The first crossing by one of the textbook's solvers.
#[inline(never)]
fn exhibited(exhibit: Exhibit, shape: &Shape, approach: &impl Approach) -> Option<Crossing> {
    let mut crossings = Crossings::new();
    exhibit.crossings(shape, &approach.generic(), &mut NullRecorder, &mut crossings);
    crossings.into_iter().find(|crossing| crossing.t > 0.0)
}

/// The first crossing in an arithmetic that only experiments ask for: what renders pictures every day is not to grow by it.
#[inline(never)]
fn out_of_line<A: Real>(shape: &Shape, approach: &impl Approach) -> Option<Crossing> {
    shape.first_crossing::<A>(approach)
}
