//! How much a metal mirrors: Fresnel's equations with a complex index of refraction.
//!
//! **Equations.** With m = η + i k relative to the medium outside, and (a + i b)² = m² − sin² θ: a² and b² are half of h ± d,
//! where d = η² − k² − sin² θ and h = √(d² + 4 η² k²). Then R_s = ((a − cos θ)² + b²) / ((a + cos θ)² + b²), and R_p is R_s
//! times P = ((a cos θ − sin² θ)² + b² cos² θ) / ((a cos θ + sin² θ)² + b² cos² θ).
//!
//! **Accuracy.** All four are sums of squares, so that nothing cancels but a − cos θ, where little is mirrored. The smaller
//! of a and b comes from a b = η k and not from h − |d|. P has no tangent in it: it holds at grazing incidence, where it is 1.
//! For k = 0 it is the formula for glass.
//!
//! **Source.** M. Born and E. Wolf, Principles of Optics (7th edition), § 14.2, eqs. 14 to 16; the form of P is that of § 1.5.2.

use crate::math::portable;
use crate::record::{self, Entry, What};
use glam::DVec3;

/// The reflectance of unpolarised light at the angle of incidence with this cosine and sine, for an index η + i k relative
/// to the medium outside.
#[must_use]
pub fn conductor_reflectance([cosine, sine]: [f64; 2], eta: f64, k: f64) -> f64 {
    let d = (eta - sine) * (eta + sine) - k * k;
    let h = portable::hypot(d, 2.0 * eta * k);
    let larger = (0.5 * (h + d.abs())).sqrt();
    let smaller = if larger > 0.0 { eta * k / larger } else { 0.0 };
    let [a, b] = if d < 0.0 { [smaller, larger] } else { [larger, smaller] };
    let squares = |x: f64, y: f64| x * x + y * y;
    let sine_squared = sine * sine;
    let across = share(squares(a - cosine, b), squares(a + cosine, b));
    let beside = b * cosine;
    let more = share(squares(a * cosine - sine_squared, beside), squares(a * cosine + sine_squared, beside));
    0.5 * across * (1.0 + more)
}

/// Where both are nothing the ray runs along a surface of index 0, and all of it is mirrored.
fn share(part: f64, whole: f64) -> f64 {
    if whole > 0.0 { (part / whole).min(1.0) } else { 1.0 }
}

/// The reflectance of each colour for a metal in a medium of index `n1`.
#[must_use]
pub fn metal_reflectance(incidence: [f64; 2], n1: f64, eta: DVec3, k: DVec3) -> DVec3 {
    let of = |channel: usize| conductor_reflectance(incidence, eta[channel] / n1, k[channel] / n1);
    DVec3::new(of(0), of(1), of(2))
}

/// Describes what [`metal_reflectance`] found, with its working.
#[must_use]
#[track_caller]
pub fn conductor_entry([direction, normal]: [DVec3; 2], n1: f64, eta: DVec3, k: DVec3, found: DVec3) -> Entry {
    let [cosine, sine] = incidence(direction, normal);
    let event = record::Conductor {
        eta: eta.to_array(),
        k: k.to_array(),
        n1,
        theta: portable::atan2(sine, cosine).to_degrees(),
        reflectance: found.to_array(),
    };
    let theta = event.theta;
    let entry = Entry::new(What::Conductor(event));
    let vectors = [("dir", direction.to_array().into()), ("m", normal.to_array().into())];
    let entry = entry
        .line("c", "|dir · m| / (|dir| |m|)", &vectors, cosine)
        .line("s", "|dir × m| / (|dir| |m|)", &vectors, sine)
        .line("θ₁ in degrees", "arccos c", &[("c", cosine.into())], theta);
    with_reflectance(entry, [cosine, sine], n1, [eta, k], found)
}

fn with_reflectance(entry: Entry, [cosine, sine]: [f64; 2], n1: f64, [eta, k]: [DVec3; 2], found: DVec3) -> Entry {
    let [eta_1, k_1] = [eta / n1, k / n1];
    let d = (eta_1 - sine) * (eta_1 + sine) - k_1 * k_1;
    let h = (d * d + 4.0 * eta_1 * eta_1 * k_1 * k_1).map(f64::sqrt);
    let [a, b] = [0.5 * (h + d), 0.5 * (h - d)];
    let (c2, s2) = (cosine * cosine, sine * sine);
    let root = a.max(DVec3::ZERO).map(f64::sqrt);
    let across = (a + b - 2.0 * cosine * root + c2) / (a + b + 2.0 * cosine * root + c2);
    let part = c2 * (a + b) - 2.0 * cosine * s2 * root + s2 * s2;
    let more = part / (c2 * (a + b) + 2.0 * cosine * s2 * root + s2 * s2);
    let given = [("η", eta.to_array().into()), ("k", k.to_array().into()), ("n₁", n1.into())];
    let relative = [("η₁", eta_1.to_array().into()), ("k₁", k_1.to_array().into()), ("s", sine.into())];
    let squares = [("d", d.to_array().into()), ("h", h.to_array().into())];
    let known = [("A", a.to_array().into()), ("B", b.to_array().into()), ("c", cosine.into()), ("s", sine.into())];
    let halves = [("R_s", across.to_array().into()), ("P", more.to_array().into())];
    let joined: Vec<_> = relative.into_iter().chain(squares).collect();
    entry
        .line("η₁", "η / n₁", &given, eta_1.to_array())
        .line("k₁", "k / n₁", &given, k_1.to_array())
        .line("d", "η₁² − k₁² − s²", &joined, d.to_array())
        .line("h", "√(d² + 4 η₁² k₁²)", &joined, h.to_array())
        .line("A", "(h + d) / 2", &squares, a.to_array())
        .line("B", "(h − d) / 2", &squares, b.to_array())
        .line("R_s", "(A + B − 2 c √A + c²) / (A + B + 2 c √A + c²)", &known, across.to_array())
        .line("P", "(c² (A + B) − 2 c s² √A + s⁴) / (c² (A + B) + 2 c s² √A + s⁴)", &known, more.to_array())
        .line("R", "R_s (1 + P) / 2", &halves, found.to_array())
}

/// Cosine and sine of the angle between a ray and a surface's normal, of any lengths.
#[must_use]
pub fn incidence(direction: DVec3, normal: DVec3) -> [f64; 2] {
    let length = direction.length() * normal.length();
    [direction.dot(normal).abs() / length, direction.cross(normal).length() / length].map(|x| x.min(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::refract;
    use proptest::prelude::*;

    #[test]
    fn head_on_the_textbook_formula_holds() {
        // ((η − 1)² + k²) / ((η + 1)² + k²).
        let (eta, k) = (0.42, 2.47);
        let expected = ((eta - 1.0) * (eta - 1.0) + k * k) / ((eta + 1.0) * (eta + 1.0) + k * k);
        assert!((conductor_reflectance([1.0, 0.0], eta, k) - expected).abs() < 1e-15);
    }

    #[test]
    fn a_grazing_ray_is_mirrored_whole_by_any_metal() {
        for (eta, k) in [(0.05, 4.0), (1.4, 7.4), (1.5, 0.0), (0.0, 2.0), (1.0, 1e-9)] {
            assert_eq!(conductor_reflectance([0.0, 1.0], eta, k), 1.0, "{eta} + {k} i");
        }
    }

    #[test]
    fn at_sixty_degrees_complex_arithmetic_comes_to_the_same() {
        // η = 1, k = 2, cos = ½: m² − sin² = −3.75 + 4i, whose root q is 0.931 852… + 2.146 264…i;
        // R_s = |(½ − q) / (½ + q)|² and R_p = |(½ m² − q) / (½ m² + q)|² with m² = −3 + 4i.
        let h = 3.75_f64.hypot(4.0);
        let (a, b) = ((0.5 * (h - 3.75)).sqrt(), (0.5 * (h + 3.75)).sqrt());
        let across = ((0.5 - a).powi(2) + b * b) / ((0.5 + a).powi(2) + b * b);
        let within = ((-1.5 - a).powi(2) + (2.0 - b).powi(2)) / ((-1.5 + a).powi(2) + (2.0 + b).powi(2));
        let found = conductor_reflectance([0.5, 0.75_f64.sqrt()], 1.0, 2.0);
        assert!((found - 0.5 * (across + within)).abs() < 1e-15, "{found}");
    }

    /// What a sine that is off by four roundings makes of the transmittances 4 c q / (c + q)² and 4 η² c q / (η² c + q)² with
    /// q = √(η² − s²): next to the critical angle they go up like a root.
    fn tolerance(eta: f64, cosine: f64, sine: f64) -> f64 {
        let q = (eta * eta - sine * sine).abs().sqrt();
        let off = 4.0 * f64::EPSILON;
        // At the critical angle itself a change of q² by 2 off moves q by the root of that.
        let moved = sine * (off / q).min((2.0 * off).sqrt());
        let slope = |c: f64| 4.0 * c / ((c + q) * (c + q));
        1e-14 + moved * (slope(cosine) + slope(eta * eta * cosine)) / 2.0
    }

    proptest! {
        #[test]
        fn without_absorption_it_is_glass(eta in 0.2..4.0_f64, degrees in 0.0..90.0_f64) {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            let glass = refract(DVec3::new(sine, 0.0, -cosine), DVec3::Z, 1.0, eta).reflectance();
            let metal = conductor_reflectance([cosine, sine], eta, 0.0);
            prop_assert!((metal - glass).abs() <= tolerance(eta, cosine, sine), "{metal} and {glass}");
        }

        #[test]
        fn no_metal_mirrors_more_than_all(
            eta in 0.0..100.0_f64, k in 0.0..100.0_f64, degrees in 0.0..90.0_f64,
        ) {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            let found = conductor_reflectance([cosine, sine], eta, k);
            prop_assert!((0.0..=1.0).contains(&found), "{found}");
        }
    }
}
