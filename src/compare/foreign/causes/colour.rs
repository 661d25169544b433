//! What can be wrong with the colour that a ray brings back.

use super::light::{Lit, lit, wrong_diffuse, wrong_specular};
use super::{
    AMBIENT_PER_LIGHT, AMBIENT_UNLIT, BEYOND_LIGHT, BYTES, CLAMPED, Case, Cause, GAMMA, GAMMA_MISSING, Guess, SELF_HIT,
    TERM_MISSING, TERM_UNWEIGHTED, number,
};
use crate::compare::Said;
use crate::compare::foreign::check::Term;
use crate::math::portable;
use crate::record::{RayKind, What};
use crate::trace::srgb;
use glam::DVec3;

/// A colour by its five terms.
struct Terms {
    ambient: DVec3,
    diffuse: DVec3,
    specular: DVec3,
    mirrored: DVec3,
    transmitted: DVec3,
    total: DVec3,
}

fn terms(case: Case) -> Option<Terms> {
    case.ours.of(case.check.ray).find_map(|event| match &event.what {
        What::Colour { ambient, diffuse, specular, reflected, transmitted, total } => Some(Terms {
            ambient: (*ambient).into(),
            diffuse: (*diffuse).into(),
            specular: (*specular).into(),
            mirrored: (*reflected).into(),
            transmitted: (*transmitted).into(),
            total: (*total).into(),
        }),
        _ => None,
    })
}

/// Guesses about a colour.
pub fn of_colour(case: Case, guesses: &mut Vec<Guess>) {
    if let Said::Numbers(ours) = &case.check.ours
        && let Ok(ours) = <[f64; 3]>::try_from(ours.as_slice())
    {
        of_encoding(ours.into(), guesses);
    }
    let Some(terms) = terms(case) else { return };
    for (name, term) in [
        ("ambient", terms.ambient),
        ("diffuse", terms.diffuse),
        ("specular", terms.specular),
        ("mirrored", terms.mirrored),
        ("refracted", terms.transmitted),
        ("mirrored and refracted", terms.mirrored + terms.transmitted),
    ] {
        guesses.push(Guess::vector(&TERM_MISSING, format!("the sum without the {name} term"), terms.total - term));
    }
    for (name, term, kind) in
        [("mirrored", terms.mirrored, RayKind::Reflected), ("refracted", terms.transmitted, RayKind::Refracted)]
    {
        let back = brought_back(case, kind);
        let how = format!("the sum with the {name} ray's colour as it is");
        guesses.push(Guess::vector(&TERM_UNWEIGHTED, how, terms.total - term + back));
    }
    for (cause, how, value) in wrong_ambient(case, &terms) {
        guesses.push(Guess::vector(cause, format!("{how}: the sum"), terms.total - terms.ambient + value));
    }
    for (cause, how, change) in wrong_lights(case) {
        guesses.push(Guess::vector(cause, format!("{how}: the sum"), terms.total + change));
    }
    for event in case.ours.of(case.check.ray) {
        let (What::Light { name, .. }, Some(lost)) = (&event.what, lit(case, event.id)) else { continue };
        let how = format!("the sum without the light {name}, which does not arrive");
        for cause in [&SELF_HIT, &BEYOND_LIGHT] {
            guesses.push(Guess::vector(cause, how.clone(), terms.total - lost.diffuse - lost.specular));
        }
    }
}

/// What came back along the spawned rays of a kind, before it is weighted.
fn brought_back(case: Case, kind: RayKind) -> DVec3 {
    let spawned = case.ours.rays.iter().enumerate();
    let spawned = spawned.filter(|(_, ray)| ray.parent == Some(case.check.ray) && ray.kind == kind);
    let colour = |ray: usize| {
        let told = case.ours.of(ray).filter_map(|event| match &event.what {
            What::Colour { total, .. } => Some(DVec3::from_array(*total)),
            What::Nothing { background } => Some(DVec3::from_array(*background)),
            _ => None,
        });
        told.last().unwrap_or_default()
    };
    spawned.map(|(ray, _)| colour(ray)).sum()
}

fn of_encoding(ours: DVec3, guesses: &mut Vec<Guess>) {
    let encoded = srgb_of(ours);
    let root = |degree: f64| ours.max(DVec3::ZERO).map(|x| portable::powf(x, 1.0 / degree));
    guesses.push(Guess::vector(&CLAMPED, "min(1, I)", ours.clamp(DVec3::ZERO, DVec3::ONE)));
    guesses.push(Guess::vector(&GAMMA, "sRGB of I", encoded));
    guesses.push(Guess::vector(&GAMMA, "sRGB of I, rounded to bytes", (encoded * 255.0).round() / 255.0));
    guesses.push(Guess::vector(&GAMMA, "I^(1/2.2)", root(2.2)));
    guesses.push(Guess::vector(&GAMMA, "√I", root(2.0)));
    guesses.push(Guess::vector(&BYTES, "255 I", ours * 255.0));
    guesses.push(Guess::vector(&BYTES, "255 I, rounded", (ours * 255.0).round()));
    guesses.push(Guess::vector(&BYTES, "sRGB of I in bytes", (encoded * 255.0).round()));
}

/// The encoding of IEC 61966-2-1, from 0 to 1.
fn srgb_of(linear: DVec3) -> DVec3 {
    let one = |x: f64| {
        let x = x.clamp(0.0, 1.0);
        if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * portable::powf(x, 1.0 / 2.4) - 0.055 }
    };
    DVec3::from_array(linear.to_array().map(one))
}

fn wrong_ambient(case: Case, terms: &Terms) -> Vec<(&'static Cause, String, DVec3)> {
    let lights = case.ours.scene.lights.len() as f64;
    let ambient = case.ours.scene.ambient;
    let unlit =
        DVec3::from_array(std::array::from_fn(|k| if ambient[k] == 0.0 { 0.0 } else { terms.ambient[k] / ambient[k] }));
    vec![
        (&AMBIENT_PER_LIGHT, format!("{} I_amb", number(lights)), terms.ambient * lights),
        (&AMBIENT_UNLIT, "k_a".to_owned(), unlit),
    ]
}

/// By how much the sum changes if all lights are worked out with a mistake.
fn wrong_lights(case: Case) -> Vec<(&'static Cause, String, DVec3)> {
    let lights: Vec<Lit> = case
        .ours
        .of(case.check.ray)
        .filter(|event| matches!(event.what, What::Light { .. }))
        .filter_map(|event| lit(case, event.id))
        .collect();
    let mut changes: Vec<(&'static Cause, String, DVec3)> = Vec::new();
    for (name, terms) in [
        ("diffuse", lights.iter().map(|lit| (lit.diffuse, wrong_diffuse(case, lit))).collect::<Vec<_>>()),
        ("specular", lights.iter().map(|lit| (lit.specular, wrong_specular(case, lit))).collect()),
    ] {
        // Every light has the same mistakes in the same order, but for those that only points can have.
        let Some((_, longest)) = terms.iter().max_by_key(|(_, wrong)| wrong.len()) else { continue };
        for (place, (cause, how, _)) in longest.iter().enumerate() {
            let change = |(ours, wrong): &(DVec3, Vec<(&'static Cause, String, DVec3)>)| {
                let same = wrong.get(place).filter(|(other, ..)| other == cause);
                same.map_or(DVec3::ZERO, |(_, _, value)| *value - *ours)
            };
            changes.push((cause, format!("{name} terms of all lights by {how}"), terms.iter().map(change).sum()));
        }
    }
    both(&mut changes);
    changes
}

/// A mistake that changes diffuse and specular terms alike changes the sum by both.
fn both(changes: &mut Vec<(&'static Cause, String, DVec3)>) {
    let mut together = Vec::new();
    for (cause, how, change) in changes.iter().filter(|(_, how, _)| how.starts_with("diffuse")) {
        for (_, other, more) in changes.iter().filter(|(same, how, _)| same == cause && how.starts_with("specular")) {
            together.push((*cause, format!("{how}, and {other}"), *change + *more));
        }
    }
    changes.extend(together);
}

/// Guesses about one of the five terms.
pub fn of_term(case: Case, term: Term, guesses: &mut Vec<Guess>) {
    let Some(terms) = terms(case) else { return };
    match term {
        Term::Ambient => {
            for (cause, how, value) in wrong_ambient(case, &terms) {
                guesses.push(Guess::vector(cause, how, value));
            }
            guesses.push(Guess::vector(&TERM_MISSING, "0", DVec3::ZERO));
        }
        Term::Diffuse | Term::Specular => {
            let (ours, word) =
                if term == Term::Diffuse { (terms.diffuse, "diffuse") } else { (terms.specular, "specular") };
            let changes = wrong_lights(case).into_iter().filter(|(_, how, _)| how.starts_with(word));
            guesses.extend(changes.map(|(cause, how, change)| Guess::vector(cause, how, ours + change)));
            guesses.push(Guess::vector(&TERM_MISSING, "0", DVec3::ZERO));
        }
        Term::Mirrored | Term::Transmitted => {
            let kind = if term == Term::Mirrored { RayKind::Reflected } else { RayKind::Refracted };
            guesses.push(Guess::vector(&TERM_UNWEIGHTED, "the ray's colour as it is", brought_back(case, kind)));
            guesses.push(Guess::vector(&TERM_MISSING, "0", DVec3::ZERO));
        }
    }
}

/// Guesses about the bytes of a pixel.
pub fn of_written(case: Case, guesses: &mut Vec<Guess>) {
    let colour: DVec3 = case.ours.tree.colour().into();
    let clamped = colour.clamp(DVec3::ZERO, DVec3::ONE);
    let bytes = |x: DVec3| (x * 255.0).round().to_array().to_vec();
    guesses.push(Guess::new(&GAMMA_MISSING, "255 I", bytes(clamped)));
    guesses.push(Guess::new(&GAMMA, "255 I^(1/2.2)", bytes(clamped.map(|x| portable::powf(x, 1.0 / 2.2)))));
    let twice = DVec3::from_array(srgb(srgb_of(clamped)).map(f64::from));
    guesses.push(Guess::new(&GAMMA, "sRGB of sRGB", twice.to_array()));
}
