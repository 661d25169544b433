//! How a tree is built: from the whole list downwards, each node as full as it can be.

use super::super::Extent;
use super::node::{Child, Node, WIDTH};
use arrayvec::ArrayVec;
use glam::DVec3;

/// The nodes of a tree over these boxes; the first one is its root.
pub(super) fn build(extents: &[Extent]) -> Vec<Node> {
    let mut nodes = Vec::new();
    let mut order: Vec<u32> = (0..).take(extents.len()).collect();
    if !order.is_empty() {
        let centres: Vec<DVec3> = extents.iter().map(|extent| extent.low + extent.high).collect();
        Builder { extents, centres: &centres, nodes: &mut nodes }.node(&mut order, 0);
    }
    nodes
}

/// Makes the nodes.
struct Builder<'a> {
    extents: &'a [Extent],
    /// Twice the middles of the boxes.
    centres: &'a [DVec3],
    nodes: &'a mut Vec<Node>,
}

/// Some items, and the box of all of them.
struct Part<'a> {
    items: &'a mut [u32],
    extent: Extent,
}

/// Places to cut, along each axis. Fewer miss good cuts; more take longer than they save.
const BINS: usize = 16;

/// Depth from which cuts go through the middle of the list. A deeper tree could come only from boxes that the heuristic
/// peels off one by one, and would make the walk, and this recursion, as long as their list.
pub(super) const DEEPEST_CHOICE: u32 = 24;

/// Levels below that: each of them at least halves what may be 2³¹ items.
pub(super) const DEEPEST_HALVING: u32 = 32;

impl Builder<'_> {
    /// Makes a node over some items, and all below it; returns its place.
    fn node(&mut self, items: &mut [u32], depth: u32) -> usize {
        let place = self.nodes.len();
        self.nodes.push(Node::empty());
        for (k, Part { items, extent }) in self.parts(items, depth).into_iter().enumerate() {
            let child = match items {
                [item] => Child::item(*item as usize),
                _ => Child::node(self.node(items, depth + 1)),
            };
            self.nodes[place].set(k, &extent, child);
        }
        place
    }

    /// The children of a node: its items where they fit into it, else what is left when the largest part is cut in two again
    /// and again.
    fn parts<'b>(&self, items: &'b mut [u32], depth: u32) -> ArrayVec<Part<'b>, WIDTH> {
        if items.len() <= WIDTH {
            return items.chunks_mut(1).map(|item| self.part(item)).collect();
        }
        let mut parts = ArrayVec::new();
        parts.push(self.part(items));
        while parts.len() < WIDTH {
            let to_cut = (0..parts.len()).filter(|&k| parts[k].items.len() > WIDTH);
            let size = |k: &usize| parts[*k].extent.half_surface();
            let Some(largest) = to_cut.max_by(|a, b| size(a).total_cmp(&size(b))) else { break };
            let halves = self.two_parts(parts.swap_remove(largest).items, depth);
            parts.extend(halves.map(|half| self.part(half)));
        }
        parts
    }

    fn part<'b>(&self, items: &'b mut [u32]) -> Part<'b> {
        let extent = items.iter().fold(Extent::EMPTY, |all, &item| all.joined(self.extents[item as usize]));
        Part { items, extent }
    }

    /// Cuts where the surface area heuristic says so.
    fn two_parts<'b>(&self, items: &'b mut [u32], depth: u32) -> [&'b mut [u32]; 2] {
        let middle = items.len().div_ceil(2);
        let cut = if depth > DEEPEST_CHOICE { None } else { self.best_cut(items) };
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

    /// The cut with the smallest n_left · area_left + n_right · area_right, n being the number of nodes that the items fill;
    /// none where all middles are the same.
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
        let weight = |(count, extent): (usize, Extent)| match count {
            0 => 0.0,
            _ => count.div_ceil(WIDTH) as f64 * extent.half_surface(),
        };
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
