//! Scenes in POV-Ray's language: what is written, what is refused, and that POV-Ray draws the same picture from it.

mod povray;

use rayscope::peer::{Agreement, to_povray};
use rayscope::record::Effect;
use rayscope::scene::{embedded_scene, embedded_scenes, load};
use std::fs;

/// What keeps an embedded scene from being said in POV-Ray's language.
const REFUSED: [(&str, &str); 2] = [
    ("optics/fishbowl", "media: transparent objects may overlap (bowl, water)"),
    ("optics/media_priority", "media: transparent objects may overlap"),
];

/// Effects that are not written in POV-Ray's language.
const WITHOUT_EQUAL: [Effect; 12] = [
    Effect::ApertureShape,
    Effect::SoftShadows,
    Effect::Fresnel,
    Effect::Dispersion,
    Effect::Attenuation,
    Effect::Scattering,
    Effect::Details,
    Effect::ImageTextures,
    Effect::SolidTextures,
    Effect::Bumps,
    Effect::Frames,
    Effect::Environment,
];

fn exported(text: &str) -> Result<String, String> {
    to_povray(&load(text, "test").unwrap())
}

/// A scene with one solid.
fn solid(solid: &str) -> Result<String, String> {
    exported(&format!(r#"{{"materials": {{"m": {{}}}}, "objects": [{solid}]}}"#))
}

#[test]
fn every_embedded_scene_can_be_said_or_is_refused_for_its_media() {
    for scene in embedded_scenes() {
        let reason = REFUSED.iter().find(|(name, _)| *name == scene.name).map(|(_, reason)| *reason);
        let compiled = load(scene.text, &scene.name).unwrap();
        let exported = to_povray(&compiled);
        let called_for = |effects: &[Effect]| effects.iter().any(|&effect| compiled.effects.has(effect));
        if called_for(&WITHOUT_EQUAL) {
            let refused = exported.expect_err(&scene.name);
            let parts = ["environment:", "object `", "material `", "light `", "camera:", "media:"];
            assert!(parts.iter().any(|part| refused.starts_with(part)), "{refused}");
            continue;
        }
        match (exported, reason) {
            (Ok(_), None) => {}
            (Err(message), Some(reason)) => assert!(message.starts_with(reason), "{}: {message}", scene.name),
            (Ok(_), Some(_)) => panic!("{} is not refused", scene.name),
            (Err(message), None) => panic!("{}: {message}", scene.name),
        }
    }
}

#[test]
fn numbers_keep_all_of_their_digits() {
    let sdl = solid(
        r#"{"shape": "sphere", "material": "m", "transform": [{"translate": [0.1, 1e-300, 12345678901234.567]}]}"#,
    );
    let expected = "matrix <1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.1, 1e-300, 12345678901234.566>";
    assert!(sdl.as_ref().unwrap().contains(expected), "{sdl:?}");
}

#[test]
fn a_union_has_no_surfaces_inside_and_a_difference_stays_binary() {
    let sdl = solid(
        r#"{"shape": "difference", "material": "m", "of": [{"shape": "cube"}, {"shape": "sphere"},
            {"shape": "union", "of": [{"shape": "cone"}, {"shape": "cylinder"}]}]}"#,
    )
    .unwrap();
    let shapes: Vec<&str> = sdl.lines().filter_map(|line| line.split_once(" {").map(|(word, _)| word)).collect();
    let tree = &shapes[shapes.iter().position(|word| *word == "difference").unwrap()..];
    assert_eq!(tree, ["difference", "  difference", "    box", "    sphere", "  merge", "    cone", "    cylinder"]);
}

/// A point at x = 1 on the generic axis z of the tube's circle must stay in the plane z = 0: POV-Ray's y goes to z.
#[test]
fn the_axis_of_a_torus_is_turned_from_y_to_z() {
    let sdl = solid(r#"{"shape": "torus", "d": 2, "material": "m"}"#).unwrap();
    let columns = "matrix <0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0>";
    assert!(sdl.contains(&format!("torus {{ 2.0, 1 {columns}")), "{sdl}");
}

#[test]
fn what_cannot_be_said_is_named_with_its_place() {
    let spindle = solid(r#"{"shape": "torus", "d": 0.5, "name": "ring", "material": "m"}"#).unwrap_err();
    assert!(spindle.starts_with("object `ring`: `ring`: d is 0.5; below 1 the tube overlaps itself"), "{spindle}");
    let coloured =
        r#"{"materials": {"gold": {"specular": [1, 0.8, 0.3]}}, "objects": [{"shape": "cube", "material": "gold"}]}"#;
    assert!(exported(coloured).unwrap_err().starts_with("material `gold`: its highlights are coloured"));
}

#[test]
fn a_name_cannot_end_its_comment() {
    let sdl = solid(r#"{"shape": "cube", "name": "a\nsphere { S₁", "material": "m"}"#).unwrap();
    assert!(sdl.contains("// a\\nsphere { S\\u{2081}\n"), "{sdl}");
}

/// The share of pixels that agree; what is left lies on edges, where the two programs round to different sides.
#[test]
fn pov_ray_draws_the_same_pictures_from_what_is_written() {
    for name in ["csg/nested", "skewed/convex_polyhedron", "skewed/superellipsoid", "skewed/torus", "optics/mirrors"] {
        let scene = load(embedded_scene(name).unwrap().text, name).unwrap();
        let file = tempfile::Builder::new().suffix(".pov").tempfile().unwrap();
        fs::write(file.path(), to_povray(&scene).unwrap()).unwrap();
        let Some(theirs) = povray::picture(file.path(), 160, 120) else { return };
        let agreement = Agreement::of(&povray::ours(scene, 160, 120), &theirs).unwrap();
        assert!(agreement.share >= 0.999, "{name}: {agreement:?}");
    }
}
