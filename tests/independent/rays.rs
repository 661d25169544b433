//! Rays that are hard for a solver, in turn.

use super::exact::Exact;
use super::random::Random;
use glam::DVec3;

/// How many kinds of rays there are.
const KINDS: usize = 7;

/// The ray number `k`: origin and direction.
pub fn ray(solid: &Exact, k: usize, random: &mut Random) -> (DVec3, DVec3) {
    let (on_surface, normal) = surface_point(solid, random);
    let across = normal.cross(random.direction()).normalize();
    let (origin, direction) = match k % KINDS {
        0 => {
            let target = on_surface * random.between(0.0, 1.2);
            aimed(target, random.direction(), 8.0, random)
        }
        1 => {
            // Past the surface, or through it, by a hair.
            let gap = 10.0_f64.powf(random.between(-13.0, -1.0)) * if random.below(2) == 0 { 1.0 } else { -1.0 };
            aimed(on_surface + normal * gap, across, 3.0, random)
        }
        2 => aimed(edge_point(solid, on_surface, random), random.direction(), 8.0, random),
        3 => {
            // Along an axis, or in a plane of two.
            let mut along = DVec3::ZERO;
            along[random.below(3)] = 1.0;
            along[random.below(3)] = random.between(-1.0, 1.0);
            aimed(on_surface * random.between(0.0, 1.0), along, 6.0, random)
        }
        4 => (on_surface, random.direction()),
        5 => {
            let eighths = |v: DVec3| (v * 8.0).round() / 8.0;
            let direction = eighths(random.vector(-1.0, 1.0));
            let direction = if direction == DVec3::ZERO { DVec3::X } else { direction };
            (eighths(random.vector(-3.0, 3.0)), direction)
        }
        // Nearly along the surface from a point of it.
        _ => (on_surface, across + normal * 10.0_f64.powf(random.between(-8.0, -1.0))),
    };
    let length = if random.below(2) == 0 { 1.0 } else { 10.0_f64.powf(random.between(-240.0, 240.0)) };
    (origin, direction * length)
}

/// Through the point, from a distance of 1 to 10 to the given power.
fn aimed(target: DVec3, direction: DVec3, farthest: f64, random: &mut Random) -> (DVec3, DVec3) {
    (target - direction * 10.0_f64.powf(random.between(0.0, farthest)), direction)
}

/// A point of the surface with the outward unit normal there.
pub fn surface_point(solid: &Exact, random: &mut Random) -> (DVec3, DVec3) {
    let towards = random.direction();
    match solid {
        Exact::Sphere => (towards, towards),
        Exact::Tapered(s) => {
            let z = random.between(0.0, 1.0);
            let (sin, cos) = random.between(0.0, std::f64::consts::TAU).sin_cos();
            let radius = 1.0 + (s - 1.0) * z;
            (DVec3::new(radius * cos, radius * sin, z), DVec3::new(cos, sin, 1.0 - s).normalize())
        }
        Exact::Planes(planes) => {
            let reach = |(n, d): &(DVec3, f64)| n.dot(towards) / d;
            let (n, d) = planes.iter().max_by(|a, b| reach(a).total_cmp(&reach(b))).unwrap();
            (towards * (d / n.dot(towards)), n.normalize())
        }
        Exact::Torus(d) => {
            let (sin, cos) = random.between(0.0, std::f64::consts::TAU).sin_cos();
            let widest = if *d < 1.0 { (-d).acos() } else { std::f64::consts::PI };
            let turn = random.between(-widest, widest);
            let normal = DVec3::new(turn.cos() * cos, turn.cos() * sin, turn.sin());
            (DVec3::new(*d * cos, *d * sin, 0.0) + normal, normal)
        }
        Exact::Super(n, m) => {
            let [x, y, z] = towards.abs().to_array();
            let flat = x.powf(*n) + y.powf(*n);
            let gauge = (flat.powf(m / n) + z.powf(*m)).powf(1.0 / m);
            let p = towards / gauge;
            let slope = |x: f64, e: f64| (x / gauge).powf(e - 1.0);
            let lean = (flat / gauge.powf(*n)).powf(m / n - 1.0);
            let normal = DVec3::new(lean * slope(x, *n), lean * slope(y, *n), slope(z, *m)) * p.signum();
            (p, normal.normalize())
        }
    }
}

/// A point where the surface may be hard: an edge, a rim, a tip, a plane of symmetry.
fn edge_point(solid: &Exact, on_surface: DVec3, random: &mut Random) -> DVec3 {
    let mut p = on_surface;
    match solid {
        Exact::Tapered(s) => {
            let (z, radius) = if random.below(2) == 0 { (0.0, 1.0) } else { (1.0, *s) };
            let flat = p.truncate().normalize() * radius;
            DVec3::new(flat.x, flat.y, z)
        }
        Exact::Planes(planes) => {
            let corner = p / p.abs().max_element();
            // Of the cube an edge; of the others a point near where three faces may meet.
            let snapped = DVec3::from_array(corner.to_array().map(|x| if x.abs() > 0.5 { x.signum() } else { x }));
            if planes.len() == 6 { snapped } else { p * 0.999 }
        }
        Exact::Torus(d) if random.below(2) == 0 => DVec3::new(0.0, 0.0, (1.0 - d * d).max(0.0).sqrt()),
        Exact::Sphere | Exact::Torus(_) | Exact::Super(..) => {
            p[random.below(3)] = 0.0;
            p
        }
    }
}
