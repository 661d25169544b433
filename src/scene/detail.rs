//! Polygons that lie on a face and take precedence over it (§ 6.3.0).
//!
//! A detail has no surface of its own that a ray could hit before or behind the face's: the face is hit, and the detail only
//! says which material is there. So nothing flickers between the two, however thin the paint.

use crate::shape::Part;
use glam::DVec2;

/// A polygon on a flat part of a primitive, with its own material.
#[derive(Clone, Debug, PartialEq)]
pub struct Detail {
    /// The part that it lies on.
    pub part: Part,
    /// Its corners in (u, v), in either order; a point is within it if an odd number of its rings' turns go round it.
    pub polygon: Vec<DVec2>,
    /// How often the polygon repeats along u and v; it is then given in one cell of the pattern, from 0 to 1.
    pub repeat: Option<DVec2>,
    /// Its material: an index into [`Scene::materials`](super::Scene::materials).
    pub material: usize,
    /// Polygons that lie on this one.
    pub details: Vec<Self>,
}

impl Detail {
    /// The topmost of `details` at a place of a part, with the place in its own cell.
    #[must_use]
    pub fn topmost(details: &[Self], part: Part, uv: DVec2) -> Option<(&Self, DVec2)> {
        let on_top = details.iter().rev().filter(|detail| detail.part == part);
        let (found, cell) =
            on_top.map(|detail| (detail, detail.cell(uv))).find(|(detail, cell)| detail.holds(*cell))?;
        Self::topmost(&found.details, part, cell).or(Some((found, cell)))
    }

    /// All materials of these details and of those that lie on them.
    pub fn materials(details: &[Self]) -> impl Iterator<Item = usize> {
        details.iter().flat_map(|detail| {
            let above: Vec<_> = Self::materials(&detail.details).collect();
            std::iter::once(detail.material).chain(above)
        })
    }

    /// The place within the cell of the pattern.
    fn cell(&self, uv: DVec2) -> DVec2 {
        let Some(repeat) = self.repeat else { return uv };
        let scaled = uv * repeat;
        // The far edge belongs to the last cell.
        let last = repeat - 1.0;
        let whole = DVec2::select(scaled.cmpeq(repeat), last, scaled.floor());
        scaled - whole
    }

    /// Whether the place lies within the polygon. Of two polygons that share an edge, each place of it belongs to one.
    fn holds(&self, place: DVec2) -> bool {
        let ends = self.polygon.iter().zip(self.polygon.iter().cycle().skip(1));
        let crossed = ends.filter(|&(&a, &b)| {
            let spans = (a.y > place.y) != (b.y > place.y);
            // Always from the lower end, so that both neighbours compute the same crossing.
            let (low, high) = if a.y < b.y { (a, b) } else { (b, a) };
            spans && place.x < low.x + (place.y - low.y) * (high.x - low.x) / (high.y - low.y)
        });
        crossed.count() % 2 == 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(corners: &[[f64; 2]], material: usize) -> Detail {
        let polygon = corners.iter().map(|&corner| DVec2::from_array(corner)).collect();
        Detail { part: 0, polygon, repeat: None, material, details: Vec::new() }
    }

    fn material_at(details: &[Detail], u: f64, v: f64) -> Option<usize> {
        Detail::topmost(details, 0, DVec2::new(u, v)).map(|(detail, _)| detail.material)
    }

    #[test]
    fn a_place_on_the_edge_of_two_neighbours_belongs_to_one_of_them() {
        let left = polygon(&[[0.0, 0.0], [0.3, 0.0], [0.7, 1.0], [0.0, 1.0]], 1);
        let right = polygon(&[[0.3, 0.0], [1.0, 0.0], [1.0, 1.0], [0.7, 1.0]], 2);
        for step in 0..1000 {
            let v = f64::from(step) / 1000.0;
            let place = DVec2::new(0.3 + 0.4 * v, v);
            assert_eq!(usize::from(left.holds(place)) + usize::from(right.holds(place)), 1, "{place}");
        }
    }

    #[test]
    fn the_last_polygon_lies_on_top_and_those_on_it_on_top_of_it() {
        let square =
            |low: f64, high: f64, material| polygon(&[[low, low], [high, low], [high, high], [low, high]], material);
        let upper = Detail { details: vec![square(0.4, 0.6, 3)], ..square(0.2, 0.8, 2) };
        let details = [square(0.1, 0.9, 1), upper];
        assert_eq!(material_at(&details, 0.05, 0.5), None);
        assert_eq!(material_at(&details, 0.15, 0.5), Some(1));
        assert_eq!(material_at(&details, 0.3, 0.5), Some(2));
        assert_eq!(material_at(&details, 0.5, 0.5), Some(3));
        assert_eq!(Detail::materials(&details).collect::<Vec<_>>(), [1, 2, 3]);
    }

    #[test]
    fn a_star_has_a_hole_where_its_ring_goes_round_twice() {
        let corner = |k: usize| {
            let angle = std::f64::consts::TAU * (0.25 + 0.4 * f64::from(u32::try_from(k).unwrap()));
            [0.5 + 0.5 * angle.cos(), 0.5 + 0.5 * angle.sin()]
        };
        let star = polygon(&[0, 1, 2, 3, 4].map(corner), 7);
        assert_eq!(material_at(std::slice::from_ref(&star), 0.5, 0.5), None);
        assert_eq!(material_at(&[star], 0.5, 0.9), Some(7));
    }

    #[test]
    fn a_pattern_repeats_up_to_the_far_edge() {
        let half = Detail {
            repeat: Some(DVec2::new(4.0, 2.0)),
            ..polygon(&[[0.0, 0.0], [0.5, 0.0], [0.5, 1.0], [0.0, 1.0]], 5)
        };
        let at = |u: f64| material_at(std::slice::from_ref(&half), u, 0.3).is_some();
        assert_eq!(
            [0.0, 0.1, 0.2, 0.3, 0.4, 0.55, 0.7, 0.8, 0.95, 1.0].map(at),
            [true, true, false, true, false, true, false, true, false, false]
        );
    }
}
