//! Convex polygons that are cut by straight lines.

use arrayvec::ArrayVec;
use glam::{DVec2, DVec3};

/// A convex polygon. A square that is cut into rows and columns has at most eight corners; the rest is for rounding.
#[derive(Clone, Debug, Default)]
pub(super) struct Polygon(ArrayVec<DVec2, 16>);

impl Polygon {
    /// The polygon with these corners, in order.
    pub fn new(corners: &[DVec2]) -> Self {
        Self(corners.iter().copied().take(16).collect())
    }

    /// Its corners.
    pub fn corners(&self) -> &[DVec2] {
        &self.0
    }

    /// Its area, by the shoelace formula about its first corner.
    pub fn area(&self) -> f64 {
        let Some((&first, rest)) = self.0.split_first() else { return 0.0 };
        let twice: f64 = rest.windows(2).map(|pair| (pair[0] - first).perp_dot(pair[1] - first)).sum();
        twice.abs() / 2.0
    }

    /// The pieces where `line` · (x, y, 1) is below 0 and where it is above.
    pub fn split(&self, line: DVec3) -> [Self; 2] {
        let [mut below, mut above] = [Self::default(), Self::default()];
        let Some(&last) = self.0.last() else { return [below, above] };
        let side = |corner: DVec2| line.x * corner.x + line.y * corner.y + line.z;
        let (mut from, mut from_side) = (last, side(last));
        for &to in &self.0 {
            let to_side = side(to);
            if (from_side < 0.0) != (to_side < 0.0) {
                let crossing = from.lerp(to, from_side / (from_side - to_side));
                below.push(crossing);
                above.push(crossing);
            }
            if to_side < 0.0 {
                below.push(to);
            } else {
                above.push(to);
            }
            (from, from_side) = (to, to_side);
        }
        [below, above]
    }

    /// Only rounding could make a corner too many, and the area between it and its neighbours is then next to nothing.
    fn push(&mut self, corner: DVec2) {
        if !self.0.is_full() {
            self.0.push(corner);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pieces_of_a_square_add_up_to_it() {
        let square = Polygon::new(&[DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y]);
        let [below, above] = square.split(DVec3::new(1.0, 1.0, -0.5));
        assert_eq!([below.area(), above.area()], [0.125, 0.875]);
        assert_eq!(above.corners().len(), 5);
        let [below, above] = square.split(DVec3::new(0.0, 0.0, 1.0));
        assert_eq!([below.area(), above.area()], [0.0, 1.0]);
    }
}
