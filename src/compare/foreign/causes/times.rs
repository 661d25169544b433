//! What can be wrong with hit times and with the intervals inside a compound.

use super::generic::{leaf, wrong_maps};
use super::{
    CAP_MISSING, CAP_UNBOUNDED, Case, Cause, DIRECTION_NORMALISED, FORWARD_MATRIX, Guess, NOT_TRANSFORMED, ONE_ROOT,
    OPERANDS_SWAPPED, QUADRATIC_HALF_B, QUADRATIC_SIGN_B, QUADRATIC_UNIT_A, RIGHT_OPERAND_IGNORED, WALL_UNBOUNDED,
    WRONG_OPERATOR, list, number,
};
use crate::compare::foreign::check::Subject;
use crate::compare::foreign::search::intervals;
use crate::csg::{Leaf, Placement, Solid};
use crate::record::{Candidate, CandidateFate, EventId, NullRecorder, Operator, Span, What};
use glam::{DAffine3, DVec3};

/// A formula with its numbers, and the hit times that it gives.
type Times = (&'static Cause, String, Vec<f64>);

/// Guesses about the hit times of one primitive.
pub fn of_primitive(case: Case, primitive: EventId, guesses: &mut Vec<Guess>) {
    for (cause, how, times) in wrong_times(case, primitive) {
        guesses.push(Guess::new(cause, how, case.in_front(times)));
    }
}

/// All wrong hit times of a primitive.
pub(super) fn wrong_times(case: Case, primitive: EventId) -> Vec<Times> {
    let candidates = case.ours.candidates(primitive).map(|(_, candidates)| candidates).unwrap_or_default();
    let accepted: Vec<f64> = candidates.iter().filter(|c| is_accepted(c)).map(|c| c.t).collect();
    let mut times = Vec::new();
    let is_mapped = case.agrees(case.check.ray, |subject| subject == Subject::GenericDirection(primitive));
    if let Some((_, _, c)) = case.ours.transform(primitive).filter(|_| !is_mapped) {
        for unit in case.units() {
            let how = format!("t |c| for t = {} and |c| = {}", list(&accepted), number(c.length() * unit));
            times.push((&DIRECTION_NORMALISED, how, accepted.iter().map(|t| t * c.length() * unit).collect()));
        }
    }
    of_parts(candidates, &mut times);
    of_quadratic(case, primitive, &mut times);
    if let [first, .., last] = accepted[..] {
        times.push((&ONE_ROOT, "the first of the roots".to_owned(), vec![first]));
        times.push((&ONE_ROOT, "the last of the roots".to_owned(), vec![last]));
    }
    if let Some(leaf) = leaf(case, primitive).filter(|_| !is_mapped) {
        of_placement(case, leaf, &mut times);
    }
    times
}

fn is_accepted(candidate: &Candidate) -> bool {
    candidate.fate == CandidateFate::Accepted
}

/// Walls and caps that are not tested, or accepted where they do not count.
fn of_parts(candidates: &[Candidate], times: &mut Vec<Times>) {
    let is_wall = |c: &&Candidate| c.part == "wall";
    if !candidates.iter().any(|c| c.part == "wall" || c.part == "cap") {
        return;
    }
    let of = |which: &dyn Fn(&&Candidate) -> bool| candidates.iter().filter(which).map(|c| c.t).collect::<Vec<_>>();
    times.push((&CAP_MISSING, "the hits with the wall alone".to_owned(), of(&|c| is_wall(c) && is_accepted(c))));
    times.push((&CAP_MISSING, "all hits with the endless wall".to_owned(), of(&|c| is_wall(c))));
    let walls = of(&|c| is_wall(c) || is_accepted(c));
    times.push((&WALL_UNBOUNDED, "the hits, with those on the wall beyond its ends".to_owned(), walls));
    let caps = of(&|c| !is_wall(c) || is_accepted(c));
    times.push((&CAP_UNBOUNDED, "the hits, with those on the caps' planes outside the discs".to_owned(), caps));
}

/// Slips in the solution of A t² + 2 B t + C = 0.
fn of_quadratic(case: Case, primitive: EventId, times: &mut Vec<Times>) {
    let found = case.ours.below(primitive).iter().find_map(|event| match &event.what {
        What::Quadratic { a, b, c, recentred_at, .. } => Some((*a, *b, *c, *recentred_at)),
        _ => None,
    });
    let Some((a, b, c, start)) = found else { return };
    let candidates = case.ours.candidates(primitive).map(|(_, candidates)| candidates).unwrap_or_default();
    // Between its ends the wall counts, and the caps have times of their own.
    let ends = candidates.iter().filter(|c| is_accepted(c) && matches!(c.part.as_str(), "cap" | "base"));
    let caps: Vec<f64> = ends.map(|candidate| candidate.t).collect();
    let has_ends = candidates.iter().any(|c| c.part != "surface");
    let between = |t: &f64| {
        let height = case.ours.transform(primitive).map_or(0.0, |(_, s, c)| s.z + c.z * t);
        !has_ends || (0.0..=1.0).contains(&height)
    };
    // About t = 0, as textbooks write it.
    let (b, c) = (b - a * start, c - 2.0 * b * start + a * start * start);
    let formulas: [(&'static Cause, &str, f64, f64, f64); 5] = [
        (&QUADRATIC_HALF_B, "(−2B ± √(4B² − A C)) / A", -2.0 * b, 4.0 * b * b - a * c, a),
        (&QUADRATIC_HALF_B, "(−B ± √(B² − 4 A C)) / 2A", -b, b * b - 4.0 * a * c, 2.0 * a),
        (&QUADRATIC_UNIT_A, "−B ± √(B² − C)", -b, b * b - c, 1.0),
        (&QUADRATIC_UNIT_A, "−B ± √(B² − A C), not divided by A,", -b, b * b - a * c, 1.0),
        (&QUADRATIC_SIGN_B, "(B ± √(B² − A C)) / A", b, b * b - a * c, a),
    ];
    for (cause, formula, minus_b, discriminant, divisor) in formulas {
        let root = discriminant.sqrt();
        let roots = [(minus_b - root) / divisor, (minus_b + root) / divisor];
        let walls = roots.into_iter().filter(|t| discriminant >= 0.0 && between(t));
        let roots: Vec<f64> = walls.chain(caps.iter().copied()).collect();
        let how = format!("{formula} with A = {}, B = {}, C = {}", number(a), number(b), number(c));
        times.push((cause, how, roots));
    }
}

/// The primitive in a place where it does not stand.
fn of_placement(case: Case, leaf: &Leaf, times: &mut Vec<Times>) {
    let matrix = leaf.placement.world_from_generic();
    let mut wrong = wrong_maps(matrix);
    wrong.push((&NOT_TRANSFORMED, "the generic primitive as it is", DAffine3::IDENTITY));
    wrong.push((&FORWARD_MATRIX, "M in place of M⁻¹", matrix.inverse()));
    for (cause, how, map) in wrong {
        let hits = placed(leaf, map).map(|solid| crossings(&solid, case.origin(), case.direction()));
        times.extend(hits.map(|hits| (cause, format!("{how}: t"), hits)));
    }
}

fn placed(leaf: &Leaf, map: DAffine3) -> Option<Solid> {
    let placement = Placement::new(map).ok()?;
    Some(Solid::leaf(Leaf::new(leaf.name.clone(), leaf.shape.clone(), placement)))
}

fn crossings(solid: &Solid, origin: DVec3, direction: DVec3) -> Vec<f64> {
    let inside = solid.inside::<f64>(origin, direction, &mut NullRecorder);
    inside.boundaries().iter().map(|(boundary, _)| boundary.t).collect()
}

/// Guesses about the hit times of a compound.
pub fn of_edges(case: Case, object: EventId, guesses: &mut Vec<Guess>) {
    for (cause, how, spans) in wrong_intervals(case, object) {
        let times: Vec<f64> = spans.into_iter().flatten().filter(|t| t.is_finite()).collect();
        guesses.push(Guess::new(cause, how, case.in_front(times)));
    }
}

/// Guesses about the intervals inside an object.
pub fn of_inside(case: Case, object: EventId, guesses: &mut Vec<Guess>) {
    let mut all = wrong_intervals(case, object);
    if let Some((primitive, _)) = case.ours.primitives(object).next().filter(|_| case.ours.combined(object).is_none()) {
        let paired = |times: Vec<f64>| times.chunks(2).filter_map(|pair| <[f64; 2]>::try_from(pair).ok()).collect();
        all.extend(wrong_times(case, primitive.id).into_iter().map(|(cause, how, times)| (cause, how, paired(times))));
    }
    for (cause, how, spans) in all {
        let ahead = spans.into_iter().filter(|[_, to]| *to > case.check.allowed);
        let ends: Vec<f64> = ahead.flat_map(|[from, to]| [from.max(0.0), to]).collect();
        guesses.push(Guess::new(cause, how, ends));
    }
}

pub(super) type Intervals = (&'static Cause, String, Vec<[f64; 2]>);

pub(super) fn wrong_intervals(case: Case, object: EventId) -> Vec<Intervals> {
    let Some(node) = case.ours.combined(object) else { return Vec::new() };
    let (left, right) = (intervals(node.left), intervals(node.right));
    let mut wrong: Vec<Intervals> = Vec::new();
    if node.operator == Operator::Difference {
        wrong.push((&OPERANDS_SWAPPED, "right − left".to_owned(), combine(Operator::Difference, &right, &left)));
    }
    wrong.push((&RIGHT_OPERAND_IGNORED, "left alone".to_owned(), left.clone()));
    for operator in [Operator::Union, Operator::Intersection, Operator::Difference] {
        if operator != node.operator {
            let how = format!("left {} right", operator.sign());
            wrong.push((&WRONG_OPERATOR, how, combine(operator, &left, &right)));
        }
    }
    for unit in case.units() {
        let scaled = |spans: &[Span]| scaled_by_leaf(case, object, spans, unit);
        let how = format!("left {} right, every t times |c| of its primitive", node.operator.sign());
        wrong.push((&DIRECTION_NORMALISED, how, combine(node.operator, &scaled(node.left), &scaled(node.right))));
    }
    wrong
}

/// The intervals with every end times the |c| of the primitive that it lies on.
fn scaled_by_leaf(case: Case, object: EventId, spans: &[Span], unit: f64) -> Vec<[f64; 2]> {
    let scale = |name: &str| {
        let primitive = case.ours.primitives(object).find(|(_, primitive)| *primitive == name);
        let transform = primitive.and_then(|(event, _)| case.ours.transform(event.id));
        transform.map_or(1.0, |(_, _, c)| c.length() * unit)
    };
    let one = |span: &Span| {
        let from = span.enter.as_ref().map_or(f64::NEG_INFINITY, |edge| edge.t * scale(&edge.name));
        [from, span.leave.as_ref().map_or(f64::INFINITY, |edge| edge.t * scale(&edge.name))]
    };
    spans.iter().map(one).collect()
}

/// Two lists of intervals under a Boolean operator, by what holds between any two neighbouring ends.
fn combine(operator: Operator, left: &[[f64; 2]], right: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut ends: Vec<f64> = left.iter().chain(right).flatten().copied().collect();
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    let holds = |list: &[[f64; 2]], [from, to]: [f64; 2]| list.iter().any(|[a, b]| *a <= from && to <= *b);
    let mut result: Vec<[f64; 2]> = Vec::new();
    for stretch in ends.windows(2).filter_map(|pair| <[f64; 2]>::try_from(pair).ok()) {
        let (in_left, in_right) = (holds(left, stretch), holds(right, stretch));
        let is_inside = match operator {
            Operator::Union => in_left || in_right,
            Operator::Intersection => in_left && in_right,
            Operator::Difference => in_left && !in_right,
        };
        if is_inside {
            match result.last_mut().filter(|last| last[1] == stretch[0]) {
                Some(last) => last[1] = stretch[1],
                None => result.push(stretch),
            }
        }
    }
    result
}

impl Case<'_, '_> {
    /// The times in order, without those behind the start that the other program left out.
    fn in_front(&self, mut times: Vec<f64>) -> Vec<f64> {
        let near = self.check.allowed;
        times.sort_by(f64::total_cmp);
        times.retain(|&t| t > near || self.check.numbers().iter().any(|other| (other - t).abs() <= near));
        times
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_combine_as_sets_do() {
        let (a, b) = ([[0.0, 4.0]], [[1.0, 2.0], [3.0, f64::INFINITY]]);
        assert_eq!(combine(Operator::Difference, &a, &b), [[0.0, 1.0], [2.0, 3.0]]);
        assert_eq!(combine(Operator::Intersection, &a, &b), [[1.0, 2.0], [3.0, 4.0]]);
        assert_eq!(combine(Operator::Union, &a, &b), [[0.0, f64::INFINITY]]);
        assert_eq!(combine(Operator::Difference, &[], &b), [] as [[f64; 2]; 0]);
    }
}
