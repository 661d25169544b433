//! Balls that hold a solid: the other extent of § 6.5.4, tighter than a box for what is round or stands askew.

use super::course::{ROUNDINGS, ball_scale};
use super::{Course, Placement};
use crate::record::Operator;
use crate::shape::{Bounds, Primitive};
use glam::DVec3;

/// A ball in world space; its radius is infinite where the solid is unbounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Its middle.
    pub centre: DVec3,
    /// Its radius.
    pub radius: f64,
}

impl Ball {
    /// The ball of everything.
    pub const UNBOUNDED: Self = Self { centre: DVec3::ZERO, radius: f64::INFINITY };

    /// The ball of a placed primitive, about the middle of its own box.
    ///
    /// M stretches nothing by more than its largest singular value, whose square is at most the largest row sum of
    /// |Mᵀ M|: with equality where M turns and scales alike.
    #[must_use]
    pub fn of_primitive(shape: &impl Primitive, placement: &Placement) -> Self {
        let Bounds { low, high } = shape.bounds();
        if !(low.is_finite() && high.is_finite()) {
            return Self::UNBOUNDED;
        }
        let (map, middle) = (placement.world_from_generic(), (low + high) * 0.5);
        let centre = map.transform_point3(middle);
        let squares = (map.matrix3.transpose() * map.matrix3).abs() * DVec3::ONE;
        let radius = shape.ball_radius() * squares.max_element().sqrt();
        let size = radius + (map.matrix3.abs() * middle.abs() + map.translation.abs()).length();
        let ball = Self { centre, radius: radius + size * ROUNDINGS * placement.skew() };
        if ball.centre.is_finite() && !ball.radius.is_nan() { ball } else { Self::UNBOUNDED }
    }

    /// The ball of a compound, from those of its operands.
    #[must_use]
    pub fn of_pair(operator: Operator, left: Self, right: Self) -> Self {
        match operator {
            Operator::Union => left.joined(right),
            Operator::Intersection if right.radius < left.radius => right,
            Operator::Intersection | Operator::Difference => left,
        }
    }

    /// The smallest ball that holds two balls.
    #[must_use]
    pub fn joined(self, other: Self) -> Self {
        let (small, large) = if self.radius < other.radius { (self, other) } else { (other, self) };
        let way = small.centre - large.centre;
        let distance = way.length();
        if large.radius.is_infinite() || distance + small.radius <= large.radius {
            return large;
        }
        let radius = 0.5 * (distance + small.radius + large.radius);
        let centre = large.centre + way * ((radius - large.radius) / distance);
        // Roundings of the middle and of the sums, which are all smaller than this.
        let padding = ROUNDINGS * (radius + centre.abs().max_element());
        if centre.is_finite() && radius.is_finite() {
            Self { centre, radius: radius + padding }
        } else {
            Self::UNBOUNDED
        }
    }

    /// How far the ray's line passes from the middle: |(C − S) × c| / |c|.
    #[must_use]
    pub fn distance(&self, course: &Course) -> f64 {
        let [origin, direction] = course.line;
        (self.centre - origin).cross(direction.normalize_or_zero()).length()
    }

    /// Whether the ray's line surely passes outside.
    #[must_use]
    #[inline]
    pub fn is_missed(&self, course: &Course) -> bool {
        let [origin, direction] = course.line;
        let way = self.centre - origin;
        let moment = way.cross(direction);
        // What rounding can do to the ray on its way into generic coordinates, and to the cross product here.
        let slack = ROUNDINGS * course.skew * (origin.abs().max_element() + way.abs().element_sum());
        let reach = self.radius + slack;
        moment.length_squared() > reach * reach * ball_scale(direction)
    }

    /// Half its surface: like that of a box in proportion to the share of random rays that meet it.
    #[must_use]
    pub fn half_surface(&self) -> f64 {
        2.0 * std::f64::consts::PI * self.radius * self.radius
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::NullRecorder;
    use crate::shape::{Crossings, Shape, Sphere, TaperedCylinder, Torus};
    use glam::{DAffine3, DMat3, DQuat};
    use proptest::prelude::*;

    fn triple(size: f64) -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-size..size).prop_map(DVec3::from_array)
    }

    fn shapes() -> Vec<Shape> {
        vec![
            Shape::Sphere(Sphere::new().unwrap()),
            Shape::Torus(Torus::new(2.0).unwrap()),
            Shape::TaperedCylinder(TaperedCylinder::new(1.5).unwrap()),
        ]
    }

    proptest! {
        #[test]
        fn a_ray_that_misses_the_ball_misses_what_is_in_it(
            rows in prop::array::uniform3(triple(2.0)), at in triple(50.0), origin in triple(20.0), aim in triple(3.0),
        ) {
            let map = DAffine3::from_mat3_translation(DMat3::from_cols(rows[0], rows[1], rows[2]), at);
            let Ok(placement) = Placement::new(map) else { return Ok(()) };
            let direction = at + aim - origin;
            for shape in shapes() {
                let ball = Ball::of_primitive(&shape, &placement);
                let mut crossings = Crossings::new();
                shape.crossings(&placement.generic_ray::<f64>(&[origin, direction]), &mut NullRecorder, &mut crossings);
                let course = Course::new(origin, direction, placement.skew());
                prop_assert!(crossings.is_empty() || !ball.is_missed(&course), "{shape:?} {ball:?}");
                prop_assert!(ball.is_missed(&course) || ball.distance(&course) <= ball.radius * (1.0 + 1e-9));
            }
        }

        #[test]
        fn two_balls_are_held_by_their_union(a in triple(9.0), b in triple(9.0), radii in (0.0..5.0, 0.0..5.0), to in triple(1.0)) {
            let balls = [Ball { centre: a, radius: radii.0 }, Ball { centre: b, radius: radii.1 }];
            let union = balls[0].joined(balls[1]);
            for ball in balls {
                let point = ball.centre + to.normalize_or_zero() * ball.radius;
                prop_assert!(union.centre.distance(point) <= union.radius * (1.0 + 1e-15) + 1e-15);
            }
        }
    }

    #[test]
    fn a_turned_and_scaled_ball_stays_as_tight_as_it_was() {
        let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -2.0) / 3.0, 0.7);
        let map = DAffine3::from_scale_rotation_translation(DVec3::splat(2.5), turn, DVec3::new(3.0, -4.0, 12.0));
        let ball = Ball::of_primitive(&Sphere::new().unwrap(), &Placement::new(map).unwrap());
        assert!(ball.centre.abs_diff_eq(DVec3::new(3.0, -4.0, 12.0), 1e-14));
        assert!(ball.radius >= 2.5 && ball.radius < 2.5 * (1.0 + 1e-12));
    }

    #[test]
    fn directions_beyond_squares_miss_nothing() {
        let ball = Ball { centre: DVec3::ZERO, radius: 1.0 };
        for size in [1e-170, 1e170] {
            assert!(!ball.is_missed(&Course::new(DVec3::new(-5.0, 0.5, 0.0), DVec3::X * size, 1.0)));
        }
        assert!(ball.is_missed(&Course::new(DVec3::new(-5.0, 1.5, 0.0), DVec3::X, 1.0)));
    }
}
