//! Union, intersection and difference by sorted hit times: walk along both lists, note who is inside, and keep the times at
//! which the result changes.
//!
//! **Where it fails** Where both surfaces coincide: their hit times are equal or differ by rounding, so the answer is left to
//! the order of two numbers that mean the same. A − A leaves slivers, boxes that abut unite with a seam, and a lens whose
//! faces touch flickers. What is hit on the way is lost or doubled whenever a primitive's list is wrong by one.
//!
//! **Source** S. D. Roth, "Ray casting for modeling solids", Computer Graphics and Image Processing 18 (1982); F. S. Hill,
//! Computer Graphics Using OpenGL, 2nd ed., § 14.14.

use crate::record::Sense;
use crate::shape::Crossing;

/// The crossings of `left OP right`, where `holds` says whether a point is in the result, given whether it is in the left and
/// in the right operand: wrong where surfaces coincide.
#[must_use]
pub fn combine(holds: impl Fn(bool, bool) -> bool, left: &[Crossing], right: &[Crossing]) -> Vec<Crossing> {
    let mut events: Vec<_> = left.iter().map(|hit| (*hit, 0)).chain(right.iter().map(|hit| (*hit, 1))).collect();
    events.sort_by(|(a, _), (b, _)| a.t.total_cmp(&b.t));
    let starts_inside = |list: &[Crossing]| list.first().is_some_and(|first| first.sense == Sense::Leave);
    let mut inside = [starts_inside(left), starts_inside(right)];
    let mut is_open = holds(inside[0], inside[1]);
    let mut result = Vec::new();
    for (hit, side) in events {
        inside[side] = hit.sense == Sense::Enter;
        let now_open = holds(inside[0], inside[1]);
        if now_open != is_open {
            let sense = if now_open { Sense::Enter } else { Sense::Leave };
            result.push(Crossing { sense, ..hit });
            is_open = now_open;
        }
    }
    result
}
