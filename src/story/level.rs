//! Levels of detail: which events the story tells, which belong to the working, and which are everything else.
//!
//! The table of kinds gives every event a level. What is told more, whatever its kind, stands here: what went wrong, what was
//! cut off, and what decided the outcome.

use super::index::Scope;
use super::kind::Kind;
use crate::record::{Certificate, Event, RayKind, What};

/// How much of what happened has a row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Rays, what they hit, the lights, the colours, and whatever cut something off.
    #[default]
    Story,
    /// The same, with objects, primitives, CSG nodes, Snell's law, and the terms of the shading.
    Working,
    /// All that was recorded.
    Everything,
}

impl Level {
    /// All of them, from the shortest.
    pub const ALL: [Self; 3] = [Self::Story, Self::Working, Self::Everything];

    /// The word for it, which is also its key in the catalogue of words.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Story => "story",
            Self::Working => "working",
            Self::Everything => "everything",
        }
    }
}

/// The level of an event, before what lies below it is looked at.
///
/// `scope` is the ray that it belongs to; `decides` says whether it is about the object that this ray ends on.
pub(super) fn level_of(event: &Event, scope: &Scope, decides: bool) -> Level {
    let usual = Kind::of(&event.what).level();
    // Shadow rays are the working of a light: the light's own row says how much of it arrives.
    let alarming = if scope.kind == RayKind::Shadow { Level::Working } else { Level::Story };
    match &event.what {
        What::Decision { certificate: Certificate::Undecidable, .. }
        | What::Snell { total_internal_reflection: true, .. }
        | What::Medium { interpenetration: true, .. } => alarming,
        What::Search { undecided, .. } if *undecided > 0 => alarming,
        What::Combine { early_out: Some(_), .. } if decides => alarming,
        What::Ray { ray: RayKind::Shadow, .. }
        | What::Decision { certificate: Certificate::Fallback, .. }
        | What::Extent { inside: None, .. }
        | What::Ball { is_met: false, .. }
        | What::Projection { holds: false, .. }
        | What::Planes { stopped: Some(_), .. } => Level::Working,
        _ => usual,
    }
}
