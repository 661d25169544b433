//! Unions of many solids: a ray asks only those operands whose boxes it meets.
//!
//! The operands of a union are folded from the left into pairs, so that a ray would come past all of them. A hierarchy over
//! their boxes finds the few that it can meet; combined in the same order they give the same list, for the union with an
//! empty list changes nothing.

use super::{Course, Extent, Hierarchy, Node};
use crate::record::Operator;

/// A hierarchy over the operands of a union.
#[derive(Clone, Debug, PartialEq)]
pub struct WideUnion {
    hierarchy: Hierarchy,
    /// The nodes of the operands that have a box, from left to right.
    bounded: Vec<usize>,
    /// Those that have none.
    unbounded: Vec<usize>,
}

/// Operands from which a hierarchy pays. For fewer their own boxes are tested in less time.
const WIDE: usize = 8;

impl WideUnion {
    /// The unions of many in a tree, each with its topmost node.
    #[must_use]
    pub fn all_in(nodes: &[Node]) -> Vec<(usize, Self)> {
        // A union that is the left side of another one is a part of that one's chain.
        let mut is_continued = vec![false; nodes.len()];
        nodes.iter().filter_map(union).for_each(|[left, _]| is_continued[left] = true);
        let tops = (0..nodes.len()).filter(|&index| union(&nodes[index]).is_some() && !is_continued[index]);
        let with_operands = tops.map(|top| (top, operands(nodes, top)));
        with_operands.filter(|(_, all)| all.len() >= WIDE).map(|(top, all)| (top, Self::new(nodes, all))).collect()
    }

    fn new(nodes: &[Node], operands: Vec<usize>) -> Self {
        let extent = |index: &usize| nodes[*index].enclosure().extent;
        let (bounded, unbounded): (Vec<_>, Vec<_>) = operands.into_iter().partition(|index| extent(index).is_finite());
        let extents: Vec<Extent> = bounded.iter().map(extent).collect();
        Self { hierarchy: Hierarchy::new(&extents), bounded, unbounded }
    }

    /// The nodes that the ray's line may meet, from left to right.
    #[must_use]
    pub fn reached(&self, course: &Course) -> Vec<usize> {
        let items = self.hierarchy.reached(course, |_, _, _| ());
        let mut nodes: Vec<_> = items.into_iter().map(|item| self.bounded[item]).collect();
        nodes.extend(&self.unbounded);
        nodes.sort_unstable();
        nodes
    }
}

/// The two sides of a union.
fn union(node: &Node) -> Option<[usize; 2]> {
    match node {
        Node::Pair { operator: Operator::Union, left, right, .. } => Some([*left, *right]),
        _ => None,
    }
}

/// What a chain of unions joins, from left to right.
fn operands(nodes: &[Node], top: usize) -> Vec<usize> {
    let (mut operands, mut first) = (Vec::new(), top);
    while let Some([left, right]) = union(&nodes[first]) {
        operands.push(right);
        first = left;
    }
    operands.push(first);
    operands.reverse();
    operands
}

#[cfg(test)]
mod tests {
    use super::super::{Leaf, Placement, Solid};
    use super::*;
    use crate::record::NullRecorder;
    use crate::shape::{Plane, Shape, Sphere};
    use glam::{DAffine3, DVec3};
    use proptest::prelude::*;

    fn placed(shape: Shape, at: DVec3) -> Solid {
        Solid::leaf(Leaf::new("leaf", shape, Placement::new(DAffine3::from_translation(at)).unwrap()))
    }

    /// Spheres, some of which overlap, and below them a half-space.
    fn union_of(places: &[DVec3]) -> Solid {
        let floor = placed(Shape::Plane(Plane::new().unwrap()), DVec3::new(0.0, 0.0, -20.0));
        places.iter().fold(floor, |all, &at| {
            Solid::pair("union", Operator::Union, all, placed(Shape::Sphere(Sphere::new().unwrap()), at))
        })
    }

    proptest! {
        #[test]
        fn a_hierarchy_changes_no_list(
            places in prop::collection::vec(prop::array::uniform3(-9.0..9.0_f64), 7..40),
            origin in prop::array::uniform3(-15.0..15.0_f64), aim in prop::array::uniform3(-9.0..9.0_f64),
        ) {
            let places: Vec<DVec3> = places.into_iter().map(DVec3::from_array).collect();
            let (origin, aim) = (DVec3::from_array(origin), DVec3::from_array(aim));
            let plain = union_of(&places);
            let wide = plain.clone().with_wide_unions();
            let list = |solid: &Solid| solid.inside::<f64>(origin, aim - origin, &mut NullRecorder);
            prop_assert_eq!(list(&wide), list(&plain));
            prop_assert!(!list(&wide).is_empty());
        }
    }

    #[test]
    fn only_the_topmost_union_of_a_chain_has_a_hierarchy() {
        let places: Vec<DVec3> = (0..12).map(|k| DVec3::X * f64::from(k)).collect();
        let solid = union_of(&places);
        let all = WideUnion::all_in(&solid.nodes);
        assert_eq!(all.len(), 1);
        let (top, wide) = &all[0];
        assert_eq!((*top, wide.bounded.len(), wide.unbounded.len()), (solid.nodes.len() - 1, 12, 1));
        assert!(WideUnion::all_in(&union_of(&places[..6]).nodes).is_empty());
    }
}
