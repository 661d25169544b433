//! What can be wrong with mirrored and refracted directions.

use super::normal::wrong_normals;
use super::{
    Case, Explanation, Guess, INDICES_OF_ENTERING, INDICES_SWAPPED, REFLECTED_FACTOR, REFLECTED_NORMAL, REFLECTED_SIGN,
    SNELL_NORMAL_NOT_FLIPPED, SNELL_NOT_NORMALISED, SNELL_SIGN, STOPPED_BY_LIMIT, STRAIGHT_ON,
    TOTAL_REFLECTION_IGNORED, number,
};
use crate::compare::Said;
use crate::compare::foreign::check::Subject;
use crate::optics::{reflect, refract};
use crate::record::What;
use glam::DVec3;

/// A ray at a surface.
struct Bounce {
    /// The ray that comes, by its place among ours.
    ray: usize,
    /// Where it goes.
    d: DVec3,
    /// The unit normal on its side.
    m: DVec3,
}

/// The ray that comes: the one that the check is about, or the one that sent it.
fn bounce(case: Case) -> Option<Bounce> {
    let told = case.check.ray;
    let ray = if case.check.subject == Subject::RayDirection { case.ours.rays[told].parent? } else { told };
    Some(Bounce { ray, d: case.ours.rays[ray].direction, m: case.ours.hit(ray)?.n_shading })
}

/// n₁, n₂ and whether all light is reflected.
fn indices(case: Case, ray: usize) -> Option<(f64, f64, bool)> {
    case.ours.of(ray).find_map(|event| match &event.what {
        What::Snell { n1, n2, total_internal_reflection, .. } => Some((*n1, *n2, *total_internal_reflection)),
        _ => None,
    })
}

/// Guesses about the mirrored direction.
pub fn of_reflected(case: Case, guesses: &mut Vec<Guess>) {
    let Some(Bounce { ray, d, m }) = bounce(case) else { return };
    let cosine = d.dot(m);
    let with = |formula: &str| format!("{formula} with dir · m = {}", number(cosine));
    for (cause, how, r) in [
        (&REFLECTED_SIGN, with("2 (dir · m) m − dir"), -reflect(d, m)),
        (&REFLECTED_SIGN, with("dir + 2 (dir · m) m"), d + 2.0 * cosine * m),
        (&REFLECTED_FACTOR, with("dir − (dir · m) m"), d - cosine * m),
        (&STRAIGHT_ON, "dir".to_owned(), d),
        (&REFLECTED_SIGN, "−dir".to_owned(), -d),
    ] {
        guesses.push(Guess::vector(cause, how, r));
    }
    if let Some(n) = long_normal(case, ray) {
        let how = format!("dir − 2 (dir · m) m with |m| = {}", number(n.length()));
        guesses.push(Guess::vector(&REFLECTED_NORMAL, how, reflect(d, n)));
    }
    for (cause, how, n) in wrong_normals(case, ray) {
        guesses.push(Guess::vector(cause, format!("{how}: r"), reflect(d, n)));
    }
}

/// The normal as the inverse transpose gives it, before it is normalised.
fn long_normal(case: Case, ray: usize) -> Option<DVec3> {
    use crate::shape::{Part, Primitive};
    let hit = case.ours.hit(ray)?;
    let leaf = case.ours.leaf(hit.object, hit.leaf)?;
    let part = leaf.parts.iter().position(|part| part == hit.part)?;
    let generic = leaf.shape.normal(hit.generic_point, Part::try_from(part).ok()?);
    Some(leaf.placement.generic_from_world().matrix3.transpose() * generic)
}

/// Guesses about n₁ and n₂.
pub fn of_indices(case: Case, guesses: &mut Vec<Guess>) {
    let Some((n1, n2, _)) = indices(case, case.check.ray) else { return };
    guesses.push(Guess::new(&INDICES_SWAPPED, "(n₂, n₁)", [n2, n1]));
    if n1 > n2 {
        guesses.push(Guess::new(&INDICES_OF_ENTERING, "the ray leaves, from n₁ to n₂: (n₂, n₁)", [n2, n1]));
    }
}

/// Guesses about the refracted direction.
pub fn of_refracted(case: Case, guesses: &mut Vec<Guess>) {
    let Some(Bounce { ray, d, m }) = bounce(case) else { return };
    let Some((n1, n2, is_total)) = indices(case, ray) else { return };
    let none = DVec3::NAN;
    let with = format!("n₁ = {}, n₂ = {}", number(n1), number(n2));
    let swapped = refract(d, m, n2, n1).refracted.unwrap_or(none);
    guesses.push(Guess::vector(&INDICES_SWAPPED, format!("T for n₁ and n₂ swapped, {with}"), swapped));
    if n1 > n2 {
        let how = format!("T for a ray that enters, {with}");
        guesses.push(Guess::vector(&INDICES_OF_ENTERING, how, swapped));
    }
    guesses.push(Guess::vector(&STRAIGHT_ON, "dir", d));
    of_formula(&[d, m], n1 / n2, is_total, guesses);
    for (cause, how, n) in wrong_normals(case, ray) {
        let bent = refract(d, n, n1, n2).refracted.unwrap_or(none);
        guesses.push(Guess::vector(cause, format!("{how}: T"), bent));
    }
}

/// Slips in T = η dir + (η cosθ₁ − cosθ₂) m.
fn of_formula(&[d, m]: &[DVec3; 2], eta: f64, is_total: bool, guesses: &mut Vec<Guess>) {
    let unit = d.normalize();
    let bent = |d: DVec3, n: DVec3, cosine: f64| {
        let w = 1.0 - eta * eta * (1.0 - cosine * cosine);
        (w, eta * d + (eta * cosine - w.max(0.0).sqrt()) * n)
    };
    let cosine = -unit.dot(m);
    let (w, _) = bent(unit, m, cosine);
    let second = w.max(0.0).sqrt();
    let numbers = format!("η = {}, cosθ₁ = {}, cosθ₂ = {}", number(eta), number(cosine), number(second));
    let mut push = |cause, how: String, t: DVec3| guesses.push(Guess::vector(cause, how, t));
    if is_total {
        let how = format!("η dir + η cosθ₁ m, the root of {} taken for 0", number(w));
        push(&TOTAL_REFLECTION_IGNORED, how, eta * unit + eta * cosine * m);
        let how = format!("with the root of |{}|", number(w));
        push(&TOTAL_REFLECTION_IGNORED, how, eta * unit + (eta * cosine - w.abs().sqrt()) * m);
        push(&TOTAL_REFLECTION_IGNORED, "dir".to_owned(), unit);
        return;
    }
    let (_, far) = bent(unit, -m, -cosine);
    push(&SNELL_NORMAL_NOT_FLIPPED, format!("with m on the far side: T, {numbers}"), far);
    let (_, long) = bent(d, m, -d.dot(m));
    push(&SNELL_NOT_NORMALISED, format!("T with |dir| = {}", number(d.length())), long);
    push(&SNELL_SIGN, format!("η dir + (η cosθ₁ + cosθ₂) m, {numbers}"), eta * unit + (eta * cosine + second) * m);
    push(&SNELL_SIGN, format!("η dir − (η cosθ₁ − cosθ₂) m, {numbers}"), eta * unit - (eta * cosine - second) * m);
    push(&SNELL_SIGN, format!("η dir + (cosθ₂ − η cosθ₁) m, {numbers}"), eta * unit + (second - eta * cosine) * m);
    push(&SNELL_SIGN, "−T".to_owned(), -(eta * unit + (eta * cosine - second) * m));
}

/// Why a ray is sent that ours does not send.
pub fn of_extra_ray(case: Case) -> Vec<Explanation> {
    let (Said::Words(ours), Said::Words(theirs)) = (&case.check.ours, &case.check.theirs) else { return Vec::new() };
    let mut found = Vec::new();
    if theirs.contains("refracted") && indices(case, case.check.ray).is_some_and(|(_, _, is_total)| is_total) {
        let evidence = "Snell's law has no refracted ray here".to_owned();
        found.push(Explanation { cause: &TOTAL_REFLECTION_IGNORED, evidence, misfit: 0.0 });
    }
    if ours.contains("stopped by") {
        found.push(Explanation { cause: &STOPPED_BY_LIMIT, evidence: ours.clone(), misfit: 0.0 });
    }
    found
}
