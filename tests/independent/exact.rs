//! Where a line crosses a solid, to 40 digits and more, by means that the solvers do not use.
//!
//! Candidates are found first (quadratic formula, plane equations, Sturm's theorem, dense samples), then the solid is
//! asked between each two of them whether the line is inside. What changes that is a crossing.

use super::big::{Big, Line, big, dot, power};
use super::samples::{brackets, sign_changes};
use super::sturm::Sturm;
use glam::DVec3;

/// A solid by its equation.
#[derive(Clone, Debug)]
pub enum Exact {
    Sphere,
    /// Radius 1 at z = 0 and s at z = 1.
    Tapered(f64),
    /// n·p ≤ d for all (n, d).
    Planes(Vec<(DVec3, f64)>),
    /// The distance from the axis to the middle of the tube of radius 1.
    Torus(f64),
    /// The exponents n of x and y and m of z.
    Super(f64, f64),
}

impl Exact {
    /// Where the line goes in and out, in turn, measured from its foot. None where two crossings cannot be told apart.
    ///
    /// The solid is the given one grown by the length `growth`, which may be less than nothing.
    pub fn crossings(&self, line: &Line, growth: f64) -> Option<Vec<Big>> {
        let mut candidates = match self {
            Self::Sphere => Self::sphere(line, growth),
            Self::Tapered(s) => Self::tapered(line, *s, growth),
            Self::Planes(planes) => Self::planes(line, planes, growth),
            Self::Torus(d) => Self::quartic(line, *d, growth).roots_in(line, *d)?,
            Self::Super(n, m) => sign_changes(self, line, [*n, *m], growth),
        };
        candidates.sort();
        candidates.dedup();
        let mut crossings = Vec::new();
        let mut inside = false;
        for (k, candidate) in candidates.iter().enumerate() {
            let after = candidates.get(k + 1);
            let inside_after =
                after.is_some_and(|after| self.holds(&line.at(&((candidate + after) * big(0.5))), growth));
            if inside_after != inside {
                crossings.push(candidate.clone());
            }
            inside = inside_after;
        }
        Some(crossings)
    }

    /// How many crossings there are, as far as they can be told apart.
    pub fn count(&self, line: &Line, growth: f64) -> Option<usize> {
        match self {
            Self::Super(n, m) => Some(brackets(self, line, [*n, *m], growth).len()),
            Self::Torus(d) if *d >= 1.0 + growth => Some(Self::quartic(line, *d, growth).count_in(line, *d)),
            _ => Some(self.crossings(line, growth)?.len()),
        }
    }

    fn holds(&self, p: &[Big; 3], growth: f64) -> bool {
        self.value(p, growth) < Big::ZERO
    }

    /// Negative inside, positive outside.
    pub fn value(&self, p: &[Big; 3], growth: f64) -> Big {
        let grown = big(growth) + big(1.0);
        let [x, y, z] = p;
        match self {
            Self::Sphere => dot(p, p) - &grown * &grown,
            Self::Tapered(s) => {
                let radius = wall_radius(z, *s, growth);
                // Beyond the apex the radius grows again, but that is no wall.
                let wall = if radius < Big::ZERO { big(1.0) } else { x * x + y * y - &radius * &radius };
                largest([wall, -z.clone() - big(growth), z - &grown])
            }
            Self::Planes(planes) => {
                largest(planes.iter().map(|(n, d)| dot(&n.to_array().map(big), p) - grown_offset(*n, *d, growth)))
            }
            Self::Torus(d) => {
                let from_middle = (x * x + y * y).sqrt() - big(*d);
                &from_middle * &from_middle + z * z - &grown * &grown
            }
            Self::Super(n, m) => {
                let share = |x: &Big| {
                    let x = x / &grown;
                    if x < Big::ZERO { -x } else { x }
                };
                let flat = power(&share(x), *n) + power(&share(y), *n);
                power(&flat, m / n) + power(&share(z), *m) - big(1.0)
            }
        }
    }

    fn sphere(line: &Line, growth: f64) -> Vec<Big> {
        let radius = big(growth) + big(1.0);
        let l = &line.nearest;
        quadratic(&dot(&line.direction, &line.direction), &big(0.0), &(dot(l, l) - &radius * &radius))
    }

    fn tapered(line: &Line, s: f64, growth: f64) -> Vec<Big> {
        let ([x, y, z], [c_x, c_y, c_z]) = (&line.nearest, &line.direction);
        let (w, slope) = (wall_radius(z, s, growth), (big(s) - big(1.0)) * c_z);
        let mut times = quadratic(
            &(c_x * c_x + c_y * c_y - &slope * &slope),
            &(x * c_x + y * c_y - &w * &slope),
            &(x * x + y * y - &w * &w),
        );
        if *c_z != Big::ZERO {
            times.push((-big(growth) - z) / c_z);
            times.push((big(1.0) + big(growth) - z) / c_z);
        }
        times
    }

    fn planes(line: &Line, planes: &[(DVec3, f64)], growth: f64) -> Vec<Big> {
        let time = |(n, d): &(DVec3, f64)| {
            let normal = n.to_array().map(big);
            let along = dot(&normal, &line.direction);
            (along != Big::ZERO).then(|| (grown_offset(*n, *d, growth) - dot(&normal, &line.nearest)) / along)
        };
        planes.iter().filter_map(time).collect()
    }

    /// (|p|² + d² − r²)² − 4 d² (x² + y²) along the line.
    pub fn quartic(line: &Line, d: f64, growth: f64) -> Quartic {
        let (l, c, d) = (&line.nearest, &line.direction, big(d));
        let radius = big(growth) + big(1.0);
        let (a, k) = (dot(c, c), dot(l, l) + &d * &d - &radius * &radius);
        let four = big(4.0) * &d * &d;
        let (alpha, beta, gamma) =
            (&c[0] * &c[0] + &c[1] * &c[1], &c[0] * &l[0] + &c[1] * &l[1], &l[0] * &l[0] + &l[1] * &l[1]);
        // l·c is nothing but rounding: the cubic term is none.
        Quartic([
            &k * &k - &four * gamma,
            -(big(2.0) * &four * beta),
            big(2.0) * &a * &k - &four * alpha,
            big(0.0),
            &a * &a,
        ])
    }
}

/// The coefficients, constant term first.
pub struct Quartic(pub [Big; 5]);

impl Quartic {
    fn roots_in(self, line: &Line, d: f64) -> Option<Vec<Big>> {
        let end = Self::end(line, d);
        Sturm::new(self.0.to_vec()).roots(-end.clone(), end)
    }

    fn count_in(self, line: &Line, d: f64) -> usize {
        let end = Self::end(line, d);
        Sturm::new(self.0.to_vec()).count(&-end.clone(), &end)
    }

    /// Where the line is far outside, on either side of the foot.
    fn end(line: &Line, d: f64) -> Big {
        &line.per_length * big(1.25 * (d + 1.0))
    }
}

fn wall_radius(z: &Big, s: f64, growth: f64) -> Big {
    big(1.0) + (big(s) - big(1.0)) * z + big(growth)
}

fn grown_offset(normal: DVec3, offset: f64, growth: f64) -> Big {
    big(offset) + big(growth) * big(normal.abs().element_sum())
}

fn largest(values: impl IntoIterator<Item = Big>) -> Big {
    values.into_iter().reduce(|a, b| if b > a { b } else { a }).unwrap()
}

/// The roots of A t² + 2 B t + C.
fn quadratic(a: &Big, b: &Big, c: &Big) -> Vec<Big> {
    if *a == Big::ZERO {
        return if *b == Big::ZERO { Vec::new() } else { vec![-c / (b * big(2.0))] };
    }
    let discriminant = b * b - a * c;
    if discriminant < Big::ZERO {
        return Vec::new();
    }
    let root = discriminant.sqrt();
    // 200 bits bear the cancellation of the textbook's formula even where A is the rounding of two f64.
    vec![(-b - &root) / a, (&root - b) / a]
}
