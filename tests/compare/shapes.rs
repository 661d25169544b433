//! The primitives of the sample ray tracer in generic coordinates, and its Boolean operators.

use super::Bug;
use super::scene::{Leaf, Object, Solid};
use glam::DVec3;

/// A crossing of a surface.
#[derive(Clone, Copy, Debug)]
pub struct Crossing {
    pub t: f64,
    pub leaf: usize,
    /// The normal in generic coordinates.
    pub normal: DVec3,
    /// The leaf is subtracted.
    pub turned: bool,
}

/// The ray in the leaf's generic coordinates.
pub fn generic(leaf: &Leaf, origin: DVec3, direction: DVec3, bug: Bug) -> [DVec3; 2] {
    let s = leaf.inverse.transform_point3(origin);
    let c = match bug {
        Bug::DirectionTranslated => leaf.inverse.transform_point3(direction),
        _ => leaf.inverse.transform_vector3(direction),
    };
    [s, if bug == Bug::DirectionNormalised { c.normalize() } else { c }]
}

/// All crossings with a leaf, in order.
pub fn crossings(leaf: &Leaf, number: usize, s: DVec3, c: DVec3, bug: Bug) -> Vec<Crossing> {
    let mut found: Vec<(f64, DVec3)> = match leaf.shape.as_str() {
        "plane" if c.z != 0.0 => vec![(-s.z / c.z, DVec3::Z)],
        "plane" => vec![],
        "sphere" => roots(c.dot(c), s.dot(c), s.dot(s) - 1.0, bug).into_iter().map(|t| (t, s + c * t)).collect(),
        "cylinder" => cylinder(s, c, bug),
        "cube" => cube(s, c),
        other => panic!("the sample has no {other}"),
    };
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.into_iter().map(|(t, normal)| Crossing { t, leaf: number, normal, turned: false }).collect()
}

fn roots(a: f64, b: f64, c: f64, bug: Bug) -> Vec<f64> {
    let discriminant = b * b - a * c;
    if discriminant <= 0.0 || a == 0.0 {
        return vec![];
    }
    let root = discriminant.sqrt();
    let a = if bug == Bug::QuadraticUnitA { 1.0 } else { a };
    vec![(-b - root) / a, (-b + root) / a]
}

fn cylinder(s: DVec3, c: DVec3, bug: Bug) -> Vec<(f64, DVec3)> {
    let (a, b, k) = (c.x * c.x + c.y * c.y, s.x * c.x + s.y * c.y, s.x * s.x + s.y * s.y - 1.0);
    let mut found = Vec::new();
    for t in roots(a, b, k, bug) {
        let p = s + c * t;
        if bug == Bug::WallUnbounded || (0.0..=1.0).contains(&p.z) {
            found.push((t, DVec3::new(p.x, p.y, 0.0)));
        }
    }
    if bug != Bug::CapMissing {
        for (z, normal) in [(0.0, -DVec3::Z), (1.0, DVec3::Z)] {
            let t = (z - s.z) / c.z;
            let p = s + c * t;
            if p.x * p.x + p.y * p.y <= 1.0 || bug == Bug::CapUnbounded {
                found.push((t, normal));
            }
        }
    }
    found
}

fn cube(s: DVec3, c: DVec3) -> Vec<(f64, DVec3)> {
    let (mut enter, mut leave) = ((f64::NEG_INFINITY, DVec3::ZERO), (f64::INFINITY, DVec3::ZERO));
    for axis in 0..3 {
        let mut unit = DVec3::ZERO;
        unit[axis] = c[axis].signum();
        let [near, far] = [(-unit[axis] - s[axis]) / c[axis], (unit[axis] - s[axis]) / c[axis]];
        enter = if near > enter.0 { (near, -unit) } else { enter };
        leave = if far < leave.0 { (far, unit) } else { leave };
    }
    if enter.0 < leave.0 { vec![enter, leave] } else { vec![] }
}

/// The boundaries of an object along a ray, in order.
pub fn boundaries(object: &Object, of_leaf: &dyn Fn(usize) -> Vec<Crossing>, bug: Bug) -> Vec<Crossing> {
    inside(&object.solid, of_leaf, bug)
}

fn inside(solid: &Solid, of_leaf: &dyn Fn(usize) -> Vec<Crossing>, bug: Bug) -> Vec<Crossing> {
    let (operator, left, right) = match solid {
        Solid::Leaf(leaf) => return of_leaf(*leaf),
        Solid::Pair(operator, left, right) => (operator.as_str(), left, right),
    };
    let left = inside(left, of_leaf, bug);
    let mut right = inside(right, of_leaf, bug);
    if operator == "difference" && bug != Bug::OperandNormal {
        for crossing in &mut right {
            crossing.turned = !crossing.turned;
        }
    }
    // Every solid of the sample is left behind far enough along the ray backwards.
    let (mut in_left, mut in_right, mut was_inside) = (false, false, false);
    let mut all: Vec<(Crossing, bool)> =
        left.into_iter().map(|c| (c, true)).chain(right.into_iter().map(|c| (c, false))).collect();
    all.sort_by(|a, b| a.0.t.total_cmp(&b.0.t));
    let mut result = Vec::new();
    for (crossing, is_left) in all {
        if is_left {
            in_left = !in_left;
        } else {
            in_right = !in_right;
        }
        let is_inside = match operator {
            "union" => in_left || in_right,
            "intersection" => in_left && in_right,
            _ => in_left && !in_right,
        };
        if is_inside != was_inside {
            result.push(crossing);
        }
        was_inside = is_inside;
    }
    result
}
