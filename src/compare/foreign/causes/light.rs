//! What can be wrong with a light's direction and its two terms.

use super::normal::wrong_normals;
use super::{
    COSINE_ABSOLUTE, COSINE_NEGATIVE, Case, Cause, EXPONENT, FADES_WITH_DISTANCE, Guess, HALF_ANGLE,
    HIGHLIGHT_MIRROR_SIGN, HIGHLIGHT_TIMES_COSINE, HIGHLIGHT_VIEW_LENGTH, HIGHLIGHT_VIEW_SIGN, LIGHT_AS_DIRECTION,
    LIGHT_BACKWARDS, LIGHT_COLOUR_IGNORED, LIGHT_NOT_NORMALISED, SELF_HIT, SHADOW_IGNORED, number, vector,
};
use crate::compare::foreign::check::Subject;
use crate::math::portable;
use crate::optics::reflect;
use crate::record::{EventId, What};
use crate::scene::LightKind;
use glam::DVec3;

/// One light at one hit, as we recorded it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lit {
    /// The unit vector towards it.
    l: DVec3,
    /// From the hit to the light; none for a light that is a direction.
    to_light: Option<DVec3>,
    /// The light's position, likewise.
    position: Option<DVec3>,
    /// All of its light, and what arrives of it.
    colour: DVec3,
    arriving: DVec3,
    n: DVec3,
    /// The unit vector towards the eye, and the direction of the ray.
    v: DVec3,
    direction: DVec3,
    k_d: DVec3,
    k_s: DVec3,
    exponent: f64,
    /// What passes through the surface itself.
    transparency: f64,
    pub diffuse: DVec3,
    pub specular: DVec3,
}

/// What we recorded of a light.
pub(super) fn lit(case: Case, light: EventId) -> Option<Lit> {
    let What::Light { name, towards, arriving, diffuse, specular, .. } = &case.ours.tree.event(light).what else {
        return None;
    };
    let hit = case.ours.hit(case.check.ray)?;
    let What::Hit { material, .. } = &case.ours.tree.event(hit.event).what else { return None };
    let material = case.ours.material(material)?;
    let source = case.ours.scene.lights.iter().find(|light| light.name == *name)?;
    let position = match source.kind {
        LightKind::Point(position) => Some(position),
        LightKind::Area(area) => Some(area.middle()),
        LightKind::Directional(_) => None,
    };
    let pigment = case.ours.of(case.check.ray).find_map(|event| match &event.what {
        What::Texture(texture) => Some(DVec3::from_array(texture.colour)),
        _ => None,
    });
    let direction = case.direction();
    Some(Lit {
        l: (*towards).into(),
        to_light: position.map(|position| position - hit.point),
        position,
        colour: source.colour,
        arriving: (*arriving).into(),
        n: hit.n_shading,
        v: -direction.normalize(),
        direction,
        k_d: material.diffuse * pigment.unwrap_or(DVec3::ONE),
        k_s: material.specular,
        exponent: material.exponent,
        transparency: material.transparency,
        diffuse: (*diffuse).into(),
        specular: (*specular).into(),
    })
}

/// Guesses about the direction towards a light.
pub fn of_towards(case: Case, light: EventId, guesses: &mut Vec<Guess>) {
    let Some(lit) = lit(case, light) else { return };
    if let Some(to_light) = lit.to_light {
        let how = format!("light − P, of length {}", number(to_light.length()));
        guesses.push(Guess::vector(&LIGHT_NOT_NORMALISED, how, to_light));
        guesses.push(Guess::vector(&LIGHT_BACKWARDS, "P − light", -to_light));
    } else if let Some(theirs) = case.theirs() {
        let how = format!("l times the length {}", number(theirs.length()));
        guesses.push(Guess::vector(&LIGHT_NOT_NORMALISED, how, lit.l * theirs.length()));
    }
    guesses.push(Guess::vector(&LIGHT_BACKWARDS, "−l", -lit.l));
    if let Some(position) = lit.position {
        guesses.push(Guess::vector(&LIGHT_AS_DIRECTION, "the light's position", position));
        guesses.push(Guess::vector(
            &LIGHT_AS_DIRECTION,
            "the light's position / its length",
            position.normalize_or_zero(),
        ));
    }
}

/// Guesses about where a shadow ray goes.
pub fn of_shadow_ray(case: Case, guesses: &mut Vec<Guess>) {
    let direction = case.direction();
    guesses.push(Guess::vector(&LIGHT_BACKWARDS, "P − light", -direction));
    let position = case.origin() + direction;
    guesses.push(Guess::vector(&LIGHT_AS_DIRECTION, "the light's position", position));
}

/// Guesses about the diffuse term of a light.
pub fn of_diffuse(case: Case, light: EventId, guesses: &mut Vec<Guess>) {
    let Some(lit) = lit(case, light) else { return };
    for (cause, how, value) in wrong_diffuse(case, &lit) {
        guesses.push(Guess::vector(cause, how, value));
    }
}

/// Diffuse terms that come out of mistakes.
pub(super) fn wrong_diffuse(case: Case, lit: &Lit) -> Vec<(&'static Cause, String, DVec3)> {
    let cosine = lit.n.dot(lit.l);
    let term = |light: DVec3, cosine: f64| light * lit.k_d * cosine;
    let with = |formula: &str| format!("{formula} with n·l = {}", number(cosine));
    let mut wrong = vec![
        (&SHADOW_IGNORED, with("I k_d max(0, n·l)"), term(lit.colour, cosine.max(0.0))),
        (&COSINE_ABSOLUTE, with("I k_d |n·l|"), term(lit.colour, cosine.abs())),
        (&COSINE_NEGATIVE, with("I k_d n·l"), term(lit.colour, cosine)),
        (&LIGHT_BACKWARDS, with("I k_d max(0, −n·l)"), term(lit.colour, (-cosine).max(0.0))),
    ];
    let how = format!("the surface itself passes {} of the light: I_diff", number(lit.transparency));
    wrong.push((&SELF_HIT, how, lit.diffuse * lit.transparency));
    let share = DVec3::from_array(std::array::from_fn(|k| ratio(lit.arriving[k], lit.colour[k])));
    wrong.push((&LIGHT_COLOUR_IGNORED, with("k_d n·l"), term(share, cosine.max(0.0))));
    if let (Some(to_light), Some(position)) = (lit.to_light, lit.position) {
        let length = to_light.length();
        let how = format!("I k_d n·L with |L| = {}", number(length));
        wrong.push((&LIGHT_NOT_NORMALISED, how, lit.diffuse * length));
        let how = format!("I k_d n·l / |L|² with |L| = {}", number(length));
        wrong.push((&FADES_WITH_DISTANCE, how, lit.diffuse / (length * length)));
        let cosine = lit.n.dot(position.normalize_or_zero());
        wrong.push((&LIGHT_AS_DIRECTION, "I k_d n·position".to_owned(), term(lit.colour, cosine.max(0.0))));
    }
    for (cause, how, normal) in wrong_normals(case, case.check.ray) {
        let how = format!("{how}: I k_d max(0, n·l)");
        wrong.push((cause, how.clone(), term(lit.colour, normal.dot(lit.l).max(0.0))));
        wrong.push((cause, how, term(lit.arriving, normal.dot(lit.l).max(0.0))));
    }
    wrong
}

/// Guesses about the specular term of a light.
pub fn of_specular(case: Case, light: EventId, guesses: &mut Vec<Guess>) {
    let Some(lit) = lit(case, light) else { return };
    for (cause, how, value) in wrong_specular(case, &lit) {
        guesses.push(Guess::vector(cause, how, value));
    }
    of_exponent(case, &lit, guesses);
}

/// Specular terms that come out of mistakes.
pub(super) fn wrong_specular(case: Case, lit: &Lit) -> Vec<(&'static Cause, String, DVec3)> {
    let Lit { l, n, v, exponent, .. } = *lit;
    let r = reflect(-l, n);
    let shiny = |light: DVec3, cosine: f64| light * lit.k_s * portable::powf(cosine.max(0.0), exponent);
    let halfway = (l + v).normalize_or_zero();
    let mut wrong = vec![
        (&SHADOW_IGNORED, format!("I k_s (r·v)^f with r·v = {}", number(r.dot(v))), shiny(lit.colour, r.dot(v))),
        (&HALF_ANGLE, format!("I k_s (n·h)^f with h = {}", vector(halfway)), shiny(lit.arriving, n.dot(halfway))),
        (&HIGHLIGHT_MIRROR_SIGN, "I k_s (−r·v)^f".to_owned(), shiny(lit.arriving, -r.dot(v))),
        (&HIGHLIGHT_VIEW_SIGN, "I k_s (r·dir)^f".to_owned(), shiny(lit.arriving, -r.dot(v))),
        (
            &HIGHLIGHT_VIEW_LENGTH,
            format!("I k_s (r·(−dir))^f with |dir| = {}", number(lit.direction.length())),
            shiny(lit.arriving, -r.dot(lit.direction)),
        ),
        (
            &HIGHLIGHT_TIMES_COSINE,
            format!("I k_s (r·v)^f n·l with n·l = {}", number(n.dot(l))),
            lit.specular * n.dot(l),
        ),
    ];
    let how = format!("the surface itself passes {} of the light: I_spec", number(lit.transparency));
    wrong.push((&SELF_HIT, how, lit.specular * lit.transparency));
    let share = DVec3::from_array(std::array::from_fn(|k| ratio(lit.arriving[k], lit.colour[k])));
    wrong.push((&LIGHT_COLOUR_IGNORED, "k_s (r·v)^f".to_owned(), shiny(share, r.dot(v))));
    of_strength(lit, r, &mut wrong);
    let is_diffuse_right = case.agrees(case.check.ray, |subject| matches!(subject, Subject::Diffuse(_)));
    for (cause, how, normal) in wrong_normals(case, case.check.ray).into_iter().filter(|_| !is_diffuse_right) {
        let is_lit = normal.dot(l) > 0.0;
        let cosine = reflect(-l, normal).dot(v);
        let value = if is_lit { shiny(lit.colour, cosine) } else { DVec3::ZERO };
        wrong.push((cause, format!("{how}: I k_s (r·v)^f"), value));
    }
    wrong
}

/// Highlights of another exponent, and of a light whose direction or strength is not what it should be; `r` is the mirrored
/// direction of the light.
fn of_strength(lit: &Lit, r: DVec3, wrong: &mut Vec<(&'static Cause, String, DVec3)>) {
    let Lit { v, exponent, .. } = *lit;
    let shiny = |light: DVec3, cosine: f64| light * lit.k_s * portable::powf(cosine.max(0.0), exponent);
    for factor in [0.25, 0.5, 2.0, 4.0] {
        let value = lit.arriving * lit.k_s * portable::powf(r.dot(v).max(0.0), exponent * factor);
        wrong.push((
            &EXPONENT,
            format!("I k_s (r·v)^{} in place of {}", number(exponent * factor), number(exponent)),
            value,
        ));
    }
    if let Some(to_light) = lit.to_light {
        let length = to_light.length();
        let how = format!("I k_s (R·v)^f with |R| = |L| = {}", number(length));
        wrong.push((&LIGHT_NOT_NORMALISED, how, shiny(lit.arriving, r.dot(v) * length)));
        wrong.push((&FADES_WITH_DISTANCE, "I k_s (r·v)^f / |L|²".to_owned(), lit.specular / (length * length)));
    }
}

/// The exponent that would give their highlight, if one gives it in all three colours.
fn of_exponent(case: Case, lit: &Lit, guesses: &mut Vec<Guess>) {
    let (Some(theirs), r) = (case.theirs(), reflect(-lit.l, lit.n)) else { return };
    let full = lit.arriving * lit.k_s;
    for (cause, name, base) in
        [(&EXPONENT, "r·v", r.dot(lit.v)), (&HALF_ANGLE, "n·h", lit.n.dot((lit.l + lit.v).normalize_or_zero()))]
    {
        if base <= 0.0 || base >= 1.0 || full.x <= 0.0 || theirs.x <= 0.0 {
            continue;
        }
        let exponent = portable::ln(theirs.x / full.x) / portable::ln(base);
        // Any one number is some power of another; a power that somebody would write is a whole number or a quarter.
        let is_plain = ((4.0 * exponent).round() - 4.0 * exponent).abs() < 1e-3;
        if is_plain && exponent >= 0.0 {
            let how = format!("I k_s ({name})^f with f = {} in place of {}", number(exponent), number(lit.exponent));
            guesses.push(Guess::vector(cause, how, full * portable::powf(base, exponent)));
        }
    }
}

fn ratio(part: f64, whole: f64) -> f64 {
    if whole == 0.0 { 0.0 } else { part / whole }
}
