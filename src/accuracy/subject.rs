//! The primitives that are followed into the distance and towards tangents, and the rays that are sent at them.

use super::random::Random;
use crate::math::portable;
use crate::shape::{
    ConvexPolyhedron, Cube, HalfSpace, Primitive, Shape, Sphere, Square, Superellipsoid, TaperedCylinder, Torus,
};
use glam::DVec3;
use std::f64::consts::{FRAC_PI_2, TAU};

/// A primitive with its name for titles.
#[derive(Clone, Debug)]
pub struct Subject {
    /// As scene files spell it.
    pub name: &'static str,
    /// For titles, with its parameters.
    pub title: &'static str,
    /// The primitive.
    pub shape: Shape,
}

/// The exponents of the superellipsoid.
const EXPONENTS: [f64; 2] = [4.0, 3.0];
/// The torus's distance from the axis to the middle of the tube.
const D: f64 = 3.0;
/// The radius of the tapered cylinder's cap.
const S: f64 = 0.5;

/// The subject of this name, if it is one.
#[must_use]
pub fn subject(name: &str) -> Option<Subject> {
    let (name, title, shape) = match name {
        "sphere" => ("sphere", "Sphere", Sphere::new().map(Shape::Sphere)),
        "square" => ("square", "Square", Square::new().map(Shape::Square)),
        "tapered_cylinder" => {
            ("tapered_cylinder", "Tapered cylinder, s = 0.5", TaperedCylinder::new(S).map(Shape::TaperedCylinder))
        }
        "cube" => ("cube", "Cube", Cube::new().map(Shape::Cube)),
        "convex_polyhedron" => ("convex_polyhedron", "Octahedron", octahedron()),
        "torus" => ("torus", "Torus, d = 3", Torus::new(D).map(Shape::Torus)),
        "superellipsoid" => (
            "superellipsoid",
            "Superellipsoid, n = 4, m = 3",
            Superellipsoid::new(EXPONENTS[0], EXPONENTS[1]).map(Shape::Superellipsoid),
        ),
        _ => return None,
    };
    shape.ok().map(|shape| Subject { name, title, shape })
}

/// |x + y / 2| + |y| + |z| about 1, a little askew so that no normal is a simple number.
fn octahedron() -> Result<Shape, String> {
    let signs = [1.0, -1.0];
    let normals =
        signs.into_iter().flat_map(|x| signs.into_iter().flat_map(move |y| signs.map(|z| DVec3::new(x, y, z))));
    let planes = normals.map(|n| HalfSpace { normal: n * DVec3::new(1.0, 1.1, 0.9) + DVec3::X * 0.1, offset: 1.0 });
    ConvexPolyhedron::new(planes.collect()).map(Shape::ConvexPolyhedron)
}

impl Subject {
    /// Half the diagonal of its box: what distances and gaps are measured in.
    #[must_use]
    pub fn size(&self) -> f64 {
        let bounds = self.shape.bounds();
        0.5 * (bounds.high - bounds.low).length()
    }

    /// A ray from this many sizes away into the box.
    #[must_use]
    pub fn ray_from(&self, distance: f64, random: &mut Random) -> (DVec3, DVec3) {
        let bounds = self.shape.bounds();
        let target = random.within(bounds.low, bounds.high);
        let origin = target + random.direction() * (distance * self.size());
        (origin, (target - origin).normalize())
    }

    /// A ray from 4 sizes away that passes a tangent, or for a solid of planes an edge, at this many sizes: inside of it or
    /// outside, by chance.
    #[must_use]
    pub fn ray_beside(&self, gap: f64, random: &mut Random) -> Option<(DVec3, DVec3)> {
        let (point, normal) = self.rim(random)?;
        let any = random.direction();
        let along = match self.shape {
            // A ray within the plane of the square would be another question.
            Shape::Square(_) => DVec3::new(any.x, any.y, 0.5 + any.z.abs()),
            _ => any - normal * any.dot(normal),
        };
        let along = (along.length() > 0.1).then(|| along.normalize())?;
        let side = if random.share() < 0.5 { 1.0 } else { -1.0 };
        Some((point + normal * (side * gap * self.size()) - along * (4.0 * self.size()), along))
    }

    /// A point of the surface that a line can touch from outside, with the unit vector out of the solid there.
    fn rim(&self, random: &mut Random) -> Option<(DVec3, DVec3)> {
        let (shape, angle) = (&self.shape, random.between(0.0, TAU));
        let around = DVec3::new(portable::cos(angle), portable::sin(angle), 0.0);
        let point = match shape {
            Shape::Sphere(_) => random.direction(),
            Shape::TaperedCylinder(solid) => {
                let z = random.between(0.2, 0.8);
                around * solid.radius(z) + DVec3::Z * z
            }
            Shape::Torus(_) => {
                // The outer half of the tube: the inner half is touched from within the hole.
                let turn = random.between(-0.9, 0.9) * FRAC_PI_2;
                around * (D + portable::cos(turn)) + DVec3::Z * portable::sin(turn)
            }
            Shape::Superellipsoid(_) => {
                let v = random.direction();
                v / portable::powf(shape.implicit(v) + 1.0, 1.0 / EXPONENTS[1])
            }
            _ => return self.edge(random),
        };
        Some((point, shape.normal(point, 0).normalize()))
    }

    /// A point of an edge, with the unit vector that halves the angle between the faces that meet there.
    fn edge(&self, random: &mut Random) -> Option<(DVec3, DVec3)> {
        let outline = self.shape.outline();
        let segments: Vec<_> = outline.iter().flat_map(|line| line.windows(2)).collect();
        let segment = segments.get(random.index(segments.len()))?;
        let point = segment[0].lerp(segment[1], random.between(0.1, 0.9));
        let near = |x: f64| (x.abs() - 1.0).abs() < 1e-9;
        let normal = match &self.shape {
            Shape::ConvexPolyhedron(solid) => {
                let faces = solid.planes().iter().filter(|plane| near(plane.normal.dot(point) / plane.offset));
                faces.map(|plane| plane.normal.normalize()).sum()
            }
            _ => DVec3::from_array(point.to_array().map(|x| if near(x) { x.signum() } else { 0.0 })),
        };
        (normal != DVec3::ZERO).then(|| (point, normal.normalize()))
    }
}
