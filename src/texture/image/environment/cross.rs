//! An environment on the six faces of a cube, laid out as a cross.
//!
//! Seen from inside. Four columns and three rows of faces:
//!
//! ```text
//!        +z                      +z
//!   +y   +x   −y   −x       +y   +x   −y
//!        −z                      −z
//!                                −x   upside down
//! ```
//!
//! or three columns and four rows. The front face looks along +x with +z up; the faces around it are folded back from it.

use super::chart::{Chart, Region};
use glam::{DVec2, DVec3};

/// A face of the cube: directions are `ahead` + x `right` + y `down` with x and y from −1 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Face {
    /// The column and row of the face in the cross.
    pub place: [u32; 2],
    pub ahead: DVec3,
    pub right: DVec3,
    pub down: DVec3,
}

const fn face(place: [u32; 2], ahead: DVec3, right: DVec3, down: DVec3) -> Face {
    Face { place, ahead, right, down }
}

/// The faces that both crosses have in the same places.
const COMMON: [Face; 5] = [
    face([1, 0], DVec3::Z, DVec3::NEG_Y, DVec3::X),
    face([0, 1], DVec3::Y, DVec3::X, DVec3::NEG_Z),
    face([1, 1], DVec3::X, DVec3::NEG_Y, DVec3::NEG_Z),
    face([2, 1], DVec3::NEG_Y, DVec3::NEG_X, DVec3::NEG_Z),
    face([1, 2], DVec3::NEG_Z, DVec3::NEG_Y, DVec3::NEG_X),
];

/// The back face, at the right end of the lying cross.
const BACK_LYING: Face = face([3, 1], DVec3::NEG_X, DVec3::Y, DVec3::NEG_Z);

/// The back face, at the foot of the standing cross.
const BACK_STANDING: Face = face([1, 3], DVec3::NEG_X, DVec3::NEG_Y, DVec3::Z);

/// The faces of a cross, and how many texels each is wide and high.
pub(super) fn faces([width, height]: [u32; 2]) -> Result<([Face; 6], u32), String> {
    let [a, b, c, d, e] = COMMON;
    let count = width.min(height) / 3;
    if [width, height] == [4 * count, 3 * count] {
        Ok(([a, b, c, d, e, BACK_LYING], count))
    } else if [width, height] == [3 * count, 4 * count] {
        Ok(([a, b, c, d, e, BACK_STANDING], count))
    } else {
        Err(format!(
            "the image has {width} × {height} texels; a cross has four faces by three (such as 1024 × 768) or three by four \
             (such as 768 × 1024)"
        ))
    }
}

impl Face {
    /// Its chart, if it has `count` columns.
    pub fn chart(&self, count: u32) -> Chart {
        Chart::Face { count, origin: self.place.map(|place| i64::from(place) * i64::from(count)) }
    }

    /// A direction's place on the face; of use only where the face is what the direction meets.
    pub fn project(&self, direction: DVec3) -> DVec2 {
        DVec2::new(direction.dot(self.right), direction.dot(self.down)) / direction.dot(self.ahead)
    }

    /// The part of a polygon of directions that the face holds; none if it holds nothing.
    pub fn region(&self, chart: usize, corners: &[DVec3]) -> Option<Region> {
        let mut rest = corners.to_vec();
        for normal in [self.ahead - self.right, self.ahead + self.right, self.ahead - self.down, self.ahead + self.down]
        {
            rest = clip(&rest, normal);
        }
        let polygon: Vec<_> =
            rest.iter().map(|corner| self.project(*corner)).filter(|place| place.is_finite()).collect();
        (polygon.len() > 2).then_some(Region { chart, polygon })
    }
}

/// The number of the face that a direction meets: the one that it goes towards most.
pub(super) fn met(faces: &[Face; 6], direction: DVec3) -> usize {
    let towards = |i: &usize| direction.dot(faces[*i].ahead);
    (0..6).rev().max_by(|i, j| towards(i).total_cmp(&towards(j))).unwrap_or(0)
}

/// The part of a polygon of directions on one side of a plane through the eye.
fn clip(corners: &[DVec3], normal: DVec3) -> Vec<DVec3> {
    let mut kept = Vec::with_capacity(corners.len() + 1);
    let Some(mut from) = corners.last() else { return kept };
    for to in corners {
        let [from_side, to_side] = [from, to].map(|corner| corner.dot(normal));
        if (from_side < 0.0) != (to_side < 0.0) {
            kept.push(from.lerp(*to, from_side / (from_side - to_side)));
        }
        if to_side >= 0.0 {
            kept.push(*to);
        }
        from = to;
    }
    kept
}
