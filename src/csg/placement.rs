//! Where a primitive stands in the world: an affine map and its inverse.

use crate::math::{LaneMap, Real, WideMap, coordinates};
use crate::shape::{Approach, GenericRay};
use glam::{DAffine3, DMat3, DVec3};

/// The affine map of a primitive from generic to world coordinates, with its inverse.
///
/// What every ray needs stands first and together; the rest is out of its way.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    /// World to generic, for rays and normals.
    ray_map: LaneMap,
    rest: Box<Rest>,
}

/// What is asked for once for a scene, for a picture of it, or for a hard ray.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Rest {
    world_from_generic: DAffine3,
    generic_from_world: DAffine3,
    /// World to generic with 32 digits, for solvers that cannot tell with 16.
    wide_generic_from_world: WideMap,
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
        let skew = world_from_generic.matrix3.abs() * (generic_from_world.matrix3.abs() * DVec3::ONE);
        let skew = skew.max_element();
        Ok(Self {
            ray_map: LaneMap::from_rows(rows(&generic_from_world)),
            rest: Box::new(Rest { world_from_generic, generic_from_world, wide_generic_from_world, skew }),
        })
    }

    /// Generic to world.
    #[must_use]
    pub fn world_from_generic(&self) -> DAffine3 {
        self.rest.world_from_generic
    }

    /// World to generic.
    #[must_use]
    pub fn generic_from_world(&self) -> DAffine3 {
        self.rest.generic_from_world
    }

    /// ‖ |M| |M⁻¹| ‖∞: how many times larger an error of a coordinate can be after the way into generic coordinates and
    /// back. 1 where axes are only stretched, at most 3 for rotations, large for solids that are thin across a slope.
    #[must_use]
    pub fn skew(&self) -> f64 {
        self.rest.skew
    }

    /// The world ray `line` (its origin and direction) in generic coordinates; t is shared because c is not normalised.
    // Inlined always: a solver that sees how its ray comes about leaves out what it does not need of it.
    #[must_use]
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "measured: 8 % of a picture's time")]
    pub fn generic_ray<'a, A: Real>(&'a self, line: &'a [DVec3; 2]) -> GenericRay<'a, A> {
        let [origin, direction] = line.map(|v| v.to_array());
        let [origin_size, direction_size] = line.map(|v| v.abs().to_array());
        GenericRay::mapped(
            line,
            [self.ray_map.point(origin), self.ray_map.vector(direction)],
            // Twice, for the matrix was itself rounded when it was composed.
            [self.ray_map.point_size(origin_size), self.ray_map.vector_size(direction_size)].map(|size| size + size),
            &self.rest.wide_generic_from_world,
        )
    }

    /// A point of the world in generic coordinates.
    #[must_use]
    #[inline]
    pub fn generic_point(&self, point: DVec3) -> DVec3 {
        coordinates(self.ray_map.point(point.to_array())).into()
    }

    /// A generic normal as an outward unit normal in world space (by the inverse transpose).
    #[must_use]
    #[inline]
    pub fn world_normal(&self, generic_normal: DVec3) -> DVec3 {
        // Of a length that is neither too large nor too small for what follows it need not be made a unit first.
        let is_ordinary = (1e-100..1e100).contains(&generic_normal.length_squared());
        let normal = if is_ordinary { generic_normal } else { unit(generic_normal) };
        unit(self.ray_map.transposed_vector(normal.to_array()).into())
    }

    /// The inverse as three rows of four, as it is shown.
    #[must_use]
    pub fn inverse_rows(&self) -> [[f64; 4]; 3] {
        rows(&self.rest.generic_from_world)
    }
}

/// A world ray on its way into a primitive's generic coordinates.
pub(super) struct PlacedRay<'a> {
    pub placement: &'a Placement,
    /// Its origin and direction.
    pub line: &'a [DVec3; 2],
}

impl Approach for PlacedRay<'_> {
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "measured with `generic_ray`, of which it is the way in")]
    fn generic<A: Real>(&self) -> GenericRay<'_, A> {
        self.placement.generic_ray(self.line)
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
