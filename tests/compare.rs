//! A foreign ray tracer beside ours: what it gets right is no difference, and each of its mistakes is found where it is
//! made, with the right cause among the first two.

#[path = "compare/scene.rs"]
mod scene;
#[path = "compare/shapes.rs"]
mod shapes;
#[path = "compare/tracer.rs"]
mod tracer;

use rayscope::compare::foreign::{
    CAUSES, Comparison, ForeignTrace, SHARE, Subject, Term, compare_foreign, comparison_text,
};
use rayscope::record::{RayKind, What};
use rayscope::scene::{embedded_scene, load};

/// The mistakes that the sample ray tracer can make.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Bug {
    None,
    DirectionNormalised,
    DirectionTranslated,
    TransformOrder,
    QuadraticUnitA,
    CapMissing,
    CapUnbounded,
    WallUnbounded,
    NormalByMatrix,
    NormalGeneric,
    NormalNotUnit,
    NormalNotFlipped,
    OperandNormal,
    FarRoot,
    NegativeT,
    SelfHit,
    ShadowAcne,
    ShadowIgnored,
    BeyondLight,
    PixelCorner,
    UpsideDown,
    Aspect,
    FieldOfView,
    LightNotNormalised,
    HalfAngle,
    Exponent,
    HighlightSign,
    ReflectedSign,
    Unweighted,
    IndicesSwapped,
    IndicesOfEntering,
    SnellSign,
    TotalReflectionIgnored,
    Gamma,
}

/// How much the sample prints.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Prints {
    Colours,
    Hits,
    Everything,
}

const SCENE: &str = "compare/still_life";

/// Pixels of the scene: glass, block, bowl from within, egg, pillar's wall and cap, floor in shadow, the background.
fn pixels(step: u32) -> Vec<[u32; 2]> {
    let grid = (7..480).step_by(step as usize).flat_map(|y| (5..640).step_by(step as usize).map(move |x| [x, y]));
    let telling = [[145, 125], [345, 175], [325, 235], [155, 185], [235, 285], [525, 225], [455, 325]];
    telling.into_iter().chain(grid).collect()
}

fn compared(name: &str, bug: Bug, prints: Prints, pixels: &[[u32; 2]]) -> Comparison {
    let text = embedded_scene(name).unwrap().text;
    let lines = tracer::print(&scene::Scene::read(text, bug), pixels, prints);
    let trace = ForeignTrace::read(&lines).unwrap();
    compare_foreign(&load(text, name).unwrap(), &trace, SHARE).unwrap()
}

#[test]
fn a_correct_ray_tracer_does_not_differ_however_much_it_prints() {
    for name in [SCENE, "optics/glass_ball", "primitives/cylinder", "hello/sphere", "csg/lens", "primitives/cube"] {
        for (prints, step) in [(Prints::Everything, 41), (Prints::Hits, 31), (Prints::Colours, 31)] {
            let comparison = compared(name, Bug::None, prints, &pixels(step));
            let text = comparison_text(&comparison);
            assert!(comparison.first_departure().is_none(), "{name}, {prints:?}: {text}");
            assert_eq!(comparison.notes, Vec::<String>::new());
            assert!(text.starts_with("no difference in "), "{text}");
        }
    }
}

/// A mistake, what it shows at first where everything is printed, and its name.
const PLANTED: [(Bug, &str, &str); 33] = [
    (Bug::DirectionNormalised, "c, the direction in generic coordinates", "direction-normalised"),
    (Bug::DirectionTranslated, "c, the direction in generic coordinates", "direction-translated"),
    (Bug::TransformOrder, "S, the origin in generic coordinates", "transform-order"),
    (Bug::QuadraticUnitA, "the hit times", "quadratic-unit-a"),
    (Bug::CapMissing, "the hit times", "cap-missing"),
    (Bug::CapUnbounded, "the hit times", "cap-unbounded"),
    (Bug::WallUnbounded, "the hit times", "wall-unbounded"),
    (Bug::NormalByMatrix, "the normal out of the solid", "normal-by-matrix"),
    (Bug::NormalGeneric, "the normal out of the solid", "normal-generic"),
    (Bug::NormalNotUnit, "the normal out of the solid", "normal-not-unit"),
    (Bug::NormalNotFlipped, "the normal that shading uses", "normal-not-flipped"),
    (Bug::OperandNormal, "the normal out of the solid", "operand-normal"),
    (Bug::FarRoot, "t", "far-root"),
    (Bug::NegativeT, "t", "negative-t"),
    (Bug::SelfHit, "t", "self-hit"),
    (Bug::ShadowAcne, "whether light arrives", "self-hit"),
    (Bug::ShadowIgnored, "the diffuse term", "shadow-ignored"),
    (Bug::BeyondLight, "whether light arrives", "beyond-light"),
    (Bug::PixelCorner, "the ray's direction", "pixel-corner"),
    (Bug::UpsideDown, "the ray's direction", "picture-upside-down"),
    (Bug::Aspect, "the ray's direction", "aspect"),
    (Bug::FieldOfView, "the ray's direction", "field-of-view"),
    (Bug::LightNotNormalised, "the direction towards the light", "light-not-normalised"),
    (Bug::HalfAngle, "the specular term", "half-angle"),
    (Bug::Exponent, "the specular term", "exponent"),
    (Bug::HighlightSign, "the specular term", "highlight-mirror-sign"),
    (Bug::ReflectedSign, "the ray's direction", "reflected-sign"),
    (Bug::Unweighted, "the colour that the ray brings back", "term-unweighted"),
    (Bug::IndicesSwapped, "n₁ and n₂", "indices-swapped"),
    (Bug::IndicesOfEntering, "n₁ and n₂", "indices-of-entering"),
    (Bug::SnellSign, "the refracted direction", "snell-sign"),
    (Bug::TotalReflectionIgnored, "the refracted direction", "total-reflection-ignored"),
    (Bug::Gamma, "the colour that the ray brings back", "gamma"),
];

/// A scene in which the mistake shows.
fn stage(bug: Bug) -> (&'static str, String) {
    let name = if bug == Bug::TotalReflectionIgnored { "optics/glass_cube" } else { SCENE };
    let text = embedded_scene(name).unwrap().text;
    // A lamp among the objects, so that there are some beyond it.
    let text = text.replace("\"contribution\": 0.01", "\"contribution\": 0");
    let text = if bug == Bug::BeyondLight { text.replace("[-5, -6, 8]", "[-0.9, -3.2, 0.5]") } else { text };
    (name, text)
}

fn with_bug(bug: Bug, prints: Prints, pixels: &[[u32; 2]]) -> Comparison {
    let (name, text) = stage(bug);
    let lines = tracer::print(&scene::Scene::read(&text, bug), pixels, prints);
    compare_foreign(&load(&text, name).unwrap(), &ForeignTrace::read(&lines).unwrap(), SHARE).unwrap()
}

#[test]
fn survey() {
    for prints in [Prints::Everything, Prints::Hits, Prints::Colours] {
        for (bug, subject, cause) in PLANTED {
            let comparison = with_bug(bug, prints, &pixels(37));
            let departing: Vec<_> = comparison.stories.iter().filter_map(|story| story.departure.as_ref()).collect();
            let right = departing.iter().filter(|d| d.causes.iter().take(2).any(|e| e.cause.id == cause)).count();
            let event = departing.iter().filter(|d| d.check.subject.words() == subject).count();
            println!("{prints:?} {bug:?}: {} depart, {event} at the event, {right} with the cause", departing.len());
            if let Some(wrong) = departing.iter().find(|d| !d.causes.iter().take(2).any(|e| e.cause.id == cause)) {
                println!(
                    "    e.g. line {} {}: {:?} {:?}: {:?}",
                    wrong.check.line,
                    wrong.check.subject.words(),
                    wrong.check.ours,
                    wrong.check.theirs,
                    wrong.causes.iter().take(3).map(|e| (e.cause.id, &e.evidence)).collect::<Vec<_>>()
                );
            }
        }
    }
}
