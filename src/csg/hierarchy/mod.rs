//! A tree of boxes over many boxes: a ray that misses a box is spared all that is in it (§ 6.5.4, taken further).
//!
//! Each node holds the boxes of up to eight children side by side, so that one pass over them tests all eight, in the
//! vector registers where there are some. Where to cut is chosen by the surface area heuristic with bins. Items that are round
//! have their balls side by side as well.
//!
//! **Source** I. Wald, "On fast construction of SAH-based bounding volume hierarchies", IEEE Symposium on Interactive
//! Ray Tracing (2007); many children: H. Dammertz et al., "Shallow bounding volume hierarchies for fast SIMD ray tracing of
//! incoherent rays", EGSR (2008).
//!
//! The crates for such trees work in single precision or do not widen their boxes by what rounding can do; a box here must
//! never lose a hit that the solver behind it would find, so it is written for [`Course`].

mod build;
mod node;

use super::{Ball, Course, Extent};
use arrayvec::ArrayVec;
use build::{DEEPEST_CHOICE, DEEPEST_HALVING, build};
use node::{Balls, Behind, Child, Node, WIDTH};

/// A tree over boxes that are numbered from 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hierarchy {
    nodes: Vec<Node>,
    /// Of those nodes that have round children.
    balls: Vec<Balls>,
}

/// A child that waits for its turn, and when the ray comes to it.
type Waiting = (f64, Child);

/// Room for the children of as many levels as there can be.
type Pile = ArrayVec<Waiting, { (DEEPEST_CHOICE + DEEPEST_HALVING) as usize * WIDTH }>;

impl Hierarchy {
    /// The tree over these boxes.
    #[must_use]
    pub fn new(extents: &[Extent]) -> Self {
        Self { nodes: build(extents), balls: Vec::new() }
    }

    /// The same tree, which also asks the balls of those items for which it gets one.
    #[must_use]
    #[expect(
        clippy::cast_possible_truncation,
        reason = "there are fewer nodes than items, of which there are less than 2³¹"
    )]
    pub fn with_balls(mut self, ball: impl Fn(usize) -> Option<Ball>) -> Self {
        for node in &mut self.nodes {
            if let Some(balls) = Balls::of(node, &ball) {
                node.balls = Some(self.balls.len() as u32);
                self.balls.push(balls);
            }
        }
        self
    }

    /// Shows the items whose boxes and balls the ray meets at t ≥ 0 to `visit`, the nearest boxes first, until the boxes that are left
    /// begin behind the limit. `visit` gets an item and the limit, and returns the limit from then on.
    #[inline]
    pub fn walk(&self, course: &Course, mut limit: f64, mut visit: impl FnMut(usize, f64) -> f64) {
        let (slabs, mut waiting) = (course.slabs(), Pile::new());
        let mut next = Some(Child::node(0)).filter(|_| !self.nodes.is_empty());
        while let Some(child) = next {
            next = match child.behind() {
                Behind::Item(item) => {
                    limit = visit(item, limit);
                    None
                }
                Behind::Node(index) => self.nodes[index].open(&self.balls, &course.line, slabs, limit, &mut waiting),
            };
            while next.is_none() {
                let Some((near, child)) = waiting.pop() else { return };
                next = (near <= limit).then_some(child);
            }
        }
    }

    /// The items that the whole line can meet, ascending: all that stand in a node whose box it meets, whatever their own
    /// boxes say. `told` hears of the box of every node that is come to, when the line is in it, and how many items it holds.
    pub fn reached(&self, course: &Course, mut told: impl FnMut(&Extent, Option<[f64; 2]>, usize)) -> Vec<usize> {
        let mut items = Vec::new();
        self.reach(0, course, &mut items, &mut told);
        items.sort_unstable();
        items
    }

    fn reach(
        &self,
        node: usize,
        course: &Course,
        items: &mut Vec<usize>,
        told: &mut impl FnMut(&Extent, Option<[f64; 2]>, usize),
    ) {
        let Some(open) = self.nodes.get(node) else { return };
        for (place, child) in open.children.iter().enumerate() {
            match child.behind() {
                Behind::Item(item) => items.push(item),
                Behind::Node(inner) if inner < self.nodes.len() => {
                    let extent = open.extent(place);
                    let inside = extent.inside(course);
                    told(&extent, inside, self.count(inner));
                    if inside.is_some() {
                        self.reach(inner, course, items, told);
                    }
                }
                Behind::Node(_) => {}
            }
        }
    }

    /// The number of items under a node.
    fn count(&self, node: usize) -> usize {
        let Some(open) = self.nodes.get(node) else { return 0 };
        let under = |child: &Child| match child.behind() {
            Behind::Item(_) => 1,
            Behind::Node(inner) => self.count(inner),
        };
        open.children.iter().map(under).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use proptest::prelude::*;

    fn any_extent() -> impl Strategy<Value = Extent> {
        (prop::array::uniform3(-10.0..10.0), prop::array::uniform3(0.0..2.0)).prop_map(
            |(low, size): ([f64; 3], [f64; 3])| {
                let low = DVec3::from_array(low);
                Extent { low, high: low + DVec3::from_array(size) }
            },
        )
    }

    fn any_course() -> impl Strategy<Value = Course> {
        (prop::array::uniform3(-12.0..12.0), prop::array::uniform3(-1.0..1.0))
            .prop_map(|(origin, direction)| Course::new(DVec3::from_array(origin), DVec3::from_array(direction), 1.0))
    }

    fn walked(hierarchy: &Hierarchy, course: &Course, limit: f64) -> Vec<usize> {
        let mut items = Vec::new();
        hierarchy.walk(course, limit, |item, limit| {
            items.push(item);
            limit
        });
        items.sort_unstable();
        items
    }

    proptest! {
        #[test]
        fn exactly_the_boxes_that_the_ray_meets_are_visited(
            extents in prop::collection::vec(any_extent(), 0..60), course in any_course(), limit in 0.0..30.0,
        ) {
            let hierarchy = Hierarchy::new(&extents);
            let ahead = |[t_in, t_out]: [f64; 2]| t_out >= 0.0 && t_in <= limit;
            let met: Vec<_> = (0..extents.len()).filter(|&k| extents[k].inside(&course).is_some_and(ahead)).collect();
            prop_assert_eq!(walked(&hierarchy, &course, limit), met);
        }

        #[test]
        fn of_round_items_those_are_visited_whose_balls_the_ray_meets_too(
            extents in prop::collection::vec(any_extent(), 0..60), course in any_course(),
        ) {
            // Every other item is round; its ball is the one within its box.
            let ball = |k: usize, factor: f64| {
                let radius = 0.5 * (extents[k].high - extents[k].low).min_element() * factor;
                Ball { centre: (extents[k].low + extents[k].high) * 0.5, radius }
            };
            let hierarchy = Hierarchy::new(&extents).with_balls(|k| k.is_multiple_of(2).then(|| ball(k, 1.0)));
            let visited = walked(&hierarchy, &course, f64::INFINITY);
            for k in walked(&Hierarchy::new(&extents), &course, f64::INFINITY) {
                let is_round = k.is_multiple_of(2);
                prop_assert!(visited.contains(&k) || is_round && ball(k, 1.0 - 1e-9).is_missed(&course));
                prop_assert!(!visited.contains(&k) || !is_round || !ball(k, 1.0 + 1e-9).is_missed(&course));
            }
            let blind = course.clone().testing_balls(false);
            prop_assert_eq!(walked(&hierarchy, &blind, f64::INFINITY), walked(&Hierarchy::new(&extents), &course, f64::INFINITY));
        }

        #[test]
        fn every_box_on_the_line_is_reached_and_the_counts_of_the_others_are_told(
            extents in prop::collection::vec(any_extent(), 0..60), course in any_course(),
        ) {
            let hierarchy = Hierarchy::new(&extents);
            let mut spared = 0;
            let reached = hierarchy.reached(&course, |_, inside, count| {
                spared += if inside.is_none() { count } else { 0 };
            });
            prop_assert_eq!(reached.len() + spared, extents.len());
            for (k, extent) in extents.iter().enumerate() {
                prop_assert!(extent.inside(&course).is_none() || reached.contains(&k));
            }
        }
    }

    #[test]
    fn boxes_in_the_same_place_are_all_kept() {
        let extents = vec![Extent { low: DVec3::NEG_ONE, high: DVec3::ONE }; 100];
        let course = Course::new(DVec3::new(-3.0, 0.0, 0.0), DVec3::X, 1.0);
        assert_eq!(walked(&Hierarchy::new(&extents), &course, f64::INFINITY).len(), 100);
    }

    #[test]
    fn boxes_that_shrink_towards_a_point_make_no_deep_tree() {
        let extents: Vec<_> = (0..1000)
            .map(|k| {
                let low = DVec3::splat(0.5_f64.powi(k));
                Extent { low, high: low * 1.5 }
            })
            .collect();
        let course = Course::new(DVec3::splat(-1.0), DVec3::ONE, 1.0);
        assert_eq!(walked(&Hierarchy::new(&extents), &course, f64::INFINITY).len(), 1000);
    }

    #[test]
    fn nearer_boxes_come_first_and_those_behind_the_limit_never() {
        let at = |x: f64| Extent { low: DVec3::new(x, -1.0, -1.0), high: DVec3::new(x + 1.0, 1.0, 1.0) };
        let extents: Vec<_> = [9.0, 3.0, 6.0, 0.0, 12.0, 15.0].map(at).to_vec();
        let course = Course::new(DVec3::new(-2.0, 0.0, 0.0), DVec3::X, 1.0);
        let mut order = Vec::new();
        Hierarchy::new(&extents).walk(&course, f64::INFINITY, |item, limit| {
            order.push(item);
            if item == 2 { 9.5 } else { limit }
        });
        assert_eq!(order, [3, 1, 2]);
    }
}
