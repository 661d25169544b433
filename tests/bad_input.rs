//! Broken scene files: each has to be refused with the place, what was read, what was expected and what to do.

mod broken;

use broken::{Case, FILES, GLASS, OBJECTS};
use proptest::prelude::*;
use rayscope::scene::{compile_solid, embedded_scenes, load};

fn file_with_object(object: &str) -> String {
    format!(
        r#"{{"materials": {{"clay": {{}}, "glass": {{}}}},
"solids": {{"globe": {{"shape": "sphere"}}}},
"objects": [
{object}
]}}"#
    )
}

fn assert_refused(text: &str, case: &Case) {
    let errors = load(text, "bad.json").err().unwrap_or_else(|| panic!("accepted: {}", case.text)).errors;
    let [error] = &errors[..] else { panic!("{} errors instead of one in {}", errors.len(), case.text) };
    let place = format!("{}:{} at {}", error.line, error.column, error.path);
    assert_eq!(place.trim_end_matches(" at "), case.place, "{}", case.text);
    assert_eq!(error.message, case.message, "{}", case.text);
    assert_eq!(error.help.join("; "), case.help, "{}", case.text);
    assert_eq!(error.file, "bad.json");
}

#[test]
fn each_broken_file_is_refused_with_place_reason_and_help() {
    for case in FILES {
        assert_refused(case.text, case);
    }
}

#[test]
fn each_broken_object_is_refused_with_place_reason_and_help() {
    for case in OBJECTS {
        assert_refused(&file_with_object(case.text), case);
    }
}

#[test]
fn each_broken_material_is_refused_with_place_reason_and_help() {
    for case in GLASS {
        assert_refused(&format!("{{\"materials\": {{\"odd\":\n{}\n}}}}", case.text), case);
    }
}

#[test]
fn the_tables_hold_at_least_forty_files_and_no_file_twice() {
    let mut texts: Vec<_> = FILES.iter().chain(OBJECTS).map(|case| case.text).collect();
    texts.sort_unstable();
    texts.dedup();
    assert_eq!(texts.len(), FILES.len() + OBJECTS.len());
    assert!(texts.len() >= 40);
}

#[test]
fn all_errors_of_a_file_come_out_at_once_in_its_order() {
    let errors = load(include_str!("bad/many_errors.json"), "many_errors.json").unwrap_err();
    assert_eq!(format!("{errors}\n"), include_str!("bad/many_errors.txt"));
}

fn nested(depth: usize) -> String {
    let unions = r#"{"shape": "union", "of": ["#.repeat(depth);
    file_with_object(&format!(r#"{unions}{{"shape": "sphere", "material": "clay"}}{}"#, "]}".repeat(depth)))
}

#[test]
fn nesting_is_followed_as_deep_as_the_limit_and_refused_beyond_it() {
    assert!(load(&nested(98), "deep.json").is_ok());
    for depth in [99, 1_000, 100_000] {
        let errors = load(&nested(depth), "deep.json").unwrap_err().errors;
        assert_eq!(errors[0].message, "brackets are nested more than 200 deep");
    }
}

#[test]
fn a_list_of_operands_may_be_as_long_as_the_tree_may_be_deep() {
    let union_of = |count: usize| {
        let spheres = vec![r#"{"shape": "sphere"}"#; count].join(", ");
        file_with_object(&format!(r#"{{"shape": "union", "material": "clay", "of": [{spheres}]}}"#))
    };
    assert!(load(&union_of(256), "wide.json").is_ok());
    let errors = load(&union_of(257), "wide.json").unwrap_err().errors;
    assert_eq!(errors[0].message, "the tree of this solid has more than 256 levels");
}

#[test]
fn copies_of_copies_that_multiply_are_stopped() {
    let doubled = |i: usize| {
        let half = format!(r#"{{"shape": "copy", "solid": "s{}"}}"#, i - 1);
        format!(r#", "s{i}": {{"shape": "union", "of": [{half}, {half}]}}"#)
    };
    let text = format!(
        r#"{{"solids": {{"s0": {{"shape": "sphere"}}{}}}, "materials": {{"clay": {{}}}},
        "objects": [{{"shape": "copy", "solid": "s40", "material": "clay"}}]}}"#,
        (1..=40).map(doubled).collect::<String>()
    );
    let errors = load(&text, "copies.json").unwrap_err().errors;
    assert_eq!(errors[0].message, "the scene has more than 150000 primitives, copies counted");
}

#[test]
fn nonsense_without_end_is_answered_with_a_list_that_ends() {
    let text = format!(r#"{{"objects": [{}]}}"#, vec!["null"; 3_000].join(", "));
    let errors = load(&text, "nonsense.json").unwrap_err();
    assert_eq!((errors.errors.len(), errors.left_out), (500, 2_500));
    assert!(errors.to_string().ends_with("3000 errors in nonsense.json; the first 500 found are shown"));
}

#[test]
fn a_solid_of_a_probe_is_refused_in_one_line_with_every_reason() {
    let solid = serde_json::json!({"shape": "union", "of": [
        {"shape": "torus", "d": -1, "transform": [{"scale": 0}]},
        {"shape": "square"},
    ]});
    assert_eq!(
        compile_solid(&solid).unwrap_err(),
        "of[0].transform[0].scale: a scale of 0 flattens the solid, so that the transform is singular (it has no inverse) | \
         of[1]: a square has no inside, so it cannot be part of a union, intersection or difference; \
         use a thin cube, or make the square an object of its own"
    );
    let solid = serde_json::json!({"shape": "union", "of": [{"shape": "shpere"}, {"shape": "torus"}]});
    assert_eq!(
        compile_solid(&solid).unwrap_err(),
        "of[0].shape: unknown shape `shpere`; did you mean `sphere`? | of[1]: the field `d` is missing; expected a number"
    );
}

/// The places of errors lie in the file.
fn assert_never_panics(text: &str) {
    if let Err(errors) = load(text, "fuzz.json") {
        let _ = errors.to_string();
        let lines: Vec<_> = text.split('\n').collect();
        for error in errors.errors {
            assert!((1..=lines.len()).contains(&error.line));
            assert!((1..=lines[error.line - 1].chars().count() + 1).contains(&error.column));
        }
    }
}

proptest! {
    #[test]
    fn a_scene_with_a_piece_replaced_is_loaded_or_refused_but_never_panics(
        scene in 0..embedded_scenes().len(), from in 0_usize..10_000, length in 0_usize..40, piece in r#"[ -~é∪{}\[\]":,0-9]{0,12}"#,
    ) {
        let text: Vec<char> = embedded_scenes()[scene].text.chars().collect();
        let from = from % text.len();
        let changed: String =
            text[..from].iter().copied().chain(piece.chars()).chain(text[from..].iter().copied().skip(length)).collect();
        assert_never_panics(&changed);
    }

    #[test]
    fn any_text_is_refused_without_a_panic(text in r#"[ -~é∪\n{}\[\]":,0-9]{0,60}"#) {
        assert_never_panics(&text);
    }
}
