//! Lights.

use super::Rgb;
use crate::sample::concentric_disc;
use glam::DVec3;

/// Where light comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// A point; its light does not fade with distance.
    Point(DVec3),
    /// From infinitely far away; the unit vector **towards** the light.
    Directional(DVec3),
    /// From every point of a shape alike.
    Area(Area),
}

impl LightKind {
    /// The word for it, as scene files spell it.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Point(_) => "point",
            Self::Directional(_) => "directional",
            Self::Area(area) => area.name(),
        }
    }
}

/// A light source.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Its name.
    pub name: String,
    /// Point, directional or with a size.
    pub kind: LightKind,
    /// How many points of it are asked at each hit; 1 where it has no size.
    pub samples: u32,
    /// Its colour, not limited to 1.
    pub colour: Rgb,
}

/// The shape of a light that has a size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Area {
    /// A disc: its middle, and two radii at right angles.
    Disc {
        /// Its middle.
        centre: DVec3,
        /// Two radii at right angles.
        radii: [DVec3; 2],
    },
    /// A parallelogram.
    Rectangle {
        /// One of its corners.
        corner: DVec3,
        /// The edges that start there.
        edges: [DVec3; 2],
    },
    /// A sphere.
    Sphere {
        /// Its middle.
        centre: DVec3,
        /// Its radius.
        radius: f64,
    },
}

impl Area {
    /// Its middle.
    #[must_use]
    pub fn middle(&self) -> DVec3 {
        match *self {
            Self::Disc { centre, .. } | Self::Sphere { centre, .. } => centre,
            Self::Rectangle { corner, edges } => corner + (edges[0] + edges[1]) * 0.5,
        }
    }

    /// The point of the light for a place in the unit square, where it is seen from `from`.
    ///
    /// Discs and rectangles are covered evenly. Of a sphere only the half that is seen gives light, and that by the size at
    /// which it is seen: points are chosen evenly in the cone of directions towards it. So what arrives is the share of the
    /// sphere that is in sight, and no point is wasted on the far side.
    #[must_use]
    pub fn point_at(&self, place: [f64; 2], from: DVec3) -> DVec3 {
        match *self {
            Self::Disc { centre, radii } => {
                let [x, y] = concentric_disc(place);
                centre + radii[0] * x + radii[1] * y
            }
            Self::Rectangle { corner, edges } => corner + edges[0] * place[0] + edges[1] * place[1],
            Self::Sphere { centre, radius } => point_of_sphere([centre, from], radius, concentric_disc(place)),
        }
    }

    /// The word for it, as scene files spell it.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Disc { .. } => "disc",
            Self::Rectangle { .. } => "rectangle",
            Self::Sphere { .. } => "sphere",
        }
    }
}

/// The point of a sphere that a direction in the cone towards it meets first; `disc` is the place in the cone's cross-section,
/// even in its solid angle: 1 − cos θ is in proportion to the square of the distance from the middle. From within the sphere
/// all directions are towards it.
fn point_of_sphere([centre, from]: [DVec3; 2], radius: f64, disc: [f64; 2]) -> DVec3 {
    let axis = centre - from;
    let squared_distance = axis.length_squared();
    let squared_sine = radius * radius / squared_distance;
    let is_outside = squared_sine < 1.0;
    // 1 − cos of the cone's half angle, without the difference of two numbers that are nearly equal.
    let cap = if is_outside { squared_sine / (1.0 + (1.0 - squared_sine).sqrt()) } else { 2.0 };
    let squared_place = disc[0] * disc[0] + disc[1] * disc[1];
    let height = cap * squared_place;
    let forward = axis.normalize_or(DVec3::Z);
    let (right, up) = forward.any_orthonormal_pair();
    let across = (cap * (2.0 - height).max(0.0)).sqrt();
    let direction = forward * (1.0 - height) + right * (disc[0] * across) + up * (disc[1] * across);
    if !is_outside {
        return centre + direction * radius;
    }
    let along = axis.dot(direction);
    let half_chord = (radius * radius - squared_distance + along * along).max(0.0).sqrt();
    from + direction * (along - half_chord)
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLACES: [[f64; 2]; 6] = [[0.5, 0.5], [0.0, 0.0], [1.0, 0.3], [0.25, 0.75], [0.9, 0.1], [0.5, 1.0]];

    #[test]
    fn points_of_a_sphere_lie_on_the_half_that_is_seen() {
        let (centre, radius, from) = (DVec3::new(1.0, 2.0, 3.0), 0.75, DVec3::new(-2.0, 0.5, 9.0));
        let sphere = Area::Sphere { centre, radius };
        for place in PLACES {
            let point = sphere.point_at(place, from);
            assert!((point.distance(centre) - radius).abs() < 1e-12, "{place:?}: {point}");
            assert!((point - centre).dot(from - point) > -1e-6, "{place:?}: {point}");
        }
        assert_eq!(sphere.point_at([0.5, 0.5], DVec3::new(1.0, 2.0, 8.0)), DVec3::new(1.0, 2.0, 3.75));
    }

    /// A sphere of radius 3 seen from 5 away: the cone's half angle has the sine 3/5 and the cosine 4/5. A quarter of its
    /// solid angle lies within cos θ = 1 − (1 − 4/5)/4 = 0.95.
    #[test]
    fn the_rim_of_the_square_is_the_rim_of_the_sphere_as_it_is_seen() {
        let sphere = Area::Sphere { centre: DVec3::Z * 5.0, radius: 3.0 };
        let cosine = |place| sphere.point_at(place, DVec3::ZERO).normalize().z;
        assert!((cosine([1.0, 0.5]) - 0.8).abs() < 1e-12);
        assert!((cosine([0.5, 0.0]) - 0.8).abs() < 1e-12);
        assert!((cosine([0.75, 0.5]) - 0.95).abs() < 1e-12);
    }

    #[test]
    fn from_within_a_sphere_all_of_it_is_seen() {
        let sphere = Area::Sphere { centre: DVec3::ZERO, radius: 2.0 };
        for place in PLACES {
            for from in [DVec3::ZERO, DVec3::new(0.5, 0.0, 1.0)] {
                assert!((sphere.point_at(place, from).length() - 2.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn points_of_discs_and_rectangles_lie_within_them() {
        let disc = Area::Disc { centre: DVec3::Z, radii: [DVec3::X * 2.0, DVec3::Y * 2.0] };
        let rectangle = Area::Rectangle { corner: DVec3::ONE, edges: [DVec3::X, DVec3::Y * 3.0] };
        for [x, y] in PLACES {
            let point = disc.point_at([x, y], DVec3::ZERO);
            assert!(point.z == 1.0 && point.truncate().length() < 2.0 + 1e-12);
            assert_eq!(rectangle.point_at([x, y], DVec3::ZERO), DVec3::new(1.0 + x, 1.0 + 3.0 * y, 1.0));
        }
        assert_eq!([disc.middle(), rectangle.middle()], [DVec3::Z, DVec3::new(1.5, 2.5, 1.0)]);
    }
}
