//! The cube [−1, 1]³ by its plane table (§ 6.2.3).
//!
//! **Shape**
//! ```text
//!          y ↑  top
//!       +----|----+
//!      /|    |   /|
//!     +---------+ |      right: x = 1, left: x = −1
//!     | |    o--|-|--→ x top: y = 1, bottom: y = −1
//!     | +--/----|-+      front: z = 1, back: z = −1
//!     |/  z     |/
//!     +---------+
//! ```
//! **Equation** F = max(|x|, |y|, |z|) − 1.
//!
//! **Ray equation** For each plane m·p = m·spot: t = m·(spot − S) / m·c, entering where m·c < 0. The ray is inside from
//! the latest entering to the earliest leaving time.
//!
//! **Accuracy** Two roundings a plane, so 2u relative in t, at any distance. Rays through edges and corners decide by the
//! order of nearly equal times; see the header of `planes.rs`.
//!
//! **Degenerate cases** A ray in a face runs inside the closed cube and has its two hits on other faces. A ray that only
//! touches an edge or a corner has none.
//!
//! **Source** Hill, Computer Graphics Using OpenGL, the generic cube; Williams et al., JGT 10(1), 2005, on the cases of
//! zero and signed zero in c.

use super::{Bounds, Crossing, GenericRay, HalfSpace, Part, Primitive, planes};
use crate::math::Real;
use crate::record::Recorder;
use glam::{DVec2, DVec3};

/// The cube from −1 to 1 in x, y and z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cube;

/// The six planes in the order of the plane table.
const PLANES: [HalfSpace; 6] = [
    HalfSpace { normal: DVec3::Y, offset: 1.0 },
    HalfSpace { normal: DVec3::NEG_Y, offset: 1.0 },
    HalfSpace { normal: DVec3::X, offset: 1.0 },
    HalfSpace { normal: DVec3::NEG_X, offset: 1.0 },
    HalfSpace { normal: DVec3::Z, offset: 1.0 },
    HalfSpace { normal: DVec3::NEG_Z, offset: 1.0 },
];

/// Their names.
const NAMES: [&str; 6] = ["top", "bottom", "right", "left", "front", "back"];

impl Cube {
    /// The generic cube.
    ///
    /// # Errors
    /// None: it has no parameters.
    pub const fn new() -> Result<Self, String> {
        Ok(Self)
    }
}

impl Primitive for Cube {
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Vec<Crossing>) {
        planes::crossings(self, &PLANES, ray, recorder, crossings);
    }

    fn normal(&self, _point: DVec3, part: Part) -> DVec3 {
        PLANES.get(usize::from(part)).map_or(DVec3::Y, |plane| plane.normal)
    }

    /// Each face seen from outside, u to the right and v up; the top and bottom with the front below and above.
    fn uv(&self, point: DVec3, part: Part) -> DVec2 {
        let DVec3 { x, y, z } = point;
        let (right, up) = match part {
            0 => (x, -z),
            1 => (x, z),
            2 => (-z, y),
            3 => (z, y),
            4 => (x, y),
            _ => (-x, y),
        };
        ((DVec2::new(right, up) + 1.0) * 0.5).clamp(DVec2::ZERO, DVec2::ONE)
    }

    fn bounds(&self) -> Bounds {
        Bounds { low: DVec3::NEG_ONE, high: DVec3::ONE }
    }

    /// Front, back, and the four edges between.
    fn outline(&self) -> Vec<Vec<DVec3>> {
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let ring = |z| (0..5).map(|k: usize| corners[k % 4]).map(|(x, y)| DVec3::new(x, y, z)).collect();
        let edges = corners.map(|(x, y)| vec![DVec3::new(x, y, -1.0), DVec3::new(x, y, 1.0)]);
        [ring(1.0), ring(-1.0)].into_iter().chain(edges).collect()
    }

    fn implicit(&self, point: DVec3) -> f64 {
        point.abs().max_element() - 1.0
    }

    fn equation(&self) -> String {
        "max(|x|, |y|, |z|) − 1".to_owned()
    }

    fn parts(&self) -> Vec<String> {
        NAMES.map(str::to_owned).to_vec()
    }
}
