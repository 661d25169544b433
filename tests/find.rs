//! `rayscope find` and `rayscope map` through the real binary.

use std::process::{Command, Output, Stdio};

fn rayscope(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_rayscope")).args(arguments).stdin(Stdio::null()).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn each_pixel_is_a_line_with_its_first_event() {
    let output = rayscope(&["find", "optics/glass_cube", "tir", "--width", "32"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let written = text(&output.stdout);
    let mut lines = written.lines();
    let head = lines.next().unwrap();
    assert_eq!(head, format!("tir: {} of {} pixels", lines.clone().count(), 32 * 24));
    assert!(lines.clone().count() > 0);
    assert!(lines.all(|line| line.contains("Snell's law: total internal reflection")), "{written}");
}

#[test]
fn the_data_say_which_pixels_and_which_events() {
    let output = rayscope(&["find", "csg/bowl", "csg.early_out&object=bowl", "--width", "16", "--format", "json"]);
    let data: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(data["query"], "csg.early_out & object=bowl");
    assert_eq!(data["size"], serde_json::json!([16, 12]));
    let pixels = data["pixels"].as_array().unwrap();
    assert!(!pixels.is_empty());
    let places: Vec<_> = pixels.iter().map(|pixel| [pixel["pixel"][1].as_u64(), pixel["pixel"][0].as_u64()]).collect();
    assert!(places.is_sorted(), "in reading order");
    assert!(pixels[0]["label"].as_str().unwrap().contains("early out"));
}

#[test]
fn a_query_that_is_none_is_refused_with_its_place_marked() {
    let output = rayscope(&["find", "csg/bowl", "hit & undecidible"]);
    assert_eq!(output.status.code(), Some(2));
    let said = text(&output.stderr);
    assert!(said.contains("  hit & undecidible\n        ^^^^^^^^^^^\n"), "{said}");
    assert!(said.contains("column 7") && said.contains("did you mean `undecidable`?"), "{said}");
}

#[test]
fn a_name_that_the_scene_lacks_is_warned_of() {
    let output = rayscope(&["find", "csg/bowl", "hit=bwl", "--width", "8"]);
    assert!(output.status.success());
    assert!(text(&output.stdout).starts_with("hit=bwl: 0 of 48 pixels"), "{}", text(&output.stdout));
    assert!(text(&output.stderr).contains("did you mean `bowl`?"), "{}", text(&output.stderr));
}

#[test]
fn the_help_lists_every_word() {
    let help = text(&rayscope(&["find", "--help"]).stdout);
    for term in rayscope::query::terms() {
        assert!(help.contains(term.name), "{}", term.name);
    }
}

#[test]
fn each_map_has_its_legend() {
    for (quantity, telling) in [
        ("rays", "Rays of all kinds"),
        ("tests", "Tests against"),
        ("depth", "rays deep"),
        ("time", "ns on average"),
        ("error", "bound on the error"),
        ("object", "bowl: "),
        ("normal", "needle"),
        ("digits", "digits"),
    ] {
        let arguments = |theme| ["map", "csg/bowl", "--of", quantity, "--width", "24", "--theme", theme];
        let [light, dark] = ["light", "dark"].map(|theme| rayscope(&arguments(theme)));
        assert!(light.status.success(), "{quantity}: {}", text(&light.stderr));
        let drawn = text(&light.stdout);
        assert!(drawn.starts_with("<svg") && drawn.contains(telling), "{quantity}");
        assert_ne!(drawn, text(&dark.stdout), "{quantity}");
    }
}

#[test]
fn what_was_found_and_a_map_can_be_pictures() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("out.png");
    let name = file.to_str().unwrap();
    for arguments in [
        ["find", "csg/bowl", "hit", "--width", "16", "--format", "png", "-o", name].as_slice(),
        &["map", "csg/bowl", "--of", "object", "--width", "16", "-o", name],
    ] {
        let output = rayscope(arguments);
        assert!(output.status.success(), "{}", text(&output.stderr));
        assert!(std::fs::read(&file).unwrap().starts_with(b"\x89PNG"));
    }
}
