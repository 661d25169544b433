//! What must have happened to a pixel's rays before a question can hold of one of its events.
//!
//! It is found out by tracing alone, which counts rays and entered effects and records nothing. What is said here must follow from
//! the question: a need that does not is a pixel that is lost.

use crate::query::Vocabulary;
use crate::query::expression::{Comparison, Expression, Value};
use crate::query::token::Sign;
use crate::record::{Effect, RayKind};
use crate::trace::Tally;

/// A condition on what the rays of a pixel did.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Need {
    /// None: it may always hold.
    Nothing,
    /// It cannot hold in this scene.
    Never,
    /// A ray of this kind was traced.
    Ray(RayKind),
    /// The code of this effect was entered.
    Call(Effect),
    /// All of these.
    All(Vec<Need>),
    /// One of these.
    Any(Vec<Need>),
}

/// Effects of which one is entered wherever Snell's law is asked.
const AT_INTERFACES: [Effect; 4] = [Effect::Refraction, Effect::Reflection, Effect::Fresnel, Effect::Dispersion];

impl Need {
    /// What a question needs.
    pub fn of(expression: &Expression, names: &Vocabulary) -> Self {
        match expression {
            Expression::Word(word) => of_word(word.name),
            Expression::Comparison(comparison) => of_comparison(comparison, names),
            // What does not hold needs nothing to have happened.
            Expression::Not(_) => Self::Nothing,
            Expression::All(terms) => Self::all(terms.iter().map(|term| Self::of(term, names)).collect()),
            Expression::Any(terms) => Self::any(terms.iter().map(|term| Self::of(term, names)).collect()),
            Expression::Has(inner) => Self::of(inner, names),
        }
    }

    fn all(needs: Vec<Self>) -> Self {
        if needs.contains(&Self::Never) {
            return Self::Never;
        }
        let needs: Vec<_> = needs.into_iter().filter(|need| *need != Self::Nothing).collect();
        if needs.is_empty() { Self::Nothing } else { Self::All(needs) }
    }

    fn any(needs: Vec<Self>) -> Self {
        if needs.contains(&Self::Nothing) {
            return Self::Nothing;
        }
        let needs: Vec<_> = needs.into_iter().filter(|need| *need != Self::Never).collect();
        if needs.is_empty() { Self::Never } else { Self::Any(needs) }
    }

    fn call(effects: &[Effect]) -> Self {
        Self::Any(effects.iter().map(|&effect| Self::Call(effect)).collect())
    }

    /// Whether it takes tracing to find out.
    pub const fn asks_rays(&self) -> bool {
        !matches!(self, Self::Nothing | Self::Never)
    }

    /// Whether what was counted for a pixel meets it.
    pub fn is_met(&self, tally: &Tally) -> bool {
        match self {
            Self::Nothing => true,
            Self::Never => false,
            Self::Ray(kind) => tally.rays(*kind) > 0,
            Self::Call(effect) => tally.calls(*effect) > 0,
            Self::All(needs) => needs.iter().all(|need| need.is_met(tally)),
            Self::Any(needs) => needs.iter().any(|need| need.is_met(tally)),
        }
    }
}

fn of_word(name: &str) -> Need {
    match name {
        "reflected" => Need::Ray(RayKind::Reflected),
        "refracted" => Need::Ray(RayKind::Refracted),
        "shadow" | "shadowed" | "dimmed" => Need::Ray(RayKind::Shadow),
        "scattered" => Need::Ray(RayKind::Scattered),
        "snell" | "tir" => Need::call(&AT_INTERFACES),
        "wavelength" => Need::Call(Effect::Dispersion),
        "metal" => Need::Call(Effect::Fresnel),
        "scatter" => Need::Call(Effect::Scattering),
        "lens" => Need::Call(Effect::DepthOfField),
        "sample" => Need::call(&[Effect::Antialiasing, Effect::DepthOfField]),
        "texture" => Need::call(&[Effect::ImageTextures, Effect::SolidTextures]),
        "bump" => Need::call(&[Effect::Bumps, Effect::Frames]),
        "detail" => Need::Call(Effect::Details),
        "environment" => Need::Call(Effect::Environment),
        _ => Need::Nothing,
    }
}

fn of_comparison(comparison: &Comparison, names: &Vocabulary) -> Need {
    // `!=` asks only for a value, whatever it is.
    let is_equal = comparison.sign == Sign::Equal;
    // Of other fields there may be values that are no name of the scene's.
    let is_named = matches!(comparison.field.name, "hit" | "left" | "leaf" | "material");
    if is_equal && is_named && comparison.unknown_name(names).is_some() {
        return Need::Never;
    }
    match (comparison.field.name, &comparison.value) {
        ("kind", Value::Name(pattern)) if is_equal => {
            let kinds = RayKind::ALL.into_iter().filter(|kind| pattern.matches(kind.name()));
            Need::any(kinds.map(|kind| if kind == RayKind::Camera { Need::Nothing } else { Need::Ray(kind) }).collect())
        }
        ("depth", Value::Number(depth)) if holds_of_none_but_spawned(comparison.sign, *depth) => {
            Need::any(RayKind::ALL.into_iter().filter(|&kind| kind != RayKind::Camera).map(Need::Ray).collect())
        }
        ("n1" | "n2" | "theta1" | "theta2" | "reflectance", _) => Need::call(&AT_INTERFACES),
        ("passes", _) => Need::Ray(RayKind::Shadow),
        _ => Need::Nothing,
    }
}

/// Whether a comparison of the depth excludes the ray from the eye, whose depth is 0.
fn holds_of_none_but_spawned(sign: Sign, depth: f64) -> bool {
    match sign {
        Sign::Equal => depth != 0.0,
        Sign::Unequal => depth == 0.0,
        Sign::Less | Sign::AtMost => false,
        Sign::More => depth >= 0.0,
        Sign::AtLeast => depth > 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::query::Query;

    fn need(question: &str) -> Need {
        let names = Vocabulary { objects: vec!["lens".to_owned()], ..Vocabulary::default() };
        Need::of(&Query::parse(question).unwrap().expression, &names)
    }

    #[test]
    fn needs_follow_from_the_question() {
        assert_eq!(need("refracted"), Need::Ray(RayKind::Refracted));
        assert_eq!(need("!refracted"), Need::Nothing);
        assert_eq!(need("refracted | hit"), Need::Nothing);
        assert_eq!(need("refracted & hit"), Need::All(vec![Need::Ray(RayKind::Refracted)]));
        assert_eq!(need("kind=refracted & hit=bowl"), Need::Never);
        assert_eq!(need("kind=refracted & hit=lens"), Need::All(vec![Need::Any(vec![Need::Ray(RayKind::Refracted)])]));
        assert_eq!(need("kind=*"), Need::Nothing);
        assert_eq!(need("depth<=2"), Need::Nothing);
        assert_ne!(need("depth>0"), Need::Nothing);
    }
}
