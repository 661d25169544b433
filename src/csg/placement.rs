//! Where a primitive stands in the world: an affine map and its inverse.

use crate::math::Real;
use crate::shape::GenericRay;
use glam::{DAffine3, DMat3, DVec3};

/// The affine map of a primitive from generic to world coordinates, with its inverse and the normals' matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Generic to world.
    pub world_from_generic: DAffine3,
    /// World to generic.
    pub generic_from_world: DAffine3,
    /// The inverse transpose: takes generic normals to world normals.
    normals: DMat3,
    /// Largest ratio of the sizes of numbers that cancel in the inverse transform, for error bounds.
    magnitude: DMat3,
}

impl Placement {
    /// The generic pose itself.
    pub const IDENTITY: Self = Self {
        world_from_generic: DAffine3::IDENTITY,
        generic_from_world: DAffine3::IDENTITY,
        normals: DMat3::IDENTITY,
        magnitude: DMat3::IDENTITY,
    };

    /// Places a primitive by `world_from_generic`.
    ///
    /// # Errors
    /// Says so when the matrix is singular or not finite, so that no inverse exists.
    pub fn new(world_from_generic: DAffine3) -> Result<Self, String> {
        if !world_from_generic.is_finite() {
            return Err("the transform holds a number that is not finite".to_owned());
        }
        let generic_from_world = world_from_generic.inverse();
        let determinant = world_from_generic.matrix3.determinant();
        if determinant == 0.0 || !generic_from_world.is_finite() {
            return Err(format!("the transform is singular (its determinant is {determinant}), so it has no inverse"));
        }
        Ok(Self {
            world_from_generic,
            generic_from_world,
            normals: generic_from_world.matrix3.transpose(),
            magnitude: generic_from_world.matrix3.abs(),
        })
    }

    /// The world ray (`origin`, `direction`) in generic coordinates; t is shared because c is not normalised.
    #[must_use]
    pub fn generic_ray<A: Real>(&self, origin: DVec3, direction: DVec3) -> GenericRay<A> {
        GenericRay::new(
            self.generic_from_world.transform_point3(origin),
            self.generic_from_world.transform_vector3(direction),
        )
    }

    /// A generic normal as an outward unit normal in world space (by the inverse transpose).
    #[must_use]
    pub fn world_normal(&self, generic_normal: DVec3) -> DVec3 {
        unit(self.normals * unit(generic_normal))
    }

    /// How far rounding can move a world point along each generic axis, in roundings of the point's coordinates.
    #[must_use]
    pub fn spread(&self, world_point: DVec3) -> DVec3 {
        self.magnitude * world_point.abs() + self.generic_from_world.translation.abs()
    }

    /// The inverse as three rows of four, as it is shown.
    #[must_use]
    pub fn inverse_rows(&self) -> [[f64; 4]; 3] {
        let (m, t) = (self.generic_from_world.matrix3, self.generic_from_world.translation);
        std::array::from_fn(|row| [m.col(0)[row], m.col(1)[row], m.col(2)[row], t[row]])
    }
}

/// Normalises without overflow or underflow.
fn unit(v: DVec3) -> DVec3 {
    (v * crate::math::scale_to_unit(v.to_array())).normalize()
}
