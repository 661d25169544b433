//! The scene as lines in space: the shapes' outlines as far as they lie on their solids, and the creases where two surfaces of
//! a solid meet. Made once for a scene, projected as often as somebody looks from elsewhere.

mod crease;
mod membership;
#[cfg(test)]
mod tests;

use crate::csg::{Extent, Leaf, Solid};
use crate::scene::Scene;
use crate::shape::{Primitive, Shape};
use glam::DVec3;
use membership::Membership;

/// Points of all lines together. More would take longer than a frame to project; fewer would show corners on the circles of
/// scenes with a few dozen shapes.
const MOST_POINTS: usize = 40_000;
/// A shape that has fewer points than these is shown by its box.
const FEWEST_POINTS: usize = 40;
/// Parts into which a straight edge is divided where something may be cut off it.
const EDGE_PARTS: u32 = 16;

/// A line on the surface of an object.
#[derive(Clone, Debug, PartialEq)]
pub struct WireLine {
    /// The object, by its place in the list.
    pub object: usize,
    /// The points, in world space.
    pub points: Vec<DVec3>,
    /// For each point the outward unit normals of the surfaces that meet there; twice the same where there is one.
    pub normals: Vec<[DVec3; 2]>,
    /// Whether two surfaces of a compound meet there.
    pub is_crease: bool,
}

/// All lines of a scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wireframe {
    /// The lines.
    pub lines: Vec<WireLine>,
    /// The corners of the box that holds them; of a scene without lines both are the origin.
    pub bounds: [DVec3; 2],
}

impl Wireframe {
    /// The lines of a scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let leaves: usize = scene.objects.iter().map(|object| object.solid.leaves.len()).sum();
        let budget = MOST_POINTS / leaves.max(1);
        let mut lines = Vec::new();
        for (object, solid) in scene.objects.iter().map(|object| &object.solid).enumerate() {
            if budget < FEWEST_POINTS {
                lines.extend(box_edges(object, solid.extent()));
            } else {
                lines.extend(solid_lines(object, solid, budget));
            }
        }
        let points = || lines.iter().flat_map(|line| &line.points);
        let low = points().copied().reduce(DVec3::min).unwrap_or_default();
        let high = points().copied().reduce(DVec3::max).unwrap_or_default();
        Self { lines, bounds: [low, high] }
    }

    /// How many points there are to project.
    #[must_use]
    pub fn len(&self) -> usize {
        self.lines.iter().map(|line| line.points.len()).sum()
    }

    /// Whether there is nothing to show.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }
}

fn solid_lines(object: usize, solid: &Solid, budget: usize) -> Vec<WireLine> {
    let membership = Membership::of(solid);
    let mut lines = Vec::new();
    for (index, leaf) in solid.leaves.iter().enumerate() {
        for line in outline(leaf, budget, solid.leaves.len() > 1) {
            lines.extend(membership.on_surface(object, index, &line));
        }
    }
    if solid.leaves.len() > 1 {
        lines.extend(crease::creases(object, &membership));
    }
    lines
}

/// A leaf's outline in world space with at most so many points, its straight edges divided where they may be cut.
fn outline(leaf: &Leaf, budget: usize, is_cut: bool) -> Vec<Vec<DVec3>> {
    let map = leaf.placement.world_from_generic();
    let lines = leaf.shape.outline();
    let count: usize = lines.iter().map(Vec::len).sum();
    let stride = count.div_ceil(budget.max(1)).max(1);
    let world = |line: &Vec<DVec3>| {
        let last = line.len().saturating_sub(1);
        let kept = line.iter().enumerate().filter(|(i, _)| i % stride == 0 || *i == last);
        let points: Vec<DVec3> = kept.map(|(_, point)| map.transform_point3(*point)).collect();
        if is_cut && stride == 1 { divided(&points) } else { points }
    };
    lines.iter().map(world).filter(|line| line.len() > 1 && line.iter().all(|point| point.is_finite())).collect()
}

/// A line of few points with points between them.
fn divided(points: &[DVec3]) -> Vec<DVec3> {
    if points.len() > EDGE_PARTS as usize {
        return points.to_vec();
    }
    let parts = |ends: &[DVec3]| {
        let [from, to] = [ends[0], ends[1]];
        (0..EDGE_PARTS).map(move |i| from.lerp(to, f64::from(i) / f64::from(EDGE_PARTS)))
    };
    points.windows(2).flat_map(parts).chain(points.last().copied()).collect()
}

/// The twelve edges of a box; none of one without bounds.
fn box_edges(object: usize, extent: Extent) -> Vec<WireLine> {
    if !extent.is_finite() {
        return Vec::new();
    }
    let corners = extent.corners();
    let middle = (extent.low + extent.high) * 0.5;
    let edge = |a: usize, b: usize| {
        let points = vec![corners[a], corners[b]];
        let outward = ((corners[a] + corners[b]) * 0.5 - middle).normalize_or(DVec3::Z);
        WireLine { object, normals: vec![[outward; 2]; 2], points, is_crease: false }
    };
    let mut edges = Vec::new();
    for a in 0..8_usize {
        for b in a + 1..8 {
            let differing = (corners[a] - corners[b]).to_array().into_iter().filter(|x| *x != 0.0).count();
            if differing == 1 {
                edges.push(edge(a, b));
            }
        }
    }
    edges
}

/// Whether a leaf bounds a solid; the square does not.
fn bounds_something(leaf: &Leaf) -> bool {
    !matches!(leaf.shape, Shape::Square(_))
}
