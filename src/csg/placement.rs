//! Where a primitive stands in the world: an affine map and its inverse.

use crate::math::{LaneMap, Real, WideMap};
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
    /// World to generic, for rays.
    ray_map: LaneMap,
    /// The sizes of its numbers, for error bounds: what cancels in the inverse transform. Twice, for the matrix was itself
    /// rounded when it was composed.
    sizes: LaneMap,
    skew: f64,
}

impl Placement {
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
        let ray_map = LaneMap::from_rows(rows(&generic_from_world));
        let skew = world_from_generic.matrix3.abs() * (generic_from_world.matrix3.abs() * DVec3::ONE);
        Ok(Self {
            world_from_generic,
            generic_from_world,
            normals: generic_from_world.matrix3.transpose(),
            wide_generic_from_world,
            ray_map,
            sizes: ray_map.sizes(2.0),
            skew: skew.max_element(),
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
        let world = [origin.to_array(), direction.to_array()];
        let sizes = [origin.abs().to_array(), direction.abs().to_array()];
        GenericRay::mapped(
            world,
            [self.ray_map.point(world[0]), self.ray_map.vector(world[1])],
            [self.sizes.point(sizes[0]), self.sizes.vector(sizes[1])],
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
    if (1e-200..1e200).contains(&square) { v / square.sqrt() } else { extreme_unit(v) }
}

/// The same where squares overflow or vanish. A coordinate that is too large for a number outweighs all others.
#[cold]
fn extreme_unit(v: DVec3) -> DVec3 {
    let outweighing = |x: f64| if x.is_infinite() { x.signum() } else { 0.0 };
    let v = if v.is_finite() { v } else { DVec3::from_array(v.to_array().map(outweighing)) };
    (v * crate::math::scale_to_unit(v.to_array())).try_normalize().unwrap_or(DVec3::Z)
}
