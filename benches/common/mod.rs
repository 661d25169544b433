//! The shapes and rays that are timed, and the calls.

use glam::DVec3;
use rayscope::accuracy::Random;
use rayscope::math::{Alone, DoubleDouble, Real};
use rayscope::record::NullRecorder;
use rayscope::shape::{
    Cone, ConvexPolyhedron, Crossings, Cube, Cylinder, GenericRay, HalfSpace, Plane, Primitive, Shape, Sphere, Square,
    Superellipsoid, TaperedCylinder, Torus, textbook,
};

/// Rays a batch: enough to average over hits and misses, few enough to stay in the cache.
pub const RAYS: usize = 1_000;

/// Every shape with a name for it.
pub fn shapes() -> Vec<(&'static str, Shape)> {
    let octahedron = (0..8_u8).map(|k| {
        let sign = |bit: u8| if k >> bit & 1 == 1 { 1.0 } else { -1.0 };
        HalfSpace { normal: DVec3::new(sign(0), sign(1), sign(2)), offset: 1.0 }
    });
    let made = |shape: Result<Shape, String>| shape.expect("the parameters are good");
    vec![
        ("plane", made(Plane::new().map(Shape::Plane))),
        ("square", made(Square::new().map(Shape::Square))),
        ("sphere", made(Sphere::new().map(Shape::Sphere))),
        ("tapered_cylinder s=0.5", made(TaperedCylinder::new(0.5).map(Shape::TaperedCylinder))),
        ("cylinder", made(Cylinder::new().map(Shape::Cylinder))),
        ("cone", made(Cone::new().map(Shape::Cone))),
        ("cube", made(Cube::new().map(Shape::Cube))),
        ("octahedron", made(ConvexPolyhedron::new(octahedron.collect()).map(Shape::ConvexPolyhedron))),
        ("torus d=3", made(Torus::new(3.0).map(Shape::Torus))),
        ("superellipsoid 4,4", made(Superellipsoid::new(4.0, 4.0).map(Shape::Superellipsoid))),
        ("superellipsoid 2.5,3", made(Superellipsoid::new(2.5, 3.0).map(Shape::Superellipsoid))),
        ("superellipsoid 0.7,0.7", made(Superellipsoid::new(0.7, 0.7).map(Shape::Superellipsoid))),
    ]
}

/// Rays from 3 to 10 sizes away, aimed into a box a little larger than the shape's, so that about half of them hit.
pub fn rays(shape: &Shape) -> Vec<(DVec3, DVec3)> {
    let bounds = shape.bounds();
    let low = bounds.low.max(DVec3::splat(-4.0));
    let high = bounds.high.min(DVec3::splat(4.0));
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    let mut random = Random::new(42, shape.index() as u64);
    let ray = |_| {
        let origin = middle + random.direction() * (half.length() * random.between(3.0, 10.0));
        let target = middle + random.within(-half, half) * 1.15;
        (origin, (target - origin).normalize())
    };
    (0..RAYS).map(ray).collect()
}

/// The program's solver on all rays; the number of crossings, so that nothing can be left out.
pub fn solve<A: Real>(shape: &Shape, rays: &[(DVec3, DVec3)], crossings: &mut Crossings) -> usize {
    let mut found = 0;
    for &(origin, direction) in rays {
        crossings.clear();
        shape.crossings(&GenericRay::<A>::new(origin, direction), &mut NullRecorder, crossings);
        found += crossings.len();
    }
    found
}

/// The textbook's.
pub fn by_the_book(shape: &Shape, rays: &[(DVec3, DVec3)], crossings: &mut Crossings) -> usize {
    let mut found = 0;
    for &(origin, direction) in rays {
        crossings.clear();
        textbook::crossings(shape, &GenericRay::new(origin, direction), crossings);
        found += crossings.len();
    }
    found
}

/// A call with its name.
pub type Contestant = (&'static str, fn(&Shape, &[(DVec3, DVec3)], &mut Crossings) -> usize);

/// The calls that are compared.
pub const CONTESTANTS: [Contestant; 4] = [
    ("adaptive", solve::<f64>),
    ("textbook", by_the_book),
    ("f64 alone", solve::<Alone<f64>>),
    ("double-double", solve::<DoubleDouble>),
];
