//! Which points lie in a solid, and which of a leaf's points lie on the solid's surface.

use super::{WireLine, bounds_something};
use crate::csg::{Leaf, Node, Solid};
use crate::math::portable;
use crate::record::Operator;
use crate::shape::Primitive;
use glam::DVec3;

/// Halvings of the stretch on which a line leaves the surface: its end is found to a millionth of the stretch.
const HALVINGS: u32 = 20;

/// Surfaces lie in the same place where they are so close, as a part of a leaf's size. Larger, and thin walls are taken for nothing;
/// smaller, and rounding decides which of two equal surfaces is seen.
const SAME_PLACE: f64 = 1e-6;
/// The cosine of the angle between surfaces that lie in the same place. Smaller, and edges are taken for faces; larger, and the
/// differences that gradients are made of are too coarse.
const SAME_WAY: f64 = 0.999;
/// Where F is larger, no surface is near: F changes by about as much as the place does.
const FAR: f64 = 1e-3;

/// A solid, asked point by point.
pub(super) struct Membership<'a> {
    pub solid: &'a Solid,
}

impl<'a> Membership<'a> {
    pub const fn of(solid: &'a Solid) -> Self {
        Self { solid }
    }

    /// F of a leaf at a point of the world.
    pub fn value(&self, leaf: usize, point: DVec3) -> f64 {
        value(&self.solid.leaves[leaf], point)
    }

    /// ∇F of a leaf in world space, by differences over a small part of its size.
    pub fn gradient(&self, leaf: usize, point: DVec3) -> DVec3 {
        let step = 1e-6 * self.scale(leaf);
        let slope = |axis: DVec3| {
            (self.value(leaf, point + axis * step) - self.value(leaf, point - axis * step)) / (2.0 * step)
        };
        DVec3::new(slope(DVec3::X), slope(DVec3::Y), slope(DVec3::Z))
    }

    /// The length of a generic unit in the world.
    pub fn scale(&self, leaf: usize) -> f64 {
        portable::cbrt(self.solid.leaves[leaf].placement.world_from_generic().matrix3.determinant().abs()).max(1e-12)
    }

    /// Whether the solid holds the point, were these leaves to hold it or not.
    pub fn holds_with(&self, point: DVec3, given: &[(usize, bool)]) -> bool {
        self.holds(self.solid.nodes.len() - 1, point, given)
    }

    fn holds(&self, node: usize, point: DVec3, given: &[(usize, bool)]) -> bool {
        match &self.solid.nodes[node] {
            Node::Leaf { leaf, enclosure } => match given.iter().find(|(other, _)| other == leaf) {
                Some((_, holds)) => *holds,
                None => enclosure.extent.holds(point) && self.value(*leaf, point) < 0.0,
            },
            Node::Pair { operator, left, right, .. } => {
                let first = self.holds(*left, point, given);
                match operator {
                    Operator::Union => first || self.holds(*right, point, given),
                    Operator::Intersection => first && self.holds(*right, point, given),
                    Operator::Difference => first && !self.holds(*right, point, given),
                }
            }
        }
    }

    /// How a leaf's surface bounds the solid at a point of it: 1 where its normal is the solid's, −1 where it is turned round, 0
    /// where it bounds nothing.
    pub fn side(&self, leaf: usize, point: DVec3) -> f64 {
        let shared = self.shared_with(leaf, point);
        let holds_where = |is_inside: bool| {
            let others = shared.iter().map(|(other, is_alike)| (*other, *is_alike == is_inside));
            let given: Vec<(usize, bool)> = std::iter::once((leaf, is_inside)).chain(others).collect();
            self.holds_with(point, &given)
        };
        f64::from(i8::from(holds_where(true))) - f64::from(i8::from(holds_where(false)))
    }

    /// The other leaves whose surfaces lie in the same place as this one's, and whether they have their inside on the same side of it:
    /// of those rounding alone would say which holds the point.
    fn shared_with(&self, leaf: usize, point: DVec3) -> Vec<(usize, bool)> {
        let is_other = |other: &usize| *other != leaf && bounds_something(&self.solid.leaves[*other]);
        let shared = |other: usize| {
            if self.value(other, point).abs() > FAR || !self.lies_on(other, point) {
                return None;
            }
            let [own, others] = [leaf, other].map(|leaf| self.gradient(leaf, point).normalize_or_zero());
            let cosine = own.dot(others);
            (cosine.abs() > SAME_WAY).then_some((other, cosine > 0.0))
        };
        (0..self.solid.leaves.len()).filter(is_other).filter_map(shared).collect()
    }

    /// The parts of a line on a leaf's surface that lie on the solid's.
    pub fn on_surface(&self, object: usize, leaf: usize, line: &[DVec3]) -> Vec<WireLine> {
        let is_bounding = bounds_something(&self.solid.leaves[leaf]);
        let side = |point: DVec3| if is_bounding { self.side(leaf, point) } else { 1.0 };
        let mut runs: Vec<Vec<(DVec3, f64)>> = vec![Vec::new()];
        let mut before: Option<(DVec3, f64)> = None;
        for &point in line {
            let now = side(point);
            if let Some((last, then)) = before.filter(|(_, then)| (*then == 0.0) != (now == 0.0)) {
                let end = self.end(leaf, [last, point], then == 0.0);
                let there = if then == 0.0 { now } else { then };
                if then == 0.0 {
                    runs.push(vec![(end, there)]);
                } else if let Some(run) = runs.last_mut() {
                    run.push((end, there));
                }
            }
            if now != 0.0
                && let Some(run) = runs.last_mut()
            {
                run.push((point, now));
            }
            before = Some((point, now));
        }
        let line = |run: Vec<(DVec3, f64)>| WireLine {
            object,
            normals: run.iter().map(|(point, side)| self.normals(leaf, *point).map(|normal| normal * *side)).collect(),
            points: run.into_iter().map(|(point, _)| point).collect(),
            is_crease: false,
        };
        runs.into_iter().filter(|run| run.len() > 1).map(line).collect()
    }

    /// The place between two points at which a leaf's surface begins or ends to bound the solid.
    fn end(&self, leaf: usize, [mut from, mut to]: [DVec3; 2], begins: bool) -> DVec3 {
        let reach = from.distance(to);
        for _ in 0..HALVINGS {
            let halfway = from.midpoint(to);
            let middle = self.settled(leaf, halfway);
            // At the tip of a star the gradient vanishes, and Newton's method leads anywhere.
            if middle.distance(halfway) > reach || !self.lies_on(leaf, middle) {
                break;
            }
            if (self.side(leaf, middle) != 0.0) == begins {
                to = middle;
            } else {
                from = middle;
            }
        }
        // The end that still lies on the surface.
        if begins { to } else { from }
    }

    /// Whether a point lies on a leaf's surface.
    fn lies_on(&self, leaf: usize, point: DVec3) -> bool {
        self.value(leaf, point).abs() <= SAME_PLACE * self.scale(leaf) * self.gradient(leaf, point).length()
    }

    /// The point on a leaf's surface next to one that lies close to it, by Newton's method along the gradient.
    fn settled(&self, leaf: usize, mut point: DVec3) -> DVec3 {
        for _ in 0..3 {
            let gradient = self.gradient(leaf, point);
            let shift = gradient * (self.value(leaf, point) / gradient.length_squared());
            if shift.is_finite() {
                point -= shift;
            }
        }
        point
    }

    /// Of the normals close to a point the two that are least alike: on an edge those of both faces.
    fn normals(&self, leaf: usize, point: DVec3) -> [DVec3; 2] {
        let step = 1e-3 * self.scale(leaf);
        let axes = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::NEG_X, DVec3::NEG_Y, DVec3::NEG_Z];
        let around = axes.map(|axis| self.gradient(leaf, point + axis * step).normalize_or_zero());
        let pairs = around.into_iter().flat_map(|first| around.map(|second| [first, second]));
        let least = pairs.min_by(|a, b| a[0].dot(a[1]).total_cmp(&b[0].dot(b[1])));
        least.unwrap_or([around[0]; 2])
    }
}

fn value(leaf: &Leaf, point: DVec3) -> f64 {
    leaf.shape.implicit(leaf.placement.generic_point(point))
}
