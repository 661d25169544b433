//! The working behind an interface, as a student would write it.

use super::spectrum::{Band, LONGEST, SHORTEST, white_up_to};
use super::{Dispersion, Optics};
use crate::record::{Entry, Value, Wavelength, What};
use glam::DVec3;

/// Describes Snell's law and the Fresnel split at an interface, every line with this ray's numbers put in.
///
/// `optics` is what [`refract`](super::refract) made of the other arguments.
#[must_use]
#[track_caller]
pub fn snell_entry(direction: DVec3, normal: DVec3, n1: f64, n2: f64, optics: &Optics) -> Entry {
    let entry = Entry::new(What::Snell {
        n1,
        n2,
        theta1: optics.theta1_degrees(),
        theta2: optics.theta2_degrees(),
        critical: optics.critical_angle_degrees(),
        total_internal_reflection: optics.refracted.is_none(),
        refracted: optics.refracted.map(|t| t.to_array()),
        reflectance: optics.reflectance(),
    });
    let entry = with_incidence(entry, direction, normal, optics);
    let entry = with_refraction(entry, n1, n2, optics);
    with_fresnel(entry, n1, n2, optics)
}

/// Describes what becomes of one wavelength of a ray that is taken apart at an interface; `offset` is that of all
/// wavelengths, `dispersions` are those of the two sides, `n` their indices at this wavelength, and `optics` is what
/// [`refract`](super::refract) made of them.
#[must_use]
#[track_caller]
pub fn wavelength_entry(
    [direction, normal]: [DVec3; 2],
    (band, offset): (&Band, f64),
    (n, dispersions): ([f64; 2], [Option<&Dispersion>; 2]),
    optics: &Optics,
) -> Entry {
    let entry = Entry::new(What::Wavelength(Wavelength {
        number: band.number,
        of: band.of,
        nanometres: band.nanometres,
        band: band.width(),
        share: band.share.to_array(),
        n1: n[0],
        n2: n[1],
        theta1: optics.theta1_degrees(),
        theta2: optics.theta2_degrees(),
        direction: optics.refracted.map(|t| t.to_array()),
        reflectance: optics.reflectance(),
    }));
    let entry = index_lines(with_band(entry, band, offset), band.nanometres, dispersions);
    let entry = with_incidence(entry, direction, normal, optics);
    let entry = with_refraction(entry, n[0], n[1], optics);
    with_fresnel(entry, n[0], n[1], optics)
}

/// λ, its band, and the share of white in it.
fn with_band(entry: Entry, band: &Band, offset: f64) -> Entry {
    let spread = [
        ("λ_min", Value::Number(SHORTEST)),
        ("λ_max", Value::Number(LONGEST)),
        ("k", f64::from(band.number).into()),
        ("n", f64::from(band.of).into()),
        ("u", offset.into()),
    ];
    let about = [("λ", Value::Number(band.nanometres)), ("Δ", band.width().into())];
    let [from, to] = band.edges;
    let [up_to_from, up_to_to] = band.edges.map(|edge| Value::Vector(white_up_to(edge).to_array()));
    entry
        .line("λ", "λ_min + (k + u) / n (λ_max − λ_min)", &spread, band.nanometres)
        .line("Δ", "(λ_max − λ_min) / n", &spread, band.width())
        .line("from", "λ − Δ / 2", &about, from)
        .line("to", "λ + Δ / 2", &about, to)
        .line("W_from, white up to there", "W_from", &[("W_from", up_to_from)], up_to_from)
        .line("W_to, white up to there", "W_to", &[("W_to", up_to_to)], up_to_to)
        .line("S", "W_to − W_from", &[("W_to", up_to_to), ("W_from", up_to_from)], band.share.to_array())
}

/// Adds how the indices of dispersive media follow from a wavelength in nanometres.
#[must_use]
pub fn index_lines(entry: Entry, nanometres: f64, dispersions: [Option<&Dispersion>; 2]) -> Entry {
    let sides = ["n₁", "n₂"].into_iter().zip(dispersions);
    sides.fold(entry, |entry, (symbol, dispersion)| match dispersion {
        Some(dispersion) => dispersion.working(entry, symbol, nanometres),
        None => entry,
    })
}

/// cos θ₁, sin θ₁ and θ₁.
fn with_incidence(entry: Entry, direction: DVec3, normal: DVec3, optics: &Optics) -> Entry {
    let vectors = [("dir", Value::Vector(direction.to_array())), ("m", Value::Vector(normal.to_array()))];
    entry
        .line("cosθ₁", "|dir · m| / (|dir| |m|)", &vectors, optics.cos_i)
        .line("sinθ₁", "|dir × m| / (|dir| |m|)", &vectors, optics.sin_i)
        .line("θ₁ in degrees", "arccos cosθ₁", &[("cosθ₁", optics.cos_i.into())], optics.theta1_degrees())
}

/// η, w, θ₂ and the critical angle.
fn with_refraction(entry: Entry, n1: f64, n2: f64, optics: &Optics) -> Entry {
    let indices = [("n₁", Value::Number(n1)), ("n₂", Value::Number(n2))];
    let eta = n1 / n2;
    let mut entry = entry.line("η", "n₁ / n₂", &indices, eta).line(
        "w",
        "1 − η² sinθ₁²",
        &[("η", eta.into()), ("sinθ₁", optics.sin_i.into())],
        optics.w,
    );
    if let (Some(cos_t), Some(theta2)) = (optics.cos_t, optics.theta2_degrees()) {
        entry = entry.line("cosθ₂", "√w", &[("w", optics.w.into())], cos_t).line(
            "θ₂ in degrees",
            "arccos cosθ₂",
            &[("cosθ₂", cos_t.into())],
            theta2,
        );
    } else {
        entry = entry.line("total internal reflection", "w < 0", &[("w", optics.w.into())], true);
    }
    match optics.critical_angle_degrees() {
        Some(critical) => entry.line("critical angle in degrees", "arcsin (n₂ / n₁)", &indices, critical),
        None => entry,
    }
}

/// R_s, R_p and their mean.
fn with_fresnel(entry: Entry, n1: f64, n2: f64, optics: &Optics) -> Entry {
    let Some(cos_t) = optics.cos_t else { return entry };
    let [r_s, r_p] = optics.fresnel();
    let known = [
        ("n₁", Value::Number(n1)),
        ("n₂", Value::Number(n2)),
        ("cosθ₁", Value::Number(optics.cos_i)),
        ("cosθ₂", Value::Number(cos_t)),
    ];
    entry
        .line("R_s", "((n₁ cosθ₁ − n₂ cosθ₂) / (n₁ cosθ₁ + n₂ cosθ₂))²", &known, r_s)
        .line("R_p", "((n₂ cosθ₁ − n₁ cosθ₂) / (n₂ cosθ₁ + n₁ cosθ₂))²", &known, r_p)
        .line("R", "(R_s + R_p) / 2", &[("R_s", r_s.into()), ("R_p", r_p.into())], optics.reflectance())
}
