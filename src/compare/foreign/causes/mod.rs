//! Why a foreign number departs from ours: known mistakes of ray tracers, each tried out.
//!
//! **Method.** A cause is not guessed from patterns. From the numbers that we recorded it is worked out what the mistake would give,
//! by its formula, and that is compared with what the other program says. Causes that give the foreign number within what is
//! allowed are listed, the closest first; among equally close ones the order of this table decides, which goes from specific
//! to general.

mod bend;
mod camera;
mod colour;
mod generic;
mod hit;
mod light;
mod normal;
mod shadow;
mod times;

use super::check::{Check, Subject, apart, unit};
use super::ours::Ours;
use crate::view::significant;
use glam::DVec3;

/// A mistake that ray tracers are known to make.
#[derive(Debug, PartialEq, Eq)]
pub struct Cause {
    /// Its name for programs, which stays as it is.
    pub id: &'static str,
    /// What is wrong, in words.
    pub says: &'static str,
}

/// A cause with its evidence.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// The cause.
    pub cause: &'static Cause,
    /// The formula of the mistake with this ray's numbers, and what it gives.
    pub evidence: String,
    /// How far what it gives lies from the foreign number, in what is allowed: at most 1.
    pub misfit: f64,
}

macro_rules! causes {
    ($($name:ident $id:literal $says:literal,)*) => {
        $(pub(super) static $name: Cause = Cause { id: $id, says: $says };)*
        /// All causes, from specific to general.
        pub static CAUSES: &[&Cause] = &[$(&$name),*];
    };
}

causes! {
    DIRECTION_NORMALISED "direction-normalised" "the direction is normalised in generic coordinates, so that t no longer means the same there and in the world",
    DIRECTION_TRANSLATED "direction-translated" "the direction is transformed as a point: the translation is added to it",
    NOT_TRANSFORMED "not-transformed" "the ray is not taken into generic coordinates",
    FORWARD_MATRIX "forward-matrix" "the object's matrix is used in place of its inverse",
    TRANSFORM_ORDER "transform-order" "the transforms are applied in the wrong order",
    ROTATION_BACKWARDS "rotation-backwards" "the rotation goes the wrong way round",
    CAP_MISSING "cap-missing" "the caps are not tested, only the wall",
    WALL_UNBOUNDED "wall-unbounded" "hits with the wall beyond its ends are accepted",
    CAP_UNBOUNDED "cap-unbounded" "hits with the plane of a cap outside its disc are accepted",
    QUADRATIC_HALF_B "quadratic-half-b" "the formulas for B and for half of it are mixed up",
    QUADRATIC_UNIT_A "quadratic-unit-a" "A is taken for 1, as if the direction had length 1",
    QUADRATIC_SIGN_B "quadratic-sign-b" "B has the wrong sign in the solution of the quadratic",
    ONE_ROOT "one-root" "only one of the two roots is kept",
    OPERANDS_SWAPPED "operands-swapped" "the operands of the difference are swapped",
    RIGHT_OPERAND_IGNORED "right-operand-ignored" "the right operand has no effect",
    WRONG_OPERATOR "wrong-operator" "another Boolean operator is applied",
    SELF_HIT "self-hit" "shadow acne: the ray hits the surface that it starts on",
    FAR_ROOT "far-root" "the far hit with the object is taken",
    NEGATIVE_T "negative-t" "a hit behind the start of the ray is accepted",
    NOT_CLOSEST "not-closest" "not the closest hit is taken",
    HIT_MISSED "hit-missed" "the hit is lost, and the next one on the ray is taken",
    REJECTED_TAKEN "rejected-taken" "a hit is taken that does not count",
    BEYOND_LIGHT "beyond-light" "an object beyond the light is taken for a blocker",
    SHADOW_MISSED "shadow-missed" "the object in the way is not seen by the shadow ray",
    SHADOW_FROM_GLASS "shadow-from-glass" "a transparent object is taken for an opaque one",
    POINT_UNIT_DIRECTION "point-unit-direction" "the hit point is worked out with a unit direction, but t belongs to another length",
    POINT_GENERIC "point-generic" "the point is still in generic coordinates",
    POINT_FROM_ORIGIN "point-from-origin" "the ray's origin is not added to the point",
    NORMAL_NOT_FLIPPED "normal-not-flipped" "the normal is not turned towards the side that the ray comes from",
    OPERAND_NORMAL "operand-normal" "the normal of the right operand of a difference is not turned round",
    NORMAL_BY_MATRIX "normal-by-matrix" "the normal is transformed by the object's matrix, not by the inverse transpose",
    NORMAL_BY_INVERSE "normal-by-inverse" "the normal is transformed by the inverse, which was not transposed",
    NORMAL_GENERIC "normal-generic" "the normal is still in generic coordinates",
    NORMAL_TRANSLATED "normal-translated" "the normal is transformed as a point: the translation is added to it",
    NORMAL_NOT_UNIT "normal-not-unit" "the normal is not normalised",
    NORMAL_RADIAL "normal-radial" "the direction from the middle of the primitive is taken for its normal",
    NORMAL_OTHER_PART "normal-other-part" "the normal is that of another part of the surface",
    NORMAL_REVERSED "normal-reversed" "the normal points to the other side",
    PIXEL_CORNER "pixel-corner" "the ray goes through the corner of the pixel, not through its centre",
    PIXEL_SHIFTED "pixel-shifted" "the ray goes through another pixel",
    PICTURE_UPSIDE_DOWN "picture-upside-down" "rows are counted from the bottom",
    PICTURE_MIRRORED "picture-mirrored" "left and right are exchanged",
    ASPECT "aspect" "the picture's width and height are confused, or their ratio is left out",
    FIELD_OF_VIEW "field-of-view" "the field of view is not halved, or is not taken in degrees, or not vertically",
    VIEW_BACKWARDS "view-backwards" "the view goes from the scene to the eye",
    LIGHT_NOT_NORMALISED "light-not-normalised" "the direction towards the light is not normalised",
    LIGHT_BACKWARDS "light-backwards" "the direction runs from the light to the surface",
    LIGHT_AS_DIRECTION "light-as-direction" "the light's position is taken for the direction towards it",
    SHADOW_IGNORED "shadow-ignored" "the light is counted though something stands in its way",
    COSINE_ABSOLUTE "cosine-absolute" "the light is counted though it stands behind the surface",
    COSINE_NEGATIVE "cosine-negative" "a negative cosine is not set to 0",
    HALF_ANGLE "half-angle" "the highlight is worked out by the half angle, not by the mirrored direction",
    EXPONENT "exponent" "the highlight has another exponent",
    HIGHLIGHT_MIRROR_SIGN "highlight-mirror-sign" "the direction of the light is mirrored with the wrong sign",
    HIGHLIGHT_VIEW_SIGN "highlight-view-sign" "the direction to the eye has the wrong sign",
    HIGHLIGHT_VIEW_LENGTH "highlight-view-length" "the direction to the eye is not normalised",
    HIGHLIGHT_TIMES_COSINE "highlight-times-cosine" "the highlight is multiplied by n·l",
    LIGHT_COLOUR_IGNORED "light-colour-ignored" "the light's colour is left out",
    FADES_WITH_DISTANCE "fades-with-distance" "the light fades with the square of the distance",
    INDICES_SWAPPED "indices-swapped" "n₁ and n₂ are swapped",
    INDICES_OF_ENTERING "indices-of-entering" "the ray is taken to enter the glass though it leaves it",
    SNELL_NORMAL_NOT_FLIPPED "snell-normal-not-flipped" "Snell's law is applied with a normal on the far side",
    SNELL_NOT_NORMALISED "snell-not-normalised" "Snell's law is applied to a direction that is not normalised",
    SNELL_SIGN "snell-sign" "a sign in Snell's law is wrong",
    STRAIGHT_ON "straight-on" "the ray goes straight on",
    TOTAL_REFLECTION_IGNORED "total-reflection-ignored" "total internal reflection is not tested for",
    REFLECTED_SIGN "reflected-sign" "the mirrored direction has the wrong sign",
    REFLECTED_FACTOR "reflected-factor" "the factor 2 is missing in the mirrored direction",
    REFLECTED_NORMAL "reflected-normal" "the direction is mirrored at a normal that is not normalised",
    GAMMA "gamma" "the colour was encoded for the screen (sRGB, or a power of 1/2.2), which linear colours are not",
    GAMMA_MISSING "gamma-missing" "the colour was not encoded as sRGB before it was written",
    CLAMPED "clamped" "the colour is cut off at 1",
    BYTES "bytes" "the colour is in bytes from 0 to 255",
    TERM_MISSING "term-missing" "a term of the colour is left out",
    TERM_UNWEIGHTED "term-unweighted" "a spawned ray's colour is added without its weight",
    AMBIENT_PER_LIGHT "ambient-per-light" "the ambient term is counted once for every light",
    AMBIENT_UNLIT "ambient-unlit" "the ambient colour is not multiplied by the ambient light",
    STOPPED_BY_LIMIT "limit" "our tree ends here at a limit of the scene",
}

/// Within this part of what is allowed, which cause is the closer one is chance.
pub(super) const CLOSE: f64 = 0.1;

/// What a mistake would give.
pub(super) struct Guess {
    pub cause: &'static Cause,
    /// The formula with its numbers; what it gives is added.
    pub how: String,
    pub predicted: Vec<f64>,
}

/// A departure that is to be explained.
#[derive(Clone, Copy)]
pub(super) struct Case<'a, 'b> {
    pub ours: &'b Ours<'a>,
    pub check: &'b Check,
    /// All that was compared: what agrees refutes causes that would have changed it.
    pub checks: &'b [Check],
}

/// The causes that give the foreign number, the closest first.
pub(super) fn explain(case: Case) -> Vec<Explanation> {
    let mut explanations = words(case);
    let mut guesses = Vec::new();
    match case.check.subject {
        Subject::RayOrigin | Subject::Point => hit::of_point(case, &mut guesses),
        Subject::RayDirection => of_direction(case, &mut guesses),
        Subject::GenericOrigin(primitive) | Subject::GenericDirection(primitive) => {
            generic::of_transform(case, primitive, &mut guesses);
        }
        Subject::Hits(primitive) => times::of_primitive(case, primitive, &mut guesses),
        Subject::Edges(object) => times::of_edges(case, object, &mut guesses),
        Subject::Inside(object) => times::of_inside(case, object, &mut guesses),
        Subject::HitTime => hit::of_time(case, &mut guesses),
        Subject::Normal | Subject::Outward => normal::of_normal(case, &mut guesses),
        Subject::Towards(light) => light::of_towards(case, light, &mut guesses),
        Subject::Diffuse(light) => light::of_diffuse(case, light, &mut guesses),
        Subject::Specular(light) => light::of_specular(case, light, &mut guesses),
        Subject::Reflected => bend::of_reflected(case, &mut guesses),
        Subject::Indices => bend::of_indices(case, &mut guesses),
        Subject::Refracted => bend::of_refracted(case, &mut guesses),
        Subject::Term(term) => colour::of_term(case, term, &mut guesses),
        Subject::Colour => colour::of_colour(case, &mut guesses),
        Subject::Written => colour::of_written(case, &mut guesses),
        Subject::HitObject | Subject::HitLeaf | Subject::Lit(_) | Subject::BlockedBy(_) | Subject::ExtraRay => {}
    }
    explanations.extend(guesses.iter().filter_map(|guess| tried(case.check, guess)));
    ranked(explanations)
}

/// Departures that are not numbers are explained by those that go with them.
fn words(case: Case) -> Vec<Explanation> {
    match case.check.subject {
        Subject::Lit(light) | Subject::BlockedBy(light) => shadow::of_shadow(case, light),
        Subject::ExtraRay => bend::of_extra_ray(case),
        Subject::HitObject => hit::of_object(case),
        _ => Vec::new(),
    }
}

fn of_direction(case: Case, guesses: &mut Vec<Guess>) {
    use crate::record::RayKind;
    match case.ours.rays[case.check.ray].kind {
        RayKind::Camera => camera::of_direction(case, guesses),
        RayKind::Reflected => bend::of_reflected(case, guesses),
        RayKind::Refracted => bend::of_refracted(case, guesses),
        RayKind::Shadow => light::of_shadow_ray(case, guesses),
        RayKind::Scattered => {}
    }
}

/// The guess as an explanation, if it gives the foreign number.
fn tried(check: &Check, guess: &Guess) -> Option<Explanation> {
    let theirs = check.numbers();
    let lengths_count = !check.subject.is_direction();
    let off =
        if lengths_count { apart(&guess.predicted, theirs) } else { apart(&unit(&guess.predicted), &unit(theirs)) };
    let misfit = if off == 0.0 { 0.0 } else { off / check.allowed };
    let evidence = format!("{} = {}; theirs: {}", guess.how, list(&guess.predicted), list(theirs));
    // That there is nothing is foretold by many a mistake.
    let misfit = if guess.predicted.is_empty() { misfit.max(0.5) } else { misfit };
    (misfit <= 1.0).then_some(Explanation { cause: guess.cause, evidence, misfit })
}

/// The closest first, each cause once. What is equally close is told by the order of the table.
fn ranked(mut explanations: Vec<Explanation>) -> Vec<Explanation> {
    let place = |cause: &Cause| CAUSES.iter().position(|other| other.id == cause.id);
    explanations.sort_by_key(|explanation| (explanation.misfit > CLOSE, place(explanation.cause)));
    let mut distinct: Vec<Explanation> = Vec::new();
    for explanation in explanations {
        if !distinct.iter().any(|known| known.cause == explanation.cause) {
            distinct.push(explanation);
        }
    }
    distinct
}

impl Case<'_, '_> {
    /// The foreign vector.
    pub fn theirs(&self) -> Option<DVec3> {
        <[f64; 3]>::try_from(self.check.numbers()).ok().map(DVec3::from_array)
    }

    /// Where the ray goes that the check is about.
    pub fn direction(&self) -> DVec3 {
        self.ours.rays[self.check.ray].direction
    }

    /// Their unit of t in ours: the one that was found, and those that a direction which was not printed may mean.
    pub fn units(&self) -> Vec<f64> {
        let Some(unit) = self.check.unit else { return vec![1.0, 1.0 / self.direction().length()] };
        vec![unit]
    }

    /// Whether something else was told of the same ray, and agrees.
    pub fn agrees(&self, ray: usize, is_meant: impl Fn(Subject) -> bool) -> bool {
        self.checks.iter().any(|check| check.ray == ray && check.holds() && is_meant(check.subject))
    }

    /// Where it starts.
    pub fn origin(&self) -> DVec3 {
        self.ours.rays[self.check.ray].origin
    }
}

impl Guess {
    /// What a mistake gives, by its formula.
    pub fn new(cause: &'static Cause, how: impl Into<String>, predicted: impl Into<Vec<f64>>) -> Self {
        Self { cause, how: how.into(), predicted: predicted.into() }
    }

    /// The same for a vector.
    pub fn vector(cause: &'static Cause, how: impl Into<String>, predicted: DVec3) -> Self {
        Self::new(cause, how, predicted.to_array())
    }
}

/// A number with seven digits.
pub(super) fn number(x: f64) -> String {
    significant(x, 7)
}

/// One number, or several in parentheses.
pub(super) fn list(numbers: &[f64]) -> String {
    match numbers {
        [one] => number(*one),
        [] => "nothing".to_owned(),
        many => format!("({})", many.iter().map(|&x| number(x)).collect::<Vec<_>>().join(", ")),
    }
}

/// A vector with seven digits.
pub(super) fn vector(v: DVec3) -> String {
    list(&v.to_array())
}
