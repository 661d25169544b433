//! The wall of a tapered cylinder: the double cone x² + y² = w² with w = 1 + (s − 1) z, and where a ray meets it.

use super::solver::Call;
use super::{GenericRay, report};
use crate::math::{Quadratic, Real};
use crate::record::{Entry, Value, What};

/// The double cone and a ray.
#[derive(Clone, Copy)]
pub(super) struct Wall<A> {
    /// w at S.
    pub w: A,
    /// d = (s − 1) c_z.
    pub d: A,
    /// p = S_x d − w c_x, q = S_y d − w c_y, r = S_x c_y − S_y c_x: the discriminant is p² + q² − r².
    pub minors: [A; 3],
    /// F along the ray, with its discriminant, 0 where that cannot be told from 0 with all digits.
    pub quadratic: Quadratic<A>,
    /// Bound on the rounding error of the discriminant.
    doubt: f64,
    /// The sums of the sizes of S and of c, with z weighed by |s − 1|.
    start: f64,
    course: f64,
}

impl<A: Real> Wall<A> {
    /// The quadratic of the wall.
    #[inline]
    pub fn new(s: f64, ray: &GenericRay<A>) -> Self {
        let slope = A::from_f64(s) - A::ONE;
        let ([x, y, z], [c_x, c_y, c_z]) = (ray.origin, ray.direction);
        let (w, d) = (A::ONE + slope * z, slope * c_z);
        let a = c_x * c_x + c_y * c_y - d * d;
        let b = x * c_x + y * c_y - w * d;
        let c = x * x + y * y - w * w;
        let minors = [x * d - w * c_x, y * d - w * c_y, x * c_y - y * c_x];
        let [p, q, r] = minors;
        let exact = p * p + q * q - r * r;

        let steep = slope.abs().to_f64();
        let sum = |[x, y, z]: [f64; 3]| x + y + steep * z;
        let (start, course) = (1.0 + sum(ray.origin_size), sum(ray.direction_size));
        let [p, q, r] = minors.map(|minor| minor.abs().to_f64());
        // Each minor is off by at most four roundings of the products of S and c.
        let (size, off) = (p + q + r, 4.0 * A::UNIT_ROUNDOFF * start * course);
        let doubt = (2.0 * size + 3.0 * off) * off + 4.0 * A::UNIT_ROUNDOFF * size * size;
        let touches = A::DOUBT_IS_ZERO && exact.abs().to_f64() <= doubt;
        let discriminant = if touches { A::ZERO } else { exact };
        let quadratic = Quadratic::with_discriminant(a, b, c, discriminant);
        Self { w, d, minors, quadratic, doubt, start, course }
    }

    /// Whether the line meets the double cone.
    #[inline]
    pub fn call(&self) -> Call {
        let [p, q, r] = self.minors.map(|minor| minor.abs().to_f64());
        Call {
            question: "Does the line meet the wall, D > 0?",
            value: self.quadratic.discriminant.to_f64(),
            doubt: self.doubt,
            input_doubt: 2.0 * f64::UNIT_ROUNDOFF * (p + q + r) * self.start * self.course,
            near: -(self.quadratic.b / self.quadratic.a).to_f64(),
        }
    }

    /// Whether the sign of the discriminant is known.
    #[inline]
    pub fn is_beyond_doubt(&self) -> bool {
        self.doubt == 0.0 || self.quadratic.discriminant.abs().to_f64() > self.doubt
    }

    /// Whether F is the same all along the ray, as far as can be told: it runs inside the wall, or in it, or outside.
    #[inline]
    pub fn is_level(&self) -> bool {
        let parallel = 8.0 * A::UNIT_ROUNDOFF * self.course * self.course;
        self.quadratic.discriminant == A::ZERO && self.quadratic.a.abs().to_f64() <= parallel
    }

    /// Whether a ray along which F is the same runs inside.
    pub fn holds_all(&self) -> bool {
        self.quadratic.c.to_f64() < -8.0 * A::UNIT_ROUNDOFF * self.start * self.start
    }

    /// Both times at which the line meets the double cone, ascending; infinite where A = 0. None for a miss.
    #[inline]
    pub fn roots(&self) -> Option<[A; 2]> {
        self.quadratic.roots()
    }

    /// Where the ray goes into the part with w > 0, and where it comes out; infinite where it never does. None for a miss.
    ///
    /// A < 0: the ray is steeper than the side, and meets each nappe once. That with w > 0 lies ahead where w grows along
    /// the ray, and behind where it shrinks.
    #[inline]
    pub fn times(&self) -> Option<[A; 2]> {
        let steep = self.quadratic.a < A::ZERO;
        if !steep && self.quadratic.discriminant <= A::ZERO {
            return None;
        }
        let [first, second] = self.roots()?;
        let infinity = A::from_f64(f64::INFINITY);
        Some(match (steep, self.d > A::ZERO) {
            (false, _) => [first, second],
            (true, true) => [second, infinity],
            (true, false) => [-infinity, first],
        })
    }

    /// A root after a step of Newton's method on F, which removes what cancels in B and C.
    #[inline]
    pub fn polished(&self, ray: &GenericRay<A>, tau: A) -> A {
        let [x, y, _] = ray.at(tau);
        let w = self.w + self.d * tau;
        let half_slope = self.quadratic.a * tau + self.quadratic.b;
        let step = A::from_f64(0.5) * (x * x + y * y - w * w) / half_slope;
        // At the apex there is no slope, and at infinity no F.
        if step.is_finite() { tau - step } else { tau }
    }

    /// How far the time of a wall hit moves when S and c are off by one part in one: δF over the slope of F.
    #[inline]
    pub fn moved(&self, tau: f64) -> f64 {
        // On the wall neither |x| nor |y| is more than w, and the slope of F is 2 √D.
        let w = (self.w.to_f64() + tau * self.d.to_f64()).abs();
        // The same reciprocal for all times: a quotient takes as long as all the rest.
        w * (self.start + tau.abs() * self.course) * (1.0 / self.quadratic.discriminant.to_f64().sqrt())
    }

    /// The wall's quadratic in the shared t, with its working.
    #[expect(clippy::many_single_char_names, reason = "the symbols of the head of the file")]
    pub fn working(&self, s: f64, ray: &GenericRay<A>) -> Entry {
        let scale = ray.t_per_tau;
        let per_t = 1.0 / scale;
        let measured = |x: A, powers: f64| report::measured(x, powers);
        let quadratic = &self.quadratic;
        let (a, b, c) =
            (measured(quadratic.a, per_t * per_t), measured(quadratic.b, per_t), measured(quadratic.c, 1.0));
        let discriminant = measured(quadratic.discriminant, per_t * per_t);
        let (w, d) = (measured(self.w, 1.0), measured(self.d, per_t));
        let [p, q, r] = self.minors.map(|minor| measured(minor, per_t));
        let polished = self.roots().into_iter().flatten().map(|tau| self.polished(ray, tau));
        let roots: Vec<_> = polished.map(|tau| measured(tau, scale)).collect();
        let roots: Vec<_> = roots.into_iter().filter(|root| root.value.is_finite()).collect();
        let ([x, y, z], [c_x, c_y, c_z]) = (ray.start(), ray.course());
        let number = Value::Number;
        let bindings = [
            ("s", number(s)),
            ("S_x", number(x)),
            ("S_y", number(y)),
            ("S_z", number(z)),
            ("c_x", number(c_x)),
            ("c_y", number(c_y)),
            ("c_z", number(c_z)),
            ("w", number(w.value)),
            ("d", number(d.value)),
            ("p", number(p.value)),
            ("q", number(q.value)),
            ("r", number(r.value)),
            ("A", number(a.value)),
            ("B", number(b.value)),
            ("C", number(c.value)),
            ("D", number(discriminant.value)),
        ];
        let mut entry = Entry::new(What::Quadratic {
            about: "the wall x² + y² = (1 + (s − 1) z)²".to_owned(),
            a: a.value,
            b: b.value,
            c: c.value,
            discriminant: discriminant.value,
            recentred_at: 0.0,
            roots: roots.iter().map(|root| root.value).collect(),
        })
        .line("w", "1 + (s − 1) S_z", &bindings, w)
        .line("d", "(s − 1) c_z", &bindings, d)
        .line("A", "c_x² + c_y² − d²", &bindings, a)
        .line("B", "S_x c_x + S_y c_y − w d", &bindings, b)
        .line("C", "S_x² + S_y² − w²", &bindings, c)
        .line("p", "S_x d − w c_x", &bindings, p)
        .line("q", "S_y d − w c_y", &bindings, q)
        .line("r", "S_x c_y − S_y c_x", &bindings, r)
        .line("D", "p² + q² − r²", &bindings, discriminant);
        if let [first, second] = roots[..] {
            let (lower, upper) = ("(−B − √D) / A", "(−B + √D) / A");
            let [earlier, later] = if a.value > 0.0 { [lower, upper] } else { [upper, lower] };
            entry = entry.line("t₁", earlier, &bindings, first).line("t₂", later, &bindings, second);
        } else if let [only] = roots[..] {
            entry = entry.line("t", "−C / (2 B)", &bindings, only);
        }
        entry
    }
}
