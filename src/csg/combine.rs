//! Combining two inside sets: union, intersection, difference, regularised along the ray (§ 6.5.3).
//!
//! Boundaries of the two operands whose error intervals overlap cannot be told apart, so they are crossed *together*:
//! all their toggles are applied at once, and only then does the result look whether it went in or out. Coincident
//! faces are thereby decided by rule, not by the last bit: A − A is empty, A ∩ A is A, and boxes that abut unite
//! without a seam. Where both operands could give the new boundary, the left one does.

use super::{Boundary, IntervalList};
use crate::record::Operator;
use smallvec::SmallVec;

impl Operator {
    /// Whether a point is in the result, given whether it is in the operands.
    #[must_use]
    pub const fn holds(self, in_left: bool, in_right: bool) -> bool {
        match self {
            Self::Union => in_left || in_right,
            Self::Intersection => in_left && in_right,
            Self::Difference => in_left && !in_right,
        }
    }
}

/// A boundary of one of the operands.
#[derive(Clone, Copy)]
struct Toggle<'a> {
    boundary: &'a Boundary,
    from_right: bool,
}

/// Boundaries of both operands, with room for those of two convex solids.
type Toggles<'a> = SmallVec<[Toggle<'a>; 8]>;

/// Boundaries of two operands that cannot be told apart, though their times differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Tie {
    /// The time of the first of them.
    pub t: f64,
    /// How far the others are from it.
    pub gap: f64,
    /// What their errors come to.
    pub doubt: f64,
    /// The leaves that they belong to.
    pub leaves: SmallVec<[usize; 4]>,
}

/// The inside set of `left OP right`. Touches bound nothing and are dropped. `tied` is told of boundaries that differ and
/// were crossed together all the same.
pub(super) fn combine(
    operator: Operator,
    left: &IntervalList,
    right: &IntervalList,
    tied: &mut impl FnMut(Tie),
) -> IntervalList {
    let mut sweep = Sweep::new(operator, left, right);
    if sweep.one_by_one(left.ends(), right.ends()) {
        return sweep.result;
    }
    let mut sweep = Sweep::new(operator, left, right);
    let toggles = merged(left.ends(), right.ends());
    let mut rest = toggles.as_slice();
    while !rest.is_empty() {
        let (group, after) = rest.split_at(crossed_together(rest));
        if let Some(tie) = tie(group) {
            tied(tie);
        }
        sweep.cross(group);
        rest = after;
    }
    sweep.result
}

/// A walk along the ray, in and out of both operands.
struct Sweep {
    operator: Operator,
    inside: [bool; 2],
    is_open: bool,
    result: IntervalList,
}

impl Sweep {
    fn new(operator: Operator, left: &IntervalList, right: &IntervalList) -> Self {
        let inside = [left.starts_inside(), right.starts_inside()];
        let is_open = operator.holds(inside[0], inside[1]);
        Self { operator, inside, is_open, result: IntervalList::starting(is_open) }
    }

    /// Crosses one boundary after the other. Ends with `false` where some of both operands cannot be told apart.
    fn one_by_one(&mut self, left: &[Boundary], right: &[Boundary]) -> bool {
        let (mut l, mut r) = (0, 0);
        // How far the boundaries reach that cannot be told apart from the one before, all of them of one operand.
        let (mut reach, mut reached_from_right) = (f64::NEG_INFINITY, false);
        while l < left.len() || r < right.len() {
            let from_right = l == left.len() || r < right.len() && right[r].t < left[l].t;
            let (boundary, next) = if from_right { (&right[r], &mut r) } else { (&left[l], &mut l) };
            *next += 1;
            if boundary.t - boundary.error > reach {
                reach = boundary.t + boundary.error;
            } else if from_right == reached_from_right {
                reach = reach.max(boundary.t + boundary.error);
            } else {
                return false;
            }
            reached_from_right = from_right;
            self.inside[usize::from(from_right)] ^= true;
            let now_open = self.operator.holds(self.inside[0], self.inside[1]);
            if now_open != self.is_open {
                self.is_open = now_open;
                self.result.push(taken(boundary, from_right, self.operator), now_open);
            }
        }
        true
    }

    /// Crosses boundaries that cannot be told apart, all at once.
    fn cross(&mut self, group: &[Toggle]) {
        let before = self.inside;
        for toggle in group {
            self.inside[usize::from(toggle.from_right)] ^= true;
        }
        let now_open = self.operator.holds(self.inside[0], self.inside[1]);
        if now_open != self.is_open {
            self.is_open = now_open;
            if let Some(boundary) = responsible(self.operator, group, before, self.inside) {
                self.result.push(boundary, now_open);
            }
        }
    }
}

/// The boundaries of both operands, ascending; the left one first where they are equal.
fn merged<'a>(left: &'a [Boundary], right: &'a [Boundary]) -> Toggles<'a> {
    let mut toggles = Toggles::new();
    let (mut l, mut r) = (0, 0);
    while l < left.len() || r < right.len() {
        let from_right = l == left.len() || r < right.len() && right[r].t < left[l].t;
        let (operand, place) = if from_right { (right, &mut r) } else { (left, &mut l) };
        toggles.push(Toggle { boundary: &operand[*place], from_right });
        *place += 1;
    }
    toggles
}

/// What is in doubt about toggles that are crossed together: nothing where they coincide to the last digit.
fn tie(group: &[Toggle]) -> Option<Tie> {
    let [first, .., last] = group else { return None };
    let (t, gap) = (first.boundary.t, last.boundary.t - first.boundary.t);
    let leaves = || group.iter().map(|toggle| toggle.boundary.leaf).collect();
    (gap > 0.0).then(|| Tie { t, gap, doubt: first.boundary.error + last.boundary.error, leaves: leaves() })
}

/// How many of the first toggles cannot be told apart. Toggles of one operand alone always can: its list is in order.
fn crossed_together(toggles: &[Toggle]) -> usize {
    let mut reach = toggles[0].boundary.t + toggles[0].boundary.error;
    let mut count = 1;
    while let Some(next) = toggles.get(count)
        && next.boundary.t - next.boundary.error <= reach
    {
        reach = reach.max(next.boundary.t + next.boundary.error);
        count += 1;
    }
    let mixed = toggles[..count].iter().any(|toggle| toggle.from_right != toggles[0].from_right);
    if mixed { count } else { 1 }
}

/// The boundary of the group on whose account the result changed: the left operand's where it changed too.
///
/// An operand that changed against the result's direction (such as the left of a union leaving while the union is
/// entered) is not responsible.
fn responsible(operator: Operator, group: &[Toggle], before: [bool; 2], after: [bool; 2]) -> Option<Boundary> {
    let enters = operator.holds(after[0], after[1]);
    let left_changed = before[0] != after[0] && after[0] == enters;
    let toggle = group.iter().rev().find(|toggle| toggle.from_right != left_changed)?;
    Some(taken(toggle.boundary, toggle.from_right, operator))
}

/// A boundary of an operand as one of the result: what is taken away is turned inside out.
#[inline]
fn taken(boundary: &Boundary, from_right: bool, operator: Operator) -> Boundary {
    let flips = from_right && operator == Operator::Difference;
    Boundary { flipped: boundary.flipped != flips, ..*boundary }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Certificate;

    fn combine(operator: Operator, left: &IntervalList, right: &IntervalList) -> IntervalList {
        super::combine(operator, left, right, &mut |_| ())
    }
    use proptest::prelude::*;

    fn boundary(t: f64, leaf: usize) -> Boundary {
        Boundary { t, error: 0.0, leaf, part: 0, flipped: false, certificate: Certificate::Certain }
    }

    fn list(leaf: usize, spans: &[(f64, f64)]) -> IntervalList {
        let mut list = IntervalList::starting(spans.first().is_some_and(|span| span.0 == f64::NEG_INFINITY));
        let ends = spans.iter().flat_map(|&(a, b)| [a, b]).filter(|t| t.is_finite());
        ends.for_each(|t| list.push(boundary(t, leaf), false));
        list
    }

    /// The same list with another bound on all errors.
    fn blurred(list: &IntervalList, error: f64) -> IntervalList {
        let mut blurred = IntervalList::starting(list.starts_inside());
        list.ends().iter().for_each(|&boundary| blurred.push(Boundary { error, ..boundary }, false));
        blurred
    }

    fn spans(list: &IntervalList) -> Vec<(f64, f64)> {
        let at = |b: Option<Boundary>, otherwise| b.map_or(otherwise, |b| b.t);
        list.intervals().map(|i| (at(i.enter, f64::NEG_INFINITY), at(i.leave, f64::INFINITY))).collect()
    }

    #[test]
    fn overlapping_spans_combine_as_sets_do() {
        let (a, b) = (list(0, &[(0.0, 2.0)]), list(1, &[(1.0, 3.0)]));
        assert_eq!(spans(&combine(Operator::Union, &a, &b)), [(0.0, 3.0)]);
        assert_eq!(spans(&combine(Operator::Intersection, &a, &b)), [(1.0, 2.0)]);
        assert_eq!(spans(&combine(Operator::Difference, &a, &b)), [(0.0, 1.0)]);
    }

    #[test]
    fn a_solid_minus_itself_is_empty_and_its_intersection_with_itself_is_itself() {
        let a = list(0, &[(0.0, 1.0), (2.0, 3.0)]);
        assert!(combine(Operator::Difference, &a, &a).is_empty());
        assert_eq!(spans(&combine(Operator::Intersection, &a, &a)), spans(&a));
        assert_eq!(spans(&combine(Operator::Union, &a, &a)), spans(&a));
    }

    #[test]
    fn abutting_spans_unite_without_a_seam_and_meet_in_nothing() {
        let (a, b) = (list(0, &[(0.0, 1.0)]), list(1, &[(1.0, 2.0)]));
        assert_eq!(spans(&combine(Operator::Union, &a, &b)), [(0.0, 2.0)]);
        assert!(combine(Operator::Intersection, &a, &b).is_empty());
        assert_eq!(spans(&combine(Operator::Difference, &a, &b)), [(0.0, 1.0)]);
    }

    #[test]
    fn boundaries_within_each_others_error_are_one() {
        let [a, b] = [list(0, &[(0.0, 1.0)]), list(1, &[(1.0 + 1e-12, 2.0)])].map(|list| blurred(&list, 1e-12));
        assert_eq!(spans(&combine(Operator::Union, &a, &b)), [(0.0, 2.0)]);
    }

    #[test]
    fn a_tie_is_told_of_unless_the_times_are_the_same() {
        let mut ties = Vec::new();
        let a = list(0, &[(0.0, 1.0)]);
        super::combine(Operator::Union, &a, &a, &mut |tie| ties.push(tie));
        assert!(ties.is_empty());
        let a = list(0, &[(0.0, 1.0)]);
        let b = blurred(&list(1, &[(-1.0, 1.0 + 1e-12)]), 1e-11);
        super::combine(Operator::Union, &a, &b, &mut |tie| ties.push(tie));
        let [Tie { t, gap, doubt, leaves }] = &ties[..] else { panic!("{ties:?}") };
        assert!(*t == 1.0 && (gap - 1e-12).abs() < 1e-15 && *doubt == 1e-11);
        assert_eq!(leaves[..], [0, 1]);
    }

    #[test]
    fn subtracted_surfaces_are_flipped_and_doubly_subtracted_ones_are_not() {
        let shell = combine(Operator::Difference, &list(0, &[(0.0, 10.0)]), &list(1, &[(2.0, 8.0)]));
        let inner = shell.intervals().next().unwrap().leave.expect("the first wall ends");
        assert_eq!((inner.t, inner.leaf, inner.flipped), (2.0, 1, true));
        let rest = combine(Operator::Difference, &list(2, &[(-1.0, 11.0)]), &shell);
        let inner = rest.intervals().nth(1).unwrap().enter.expect("the hollow is what is left");
        assert_eq!((inner.t, inner.leaf, inner.flipped), (2.0, 1, false));
    }

    #[test]
    fn a_gap_without_length_is_closed_and_a_blade_without_length_is_kept() {
        let (ball, blade) = (list(0, &[(0.0, 2.0)]), list(1, &[(1.0, 1.0)]));
        assert_eq!(spans(&combine(Operator::Difference, &ball, &blade)), [(0.0, 2.0)]);
        assert_eq!(spans(&combine(Operator::Difference, &ball, &list(1, &[(0.0, 0.0)]))), [(0.0, 2.0)]);
        assert_eq!(spans(&combine(Operator::Union, &list(0, &[(3.0, 4.0)]), &blade)), [(1.0, 1.0), (3.0, 4.0)]);
    }

    #[test]
    fn unbounded_ends_stay_unbounded() {
        let half = list(0, &[(f64::NEG_INFINITY, 1.0)]);
        let ball = list(1, &[(0.0, 2.0)]);
        assert_eq!(spans(&combine(Operator::Union, &half, &ball)), [(f64::NEG_INFINITY, 2.0)]);
        assert_eq!(spans(&combine(Operator::Difference, &half, &ball)), [(f64::NEG_INFINITY, 0.0)]);
        assert_eq!(spans(&combine(Operator::Difference, &ball, &half)), [(1.0, 2.0)]);
    }

    fn any_list(leaf: usize) -> impl Strategy<Value = IntervalList> {
        prop::collection::btree_set(-20_i32..20, 0..9).prop_map(move |ends| {
            let ends: Vec<f64> = ends.into_iter().map(f64::from).collect();
            list(leaf, &ends.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect::<Vec<_>>())
        })
    }

    proptest! {
        #[test]
        fn membership_of_every_point_follows_the_operator(a in any_list(0), b in any_list(1)) {
            for operator in [Operator::Union, Operator::Intersection, Operator::Difference] {
                let result = combine(operator, &a, &b);
                for half in -41..41 {
                    let t = f64::from(half) / 2.0 + 0.25;
                    prop_assert_eq!(result.contains(t), operator.holds(a.contains(t), b.contains(t)));
                }
            }
        }

        #[test]
        fn results_are_ascending_and_have_length(a in any_list(0), b in any_list(1)) {
            for operator in [Operator::Union, Operator::Intersection, Operator::Difference] {
                let ends: Vec<f64> = spans(&combine(operator, &a, &b)).into_iter().flat_map(|(x, y)| [x, y]).collect();
                prop_assert!(ends.windows(2).all(|pair| pair[0] < pair[1]));
            }
        }
    }
}
