//! What is told of a ray's way through a solid.

use super::combine::Tie;
use super::{Ball, Boundary, Course, Extent, Interval, IntervalList, Leaf, Node, Solid};
use crate::math::{DoubleDouble, Real};
use crate::record::{Certificate, Edge, Entry, Measured, Operator, Recorder, Span, Tier, Triple, Value, What};
use glam::DVec3;

/// The test against a box.
#[track_caller]
pub fn extent(name: &str, extent: &Extent, inside: Option<[f64; 2]>) -> Entry {
    let (low, high) = (extent.low.to_array(), extent.high.to_array());
    Entry::new(What::Extent { of: name.to_owned(), low, high, inside })
}

/// The test against a ball.
#[track_caller]
pub fn ball(name: &str, ball: &Ball, course: &Course, is_met: bool) -> Entry {
    let Ball { centre, radius } = *ball;
    let distance = ball.distance(course);
    Entry::new(What::Ball { of: name.to_owned(), centre: centre.to_array(), radius, distance, is_met })
}

/// The ray in a primitive's generic coordinates, unscaled: S and c are the very numbers that are solved with.
#[track_caller]
pub fn transform(leaf: &Leaf, [origin, direction]: [DVec3; 2], [s, c]: [Measured<Triple>; 2]) -> Entry {
    let bindings = |v: DVec3| [("origin", Value::from(v.to_array())), ("direction", Value::from(v.to_array()))];
    Entry::new(What::Transform {
        of: leaf.name.clone(),
        inverse: leaf.placement.inverse_rows(),
        origin: s.value,
        direction: c.value,
    })
    .line("S", "M⁻¹ origin", &bindings(origin), s)
    .line("c", "M⁻¹ direction", &bindings(direction), c)
}

/// A primitive's own result, before any CSG.
#[track_caller]
pub fn primitive(leaf: &Leaf, index: usize, list: &IntervalList) -> Entry {
    let (shape, name) = (leaf.shape.name().to_owned(), leaf.name.clone());
    Entry::new(What::Primitive { shape, name, leaf: index, hits: list.boundaries().len() })
}

/// The left, the right and the combined list of a node; the right one is none where it was not asked.
#[track_caller]
pub fn combine(
    solid: &Solid,
    name: &str,
    operator: Operator,
    lists: [Option<&IntervalList>; 3],
    early_out: Option<&str>,
) -> Entry {
    let [left, right, combined] = lists.map(|list| list.map(|list| spans(solid, list)));
    Entry::new(What::Combine {
        name: name.to_owned(),
        operator,
        left: left.unwrap_or_default(),
        right,
        combined: combined.unwrap_or_default(),
        early_out: early_out.map(str::to_owned),
    })
}

/// How boundaries of two operands that the fast arithmetic could not tell apart were told apart after all, or were not.
#[track_caller]
pub fn tie<A: Real>(first: &Tie, second: Option<&Tie>) -> Entry {
    let tier = |arithmetic: &str, [gap, doubt]: [f64; 2], decided| Tier {
        arithmetic: arithmetic.to_owned(),
        value: gap,
        doubt,
        decided,
        operations: 0,
        f64_operations: 0,
    };
    let [gap, doubt] = second.map_or([first.gap, 0.0], |tie| [tie.gap, tie.doubt]);
    let last = tier(DoubleDouble::NAME, [gap, doubt], second.is_none());
    Entry::new(What::Decision {
        question: "Do boundaries of two operands lie apart?".to_owned(),
        tiers: vec![tier(A::NAME, [first.gap, first.doubt], false), last],
        input_doubt: doubt,
        near: Some(first.t),
        certificate: if second.is_some() { Certificate::Undecidable } else { Certificate::Fallback },
    })
}

/// Every boundary of an operand that is none of the result, with the reason.
pub fn rejected(
    solid: &Solid,
    name: &str,
    operator: Operator,
    nodes: [&Node; 2],
    lists: [&IntervalList; 2],
    combined: &IntervalList,
    recorder: &mut impl Recorder,
) {
    let kept = combined.boundaries();
    for (side, list) in lists.into_iter().enumerate() {
        let other = lists[1 - side];
        for (boundary, _) in list.boundaries() {
            if kept.iter().any(|(b, _)| b.t == boundary.t && b.leaf == boundary.leaf) {
                continue;
            }
            let reason = reason(operator, side, other.contains(boundary.t), &node_name(solid, nodes[1 - side]));
            recorder.note(|| rejection(name, &solid.leaves[boundary.leaf], &boundary, reason));
        }
    }
}

/// A hit that does not count.
pub fn rejection(object: &str, leaf: &Leaf, boundary: &Boundary, reason: String) -> Entry {
    Entry::new(What::Rejected {
        object: object.to_owned(),
        leaf: leaf.name.clone(),
        part: leaf.part(boundary).to_owned(),
        t: boundary.t,
        reason,
    })
}

/// Why a boundary of the left (0) or right (1) operand is none of the result.
fn reason(operator: Operator, side: usize, in_other: bool, other: &str) -> String {
    match (operator, side, in_other) {
        (Operator::Union, _, true) => format!("inside {other}: the union goes on through it"),
        (Operator::Intersection, _, false) => format!("outside {other}: a point of the intersection is in both"),
        (Operator::Difference, 0, true) => format!("inside {other}, which is taken away"),
        (Operator::Difference, 1, false) => format!("outside {other}: there is nothing to take away"),
        _ => format!("coincides with a boundary of {other} that it cannot be told apart from"),
    }
}

fn node_name(solid: &Solid, node: &Node) -> String {
    match node {
        Node::Leaf { leaf, .. } => format!("`{}`", solid.leaves[*leaf].name),
        Node::Pair { name, .. } => format!("`{name}`"),
    }
}

fn spans(solid: &Solid, list: &IntervalList) -> Vec<Span> {
    let edge = |boundary: Boundary| edge(&solid.leaves[boundary.leaf], &boundary);
    let span = |interval: Interval| Span { enter: interval.enter.map(edge), leave: interval.leave.map(edge) };
    list.intervals().map(span).collect()
}

fn edge(leaf: &Leaf, boundary: &Boundary) -> Edge {
    Edge {
        t: boundary.t,
        leaf: boundary.leaf,
        name: leaf.name.clone(),
        part: leaf.part(boundary).to_owned(),
        flipped: boundary.flipped,
        certificate: boundary.certificate,
    }
}
