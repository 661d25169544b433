//! A flat part of a primitive's surface, as an affine map from its (u, v) to points and back.

use super::{Part, Primitive};
use glam::{DMat3, DVec2, DVec3};

/// A flat part: P(u, v) = P(0, 0) + u P_u + v P_v, in generic coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlatPart {
    /// P(0, 0), which need not be on the part.
    origin: DVec3,
    /// P_u and P_v.
    tangents: [DVec3; 2],
}

impl FlatPart {
    /// The map of a part; none where the part is curved, or no more than a point (the cap of a cone).
    #[must_use]
    pub fn of(shape: &impl Primitive, part: Part) -> Option<Self> {
        if !shape.is_flat(part) {
            return None;
        }
        let known = point_on(shape, part)?;
        let (uv, tangents) = (shape.uv(known, part), shape.tangents(known, part));
        let has_area = tangents[0].cross(tangents[1]) != DVec3::ZERO;
        has_area.then(|| Self { origin: known - tangents[0] * uv.x - tangents[1] * uv.y, tangents })
    }

    /// The point at (u, v), which may lie beyond the part's edges.
    #[must_use]
    pub fn point(&self, uv: DVec2) -> DVec3 {
        self.origin + self.tangents[0] * uv.x + self.tangents[1] * uv.y
    }

    /// When the line `origin` + `direction` t meets the plane of the part, and at what (u, v); none where it runs beside it.
    #[must_use]
    pub fn meet(&self, origin: DVec3, direction: DVec3) -> Option<(f64, DVec2)> {
        // origin + direction t = P(0, 0) + u P_u + v P_v, solved for (u, v, t).
        let [p_u, p_v] = self.tangents;
        let solved = DMat3::from_cols(p_u, p_v, -direction).inverse() * (origin - self.origin);
        solved.is_finite().then(|| (solved.z, solved.truncate()))
    }

    /// Whether the part of this shape goes as far as (u, v).
    #[must_use]
    pub fn holds(&self, shape: &impl Primitive, part: Part, uv: DVec2) -> bool {
        /// Of a coordinate. Less would leave out edges, which rounding moves; more would let out what lies beside them.
        const ROUNDING: f64 = 1e-9;
        let point = self.point(uv);
        // A shape gives the nearest (u, v) that it has; F tells of edges that are no lines of u or v.
        let beyond = (shape.uv(point, part) - uv).abs().max_element();
        beyond <= ROUNDING * (1.0 + uv.abs().max_element())
            && shape.implicit(point) <= ROUNDING * (1.0 + point.abs().max_element())
    }
}

/// A point on a flat part, not at its edge: every shape with flat parts is convex, so that each of these is where the
/// outline reaches farthest along the normal.
fn point_on(shape: &impl Primitive, part: Part) -> Option<DVec3> {
    let normal = shape.normal(DVec3::ZERO, part).try_normalize()?;
    let points: Vec<DVec3> = shape.outline().concat();
    let farthest = points.iter().map(|point| normal.dot(*point)).fold(f64::NEG_INFINITY, f64::max);
    let size = points.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
    // Points of the part itself lie there up to rounding, those of other parts far below.
    let on_part: Vec<DVec3> = points.into_iter().filter(|point| normal.dot(*point) >= farthest - 1e-9 * size).collect();
    let count = on_part.len() as f64;
    (count > 0.0).then(|| on_part.into_iter().sum::<DVec3>() / count)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::{
        Cone, ConvexPolyhedron, Cube, Cylinder, HalfSpace, Plane, Shape, Sphere, Square, TaperedCylinder,
    };

    fn tetrahedron() -> ConvexPolyhedron {
        let plane = |normal, offset| HalfSpace { normal, offset };
        let slanted = plane(DVec3::new(1.0, 2.0, 3.0), 6.0);
        let planes = [DVec3::NEG_X, DVec3::NEG_Y, DVec3::NEG_Z].map(|normal| plane(normal, 0.0));
        ConvexPolyhedron::new([&planes[..], &[slanted]].concat()).unwrap()
    }

    /// Every flat part of every shape that has any.
    fn flat_parts() -> Vec<(Shape, Part)> {
        let shapes = [
            Shape::Square(Square),
            Shape::Plane(Plane::new().unwrap()),
            Shape::Cube(Cube),
            Shape::Cylinder(Cylinder::new().unwrap()),
            Shape::TaperedCylinder(TaperedCylinder::new(0.5).unwrap()),
            Shape::ConvexPolyhedron(tetrahedron()),
        ];
        let parts = |shape: Shape| {
            let count = Part::try_from(shape.parts().len()).unwrap();
            (0..count).filter(|part| shape.is_flat(*part)).map(|part| (shape.clone(), part)).collect::<Vec<_>>()
        };
        shapes.into_iter().flat_map(parts).collect()
    }

    #[test]
    fn a_point_of_the_part_has_the_u_and_v_that_it_was_asked_for() {
        let parts = flat_parts();
        assert_eq!(parts.len(), 1 + 1 + 6 + 2 + 2 + 4);
        for (shape, part) in parts {
            let flat = FlatPart::of(&shape, part).unwrap();
            // The middle of each part of these is on it.
            let middle = shape.uv(point_on(&shape, part).unwrap(), part);
            for uv in [middle, middle + DVec2::new(0.01, 0.02)] {
                assert!((shape.uv(flat.point(uv), part) - uv).length() < 1e-12, "{shape:?} {part}");
                assert!(flat.holds(&shape, part, uv), "{shape:?} {part}");
                assert!(shape.implicit(flat.point(uv)).abs() < 1e-12, "{shape:?} {part}");
            }
            let way = DVec3::new(0.3, -0.7, 1.9);
            let (t, uv) = flat.meet(flat.point(middle) - way * 2.5, way).unwrap();
            assert!((t - 2.5).abs() < 1e-12 && (uv - middle).length() < 1e-12, "{shape:?} {part}: {t} {uv}");
        }
    }

    #[test]
    fn the_square_runs_from_its_corner_to_the_one_across() {
        let flat = FlatPart::of(&Square, 0).unwrap();
        assert_eq!(flat.point(DVec2::ZERO), DVec3::new(-1.0, -1.0, 0.0));
        assert_eq!(flat.point(DVec2::ONE), DVec3::new(1.0, 1.0, 0.0));
        assert!(flat.holds(&Square, 0, DVec2::new(1.0, 0.25)));
        assert!(!flat.holds(&Square, 0, DVec2::new(1.01, 0.25)));
        assert_eq!(flat.meet(DVec3::Z, DVec3::X), None);
    }

    #[test]
    fn a_disc_ends_at_its_rim() {
        let (cylinder, cap) = (Cylinder::new().unwrap(), 2);
        let flat = FlatPart::of(&cylinder, cap).unwrap();
        assert!(flat.holds(&cylinder, cap, DVec2::new(0.5, 0.99)));
        assert!(!flat.holds(&cylinder, cap, DVec2::new(0.99, 0.99)));
    }

    #[test]
    fn what_is_curved_or_has_no_area_has_no_such_map() {
        assert_eq!(FlatPart::of(&Sphere, 0), None);
        assert_eq!(FlatPart::of(&Cylinder::new().unwrap(), 0), None);
        assert_eq!(FlatPart::of(&Cone::new().unwrap(), 2), None);
    }
}
