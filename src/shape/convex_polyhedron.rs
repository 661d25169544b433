//! A convex polyhedron: the points on the inner side of every one of some planes (§ 6.2.3).
//!
//! **Shape**
//! ```text
//!         ______
//!       /   \    \        as many planes as are given,
//!      /     \____\       numbered from 0
//!      \     /    /
//!       \___/____/
//! ```
//! **Equation** F = max over the planes of (n·p − d) / |n|.
//!
//! **Ray equation** For each plane t = (d − n·S) / n·c, entering where n·c < 0. The ray is inside from the latest entering
//! to the earliest leaving time.
//!
//! **Accuracy** See the header of `planes.rs`. The numerator cancels where the ray starts far away or near the plane, and
//! the denominator where the ray nearly runs along it: that is the hard case.
//!
//! **Degenerate cases** A ray in a face runs inside the closed solid. Rays that touch an edge or a vertex have no hits.
//! Planes that cut nothing off and planes given twice do no harm. No solid at all, and one without end, are refused.
//!
//! **Source** Cyrus and Beck, Computers & Graphics 3 (1978); Haines, Graphics Gems II, "Fast ray–convex polyhedron
//! intersection".

use super::boundary::Boundaries;
use super::planes::{self, Clip};
use super::solver::{self, Attempt, Call, Solver};
use super::{Approach, Bounds, Crossing, Crossings, GenericRay, Part, Primitive, outline, plane_table};
use crate::math::{DoubleDouble, Real, dot, scale_to_unit};
use crate::record::{Candidate, Entry, Recorder};
use glam::{DVec2, DVec3};

pub use super::planes::HalfSpace;

/// The points that lie inside all planes.
#[derive(Clone, Debug, PartialEq)]
pub struct ConvexPolyhedron {
    planes: Vec<HalfSpace>,
    edges: Vec<[DVec3; 2]>,
    bounds: Bounds,
}

impl ConvexPolyhedron {
    /// The solid inside these planes.
    ///
    /// # Errors
    /// Says so when a plane is none (zero normal, a number that is not finite), when the solid is unbounded, and when the
    /// planes leave no point, or none but a flat piece.
    pub fn new(planes: Vec<HalfSpace>) -> Result<Self, String> {
        for (k, plane) in planes.iter().enumerate() {
            if !plane.normal.is_finite() || !plane.offset.is_finite() {
                return Err(format!("plane {k} holds a number that is not finite"));
            }
            if plane.normal == DVec3::ZERO {
                return Err(format!("plane {k} has the normal (0, 0, 0); a plane needs a direction"));
            }
        }
        if planes.len() < 4 {
            let given = planes.len();
            return Err(format!("a convex polyhedron is unbounded with {given} planes; it needs 4 or more"));
        }
        if planes.len() > MOST_PLANES {
            let given = planes.len();
            return Err(format!("{given} planes were given; a convex polyhedron takes at most {MOST_PLANES}"));
        }
        if let Some(direction) = way_out(&planes) {
            let [x, y, z] = direction.to_array();
            return Err(format!(
                "the polyhedron is unbounded: no plane closes it in the direction ({x:.3}, {y:.3}, {z:.3})"
            ));
        }
        let edges = edges(&planes);
        let bounds = bounds(&edges);
        let shares =
            edges.iter().map(|[a, b]| (*a + *b, 2.0)).fold((DVec3::ZERO, 0.0), |sum, x| (sum.0 + x.0, sum.1 + x.1));
        let centre = shares.0 / shares.1;
        if edges.is_empty() || planes.iter().any(|plane| !surely_inside(plane, centre)) {
            return Err("the planes leave no solid: no point lies strictly inside all of them".to_owned());
        }
        Ok(Self { planes, edges, bounds })
    }

    /// The planes.
    #[must_use]
    pub fn planes(&self) -> &[HalfSpace] {
        &self.planes
    }
}

/// More planes than this would take seconds to check, for the work grows with the cube of their number.
const MOST_PLANES: usize = 512;

fn wide(v: DVec3) -> [DoubleDouble; 3] {
    v.to_array().map(DoubleDouble::from_f64)
}

fn cross<A: Real>(a: [A; 3], b: [A; 3]) -> [A; 3] {
    let minor = |i: usize, j: usize| A::difference_of_products(a[i], b[j], a[j], b[i]);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// A direction in which one can go for ever without leaving, if there is one.
///
/// The directions v with n·v ≤ 0 for all n form a cone. If it is more than the point 0, then it has an edge along n × n′
/// for some pair of normals, or it is a whole line or plane, which all pairs of normals that span it find as well.
fn way_out(planes: &[HalfSpace]) -> Option<DVec3> {
    let unit: Vec<_> = planes.iter().map(|p| p.normal * scale_to_unit(p.normal.to_array())).collect();
    let mut spans_a_plane = false;
    for (i, a) in unit.iter().enumerate() {
        for b in &unit[..i] {
            let along = cross(wide(*a), wide(*b));
            let size = along.iter().map(|x| x.abs().to_f64()).fold(0.0, f64::max);
            if size < 16.0 * DoubleDouble::UNIT_ROUNDOFF {
                continue;
            }
            spans_a_plane = true;
            for direction in [along, along.map(|x| -x)] {
                if unit.iter().all(|normal| !rises(*normal, direction, size)) {
                    return Some(DVec3::from_array(direction.map(Real::to_f64)).normalize_or_zero());
                }
            }
        }
    }
    // All normals on one line: any direction across it.
    (!spans_a_plane).then(|| outline::across(unit[0]).0)
}

/// Whether n·v is above zero by more than rounding.
fn rises(normal: DVec3, direction: [DoubleDouble; 3], size: f64) -> bool {
    let rough = dot(normal.to_array(), direction.map(Real::to_f64));
    if rough.abs() > 32.0 * f64::EPSILON * size {
        return rough > 0.0;
    }
    dot(wide(normal), direction).to_f64() > 64.0 * DoubleDouble::UNIT_ROUNDOFF * size
}

/// Every edge: the piece inside all other planes of the line in which two planes meet.
fn edges(planes: &[HalfSpace]) -> Vec<[DVec3; 2]> {
    let mut edges: Vec<[DVec3; 2]> = Vec::new();
    for i in 0..planes.len() {
        for j in 0..i {
            let Some(line) = meeting_line(&planes[i], &planes[j]) else { continue };
            let others = planes.iter().copied().enumerate().filter(|(k, _)| *k != i && *k != j);
            // Most pairs meet far outside, which the fast arithmetic sees as well.
            let rough = planes::clip(&line.exactly::<f64>(), others.clone(), |_| ());
            if rough.decided && !rough.found.hits {
                continue;
            }
            let clip = planes::clip(&line, others, |_| ()).found;
            let (true, Some(from), Some(to)) = (clip.hits, clip.enter, clip.leave) else { continue };
            let edge = [from, to].map(|end| line.point(end.time));
            if !edges.iter().any(|known| same_edge(known, &edge)) {
                edges.push(edge);
            }
        }
    }
    edges
}

/// The line in which two planes meet, from its point nearest to the origin; none where they are parallel.
fn meeting_line(first: &HalfSpace, second: &HalfSpace) -> Option<GenericRay<'static, DoubleDouble>> {
    let scaled = |plane: &HalfSpace| {
        let scale = scale_to_unit(plane.normal.to_array());
        (wide(plane.normal * scale), DoubleDouble::from_f64(plane.offset * scale))
    };
    let ((n, d), (m, e)) = (scaled(first), scaled(second));
    let direction = cross(n, m);
    let length_squared = dot(direction, direction);
    if length_squared.to_f64() < DoubleDouble::UNIT_ROUNDOFF {
        return None;
    }
    let (by_first, by_second) = (cross(m, direction), cross(direction, n));
    let origin = std::array::from_fn(|k| (d * by_first[k] + e * by_second[k]) / length_squared);
    Some(GenericRay::wide(origin, direction))
}

/// Whether two edges are one, up to rounding and direction: planes given twice find an edge twice.
fn same_edge(a: &[DVec3; 2], b: &[DVec3; 2]) -> bool {
    let near = |p: DVec3, q: DVec3| (p - q).abs().max_element() <= 1e-12 * (1.0 + p.abs().max_element());
    (near(a[0], b[0]) && near(a[1], b[1])) || (near(a[0], b[1]) && near(a[1], b[0]))
}

fn bounds(edges: &[[DVec3; 2]]) -> Bounds {
    let corners = edges.iter().flatten();
    let empty = Bounds { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };
    let tight = corners.fold(empty, |b, p| Bounds { low: b.low.min(*p), high: b.high.max(*p) });
    // The corners are rounded to the nearest numbers; a step out holds the true ones.
    let step = tight.low.abs().max(tight.high.abs()) * (2.0 * f64::EPSILON);
    Bounds { low: tight.low - step, high: tight.high + step }
}

fn surely_inside(plane: &HalfSpace, point: DVec3) -> bool {
    let products = plane.normal * point;
    let doubt = 8.0 * f64::EPSILON * (products.abs().element_sum() + plane.offset.abs());
    plane.offset - products.element_sum() > doubt
}

impl Solver for ConvexPolyhedron {
    type Found<A: Real> = Clip<A>;

    fn solve<A: Real>(&self, ray: &GenericRay<A>) -> Attempt<Clip<A>> {
        planes::clip(ray, self.planes.iter().copied().enumerate(), |_| ())
    }

    fn closest_call<A: Real>(&self, ray: &GenericRay<A>, clip: &Clip<A>) -> Call {
        clip.closest_call(ray, &self.planes)
    }

    fn roots<A: Real>(&self, ray: &GenericRay<A>, clip: &Clip<A>) -> impl Boundaries {
        clip.roots(ray, &self.planes)
    }

    fn working<A: Real>(&self, ray: &GenericRay<A>, _: &Clip<A>) -> Vec<Entry> {
        vec![plane_table::table(&self.planes, &self.parts(), ray)]
    }

    fn rejected<A: Real>(&self, ray: &GenericRay<A>, _: &Clip<A>, crossings: &[Crossing]) -> Vec<Candidate> {
        plane_table::rejected(self, &self.planes, ray, crossings)
    }
}

impl Primitive for ConvexPolyhedron {
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Crossings) {
        solver::crossings(self, ray, recorder, crossings);
    }

    #[inline]
    fn first_crossing<A: Real>(&self, approach: &impl Approach) -> Option<Crossing> {
        solver::first_crossing::<A>(self, approach)
    }

    fn normal(&self, _point: DVec3, part: Part) -> DVec3 {
        self.planes.get(usize::from(part)).map_or(DVec3::Z, |plane| plane.normal)
    }

    /// A frame in the face, so that the box of the solid fits within 0 to 1.
    fn uv(&self, point: DVec3, part: Part) -> DVec2 {
        let (right, up) = outline::across(self.normal(point, part));
        let size = (self.bounds.high - self.bounds.low).length();
        let from_centre = point - (self.bounds.low + self.bounds.high) * 0.5;
        (DVec2::new(right.dot(from_centre), up.dot(from_centre)) / size + 0.5).clamp(DVec2::ZERO, DVec2::ONE)
    }

    fn tangents(&self, point: DVec3, part: Part) -> [DVec3; 2] {
        let (right, up) = outline::across(self.normal(point, part));
        let size = (self.bounds.high - self.bounds.low).length();
        [right * size, up * size]
    }

    fn is_flat(&self, _part: Part) -> bool {
        true
    }

    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn outline(&self) -> Vec<Vec<DVec3>> {
        self.edges.iter().map(|edge| edge.to_vec()).collect()
    }

    fn implicit(&self, point: DVec3) -> f64 {
        let distance = |plane: &HalfSpace| {
            let scale = scale_to_unit(plane.normal.to_array());
            let normal = plane.normal * scale;
            (normal.dot(point) - plane.offset * scale) / normal.length()
        };
        self.planes.iter().map(distance).fold(f64::NEG_INFINITY, f64::max)
    }

    fn equation(&self) -> String {
        "max over the planes of (n·p − d) / |n|".to_owned()
    }

    fn parts(&self) -> Vec<String> {
        (0..self.planes.len()).map(|k| format!("plane {k}")).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::*;
    use super::*;

    impl Samples for ConvexPolyhedron {
        fn samples() -> Vec<Self> {
            let plane = |x, y, z, offset| HalfSpace { normal: DVec3::new(x, y, z), offset };
            let tetrahedron = vec![
                plane(1.0, 1.0, 1.0, 1.0),
                plane(-1.0, -1.0, 1.0, 1.0),
                plane(-1.0, 1.0, -1.0, 1.0),
                plane(1.0, -1.0, -1.0, 1.0),
            ];
            let wedge = vec![
                plane(0.0, 0.0, -2.0, 0.0),
                plane(3.0, 0.0, 4.0, 6.0),
                plane(-3.0, 0.0, 4.0, 6.0),
                plane(0.0, 1.0, 0.0, 1.5),
                plane(0.0, -1.0, 0.0, 0.5),
            ];
            [tetrahedron, wedge].map(|planes| Self::new(planes).unwrap()).to_vec()
        }
    }

    fn plane(x: f64, y: f64, z: f64, offset: f64) -> HalfSpace {
        HalfSpace { normal: DVec3::new(x, y, z), offset }
    }

    fn tetrahedron() -> Vec<HalfSpace> {
        vec![
            plane(1.0, 1.0, 1.0, 1.0),
            plane(-1.0, -1.0, 1.0, 1.0),
            plane(-1.0, 1.0, -1.0, 1.0),
            plane(1.0, -1.0, -1.0, 1.0),
        ]
    }

    #[test]
    fn a_ray_through_a_tetrahedron_enters_and_leaves() {
        // At x = 0.5, y = 0 the planes leave −0.5 ≤ z ≤ 0.5.
        let solid = ConvexPolyhedron::new(tetrahedron()).unwrap();
        expect(&solid, [0.5, 0.0, -2.0], [0.0, 0.0, 1.0], &[(1.5, Enter, "plane 3"), (2.5, Leave, "plane 0")]);
        expect(&solid, [0.5, 0.0, 0.0], [0.0, 0.0, 1.0], &[(-0.5, Enter, "plane 3"), (0.5, Leave, "plane 0")]);
        expect(&solid, [0.5, 0.0, 2.0], [0.0, 0.0, 1.0], &[(-2.5, Enter, "plane 3"), (-1.5, Leave, "plane 0")]);
        expect(&solid, [1.5, 0.0, -2.0], [0.0, 0.0, 1.0], &[]);
    }

    #[test]
    fn a_ray_that_touches_an_edge_or_a_vertex_has_no_hits() {
        // The edge from (1, −1, 1) to (−1, 1, 1), and the vertex (1, −1, 1).
        let solid = ConvexPolyhedron::new(tetrahedron()).unwrap();
        expect(&solid, [-3.0, -3.0, 1.0], [1.0, 1.0, 0.0], &[]);
        expect(&solid, [1.0, -1.0, -2.0], [0.0, 0.0, 1.0], &[]);
    }

    #[test]
    fn a_tetrahedron_has_six_edges_and_its_box() {
        let solid = ConvexPolyhedron::new(tetrahedron()).unwrap();
        assert_eq!(solid.outline().len(), 6);
        assert!((solid.bounds().high - DVec3::ONE).abs().max_element() < 1e-15);
        assert!((solid.bounds().low + DVec3::ONE).abs().max_element() < 1e-15);
    }

    #[test]
    fn planes_given_twice_and_planes_that_cut_nothing_do_no_harm() {
        let mut planes = tetrahedron();
        planes.extend([plane(2.0, 2.0, 2.0, 2.0), plane(0.0, 0.0, 1.0, 50.0)]);
        let solid = ConvexPolyhedron::new(planes).unwrap();
        assert_eq!(solid.outline().len(), 6);
        assert_eq!(hits(&solid, [0.5, 0.0, -2.0], [0.0, 0.0, 1.0]).len(), 2);
    }

    #[test]
    fn what_is_no_solid_is_refused_with_the_reason() {
        let refused = |planes: Vec<HalfSpace>| ConvexPolyhedron::new(planes).unwrap_err();
        assert_eq!(
            refused(tetrahedron()[..3].to_vec()),
            "a convex polyhedron is unbounded with 3 planes; it needs 4 or more"
        );
        let mut zero = tetrahedron();
        zero[2].normal = DVec3::ZERO;
        assert_eq!(refused(zero), "plane 2 has the normal (0, 0, 0); a plane needs a direction");
        let mut endless = tetrahedron();
        endless[3].offset = f64::INFINITY;
        assert_eq!(refused(endless), "plane 3 holds a number that is not finite");
        let tube = vec![
            plane(1.0, 0.0, 0.0, 1.0),
            plane(-1.0, 0.0, 0.0, 1.0),
            plane(0.0, 1.0, 0.0, 1.0),
            plane(0.0, -1.0, 0.0, 1.0),
        ];
        assert!(refused(tube.clone()).starts_with("the polyhedron is unbounded"));
        let half_tube = [tube, vec![plane(0.0, 0.0, 1.0, 1.0)]].concat();
        assert!(refused(half_tube.clone()).contains("direction (0.000, 0.000, -1.000)"));
        let layers = vec![
            plane(0.0, 0.0, 1.0, 1.0),
            plane(0.0, 0.0, 2.0, 1.0),
            plane(0.0, 0.0, -1.0, 1.0),
            plane(0.0, 0.0, -3.0, 1.0),
        ];
        assert!(refused(layers).starts_with("the polyhedron is unbounded"));
        let none = [half_tube.clone(), vec![plane(0.0, 0.0, -1.0, -2.0)]].concat();
        assert!(refused(none).starts_with("the planes leave no solid"));
        let flat = [half_tube, vec![plane(0.0, 0.0, -1.0, -1.0)]].concat();
        assert!(refused(flat).starts_with("the planes leave no solid"));
    }
}
