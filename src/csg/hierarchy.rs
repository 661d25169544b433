//! A tree of boxes over many boxes: a ray that misses a box is spared all that is in it (§ 6.5.4, taken further).
//!
//! Each node holds the boxes of up to eight children side by side, so that one pass over them tests all eight, in the
//! vector registers where there are some. Where to cut is chosen by the surface area heuristic with bins.
//!
//! **Source** I. Wald, "On fast construction of SAH-based bounding volume hierarchies", IEEE Symposium on Interactive
//! Ray Tracing (2007); many children: H. Dammertz et al., "Shallow bounding volume hierarchies for fast SIMD ray tracing of
//! incoherent rays", EGSR (2008).
//!
//! The crates for such trees work in single precision or do not widen their boxes by what rounding can do; a box here must
//! never lose a hit that the solver behind it would find, so it is written for [`Course`].

use super::course::Slabs;
use super::{Course, Extent};
use arrayvec::ArrayVec;
use glam::DVec3;
use wide::f64x8;

/// Children of a node.
const WIDTH: usize = 8;

/// A tree over boxes that are numbered from 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hierarchy {
    nodes: Vec<Node>,
}

/// Up to eight boxes side by side.
#[derive(Clone, Debug, PartialEq)]
struct Node {
    /// For each axis the low, then the high sides.
    sides: [[f64x8; 2]; 3],
    children: [Child; WIDTH],
}

/// An item, or another node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Child(u32);

/// What is behind a box.
enum Behind {
    Item(usize),
    Node(usize),
}

impl Child {
    const ITEM: u32 = 1 << 31;
    const NONE: Self = Self(Self::ITEM - 1);

    #[expect(clippy::cast_possible_truncation, reason = "a scene with 2³¹ objects does not fit into memory")]
    const fn item(index: usize) -> Self {
        Self(index as u32 | Self::ITEM)
    }

    #[expect(clippy::cast_possible_truncation, reason = "there are fewer nodes than items")]
    const fn node(index: usize) -> Self {
        Self(index as u32)
    }

    #[inline]
    const fn behind(self) -> Behind {
        if self.0 & Self::ITEM == 0 {
            Behind::Node(self.0 as usize)
        } else {
            Behind::Item((self.0 & !Self::ITEM) as usize)
        }
    }
}

impl Node {
    fn empty() -> Self {
        Self {
            sides: [[f64x8::splat(f64::INFINITY), f64x8::splat(f64::NEG_INFINITY)]; 3],
            children: [Child::NONE; WIDTH],
        }
    }

    fn set(&mut self, place: usize, extent: &Extent, child: Child) {
        for axis in 0..3 {
            self.sides[axis][0].as_mut_array()[place] = extent.low[axis];
            self.sides[axis][1].as_mut_array()[place] = extent.high[axis];
        }
        self.children[place] = child;
    }

    fn extent(&self, place: usize) -> Extent {
        let corner =
            |side: usize| DVec3::from_array(std::array::from_fn(|axis| self.sides[axis][side].to_array()[place]));
        Extent { low: corner(0), high: corner(1) }
    }

    /// The times of all eight boxes, none before 0; an empty box is left before it is entered.
    #[inline]
    fn times(&self, slabs: &Slabs) -> [f64x8; 2] {
        let (mut t_in, mut t_out) = (f64x8::ZERO, f64x8::splat(f64::INFINITY));
        for axis in 0..3 {
            let [low, high] = self.sides[axis];
            let (near, far) = if slabs.backwards[axis] { (high, low) } else { (low, high) };
            let per_direction = f64x8::splat(slabs.per_direction[axis]);
            let near = (near - f64x8::splat(slabs.near_start[axis])) * per_direction;
            let far = (far - f64x8::splat(slabs.far_start[axis])) * per_direction;
            // What is not a number (0 · ∞, for a ray that lies in a side) is passed over by both comparisons.
            t_in = near.simd_gt(t_in).select(near, t_in);
            t_out = far.simd_lt(t_out).select(far, t_out);
        }
        let widening = f64x8::splat(slabs.widening);
        [t_in - widening * t_in.abs(), t_out + widening * t_out.abs()]
    }

    /// The nearest child that the ray meets before the limit; the others are put on the pile, the nearest on top.
    #[inline]
    fn open(&self, slabs: &Slabs, limit: f64, waiting: &mut Pile) -> Option<Child> {
        let [t_in, t_out] = self.times(slabs);
        // All eight answers at once: a branch for each would be guessed wrong too often.
        let mut met = (t_in.simd_le(t_out) & t_in.simd_le(f64x8::splat(limit))).to_bitmask();
        let (t_in, base) = (t_in.to_array(), waiting.len());
        while met != 0 {
            let place = met.trailing_zeros() as usize;
            met &= met - 1;
            waiting.push((t_in[place], self.children[place]));
            let mut k = waiting.len() - 1;
            while k > base && waiting[k - 1].0 < waiting[k].0 {
                waiting.swap(k - 1, k);
                k -= 1;
            }
        }
        if waiting.len() > base { waiting.pop().map(|(_, child)| child) } else { None }
    }
}

/// A child that waits for its turn, and when the ray comes to it.
type Waiting = (f64, Child);

/// Room for the children of as many levels as there can be: those with a chosen cut, and those that halve 2³¹ items
/// thrice each.
type Pile = ArrayVec<Waiting, { (DEEPEST_CHOICE as usize + 12) * WIDTH }>;

impl Hierarchy {
    /// The tree over these boxes.
    #[must_use]
    pub fn new(extents: &[Extent]) -> Self {
        let mut nodes = Vec::new();
        let mut order: Vec<u32> = (0..).take(extents.len()).collect();
        if !order.is_empty() {
            let centres: Vec<DVec3> = extents.iter().map(|extent| extent.low + extent.high).collect();
            Builder { extents, centres: &centres, nodes: &mut nodes }.node(&mut order, 0);
        }
        Self { nodes }
    }

    /// Shows the items whose boxes the ray meets at t ≥ 0 to `visit`, the nearest boxes first, until the boxes that are left
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
                Behind::Node(index) => self.nodes[index].open(slabs, limit, &mut waiting),
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

/// Makes the nodes.
struct Builder<'a> {
    extents: &'a [Extent],
    /// Twice the middles of the boxes.
    centres: &'a [DVec3],
    nodes: &'a mut Vec<Node>,
}

/// Places to cut, along each axis. Fewer miss good cuts; more take longer than they save.
const BINS: usize = 16;

/// Depth from which cuts go through the middle of the list. A deeper tree could come only from boxes that the heuristic
/// peels off one by one, and would make the walk, and this recursion, as long as their list.
const DEEPEST_CHOICE: u32 = 24;

impl Builder<'_> {
    /// Makes a node over some items, and all below it; returns its place.
    fn node(&mut self, items: &mut [u32], depth: u32) -> usize {
        let place = self.nodes.len();
        self.nodes.push(Node::empty());
        for (k, part) in self.eight_parts(items, depth).into_iter().enumerate() {
            let extent = part.iter().fold(Extent::EMPTY, |all, &item| all.joined(self.extents[item as usize]));
            let child = match part {
                [] => continue,
                [item] => Child::item(*item as usize),
                _ => Child::node(self.node(part, depth + 1)),
            };
            self.nodes[place].set(k, &extent, child);
        }
        place
    }

    /// Cuts thrice.
    fn eight_parts<'b>(&self, items: &'b mut [u32], depth: u32) -> [&'b mut [u32]; WIDTH] {
        let [left, right] = self.two_parts(items, depth);
        let [[a, b], [c, d]] = [left, right].map(|half| self.two_parts(half, depth));
        let [[a, b], [c, d], [e, f], [g, h]] = [a, b, c, d].map(|quarter| self.two_parts(quarter, depth));
        [a, b, c, d, e, f, g, h]
    }

    /// Cuts where the surface area heuristic says so; one item stays alone.
    fn two_parts<'b>(&self, items: &'b mut [u32], depth: u32) -> [&'b mut [u32]; 2] {
        let middle = items.len().div_ceil(2);
        let cut = if items.len() <= 2 || depth > DEEPEST_CHOICE { None } else { self.best_cut(items) };
        let at = cut.map_or(middle, |cut| {
            let mut at = 0;
            for k in 0..items.len() {
                if cut.is_left(self.centres[items[k] as usize]) {
                    items.swap(k, at);
                    at += 1;
                }
            }
            at
        });
        let (left, right) = items.split_at_mut(if at == 0 || at == items.len() { middle } else { at });
        [left, right]
    }

    /// The cut with the smallest n_left · area_left + n_right · area_right; none where all middles are the same.
    fn best_cut(&self, items: &[u32]) -> Option<Cut> {
        let spread = items.iter().fold(Extent::EMPTY, |all, &item| {
            let centre = self.centres[item as usize];
            all.joined(Extent { low: centre, high: centre })
        });
        let cuts = (0..3).filter_map(|axis| self.best_cut_along(items, axis, &spread));
        cuts.min_by(|a, b| a.cost.total_cmp(&b.cost))
    }

    fn best_cut_along(&self, items: &[u32], axis: usize, spread: &Extent) -> Option<Cut> {
        let (low, width) = (spread.low[axis], spread.high[axis] - spread.low[axis]);
        let per_width = BINS as f64 / width;
        if !(width > 0.0 && per_width.is_finite()) {
            return None;
        }
        let cut = Cut { axis, low, per_width, bin: 0, cost: f64::INFINITY };
        let mut bins = [(0_usize, Extent::EMPTY); BINS];
        for &item in items {
            let (count, extent) = &mut bins[cut.bin_of(self.centres[item as usize])];
            *count += 1;
            *extent = extent.joined(self.extents[item as usize]);
        }
        let join = |a: (usize, Extent), b: &(usize, Extent)| (a.0 + b.0, a.1.joined(b.1));
        let weight =
            |(count, extent): (usize, Extent)| if count == 0 { 0.0 } else { count as f64 * extent.half_surface() };
        let mut rights = [0.0; BINS];
        let mut right = (0, Extent::EMPTY);
        for bin in (1..BINS).rev() {
            right = join(right, &bins[bin]);
            rights[bin] = weight(right);
        }
        let mut left = (0, Extent::EMPTY);
        (1..BINS)
            .map(|bin| {
                left = join(left, &bins[bin - 1]);
                Cut { bin, cost: weight(left) + rights[bin], ..cut }
            })
            .min_by(|a, b| a.cost.total_cmp(&b.cost))
    }
}

/// A plane between two bins.
#[derive(Clone, Copy)]
struct Cut {
    axis: usize,
    low: f64,
    per_width: f64,
    /// The first bin on the right.
    bin: usize,
    cost: f64,
}

impl Cut {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to BINS")]
    fn bin_of(&self, centre: DVec3) -> usize {
        (((centre[self.axis] - self.low) * self.per_width) as usize).min(BINS - 1)
    }

    fn is_left(&self, centre: DVec3) -> bool {
        self.bin_of(centre) < self.bin
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
