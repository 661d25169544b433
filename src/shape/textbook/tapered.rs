//! The tapered cylinder, and with s = 1 and s = 0 cylinder and cone: the wall's quadratic, each root tested for
//! 0 < z < 1, and the two discs, each hit tested for its distance from the axis.
//!
//! **Where it fails** At the rims: wall and disc are tested one by one, on points that have been rounded each in its own way,
//! so that a ray through a rim may be counted twice or not at all. Then an odd number of hits is left, and inside and outside
//! change places. Along a side of the cone A nearly vanishes and −B + √D cancels. From afar the squares of S cancel, as
//! with the sphere.
//!
//! **Source** F. S. Hill, Computer Graphics Using OpenGL, 2nd ed., § 14.7, the generic tapered cylinder.

use super::append_alternating;
use crate::shape::{Crossings, GenericRay, Part};

const WALL: Part = 0;
const BASE: Part = 1;
const CAP: Part = 2;

/// A handful of hits without a heap.
#[derive(Default)]
struct Hits {
    items: [(f64, Part); 4],
    count: usize,
}

impl Hits {
    fn push(&mut self, tau: f64, part: Part) {
        if let Some(slot) = self.items.get_mut(self.count) {
            *slot = (tau, part);
            self.count += 1;
        }
    }
}

/// Wrong at the rims, along a side, and from afar.
pub fn crossings(s: f64, ray: &GenericRay<f64>, crossings: &mut Crossings) {
    let mut hits = Hits::default();
    wall(s, ray, &mut hits);
    discs(s, ray, &mut hits);
    append_alternating(ray, &mut hits.items[..hits.count], crossings);
}

fn wall(s: f64, ray: &GenericRay<f64>, hits: &mut Hits) {
    let ([sx, sy, sz], [cx, cy, cz]) = (ray.origin, ray.direction);
    let d = (s - 1.0) * cz;
    let f = 1.0 + (s - 1.0) * sz;
    let a = cx * cx + cy * cy - d * d;
    let b = sx * cx + sy * cy - f * d;
    let c = sx * sx + sy * sy - f * f;
    let mut test = |tau: f64| {
        let z = sz + cz * tau;
        if 0.0 < z && z < 1.0 {
            hits.push(tau, WALL);
        }
    };
    if a == 0.0 {
        if b != 0.0 {
            test(-c / (2.0 * b));
        }
        return;
    }
    let discriminant = b * b - a * c;
    if discriminant > 0.0 {
        let root = discriminant.sqrt();
        test((-b - root) / a);
        test((-b + root) / a);
    }
}

fn discs(s: f64, ray: &GenericRay<f64>, hits: &mut Hits) {
    let (sz, cz) = (ray.origin[2], ray.direction[2]);
    if cz == 0.0 {
        return;
    }
    for (tau, radius, part) in [(-sz / cz, 1.0, BASE), ((1.0 - sz) / cz, s, CAP)] {
        let [x, y, _] = ray.at(tau);
        if x * x + y * y < radius * radius {
            hits.push(tau, part);
        }
    }
}
