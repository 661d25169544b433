//! A foreign ray tracer beside ours: what it gets right is no difference, and each of its mistakes is found where it is
//! made, with the right cause among the first two.

#[path = "compare/scene.rs"]
mod scene;
#[path = "compare/shapes.rs"]
mod shapes;
#[path = "compare/tracer.rs"]
mod tracer;

use rayscope::compare::foreign::{
    CAUSES, Comparison, ForeignDeparture, ForeignTrace, SHARE, Subject, compare_foreign, comparison_text, line_schema,
};
use rayscope::scene::{embedded_scene, load};
use std::path::Path;

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

/// The sample knows no limit but that of depth.
fn without_contribution(text: &str) -> String {
    let text = text.replace("\"contribution\": 0.01", "\"contribution\": 0");
    if text.contains("\"limits\"") { text } else { text.replacen('{', "{\"limits\": {\"contribution\": 0},", 1) }
}

fn compared(name: &str, bug: Bug, prints: Prints, pixels: &[[u32; 2]]) -> Comparison {
    let text = without_contribution(embedded_scene(name).unwrap().text);
    let lines = tracer::print(&scene::Scene::read(&text, bug), pixels, prints);
    let trace = ForeignTrace::read(&lines).unwrap();
    compare_foreign(&load(&text, name).unwrap(), &trace, SHARE).unwrap()
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
    (Bug::NegativeT, "the object that is hit", "negative-t"),
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
    let text = without_contribution(embedded_scene(name).unwrap().text);
    // A lamp among the objects, so that there are some beyond it.
    let text = if bug == Bug::BeyondLight { text.replace("[-5, -6, 8]", "[-0.9, -3.2, 0.5]") } else { text };
    (name, text)
}

fn with_bug(bug: Bug, prints: Prints, pixels: &[[u32; 2]]) -> Comparison {
    let (name, text) = stage(bug);
    let lines = tracer::print(&scene::Scene::read(&text, bug), pixels, prints);
    compare_foreign(&load(&text, name).unwrap(), &ForeignTrace::read(&lines).unwrap(), SHARE).unwrap()
}

/// Which object is hit, and when, is told by one event.
fn event_of(subject: &str) -> &str {
    match subject {
        "the object that is hit" | "the primitive that is hit" => "t",
        other => other,
    }
}

/// Stories that depart, those of them that do so at the event, and those with the cause among the first two.
fn found(bug: Bug, prints: Prints, subject: &str, cause: &str) -> [usize; 3] {
    let comparison = with_bug(bug, prints, &pixels(43));
    let departing: Vec<_> = comparison.stories.iter().filter_map(|story| story.departure.as_ref()).collect();
    let at_event =
        departing.iter().filter(|departure| event_of(departure.check.subject.words()) == event_of(subject)).count();
    let explained =
        |departure: &&&ForeignDeparture| departure.causes.iter().take(2).any(|found| found.cause.id == cause);
    let right = departing.iter().filter(explained).count();
    let story = comparison.stories.iter().find(|story| story.departure.as_ref().is_some_and(|d| !explained(&&d)));
    if let Some(departure) = story.and_then(|story| story.departure.as_ref()) {
        println!("{bug:?}, {prints:?}: not explained: {departure:?}");
    }
    [departing.len(), at_event, right]
}

#[test]
fn each_planted_mistake_is_found_where_it_is_made_with_its_cause_among_the_first_two() {
    let mut wrong = Vec::new();
    for (bug, subject, cause) in PLANTED {
        let [departing, at_event, right] = found(bug, Prints::Everything, subject, cause);
        println!("{bug:?}: {departing} stories depart, {at_event} at the event, {right} with the cause");
        // Where a mistake only shows in what follows from it, another event is the first.
        if departing == 0 || 4 * at_event < 3 * departing || 10 * right < 9 * departing {
            wrong.push(format!("{bug:?}: {departing} depart, {at_event} at the event, {right} with the cause"));
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
}

#[test]
fn mistakes_are_found_in_hits_and_colours_alone() {
    let mut wrong = Vec::new();
    for (bug, subject, cause) in PLANTED {
        let [departing, _, right] = found(bug, Prints::Hits, subject, cause);
        println!("{bug:?}: {departing} stories depart, {right} with the cause");
        // These show too little there: a ray that goes elsewhere may go there for many reasons.
        let is_dim = matches!(
            bug,
            Bug::TotalReflectionIgnored
                | Bug::QuadraticUnitA
                | Bug::DirectionTranslated
                | Bug::WallUnbounded
                | Bug::IndicesSwapped
                | Bug::Unweighted
                | Bug::TransformOrder
        );
        if departing == 0 || (!is_dim && 10 * right < 8 * departing) {
            wrong.push(format!("{bug:?}: {departing} depart, {right} with the cause"));
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
}

#[test]
fn the_three_sample_programs_printed_what_is_no_difference() {
    let scene = load(embedded_scene(SCENE).unwrap().text, SCENE).unwrap();
    for (language, lines) in [
        ("Python", include_str!("compare/python.jsonl")),
        ("C++", include_str!("compare/cpp.jsonl")),
        ("JavaScript", include_str!("compare/javascript.jsonl")),
    ] {
        let comparison = compare_foreign(&scene, &ForeignTrace::read(lines).unwrap(), SHARE).unwrap();
        assert!(comparison.first_departure().is_none(), "{language}: {}", comparison_text(&comparison));
        assert_eq!(comparison.stories.len(), 9, "{language}");
        assert!(comparison.checks() > 1000, "{language}: {} checks", comparison.checks());
    }
}

#[test]
fn the_sample_programs_are_short() {
    for name in ["tracer.py", "tracer.cpp", "tracer.js"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/compare").join(name);
        let lines = std::fs::read_to_string(path).unwrap().lines().count();
        assert!(lines < 250, "{name} has {lines} lines");
    }
}

#[test]
fn nothing_is_required_but_a_pixel_or_a_ray_and_one_thing() {
    let scene = load(embedded_scene(SCENE).unwrap().text, SCENE).unwrap();
    let compared = |lines: &str| compare_foreign(&scene, &ForeignTrace::read(lines).unwrap(), SHARE).unwrap();
    let seen = compared("{\"pixel\": [345, 175]}\n{\"hit\": \"bowl\"}");
    assert_eq!((seen.checks(), seen.first_departure().is_none()), (1, true));
    let wrong = compared("{\"pixel\": [345, 175], \"colour\": [0, 0, 0]}");
    assert_eq!(wrong.first_departure().unwrap().1.check.subject, Subject::Colour);
    let ray = compared(
        "{\"ray\": \"camera\", \"origin\": [0, 0, 5], \"direction\": [0, 0, -1], \"hit\": \"floor\", \"t\": 5}",
    );
    assert!(ray.first_departure().is_none() && ray.checks() >= 2, "{}", comparison_text(&ray));
    let unknown = compared("{\"pixel\": [1, 2], \"colur\": [0, 0, 0]}");
    assert!(unknown.notes[0].contains("did you mean `colour`?"), "{:?}", unknown.notes);
    let nowhere = compared("{\"t\": 3}");
    assert!(nowhere.stories.is_empty() && nowhere.notes[0].contains("belong to no pixel"), "{:?}", nowhere.notes);
}

#[test]
fn times_are_told_in_the_length_of_the_direction_that_is_printed_or_in_that_of_a_unit_direction() {
    let scene = load(embedded_scene(SCENE).unwrap().text, SCENE).unwrap();
    let ray =
        "{\"ray\": \"camera\", \"origin\": [0, 0, 5], \"direction\": [0, 0, -4]}\n{\"hit\": \"floor\", \"t\": 1.25}";
    let comparison = compare_foreign(&scene, &ForeignTrace::read(ray).unwrap(), SHARE).unwrap();
    assert!(comparison.first_departure().is_none(), "{}", comparison_text(&comparison));
    let camera = &scene.camera;
    let direction = camera.ray_direction(scene.image, 20.5, 400.5);
    let t = -camera.eye.z / direction.z;
    for (t, holds) in [(t, true), (t * direction.length(), true), (t * 1.01, false)] {
        let lines = format!("{{\"pixel\": [20, 400]}}\n{{\"hit\": \"floor\", \"t\": {t}}}");
        let comparison = compare_foreign(&scene, &ForeignTrace::read(&lines).unwrap(), SHARE).unwrap();
        assert_eq!(comparison.first_departure().is_none(), holds, "{}", comparison_text(&comparison));
    }
}

#[test]
fn every_cause_has_a_name_of_its_own_and_stands_in_the_documentation() {
    let format = include_str!("../scenes/compare/format.md");
    for (place, cause) in CAUSES.iter().enumerate() {
        assert!(!CAUSES[..place].iter().any(|other| other.id == cause.id), "{}", cause.id);
        assert!(format.contains(&format!("`{}`", cause.id)), "{} is not in format.md", cause.id);
    }
}

/// Run with `RAYSCOPE_UPDATE=1` to write the schema anew.
#[test]
fn the_committed_schema_is_the_one_that_the_types_give_and_the_sample_lines_keep_to_it() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/compare.schema.json");
    let schema = format!("{}\n", serde_json::to_string_pretty(&line_schema()).unwrap());
    if std::env::var_os("RAYSCOPE_UPDATE").is_some() {
        std::fs::write(&path, &schema).unwrap();
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        schema == committed,
        "scenes/compare.schema.json is out of date: `rayscope schema compare` prints the new one"
    );
    let validator = jsonschema::validator_for(&serde_json::from_str(&schema).unwrap()).unwrap();
    for line in include_str!("compare/python.jsonl").lines() {
        let line: serde_json::Value = serde_json::from_str(line).unwrap();
        assert!(validator.is_valid(&line), "{line}");
    }
}
