//! The solids that are looked at, as the program knows them and by their equations.

use super::exact::Exact;
use glam::DVec3;
use rayscope::shape::{ConvexPolyhedron, Cube, HalfSpace, Shape, Sphere, Superellipsoid, TaperedCylinder, Torus};

pub fn sphere() -> (Shape, Exact) {
    (Shape::Sphere(Sphere::new().unwrap()), Exact::Sphere)
}

pub fn tapered(s: f64) -> (Shape, Exact) {
    (Shape::TaperedCylinder(TaperedCylinder::new(s).unwrap()), Exact::Tapered(s))
}

pub fn cube() -> (Shape, Exact) {
    let planes = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|n| [(n, 1.0), (-n, 1.0)]);
    (Shape::Cube(Cube::new().unwrap()), Exact::Planes(planes.collect()))
}

pub fn polyhedron(planes: &[(DVec3, f64)]) -> (Shape, Exact) {
    let half_spaces = planes.iter().map(|&(normal, offset)| HalfSpace { normal, offset }).collect();
    (Shape::ConvexPolyhedron(ConvexPolyhedron::new(half_spaces).unwrap()), Exact::Planes(planes.to_vec()))
}

/// The eight planes x ± y ± z.
pub fn octahedron() -> (Shape, Exact) {
    let signs = |k: u8| DVec3::new(sign(k & 1), sign(k & 2), sign(k & 4));
    polyhedron(&(0..8).map(|k| (signs(k), 1.0)).collect::<Vec<_>>())
}

/// A gem with 40 faces, the normals of no particular length, wound about the sphere by the golden angle.
pub fn gem() -> (Shape, Exact) {
    let plane = |k: u32| {
        let z = (2.0 * f64::from(k) + 1.0) / 40.0 - 1.0;
        let (sin, cos) = (2.4 * f64::from(k)).sin_cos();
        let radius = (1.0 - z * z).sqrt();
        let length = 0.5 + 0.1 * f64::from(k);
        (DVec3::new(radius * cos, radius * sin, z) * length, length)
    };
    polyhedron(&(0..40).map(plane).collect::<Vec<_>>())
}

fn sign(bit: u8) -> f64 {
    if bit == 0 { 1.0 } else { -1.0 }
}

pub fn torus(d: f64) -> (Shape, Exact) {
    (Shape::Torus(Torus::new(d).unwrap()), Exact::Torus(d))
}

pub fn superellipsoid(n: f64, m: f64) -> (Shape, Exact) {
    (Shape::Superellipsoid(Superellipsoid::new(n, m).unwrap()), Exact::Super(n, m))
}
