//! What stands below an event's row: everything that the row itself has not said.

use super::detail::{DetailLine, detail};
use crate::record::{Event, What};

/// The lines of an event's detail that neither its row nor its working says again.
#[must_use]
pub fn beneath(event: &Event) -> Vec<DetailLine> {
    let is_new = |line: &DetailLine| match line {
        DetailLine::Pair { name, .. } => {
            !said_by_row(&event.what, name) && !event.working.iter().any(|line| line.symbol == *name)
        }
        _ => true,
    };
    detail(event).lines.into_iter().filter(is_new).collect()
}

/// The parts of `symbol = formula = numbers = result`, without one that says the same as the one before it.
#[must_use]
pub fn equated<'a>(symbol: &'a str, parts: [&'a str; 3]) -> Vec<&'a str> {
    let mut said = vec![symbol];
    for part in parts {
        if said.last() != Some(&part) && !part.is_empty() {
            said.push(part);
        }
    }
    said
}

/// Whether the row above has said this already.
fn said_by_row(what: &What, name: &str) -> bool {
    match what {
        What::Pixel { .. }
        | What::LooseRay { .. }
        | What::Rejected { .. }
        | What::Nothing { .. }
        | What::Ambient { .. }
        | What::Primitive { .. } => true,
        What::Ray { .. } => matches!(name, "kind" | "depth" | "weight"),
        What::Object { .. } | What::Extent { .. } | What::Ball { .. } => name == "inside",
        What::Quadratic { .. } => matches!(name, "equation" | "roots"),
        What::Implicit { .. } => name == "zeros",
        What::Medium { .. } => matches!(name, "before" | "after"),
        What::Limit { .. } => name == "therefore",
        What::Texture(_) => matches!(name, "kind" | "colour"),
        What::Detail(_) | What::Mapping(_) => matches!(name, "u, v" | "s, t"),
        What::Undulate(_) => matches!(name, "argument" | "colour"),
        What::Texels(_) => name == "weighted sum",
        What::Lattice(_) => name == "noise, the sum",
        What::Octaves(_) => name == "sum",
        What::Rings(_) => matches!(name, "ring" | "stirred, in rings"),
        What::Bump(_) => matches!(name, "unit normal after" | "angle between them"),
        What::FrameMap(_) => matches!(name, "turned about N" | "N tilted, as slopes along and across the grain"),
        What::Environment(_) => name == "what came out",
        What::Shadow { .. } => matches!(name, "in the way" | "passes"),
        _ => false,
    }
}
