//! Cube and convex polyhedron: the ray is inside from the last plane that it enters to the first that it leaves.
//!
//! **Where they fail** At edges, where two hit times that are nearly the same are compared after each has been rounded in its
//! own way: a ray that just hits is missed, or the other way round. From afar d − n·S cancels, and its error does not
//! shrink with the cancellation. The cube's planes have no such sum, so it keeps its digits better. Of all the textbook's
//! solvers these need a cure least: what they get wrong, half a last digit of the ray could excuse.
//!
//! **Source** T. L. Kay and J. T. Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986, for the slabs; M. Cyrus and J. Beck,
//! "Generalized two- and three-dimensional clipping", Computers & Graphics 3 (1978), for the planes; F. S. Hill, Computer
//! Graphics Using OpenGL, 2nd ed., § 14.7.

use super::crossing;
use crate::math::dot;
use crate::record::Sense;
use crate::shape::{Crossings, GenericRay, HalfSpace, Part};

/// The stretch of the ray that is left, with the parts at its ends.
#[derive(Clone, Copy)]
struct Stretch {
    enter: (f64, Part),
    leave: (f64, Part),
}

impl Stretch {
    const WHOLE: Self = Self { enter: (f64::NEG_INFINITY, 0), leave: (f64::INFINITY, 0) };

    fn enters(&mut self, tau: f64, part: Part) {
        if tau > self.enter.0 {
            self.enter = (tau, part);
        }
    }

    fn leaves(&mut self, tau: f64, part: Part) {
        if tau < self.leave.0 {
            self.leave = (tau, part);
        }
    }

    fn append(self, ray: &GenericRay<f64>, crossings: &mut Crossings) {
        if self.enter.0 <= self.leave.0 {
            crossings.push(crossing(ray, self.enter.0, Sense::Enter, self.enter.1));
            crossings.push(crossing(ray, self.leave.0, Sense::Leave, self.leave.1));
        }
    }
}

/// The parts at +1 and −1 of each axis.
const FACES: [[Part; 2]; 3] = [[2, 3], [0, 1], [4, 5]];

/// Three slabs after Kay and Kajiya: wrong within rounding of an edge.
pub fn cube(ray: &GenericRay<f64>, crossings: &mut Crossings) {
    let mut inside = Stretch::WHOLE;
    for (axis, [plus, minus]) in FACES.into_iter().enumerate() {
        let (start, speed) = (ray.origin[axis], ray.direction[axis]);
        if speed == 0.0 {
            if start.abs() > 1.0 {
                return;
            }
            continue;
        }
        let (low, high) = ((-1.0 - start) / speed, (1.0 - start) / speed);
        if speed > 0.0 {
            inside.enters(low, minus);
            inside.leaves(high, plus);
        } else {
            inside.enters(high, plus);
            inside.leaves(low, minus);
        }
    }
    inside.append(ray, crossings);
}

/// One plane after the other, after Cyrus and Beck: wrong within rounding of an edge, and from afar.
pub fn polyhedron(planes: &[HalfSpace], ray: &GenericRay<f64>, crossings: &mut Crossings) {
    let mut inside = Stretch::WHOLE;
    for (part, plane) in (0..).zip(planes) {
        let normal = plane.normal.to_array();
        let numerator = plane.offset - dot(normal, ray.origin);
        let denominator = dot(normal, ray.direction);
        if denominator > 0.0 {
            inside.leaves(numerator / denominator, part);
        } else if denominator < 0.0 {
            inside.enters(numerator / denominator, part);
        } else if numerator < 0.0 {
            return;
        }
    }
    inside.append(ray, crossings);
}
