//! The tapered cylinder: radius 1 at z = 0, radius s at z = 1, closed by discs (§ 6.2.2).
//!
//! **Shape** (from the side)
//! ```text
//!              s
//!   z = 1   +-----+      cap
//!          /   |   \
//!         /    |    \    wall
//!        /     |     \
//!   z = 0 +----+------+  base
//!              1
//! ```
//! **Equation** With w = 1 + (s − 1) z, the radius at height z: F = max(x² + y² − w², −z, z − 1).
//!
//! **Ray equation** For the wall A t² + 2 B t + C = 0 with d = (s − 1) c_z: A = c_x² + c_y² − d²,
//! B = S_x c_x + S_y c_y − w d, C = S_x² + S_y² − w², where S is taken at the foot of the perpendicular from the origin. For
//! the discs t = −S_z / c_z and t = (1 − S_z) / c_z. The solid is convex: inside is where the ray is inside the wall
//! **and** between the discs, so entering is the later and leaving the earlier of two times. That settles all combinations of
//! wall, base and cap at once.
//!
//! **Accuracy** The discriminant is the sum p² + q² − r² of 2×2 minors of S and c, which cancels less than B² − A C. Where
//! rounding hides its sign, or which of two times comes first, all is worked out again with 32 digits. The hard case is the
//! ray along a side of the cone.
//!
//! **Degenerate cases** A = 0: the ray is parallel to a side, and the wall is met once. A < 0: the ray is steeper than the
//! side; it meets the wall once, and the other nappe of the double cone once, which does not count. A ray through the apex
//! (s = 0) meets both nappes there. Rays within a disc are inside the closed solid; rays within the wall only touch it.
//!
//! **Source** Hill, Computer Graphics Using OpenGL, the generic tapered cylinder; Numerical Recipes § 5.6 for the roots.

use super::{
    Bounds, Crossing, GenericRay, HalfSpace, Part, Primitive, boundary, boundary::Root, outline, planes, report,
};
use crate::math::{Quadratic, Real};
use crate::record::{Candidate, Entry, Recorder, Sense, Value, What, format_number};
use glam::{DVec2, DVec3};

const WALL: Part = 0;
const BASE: Part = 1;
const CAP: Part = 2;

/// Radius 1 at z = 0, radius s at z = 1, closed by discs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaperedCylinder {
    s: f64,
}

/// What the solver found, in τ.
struct Solution {
    /// Where the ray goes in and out.
    inside: Option<[Root; 2]>,
    /// The wall's quadratic about the foot.
    wall: Quadratic<f64>,
    foot: f64,
    /// The point at the foot.
    nearest: [f64; 3],
    /// The roots of the wall's quadratic, double cone and all.
    wall_roots: Vec<f64>,
    /// Base and cap times; none where the ray is parallel to them.
    discs: Option<[f64; 2]>,
}

/// One end of the inside, and how well it is known.
#[derive(Clone, Copy)]
struct End<A> {
    tau: A,
    error: A,
    part: Part,
}

/// The wall's quadratic, with a bound on the error of F near its roots.
struct Wall<A> {
    quadratic: Quadratic<A>,
    touches: bool,
    /// The ray is parallel to a side of the cone, as far as can be told.
    parallel: bool,
    doubt: f64,
}

impl TaperedCylinder {
    /// The tapered cylinder whose cap has radius `s`.
    ///
    /// # Errors
    /// Says so when `s` is negative or not finite.
    pub fn new(s: f64) -> Result<Self, String> {
        if s.is_finite() && s >= 0.0 {
            return Ok(Self { s });
        }
        Err(format!("s is {s}; the cap's radius needs to be 0 or more"))
    }

    /// The radius at height z.
    #[must_use]
    pub fn radius(&self, z: f64) -> f64 {
        1.0 + self.slope() * z
    }

    fn slope(&self) -> f64 {
        self.s - 1.0
    }

    /// The quadratic of the wall about the point `l`; none where rounding hides the sign of the discriminant.
    fn wall<A: Real>(&self, ray: &GenericRay<A>, l: [A; 3]) -> Option<Wall<A>> {
        let k = A::from_f64(self.s) - A::ONE;
        let [c_x, c_y, c_z] = ray.direction;
        let (w, d) = (A::ONE + k * l[2], k * c_z);
        let a = c_x * c_x + c_y * c_y - d * d;
        let b = l[0] * c_x + l[1] * c_y - w * d;
        let c = l[0] * l[0] + l[1] * l[1] - w * w;
        let minors = [l[0] * d - w * c_x, l[1] * d - w * c_y, l[0] * c_y - l[1] * c_x];
        let [p, q, r] = minors;
        let mut discriminant = p * p + q * q - r * r;
        let steep = 1.0 + self.slope().abs();
        // Every minor is off by at most this: eight roundings of l and w, times components of c below 2.
        let minor_error = 48.0 * A::UNIT_ROUNDOFF * steep * (ray.reach() + 1.0);
        let size: f64 = minors.iter().map(|x| x.abs().to_f64()).sum();
        let doubt = 2.0 * size * minor_error + 3.0 * minor_error * minor_error + 4.0 * A::UNIT_ROUNDOFF * size * size;
        let touches = discriminant.abs().to_f64() <= doubt;
        if touches && !A::FINEST {
            return None;
        }
        if touches {
            discriminant = A::ZERO;
        }
        let parallel = a.abs().to_f64() <= 64.0 * A::UNIT_ROUNDOFF * steep * steep;
        let extent = l.iter().map(|x| x.abs().to_f64()).sum::<f64>() + 4.0 * steep;
        let doubt = 32.0 * A::UNIT_ROUNDOFF * steep * extent * (ray.reach() + extent);
        let quadratic = Quadratic::with_discriminant(a, b, c, discriminant);
        Some(Wall { quadratic, touches, parallel, doubt })
    }

    /// Finds where the ray goes in and out; none where rounding hides the answer.
    fn solve<A: Real>(&self, ray: &GenericRay<A>) -> Option<Solution> {
        let foot = ray.foot();
        let l = ray.at(foot);
        let wall = self.wall(ray, l)?;
        let roots = wall.quadratic.roots();
        let discs = Self::discs(ray);
        let inside = match self.between_discs(ray, discs) {
            None => None,
            Some(slab) => within_wall(self.slope(), ray, foot, &wall, roots, slab)?,
        };
        let plain = |x: A| x.to_f64();
        let q = &wall.quadratic;
        Some(Solution {
            inside,
            wall: Quadratic { a: plain(q.a), b: plain(q.b), c: plain(q.c), discriminant: plain(q.discriminant) },
            foot: foot.to_f64(),
            nearest: l.map(plain),
            wall_roots: roots
                .into_iter()
                .flatten()
                .map(|delta| (foot + delta).to_f64())
                .filter(|tau| tau.is_finite())
                .collect(),
            discs: discs.map(|times| times.map(plain)),
        })
    }

    /// The times at which the ray meets the planes of base and cap.
    fn discs<A: Real>(ray: &GenericRay<A>) -> Option<[A; 2]> {
        let (s_z, c_z) = (ray.origin[2], ray.direction[2]);
        (c_z != A::ZERO).then(|| [-s_z / c_z, (A::ONE - s_z) / c_z])
    }

    /// The stretch between the planes of the discs; infinite ends for a ray that runs between them, none for a miss.
    fn between_discs<A: Real>(&self, ray: &GenericRay<A>, discs: Option<[A; 2]>) -> Option<[End<A>; 2]> {
        let end = |tau: A, part| End { tau, error: A::from_f64(4.0 * A::UNIT_ROUNDOFF) * tau.abs(), part };
        let infinity = A::from_f64(f64::INFINITY);
        match discs {
            None if ray.origin[2] < A::ZERO || ray.origin[2] > A::ONE => None,
            None => Some([-infinity, infinity].map(|tau| End { tau, error: A::ZERO, part: WALL })),
            Some([base, cap]) if ray.direction[2] > A::ZERO => Some([end(base, BASE), end(cap, CAP)]),
            Some([base, cap]) => Some([end(cap, CAP), end(base, BASE)]),
        }
    }
}

/// Cuts the stretch between the discs down to what is inside the wall.
///
/// The outer option is none where the order of two times is hidden by rounding; the inner one where the ray misses.
#[expect(clippy::option_option, reason = "undecided and missed are two things")]
fn within_wall<A: Real>(
    slope: f64,
    ray: &GenericRay<A>,
    foot: A,
    wall: &Wall<A>,
    roots: Option<[A; 2]>,
    [mut enter, mut leave]: [End<A>; 2],
) -> Option<Option<[Root; 2]>> {
    let root = |end: End<A>| Root { tau: end.tau.to_f64(), part: end.part };
    if wall.touches && wall.parallel {
        // F is the same all along the ray: it runs inside the wall, or in it, or outside.
        let inside = wall.quadratic.c.to_f64() < -wall.doubt;
        return Some(inside.then(|| [root(enter), root(leave)]));
    }
    let steep = wall.quadratic.a < A::ZERO;
    let Some(roots) = roots.filter(|_| steep || !wall.touches) else {
        return Some(None);
    };
    let [first, second] = roots.map(|delta| wall_end(wall, foot, delta));
    if steep {
        // The nappe with w > 0 lies ahead where w grows along the ray, and behind where it shrinks.
        if slope * ray.direction[2].to_f64() > 0.0 {
            enter = later(enter, second);
        } else {
            leave = earlier(leave, first);
        }
    } else {
        enter = later(enter, first);
        leave = earlier(leave, second);
    }
    let doubtful = (enter.tau - leave.tau).abs() <= enter.error + leave.error;
    if doubtful && !A::FINEST {
        return None;
    }
    Some((!doubtful && enter.tau < leave.tau).then(|| [root(enter), root(leave)]))
}

/// A root of the wall's quadratic with its error: that of F over the slope of F.
fn wall_end<A: Real>(wall: &Wall<A>, foot: A, delta: A) -> End<A> {
    let slope = wall.quadratic.discriminant.sqrt() * A::from_f64(2.0);
    let own = if slope > A::ZERO { A::from_f64(wall.doubt) / slope } else { A::ZERO };
    let rounding = A::from_f64(4.0 * A::UNIT_ROUNDOFF) * (foot.abs() + delta.abs());
    End { tau: foot + delta, error: own + rounding, part: WALL }
}

fn later<A: Real>(a: End<A>, b: End<A>) -> End<A> {
    if b.tau > a.tau { b } else { a }
}

fn earlier<A: Real>(a: End<A>, b: End<A>) -> End<A> {
    if b.tau < a.tau { b } else { a }
}

impl Primitive for TaperedCylinder {
    fn crossings<A: Real>(&self, ray: &GenericRay<A>, recorder: &mut impl Recorder, crossings: &mut Vec<Crossing>) {
        let begin = crossings.len();
        let Some(solution) = self.solve(ray).or_else(|| self.solve(&ray.widen())) else { return };
        if let Some(inside) = solution.inside {
            boundary::append_alternating(self, ray, &inside, Sense::Enter, crossings);
        }
        let found = &crossings[begin..];
        recorder.note(|| planes::axis_table(ray, &DISCS));
        recorder.note(|| self.working(ray, &solution));
        recorder.note(|| report::implicit(self, ray, found));
        recorder.note(|| report::roots(self, ray, found, self.rejected(ray, &solution, found)));
    }

    fn normal(&self, point: DVec3, part: Part) -> DVec3 {
        match part {
            BASE => DVec3::NEG_Z,
            CAP => DVec3::Z,
            _ => {
                let radius = point.truncate().length();
                // At the apex every direction between the sides would do; along the axis is the fair one.
                if radius > 0.0 { DVec3::new(point.x, point.y, -self.slope() * radius) } else { DVec3::Z }
            }
        }
    }

    /// On the wall u is the turn about the axis and v the height; on the discs x and y.
    fn uv(&self, point: DVec3, part: Part) -> DVec2 {
        let flat = |radius: f64| ((point.truncate() / radius + 1.0) * 0.5).clamp(DVec2::ZERO, DVec2::ONE);
        match part {
            BASE => flat(1.0),
            CAP if self.s > 0.0 => flat(self.s),
            CAP => DVec2::splat(0.5),
            _ => DVec2::new(super::sphere::turn(point.truncate()), point.z.clamp(0.0, 1.0)),
        }
    }

    fn bounds(&self) -> Bounds {
        let radius = self.s.max(1.0);
        Bounds { low: DVec3::new(-radius, -radius, 0.0), high: DVec3::new(radius, radius, 1.0) }
    }

    /// The rims, and eight lines up the wall.
    fn outline(&self) -> Vec<Vec<DVec3>> {
        let side = |k: u32| {
            let (sin, cos) = (f64::from(k) * std::f64::consts::FRAC_PI_4).sin_cos();
            vec![DVec3::new(cos, sin, 0.0), DVec3::new(self.s * cos, self.s * sin, 1.0)]
        };
        let cap = (self.s > 0.0).then(|| outline::circle(self.s, 1.0));
        [outline::circle(1.0, 0.0)].into_iter().chain(cap).chain((0..8).map(side)).collect()
    }

    fn implicit(&self, point: DVec3) -> f64 {
        let radius = self.radius(point.z);
        (point.truncate().length_squared() - radius * radius).max(-point.z).max(point.z - 1.0)
    }

    fn equation(&self) -> String {
        let radius = if self.s == 1.0 {
            "1".to_owned()
        } else if self.s == 0.0 {
            "(1 − z)²".to_owned()
        } else {
            "(1 + (s − 1) z)²".to_owned()
        };
        let given =
            if self.s == 0.0 || self.s == 1.0 { String::new() } else { format!(", s = {}", format_number(self.s)) };
        format!("max(x² + y² − {radius}, −z, z − 1){given}")
    }

    fn parts(&self) -> Vec<String> {
        ["wall", "base", "cap"].map(str::to_owned).to_vec()
    }
}

/// The planes of the discs.
const DISCS: [(HalfSpace, &str); 2] =
    [(HalfSpace { normal: DVec3::NEG_Z, offset: 0.0 }, "base"), (HalfSpace { normal: DVec3::Z, offset: 1.0 }, "cap")];

impl TaperedCylinder {
    /// The wall's quadratic in the shared t, with its working.
    fn working<A: Real>(&self, ray: &GenericRay<A>, solution: &Solution) -> Entry {
        let scale = ray.t_per_tau;
        let Quadratic { a, b, c, discriminant } = solution.wall;
        let (a, b, discriminant) = (a / scale / scale, b / scale, discriminant / scale / scale);
        let (foot, [x, y, z], [c_x, c_y, c_z]) = (solution.foot * scale, solution.nearest, ray.course());
        let roots: Vec<_> = solution.wall_roots.iter().map(|tau| tau * scale).collect();
        let number = Value::Number;
        let bindings = [
            ("S", report::start(ray)),
            ("c", report::course(ray)),
            ("s", number(self.s)),
            ("t₀", number(foot)),
            ("l_x", number(x)),
            ("l_y", number(y)),
            ("l_z", number(z)),
            ("c_x", number(c_x)),
            ("c_y", number(c_y)),
            ("c_z", number(c_z)),
            ("w", number(self.radius(z))),
            ("d", number(self.slope() * c_z)),
            ("A", number(a)),
            ("B", number(b)),
            ("C", number(c)),
            ("D", number(discriminant)),
        ];
        let about = "the wall x² + y² = (1 + (s − 1) z)²".to_owned();
        let mut entry =
            Entry::new(What::Quadratic { about, a, b, c, discriminant, recentred_at: foot, roots: roots.clone() })
                .line("t₀", "−(S·c) / (c·c)", &bindings, foot)
                .line("l", "S + c t₀", &bindings, solution.nearest)
                .line("w", "1 + (s − 1) l_z", &bindings, self.radius(z))
                .line("d", "(s − 1) c_z", &bindings, self.slope() * c_z)
                .line("A", "c_x² + c_y² − d²", &bindings, a)
                .line("B", "l_x c_x + l_y c_y − w d", &bindings, b)
                .line("C", "l_x² + l_y² − w²", &bindings, c)
                .line("D", "B² − A C", &bindings, discriminant);
        if let [first, second] = roots[..] {
            let (low, high) = if a > 0.0 { ("−", "+") } else { ("+", "−") };
            entry = entry.line("t₁", &format!("t₀ + (−B {low} √D) / A"), &bindings, first).line(
                "t₂",
                &format!("t₀ + (−B {high} √D) / A"),
                &bindings,
                second,
            );
        } else if let [only] = roots[..] {
            entry = entry.line("t", "t₀ − C / (2 B)", &bindings, only);
        }
        entry
    }

    /// The times that were looked at and are not on the solid.
    fn rejected<A: Real>(&self, ray: &GenericRay<A>, solution: &Solution, found: &[Crossing]) -> Vec<Candidate> {
        let [enters, leaves] = [Sense::Enter, Sense::Leave];
        let upward = ray.direction[2] > A::ZERO;
        let (base, cap) = if upward { (enters, leaves) } else { (leaves, enters) };
        let [first, second] = if solution.wall.a < 0.0 { [leaves, enters] } else { [enters, leaves] };
        let wall = solution.wall_roots.iter().zip([first, second]).map(|(tau, sense)| (*tau, WALL, sense));
        let discs = solution.discs.into_iter().flat_map(|[b, c]| [(b, BASE, base), (c, CAP, cap)]);
        wall.chain(discs)
            .filter(|(tau, part, _)| !found.iter().any(|hit| hit.part == *part && hit.t == tau * ray.t_per_tau))
            .filter(|(tau, _, _)| (tau * ray.t_per_tau).is_finite())
            .map(|hit| report::rejected(self, ray, hit, self.reason(ray.point(A::from_f64(hit.0)), hit.1)))
            .collect()
    }

    /// Why a point of the given part's surface is not on the solid.
    fn reason(&self, point: DVec3, part: Part) -> String {
        let radius = point.truncate().length();
        let beyond = |limit: f64, name: &str| {
            format!("{} from the axis, beyond the {name}'s radius {}", format_number(radius), format_number(limit))
        };
        match part {
            BASE if radius > 1.0 => beyond(1.0, "base"),
            CAP if radius > self.s => beyond(self.s, "cap"),
            WALL if point.z < 0.0 => format!("z = {}, below the base", format_number(point.z)),
            WALL if point.z > 1.0 => format!("z = {}, above the cap", format_number(point.z)),
            _ => "only touched there, without a length inside".to_owned(),
        }
    }
}
