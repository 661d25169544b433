//! Where a primitive stands in the world: an affine map and its inverse.

use crate::math::{Real, WideMap};
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
    /// World to generic with 32 digits, for solvers that cannot tell with 16.
    wide_generic_from_world: WideMap,
    /// The sizes of the inverse's numbers, for error bounds: what cancels in the inverse transform.
    sizes: DAffine3,
    skew: f64,
}

impl Placement {
    /// The generic pose itself.
    pub const IDENTITY: Self = Self {
        world_from_generic: DAffine3::IDENTITY,
        generic_from_world: DAffine3::IDENTITY,
        normals: DMat3::IDENTITY,
        wide_generic_from_world: WideMap::IDENTITY,
        sizes: DAffine3::IDENTITY,
        skew: 1.0,
    };

    /// Places a primitive by `world_from_generic`.
    ///
    /// # Errors
    /// Says so when the matrix is singular or not finite, so that no inverse exists.
    pub fn new(world_from_generic: DAffine3) -> Result<Self, String> {
        if !world_from_generic.is_finite() {
            return Err("the transform holds a number that is not finite".to_owned());
        }
        let wide_generic_from_world = WideMap::inverse_of(rows(&world_from_generic));
        let generic_from_world = affine(wide_generic_from_world.to_f64());
        let determinant = world_from_generic.matrix3.determinant();
        if determinant == 0.0 || !generic_from_world.is_finite() {
            return Err(format!("the transform is singular (its determinant is {determinant}), so it has no inverse"));
        }
        let sizes = DAffine3 {
            matrix3: generic_from_world.matrix3.abs(),
            translation: generic_from_world.translation.abs(),
        };
        Ok(Self {
            world_from_generic,
            generic_from_world,
            normals: generic_from_world.matrix3.transpose(),
            wide_generic_from_world,
            sizes,
            skew: ((world_from_generic.matrix3.abs() * sizes.matrix3) * DVec3::ONE).max_element(),
        })
    }

    /// ‖ |M| |M⁻¹| ‖∞: how many times larger an error of a coordinate can be after the way into generic coordinates and
    /// back. 1 where axes are only stretched, at most 3 for rotations, large for solids that are thin across a slope.
    #[must_use]
    pub const fn skew(&self) -> f64 {
        self.skew
    }

    /// The world ray (`origin`, `direction`) in generic coordinates; t is shared because c is not normalised.
    #[must_use]
    #[inline]
    pub fn generic_ray<A: Real>(&self, origin: DVec3, direction: DVec3) -> GenericRay<'_, A> {
        let inverse = &self.generic_from_world;
        GenericRay::mapped(
            [origin, direction],
            [inverse.transform_point3(origin), inverse.transform_vector3(direction)],
            // Twice, for the matrix was itself rounded when it was composed.
            [self.sizes.transform_point3(origin.abs()) * 2.0, self.sizes.transform_vector3(direction.abs()) * 2.0],
            &self.wide_generic_from_world,
        )
    }

    /// A generic normal as an outward unit normal in world space (by the inverse transpose).
    #[must_use]
    pub fn world_normal(&self, generic_normal: DVec3) -> DVec3 {
        unit(self.normals * unit(generic_normal))
    }

    /// The inverse as three rows of four, as it is shown.
    #[must_use]
    pub fn inverse_rows(&self) -> [[f64; 4]; 3] {
        rows(&self.generic_from_world)
    }
}

/// Three rows of four.
fn rows(map: &DAffine3) -> [[f64; 4]; 3] {
    let (m, t) = (map.matrix3, map.translation);
    std::array::from_fn(|row| [m.col(0)[row], m.col(1)[row], m.col(2)[row], t[row]])
}

/// The map with these rows.
fn affine([x, y, z]: [[f64; 4]; 3]) -> DAffine3 {
    let column = |k: usize| DVec3::new(x[k], y[k], z[k]);
    DAffine3 { matrix3: DMat3::from_cols(column(0), column(1), column(2)), translation: column(3) }
}

/// Normalises without overflow or underflow.
#[inline]
fn unit(v: DVec3) -> DVec3 {
    let square = v.length_squared();
    // Where the square is neither too large nor too small for its digits, scaling by a power of two changes none of them.
    if (1e-200..1e200).contains(&square) {
        v / square.sqrt()
    } else {
        (v * crate::math::scale_to_unit(v.to_array())).normalize()
    }
}
