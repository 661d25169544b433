//! Cylinder and cone: the tapered cylinder with s = 1 and with s = 0.
//!
//! **Shape**
//! ```text
//!    z = 1   +-----+        z = 1      ^
//!            |     |                  / \
//!            |     |                 /   \
//!    z = 0   +-----+        z = 0   +-----+
//!            cylinder                cone
//! ```
//! **Equation** F of the wall is x² + y² − 1, or x² + y² − (1 − z)²; see `tapered_cylinder.rs` for this and for everything
//! else: **Ray equation**, **Accuracy**, **Degenerate cases**, **Source**. Both are that solid, under names of their own.

use super::{Approach, Bounds, Crossing, Crossings, GenericRay, Part, Primitive, TaperedCylinder};
use crate::math::Real;
use crate::record::Recorder;
use glam::{DVec2, DVec3};

macro_rules! tapered {
    ($(#[$about:meta])* $name:ident, $s:literal) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name(TaperedCylinder);

        impl $name {
            /// The generic one.
            ///
            /// # Errors
            /// None: it has no parameters.
            pub fn new() -> Result<Self, String> {
                TaperedCylinder::new($s).map(Self)
            }
        }

        impl Primitive for $name {
            fn crossings<A: Real>(
                &self,
                ray: &GenericRay<A>,
                recorder: &mut impl Recorder,
                crossings: &mut Crossings,
            ) {
                self.0.crossings(ray, recorder, crossings);
            }

            #[inline]
            fn first_crossing<A: Real>(&self, approach: &impl Approach) -> Option<Crossing> {
                self.0.first_crossing::<A>(approach)
            }

            fn normal(&self, point: DVec3, part: Part) -> DVec3 {
                self.0.normal(point, part)
            }

            fn uv(&self, point: DVec3, part: Part) -> DVec2 {
                self.0.uv(point, part)
            }

            fn tangents(&self, point: DVec3, part: Part) -> [DVec3; 2] {
                self.0.tangents(point, part)
            }

            fn is_flat(&self, part: Part) -> bool {
                self.0.is_flat(part)
            }

            fn uv_period(&self, part: Part) -> [Option<f64>; 2] {
                self.0.uv_period(part)
            }

            fn bounds(&self) -> Bounds {
                self.0.bounds()
            }

            fn ball_radius(&self) -> f64 {
                self.0.ball_radius()
            }

            fn outline(&self) -> Vec<Vec<DVec3>> {
                self.0.outline()
            }

            fn implicit(&self, point: DVec3) -> f64 {
                self.0.implicit(point)
            }

            fn equation(&self) -> String {
                self.0.equation()
            }

            fn parts(&self) -> Vec<String> {
                self.0.parts()
            }
        }
    };
}

tapered! {
    /// Radius 1 from z = 0 to z = 1, closed by discs.
    Cylinder, 1.0
}

tapered! {
    /// Radius 1 at z = 0, the apex at z = 1, closed by a disc.
    Cone, 0.0
}

#[cfg(test)]
mod tests {
    use super::super::testing::*;
    use super::*;

    impl Samples for Cylinder {
        fn samples() -> Vec<Self> {
            vec![Self::new().unwrap()]
        }
    }

    impl Samples for Cone {
        fn samples() -> Vec<Self> {
            vec![Self::new().unwrap()]
        }
    }

    #[test]
    fn halfway_up_the_cylinder_is_as_wide_as_its_base_and_the_cone_half_as_wide() {
        let (origin, direction) = ([-3.0, 0.0, 0.5], [1.0, 0.0, 0.0]);
        expect(&Cylinder::new().unwrap(), origin, direction, &[(2.0, Enter, "wall"), (4.0, Leave, "wall")]);
        expect(&Cone::new().unwrap(), origin, direction, &[(2.5, Enter, "wall"), (3.5, Leave, "wall")]);
    }

    #[test]
    fn beside_the_axis_the_cylinder_is_entered_by_its_cap_and_the_cone_by_its_wall() {
        let (origin, direction) = ([0.25, 0.0, 3.0], [0.0, 0.0, -1.0]);
        expect(&Cylinder::new().unwrap(), origin, direction, &[(2.0, Enter, "cap"), (3.0, Leave, "base")]);
        expect(&Cone::new().unwrap(), origin, direction, &[(2.25, Enter, "wall"), (3.0, Leave, "base")]);
    }
}
