//! A node: boxes and balls, eight side by side.
#![expect(
    clippy::inline_always,
    reason = "measured: what is side by side would go through memory on its way to a call"
)]

use super::super::course::Slabs;
use super::super::{Ball, Extent};
use super::Pile;
use glam::DVec3;
use wide::f64x8;

/// Children of a node.
pub(super) const WIDTH: usize = 8;

/// Up to eight boxes side by side.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Node {
    /// For each axis the low, then the high sides.
    sides: [[f64x8; 2]; 3],
    pub children: [Child; WIDTH],
    /// The places that are taken, as bits.
    filled: u32,
    /// The place of its balls, if children of it are round.
    pub balls: Option<u32>,
}

/// Up to eight balls side by side. Those of children that are not round hold everything.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Balls {
    centres: [f64x8; 3],
    radii: f64x8,
}

/// An item, or another node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Child(u32);

/// What is behind a box.
pub(super) enum Behind {
    Item(usize),
    Node(usize),
}

impl Child {
    const ITEM: u32 = 1 << 31;
    const NONE: Self = Self(Self::ITEM - 1);

    #[expect(clippy::cast_possible_truncation, reason = "a scene with 2³¹ objects does not fit into memory")]
    pub const fn item(index: usize) -> Self {
        Self(index as u32 | Self::ITEM)
    }

    #[expect(clippy::cast_possible_truncation, reason = "there are fewer nodes than items")]
    pub const fn node(index: usize) -> Self {
        Self(index as u32)
    }

    #[inline]
    pub const fn behind(self) -> Behind {
        if self.0 & Self::ITEM == 0 {
            Behind::Node(self.0 as usize)
        } else {
            Behind::Item((self.0 & !Self::ITEM) as usize)
        }
    }
}

impl Node {
    pub fn empty() -> Self {
        Self {
            sides: [[f64x8::splat(f64::INFINITY), f64x8::splat(f64::NEG_INFINITY)]; 3],
            children: [Child::NONE; WIDTH],
            filled: 0,
            balls: None,
        }
    }

    pub fn set(&mut self, place: usize, extent: &Extent, child: Child) {
        for axis in 0..3 {
            self.sides[axis][0].as_mut_array()[place] = extent.low[axis];
            self.sides[axis][1].as_mut_array()[place] = extent.high[axis];
        }
        self.children[place] = child;
        self.filled |= 1 << place;
    }

    pub fn extent(&self, place: usize) -> Extent {
        let corner =
            |side: usize| DVec3::from_array(std::array::from_fn(|axis| self.sides[axis][side].to_array()[place]));
        Extent { low: corner(0), high: corner(1) }
    }

    /// The times of all eight boxes, none before 0; an empty box is left before it is entered.
    #[inline(always)]
    fn times(&self, slabs: &Slabs) -> [f64x8; 2] {
        let [x, y, z]: [[f64x8; 2]; 3] = std::array::from_fn(|axis| {
            // Picked by its place: a branch would be guessed wrong at every other ray.
            let backwards = slabs.backwards[axis] & 1;
            let (near, far) = (self.sides[axis][backwards], self.sides[axis][1 - backwards]);
            let per_direction = f64x8::splat(slabs.per_direction[axis]);
            [
                (near - f64x8::splat(slabs.near_start[axis])) * per_direction,
                (far - f64x8::splat(slabs.far_start[axis])) * per_direction,
            ]
        });
        // What is not a number (0 · ∞, for a ray that lies in a side) is passed over, and perhaps what it is compared with first:
        // that lets a box be met that is missed, but not the other way round.
        let t_in = larger(larger(x[0], y[0]), larger(z[0], f64x8::ZERO));
        let t_out = smaller(smaller(x[1], y[1]), smaller(z[1], f64x8::splat(f64::INFINITY)));
        [t_in * f64x8::splat(1.0 - slabs.widening), t_out * f64x8::splat(1.0 + slabs.widening)]
    }

    /// The nearest child that the ray meets before the limit; the others are put on the pile, the nearest on top.
    #[inline(always)]
    pub fn open(
        &self,
        balls: &[Balls],
        line: &[DVec3; 2],
        slabs: &Slabs,
        limit: f64,
        waiting: &mut Pile,
    ) -> Option<Child> {
        let [t_in, t_out] = self.times(slabs);
        // All eight answers at once: a branch for each would be guessed wrong too often.
        let mut met = (t_in.simd_le(t_out) & t_in.simd_le(f64x8::splat(limit))).to_bitmask() & self.filled;
        if let Some(balls) = self.balls.map(|place| &balls[place as usize]) {
            met &= !balls.missed(line, slabs);
        }
        if met.count_ones() < 2 {
            return (met != 0).then(|| self.children[met.trailing_zeros() as usize % WIDTH]);
        }
        let t_in = t_in.to_array();
        let mut next = || {
            let place = met.trailing_zeros() as usize % WIDTH;
            met &= met - 1;
            (t_in[place], self.children[place])
        };
        let (first, second) = (next(), next());
        // Mostly there are two.
        let [nearer, farther] = if second.0 < first.0 { [second, first] } else { [first, second] };
        if met == 0 {
            waiting.push(farther);
            return Some(nearer.1);
        }
        let base = waiting.len();
        waiting.push(farther);
        waiting.push(nearer);
        while met != 0 {
            let place = met.trailing_zeros() as usize % WIDTH;
            met &= met - 1;
            let mut k = waiting.len();
            waiting.push((t_in[place], self.children[place]));
            while k > base && waiting[k - 1].0 < waiting[k].0 {
                waiting.swap(k - 1, k);
                k -= 1;
            }
        }
        waiting.pop().map(|(_, child)| child)
    }
}

impl Balls {
    /// The balls of a node's children, by `ball`; none where no child has one.
    pub fn of(node: &Node, ball: impl Fn(usize) -> Option<Ball>) -> Option<Self> {
        let balls = node.children.map(|child| match child.behind() {
            Behind::Item(item) => ball(item),
            Behind::Node(_) => None,
        });
        let centres = balls.map(|ball| ball.map_or(DVec3::ZERO, |ball| ball.centre));
        balls.iter().any(Option::is_some).then(|| Self {
            centres: std::array::from_fn(|axis| f64x8::new(centres.map(|centre| centre[axis]))),
            radii: f64x8::new(balls.map(|b| b.map_or(f64::INFINITY, |ball| ball.radius))),
        })
    }

    /// The balls that the ray's line surely misses, as bits: eight times [`Ball::is_missed`].
    #[inline(always)]
    fn missed(&self, line: &[DVec3; 2], slabs: &Slabs) -> u32 {
        let [origin, direction] = line.map(|v| v.to_array().map(f64x8::splat));
        let [x, y, z]: [f64x8; 3] = std::array::from_fn(|axis| self.centres[axis] - origin[axis]);
        let [u, v, w] = direction;
        let moment = [y * w - z * v, z * u - x * w, x * v - y * u];
        let square = moment[0] * moment[0] + moment[1] * moment[1] + moment[2] * moment[2];
        let reach =
            self.radii + f64x8::splat(slabs.slack) + f64x8::splat(slabs.widening) * (x.abs() + y.abs() + z.abs());
        square.simd_gt(reach * reach * f64x8::splat(slabs.per_reach)).to_bitmask()
    }
}

/// The larger numbers; `b` where one is none.
#[inline(always)]
fn larger(a: f64x8, b: f64x8) -> f64x8 {
    // The instruction of these processors does just that.
    if cfg!(target_arch = "x86_64") { a.fast_max(b) } else { a.simd_gt(b).select(a, b) }
}

/// The smaller numbers; `b` where one is none.
#[inline(always)]
fn smaller(a: f64x8, b: f64x8) -> f64x8 {
    if cfg!(target_arch = "x86_64") { a.fast_min(b) } else { a.simd_lt(b).select(a, b) }
}
