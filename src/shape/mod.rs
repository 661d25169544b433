//! The generic primitives, one file each.
//!
//! [`for_each_shape!`](crate::for_each_shape) is the one list of them. It generates the [`Shape`] enum here, the
//! `shape` names and parameters of the scene file with their schema, and the battery of tests that every shape has to
//! pass. Adding a primitive means one new file and one new row.

#[cfg(test)]
mod battery;
mod boundary;
mod convex_polyhedron;
mod cube;
mod cylinder;
mod flat_part;
mod gauge;
mod method;
mod outline;
mod plane;
mod plane_table;
mod planes;
mod primitive;
mod report;
mod solver;
mod sphere;
mod square;
mod superellipsoid;
mod superellipsoid_line;
mod superellipsoid_mixed;
mod superellipsoid_root;
mod superellipsoid_search;
mod tangents;
mod tapered_cylinder;
mod tapered_wall;
#[cfg(test)]
mod testing;
pub mod textbook;
mod torus;
mod torus_quartic;
mod torus_roots;

pub use convex_polyhedron::{ConvexPolyhedron, HalfSpace};
pub use cube::Cube;
pub use cylinder::{Cone, Cylinder};
pub use flat_part::FlatPart;
pub use method::{Method, Search, Solving};
pub use plane::Plane;
pub use primitive::{Approach, Bounds, Crossing, Crossings, GenericRay, Part, Primitive};
pub use sphere::Sphere;
pub use square::Square;
pub use superellipsoid::Superellipsoid;
pub use tapered_cylinder::TaperedCylinder;
pub use torus::Torus;

use crate::math::Real;
use crate::record::Recorder;
use glam::{DVec2, DVec3};

/// Calls a macro with the list of shapes: `Variant "name" "what it is" { parameter: Type = "what it is", … }`.
///
/// Each type has a constructor `new(parameters…) -> Result<Self, String>` whose error says what was wrong with them.
#[macro_export]
macro_rules! for_each_shape {
    ($callback:ident) => {
        $callback! {
            Plane "plane" "The half-space z ≤ 0." {}
            Sphere "sphere" "The ball of radius 1 about the origin." {}
            Square "square" "The square z = 0, |x| ≤ 1, |y| ≤ 1. It bounds nothing." {}
            TaperedCylinder "tapered_cylinder" "Radius 1 at z = 0, radius s at z = 1, closed by discs." {
                s: f64 = "Radius of the cap, 0 or more.",
            }
            Cylinder "cylinder" "The tapered cylinder with s = 1." {}
            Cone "cone" "The tapered cylinder with s = 0." {}
            Cube "cube" "The cube from −1 to 1 in x, y and z." {}
            ConvexPolyhedron "convex_polyhedron" "The points that lie inside all planes." {
                planes: Vec<HalfSpace> = "The planes; inside is n·p ≤ d, and n need not be unit.",
            }
            Torus "torus" "A tube of radius 1 about the circle of radius d in the plane z = 0." {
                d: f64 = "Distance from the axis to the middle of the tube, more than 0.",
            }
            Superellipsoid "superellipsoid" "(|x|ⁿ + |y|ⁿ)^(m/n) + |z|ᵐ ≤ 1." {
                n: f64 = "The exponent of x and y, more than 0.",
                m: f64 = "The exponent of z, more than 0.",
            }
        }
    };
}

macro_rules! define_shape {
    ($($variant:ident $name:literal $about:literal { $($parameter:ident : $type:ty = $doc:literal,)* })*) => {
        /// Any generic primitive.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Shape { $(#[doc = $about] $variant($variant),)* }

        impl Shape {
            /// The names of all shapes, as scene files spell them, in the order of the list.
            pub const NAMES: &'static [&'static str] = &[$($name),*];

            /// The name, as scene files spell it.
            #[must_use]
            pub const fn name(&self) -> &'static str {
                match self { $(Self::$variant(_) => $name,)* }
            }

            /// The shape's place in the list, for counters.
            #[must_use]
            #[inline]
            pub const fn index(&self) -> usize {
                enum Place { $($variant),* }
                match self { $(Self::$variant(_) => Place::$variant as usize,)* }
            }
        }

        impl Primitive for Shape {
            fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Crossings) {
                match self { $(Self::$variant(shape) => shape.crossings(ray, recorder, crossings),)* }
            }

            fn first_crossing<A: Real>(&self, approach: &impl Approach) -> Option<Crossing> {
                match self { $(Self::$variant(shape) => shape.first_crossing::<A>(approach),)* }
            }

            fn normal(&self, point: DVec3, part: Part) -> DVec3 {
                match self { $(Self::$variant(shape) => shape.normal(point, part),)* }
            }

            fn uv(&self, point: DVec3, part: Part) -> DVec2 {
                match self { $(Self::$variant(shape) => shape.uv(point, part),)* }
            }

            fn tangents(&self, point: DVec3, part: Part) -> [DVec3; 2] {
                match self { $(Self::$variant(shape) => shape.tangents(point, part),)* }
            }

            fn is_flat(&self, part: Part) -> bool {
                match self { $(Self::$variant(shape) => shape.is_flat(part),)* }
            }

            fn uv_period(&self, part: Part) -> [Option<f64>; 2] {
                match self { $(Self::$variant(shape) => shape.uv_period(part),)* }
            }

            fn bounds(&self) -> Bounds {
                match self { $(Self::$variant(shape) => shape.bounds(),)* }
            }

            fn ball_radius(&self) -> f64 {
                match self { $(Self::$variant(shape) => shape.ball_radius(),)* }
            }

            fn is_convex(&self) -> bool {
                match self { $(Self::$variant(shape) => shape.is_convex(),)* }
            }

            fn outline(&self) -> Vec<Vec<DVec3>> {
                match self { $(Self::$variant(shape) => shape.outline(),)* }
            }

            fn implicit(&self, point: DVec3) -> f64 {
                match self { $(Self::$variant(shape) => shape.implicit(point),)* }
            }

            fn equation(&self) -> String {
                match self { $(Self::$variant(shape) => shape.equation(),)* }
            }

            fn parts(&self) -> Vec<String> {
                match self { $(Self::$variant(shape) => shape.parts(),)* }
            }
        }
    };
}

for_each_shape!(define_shape);
